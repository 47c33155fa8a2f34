#include "core/mechanics/connection_frequency.h"

#include "core/mechanics/connection_forces.h"
#include "core/mechanics/rubber_connections.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double modeSteps = 127; // of a kept mode, from 0 to its largest component

constexpr std::size_t mostTangents = 64; // found at a time

/// Symmetric matrices: xx yy zz xy yz zx, each of all of them in a row.
using Tangents = std::array<std::array<double, mostTangents>, 6>;

/// Stiffness of connections in their present state, less what would make them softer: along themselves k, across them the
/// pull per length of those that are stretched, s = max(0, 1 - l / |d|): K = k ((1 - s) d d^T / |d|^2 + s I).
Tangents tangentsOf(const ConnectionData& data, const ObjectState& state, std::size_t d, std::size_t lower,
                    std::size_t upper, std::size_t n)
{
    const std::size_t stride = state.position.stride();
    const double* from = state.position.data() + lower;
    const double* to = state.position.data() + upper;
    const double* k = data.stiffness[d].data() + lower;
    const kernels::ObjectNumber lengths = data.nominalLengths(d);
    std::array<double, mostTangents> nominal;
    if (lengths.each != nullptr)
        std::copy_n(lengths.each + lower, n, nominal.begin());
    else
        std::fill_n(nominal.begin(), n, lengths.all);
    Tangents tangents;
    for (std::size_t s = 0; s < n; ++s) {
        const double x = to[s] - from[s];
        const double y = to[stride + s] - from[stride + s];
        const double z = to[2 * stride + s] - from[2 * stride + s];
        const double squared = x * x + y * y + z * z;
        const double present = squared > 0 ? squared : 1; // of two in one place all ways are along
        const double sideways = squared > 0 ? std::max(0.0, 1 - nominal[s] / std::sqrt(present)) : 1;
        const double across = k[s] * sideways;
        const double along = (k[s] - across) / present;
        tangents[0][s] = along * x * x + across;
        tangents[1][s] = along * y * y + across;
        tangents[2][s] = along * z * z + across;
        tangents[3][s] = along * x * y;
        tangents[4][s] = along * y * z;
        tangents[5][s] = along * z * x;
    }
    return tangents;
}

/// The sum of the connections' stiffness around each object of a block.
class BlockStiffness {
public:
    BlockStiffness(std::size_t begin, std::size_t end)
        : m_begin(begin)
        , m_size(end - begin)
        , m_sums(6 * m_size, 0.0)
    {
    }

    void add(const Tangents& tangents, std::size_t object, std::size_t n)
    {
        for (std::size_t entry = 0; entry < 6; ++entry) {
            double* sums = m_sums.data() + entry * m_size + (object - m_begin);
            for (std::size_t s = 0; s < n; ++s)
                sums[s] += tangents[entry][s];
        }
    }

    Mat3 of(std::size_t object) const
    {
        const auto entry = [&](std::size_t n) { return m_sums[n * m_size + (object - m_begin)]; };
        Mat3 sum;
        sum << entry(0), entry(3), entry(5), entry(3), entry(1), entry(4), entry(5), entry(4), entry(2);
        return sum;
    }

private:
    std::size_t m_begin;
    std::size_t m_size;
    std::vector<double> m_sums;
};

std::vector<double> bondBounds(const ConnectionData& data, const ObjectState& state, const std::vector<double>& added)
{
    std::vector<double> bounds(state.size());
    forEachBlock(state.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        BlockStiffness stiffness(begin, end);
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
            // To both ends that are in the block; connections from an earlier one are found by each of both blocks.
            const auto add = [&](std::size_t lower, std::size_t upper, std::size_t count) {
                for (std::size_t done = 0; done < count; done += mostTangents) {
                    const std::size_t n = std::min(mostTangents, count - done);
                    const Tangents tangents = tangentsOf(data, state, d, lower + done, upper + done, n);
                    if (lower >= begin)
                        stiffness.add(tangents, lower + done, n);
                    if (const std::size_t first = upper + done; first < end)
                        stiffness.add(tangents, first, std::min(n, end - first));
                }
            };
            forEachStretch<ConnectionEnd::upper>(data.aggregate->lattice, d, begin, end,
                                                 [&](std::size_t lower, std::size_t upper, std::size_t n) {
                                                     if (lower < begin)
                                                         add(lower, upper, std::min(n, begin - lower));
                                                 });
            forEachStretch(data.aggregate->lattice, d, begin, end, add);
        }
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        for (std::size_t i = begin; i < end; ++i) {
            solver.computeDirect(stiffness.of(i), Eigen::EigenvaluesOnly);
            bounds[i] = 2 * solver.eigenvalues()[2] + added[i];
        }
    });
    return bounds;
}

