#include "core/mechanics/structural_connections.h"

#include "core/mechanics/lattice_kernels.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Connections computed at a time: their forces stay in the first-level cache until both ends have taken them.
constexpr std::size_t chunkSize = 256;

// Stiffness of a contact in units of mu V / a^2. 3 keeps a tool from sinking visibly into soft material
// (overlap / a about 0.4 p / E) and adds a quarter to the stiffness of a surface object.
constexpr double contactShare = 3;

kernels::ConstVectors from(const VectorArray& v, std::size_t i)
{
    return {&v.x[i], &v.y[i], &v.z[i]};
}
kernels::Vectors into(VectorArray& v, std::size_t i)
{
    return {&v.x[i], &v.y[i], &v.z[i]};
}

/// Calls run(object, neighbor, lower, count) for every stretch of connections of direction `d` that starts (forward) or ends
/// (backward) in [begin, end). `lower` is where the stretch's parameters are.
template <typename Run>
void forEachForward(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Run run)
{
    const auto& segments = lattice.segments[d];
    auto segment =
        std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return s.end <= begin; });
    for (; segment != segments.end() && segment->begin < end; ++segment) {
        const std::size_t first = std::max<std::size_t>(segment->begin, begin);
        const std::size_t last = std::min<std::size_t>(segment->end, end);
        run(first, first + static_cast<std::size_t>(segment->offset), first, last - first);
    }
}

template <typename Run>
void forEachBackward(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Run run)
{
    const auto& segments = lattice.segments[d];
    const auto shift = [](const auto& s, ObjectIndex i) { return i + static_cast<std::size_t>(s.offset); };
    auto segment =
        std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return shift(s, s.end) <= begin; });
    for (; segment != segments.end() && shift(*segment, segment->begin) < end; ++segment) {
        const std::size_t first = std::max(shift(*segment, segment->begin), begin);
        const std::size_t last = std::min(shift(*segment, segment->end), end);
        const std::size_t lower = first - static_cast<std::size_t>(segment->offset);
        run(first, lower, lower, last - first);
    }
}

} // namespace

StructuralConnections::StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const Material& material)
    : m_aggregate(std::move(aggregate))
    , m_count(m_aggregate->connectionCount())
{
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        m_nominalLength[d].assign(m_aggregate->size(), m_aggregate->lattice.direction(static_cast<int>(d)).norm());
    // A block also computes the connections that reach into it from lower objects, which lie up to the largest offset
    // back; four times that keeps the double work near a tenth. Small lattices have small offsets and need no small blocks.
    std::size_t largestOffset = 0;
    for (const auto& segments : m_aggregate->lattice.segments)
        for (const Lattice::Segment& segment : segments)
            largestOffset = std::max(largestOffset, static_cast<std::size_t>(segment.offset));
    m_blockSize = std::clamp<std::size_t>(4 * largestOffset, 2048, 65536);
    setMaterial(material);
}

void StructuralConnections::setMaterial(const Material& material)
{
    const double a = m_aggregate->lattice.spacing;
    m_shearModulus = material.shearModulus();
    m_volumetricModulus = material.lameLambda() - m_shearModulus;
    if (std::abs(m_volumetricModulus) < 1e-9 * m_shearModulus)
        m_volumetricModulus = 0;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::vector<double>& weight = m_aggregate->weight[d];
        m_stiffness[d].resize(weight.size());
        std::transform(weight.begin(), weight.end(), m_stiffness[d].begin(),
                       [&](double w) { return m_shearModulus * a * w; });
    }
    // b = 2 zeta sqrt(k m_red) with k = mu a w and m_red = rho a^3 w / 2 gives the same b / k for every connection.
    m_dampingTime = 2 * material.dampingRatio * std::sqrt(material.density * a * a / (2 * m_shearModulus));
    m_mode.resize(0);
    if (m_volumetricModulus != 0)
        findInverseShapes();
}

void StructuralConnections::findInverseShapes()
{
    const std::size_t count = m_aggregate->size();
    std::vector<Mat3> shape(count, Mat3::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& o = Lattice::directions[d];
        const Vec3 direction(o[0], o[1], o[2]);
        const Mat3 dyad = direction * direction.transpose();
        forEachForward(m_aggregate->lattice, d, 0, count,
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               shape[i + s] += m_stiffness[d][lower + s] * dyad;
                               shape[j + s] += m_stiffness[d][lower + s] * dyad;
                           }
                       });
    }
    for (auto& component : m_inverseShape)
        component.resize(count);
    for (auto& component : m_stress)
        component.resize(count);
    m_theta.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Mat3 inverse = shape[i].inverse();
        const double components[] = {inverse(0, 0), inverse(1, 1), inverse(2, 2),
                                     inverse(0, 1), inverse(0, 2), inverse(1, 2)};
        for (std::size_t c = 0; c < 6; ++c)
            m_inverseShape[c][i] = components[c];
    }
}

