// Plastic flow, re-normalization and recovery: how nominal lengths change. Part of StructuralConnections.
#include "core/mechanics/kernel_views.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

constexpr std::size_t chunkSize = 256;

/// Energy of a connection [J].
double springEnergy(double stiffness, double length, double nominalLength)
{
    return 0.5 * stiffness * (length - nominalLength) * (length - nominalLength);
}

} // namespace

/// Deviatoric flow (Perzyna with linear hardening, per connection; the bond form of state-based plasticity, Mitchell 2011):
/// strain beyond yield, measured against the dilatation from ln det F, so that flow keeps volume at finite strain.
double StructuralConnections::flowBlock(const ObjectState& state, std::size_t begin, std::size_t end, double dt)
{
    std::array<double, kernels::sumLanes> dissipated{};
    double yield[chunkSize];
    double hardening[chunkSize];
    double share[chunkSize];
    using kernels::from;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, begin, end,
                       [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                           for (std::size_t s = 0; s < n; s += chunkSize) {
                               const std::size_t count = std::min(chunkSize, n - s);
                               m_laws.fill(&ConnectionLaw::yieldStrain, i + s, j + s, count, yield);
                               m_laws.fill(&ConnectionLaw::hardening, i + s, j + s, count, hardening);
                               m_laws.fill(&ConnectionLaw::flowTime, i + s, j + s, count, share);
                               for (std::size_t c = 0; c < count; ++c)
                                   share[c] = share[c] > 0 ? -std::expm1(-dt / share[c]) : 1;
                               kernels::best().flow(count, {from(state.position, i + s), from(state.position, j + s),
                                                            &m_theta[i + s], &m_theta[j + s], &m_stiffness[d][i + s],
                                                            yield, hardening, share, &m_changes.nominalLength[d][i + s],
                                                            &m_changes.plasticStrain[d][i + s], dissipated.data()});
                           }
                       });
    return std::accumulate(dissipated.begin(), dissipated.end(), 0.0);
}

StructuralConnections::FlowReport StructuralConnections::flowAndBreak(const ObjectState& state, double dt, double step)
{
    FlowReport report;
    if (m_laws.anyYields()) {
        if (!m_thetaIsPresent)
            computeStress(state.position);
        std::vector<double> dissipated((state.size() + m_blockSize - 1) / m_blockSize);
        forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
            dissipated[begin / m_blockSize] = flowBlock(state, begin, end, dt);
        });
        report.plastic = std::accumulate(dissipated.begin(), dissipated.end(), 0.0);
        m_lengthVersion += report.plastic > 0 ? 1 : 0;
    }
    if (m_laws.anyBreaks())
        if (const std::vector<ConnectionId> broken = overloaded(state); !broken.empty()) {
            report.fracture = breakAll(state, broken, step);
            report.broken = broken.size();
        }
    return report;
}

double StructuralConnections::renormalize(const ObjectState& state, const std::vector<std::uint8_t>& marks,
                                          double share)
{
    makeLengthsOwn();
    ++m_lengthVersion;
    const auto takesPart = [&](std::size_t object) { return marks.empty() || marks[object] != 0; };
    double released = 0;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               const double k = m_stiffness[d][lower + s];
                               if (k == 0 || !takesPart(i + s) || !takesPart(j + s))
                                   continue;
                               double& nominal = m_changes.nominalLength[d][lower + s];
                               const double length = (state.position.at(j + s) - state.position.at(i + s)).norm();
                               released += springEnergy(k, length, nominal);
                               nominal += share * (length - nominal);
                               released -= springEnergy(k, length, nominal);
                               m_changes.plasticStrain[d][lower + s] *= 1 - share;
                           }
                       });
    computeStress(state.position);
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (!takesPart(i))
            continue;
        const double relaxed = share * m_theta[i];
        released += volumetricEnergy(i);
        m_theta[i] -= relaxed;
        m_changes.restDilatation[i] += relaxed;
        released -= volumetricEnergy(i);
    }
    return released;
}

void StructuralConnections::recover(double dt)
{
    const auto healing = [&](ObjectIndex i) {
        const Material& material = m_materials->of(i);
        return material.heals() ? std::exp(-dt / material.healingTime) : 1;
    };
    for (auto& strains : m_changes.plasticStrain)
        for (ObjectIndex i = 0; i < strains.size(); ++i)
            strains[i] *= healing(i);
}

} // namespace knead
