#include "core/mechanics/tangent_operator.h"

#include "core/mechanics/kernel_views.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <numeric>

namespace knead {

namespace {

// Connections worked on at a time: what they are made of stays in the first-level cache.
constexpr std::size_t chunkSize = 256;

// Blocks of slots, and runs of objects, that a thread takes at a time.
constexpr std::size_t slotBlocks = 64;
constexpr std::size_t runsAtATime = 32;

using kernels::from;
using kernels::into;

/// Arrays begin on cache lines, and not all at the same place of a page.
std::size_t strideFor(std::size_t slots)
{
    constexpr std::size_t line = 16;
    constexpr std::size_t linesPerPage = 64;
    constexpr std::size_t apart = 5;
    const std::size_t lines = (slots + line - 1) / line + 1;
    return line * (lines + (apart + linesPerPage - lines % linesPerPage) % linesPerPage);
}

} // namespace

TangentOperator::TangentOperator(const StructuralConnections& connections, const LaneVector<double>& mass)
    : m_connections(&connections)
    , m_mass(&mass)
    , m_places(connections.aggregate().lattice)
    , m_directions(Lattice::isotropicCount)
    , m_stride(strideFor(m_places.size()))
{
    const Lattice& lattice = connections.aggregate().lattice;
    for (std::size_t d = Lattice::isotropicCount; d < Lattice::directionCount; ++d)
        if (!lattice.segments[d].empty())
            m_directions = Lattice::directionCount;
    m_massArray = 5 * m_directions;
    m_gradient = m_massArray + 1;
    m_pressure = m_gradient + 9;
    m_values.resize((connections.hasBulk() ? m_pressure + 9 : m_gradient) * m_stride);
}

void TangentOperator::update(const VectorArray& position, double step)
{
    const LaneVector<double>& bulk = m_connections->bulk();
    m_hasBulk =
        m_connections->hasBulk() && std::any_of(bulk.begin(), bulk.end(), [](double value) { return value > 0; });
    if (m_hasBulk)
        m_values.resize((m_pressure + 9) * m_stride);
    findConnections(position, step);
    if (m_hasBulk)
        findGradients(position, step);
}

void TangentOperator::findConnections(const VectorArray& position, double step)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    forEachBlock(m_places.runs().size(), runsAtATime, [&](std::size_t begin, std::size_t end) {
        double length[chunkSize];
        double time[chunkSize];
        for (std::size_t r = begin; r < end; ++r) {
            const RunSlots::Run& run = m_places.runs()[r];
            const std::size_t slot = m_places.of(run.begin);
            for (std::size_t i = run.begin; i < run.end; ++i)
                array(m_massArray)[slot + i - run.begin] = static_cast<float>((*m_mass)[i]);
            for (std::size_t d = 0; d < m_directions; ++d) {
                if (d >= Lattice::isotropicCount && lattice.segments[d].empty())
                    continue;
                forEachStretch(lattice, d, run.begin, run.end, [&](std::size_t i, std::size_t j, std::size_t n) {
                    for (std::size_t s = 0; s < n; s += chunkSize) {
                        const std::size_t count = std::min(chunkSize, n - s);
                        const std::size_t lower = i + s;
                        const std::size_t at = slot + lower - run.begin;
                        const double* stiffness = &m_connections->stiffness()[d][lower];
                        m_connections->laws().fill(&ConnectionLaw::dampingTime, lower, j + s, count, time);
                        kernels::best().connectionTangent(
                            count, from(position, lower), from(position, j + s), stiffness,
                            m_connections->nominalLengths(d, lower, count, length), time, step,
                            {array(rootOf(d)) + at, array(rootOf(d) + 1) + at, array(rootOf(d) + 2) + at},
                            array(acrossOf(d)) + at);
                        for (std::size_t c = 0; m_hasBulk && c < count; ++c)
                            array(stiffnessOf(d))[at + c] = static_cast<float>(stiffness[c]);
                    }
                });
            }
        }
    });
}

