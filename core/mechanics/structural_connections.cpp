#include "core/mechanics/structural_connections.h"

#include "core/mechanics/lattice_kernels.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

// Fewer objects than this stay in one block: they take less time than handing part of them to another thread.
constexpr std::size_t smallestSplit = 4096;
// More, in at least so many blocks, so that threads end together.
constexpr std::size_t fewestBlocks = 8;
constexpr std::size_t smallestBlock = 2048;
constexpr std::size_t largestBlock = 65536;

// Stiffness of a contact in units of mu V / a^2. 6 keeps a tool from sinking visibly into soft material
// (overlap / a about 0.4 p / E) and adds a half to the stiffness of a surface object, a tenth to the number of steps.
constexpr double contactShare = 6;

// Surroundings whose connections lie this near to a plane say nothing about volume.
constexpr double flattestShape = 0.01;

constexpr std::size_t wholeVectors(std::size_t count)
{
    return (count + laneCount - 1) / laneCount * laneCount;
}

Vec3 latticeVector(std::size_t d)
{
    const Lattice::Node& o = Lattice::directions[d];
    return {static_cast<double>(o[0]), static_cast<double>(o[1]), static_cast<double>(o[2])};
}

} // namespace

StructuralConnections::StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const MaterialMap& materials)
    : m_aggregate(std::move(aggregate))
    , m_materials(&materials)
    , m_laws(materials, m_aggregate->lattice.spacing)
{
    std::size_t largestOffset = 0;
    for (const auto& segments : m_aggregate->lattice.segments)
        for (const Lattice::Segment& segment : segments)
            largestOffset = std::max(largestOffset, static_cast<std::size_t>(segment.offset));
    // A margin must not reach beyond the next block. With blocks of four times its reach, adding it up costs little.
    const std::size_t reach = wholeVectors(largestOffset + laneCount);
    const std::size_t objects = m_aggregate->size();
    m_blockSize = objects <= smallestSplit
                      ? smallestSplit
                      : std::max({smallestBlock, reach,
                                  std::min({wholeVectors(objects / fewestBlocks + 1), 4 * reach, largestBlock})});
    for (std::size_t end = m_blockSize; end < m_aggregate->size(); end += m_blockSize) {
        const std::size_t overlap = 2 * laneCount;
        m_margins.push_back({end - overlap, VectorArray(overlap + reach), VectorArray(overlap + reach)});
    }
    m_runs = findRuns(m_aggregate->lattice, RunNeighbors::ahead);
    m_stressRuns = findRuns(m_aggregate->lattice, RunNeighbors::all);
    const std::vector<std::uint32_t> behind = neighborsBehind(m_aggregate->lattice);
    m_hasBehind.assign(behind.begin(), behind.end());
    m_changes.restDilatation.assign(m_aggregate->size(), 0);
    updateMaterials();
}

void StructuralConnections::updateMaterials()
{
    m_laws = ConnectionLaws(*m_materials, m_aggregate->lattice.spacing);
    findStiffness();
    m_mode.resize(0);
    m_hasTrial = false;
    forgetEnergy();
    if (m_laws.anyYields())
        makeLengthsOwn();
    findInverseShapes();
}

void StructuralConnections::restore(Changes changes)
{
    m_changes = std::move(changes);
    ++m_lengthVersion;
    if (m_changes.restDilatation.empty())
        m_changes.restDilatation.assign(m_aggregate->size(), 0);
    if (!m_changes.plastic.nominalLength[0].empty() && m_changes.plastic.metric[0].empty())
        findMetric();
    updateMaterials();
}

void StructuralConnections::findStiffness()
{
    const double a = m_aggregate->lattice.spacing;
    const std::size_t objects = m_aggregate->size();
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::vector<double>& weight = m_aggregate->weight[d];
        LaneVector<double>& stiffness = m_stiffness[d];
        stiffness.assign(weight.size(), 0);
        forEachForward(m_aggregate->lattice, d, 0, objects,
                       [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                           m_laws.fill(&ConnectionLaw::stiffness, i, j, n, &stiffness[i]);
                           for (std::size_t s = i; s < i + n; ++s)
                               stiffness[s] *= a * weight[s];
                       });
    }
    findDampingTimes();
    for (const ConnectionId& broken : m_changes.broken)
        m_stiffness[broken.direction][broken.lower] = 0;
    m_count = m_aggregate->connectionCount() - m_changes.broken.size();
}

