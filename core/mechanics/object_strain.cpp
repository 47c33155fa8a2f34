#include "core/mechanics/object_strain.h"

#include "core/aggregate/lattice_sweep.h"
#include "core/aggregate/pieces.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t objectsPerBlock = 512;
constexpr double flattestShape = 0.01; // surroundings nearer to a plane say nothing about what is across it
constexpr double leastStretch = 1e-3;  // of squashed material: logarithms stay finite

} // namespace

/// The live connections of objects.
class ObjectSurroundings {
public:
    ObjectSurroundings(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
        : m_aggregate(aggregate)
        , m_isBroken(brokenDirections(aggregate, broken))
    {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            m_steps[d] = aggregate.lattice.direction(static_cast<int>(d));
        markEnds(broken);
    }

    /// Calls visit(neighbor, step, weight) for each, `step` being the way to the neighbor at rest [m].
    template <typename Visit>
    void forEach(ObjectIndex object, Visit&& visit) const
    {
        forEachNeighbor(m_aggregate.lattice, object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
            const auto [d, lower] = connection;
            if (isAlive(d, lower))
                visit(neighbor, lower == object ? m_steps[d] : Vec3(-m_steps[d]), m_aggregate.weight[d][lower]);
        });
    }

    bool hasBroken() const { return !m_hasBroken.empty(); }
    bool hasBroken(ObjectIndex object) const { return !m_hasBroken.empty() && m_hasBroken[object] != 0; }

private:
    bool isAlive(std::uint32_t d, ObjectIndex lower) const
    {
        return m_aggregate.weight[d][lower] > 0 && (m_isBroken[lower] >> d & 1U) == 0;
    }

    void markEnds(std::span<const BrokenConnection> broken)
    {
        if (!broken.empty())
            m_hasBroken.assign(m_aggregate.size(), 0);
        for (const ConnectionId& connection : broken)
            m_hasBroken[connection.lower] = m_hasBroken[upperEnd(m_aggregate.lattice, connection)] = 1;
    }

    const Aggregate& m_aggregate;
    std::vector<std::uint16_t> m_isBroken;
    std::vector<std::uint8_t> m_hasBroken; ///< per object, at either end; empty: none
    std::array<Vec3, Lattice::directionCount> m_steps;
};

namespace {

/// F = (sum w d o^T) (sum w o o^T)^-1 for the ways o at rest and d now; across what these do not span a rotation.
Mat3 deformationGradient(const ObjectSurroundings& surroundings, std::span<const Vec3> displacements,
                         ObjectIndex object)
{
    Mat3 moment = Mat3::Zero();
    Mat3 reference = Mat3::Zero();
    surroundings.forEach(object, [&](ObjectIndex neighbor, const Vec3& step, double weight) {
        moment += weight * (step + displacements[neighbor] - displacements[object]) * step.transpose();
        reference += weight * step * step.transpose();
    });
    const Eigen::SelfAdjointEigenSolver<Mat3> known(reference);
    const double least = flattestShape * known.eigenvalues()[2];
    if (least > 0 && known.eigenvalues()[0] > least)
        return moment * reference.inverse();
    const Vec3 inverse = known.eigenvalues().unaryExpr([&](double value) { return value > least ? 1 / value : 0; });
    const Mat3 flat = moment * known.eigenvectors() * inverse.asDiagonal() * known.eigenvectors().transpose();
    const Eigen::JacobiSVD<Mat3> svd(flat, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 stretches = svd.singularValues();
    const auto rank = static_cast<Eigen::Index>((inverse.array() > 0).count());
    stretches.tail(3 - rank).setOnes();
    if (rank < 3 && svd.matrixU().determinant() * svd.matrixV().determinant() < 0)
        stretches[2] = -1;
    return svd.matrixU() * stretches.asDiagonal() * svd.matrixV().transpose();
}

} // namespace

ObjectStrains::ObjectStrains(const Aggregate& aggregate, std::span<const Vec3> displacements,
                             const RelaxedState& relaxed, std::span<const BrokenConnection> broken)
    : m_surroundings(std::make_unique<const ObjectSurroundings>(aggregate, broken))
    , m_displacements(displacements)
    , m_relaxed(relaxed)
    , m_axes(aggregate.lattice.axes)
{
    assert(displacements.size() == aggregate.size());
}

ObjectStrains::~ObjectStrains() = default;

ObjectStrain ObjectStrains::of(ObjectIndex object) const
{
    const Mat3 gradient = deformationGradient(*m_surroundings, m_displacements, object);
    ObjectStrain result;
    result.strain = halfLogarithm(gradient * gradient.transpose());
    const Mat3 metric = relaxedMetric(object);
    if (m_relaxed.hasFlowed())
        result.flow = halfLogarithm(metric);
    const Material material = bearingMaterial(m_relaxed.materials.of(object), m_relaxed.materials);
    result.stress = cauchyStress(gradient, metric, material, flowStress(material, plasticStrain(object)));
    return result;
}

ObjectStrains::Elastic ObjectStrains::elastic(ObjectIndex object) const
{
    const Mat3 gradient = deformationGradient(*m_surroundings, m_displacements, object);
    return {gradient, halfLogarithm(gradient * relaxedMetric(object).inverse() * gradient.transpose())};
}

Mat3 ObjectStrains::relaxedMetric(ObjectIndex object) const
{
    if (!m_relaxed.hasFlowed())
        return Mat3::Identity();
    const auto entry = [&](std::size_t n) { return static_cast<double>(m_relaxed.metric[n][object]); };
    Mat3 metric;
    metric << entry(0), entry(3), entry(4), entry(3), entry(1), entry(5), entry(4), entry(5), entry(2);
    return m_axes * metric * m_axes.transpose();
}

Mat3 ObjectStrains::flow(ObjectIndex object) const
{
    return m_relaxed.hasFlowed() ? halfLogarithm(relaxedMetric(object)) : Mat3::Zero();
}

double ObjectStrains::plasticStrain(ObjectIndex object) const
{
    return m_relaxed.equivalentStrain.empty() ? 0 : static_cast<double>(m_relaxed.equivalentStrain[object]);
}

bool ObjectStrains::hasBroken(ObjectIndex object) const
{
    return m_surroundings->hasBroken(object);
}

bool ObjectStrains::hasBroken() const
{
    return m_surroundings->hasBroken();
}

std::vector<ObjectStrain> objectStrains(const Aggregate& aggregate, std::span<const Vec3> displacements,
                                        const RelaxedState& relaxed, std::span<const BrokenConnection> broken)
{
    const ObjectStrains objects(aggregate, displacements, relaxed, broken);
    std::vector<ObjectStrain> strains(aggregate.size());
    forEachBlock(aggregate.size(), objectsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            strains[i] = objects.of(static_cast<ObjectIndex>(i));
    });
    return strains;
}

/// ln sqrt(b) of a symmetric b.
Mat3 halfLogarithm(const Mat3& b)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(b);
    const Vec3 logarithms = solver.eigenvalues().unaryExpr(
        [](double value) { return 0.5 * std::log(std::max(value, leastStretch * leastStretch)); });
    return solver.eigenvectors() * logarithms.asDiagonal() * solver.eigenvectors().transpose();
}

} // namespace knead
