// Connections that bear too much break. Part of StructuralConnections.
#include "core/mechanics/kernel_views.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t chunkSize = 256;

// Where breaking has left less than this of what an object's connections say about a direction, they say too little: springs go
// on alone.
constexpr double leastLiveShape = 0.45;

// Strength varies from connection to connection by so much either way, so that an evenly loaded body breaks at one place.
constexpr double strengthScatter = 0.05;

// Of the connections that bear too much at one look, only those within this share of the worst break; the others may be
// relieved by that.
constexpr double worstShare = 0.98;

/// A number from -1 to 1 that belongs to a connection (Murmur3's finalizer).
double scatter(std::size_t direction, std::size_t lower)
{
    auto bits = static_cast<std::uint64_t>(lower * Lattice::directionCount + direction + 1);
    bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
    bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

/// For each direction, forward and then backward, those within less than 60 degrees of it.
std::array<std::uint32_t, 2 * Lattice::directionCount> directionsBeside()
{
    constexpr std::size_t count = Lattice::directionCount;
    const auto direction = [](std::size_t q) -> Vec3 {
        const Lattice::Node& o = Lattice::directions[q % count];
        return (q < count ? 1 : -1) * Vec3(o[0], o[1], o[2]).normalized();
    };
    std::array<std::uint32_t, 2 * count> beside{};
    for (std::size_t q = 0; q < 2 * count; ++q)
        for (std::size_t p = 0; p < 2 * count; ++p)
            if (direction(p).dot(direction(q)) > 0.51)
                beside[q] |= std::uint32_t{1} << p;
    return beside;
}

Vec3 latticeStep(const ConnectionId& connection, ObjectIndex from)
{
    const Lattice::Node& o = Lattice::directions[connection.direction];
    const Vec3 step(o[0], o[1], o[2]);
    return connection.lower == from ? step : Vec3(-step);
}

/// Where an object was a time `back` ago.
Vec3 placeBefore(const ObjectState& state, std::size_t object, double back)
{
    return state.position.at(object) - back * state.velocity.at(object);
}

} // namespace

/// The least-squares deformation of an object's surroundings: M = sum k d o^T and K = sum k o o^T.
struct StructuralConnections::Shape {
    Mat3 moment = Mat3::Zero();
    Mat3 reference = Mat3::Zero();
};

StructuralConnections::Shape StructuralConnections::shapeAround(const ObjectState& state, ObjectIndex object,
                                                                double back) const
{
    Shape shape;
    forEachConnection(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const double k = m_stiffness[connection.direction][connection.lower];
        const Vec3 step = latticeStep(connection, object);
        shape.moment += k * (placeBefore(state, neighbor, back) - placeBefore(state, object, back)) * step.transpose();
        shape.reference += k * step * step.transpose();
    });
    return shape;
}

void StructuralConnections::markBroken(const ConnectionId& connection)
{
    forgetEnergy();
    m_brokenAround.resize(m_aggregate->size(), 0);
    const auto [lower, upper] = endsOf(connection);
    m_brokenAround[lower] |= std::uint32_t{1} << connection.direction;
    m_brokenAround[upper] |= std::uint32_t{1} << (Lattice::directionCount + connection.direction);
    // What has begun to break apart bears no more hydrostatic tension than springs do, of bulk modulus 5/3 mu.
    m_bulk[lower] = 0;
    m_bulk[upper] = 0;
    if (!m_tensors)
        return;
    m_tensors->tensionShare.resize(m_aggregate->size(), 1);
    for (const ObjectIndex end : {lower, upper}) {
        const Material& material = m_materials->of(end);
        const double bulk = material.lameLambda() + 2.0 / 3 * material.shearModulus();
        m_tensors->tensionShare[end] = std::min(1.0, 5.0 / 3 * material.shearModulus() / bulk);
    }
}

