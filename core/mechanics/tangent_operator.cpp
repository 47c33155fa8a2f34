#include "core/mechanics/tangent_operator.h"

#include "core/mechanics/kernel_views.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/tangent_kernels.h"
#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

// Connections worked on at a time: what they give stays in the first-level cache until both ends have taken it.
constexpr std::size_t chunkSize = 256;

kernels::ConstVectors from(const kernels::ConstVectors& v, std::size_t i)
{
    return {v.x + i, v.y + i, v.z + i};
}
kernels::Vectors into(const kernels::Vectors& v, std::size_t i)
{
    return {v.x + i, v.y + i, v.z + i};
}

using kernels::from;
using kernels::into;

bool isAxis(const Lattice::Node& step, std::size_t axis)
{
    return step[axis] == 1 && step[(axis + 1) % 3] == 0 && step[(axis + 2) % 3] == 0;
}

/// The part of `count` objects from `first` on that lies in [begin, end); `skip` of them come before it.
struct Part {
    std::size_t first;
    std::size_t skip;
    std::size_t count;
};
Part partWithin(std::size_t first, std::size_t count, std::size_t begin, std::size_t end)
{
    const std::size_t low = std::max(first, begin);
    const std::size_t high = std::min(first + count, end);
    return {low, low - first, low < high ? high - low : 0};
}

} // namespace

TangentOperator::TangentOperator(const StructuralConnections& connections)
    : m_connections(&connections)
{
}

void TangentOperator::update(const VectorArray& position, double step)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        m_root[d].resize(m_connections->stiffness()[d].size());
        m_across[d].resize(m_connections->stiffness()[d].size());
    }
    forEachBlock(position.size(), m_connections->blockSize(), [&](std::size_t begin, std::size_t end) {
        double length[chunkSize];
        double time[chunkSize];
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachForward(lattice, d, begin, end, [&](std::size_t i, std::size_t j, std::size_t, std::size_t n) {
                for (std::size_t s = 0; s < n; s += chunkSize) {
                    const std::size_t count = std::min(chunkSize, n - s);
                    const std::size_t lower = i + s;
                    m_connections->laws().fill(&ConnectionLaw::dampingTime, lower, j + s, count, time);
                    kernels::bestTangents().connectionTangent(count, from(position, lower), from(position, j + s),
                                                              &m_connections->stiffness()[d][lower],
                                                              m_connections->nominalLengths(d, lower, count, length),
                                                              time, step, into(m_root[d], lower), &m_across[d][lower]);
                }
            });
    });
    const LaneVector<double>& bulk = m_connections->bulk();
    m_hasBulk =
        m_connections->hasBulk() && std::any_of(bulk.begin(), bulk.end(), [](double value) { return value > 0; });
    if (m_hasBulk)
        findGradients(position, step);
}

void TangentOperator::findGradients(const VectorArray& position, double step)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    for (auto& component : m_gradient)
        component.resize(position.size());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& node = Lattice::directions[d];
        const bool isDiagonal = !isAxis(node, 0) && !isAxis(node, 1) && !isAxis(node, 2);
        if (isDiagonal && !lattice.segments[d].empty())
            m_diagonal[d].resize(position.size());
    }
    m_weight.resize(position.size());
    m_pressure.resize(position.size());
    forEachBlock(position.size(), m_connections->blockSize(), [&](std::size_t begin, std::size_t end) {
        std::array<VectorArray, 3> columns;
        for (VectorArray& column : columns)
            column.resize(end - begin);
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            for (std::size_t c = 0; c < 3; ++c) {
                const int component = Lattice::directions[d][c];
                if (component == 0)
                    continue;
                const auto add = [&](double sign) {
                    return [&, sign](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                        kernels::bestTangents().addShape(n, from(position, i), from(position, j),
                                                         &m_connections->stiffness()[d][lower], sign * component,
                                                         into(columns[c], i - begin));
                    };
                };
                forEachForward(lattice, d, begin, end, add(1));
                forEachBackward(lattice, d, begin, end, add(-1));
            }
        const double* shape[9];
        double* gradient[9];
        const double* inverseShape[6];
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                shape[3 * c + axis] = columns[c].component(axis);
        }
        for (std::size_t c = 0; c < 9; ++c)
            gradient[c] = &m_gradient[c][begin];
        for (std::size_t c = 0; c < 6; ++c)
            inverseShape[c] = &m_connections->inverseShape()[c][begin];
        kernels::bestTangents().dilatationGradient(end - begin, {shape, inverseShape, &m_connections->bulk()[begin],
                                                                 lattice.spacing, step, gradient, &m_weight[begin]});
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            if (m_diagonal[d].size() == 0)
                continue;
            const Lattice::Node& node = Lattice::directions[d];
            const double steps[3] = {static_cast<double>(node[0]), static_cast<double>(node[1]),
                                     static_cast<double>(node[2])};
            kernels::bestTangents().combineColumns(end - begin, gradient, steps, into(m_diagonal[d], begin));
        }
    });
}

/// Gradients of the dilatation of the objects from `first` on towards direction `d`, per stiffness.
kernels::ConstVectors TangentOperator::gradientsTowards(std::size_t d, std::size_t first) const
{
    const Lattice::Node& step = Lattice::directions[d];
    for (std::size_t c = 0; c < 3; ++c)
        if (isAxis(step, c))
            return {&m_gradient[3 * c][first], &m_gradient[3 * c + 1][first], &m_gradient[3 * c + 2][first]};
    return from(m_diagonal[d], first);
}

