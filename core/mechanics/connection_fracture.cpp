// Connections that bear too much break.
#include "core/mechanics/connection_fracture.h"

#include "core/mechanics/connection_parameters.h"
#include "core/mechanics/connection_stress.h"
#include "core/mechanics/kernel_views.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t chunkSize = 256;

// Where breaking has left less than this of what an object's connections say about a direction, they say too little:
// springs go on alone.
constexpr double leastLiveShape = 0.45;

// Strength varies from connection to connection by so much either way, so that an evenly loaded body breaks at one
// place.
constexpr double strengthScatter = 0.05;

// Of the connections that bear too much at one look, only those within this share of the worst break; the others may
// be relieved by that.
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
        return (q < count ? 1 : -1) * latticeVector(q % count).normalized();
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
    const Vec3 step = latticeVector(connection.direction);
    return connection.lower == from ? step : Vec3(-step);
}

/// Where an object was a time `back` ago.
Vec3 placeBefore(const ObjectState& state, std::size_t object, double back)
{
    return state.position.at(object) - back * state.velocity.at(object);
}

struct Overloaded {
    ConnectionId id;
    double load; ///< strain by what it bears, > 1
};

/// M = sum k d o^T of an object's surroundings, a time `back` ago.
Mat3 shapeAround(const ConnectionData& data, const ObjectState& state, ObjectIndex object, double back)
{
    Mat3 moment = Mat3::Zero();
    data.forEachConnection(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const double k = data.stiffness[connection.direction][connection.lower];
        const Vec3 step = latticeStep(connection, object);
        moment += k * (placeBefore(state, neighbor, back) - placeBefore(state, object, back)) * step.transpose();
    });
    return moment;
}

/// Limits of connections that cross the same plane as a broken one beside them.
void weakenBesideCracks(const ConnectionData& data, std::size_t d, std::size_t lower, std::size_t upper,
                        std::size_t count, double* limit)
{
    static const auto beside = directionsBeside();
    double atCrack[chunkSize];
    data.laws.fill(&ConnectionLaw::suddenStrainAtCrack, lower, upper, count, atCrack);
    for (std::size_t c = 0; c < count; ++c)
        if (((data.brokenAround[lower + c] & beside[d]) |
             (data.brokenAround[upper + c] & beside[Lattice::directionCount + d])) != 0)
            limit[c] = atCrack[c];
}

/// How far material has flowed by how far it can. Above 1 a connection breaks as soon as it is stretched again.
void findSpent(const ConnectionData& data, std::size_t lower, std::size_t upper, std::size_t count,
               const double* strength, double* spent)
{
    const LaneVector<double>& damage = data.plasticState().damage;
    data.laws.fill(&ConnectionLaw::ductility, lower, upper, count, spent);
    for (std::size_t c = 0; c < count; ++c)
        spent[c] = 0.5 * (damage[lower + c] + damage[upper + c]) / (strength[c] * spent[c]);
}

void findOverloaded(const ConnectionData& data, const ObjectState& state, std::size_t begin, std::size_t end,
                    std::vector<Overloaded>& found)
{
    double limit[chunkSize];
    double spent[chunkSize] = {};
    double bound[chunkSize];
    double excess[chunkSize];
    double rest[chunkSize];
    // What no limit is below. Nearly always nothing exceeds it, and the limits need not be known.
    const double least = data.laws.leastSuddenStrain() * (1 - strengthScatter);
    using kernels::from;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        const LaneVector<double>& damage = data.plasticState().damage;
        const LaneVector<double>& nominal = data.plasticState().nominalLength[d];
        const bool mayBeSpent = !damage.empty() && data.laws.anyTires();
        std::fill_n(rest, chunkSize, data.aggregate->lattice.direction(static_cast<int>(d)).norm());
        forEachStretch(data.aggregate->lattice, d, begin, end, [&](std::size_t i, std::size_t j, std::size_t n) {
            for (std::size_t s = i; s < i + n; s += chunkSize) {
                const std::size_t count = std::min(chunkSize, i + n - s);
                const auto self = from(state.position, s);
                const auto neighbor = from(state.position, s + j - i);
                const double* lengths = nominal.empty() ? rest : &nominal[s];
                if (!mayBeSpent &&
                    !kernels::best().anyLonger(count, self, neighbor, &data.stiffness[d][s], lengths, 1 + least))
                    continue;
                data.laws.fill(&ConnectionLaw::suddenStrain, s, s + j - i, count, limit);
                if (!data.brokenAround.empty())
                    weakenBesideCracks(data, d, s, s + j - i, count, limit);
                double own[chunkSize]; // strength of each connection by that of its material
                for (std::size_t c = 0; c < count; ++c) {
                    own[c] = 1 + strengthScatter * scatter(d, s + c);
                    limit[c] *= own[c];
                }
                if (mayBeSpent)
                    findSpent(data, s, s + j - i, count, own, spent);
                for (std::size_t c = 0; c < count; ++c)
                    bound[c] = spent[c] > 1 ? 0 : limit[c];
                kernels::best().excessStrain(count, self, neighbor, lengths, bound, excess);
                for (std::size_t c = 0; c < count; ++c)
                    if (excess[c] > 0 && data.stiffness[d][s + c] > 0)
                        found.push_back({{d, static_cast<ObjectIndex>(s + c)},
                                         std::max(spent[c], (bound[c] + excess[c]) / limit[c])});
            }
        });
    }
}