/// Limits of connections that cross the same plane as a broken one beside them.
void StructuralConnections::weakenBesideCracks(std::size_t d, std::size_t lower, std::size_t upper, std::size_t count,
                                               double* limit) const
{
    static const auto beside = directionsBeside();
    double atCrack[chunkSize];
    m_laws.fill(&ConnectionLaw::suddenStrainAtCrack, lower, upper, count, atCrack);
    for (std::size_t c = 0; c < count; ++c)
        if (((m_brokenAround[lower + c] & beside[d]) |
             (m_brokenAround[upper + c] & beside[Lattice::directionCount + d])) != 0)
            limit[c] = atCrack[c];
}

void StructuralConnections::findOverloaded(const ObjectState& state, std::size_t begin, std::size_t end,
                                           std::vector<Overloaded>& found) const
{
    double limit[chunkSize];
    double spent[chunkSize] = {};
    double bound[chunkSize];
    double excess[chunkSize];
    double rest[chunkSize];
    // What no limit is below. Nearly always nothing exceeds it, and the limits need not be known.
    const double least = m_laws.leastSuddenStrain() * (1 - strengthScatter);
    using kernels::from;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        const LaneVector<double>& damage = plasticState().damage;
        const LaneVector<double>& nominal = plasticState().nominalLength[d];
        const bool mayBeSpent = !damage.empty() && m_laws.anyTires();
        std::fill_n(rest, chunkSize, m_aggregate->lattice.direction(static_cast<int>(d)).norm());
        forEachForward(m_aggregate->lattice, d, begin, end,
                       [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                           for (std::size_t s = i; s < i + n; s += chunkSize) {
                               const std::size_t count = std::min(chunkSize, i + n - s);
                               const auto self = from(state.position, s);
                               const auto neighbor = from(state.position, s + j - i);
                               const double* lengths = nominal.empty() ? rest : &nominal[s];
                               if (!mayBeSpent && !kernels::best().anyLonger(count, self, neighbor, &m_stiffness[d][s],
                                                                             lengths, 1 + least))
                                   continue;
                               m_laws.fill(&ConnectionLaw::suddenStrain, s, s + j - i, count, limit);
                               if (!m_brokenAround.empty())
                                   weakenBesideCracks(d, s, s + j - i, count, limit);
                               double own[chunkSize]; // strength of each connection by that of its material
                               for (std::size_t c = 0; c < count; ++c) {
                                   own[c] = 1 + strengthScatter * scatter(d, s + c);
                                   limit[c] *= own[c];
                               }
                               if (mayBeSpent)
                                   findSpent(s, s + j - i, count, own, spent);
                               for (std::size_t c = 0; c < count; ++c)
                                   bound[c] = spent[c] > 1 ? 0 : limit[c];
                               kernels::best().excessStrain(count, self, neighbor, lengths, bound, excess);
                               for (std::size_t c = 0; c < count; ++c)
                                   if (excess[c] > 0 && m_stiffness[d][s + c] > 0)
                                       found.push_back({{d, static_cast<ObjectIndex>(s + c)},
                                                        std::max(spent[c], (bound[c] + excess[c]) / limit[c])});
                           }
                       });
    }
}

/// How far material has flowed by how far it can. Above 1 a connection breaks as soon as it is stretched again.
void StructuralConnections::findSpent(std::size_t lower, std::size_t upper, std::size_t count, const double* strength,
                                      double* spent) const
{
    const LaneVector<double>& damage = plasticState().damage;
    m_laws.fill(&ConnectionLaw::ductility, lower, upper, count, spent);
    for (std::size_t c = 0; c < count; ++c)
        spent[c] = 0.5 * (damage[lower + c] + damage[upper + c]) / (strength[c] * spent[c]);
}

std::vector<BrokenConnection> StructuralConnections::overloaded(const ObjectState& state) const
{
    std::vector<std::vector<Overloaded>> found((state.size() + m_blockSize - 1) / m_blockSize);
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        findOverloaded(state, begin, end, found[begin / m_blockSize]);
    });
    double worst = 0;
    for (const auto& block : found)
        for (const Overloaded& connection : block)
            if (std::isfinite(connection.load))
                worst = std::max(worst, connection.load);
    std::vector<BrokenConnection> breaking;
    for (const auto& block : found)
        for (const Overloaded& connection : block)
            if (connection.load >= worstShare * worst)
                breaking.push_back({connection.id});
    return breaking;
}