void StructuralConnections::findDampingTimes()
{
    const bool differ = m_laws.leastDampingTime() < m_laws.largestDampingTime();
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        LaneVector<double>& times = m_dampingTime[d];
        times.assign(differ ? m_stiffness[d].size() : 0, 0);
        if (differ)
            forEachForward(m_aggregate->lattice, d, 0, m_aggregate->size(),
                           [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                               m_laws.fill(&ConnectionLaw::dampingTime, i, j, n, &times[i]);
                           });
    }
}

void StructuralConnections::makeLengthsOwn()
{
    const auto ensure = [](LaneVector<double>& numbers, std::size_t size, double value) {
        if (numbers.size() != size)
            numbers.assign(size, value);
    };
    PlasticState& plastic = m_changes.plastic;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        ensure(plastic.nominalLength[d], m_stiffness[d].size(),
               m_aggregate->lattice.direction(static_cast<int>(d)).norm());
    for (std::size_t c = 0; c < 6; ++c)
        ensure(plastic.metric[c], m_aggregate->size(), c < 3 ? 1 : 0);
    ensure(plastic.equivalentStrain, m_aggregate->size(), 0);
    ensure(plastic.damage, m_aggregate->size(), 0);
}

const double* StructuralConnections::nominalLengths(std::size_t d, std::size_t lower, std::size_t count,
                                                    double* buffer) const
{
    if (const LaneVector<double>& own = plasticState().nominalLength[d]; !own.empty())
        return &own[lower];
    std::fill_n(buffer, count, m_aggregate->lattice.direction(static_cast<int>(d)).norm());
    return buffer;
}

double StructuralConnections::nominalLength(const ConnectionId& connection) const
{
    double rest = 0;
    return *nominalLengths(connection.direction, connection.lower, 1, &rest);
}

void StructuralConnections::findInverseShapes()
{
    const std::size_t count = m_aggregate->size();
    m_tensors.reset();
    const auto bulkModulus = [](const Material& material) {
        const double modulus = material.lameLambda() - material.shearModulus();
        return std::abs(modulus) < 1e-9 * material.shearModulus() ? 0 : modulus;
    };
    m_hasBulk = m_materials->largest([&](const Material& m) { return std::abs(bulkModulus(m)); }) > 0;
    for (auto& component : m_inverseShape)
        component.resize(count);
    for (VectorArray& column : m_stress)
        column.resize(m_hasBulk || anyTensorial() ? count : 0);
    m_bulk.resize(count);
    m_flat.clear();
    m_theta.assign(count, 0);
    std::vector<Mat3> shape(count, Mat3::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Mat3 dyad = latticeVector(d) * latticeVector(d).transpose();
        forEachForward(m_aggregate->lattice, d, 0, count,
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               shape[i + s] += m_stiffness[d][lower + s] * dyad;
                               shape[j + s] += m_stiffness[d][lower + s] * dyad;
                           }
                       });
    }
    for (ObjectIndex i = 0; i < count; ++i) {
        m_bulk[i] = bulkModulus(m_materials->of(i)) * m_aggregate->volume[i];
        setInverseShape(i, shape[i]);
    }
    findTensorNumbers();
    m_brokenAround.clear();
    for (const ConnectionId& broken : m_changes.broken)
        markBroken(broken);
    for (ObjectIndex i = 0; i < m_brokenAround.size(); ++i)
        if (m_brokenAround[i] != 0)
            findLiveShape(i);
}

std::array<ObjectIndex, 2> StructuralConnections::endsOf(const ConnectionId& connection) const
{
    const auto& segments = m_aggregate->lattice.segments[connection.direction];
    const auto segment = std::partition_point(segments.begin(), segments.end(),
                                              [&](const auto& s) { return s.end <= connection.lower; });
    return {connection.lower, connection.lower + static_cast<ObjectIndex>(segment->offset)};
}

