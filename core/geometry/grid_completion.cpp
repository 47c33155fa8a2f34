#include "core/geometry/grid_completion.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Ties values down where second derivatives do not: between lines that nothing known crosses. Relative to the stiffness where
// lines lie farthest apart: where they crowd it is larger by the cube of how much, and a tie to go with that would pull all
// values to their mean.
constexpr double tie = 1e-8;
constexpr double rounding = 1e-15; // of the largest stiffness: less would be lost

/// The second derivative from values at three places, by the root of the length it stands for: the sum of squares over a
/// line is the integral of its square.
std::array<double, 3> secondDerivative(double a, double b, double c)
{
    const double weight = std::sqrt(2 / (c - a));
    return {weight / (b - a), -weight / (b - a) - weight / (c - b), weight / (c - b)};
}

class GridSystem {
public:
    GridSystem(const std::vector<bool>& known, std::span<Vec3> values)
        : m_values(values)
        , m_numbers(known.size(), -1)
    {
        for (std::size_t i = 0; i < known.size(); ++i)
            if (!known[i])
                m_numbers[i] = m_unknowns++;
        m_right.setZero(m_unknowns, 3);
    }

    int unknowns() const { return m_unknowns; }

    void add(const std::array<std::size_t, 3>& places, const std::array<double, 3>& factors)
    {
        for (std::size_t row = 0; row < 3; ++row) {
            const int unknown = m_numbers[places[row]];
            if (unknown < 0)
                continue;
            for (std::size_t column = 0; column < 3; ++column) {
                const double product = factors[row] * factors[column];
                if (const int other = m_numbers[places[column]]; other >= 0)
                    m_entries.emplace_back(unknown, other, product);
                else
                    m_right.row(unknown) -= product * m_values[places[column]].transpose();
            }
        }
    }

    /// @param mean what unknown values are weakly tied to
    void solve(const Vec3& mean)
    {
        std::vector<double> stiffness(static_cast<std::size_t>(m_unknowns), 0);
        for (const Eigen::Triplet<double>& entry : m_entries)
            if (entry.row() == entry.col())
                stiffness[static_cast<std::size_t>(entry.row())] += entry.value();
        double least = std::numeric_limits<double>::max();
        double largest = 0;
        for (const double value : stiffness) {
            least = value > 0 ? std::min(least, value) : least;
            largest = std::max(largest, value);
        }
        const double spring = largest > 0 ? std::max(tie * least, rounding * largest) : 1;
        for (int unknown = 0; unknown < m_unknowns; ++unknown) {
            m_entries.emplace_back(unknown, unknown, spring);
            m_right.row(unknown) += spring * mean.transpose();
        }
        Eigen::SparseMatrix<double> matrix(m_unknowns, m_unknowns);
        matrix.setFromTriplets(m_entries.begin(), m_entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
        const Eigen::Matrix<double, Eigen::Dynamic, 3> solution = factors.solve(m_right);
        for (std::size_t i = 0; i < m_values.size(); ++i)
            if (m_numbers[i] >= 0)
                m_values[i] = solution.row(m_numbers[i]).transpose();
    }

private:
    std::span<Vec3> m_values;
    std::vector<int> m_numbers; // of unknowns, -1 for what is known
    int m_unknowns = 0;
    std::vector<Eigen::Triplet<double>> m_entries;
    Eigen::Matrix<double, Eigen::Dynamic, 3> m_right;
};

} // namespace

void completeGrid(std::span<const double> u, std::span<const double> v, const std::vector<bool>& known,
                  std::span<Vec3> values)
{
    assert(values.size() == u.size() * v.size() && known.size() == values.size());
    GridSystem system(known, values);
    if (system.unknowns() == 0 || system.unknowns() == static_cast<int>(values.size()))
        return;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < values.size(); ++i)
        if (known[i])
            sum += values[i];
    for (std::size_t i = 0; i < u.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j) {
            const std::size_t place = i * v.size() + j;
            if (i > 0 && i + 1 < u.size())
                system.add({place - v.size(), place, place + v.size()}, secondDerivative(u[i - 1], u[i], u[i + 1]));
            if (j > 0 && j + 1 < v.size())
                system.add({place - 1, place, place + 1}, secondDerivative(v[j - 1], v[j], v[j + 1]));
        }
    system.solve(sum / static_cast<double>(static_cast<int>(values.size()) - system.unknowns()));
}

} // namespace knead
