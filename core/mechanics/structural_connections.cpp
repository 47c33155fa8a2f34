#include "core/mechanics/structural_connections.h"

#include "core/mechanics/lattice_kernels.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_friction.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Connections computed at a time: their forces stay in the first-level cache until both ends have taken them.
constexpr std::size_t chunkSize = 256;

// Stiffness of a contact in units of mu V / a^2. 6 keeps a tool from sinking visibly into soft material
// (overlap / a about 0.4 p / E) and adds a half to the stiffness of a surface object, a tenth to the number of steps.
constexpr double contactShare = 6;

// Surroundings whose connections lie this near to a plane say nothing about volume.
constexpr double flattestShape = 0.01;

kernels::ConstVectors from(const VectorArray& v, std::size_t i)
{
    return {&v.x[i], &v.y[i], &v.z[i]};
}
kernels::Vectors into(VectorArray& v, std::size_t i)
{
    return {&v.x[i], &v.y[i], &v.z[i]};
}

Vec3 latticeVector(std::size_t d)
{
    const Lattice::Node& o = Lattice::directions[d];
    return {static_cast<double>(o[0]), static_cast<double>(o[1]), static_cast<double>(o[2])};
}

} // namespace

StructuralConnections::StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const MaterialMap& materials)
    : m_aggregate(std::move(aggregate))
    , m_materials(&materials)
    , m_laws(materials, m_aggregate->lattice.spacing)
{
    // A block also computes the connections that reach into it from lower objects, which lie up to the largest offset
    // back; four times that keeps the double work near a tenth. Small lattices have small offsets and need no small blocks.
    std::size_t largestOffset = 0;
    for (const auto& segments : m_aggregate->lattice.segments)
        for (const Lattice::Segment& segment : segments)
            largestOffset = std::max(largestOffset, static_cast<std::size_t>(segment.offset));
    m_blockSize = std::clamp<std::size_t>(4 * largestOffset, 2048, 65536);
    m_changes.restDilatation.assign(m_aggregate->size(), 0);
    updateMaterials();
}

void StructuralConnections::updateMaterials()
{
    m_laws = ConnectionLaws(*m_materials, m_aggregate->lattice.spacing);
    findStiffness();
    m_mode.resize(0);
    if (m_laws.anyYields())
        makeLengthsOwn();
    findInverseShapes();
}

void StructuralConnections::restore(Changes changes)
{
    m_changes = std::move(changes);
    if (m_changes.restDilatation.empty())
        m_changes.restDilatation.assign(m_aggregate->size(), 0);
    updateMaterials();
}

void StructuralConnections::findStiffness()
{
    const double a = m_aggregate->lattice.spacing;
    const std::size_t objects = m_aggregate->size();
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::vector<double>& weight = m_aggregate->weight[d];
        std::vector<double>& stiffness = m_stiffness[d];
        stiffness.assign(weight.size(), 0);
        forEachForward(m_aggregate->lattice, d, 0, objects,
                       [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                           m_laws.fill(&ConnectionLaw::stiffness, i, j, n, &stiffness[i]);
                           for (std::size_t s = i; s < i + n; ++s)
                               stiffness[s] *= a * weight[s];
                       });
    }
    for (const ConnectionId& broken : m_changes.broken)
        m_stiffness[broken.direction][broken.lower] = 0;
    m_count = m_aggregate->connectionCount() - m_changes.broken.size();
}

void StructuralConnections::makeLengthsOwn()
{
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::size_t size = m_stiffness[d].size();
        if (m_changes.nominalLength[d].size() != size)
            m_changes.nominalLength[d].assign(size, m_aggregate->lattice.direction(static_cast<int>(d)).norm());
        if (m_changes.plasticStrain[d].size() != size)
            m_changes.plasticStrain[d].assign(size, 0);
    }
}

const double* StructuralConnections::nominalLengths(std::size_t d, std::size_t lower, std::size_t count,
                                                    double* buffer) const
{
    if (!m_changes.nominalLength[d].empty())
        return &m_changes.nominalLength[d][lower];
    std::fill_n(buffer, count, m_aggregate->lattice.direction(static_cast<int>(d)).norm());
    return buffer;
}

double StructuralConnections::nominalLength(const ConnectionId& connection) const
{
    double rest = 0;
    return *nominalLengths(connection.direction, connection.lower, 1, &rest);
}

void StructuralConnections::findInverseShapes()
{
    const std::size_t count = m_aggregate->size();
    const auto bulkModulus = [](const Material& material) {
        const double modulus = material.lameLambda() - material.shearModulus();
        return std::abs(modulus) < 1e-9 * material.shearModulus() ? 0 : modulus;
    };
    m_hasBulk = m_materials->largest([&](const Material& m) { return std::abs(bulkModulus(m)); }) > 0;
    for (auto& component : m_inverseShape)
        component.resize(count);
    for (auto& component : m_stress)
        component.assign(count, 0);
    m_bulk.resize(count);
    m_flat.clear();
    m_theta.assign(count, 0);
    m_thetaIsPresent = false;
    std::vector<Mat3> shape(count, Mat3::Zero());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Mat3 dyad = latticeVector(d) * latticeVector(d).transpose();
        forEachForward(m_aggregate->lattice, d, 0, count,
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               shape[i + s] += m_stiffness[d][lower + s] * dyad;
                               shape[j + s] += m_stiffness[d][lower + s] * dyad;
                           }
                       });
    }
    for (ObjectIndex i = 0; i < count; ++i) {
        m_bulk[i] = bulkModulus(m_materials->of(i)) * m_aggregate->volume[i];
        setInverseShape(i, shape[i]);
    }
    m_brokenAround.clear();
    for (const ConnectionId& broken : m_changes.broken)
        markBroken(broken);
}