std::vector<BrokenConnection> overloaded(const ConnectionData& data, const ObjectState& state)
{
    std::vector<std::vector<Overloaded>> found((state.size() + data.blockSize - 1) / data.blockSize);
    forEachBlock(state.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        findOverloaded(data, state, begin, end, found[begin / data.blockSize]);
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

double energyAround(const ConnectionData& data, const ObjectState& state, const std::vector<ObjectIndex>& objects,
                    double back)
{
    double sum = 0;
    for (const ObjectIndex i : objects) {
        if (data.bulk[i] == 0)
            continue;
        Mat3 inverse;
        const auto& k = data.inverseShape;
        inverse << k[0][i], k[3][i], k[4][i], k[3][i], k[1][i], k[5][i], k[4][i], k[5][i], k[2][i];
        const double determinant =
            (shapeAround(data, state, i, back) * inverse / data.aggregate->lattice.spacing).determinant();
        const double theta = kernels::logarithmOfVolume(determinant, [](double ratio) { return std::log(ratio); }) -
                             data.changes.restDilatation[i];
        const double strain = kernels::volumetricStrain(data.bulk[i], theta, data.changes.restDilatation[i]);
        sum += 0.5 * data.bulk[i] * strain * strain;
    }
    return sum;
}

} // namespace

void markBroken(ConnectionData& data, const ConnectionId& connection)
{
    data.forgetEnergy();
    data.brokenAround.resize(data.aggregate->size(), 0);
    const auto [lower, upper] = data.endsOf(connection);
    data.brokenAround[lower] |= std::uint32_t{1} << connection.direction;
    data.brokenAround[upper] |= std::uint32_t{1} << (Lattice::directionCount + connection.direction);
    // What has begun to break apart bears no more hydrostatic tension than springs do, of bulk modulus 5/3 mu.
    data.bulk[lower] = 0;
    data.bulk[upper] = 0;
    if (!data.tensors)
        return;
    data.tensors->tensionShare.resize(data.aggregate->size(), 1);
    for (const ObjectIndex end : {lower, upper}) {
        const Material& material = data.materials->of(end);
        const double bulk = material.lameLambda() + 2.0 / 3 * material.shearModulus();
        data.tensors->tensionShare[end] = std::min(1.0, 5.0 / 3 * material.shearModulus() / bulk);
    }
}

/// An object some connections of which broke bears with the share of its volume that those left say something about,
/// in the direction n in which they say least: min n^T K n / n^T K_made n. At the face of a crack that is a half, as
/// for a cell that is cut there. With more, the object would bear on few connections, and be stiffer than steps
/// allow.
void findLiveShape(ConnectionData& data, ObjectIndex object)
{
    if (data.inverseShape[0][object] == 0)
        return; // flat, and it stays so
    Mat3 live = Mat3::Zero();
    Mat3 made = Mat3::Zero();
    data.forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const auto [d, lower] = connection;
        const Vec3 step = latticeStep(connection, object);
        live += data.stiffness[d][lower] * step * step.transpose();
        made += data.laws.between(object, neighbor).stiffness * data.aggregate->lattice.spacing *
                data.aggregate->weight[d][lower] * step * step.transpose();
    });
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> solver(live, made + 1e-9 * made.trace() * Mat3::Identity(),
                                                                Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
    const double share = std::clamp(solver.eigenvalues()[0], 0.0, 1.0);
    setInverseShape(data, object, share < leastLiveShape ? Mat3::Zero() : live);
    if (data.tensors)
        data.tensors->volume[object] = share * data.borneVolume[object];
}

double breakAll(ConnectionData& data, const ObjectState& state, const std::vector<BrokenConnection>& connections,
                double step)
{
    std::vector<ObjectIndex> objects;
    for (const ConnectionId& connection : connections)
        for (const ObjectIndex end : data.endsOf(connection))
            objects.push_back(end);
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    // In the semi-implicit scheme the force of a connection has acted up to half a step ago: what it had then is set
    // free.
    const double back = step / 2;
    VectorArray before;
    if (data.tensors) {
        before = state.position;
        for (std::size_t i = 0; i < state.size(); ++i)
            before.set(i, placeBefore(state, i, back));
    }
    double released = data.tensors ? storedEnergy(data, before) : energyAround(data, state, objects, back);
    for (const BrokenConnection& connection : connections) {
        double& k = data.stiffness[connection.direction][connection.lower];
        const auto [lower, upper] = data.endsOf(connection);
        const double length = (placeBefore(state, upper, back) - placeBefore(state, lower, back)).norm();
        const double stretch = length - data.nominalLength(connection);
        if (!data.tensors)
            released += 0.5 * k * stretch * stretch;
        k = 0;
        data.changes.broken.push_back(connection);
        markBroken(data, connection);
    }
    data.count -= connections.size();
    for (const ObjectIndex object : objects)
        findLiveShape(data, object);
    // Without tensors the volumetric energy of the ends is all set free.
    return data.tensors ? released - storedEnergy(data, before) : released;
}

BreakReport breakOverloaded(ConnectionData& data, const ObjectState& state, double step)
{
    BreakReport report;
    if (!data.laws.anyBreaks())
        return report;
    if (const std::vector<BrokenConnection> broken = overloaded(data, state); !broken.empty()) {
        report.released = breakAll(data, state, broken, step);
        report.broken = broken.size();
    }
    return report;
}

} // namespace knead
