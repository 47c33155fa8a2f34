#include "core/aggregate/moment_spread.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace knead {

namespace {

constexpr std::size_t terms = CellMoments::count;

// [a] Less leaves too few layers beside walls of 2.25 cells (+12 % in bending instead of +8 %); more costs and smears.
constexpr double radius = 2.4;

// Of the trace: what can hardly be told from the points (the square of a height with two layers) is left as it is.
// Less asks for large weights of both signs there, more leaves out what could be had.
constexpr double ridge = 2e-4;

using Exponents = std::array<std::size_t, 3>;

constexpr std::array<Exponents, terms> exponents{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};

constexpr std::size_t powers = 5; // 0 to 4

/// sum omega u^i v^j w^k over points, for i + j + k <= 4. Points come row by row and plane by plane, so that each axis is
/// summed over once: a third of the work of summing 35 products over the points.
struct PowerSums {
    std::array<double, powers> row{};                               ///< k
    std::array<std::array<double, powers>, powers> plane{};         ///< j k
    std::array<std::array<std::array<double, powers>, powers>, powers> all{}; ///< i j k

    void addPoint(double w, double omega)
    {
        for (double& sum : row) {
            sum += omega;
            omega *= w;
        }
    }

    void endRow(double v)
    {
        double power = 1;
        for (std::size_t j = 0; j < powers; ++j, power *= v)
            for (std::size_t k = 0; j + k < powers; ++k)
                plane[j][k] += power * row[k];
        row = {};
    }

    void endPlane(double u)
    {
        double power = 1;
        for (std::size_t i = 0; i < powers; ++i, power *= u)
            for (std::size_t j = 0; i + j < powers; ++j)
                for (std::size_t k = 0; i + j + k < powers; ++k)
                    all[i][j][k] += power * plane[j][k];
        plane = {};
    }

    double ofTerms(const Exponents& a, const Exponents& b) const { return all[a[0] + b[0]][a[1] + b[1]][a[2] + b[2]]; }
};

using Matrix = Eigen::Matrix<double, terms, terms>;
using Coefficients = Eigen::Matrix<double, terms, 1>;

/// (sum omega p p^T + ridge)^-1 M
Coefficients fitted(const PowerSums& sums, const QuadraticMoments& moments)
{
    Matrix matrix;
    for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t j = 0; j < terms; ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                sums.ofTerms(exponents[i], exponents[j]);
    matrix.diagonal().array() += ridge * matrix.trace();
    return matrix.llt().solve(Eigen::Map<const Coefficients>(moments.data()));
}

double valueAt(const Coefficients& c, double u, double v, double w)
{
    return c[0] + u * (c[1] + c[4] * u + c[7] * v + c[8] * w) + v * (c[2] + c[5] * v + c[9] * w) +
           w * (c[3] + c[6] * w);
}

} // namespace

QuadraticMoments moved(const QuadraticMoments& m, const Vec3& s)
{
    return {m[0],
            m[1] + s[0] * m[0],
            m[2] + s[1] * m[0],
            m[3] + s[2] * m[0],
            m[4] + 2 * s[0] * m[1] + s[0] * s[0] * m[0],
            m[5] + 2 * s[1] * m[2] + s[1] * s[1] * m[0],
            m[6] + 2 * s[2] * m[3] + s[2] * s[2] * m[0],
            m[7] + s[0] * m[2] + s[1] * m[1] + s[0] * s[1] * m[0],
            m[8] + s[0] * m[3] + s[2] * m[1] + s[0] * s[2] * m[0],
            m[9] + s[1] * m[3] + s[2] * m[2] + s[1] * s[2] * m[0]};
}

const std::vector<MomentSpread::Share>& MomentSpread::spread(std::size_t direction, const QuadraticMoments& moments,
                                                             const Vec3& center, const Objects& objects,
                                                             const std::vector<double>& today)
{
    constexpr double far = radius * radius;
    const Lattice::Node& ahead = Lattice::directions[direction];
    const auto middle = [&](std::int32_t place, std::size_t axis) { return place - reach + 0.5 * ahead[axis]; };
    const auto square = [](double x) { return x * x; };
    m_points.clear();
    m_shares.clear();
    PowerSums sums;
    for (std::int32_t planes = 0; planes < across; ++planes) {
        const double u = middle(planes, 0);
        const double besides = square(u - center[0]);
        if (besides >= far)
            continue;
        for (std::int32_t rows = 0; rows < across; ++rows) {
            const double v = middle(rows, 1);
            const double beside = besides + square(v - center[1]);
            if (beside >= far)
                continue;
            for (std::int32_t places = 0; places < across; ++places) {
                const double w = middle(places, 2);
                const double squared = beside + square(w - center[2]);
                const ObjectIndex object = objects[static_cast<std::size_t>((planes * across + rows) * across + places)];
                if (squared >= far || object >= today.size() || !(today[object] > 0))
                    continue;
                const double r = std::sqrt(squared) / radius;
                const double omega = today[object] * square(square(1 - r)) * (4 * r + 1);
                m_points.push_back({u, v, w, omega});
                m_shares.push_back({object, 0});
                sums.addPoint(w, omega);
            }
            sums.endRow(v);
        }
        sums.endPlane(u);
    }
    if (m_points.empty())
        return m_shares;
    const Coefficients coefficients = fitted(sums, moments);
    for (std::size_t b = 0; b < m_points.size(); ++b) {
        const Point& x = m_points[b];
        m_shares[b].weight = x.omega * valueAt(coefficients, x.u, x.v, x.w);
    }
    return m_shares;
}

} // namespace knead
