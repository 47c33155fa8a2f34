#include "core/integration/minimal_residuals.h"

#include "core/integration/solver_settings.h"
#include "core/kernels/kernels.h"
#include "core/task/block_sums.h"

#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t slotsAtATime = 2048;
constexpr std::size_t mostKept = solverSettings.linear.mostKept;

// What is new of a vector below this share, squared, is rounding of single precision: the basis ends there.
constexpr double leastNew = 1e-6;

using Sums = std::array<double, mostKept>;

/// v . y for the first `count` vectors of a basis.
Sums dotProducts(const std::vector<FloatArray>& basis, std::size_t count, const FloatArray& y)
{
    const auto ofBlocks = ofEachBlock<Sums>(y.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
        Sums sums{};
        for (std::size_t v = 0; v < count; ++v)
            for (std::size_t c = 0; c < 3; ++c)
                sums[v] += kernels::best().floatDot(end - begin, basis[v].component(c) + begin, y.component(c) + begin);
        return sums;
    });
    Sums all{};
    for (const Sums& sums : ofBlocks)
        for (std::size_t v = 0; v < count; ++v)
            all[v] += sums[v];
    return all;
}

/// Calls change(component, begin, end) for parts of a vector of the system.
template <typename Change>
void forEachPart(const FloatArray& vector, Change&& change)
{
    forEachBlock(vector.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = 0; c < 3; ++c)
            change(c, begin, end);
    });
}

} // namespace

/// The next column of h, and the next vector of the basis unless nothing is left of it.
void MinimalResiduals::extend(ImplicitSystem& system, RigidModePreconditioner& preconditioner)
{
    const std::size_t count = m_column.size() + 1;
    system.multiply(m_basis[count - 1], m_product);
    const double squared = preconditioner.apply(m_product, m_preconditioned);
    const Sums along = dotProducts(m_basis, count, m_product);
    double rest = squared;
    for (std::size_t v = 0; v < count; ++v)
        rest -= along[v] * along[v];
    const double beyond = rest > leastNew * squared ? std::sqrt(rest) : 0;
    if (m_basis.size() == count && count < mostKept)
        m_basis.emplace_back();
    if (beyond > 0 && count < mostKept) {
        FloatArray& next = m_basis[count];
        if (next.size() != m_product.size())
            next.resize(m_product.size());
        const auto factor = static_cast<float>(1 / beyond);
        forEachPart(next, [&](std::size_t c, std::size_t begin, std::size_t end) {
            float* to = next.component(c);
            const float* from = m_preconditioned.component(c);
            for (std::size_t i = begin; i < end; ++i)
                to[i] = factor * from[i];
            for (std::size_t v = 0; v < count; ++v) {
                const auto share = static_cast<float>(along[v] / beyond);
                const float* own = m_basis[v].component(c);
                for (std::size_t i = begin; i < end; ++i)
                    to[i] -= share * own[i];
            }
        });
    }
    std::vector<double> column(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t n = 0; n + 1 < count; ++n) {
        const auto [cosine, sine] = m_turns[n];
        const double upper = column[n];
        column[n] = cosine * upper + sine * column[n + 1];
        column[n + 1] = cosine * column[n + 1] - sine * upper;
    }
    const double length = std::hypot(column.back(), beyond);
    const auto [cosine, sine] =
        m_turns.emplace_back(length > 0 ? column.back() / length : 1, length > 0 ? beyond / length : 0);
    column.back() = length;
    m_column.push_back(std::move(column));
    m_left.push_back(-sine * m_left.back());
    m_left[count - 1] *= cosine;
}

/// What the basis gives of the solution.
void MinimalResiduals::addCombination(FloatArray& to) const
{
    const std::size_t count = m_column.size();
    std::vector<double> shares(count, 0);
    for (std::size_t n = count; n-- > 0;) {
        double rest = m_left[n];
        for (std::size_t later = n + 1; later < count; ++later)
            rest -= m_column[later][n] * shares[later];
        shares[n] = m_column[n][n] > 0 ? rest / m_column[n][n] : 0;
    }
    forEachPart(to, [&](std::size_t c, std::size_t begin, std::size_t end) {
        for (std::size_t v = 0; v < count; ++v) {
            const auto share = static_cast<float>(shares[v]);
            const float* own = m_basis[v].component(c);
            for (std::size_t i = begin; i < end; ++i)
                to.component(c)[i] += share * own[i];
        }
    });
}

LinearReport MinimalResiduals::solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner,
                                     const VectorArray& residual, VectorArray& solution, double goal, int most)
{
    for (FloatArray* vectors : {&m_solution, &m_preconditioned, &m_product, &m_way})
        vectors->resize(system.slotCount());
    const double scale = scaleOf(residual);
    system.gather(residual, scale, m_residual);
    goal *= scale * scale;
    LinearReport report;
    report.start = report.end = preconditioner.apply(m_residual, m_preconditioned);
    while (report.end > goal && report.iterations < most) {
        const double before = report.end;
        const double size = std::sqrt(before);
        if (m_basis.empty())
            m_basis.emplace_back();
        m_basis[0] = m_preconditioned;
        forEachPart(m_basis[0], [&](std::size_t c, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_basis[0].component(c)[i] *= static_cast<float>(1 / size);
        });
        m_column.clear();
        m_turns.clear();
        m_left.assign(1, size);
        while (report.end > goal && report.iterations < most && m_column.size() < mostKept) {
            extend(system, preconditioner);
            report.end = m_left.back() * m_left.back();
            ++report.iterations;
            if (m_turns.back().second == 0)
                break;
        }
        m_way.setZero();
        addCombination(m_way);
        forEachPart(m_way, [&](std::size_t c, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_solution.component(c)[i] += m_way.component(c)[i];
        });
        if (report.end <= goal || !(report.end < before)) // rounding is all that is left
            break;
        system.multiply(m_way, m_product);
        forEachPart(m_way, [&](std::size_t c, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_residual.component(c)[i] -= m_product.component(c)[i];
        });
        report.end = preconditioner.apply(m_residual, m_preconditioned);
    }
    system.addTo(solution, 1 / scale, m_solution);
    report.start /= scale * scale;
    report.end /= scale * scale;
    return report;
}

} // namespace knead
