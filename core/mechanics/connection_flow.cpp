// Plastic flow, re-normalization and recovery: how nominal lengths and plastic metrics change.
#include "core/mechanics/connection_flow.h"

#include "core/mechanics/connection_parameters.h"
#include "core/mechanics/connection_stress.h"
#include "core/mechanics/connection_surroundings.h"
#include "core/mechanics/connection_volume.h"
#include "core/mechanics/kernel_views.h"
#include "core/task/block_sums.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

Mat3 symmetric(const Vec6& c)
{
    Mat3 matrix;
    matrix << c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2];
    return matrix;
}

Mat3 metricAt(const PlasticState& state, std::size_t object)
{
    Vec6 c;
    for (std::size_t n = 0; n < 6; ++n)
        c[static_cast<Eigen::Index>(n)] = state.metric[n][object];
    return symmetric(c);
}

void setMetric(PlasticState& state, std::size_t object, const Mat3& metric)
{
    constexpr Eigen::Index rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr Eigen::Index columns[6] = {0, 1, 2, 1, 2, 2};
    for (std::size_t n = 0; n < 6; ++n)
        state.metric[n][object] = metric(rows[n], columns[n]);
}

bool flowsAnywhere(const TensorBody& body)
{
    return std::any_of(body.blockFlows.begin(), body.blockFlows.end(), [](std::uint8_t block) { return block != 0; });
}

/// W of all objects, where |s| falls to its share q: D = G |e|^2 (1 - q^2), and W = 2 G |e|^2 q (1 - q) = D 2 q / (1
/// + q) [J].
double workOfObjects(const TensorBody& body)
{
    double work = 0;
    for (std::size_t i = 0; i < body.share.size(); ++i)
        work += body.dissipated[i] * 2 * body.share[i] / (1 + body.share[i]);
    return work;
}

/// ln(L / l) of all connections, and the dilatation of all objects.
void findStrains(ConnectionData& data, const VectorArray& position)
{
    TensorBody& body = *data.tensors;
    const DirectionArray& lengths = data.changes.plastic.nominalLength;
    const LaneVector<double>& rest = data.changes.restDilatation;
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, body.dilatation.data(), nullptr);
        for (std::size_t i = at.begin; i < at.end; ++i)
            body.dilatation[i] += rest[i];
    });
    forEachBlock(position.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachStretch(data.aggregate->lattice, d, begin, end, [&](std::size_t i, std::size_t j, std::size_t n) {
                kernels::best().naturalStrain(n, kernels::from(position, i), kernels::from(position, j), &lengths[d][i],
                                              &body.strain[d][i]);
            });
    });
}

/// Per block, whether anything in it has flowed.
std::vector<std::uint8_t> blocksThatFlow(const ConnectionData& data)
{
    const LaneVector<double>& share = data.tensors->share;
    return ofEachBlock<std::uint8_t>(share.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        std::uint8_t flows = 0;
        for (std::size_t i = begin; i < end; ++i)
            flows |= share[i] >= 1 ? 0 : 1;
        return flows;
    });
}

/// How much further on the upper end of a connection may be.
std::size_t farthestAhead(const Lattice& lattice)
{
    std::size_t farthest = 0;
    for (const auto& segments : lattice.segments)
        for (const Lattice::Segment& segment : segments)
            farthest = std::max(farthest, static_cast<std::size_t>(segment.offset));
    return farthest;
}

/// Energy of connections that went with a flow, and the work of their forces afterwards on it [J].
struct LengthReport {
    double dissipated = 0;
    double work = 0;
};

/// Nominal lengths of the connections of a block after the flow of the objects.
LengthReport lengthenBlock(ConnectionData& data, const VectorArray& position, std::size_t begin, std::size_t end)
{
    TensorBody& body = *data.tensors;
    const DirectionArray& before = data.changes.plastic.nominalLength;
    std::array<double, kernels::sumLanes> lanes{};
    std::array<double, kernels::sumLanes> work{};
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        forEachStretch(data.aggregate->lattice, d, begin, end, [&](std::size_t i, std::size_t j, std::size_t n) {
            kernels::best().lengthen(n, {.lower = kernels::from(position, i),
                                         .upper = kernels::from(position, j),
                                         .strain = &body.strain[d][i],
                                         .lowerShare = &body.share[i],
                                         .upperShare = &body.share[j],
                                         .lowerAffine = &body.affine[d][i],
                                         .upperAffine = &body.affine[d][j],
                                         .lowerLengthening = &body.lengthening[d][i],
                                         .upperLengthening = &body.lengthening[d][j],
                                         .stiffness = &data.stiffness[d][i],
                                         .before = &before[d][i],
                                         .after = &body.flowed.nominalLength[d][i],
                                         .dissipated = lanes.data(),
                                         .work = work.data()});
        });
    return {std::accumulate(lanes.begin(), lanes.end(), 0.0), std::accumulate(work.begin(), work.end(), 0.0)};
}

