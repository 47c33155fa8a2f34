#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace knead {

/// Distinct knots, ascending, with the multiplicity of each inner one; those at the ends are clamped whatever they say.
struct SplineKnots {
    std::vector<double> values;      ///< at least two
    std::vector<int> multiplicities; ///< as many

    std::size_t spans() const { return values.size() - 1; }

    /// Which span holds a parameter; the first or last one for those outside.
    std::size_t spanOf(double parameter) const;

    /// In every span marked, a knot of multiplicity 1 in its middle; and in those beside that would become more than 4.5
    /// times as long, since interpolation overshoots where spans of very different lengths meet.
    SplineKnots split(const std::vector<bool>& wanted) const;

    /// Knots at a and b and nothing between.
    static SplineKnots between(double a, double b);
};

/// The B-spline basis functions of a clamped knot vector, and interpolation at its Greville points (de Boor, "A Practical
/// Guide to Splines", chapters IX and XIII).
class SplineBasis {
public:
    static constexpr int mostDegree = 9;
    using Values = std::array<double, mostDegree + 1>;

    /// Inner multiplicities are brought into 1 .. degree.
    /// @param degree 1 .. mostDegree
    SplineBasis(const SplineKnots& knots, int degree);

    int degree() const { return m_degree; }
    std::size_t size() const { return m_greville.size(); } ///< number of functions

    /// One parameter per function: means of `degree` consecutive knots. Ends are the ends of the knots.
    const std::vector<double>& greville() const { return m_greville; }

    /// Values of the degree + 1 functions that are not zero at a parameter.
    /// @return the first of them
    std::size_t functionsAt(double parameter, Values& values) const;

    /// Solves for the coefficients of the function that has the given values at the Greville points, in place.
    /// @param stride between values, which are size() of them
    void interpolate(Vec3* values, std::size_t stride) const;

    /// Multiplicities as used, ends included.
    std::vector<int> multiplicities() const { return m_multiplicities; }

private:
    std::size_t lastKnotBefore(double parameter) const;
    void factorize();

    int m_degree;
    std::vector<int> m_multiplicities;
    std::vector<double> m_knots; ///< with repetitions
    std::vector<double> m_greville;
    std::vector<double> m_factors; ///< LU of the collocation matrix, banded, without pivoting: it is totally positive
};

} // namespace knead
