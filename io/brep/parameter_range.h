#pragma once

#include <cstddef>
#include <vector>

class BRepAdaptor_Surface;
class Geom2dAdaptor_Curve;

namespace knead {

struct GaussRule {
    std::vector<double> points;  ///< -1..1
    std::vector<double> weights; ///< sum 2
};

GaussRule gaussRule(int order);

/// The range of a parameter, cut into pieces over which functions are smooth.
struct ParameterRange {
    std::vector<double> knots; ///< at least two
    int order = 1;             ///< of Gauss integration that a piece asks for

    double first() const { return knots.front(); }
    double last() const { return knots.back(); }
    double width() const { return last() - first(); }
    std::size_t pieces() const { return knots.size() - 1; }
};

/// Cut at knots of splines, and where a round surface goes around by more than a quarter.
ParameterRange uRangeOf(const BRepAdaptor_Surface& surface);
ParameterRange vRangeOf(const BRepAdaptor_Surface& surface);

/// Cut at knots of splines and where the curve turns far.
ParameterRange rangeOf(const Geom2dAdaptor_Curve& curve);

/// The order for each of many pieces: short ones need few points.
int orderFor(std::size_t pieces, int order);

constexpr std::size_t fewPieces = 12;    ///< up to so many are integrated with the order of their degree
constexpr double narrowestPiece = 1e-10; ///< of a range; cuts that lie closer are one

} // namespace knead
