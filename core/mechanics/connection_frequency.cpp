// The largest frequency of a body: part of StructuralConnections.
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double modeSteps = 127; // of a kept mode, from 0 to its largest component

/// Stiffness of one connection in its present state, less what would make it softer: along itself k, across it the pull per
/// length when it is stretched.
Mat3 tangent(const Vec3& across, double k, double nominalLength)
{
    const double length = across.norm();
    if (length == 0)
        return k * Mat3::Identity();
    const Vec3 n = across / length;
    const Mat3 dyad = n * n.transpose();
    const double sideways = std::max(0.0, 1 - nominalLength / length);
    return k * (dyad + sideways * (Mat3::Identity() - dyad));
}

} // namespace

std::vector<double> StructuralConnections::bondBounds(const ObjectState& state, const std::vector<double>& added) const
{
    std::vector<double> bounds(state.size());
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        std::vector<Mat3> stiffness(end - begin, Mat3::Zero());
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
            const LaneVector<double>& own = plasticState().nominalLength[d];
            const double uniform = m_aggregate->lattice.direction(static_cast<int>(d)).norm();
            const auto add = [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                for (std::size_t s = 0; s < n; ++s)
                    if (const double k = m_stiffness[d][lower + s]; k > 0)
                        stiffness[i + s - begin] += tangent(state.position.at(j + s) - state.position.at(i + s), k,
                                                            own.empty() ? uniform : own[lower + s]);
            };
            forEachForward(m_aggregate->lattice, d, begin, end, add);
            forEachBackward(m_aggregate->lattice, d, begin, end, add);
        }
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        for (std::size_t i = begin; i < end; ++i) {
            solver.computeDirect(stiffness[i - begin], Eigen::EigenvaluesOnly);
            bounds[i] = 2 * solver.eigenvalues()[2] + added[i];
        }
    });
    return bounds;
}

/// The volumetric term stiffens the fastest waves from 3 mu to lambda + 2 mu, but not what is added.
std::vector<double> StructuralConnections::stiffnessBounds(const ObjectState& state,
                                                           const std::vector<double>& added) const
{
    std::vector<double> bounds = bondBounds(state, std::vector<double>(added.size(), 0));
    for (ObjectIndex i = 0; i < bounds.size(); ++i) {
        const Material& material = m_materials->of(i);
        const double waves = (material.lameLambda() + 2 * material.shearModulus()) / (3 * material.shearModulus());
        bounds[i] *= std::max(1.0, waves);
    }
    if (rubber() != nullptr)
        stiffenByStretch(state, bounds);
    for (std::size_t i = 0; i < bounds.size(); ++i)
        bounds[i] += added[i];
    return bounds;
}

double StructuralConnections::iteratedFrequency(ObjectState& state, const std::vector<double>& added)
{
    const std::size_t count = state.size();
    // Any vector has a share in all modes; the golden ratio's multiples are spread evenly. A little of it is mixed into the
    // mode found last, so that another one that has become faster since is found in time.
    const bool known = m_mode.size() == count;
    double size = 1;
    if (known) {
        for (std::size_t i = 0; i < count; ++i)
            size = std::max(size, m_mode.at(i).cwiseAbs().maxCoeff());
    } else {
        m_mode.resize(count);
    }
    constexpr double freshShare = 0.1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto spread = [&](double factor) { return std::fmod(static_cast<double>(i + 1) * factor, 1.0) - 0.5; };
        m_mode.add(i, freshShare * size * Vec3(spread(0.6180339887), spread(0.7548776662), spread(0.5698402910)));
    }
    ObjectState probe = state;
    probe.velocity.setZero();
    const double step = 1e-4 * m_aggregate->lattice.spacing;
    const auto displaced = [&](double amount) {
        for (std::size_t i = 0; i < count; ++i)
            probe.position.set(i, state.position.at(i) + amount * m_mode.at(i));
        computeForces(probe);
        return probe.force;
    };
    double squared = 0;
    const int iterations = known ? 8 : 40;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        double largest = 0;
        for (std::size_t i = 0; i < count; ++i)
            largest = std::max(largest, m_mode.at(i).cwiseAbs().maxCoeff());
        if (!(largest > 0))
            break;
        for (std::size_t i = 0; i < count; ++i)
            m_mode.set(i, m_mode.at(i) / largest);
        const VectorArray ahead = displaced(step);
        const VectorArray behind = displaced(-step);
        double numerator = 0;
        double denominator = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 stiffnessTimesMode = (behind.at(i) - ahead.at(i)) / (2 * step);
            numerator += m_mode.at(i).dot(stiffnessTimesMode);
            denominator += state.mass[i] * m_mode.at(i).squaredNorm();
            m_mode.set(i, stiffnessTimesMode / state.mass[i]);
        }
        squared = std::max(squared, numerator / denominator);
    }
    double contact = 0;
    for (std::size_t i = 0; i < count; ++i)
        contact = std::max(contact, added[i] / state.mass[i]);
    constexpr double margin = 1.1; // 40 iterations come within a few percent from below
    return std::sqrt(margin * margin * squared + contact);
}

std::vector<std::int8_t> StructuralConnections::fastestMode() const
{
    double largest = 0;
    for (std::size_t i = 0; i < m_mode.size(); ++i)
        largest = std::max(largest, m_mode.at(i).cwiseAbs().maxCoeff());
    std::vector<std::int8_t> mode;
    if (!(largest > 0 && std::isfinite(largest)))
        return mode;
    for (std::size_t i = 0; i < m_mode.size(); ++i)
        for (const double component : m_mode.at(i))
            mode.push_back(static_cast<std::int8_t>(std::lround(modeSteps * component / largest)));
    return mode;
}

void StructuralConnections::setFastestMode(const std::vector<std::int8_t>& mode)
{
    m_mode.resize(mode.size() / 3);
    for (std::size_t i = 0; i < m_mode.size(); ++i)
        m_mode.set(i, Vec3(mode[3 * i], mode[3 * i + 1], mode[3 * i + 2]) / modeSteps);
}

double StructuralConnections::leastDampingTime() const
{
    // Of compression waves, of stiffness lambda + 2 mu, only the connections' share 3 mu is damped.
    const double stiffening = m_materials->largest([](const Material& material) {
        return (material.lameLambda() + 2 * material.shearModulus()) / (3 * material.shearModulus());
    });
    return m_laws.leastDampingTime() / std::max(1.0, stiffening);
}

double StructuralConnections::largestFrequency(ObjectState& state, const std::vector<double>& added)
{
    if (!m_tensors && m_materials->largest([](const Material& material) { return material.poissonRatio; }) > 0.25)
        return iteratedFrequency(state, added);
    const std::vector<double> bounds = m_tensors ? stiffnessBounds(state, added) : bondBounds(state, added);
    double squared = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        squared = std::max(squared, bounds[i] / state.mass[i]);
    return std::sqrt(squared);
}

} // namespace knead