std::array<ObjectIndex, 2> StructuralConnections::endsOf(const ConnectionId& connection) const
{
    const auto& segments = m_aggregate->lattice.segments[connection.direction];
    const auto segment = std::partition_point(segments.begin(), segments.end(),
                                              [&](const auto& s) { return s.end <= connection.lower; });
    return {connection.lower, connection.lower + static_cast<ObjectIndex>(segment->offset)};
}

void StructuralConnections::setInverseShape(ObjectIndex object, const Mat3& shape)
{
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(shape, Eigen::EigenvaluesOnly);
    Mat3 inverse = Mat3::Zero();
    if (solver.eigenvalues()[0] > flattestShape * solver.eigenvalues()[2])
        inverse = shape.inverse();
    else {
        m_bulk[object] = 0;
        m_flat.push_back(object);
    }
    const double components[] = {inverse(0, 0), inverse(1, 1), inverse(2, 2),
                                 inverse(0, 1), inverse(0, 2), inverse(1, 2)};
    for (std::size_t c = 0; c < 6; ++c)
        m_inverseShape[c][object] = components[c];
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
        kernels::best().volumetricStress(end - begin,
                                         {shape, inverseShape, &m_bulk[begin], &m_changes.restDilatation[begin],
                                          lattice.spacing, stress, &m_theta[begin]});
    });
    for (const ObjectIndex object : m_flat)
        m_theta[object] = 0;
    m_thetaIsPresent = true;
}

void StructuralConnections::addForcesOfBlock(ObjectState& state, std::size_t begin, std::size_t end, double dt)
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
                addForcesOfChunk(state, d, {chunk, std::min(chunk + chunkSize, last), offset}, begin, end, dt);
        }
    }
}

void StructuralConnections::addForcesOfChunk(ObjectState& state, std::size_t d, const Chunk& chunk, std::size_t begin,
                                             std::size_t end, double dt) const
{
    const std::size_t lower = chunk.first;
    const std::size_t upper = chunk.first + chunk.offset;
    const std::size_t count = chunk.last - chunk.first;
    if (chunk.last <= begin && upper >= end) // an offset longer than the block: both ends miss it
        return;
    double buffer[8][chunkSize];
    const kernels::Vectors pull{buffer[0], buffer[1], buffer[2]};
    const kernels::Vectors brake{buffer[3], buffer[4], buffer[5]};
    const kernels::Kernels& kernel = kernels::best();
    const kernels::End self{from(state.position, lower), from(state.velocity, lower)};
    const kernels::End neighbor{from(state.position, upper), from(state.velocity, upper)};
    m_laws.fill(&ConnectionLaw::dampingTime, lower, upper, count, buffer[6]);
    kernel.connectionForces(count, self, neighbor, &m_stiffness[d][lower], nominalLengths(d, lower, count, buffer[7]),
                            buffer[6], pull, brake);
    if (m_structuralFriction > 0)
        addStructuralFriction(count, self, neighbor, {&state.mass[lower], &state.mass[upper]}, m_structuralFriction, dt,
                              pull, brake);
    if (m_hasBulk) {
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

void StructuralConnections::computeForces(ObjectState& state, double dt)
{
    if (needsStress())
        computeStress(state);
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        for (VectorArray* array : {&state.force, &state.damping})
            for (std::vector<double>* component : {&array->x, &array->y, &array->z})
                std::fill_n(component->data() + begin, end - begin, 0.0);
        addForcesOfBlock(state, begin, end, dt);
    });
}

double StructuralConnections::energy(const ObjectState& state)
{
    double sum = 0;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               const double length = (state.position.at(j + s) - state.position.at(i + s)).norm();
                               const double stretch = length - nominalLength({d, static_cast<ObjectIndex>(lower + s)});
                               sum += 0.5 * m_stiffness[d][lower + s] * stretch * stretch;
                           }
                       });
    if (!m_hasBulk)
        return sum;
    // Looking must not change what happens next: flow goes by the dilatation of the last forces.
    const std::vector<double> theta = m_theta;
    const bool isPresent = m_thetaIsPresent;
    computeStress(state);
    for (std::size_t i = 0; i < state.size(); ++i)
        sum += volumetricEnergy(i);
    m_theta = theta;
    m_thetaIsPresent = isPresent;
    return sum;
}

double StructuralConnections::volumetricEnergy(std::size_t object) const
{
    const double strain = kernels::volumetricStrain(m_bulk[object], m_theta[object], m_changes.restDilatation[object]);
    return 0.5 * m_bulk[object] * strain * strain;
}

std::size_t StructuralConnections::countInverted(const ObjectState& state)
{
    computeStress(state);
    std::size_t inverted = 0;
    for (ObjectIndex i = 0; i < state.size(); ++i) {
        if (m_theta[i] + m_changes.restDilatation[i] > kernels::flatDilatation)
            continue;
        std::size_t neighbors = 0;
        forEachConnection(i, [&](ObjectIndex, const ConnectionId&) { ++neighbors; });
        if (neighbors >= 2 * Lattice::isotropicCount)
            ++inverted;
    }
    return inverted;
}

double StructuralConnections::contactStiffness(ObjectIndex object) const
{
    const double a = m_aggregate->lattice.spacing;
    return contactShare * m_materials->of(object).shearModulus() * m_aggregate->volume[object] / (a * a);
}

} // namespace knead
