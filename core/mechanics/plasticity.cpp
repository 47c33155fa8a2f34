// Plastic flow, re-normalization and recovery: how nominal lengths and plastic metrics change. Part of StructuralConnections.
#include "core/mechanics/kernel_views.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/task/parallel.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr std::size_t chunkSize = 256;

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

double bulkModulusOf(const Material& material)
{
    return material.lameLambda() + 2.0 / 3 * material.shearModulus();
}

double yieldStressOf(const Material& material)
{
    return material.yields() ? material.yieldStress : std::numeric_limits<double>::infinity();
}

/// W of all objects, where |s| falls to its share q: D = G |e|^2 (1 - q^2), and W = 2 G |e|^2 q (1 - q) = D 2 q / (1 + q) [J].
double workOfObjects(const TensorBody& body)
{
    double work = 0;
    for (std::size_t i = 0; i < body.share.size(); ++i)
        work += body.dissipated[i] * 2 * body.share[i] / (1 + body.share[i]);
    return work;
}

/// What heals is not tired by being kneaded to and fro.
double shearDamageOf(const Material& material)
{
    return material.heals() ? 0 : 0.5;
}

} // namespace

void StructuralConnections::findTensorNumbers()
{
    m_tensors = anyTensorial() ? std::make_unique<TensorBody>() : nullptr;
    if (!m_tensors)
        return;
    const std::size_t count = m_aggregate->size();
    TensorBody& body = *m_tensors;
    body.volume.assign(m_aggregate->volume.begin(), m_aggregate->volume.end()); // see findLiveShape()
    body.energy.assign(count, 0);
    findRubber();
    if (m_materials->isUniform())
        return;
    for (auto* numbers :
         {&body.shear, &body.bulk, &body.yieldStress, &body.hardening, &body.flowTime, &body.shearDamage})
        numbers->assign(count, 0);
    std::vector<double> shape(count, 0);     // sum of w |o|^2 over all connections that were made
    std::vector<double> stiffness(count, 0); // sum of k |o|^2
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& o = Lattice::directions[d];
        const double squared = Vec3(o[0], o[1], o[2]).squaredNorm();
        forEachForward(
            m_aggregate->lattice, d, 0, count, [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                for (std::size_t s = 0; s < n; ++s) {
                    const double share = squared * m_aggregate->weight[d][lower + s];
                    const double k =
                        squared * m_aggregate->lattice.spacing * m_aggregate->weight[d][lower + s] *
                        m_laws.between(static_cast<ObjectIndex>(i + s), static_cast<ObjectIndex>(j + s)).stiffness;
                    for (const std::size_t end : {i + s, j + s}) {
                        stiffness[end] += k;
                        shape[end] += share;
                    }
                }
            });
    }
    for (ObjectIndex i = 0; i < count; ++i) {
        const Material& material = m_materials->of(i);
        // Beside softer material, connections are as stiff as springs in series, and so is the object.
        const double own = material.shearModulus() * m_aggregate->lattice.spacing * shape[i];
        const double share = own > 0 ? std::min(1.0, stiffness[i] / own) : 1;
        body.shear[i] = share * material.shearModulus();
        body.bulk[i] = share * bulkModulusOf(material);
        body.yieldStress[i] = yieldStressOf(material);
        body.hardening[i] = material.hardening;
        body.flowTime[i] = material.relaxationTime;
        body.shearDamage[i] = shearDamageOf(material);
    }
}

kernels::TensorLawNumbers StructuralConnections::tensorNumbers() const
{
    const TensorBody& body = *m_tensors;
    const Material& own = m_materials->materials().front();
    const auto number = [](const LaneVector<double>& each, double all) {
        return kernels::ObjectNumber{each.empty() ? nullptr : each.data(), all};
    };
    return {.volume = body.volume.data(),
            .shear = number(body.shear, own.shearModulus()),
            .bulk = number(body.bulk, bulkModulusOf(own)),
            .tensionShare = number(body.tensionShare, 1),
            .yieldStress = number(body.yieldStress, yieldStressOf(own)),
            .hardening = number(body.hardening, own.hardening),
            .flowTime = number(body.flowTime, own.relaxationTime),
            .shearDamage = number(body.shearDamage, shearDamageOf(own))};
}