/// The same of all blocks in reach of which something flows, or has flowed at the time before.
LengthReport lengthen(ConnectionData& data, const VectorArray& position)
{
    TensorBody& body = *data.tensors;
    const std::vector<std::uint8_t>& flows = body.blockFlows;
    const std::size_t size = data.blockSize;
    const auto reports = ofEachBlock<LengthReport>(position.size(), size, [&](std::size_t begin, std::size_t end) {
        const std::size_t farthest = std::min((end - 1 + body.reach) / size, flows.size() - 1);
        const auto first = flows.begin() + static_cast<std::ptrdiff_t>(begin / size);
        const auto last = flows.begin() + static_cast<std::ptrdiff_t>(farthest) + 1;
        const bool changes = std::any_of(first, last, [](std::uint8_t block) { return block != 0; });
        std::uint8_t& changed = body.blockLengthened[begin / size];
        const LengthReport report =
            changes || changed != 0 ? lengthenBlock(data, position, begin, end) : LengthReport{};
        changed = changes ? 1 : 0;
        return report;
    });
    LengthReport sum;
    for (const LengthReport& report : reports) {
        sum.dissipated += report.dissipated;
        sum.work += report.work;
    }
    return sum;
}

/// The next flow begins anew, since the state has been changed by something else.
void forgetFlow(ConnectionData& data)
{
    if (data.tensors)
        data.tensors->share.clear();
}

/// Makes room for a flow. What flowed and the state before are alike from here on where nothing flows.
void beginToFlow(ConnectionData& data)
{
    TensorBody& body = *data.tensors;
    const std::size_t count = data.aggregate->size();
    body.flowed = data.changes.plastic;
    body.share.assign(count, 1);
    body.dissipated.assign(count, 0);
    body.dilatation.assign(count, 0);
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::size_t used = data.stiffness[d].empty() ? 0 : count;
        body.strain[d].assign(used, 0);
        body.affine[d].assign(used, 0);
        body.lengthening[d].assign(used, 1);
    }
    body.blockLengthened.assign((count + data.blockSize - 1) / data.blockSize, 0);
    body.reach = farthestAhead(data.aggregate->lattice);
}

} // namespace

void findFlow(ConnectionData& data, const VectorArray& position, double duration)
{
    TensorBody& body = *data.tensors;
    if (body.share.size() != position.size())
        beginToFlow(data);
    findStrains(data, position);
    const auto strain = pointersTo<const double*>(body.strain);
    const auto metric = pointersTo<double*>(body.flowed.metric);
    const auto affine = pointersTo<double*>(body.affine);
    const auto lengthening = pointersTo<double*>(body.lengthening);
    const kernels::FlowResult result{.duration = duration,
                                     .connectionStrain = strain.data(),
                                     .dilatation = body.dilatation.data(),
                                     .metric = metric.data(),
                                     .equivalentStrain = body.flowed.equivalentStrain.data(),
                                     .damage = body.flowed.damage.data(),
                                     .share = body.share.data(),
                                     .affine = affine.data(),
                                     .lengthening = lengthening.data(),
                                     .dissipated = body.dissipated.data()};
    applyTensorLaw(data, position, &result, WantedOfLaw::forces);
    body.blockFlows = blocksThatFlow(data);
    const LengthReport report = lengthen(data, position);
    body.dissipatedEnergy = report.dissipated;
    body.flowWork = report.work;
    if (flowsAnywhere(body)) {
        body.dissipatedEnergy += std::accumulate(body.dissipated.begin(), body.dissipated.end(), 0.0);
        body.flowWork += workOfObjects(body);
    }
    data.hasTrial = true;
}

double acceptFlow(ConnectionData& data)
{
    if (!data.hasTrial)
        return 0;
    data.hasTrial = false;
    std::swap(data.changes.plastic, data.tensors->flowed);
    data.lengthVersion += flowsAnywhere(*data.tensors) ? 1 : 0;
    return data.tensors->dissipatedEnergy;
}