void StructuralConnections::computeStress(const ObjectState& state)
{
    const Lattice& lattice = m_aggregate->lattice;
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        std::array<VectorArray, 3> columns;
        for (VectorArray& column : columns)
            column.resize(end - begin);
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            for (std::size_t c = 0; c < 3; ++c) {
                const int component = Lattice::directions[d][c];
                if (component == 0)
                    continue;
                const auto add = [&](double sign) {
                    return [&, sign](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                        kernels::best().addShape(n, from(state.position, i), from(state.position, j),
                                                 &m_stiffness[d][lower], sign * component, into(columns[c], i - begin));
                    };
                };
                forEachForward(lattice, d, begin, end, add(1));
                forEachBackward(lattice, d, begin, end, add(-1));
            }
        }
        const double* shape[9];
        double* stress[9];
        const double* inverseShape[6];
        for (std::size_t c = 0; c < 3; ++c) {
            shape[3 * c] = columns[c].x.data();
            shape[3 * c + 1] = columns[c].y.data();
            shape[3 * c + 2] = columns[c].z.data();
        }
        for (std::size_t c = 0; c < 9; ++c)
            stress[c] = &m_stress[c][begin];
        for (std::size_t c = 0; c < 6; ++c)
            inverseShape[c] = &m_inverseShape[c][begin];
        kernels::best().volumetricStress(end - begin, {shape, inverseShape, &m_aggregate->volume[begin],
                                                       lattice.spacing, m_volumetricModulus, stress, &m_theta[begin]});
    });
}

void StructuralConnections::addForcesOfBlock(ObjectState& state, std::size_t begin, std::size_t end)
{
    const auto& segments = m_aggregate->lattice.segments;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const auto upper = [](const Lattice::Segment& s, ObjectIndex i) {
            return i + static_cast<std::size_t>(s.offset);
        };
        auto segment = std::partition_point(segments[d].begin(), segments[d].end(),
                                            [&](const auto& s) { return upper(s, s.end) <= begin; });
        for (; segment != segments[d].end() && segment->begin < end; ++segment) {
            // Connections with an end in the block: the lower end from `offset` before it on, to its end.
            const auto offset = static_cast<std::size_t>(segment->offset);
            const std::size_t first = std::max<std::size_t>(segment->begin, begin > offset ? begin - offset : 0);
            const std::size_t last = std::min<std::size_t>(segment->end, end);
            for (std::size_t chunk = first; chunk < last; chunk += chunkSize)
                addForcesOfChunk(state, d, {chunk, std::min(chunk + chunkSize, last), offset}, begin, end);
        }
    }
}

void StructuralConnections::addForcesOfChunk(ObjectState& state, std::size_t d, const Chunk& chunk, std::size_t begin,
                                             std::size_t end) const
{
    const std::size_t lower = chunk.first;
    const std::size_t upper = chunk.first + chunk.offset;
    const std::size_t count = chunk.last - chunk.first;
    if (chunk.last <= begin && upper >= end) // an offset longer than the block: both ends miss it
        return;
    double buffer[6][chunkSize];
    const kernels::Vectors pull{buffer[0], buffer[1], buffer[2]};
    const kernels::Vectors brake{buffer[3], buffer[4], buffer[5]};
    const kernels::Kernels& kernel = kernels::best();
    kernel.connectionForces(count, {from(state.position, lower), from(state.velocity, lower)},
                            {from(state.position, upper), from(state.velocity, upper)}, &m_stiffness[d][lower],
                            &m_nominalLength[d][lower], m_dampingTime, pull, brake);
    if (m_volumetricModulus != 0) {
        const auto column = [&](std::size_t c, std::size_t i) {
            return kernels::ConstVectors{&m_stress[3 * c][i], &m_stress[3 * c + 1][i], &m_stress[3 * c + 2][i]};
        };
        for (std::size_t c = 0; c < 3; ++c)
            if (const int component = Lattice::directions[d][c]; component != 0)
                kernel.addVolumetricForces(count, column(c, lower), column(c, upper), &m_stiffness[d][lower], component,
                                           pull);
    }
    const auto take = [&](double sign, std::size_t end0) { // what of the ends that begin at end0 lies in the block
        const std::size_t from0 = std::max(end0, begin);
        const std::size_t to = std::min(end0 + count, end);
        if (from0 >= to)
            return;
        const std::size_t skip = from0 - end0;
        kernel.addScaled(to - from0, sign, {pull.x + skip, pull.y + skip, pull.z + skip}, into(state.force, from0));
        kernel.addScaled(to - from0, sign, {brake.x + skip, brake.y + skip, brake.z + skip},
                         into(state.damping, from0));
    };
    take(1, lower);
    take(-1, upper);
}

