#include "core/mechanics/connection_stress.h"

#include "core/mechanics/connection_parameters.h"
#include "core/mechanics/connection_surroundings.h"
#include "core/mechanics/hyperelastic_law.h"

#include <numeric>

namespace knead {

namespace {

/// Where the stress of objects goes, column by column.
std::array<double*, 9> stressColumns(ConnectionData& data, std::size_t objects)
{
    std::array<double*, 9> stress{};
    for (VectorArray& column : data.stress)
        if (column.size() != objects)
            column.resize(objects);
    for (std::size_t c = 0; c < 9; ++c)
        stress[c] = data.stress[c / 3].component(c % 3);
    return stress;
}

void applyHyperelasticLaw(ConnectionData& data, const VectorArray& position, WantedOfLaw wanted)
{
    const RubberBody& body = *data.rubber();
    const bool withEnergy = wanted == WantedOfLaw::forcesAndEnergy;
    const RubberNumbers own = rubberNumbers(data.materials->materials().front());
    const kernels::TensorLawNumbers numbers = tensorNumbers(data);
    const PlasticState& state = data.plasticState();
    const std::array<double*, 9> stress = stressColumns(data, position.size());
    const auto metric = pointersTo<const double*>(state.metric);
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().hyperelasticLaw(
            {.at = at,
             .numbers = numbers,
             .isRubber = body.isWhole ? kernels::ObjectNumber{nullptr, 1} : numberOf(body.isRubber, 0),
             .secondShare = numberOf(body.secondShare, own.secondShare),
             .inverseChain = numberOf(body.inverseChain, own.inverseChain),
             .firstScale = numberOf(body.firstScale, own.firstScale),
             .metric = state.metric[0].empty() ? nullptr : metric.data(),
             .stress = stress.data(),
             .theta = withEnergy ? data.theta.data() : nullptr,
             .energy = withEnergy ? data.tensors->energy.data() : nullptr});
    });
}

/// Of a connection, whose ends have half of it each.
double springEnergy(const ConnectionData& data, std::size_t i, std::size_t j, double stiffness, double length,
                    double nominal)
{
    const double stretch = length - nominal;
    if (data.rubber() == nullptr)
        return 0.5 * stiffness * stretch * stretch;
    const double rubberlike = 0.5 * (data.rubber()->isRubber[i] + data.rubber()->isRubber[j]);
    return 0.5 * stiffness *
           ((1 - rubberlike) * stretch * stretch + rubberlike * kernels::rubberSpringShare * length * length);
}

double objectEnergy(const ConnectionData& data, std::size_t object)
{
    if (data.tensors)
        return data.tensors->energy[object];
    const double strain =
        kernels::volumetricStrain(data.bulk[object], data.theta[object], data.changes.restDilatation[object]);
    return 0.5 * data.bulk[object] * strain * strain;
}

double findEnergy(ConnectionData& data, const VectorArray& position)
{
    const bool hasObjects = data.hasBulk || data.tensors;
    if (hasObjects)
        findStress(data, position, WantedOfLaw::forcesAndEnergy);
    std::vector<double> sums((position.size() + data.blockSize - 1) / data.blockSize);
    forEachBlock(position.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        double& sum = sums[begin / data.blockSize];
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
            const kernels::ObjectNumber lengths = data.nominalLengths(d);
            forEachPair(data.aggregate->lattice, d, begin, end, [&](ObjectIndex i, ObjectIndex j) {
                const double length = (position.at(j) - position.at(i)).norm();
                sum += springEnergy(data, i, j, data.stiffness[d][i], length, valueAt(lengths, i));
            });
        }
        for (std::size_t i = begin; hasObjects && i < end; ++i)
            sum += objectEnergy(data, i);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace

void findStress(ConnectionData& data, const VectorArray& position, WantedOfLaw wanted)
{
    if (data.tensors) {
        applyTensorLaw(data, position, nullptr, wanted);
        return;
    }
    const std::array<double*, 9> stress = stressColumns(data, position.size());
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().volumetricStress(
            {.at = at, .bulk = data.bulk.data(), .stress = stress.data(), .theta = data.theta.data()});
    });
    for (const ObjectIndex object : data.flat)
        data.theta[object] = 0;
}

void applyTensorLaw(ConnectionData& data, const VectorArray& position, const kernels::FlowResult* flow,
                    WantedOfLaw wanted)
{
    TensorBody& body = *data.tensors;
    const bool withEnergy = wanted == WantedOfLaw::forcesAndEnergy;
    const kernels::TensorLawNumbers numbers = tensorNumbers(data);
    const PlasticState& state = flow != nullptr ? data.changes.plastic : data.plasticState();
    const std::array<double*, 9> stress = stressColumns(data, position.size());
    const auto metric = pointersTo<const double*>(state.metric);
    if (data.rubber() != nullptr && data.rubber()->isWhole) {
        applyHyperelasticLaw(data, position, wanted);
        return;
    }
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().tensorLaw({.at = at,
                                   .numbers = numbers,
                                   .plastic = {.metric = state.metric[0].empty() ? nullptr : metric.data(),
                                               .equivalentStrain = state.equivalentStrain.data(),
                                               .damage = state.damage.data()},
                                   .flow = flow,
                                   .stress = stress.data(),
                                   .theta = withEnergy ? data.theta.data() : nullptr,
                                   .energy = withEnergy ? body.energy.data() : nullptr});
    });
    if (data.rubber() != nullptr)
        applyHyperelasticLaw(data, position, wanted);
}

double storedEnergy(ConnectionData& data, const VectorArray& position)
{
    if (!position.hasSameBits(data.energyAt)) {
        data.energy = findEnergy(data, position);
        data.energyAt = position;
    }
    return data.energy;
}

std::size_t countInverted(ConnectionData& data, const ObjectState& state)
{
    findStress(data, state.position, WantedOfLaw::forcesAndEnergy);
    std::size_t inverted = 0;
    for (ObjectIndex i = 0; i < state.size(); ++i) {
        if (data.theta[i] + data.changes.restDilatation[i] > kernels::flatDilatation)
            continue;
        std::size_t neighbors = 0;
        data.forEachConnection(i, [&](ObjectIndex, const ConnectionId&) { ++neighbors; });
        if (neighbors >= 2 * Lattice::isotropicCount)
            ++inverted;
    }
    return inverted;
}

DeformationGradients::DeformationGradients(const ConnectionData& data, const VectorArray& position,
                                           LaneVector<double>& theta)
{
    for (auto& component : m_components)
        component.assign(position.size(), 0);
    const auto components = pointersTo<double*>(m_components);
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, theta.data(), components.data());
    });
}

Mat3 DeformationGradients::of(std::size_t object) const
{
    Mat3 f;
    for (std::size_t n = 0; n < 9; ++n)
        f(static_cast<Eigen::Index>(n % 3), static_cast<Eigen::Index>(n / 3)) = m_components[n][object];
    return f;
}

} // namespace knead