double iteratedFrequency(ConnectionData& data, ObjectState& state, const std::vector<double>& added)
{
    const std::size_t count = state.size();
    // Any vector has a share in all modes; the golden ratio's multiples are spread evenly. A little of it is mixed into the
    // mode found last, so that another one that has become faster since is found in time.
    const bool known = data.mode.size() == count;
    double size = 1;
    if (known) {
        for (std::size_t i = 0; i < count; ++i)
            size = std::max(size, data.mode.at(i).cwiseAbs().maxCoeff());
    } else {
        data.mode.resize(count);
    }
    constexpr double freshShare = 0.1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto spread = [&](double factor) { return std::fmod(static_cast<double>(i + 1) * factor, 1.0) - 0.5; };
        data.mode.add(i, freshShare * size * Vec3(spread(0.6180339887), spread(0.7548776662), spread(0.5698402910)));
    }
    ObjectState probe = state;
    probe.velocity.setZero();
    const double step = 1e-4 * data.aggregate->lattice.spacing;
    const auto displaced = [&](double amount) {
        for (std::size_t i = 0; i < count; ++i)
            probe.position.set(i, state.position.at(i) + amount * data.mode.at(i));
        findForces(data, probe, 0, 0);
        return probe.force;
    };
    double squared = 0;
    const int iterations = known ? 8 : 40;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        double largest = 0;
        for (std::size_t i = 0; i < count; ++i)
            largest = std::max(largest, data.mode.at(i).cwiseAbs().maxCoeff());
        if (!(largest > 0))
            break;
        for (std::size_t i = 0; i < count; ++i)
            data.mode.set(i, data.mode.at(i) / largest);
        const VectorArray ahead = displaced(step);
        const VectorArray behind = displaced(-step);
        double numerator = 0;
        double denominator = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 stiffnessTimesMode = (behind.at(i) - ahead.at(i)) / (2 * step);
            numerator += data.mode.at(i).dot(stiffnessTimesMode);
            denominator += state.mass[i] * data.mode.at(i).squaredNorm();
            data.mode.set(i, stiffnessTimesMode / state.mass[i]);
        }
        squared = std::max(squared, numerator / denominator);
    }
    double contact = 0;
    for (std::size_t i = 0; i < count; ++i)
        contact = std::max(contact, added[i] / state.mass[i]);
    constexpr double margin = 1.1; // 40 iterations come within a few percent from below
    return std::sqrt(margin * margin * squared + contact);
}

} // namespace

/// The volumetric term stiffens the fastest waves from 3 mu to lambda + 2 mu, but not what is added.
std::vector<double> stiffnessBounds(const ConnectionData& data, const ObjectState& state,
                                    const std::vector<double>& added)
{
    std::vector<double> bounds = bondBounds(data, state, std::vector<double>(added.size(), 0));
    for (ObjectIndex i = 0; i < bounds.size(); ++i) {
        const Material& material = data.materials->of(i);
        const double waves = (material.lameLambda() + 2 * material.shearModulus()) / (3 * material.shearModulus());
        bounds[i] *= std::max(1.0, waves);
    }
    if (data.rubber() != nullptr)
        stiffenByStretch(data, state, bounds);
    for (std::size_t i = 0; i < bounds.size(); ++i)
        bounds[i] += added[i];
    return bounds;
}

std::vector<std::int8_t> fastestMode(const ConnectionData& data)
{
    double largest = 0;
    for (std::size_t i = 0; i < data.mode.size(); ++i)
        largest = std::max(largest, data.mode.at(i).cwiseAbs().maxCoeff());
    std::vector<std::int8_t> mode;
    if (!(largest > 0 && std::isfinite(largest)))
        return mode;
    for (std::size_t i = 0; i < data.mode.size(); ++i)
        for (const double component : data.mode.at(i))
            mode.push_back(static_cast<std::int8_t>(std::lround(modeSteps * component / largest)));
    return mode;
}

void setFastestMode(ConnectionData& data, const std::vector<std::int8_t>& mode)
{
    data.mode.resize(mode.size() / 3);
    for (std::size_t i = 0; i < data.mode.size(); ++i)
        data.mode.set(i, Vec3(mode[3 * i], mode[3 * i + 1], mode[3 * i + 2]) / modeSteps);
}

double leastDampingTime(const ConnectionData& data)
{
    // Of compression waves, of stiffness lambda + 2 mu, only the connections' share 3 mu is damped.
    const double stiffening = data.materials->largest([](const Material& material) {
        return (material.lameLambda() + 2 * material.shearModulus()) / (3 * material.shearModulus());
    });
    return data.laws.leastDampingTime() / std::max(1.0, stiffening);
}

double largestFrequency(ConnectionData& data, ObjectState& state, const std::vector<double>& added)
{
    if (!data.tensors && data.materials->largest([](const Material& material) { return material.poissonRatio; }) > 0.25)
        return iteratedFrequency(data, state, added);
    const std::vector<double> bounds =
        data.tensors ? stiffnessBounds(data, state, added) : bondBounds(data, state, added);
    double squared = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        squared = std::max(squared, bounds[i] / state.mass[i]);
    return std::sqrt(squared);
}

} // namespace knead
