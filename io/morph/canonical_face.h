#pragma once

#include "core/geometry/spline_fit.h"
#include "io/morph/parameter_curves.h"

#include <Geom_ElementarySurface.hxx>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// A piece of surface x(u, v) that may be one of a simple form.
struct SurfacePiece {
    /// Places of parameters, a little beyond the piece too [mm].
    std::function<void(std::span<const Vec2>, std::span<Vec3>)> places;
    Vec2 low; ///< the box of its parameters
    Vec2 high;
    std::array<bool, 2> isClosed{}; ///< ends along u, along v where it begins
    std::vector<Vec2> inside;       ///< parameters well within it
    std::vector<Vec2> border;       ///< and on its border
};

/// A surface of simple form, and which of its parameters are those of a piece.
struct CanonicalSurface {
    Handle(Geom_ElementarySurface) surface; ///< [mm]
    ParameterMap parameters;                ///< from those of the piece
    double error = 0;                       ///< largest distance at parameters that belong together [mm]
};

/// The cylinder, cone, sphere or torus that a piece is of, where its parameters run evenly with those of that surface: as of a plane
/// that is bent into a cylinder, a tube that is bent into a torus, a cylinder that tapers into a cone or is twisted about its axis.
/// @param tolerance by which places may be off, at parameters that belong together [mm]
/// @return none where it is of no such form
std::optional<CanonicalSurface> canonicalSurface(const SurfacePiece& piece, double tolerance);

} // namespace knead