void StructuralConnections::setInverseShape(ObjectIndex object, const Mat3& shape)
{
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(shape, Eigen::EigenvaluesOnly);
    Mat3 inverse = Mat3::Zero();
    if (solver.eigenvalues()[0] > flattestShape * solver.eigenvalues()[2])
        inverse = shape.inverse();
    else {
        m_bulk[object] = 0;
        m_flat.push_back(object);
    }
    const double components[] = {inverse(0, 0), inverse(1, 1), inverse(2, 2),
                                 inverse(0, 1), inverse(0, 2), inverse(1, 2)};
    for (std::size_t c = 0; c < 6; ++c)
        m_inverseShape[c][object] = components[c];
    if (isRubber(object) && components[0] == 0) {
        rubber()->isWhole = false;
        rubber()->isRubber[object] = 0;
        rubber()->springsAreKnown = false;
    }
}

double StructuralConnections::energy(const VectorArray& position)
{
    if (!position.hasSameBits(m_energyAt)) {
        m_energy = findEnergy(position);
        m_energyAt = position;
    }
    return m_energy;
}

double StructuralConnections::findEnergy(const VectorArray& position)
{
    const bool hasObjects = m_hasBulk || m_tensors;
    if (hasObjects)
        computeStress(position);
    const DirectionArray& lengths = plasticState().nominalLength;
    std::vector<double> sums((position.size() + m_blockSize - 1) / m_blockSize);
    forEachBlock(position.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        double& sum = sums[begin / m_blockSize];
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
            const LaneVector<double>& own = lengths[d];
            const double uniform = m_aggregate->lattice.direction(static_cast<int>(d)).norm();
            forEachForward(m_aggregate->lattice, d, begin, end,
                           [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                               for (std::size_t s = 0; s < n; ++s) {
                                   const double length = (position.at(j + s) - position.at(i + s)).norm();
                                   sum += springEnergy(i + s, j + s, m_stiffness[d][lower + s], length,
                                                       own.empty() ? uniform : own[lower + s]);
                               }
                           });
        }
        for (std::size_t i = begin; hasObjects && i < end; ++i)
            sum += objectEnergy(i);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

bool StructuralConnections::anyTensorial() const
{
    return m_materials->largest([](const Material& material) { return material.isTensorial() ? 1 : 0; }) > 0;
}

/// Of a connection, whose ends have half of it each.
double StructuralConnections::springEnergy(std::size_t i, std::size_t j, double stiffness, double length,
                                           double nominal) const
{
    const double stretch = length - nominal;
    if (rubber() == nullptr)
        return 0.5 * stiffness * stretch * stretch;
    const double rubberlike = 0.5 * (rubber()->isRubber[i] + rubber()->isRubber[j]);
    return 0.5 * stiffness *
           ((1 - rubberlike) * stretch * stretch + rubberlike * kernels::rubberSpringShare * length * length);
}

double StructuralConnections::objectEnergy(std::size_t object) const
{
    if (m_tensors)
        return m_tensors->energy[object];
    const double strain = kernels::volumetricStrain(m_bulk[object], m_theta[object], m_changes.restDilatation[object]);
    return 0.5 * m_bulk[object] * strain * strain;
}

std::size_t StructuralConnections::countInverted(const ObjectState& state)
{
    computeStress(state.position);
    std::size_t inverted = 0;
    for (ObjectIndex i = 0; i < state.size(); ++i) {
        if (m_theta[i] + m_changes.restDilatation[i] > kernels::flatDilatation)
            continue;
        std::size_t neighbors = 0;
        forEachConnection(i, [&](ObjectIndex, const ConnectionId&) { ++neighbors; });
        if (neighbors >= 2 * Lattice::isotropicCount)
            ++inverted;
    }
    return inverted;
}

double StructuralConnections::contactStiffness(ObjectIndex object) const
{
    const double a = m_aggregate->lattice.spacing;
    return contactShare * m_materials->of(object).shearModulus() * m_aggregate->volume[object] / (a * a);
}

} // namespace knead