void StructuralConnections::applyTensorLaw(const VectorArray& position, const kernels::FlowResult* flow,
                                           bool withEnergy)
{
    TensorBody& body = *m_tensors;
    const kernels::TensorLawNumbers numbers = tensorNumbers();
    const PlasticState& state = flow != nullptr ? m_changes.plastic : plasticState();
    const std::array<double*, 9> stress = stressColumns(position.size());
    const auto metric = pointersTo<const double*>(state.metric);
    if (rubber() != nullptr && rubber()->isWhole) {
        applyHyperelasticLaw(position, withEnergy);
        return;
    }
    forEachSurroundings(position, [&](const kernels::Surroundings& at) {
        kernels::best().tensorLaw({.at = at,
                                   .numbers = numbers,
                                   .plastic = {.metric = state.metric[0].empty() ? nullptr : metric.data(),
                                               .equivalentStrain = state.equivalentStrain.data(),
                                               .damage = state.damage.data()},
                                   .flow = flow,
                                   .stress = stress.data(),
                                   .theta = withEnergy ? m_theta.data() : nullptr,
                                   .energy = withEnergy ? body.energy.data() : nullptr});
    });
    if (rubber() != nullptr)
        applyHyperelasticLaw(position, withEnergy);
}

/// ln(L / l) of all connections, and the dilatation of all objects.
void StructuralConnections::findStrains(const VectorArray& position)
{
    TensorBody& body = *m_tensors;
    const DirectionArray& lengths = m_changes.plastic.nominalLength;
    forEachSurroundings(position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, body.dilatation.data(), nullptr);
    });
    for (std::size_t i = 0; i < position.size(); ++i)
        body.dilatation[i] += m_changes.restDilatation[i];
    forEachBlock(position.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachForward(m_aggregate->lattice, d, begin, end,
                           [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                               kernels::best().naturalStrain(n, kernels::from(position, i), kernels::from(position, j),
                                                             &lengths[d][i], &body.strain[d][i]);
                           });
    });
}

/// Nominal lengths after the flow of the objects. @return energy of the connections that went with it, and the work of their forces
/// afterwards on it [J]
std::pair<double, double> StructuralConnections::lengthen(const VectorArray& position)
{
    TensorBody& body = *m_tensors;
    const DirectionArray& before = m_changes.plastic.nominalLength;
    std::vector<std::pair<double, double>> sums((position.size() + m_blockSize - 1) / m_blockSize);
    forEachBlock(position.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        std::array<double, kernels::sumLanes> lanes{};
        std::array<double, kernels::sumLanes> work{};
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachForward(m_aggregate->lattice, d, begin, end,
                           [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                               kernels::best().lengthen(n, {.lower = kernels::from(position, i),
                                                            .upper = kernels::from(position, j),
                                                            .strain = &body.strain[d][i],
                                                            .lowerShare = &body.share[i],
                                                            .upperShare = &body.share[j],
                                                            .lowerAffine = &body.affine[d][i],
                                                            .upperAffine = &body.affine[d][j],
                                                            .lowerLengthening = &body.lengthening[d][i],
                                                            .upperLengthening = &body.lengthening[d][j],
                                                            .stiffness = &m_stiffness[d][i],
                                                            .before = &before[d][i],
                                                            .after = &body.flowed.nominalLength[d][i],
                                                            .dissipated = lanes.data(),
                                                            .work = work.data()});
                           });
        sums[begin / m_blockSize] = {std::accumulate(lanes.begin(), lanes.end(), 0.0),
                                     std::accumulate(work.begin(), work.end(), 0.0)};
    });
    std::pair<double, double> sum;
    for (const auto& [dissipated, work] : sums) {
        sum.first += dissipated;
        sum.second += work;
    }
    return sum;
}

void StructuralConnections::flow(const VectorArray& position, double duration)
{
    TensorBody& body = *m_tensors;
    if (body.share.size() != position.size()) {
        body.flowed = m_changes.plastic;
        body.share.assign(position.size(), 1);
        body.dissipated.assign(position.size(), 0);
        body.dilatation.assign(position.size(), 0);
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            const std::size_t used = m_stiffness[d].empty() ? 0 : position.size();
            body.strain[d].assign(used, 0);
            body.affine[d].assign(used, 0);
            body.lengthening[d].assign(used, 1);
        }
    }
    findStrains(position);
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
    applyTensorLaw(position, &result, false);
    const double ofObjects = std::accumulate(body.dissipated.begin(), body.dissipated.end(), 0.0);
    const auto [ofConnections, work] = lengthen(position);
    body.dissipatedEnergy = ofConnections + ofObjects;
    body.flowWork = work + workOfObjects(body);
    m_hasTrial = true;
}

double StructuralConnections::acceptFlow()
{
    if (!m_hasTrial)
        return 0;
    m_hasTrial = false;
    std::swap(m_changes.plastic, m_tensors->flowed);
    const bool hasFlowed =
        std::any_of(m_tensors->share.begin(), m_tensors->share.end(), [](double s) { return s < 1; });
    m_lengthVersion += hasFlowed ? 1 : 0;
    return m_tensors->dissipatedEnergy;
}

