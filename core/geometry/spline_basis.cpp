#include "core/geometry/spline_basis.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace knead {

std::size_t SplineKnots::spanOf(double parameter) const
{
    const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, parameter);
    return static_cast<std::size_t>(above - values.begin()) - 1;
}

namespace {

constexpr double steepest = 4.5; // ratio of spans side by side

/// Marks spans, too, beside which much shorter ones would be.
std::vector<bool> graded(const std::vector<double>& knots, std::vector<bool> marked)
{
    const auto length = [&](std::size_t span) { return (knots[span + 1] - knots[span]) / (marked[span] ? 2 : 1); };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i + 1 < marked.size(); ++i) {
            const std::size_t longer = length(i) > length(i + 1) ? i : i + 1;
            const std::size_t other = longer == i ? i + 1 : i;
            if (!marked[longer] && marked[other] && length(longer) > steepest * length(other))
                changed = marked[longer] = true;
        }
    }
    return marked;
}

} // namespace

SplineKnots SplineKnots::split(const std::vector<bool>& wanted) const
{
    const std::vector<bool> marked = graded(values, wanted);
    SplineKnots result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        result.values.push_back(values[i]);
        result.multiplicities.push_back(multiplicities[i]);
        if (i < spans() && marked[i]) {
            result.values.push_back(std::midpoint(values[i], values[i + 1]));
            result.multiplicities.push_back(1);
        }
    }
    return result;
}

SplineKnots SplineKnots::between(double a, double b)
{
    return {{a, b}, {1, 1}};
}

SplineBasis::SplineBasis(const SplineKnots& knots, int degree)
    : m_degree(degree)
{
    assert(degree >= 1 && degree <= mostDegree && knots.values.size() >= 2);
    for (std::size_t i = 0; i < knots.values.size(); ++i) {
        const bool isEnd = i == 0 || i + 1 == knots.values.size();
        m_multiplicities.push_back(isEnd ? degree + 1 : std::clamp(knots.multiplicities[i], 1, degree));
        m_knots.insert(m_knots.end(), static_cast<std::size_t>(m_multiplicities.back()), knots.values[i]);
    }
    m_greville.resize(m_knots.size() - static_cast<std::size_t>(degree) - 1);
    for (std::size_t i = 0; i < m_greville.size(); ++i) {
        const auto first = m_knots.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        // Equal knots have themselves as their mean, whatever rounding says.
        m_greville[i] = *first == first[degree - 1] ? *first : std::accumulate(first, first + degree, 0.0) / degree;
    }
    m_greville.front() = m_knots.front();
    m_greville.back() = m_knots.back();
    factorize();
}

std::size_t SplineBasis::lastKnotBefore(double parameter) const
{
    const auto degree = static_cast<std::ptrdiff_t>(m_degree);
    const auto begin = m_knots.begin() + degree + 1;
    const auto end = m_knots.end() - degree - 1;
    return static_cast<std::size_t>(std::upper_bound(begin, end, parameter) - m_knots.begin()) - 1;
}

std::size_t SplineBasis::functionsAt(double parameter, Values& values) const
{
    const std::size_t span = lastKnotBefore(parameter);
    Values left{};
    Values right{};
    values[0] = 1;
    for (std::size_t j = 1; j <= static_cast<std::size_t>(m_degree); ++j) {
        left[j] = parameter - m_knots[span + 1 - j];
        right[j] = m_knots[span + j] - parameter;
        double saved = 0;
        for (std::size_t k = 0; k < j; ++k) {
            const double part = values[k] / (right[k + 1] + left[j - k]);
            values[k] = saved + right[k + 1] * part;
            saved = left[j - k] * part;
        }
        values[j] = saved;
    }
    return span - static_cast<std::size_t>(m_degree);
}

void SplineBasis::factorize()
{
    const auto p = static_cast<std::size_t>(m_degree);
    const std::size_t width = 2 * p + 1;
    const std::size_t n = size();
    m_factors.assign(n * width, 0);
    const auto entry = [&](std::size_t row, std::size_t column) -> double& {
        return m_factors[row * width + column + p - row];
    };
    Values values;
    for (std::size_t row = 0; row < n; ++row) {
        const std::size_t first = functionsAt(m_greville[row], values);
        for (std::size_t k = 0; k <= p; ++k)
            if (first + k + p >= row && first + k <= row + p)
                entry(row, first + k) = values[k];
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t row = k + 1; row < std::min(n, k + p + 1); ++row) {
            const double factor = entry(row, k) /= entry(k, k);
            for (std::size_t column = k + 1; column < std::min(n, k + p + 1); ++column)
                entry(row, column) -= factor * entry(k, column);
        }
}

void SplineBasis::interpolate(Vec3* values, std::size_t stride) const
{
    const auto p = static_cast<std::size_t>(m_degree);
    const std::size_t width = 2 * p + 1;
    const std::size_t n = size();
    const auto entry = [&](std::size_t row, std::size_t column) { return m_factors[row * width + column + p - row]; };
    for (std::size_t row = 0; row < n; ++row)
        for (std::size_t k = row > p ? row - p : 0; k < row; ++k)
            values[row * stride] -= entry(row, k) * values[k * stride];
    for (std::size_t row = n; row-- > 0;) {
        for (std::size_t k = row + 1; k < std::min(n, row + p + 1); ++k)
            values[row * stride] -= entry(row, k) * values[k * stride];
        values[row * stride] /= entry(row, row);
    }
}

} // namespace knead
