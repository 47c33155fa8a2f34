#include "core/aggregate/moment_stencil.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t terms = MomentStencil::terms;
constexpr std::size_t products = MomentStencil::products;

// [a] 2.1 leaves too few layers beside walls of 2.25 cells (+12 % in bending instead of +5 %); more costs and smears.
constexpr double radius = 2.3;

// Of the trace: what can hardly be told from the points (the square of a height with two layers) is left as it is.
// Less asks for large weights of both signs there, more leaves out what could be had.
constexpr double ridge = 2e-4;

using Exponents = std::array<int, 3>;

constexpr std::array<Exponents, terms> exponents{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};

constexpr std::size_t exponentKey(const Exponents& e)
{
    return static_cast<std::size_t>(25 * e[0] + 5 * e[1] + e[2]);
}

struct Products {
    std::array<std::array<std::size_t, terms>, terms> of{}; ///< number of the product of two terms
    std::array<std::pair<std::size_t, std::size_t>, products> pair{};
};

constexpr Products numberProducts()
{
    Products numbers;
    std::array<std::size_t, 125> known{}; // number + 1 by exponents
    std::size_t count = 0;
    for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            Exponents sum = exponents[i];
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += exponents[j][axis];
            std::size_t& number = known[exponentKey(sum)];
            if (number == 0) {
                numbers.pair[count] = {i, j};
                number = ++count;
            }
            numbers.of[i][j] = numbers.of[j][i] = number - 1;
        }
    return numbers;
}

constexpr Products productNumbers = numberProducts();

constexpr int places = 3; // of centers of material per axis that are told apart

/// @param place 0 .. places - 1
constexpr double placeOf(int place)
{
    return (place - 1) / 3.0;
}

int nearestPlace(double coordinate)
{
    return std::clamp(static_cast<int>(std::lround(3 * coordinate)) + 1, 0, places - 1);
}

std::vector<MomentStencil> makeStencils()
{
    std::vector<MomentStencil> stencils;
    stencils.reserve(Lattice::isotropicCount * places * places * places);
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        for (int u = 0; u < places; ++u)
            for (int v = 0; v < places; ++v)
                for (int w = 0; w < places; ++w)
                    stencils.emplace_back(d, Vec3(placeOf(u), placeOf(v), placeOf(w)));
    return stencils;
}

} // namespace

MomentStencil::MomentStencil(std::size_t direction, const Vec3& center)
{
    const Lattice::Node& ahead = Lattice::directions[direction];
    const Vec3 middle = 0.5 * (Vec3(ahead[0], ahead[1], ahead[2]) - Vec3::Ones());
    for (std::size_t node = 0; node < nodes; ++node) {
        const auto place = static_cast<std::int32_t>(node);
        const Vec3 x =
            middle + Vec3(first + place / (across * across), first + place / across % across, first + place % across);
        const double r = (x - center).norm() / radius;
        if (r >= 1)
            continue;
        Point point;
        point.node = node;
        point.omega = std::pow(1 - r, 4) * (4 * r + 1);
        point.term = {1,           x[0],        x[1],        x[2],        x[0] * x[0],
                      x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2]};
        for (std::size_t k = 0; k < products; ++k) {
            const auto [i, j] = productNumbers.pair[k];
            point.product[k] = point.omega * point.term[i] * point.term[j];
        }
        m_points.push_back(point);
    }
}

const MomentStencil& MomentStencil::of(std::size_t direction, const Vec3& center)
{
    static const std::vector<MomentStencil> stencils = makeStencils();
    std::size_t number = direction;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        number = places * number + static_cast<std::size_t>(nearestPlace(center[axis]));
    return stencils[number];
}

void MomentStencil::spread(const QuadraticMoments& moments, const std::vector<double>& weight,
                           std::vector<double>& weights) const
{
    using Products = Eigen::Matrix<double, products, 1>;
    Products sum = Products::Zero();
    for (std::size_t b = 0; b < m_points.size(); ++b)
        if (weight[b] > 0)
            sum += weight[b] * Eigen::Map<const Products>(m_points[b].product.data());
    weights.assign(m_points.size(), 0);
    if (sum[0] == 0)
        return;
    Eigen::Matrix<double, terms, terms> matrix;
    for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t j = 0; j < terms; ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                sum[static_cast<Eigen::Index>(productNumbers.of[i][j])];
    matrix.diagonal().array() += ridge * matrix.trace();
    const Eigen::Matrix<double, terms, 1> coefficients =
        matrix.llt().solve(Eigen::Map<const Eigen::Matrix<double, terms, 1>>(moments.data()));
    for (std::size_t b = 0; b < m_points.size(); ++b) {
        const Eigen::Map<const Eigen::Matrix<double, terms, 1>> term(m_points[b].term.data());
        weights[b] = weight[b] * m_points[b].omega * term.dot(coefficients);
    }
}

} // namespace knead