/// C becomes what F makes of the shape at rest, all shear is forgotten; on the way there the elastic part of F shrinks.
double StructuralConnections::renormalize(const ObjectState& state, const std::vector<std::uint8_t>& marks,
                                          double share)
{
    rejectFlow();
    makeLengthsOwn();
    if (rubber() != nullptr)
        rubber()->springsAreKnown = false;
    ++m_lengthVersion;
    const auto takesPart = [&](std::size_t object) { return marks.empty() || marks[object] != 0; };
    const double before = energy(state.position);
    PlasticState& plastic = m_changes.plastic;
    std::array<LaneVector<double>, 9> gradients;
    for (auto& component : gradients)
        component.assign(state.size(), 0);
    const auto gradient = pointersTo<double*>(gradients);
    forEachSurroundings(state.position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, m_theta.data(), gradient.data());
    });
    // Lengths are relative to C where there is one, and C has no volume.
    const auto volumeOf = [&](std::size_t i) {
        return m_tensors && m_inverseShape[0][i] != 0 ? m_theta[i] + m_changes.restDilatation[i] : 0.0;
    };
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               if (m_stiffness[d][lower + s] == 0 || !takesPart(i + s) || !takesPart(j + s))
                                   continue;
                               double& nominal = plastic.nominalLength[d][lower + s];
                               const double length = (state.position.at(j + s) - state.position.at(i + s)).norm();
                               const double volume = (volumeOf(i + s) + volumeOf(j + s)) / 6;
                               nominal += share * (length * std::exp(-volume) - nominal);
                           }
                       });
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (!takesPart(i))
            continue;
        plastic.equivalentStrain[i] *= 1 - share;
        plastic.damage[i] *= 1 - share;
        if (m_inverseShape[0][i] == 0)
            continue; // flat: it has no F
        m_changes.restDilatation[i] += share * m_theta[i];
        Mat3 f;
        for (std::size_t n = 0; n < 9; ++n)
            f(static_cast<Eigen::Index>(n % 3), static_cast<Eigen::Index>(n / 3)) = gradients[n][i];
        if (f.determinant() < kernels::smallestVolumeRatio)
            continue;
        const Mat3 shape = f / std::cbrt(f.determinant());
        const Mat3 elastic = shape * metricAt(plastic, i).inverse() * shape.transpose();
        Mat3 kept = (1 - share) * elastic + share * elastic.trace() / 3 * Mat3::Identity();
        kept /= std::cbrt(kept.determinant());
        setMetric(plastic, i, shape.transpose() * kept.inverse() * shape);
    }
    forgetEnergy();
    return before - energy(state.position);
}

/// C from nominal lengths alone, of states that were kept without it: the symmetric H with n^T H n = ln(l / l_rest) as well as
/// it goes makes C = e^(2 H), which stays positive however the lengths were sheared.
void StructuralConnections::findMetric()
{
    PlasticState& plastic = m_changes.plastic;
    const std::size_t count = m_aggregate->size();
    std::vector<Mat6> normal(count, Mat6::Identity() * 1e-9);
    std::vector<Vec6> right(count, Vec6::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& o = Lattice::directions[d];
        const Vec3 n = Vec3(o[0], o[1], o[2]).normalized();
        const Vec6 form{n[0] * n[0], n[1] * n[1], n[2] * n[2], 2 * n[0] * n[1], 2 * n[0] * n[2], 2 * n[1] * n[2]};
        const double rest = m_aggregate->lattice.direction(static_cast<int>(d)).norm();
        forEachForward(m_aggregate->lattice, d, 0, count,
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t m) {
                           for (std::size_t s = 0; s < m; ++s) {
                               const double weight = m_aggregate->weight[d][lower + s];
                               const double strain = std::log(plastic.nominalLength[d][lower + s] / rest);
                               for (const std::size_t end : {i + s, j + s}) {
                                   normal[end] += weight * form * form.transpose();
                                   right[end] += weight * strain * form;
                               }
                           }
                       });
    }
    makeLengthsOwn();
    for (std::size_t i = 0; i < count; ++i) {
        Mat3 strain = symmetric(normal[i].ldlt().solve(right[i]));
        strain -= strain.trace() / 3 * Mat3::Identity();
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(strain);
        const Vec3 stretches = (2 * solver.eigenvalues()).array().exp();
        setMetric(plastic, i, solver.eigenvectors() * stretches.asDiagonal() * solver.eigenvectors().transpose());
    }
}

void StructuralConnections::recover(double dt)
{
    const auto& materials = m_materials->materials();
    std::vector<double> kept;
    for (const Material& material : materials)
        kept.push_back(material.heals() ? std::exp(-dt / material.healingTime) : 1);
    LaneVector<double>& damage = m_changes.plastic.damage;
    for (ObjectIndex i = 0; i < damage.size(); ++i)
        damage[i] *= kept[m_materials->indexOf(i)];
}

} // namespace knead