void TangentOperator::findPressures(const kernels::ConstVectors& u)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    forEachBlock(m_pressure.size(), m_connections->blockSize(), [&](std::size_t begin, std::size_t end) {
        std::fill_n(&m_pressure[begin], end - begin, 0.0);
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachTouching(lattice, d, begin, end, chunkSize,
                            [&](std::size_t lower, std::size_t upper, std::size_t count) {
                                for (const std::size_t first : {lower, upper}) {
                                    const Part part = partWithin(first, count, begin, end);
                                    if (part.count == 0)
                                        continue;
                                    kernels::bestTangents().addDilatationRate(
                                        part.count, from(u, lower + part.skip), from(u, upper + part.skip),
                                        &m_connections->stiffness()[d][lower + part.skip],
                                        gradientsTowards(d, part.first), &m_pressure[part.first]);
                                }
                            });
        for (std::size_t i = begin; i < end; ++i)
            m_pressure[i] *= m_weight[i];
    });
}

void TangentOperator::addProduct(const kernels::ConstVectors& u, const kernels::Vectors& product)
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    const kernels::TangentKernels& kernel = kernels::bestTangents();
    if (m_hasBulk)
        findPressures(u);
    forEachBlock(lattice.size(), m_connections->blockSize(), [&](std::size_t begin, std::size_t end) {
        double buffer[3 * chunkSize];
        const kernels::Vectors pull{buffer, buffer + chunkSize, buffer + 2 * chunkSize};
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachTouching(
                lattice, d, begin, end, chunkSize, [&](std::size_t lower, std::size_t upper, std::size_t count) {
                    kernel.connectionPull(count, from(u, lower), from(u, upper), roots(d, lower), &m_across[d][lower],
                                          pull);
                    if (m_hasBulk)
                        kernel.addPressurePull(count, &m_connections->stiffness()[d][lower],
                                               {&m_pressure[lower], &m_pressure[upper]},
                                               {gradientsTowards(d, lower), gradientsTowards(d, upper)}, pull);
                    const auto take = [&](double sign, std::size_t first) {
                        const Part part = partWithin(first, count, begin, end);
                        if (part.count > 0)
                            kernel.addScaled(part.count, sign,
                                             {pull.x + part.skip, pull.y + part.skip, pull.z + part.skip},
                                             into(product, part.first));
                    };
                    take(-1, lower);
                    take(1, upper);
                });
    });
}

void TangentOperator::addBlocks(const std::array<double*, 6>& blocks) const
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    forEachBlock(lattice.size(), m_connections->blockSize(), [&](std::size_t begin, std::size_t end) {
        VectorArray own; // the gradient of an object's dilatation with its own place
        if (m_hasBulk)
            own.resize(end - begin);
        const auto add = [&](std::size_t i, const Vec3& gradient, double weight) {
            *(blocks[0] + i) += weight * gradient.x() * gradient.x();
            *(blocks[1] + i) += weight * gradient.y() * gradient.y();
            *(blocks[2] + i) += weight * gradient.z() * gradient.z();
            *(blocks[3] + i) += weight * gradient.x() * gradient.y();
            *(blocks[4] + i) += weight * gradient.x() * gradient.z();
            *(blocks[5] + i) += weight * gradient.y() * gradient.z();
        };
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachTouching(
                lattice, d, begin, end, chunkSize, [&](std::size_t lower, std::size_t upper, std::size_t count) {
                    for (const std::size_t first : {lower, upper}) {
                        const Part part = partWithin(first, count, begin, end);
                        if (part.count == 0)
                            continue;
                        double* target[6];
                        for (std::size_t c = 0; c < 6; ++c)
                            target[c] = blocks[c] + part.first;
                        kernels::bestTangents().addConnectionBlocks(part.count, roots(d, lower + part.skip),
                                                                    &m_across[d][lower + part.skip], target);
                    }
                    if (!m_hasBulk)
                        return;
                    const double* stiffness = &m_connections->stiffness()[d][lower];
                    const auto below = gradientsTowards(d, lower);
                    const auto above = gradientsTowards(d, upper);
                    for (std::size_t s = 0; s < count; ++s) {
                        const Vec3 low = stiffness[s] * Vec3(below.x[s], below.y[s], below.z[s]);
                        const Vec3 high = stiffness[s] * Vec3(above.x[s], above.y[s], above.z[s]);
                        if (lower + s >= begin && lower + s < end) {
                            own.add(lower + s - begin, -low);
                            add(lower + s, high, m_weight[upper + s]);
                        }
                        if (upper + s >= begin && upper + s < end) {
                            own.add(upper + s - begin, high);
                            add(upper + s, low, m_weight[lower + s]);
                        }
                    }
                });
        if (m_hasBulk)
            for (std::size_t i = begin; i < end; ++i)
                add(i, own.at(i - begin), m_weight[i]);
    });
}

std::vector<TangentOperator::Slope> TangentOperator::slopesOf(ObjectIndex object) const
{
    std::vector<Slope> slopes;
    if (!m_hasBulk || m_weight[object] == 0)
        return slopes;
    Mat3 columns;
    for (int c = 0; c < 9; ++c)
        columns(c % 3, c / 3) = m_gradient[static_cast<std::size_t>(c)][object];
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
    return slopes;
}

} // namespace knead