/// C becomes what F makes of the shape at rest, all shear is forgotten; on the way there the elastic part of F
/// shrinks.
double renormalize(ConnectionData& data, const ObjectState& state, const std::vector<std::uint8_t>& marks, double share)
{
    rejectFlow(data);
    makeLengthsOwn(data);
    if (data.rubber() != nullptr)
        data.rubber()->springsAreKnown = false;
    ++data.lengthVersion;
    const auto takesPart = [&](std::size_t object) { return marks.empty() || marks[object] != 0; };
    const double before = storedEnergy(data, state.position);
    const double atRest = data.changes.keptVolume > 0 ? volumeAtRest(data) : 0;
    PlasticState& plastic = data.changes.plastic;
    forgetFlow(data);
    const DeformationGradients gradients(data, state.position, data.theta);
    // Lengths are relative to C where there is one, and C has no volume.
    const auto volumeOf = [&](std::size_t i) {
        return data.tensors && data.inverseShape[0][i] != 0 ? data.theta[i] + data.changes.restDilatation[i] : 0.0;
    };
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        forEachPair(data.aggregate->lattice, d, 0, state.size(), [&](ObjectIndex i, ObjectIndex j) {
            if (data.stiffness[d][i] == 0 || !takesPart(i) || !takesPart(j))
                return;
            double& nominal = plastic.nominalLength[d][i];
            const double length = (state.position.at(j) - state.position.at(i)).norm();
            const double volume = (volumeOf(i) + volumeOf(j)) / 6;
            nominal += share * (length * std::exp(-volume) - nominal);
        });
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (!takesPart(i))
            continue;
        plastic.equivalentStrain[i] *= 1 - share;
        plastic.damage[i] *= 1 - share;
        if (data.inverseShape[0][i] == 0)
            continue; // flat: it has no F
        data.changes.restDilatation[i] += share * data.theta[i];
        const Mat3 f = gradients.of(i);
        if (f.determinant() < kernels::smallestVolumeRatio)
            continue;
        const Mat3 shape = f / std::cbrt(f.determinant());
        const Mat3 elastic = shape * metricAt(plastic, i).inverse() * shape.transpose();
        Mat3 kept = (1 - share) * elastic + share * elastic.trace() / 3 * Mat3::Identity();
        kept /= std::cbrt(kept.determinant());
        setMetric(plastic, i, shape.transpose() * kept.inverse() * shape);
    }
    if (atRest > 0)
        data.changes.keptVolume *= volumeAtRest(data) / atRest;
    data.forgetEnergy();
    return before - storedEnergy(data, state.position);
}

/// C from nominal lengths alone, of states that were kept without it: the symmetric H with n^T H n = ln(l / l_rest)
/// as well as it goes makes C = e^(2 H), which stays positive however the lengths were sheared.
void findMetric(ConnectionData& data)
{
    PlasticState& plastic = data.changes.plastic;
    const std::size_t count = data.aggregate->size();
    std::vector<Mat6> normal(count, Mat6::Identity() * 1e-9);
    std::vector<Vec6> right(count, Vec6::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Vec3 n = latticeVector(d).normalized();
        const Vec6 form{n[0] * n[0], n[1] * n[1], n[2] * n[2], 2 * n[0] * n[1], 2 * n[0] * n[2], 2 * n[1] * n[2]};
        const double rest = data.aggregate->lattice.direction(static_cast<int>(d)).norm();
        forEachPair(data.aggregate->lattice, d, 0, count, [&](ObjectIndex i, ObjectIndex j) {
            const double weight = data.aggregate->weight[d][i];
            const double strain = std::log(plastic.nominalLength[d][i] / rest);
            for (const ObjectIndex end : {i, j}) {
                normal[end] += weight * form * form.transpose();
                right[end] += weight * strain * form;
            }
        });
    }
    makeLengthsOwn(data);
    for (std::size_t i = 0; i < count; ++i) {
        Mat3 strain = symmetric(normal[i].ldlt().solve(right[i]));
        strain -= strain.trace() / 3 * Mat3::Identity();
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(strain);
        const Vec3 stretches = (2 * solver.eigenvalues()).array().exp();
        setMetric(plastic, i, solver.eigenvectors() * stretches.asDiagonal() * solver.eigenvectors().transpose());
    }
}

void recover(ConnectionData& data, double dt)
{
    const auto& materials = data.materials->materials();
    std::vector<double> kept;
    for (const Material& material : materials)
        kept.push_back(material.heals() ? std::exp(-dt / material.healingTime) : 1);
    LaneVector<double>& damage = data.changes.plastic.damage;
    for (ObjectIndex i = 0; i < damage.size(); ++i)
        damage[i] *= kept[data.materials->indexOf(i)];
    if (data.tensors && data.tensors->flowed.damage.size() == damage.size())
        data.tensors->flowed.damage = damage;
}

} // namespace knead
