// Connections that bear too much break. Part of StructuralConnections.
#include "core/mechanics/lattice_kernels.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t chunkSize = 256;

Vec3 latticeStep(const ConnectionId& connection, ObjectIndex from)
{
    const Lattice::Node& o = Lattice::directions[connection.direction];
    const Vec3 step(o[0], o[1], o[2]);
    return connection.lower == from ? step : Vec3(-step);
}

} // namespace

/// The least-squares deformation of an object's surroundings: M = sum k d o^T and K = sum k o o^T.
struct StructuralConnections::Shape {
    Mat3 moment = Mat3::Zero();
    Mat3 reference = Mat3::Zero();
};

StructuralConnections::Shape StructuralConnections::shapeAround(const ObjectState& state, ObjectIndex object) const
{
    Shape shape;
    forEachConnection(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const double k = m_stiffness[connection.direction][connection.lower];
        const Vec3 step = latticeStep(connection, object);
        shape.moment += k * (state.position.at(neighbor) - state.position.at(object)) * step.transpose();
        shape.reference += k * step * step.transpose();
    });
    return shape;
}

void StructuralConnections::findOverloaded(const ObjectState& state, std::size_t begin, std::size_t end,
                                           std::vector<ConnectionId>& found) const
{
    double limit[chunkSize];
    double ductility[chunkSize];
    double excess[chunkSize];
    double rest[chunkSize];
    const auto from = [](const VectorArray& v, std::size_t i) {
        return kernels::ConstVectors{&v.x[i], &v.y[i], &v.z[i]};
    };
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        const std::vector<double>& plastic = m_changes.plasticStrain[d];
        forEachForward(
            m_aggregate->lattice, d, begin, end, [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                for (std::size_t s = i; s < i + n; s += chunkSize) {
                    const std::size_t count = std::min(chunkSize, i + n - s);
                    m_laws.fill(&ConnectionLaw::breakingStrain, s, s + j - i, count, limit);
                    m_laws.fill(&ConnectionLaw::ductility, s, s + j - i, count, ductility);
                    // A connection that has flowed as far as it can breaks as soon as it is stretched again.
                    for (std::size_t c = 0; c < count && !plastic.empty(); ++c)
                        if (plastic[s + c] > ductility[c])
                            limit[c] = 0;
                    kernels::best().excessStrain(count, from(state.position, s), from(state.position, s + j - i),
                                                 nominalLengths(d, s, count, rest), limit, excess);
                    for (std::size_t c = 0; c < count; ++c)
                        if (excess[c] > 0 && m_stiffness[d][s + c] > 0)
                            found.push_back({d, static_cast<ObjectIndex>(s + c)});
                }
            });
    }
}

std::vector<ConnectionId> StructuralConnections::overloaded(const ObjectState& state) const
{
    std::vector<std::vector<ConnectionId>> found((state.size() + m_blockSize - 1) / m_blockSize);
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        findOverloaded(state, begin, end, found[begin / m_blockSize]);
    });
    std::vector<ConnectionId> all;
    for (const auto& block : found)
        all.insert(all.end(), block.begin(), block.end());
    return all;
}

double StructuralConnections::energyAround(const ObjectState& state, const std::vector<ObjectIndex>& objects) const
{
    double sum = 0;
    for (const ObjectIndex i : objects) {
        if (m_bulk[i] == 0)
            continue;
        Mat3 inverse;
        const auto& k = m_inverseShape;
        inverse << k[0][i], k[3][i], k[4][i], k[3][i], k[1][i], k[5][i], k[4][i], k[5][i], k[2][i];
        const double determinant =
            (shapeAround(state, i).moment * inverse / m_aggregate->lattice.spacing).determinant();
        const double floor = kernels::smallestVolumeRatio;
        const double theta = std::log(std::max(determinant, floor)) + std::min(determinant / floor - 1, 0.0) -
                             m_changes.restDilatation[i];
        sum += 0.5 * m_bulk[i] * theta * theta;
    }
    return sum;
}

double StructuralConnections::breakAll(const ObjectState& state, const std::vector<ConnectionId>& connections)
{
    std::vector<ObjectIndex> ends;
    for (const ConnectionId& connection : connections)
        forEachConnection(connection.lower, [&](ObjectIndex neighbor, const ConnectionId& other) {
            if (other == connection)
                ends.insert(ends.end(), {connection.lower, neighbor});
        });
    double released = 0;
    std::vector<ObjectIndex> objects = ends;
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    released += energyAround(state, objects);
    for (std::size_t c = 0; c < connections.size(); ++c) {
        const ConnectionId& connection = connections[c];
        double& k = m_stiffness[connection.direction][connection.lower];
        const double length = (state.position.at(ends[2 * c + 1]) - state.position.at(ends[2 * c])).norm();
        const double stretch = length - nominalLength(connection);
        released += 0.5 * k * stretch * stretch;
        k = 0;
        m_changes.broken.push_back(connection);
    }
    m_count -= connections.size();
    for (const ObjectIndex object : objects)
        setInverseShape(object, shapeAround(state, object).reference);
    m_thetaIsPresent = false;
    return released - energyAround(state, objects);
}

} // namespace knead