void StructuralConnections::computeForces(ObjectState& state)
{
    if (m_volumetricModulus != 0)
        computeStress(state);
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        for (VectorArray* array : {&state.force, &state.damping})
            for (std::vector<double>* component : {&array->x, &array->y, &array->z})
                std::fill_n(component->data() + begin, end - begin, 0.0);
        addForcesOfBlock(state, begin, end);
    });
}

double StructuralConnections::energy(const ObjectState& state)
{
    double sum = 0;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               const double length = (state.position.at(j + s) - state.position.at(i + s)).norm();
                               const double stretch = length - m_nominalLength[d][lower + s];
                               sum += 0.5 * m_stiffness[d][lower + s] * stretch * stretch;
                           }
                       });
    if (m_volumetricModulus == 0)
        return sum;
    computeStress(state);
    for (std::size_t i = 0; i < state.size(); ++i)
        sum += 0.5 * m_volumetricModulus * m_aggregate->volume[i] * m_theta[i] * m_theta[i];
    return sum;
}

double StructuralConnections::contactStiffness(ObjectIndex object) const
{
    const double a = m_aggregate->lattice.spacing;
    return contactShare * m_shearModulus * m_aggregate->volume[object] / (a * a);
}

double StructuralConnections::bondBound(const ObjectState& state) const
{
    std::vector<Mat3> stiffness(state.size(), Mat3::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Vec3 n = m_aggregate->lattice.direction(static_cast<int>(d)).normalized();
        const Mat3 dyad = n * n.transpose();
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t count) {
                           for (std::size_t s = 0; s < count; ++s) {
                               stiffness[i + s] += m_stiffness[d][lower + s] * dyad;
                               stiffness[j + s] += m_stiffness[d][lower + s] * dyad;
                           }
                       });
    }
    double largest = 0;
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    for (std::size_t i = 0; i < state.size(); ++i) {
        solver.computeDirect(stiffness[i], Eigen::EigenvaluesOnly);
        const double bound = 2 * solver.eigenvalues()[2] + contactStiffness(static_cast<ObjectIndex>(i));
        largest = std::max(largest, bound / state.mass[i]);
    }
    return std::sqrt(largest);
}

double StructuralConnections::iteratedFrequency(ObjectState& state)
{
    const std::size_t count = state.size();
    const bool known = m_mode.size() == count;
    if (!known) { // any vector with a share in all modes; the golden ratio's multiples are spread evenly
        m_mode.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto spread = [&](double factor) {
                return std::fmod(static_cast<double>(i + 1) * factor, 1.0) - 0.5;
            };
            m_mode.set(i, {spread(0.6180339887), spread(0.7548776662), spread(0.5698402910)});
        }
    }
    ObjectState probe = state;
    std::fill(probe.velocity.x.begin(), probe.velocity.x.end(), 0.0);
    std::fill(probe.velocity.y.begin(), probe.velocity.y.end(), 0.0);
    std::fill(probe.velocity.z.begin(), probe.velocity.z.end(), 0.0);
    const double step = 1e-4 * m_aggregate->lattice.spacing;
    const auto displaced = [&](double amount) {
        for (std::size_t i = 0; i < count; ++i)
            probe.position.set(i, state.position.at(i) + amount * m_mode.at(i));
        computeForces(probe);
        return probe.force;
    };
    double squared = 0;
    const int iterations = known ? 6 : 40;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        double largest = 0;
        for (std::size_t i = 0; i < count; ++i)
            largest = std::max(largest, m_mode.at(i).cwiseAbs().maxCoeff());
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
        contact = std::max(contact, contactStiffness(static_cast<ObjectIndex>(i)) / state.mass[i]);
    constexpr double margin = 1.1; // 40 iterations come within a few percent from below
    return std::sqrt(margin * margin * squared + contact);
}

double StructuralConnections::largestFrequency(ObjectState& state)
{
    return m_volumetricModulus > 0 ? iteratedFrequency(state) : bondBound(state);
}

} // namespace knead