void TangentOperator::findGradients(const VectorArray& position, double step)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    forEachBlock(m_places.runs().size(), runsAtATime, [&](std::size_t firstRun, std::size_t lastRun) {
        const std::size_t begin = m_places.runs()[firstRun].begin;
        const std::size_t end = m_places.runs()[lastRun - 1].end;
        std::array<VectorArray, 3> columns;
        for (VectorArray& column : columns)
            column.resize(end - begin);
        for (std::size_t d = 0; d < m_directions; ++d)
            for (std::size_t c = 0; c < 3; ++c) {
                const int component = Lattice::directions[d][c];
                if (component == 0)
                    continue;
                const auto addTo = [&](std::size_t object, std::size_t lower, std::size_t upper, std::size_t n) {
                    kernels::best().addShape(n, from(position, lower), from(position, upper),
                                             &m_connections->stiffness()[d][lower], component,
                                             into(columns[c], object - begin));
                };
                forEachStretch(lattice, d, begin, end, [&](std::size_t lower, std::size_t upper, std::size_t n) {
                    addTo(lower, lower, upper, n);
                });
                forEachStretch<ConnectionEnd::upper>(
                    lattice, d, begin, end,
                    [&](std::size_t lower, std::size_t upper, std::size_t n) { addTo(upper, lower, upper, n); });
            }
        for (std::size_t r = firstRun; r < lastRun; ++r) {
            const RunSlots::Run& run = m_places.runs()[r];
            const double* shape[9];
            float* gradient[9];
            const double* inverseShape[6];
            for (std::size_t c = 0; c < 9; ++c) {
                shape[c] = columns[c / 3].component(c % 3) + (run.begin - begin);
                gradient[c] = array(m_gradient + c) + m_places.of(run.begin);
            }
            for (std::size_t c = 0; c < 6; ++c)
                inverseShape[c] = &m_connections->inverseShape()[c][run.begin];
            kernels::best().dilatationGradient(
                run.end - run.begin,
                {shape, inverseShape, &m_connections->bulk()[run.begin], lattice.spacing, step, gradient});
        }
    });
}

kernels::SlotTangent TangentOperator::view(std::size_t vectorStride) const
{
    kernels::SlotTangent tangent{};
    tangent.stride = static_cast<std::ptrdiff_t>(m_stride);
    tangent.vectorStride = static_cast<std::ptrdiff_t>(vectorStride);
    for (std::size_t d = 0; d < m_directions; ++d) {
        tangent.root[d] = array(rootOf(d));
        tangent.across[d] = array(acrossOf(d));
        tangent.stiffness[d] = array(stiffnessOf(d));
    }
    tangent.mass = array(m_massArray);
    if (m_hasBulk)
        tangent.gradient = array(m_gradient);
    return tangent;
}

double TangentOperator::multiply(const float* u, float* product, std::size_t stride)
{
    kernels::SlotTangent tangent = view(stride);
    if (m_hasBulk)
        tangent.pressure = array(m_pressure);
    const std::vector<SlotBlock>& blocks = m_places.blocks();
    if (m_hasBulk)
        forEachBlock(blocks.size(), slotBlocks, [&](std::size_t begin, std::size_t end) {
            kernels::best().slotPressures(end - begin, &blocks[begin], tangent, u);
        });
    std::vector<double> energies((blocks.size() + slotBlocks - 1) / slotBlocks);
    forEachBlock(blocks.size(), slotBlocks, [&](std::size_t begin, std::size_t end) {
        energies[begin / slotBlocks] = kernels::best().slotProduct(end - begin, &blocks[begin], tangent, u, product);
    });
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

void TangentOperator::findDiagonal(const std::array<double*, 6>& diagonal) const
{
    const kernels::SlotTangent tangent = view(m_stride);
    const std::vector<SlotBlock>& blocks = m_places.blocks();
    forEachBlock(blocks.size(), slotBlocks, [&](std::size_t begin, std::size_t end) {
        kernels::best().slotDiagonal(end - begin, &blocks[begin], tangent, diagonal.data());
    });
}

void TangentOperator::slopesOf(ObjectIndex object, std::vector<Slope>& slopes) const
{
    slopes.clear();
    if (!m_hasBulk)
        return;
    Mat3 columns;
    for (int c = 0; c < 9; ++c)
        columns(c % 3, c / 3) =
            static_cast<double>(array(m_gradient + static_cast<std::size_t>(c))[m_places.of(object)]);
    if (columns.isZero(0))
        return;
    Slope own{object, Vec3::Zero()};
    m_connections->forEachConnection(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        const Lattice::Node& step = Lattice::directions[connection.direction];
        const double towards = connection.lower == object ? 1 : -1;
        const double stiffness = m_connections->stiffness()[connection.direction][connection.lower];
        const Vec3 gradient = towards * stiffness * (columns * Vec3(step[0], step[1], step[2]));
        slopes.push_back({neighbor, gradient});
        own.gradient -= gradient;
    });
    slopes.push_back(own);
}

} // namespace knead
