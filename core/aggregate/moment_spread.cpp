#include "core/aggregate/moment_spread.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t terms = CellMoments::count;

// [a] Less leaves too few layers beside walls of 2.25 cells (+12 % in bending instead of +8 %); more costs and smears.
constexpr double radius = 2.4;

// Of the trace: what can hardly be told from the points (the square of a height with two layers) is left as it is.
// Less asks for large weights of both signs there, more leaves out what could be had.
constexpr double relativeRidge = 2e-4;

using Exponents = std::array<std::size_t, 3>;

constexpr std::array<Exponents, terms> exponents{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};

constexpr std::size_t powers = 5; // 0 to 4

/// sum omega u^i v^j w^k over points, for i + j + k <= 4. Points come row by row and plane by plane, so that each axis is
/// summed over once: a third of the work of summing 35 products over the points.
struct PowerSums {
    std::array<double, powers> row{};                                         ///< k
    std::array<std::array<double, powers>, powers> plane{};                   ///< j k
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

    double ridge() const
    {
        double trace = 0;
        for (const Exponents& e : exponents)
            trace += ofTerms(e, e);
        return relativeRidge * trace;
    }
};

using Coefficients = std::array<double, terms>;

/// (sum omega p p^T + ridge)^-1 M, by L D L^T.
Coefficients fitted(const PowerSums& sums, const QuadraticMoments& moments)
{
    std::array<std::array<double, terms>, terms> lower; // below the diagonal L, on and above it L D
    const double ridge = sums.ridge();
    std::array<double, terms> inverse;
    Coefficients c = moments;
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double left = sums.ofTerms(exponents[i], exponents[j]);
            for (std::size_t k = 0; k < j; ++k)
                left -= lower[i][k] * lower[k][j];
            lower[j][i] = left;
            if (j < i)
                lower[i][j] = left * inverse[j];
        }
        inverse[i] = 1 / (lower[i][i] += ridge);
        for (std::size_t k = 0; k < i; ++k)
            c[i] -= lower[i][k] * c[k];
    }
    for (std::size_t i = terms; i-- > 0;) {
        c[i] *= inverse[i];
        for (std::size_t k = i + 1; k < terms; ++k)
            c[i] -= lower[k][i] * c[k];
    }
    return c;
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
    const Lattice::Node& ahead = Lattice::directions[direction];
    const auto middle = [&](std::int32_t place, std::size_t axis) { return place - reach + 0.5 * ahead[axis]; };
    const auto square = [](double x) { return x * x; };
    // Calls visit(place, coordinate, what is left of the square) along an axis, where the square of the radius is not passed.
    const auto forEachWithin = [&](double squared, std::size_t axis, auto visit) {
        const double at = center[static_cast<Eigen::Index>(axis)];
        const double half = std::sqrt(squared);
        const auto first = static_cast<std::int32_t>(std::ceil(at - half - middle(0, axis)));
        const auto last = static_cast<std::int32_t>(std::floor(at + half - middle(0, axis)));
        for (std::int32_t place = std::max(first, 0); place <= std::min(last, across - 1); ++place)
            visit(place, middle(place, axis) - at, std::max(squared - square(middle(place, axis) - at), 0.0));
    };
    m_points.clear();
    m_shares.clear();
    PowerSums sums;
    forEachWithin(square(radius), 0, [&](std::int32_t plane, double u, double left) {
        forEachWithin(left, 1, [&](std::int32_t row, double v, double leftInPlane) {
            forEachWithin(leftInPlane, 2, [&](std::int32_t place, double w, double leftInRow) {
                const auto node = static_cast<std::uint32_t>((plane * across + row) * across + place);
                const ObjectIndex object = objects[node];
                if (object >= today.size() || !(today[object] > 0))
                    return;
                const double r = std::sqrt(square(radius) - leftInRow) * (1 / radius);
                const double omega = today[object] * square(square(1 - r)) * (4 * r + 1);
                m_points.push_back({u, v, w, omega});
                m_shares.push_back({node, 0});
                sums.addPoint(w, omega);
            });
            sums.endRow(v);
        });
        sums.endPlane(u);
    });
    m_residual = {};
    if (m_points.empty())
        return m_shares;
    const Coefficients coefficients = fitted(sums, moments);
    const double ridge = sums.ridge();
    for (std::size_t k = 0; k < terms; ++k)
        m_residual[k] = -ridge * coefficients[k];
    for (std::size_t b = 0; b < m_points.size(); ++b) {
        const Point& x = m_points[b];
        m_shares[b].weight = x.omega * valueAt(coefficients, x.u, x.v, x.w);
    }
    return m_shares;
}

} // namespace knead