double StructuralConnections::energyAround(const ObjectState& state, const std::vector<ObjectIndex>& objects,
                                           double back) const
{
    double sum = 0;
    for (const ObjectIndex i : objects) {
        if (m_bulk[i] == 0)
            continue;
        Mat3 inverse;
        const auto& k = m_inverseShape;
        inverse << k[0][i], k[3][i], k[4][i], k[3][i], k[1][i], k[5][i], k[4][i], k[5][i], k[2][i];
        const double determinant =
            (shapeAround(state, i, back).moment * inverse / m_aggregate->lattice.spacing).determinant();
        const double floor = kernels::smallestVolumeRatio;
        const double theta = std::log(std::max(determinant, floor)) + std::min(determinant / floor - 1, 0.0) -
                             m_changes.restDilatation[i];
        const double strain = kernels::volumetricStrain(m_bulk[i], theta, m_changes.restDilatation[i]);
        sum += 0.5 * m_bulk[i] * strain * strain;
    }
    return sum;
}

double StructuralConnections::breakAll(const ObjectState& state, const std::vector<BrokenConnection>& connections,
                                       double step)
{
    std::vector<ObjectIndex> objects;
    for (const ConnectionId& connection : connections)
        for (const ObjectIndex end : endsOf(connection))
            objects.push_back(end);
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    // In the semi-implicit scheme the force of a connection has acted up to half a step ago: what it had then is set free.
    const double back = step / 2;
    VectorArray before;
    if (m_tensors) {
        before = state.position;
        for (std::size_t i = 0; i < state.size(); ++i)
            before.set(i, placeBefore(state, i, back));
    }
    double released = m_tensors ? energy(before) : energyAround(state, objects, back);
    for (const BrokenConnection& connection : connections) {
        double& k = m_stiffness[connection.direction][connection.lower];
        const auto [lower, upper] = endsOf(connection);
        const double length = (placeBefore(state, upper, back) - placeBefore(state, lower, back)).norm();
        const double stretch = length - nominalLength(connection);
        if (!m_tensors)
            released += 0.5 * k * stretch * stretch;
        k = 0;
        m_changes.broken.push_back(connection);
        markBroken(connection);
    }
    m_count -= connections.size();
    for (const ObjectIndex object : objects)
        findLiveShape(object);
    // Without tensors the volumetric energy of the ends is all set free.
    return m_tensors ? released - energy(before) : released;
}

/// An object some connections of which broke bears with the share of its volume that those left say something about, in the
/// direction n in which they say least: min n^T K n / n^T K_made n. At the face of a crack that is a half, as for a cell that is
/// cut there. With more, the object would bear on few connections, and be stiffer than steps allow.
void StructuralConnections::findLiveShape(ObjectIndex object)
{
    if (m_inverseShape[0][object] == 0)
        return; // flat, and it stays so
    Mat3 live = Mat3::Zero();
    Mat3 made = Mat3::Zero();
    forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const auto [d, lower] = connection;
        const Vec3 step = latticeStep(connection, object);
        live += m_stiffness[d][lower] * step * step.transpose();
        made += m_laws.between(object, neighbor).stiffness * m_aggregate->lattice.spacing *
                m_aggregate->weight[d][lower] * step * step.transpose();
    });
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> solver(live, made + 1e-9 * made.trace() * Mat3::Identity(),
                                                                Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
    const double share = std::clamp(solver.eigenvalues()[0], 0.0, 1.0);
    setInverseShape(object, share < leastLiveShape ? Mat3::Zero() : live);
    if (m_tensors)
        m_tensors->volume[object] = share * m_aggregate->volume[object];
}

StructuralConnections::BreakReport StructuralConnections::breakOverloaded(const ObjectState& state, double step)
{
    BreakReport report;
    if (!m_laws.anyBreaks())
        return report;
    if (const std::vector<BrokenConnection> broken = overloaded(state); !broken.empty()) {
        report.released = breakAll(state, broken, step);
        report.broken = broken.size();
    }
    return report;
}

} // namespace knead
