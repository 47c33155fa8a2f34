#pragma once

#include "core/geometry/spline_basis.h"
#include "core/geometry/vec3.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace knead {

/// A place in the parameters of a surface.
using Vec2 = Eigen::Vector2d;

/// A polynomial B-spline curve.
struct SplineCurve {
    SplineKnots knots;
    int degree = 0;
    std::vector<Vec3> poles;
};

/// A polynomial tensor-product B-spline surface of the same degree in both directions.
struct SplineSurface {
    SplineKnots u;
    SplineKnots v;
    int degree = 0;
    std::vector<Vec3> poles; ///< those of a u beside each other
};

/// What is fitted: places for parameters, as many as asked for. The same parameters always give the same places.
using CurveTarget = std::function<void(std::span<const double> parameters, std::span<Vec3> places)>;
using SurfaceTarget = std::function<void(std::span<const Vec2> parameters, std::span<Vec3> places)>;

struct SplineFitOptions {
    int degree = 5;
    double tolerance = 1e-6;     ///< largest distance at equal parameters
    double slopeTolerance = 0;   ///< of a surface's normals at the places that matter most [rad]; 0: not looked at
    std::size_t mostSpans = 640; ///< per direction
    std::size_t mostPoles = 60'000;
};

template <typename Spline>
struct SplineFit {
    Spline spline;
    double error = 0;          ///< largest distance that was seen
    bool converged = false;    ///< within the tolerance
    Vec2 worst = Vec2::Zero(); ///< parameters of a surface where that distance was seen
};

/// Interpolates a curve at Greville points and splits the spans in which it misses the tolerance, until it does not.
/// @param start knots where the target is not smooth, with multiplicities that leave it so
/// @param feature a length of parameter in which the target has no features: it is looked at that often at least, > 0
SplineFit<SplineCurve> fitCurve(const CurveTarget& target, const SplineKnots& start, double feature,
                                const SplineFitOptions& options);

/// What a surface is fitted to and where.
struct SurfaceToFit {
    SurfaceTarget target;
    SurfaceTarget rest; ///< what the target is a deformation of. Where the target is not known the spline follows this,
                        ///< displaced in a way that goes on smoothly from where it is
    SplineKnots u;      ///< as `start` of fitCurve()
    SplineKnots v;
    Vec2 feature = Vec2::Ones();             ///< as `feature` of fitCurve(), along u and v
    std::function<bool(const Vec2&)> counts; ///< whether errors matter at a place
    /// Whether the target is known at a place, as it must be where errors matter; the further around, the smoother the spline.
    std::function<bool(const Vec2&)> isKnown;
    std::vector<Vec2> checks;       ///< places where they matter most
    std::array<bool, 2> isClosed{}; ///< along u and v: the target ends where it begins, and so will the spline
};

/// As fitCurve(), for a surface: interpolation in both directions one after the other. Errors are looked for along lines of
/// constant u and v first, which tell the direction to refine, then all over.
SplineFit<SplineSurface> fitSurface(const SurfaceToFit& wanted, const SplineFitOptions& options);

} // namespace knead
