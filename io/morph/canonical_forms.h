#pragma once

#include "core/geometry/spline_fit.h"

#include <Geom_ElementarySurface.hxx>

#include <vector>

namespace knead {

/// Places of a surface with its normals, all to the same side.
struct OrientedPoints {
    std::vector<Vec3> places; ///< [mm]
    std::vector<Vec3> normals;
};

/// Cylinder, sphere, cone and torus that come nearest to points by their normals, as far as there are such; simple ones first. Whether
/// one of them is close remains to be seen.
std::vector<Handle(Geom_ElementarySurface)> possibleForms(const OrientedPoints& points);

/// The parameters of the place of a surface that is nearest.
Vec2 parametersOn(const Handle(Geom_ElementarySurface) & surface, const Vec3& place);

/// Whether a parameter (0: u, 1: v) is an angle rather than a length.
bool isAngle(const Handle(Geom_ElementarySurface) & surface, Eigen::Index axis);

bool isSphere(const Handle(Geom_ElementarySurface) & surface);

/// Its radius, the larger one of a torus [mm].
double sizeOf(const Handle(Geom_ElementarySurface) & surface);

} // namespace knead
