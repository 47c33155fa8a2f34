#pragma once

#include "core/skin/former_shape.h"
#include "core/skin/skin.h"
#include "core/skin/surface_fit.h"
#include "core/task/task_control.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace knead {

/// Moves places of a surface that cannot be where they are, as those inside of a tool [m].
using MovePlaces = std::function<void(std::span<Vec3> places)>;

/// What of the fit of a former shape does not depend on where its carriers go, for the next one. Immutable.
struct ShapeFitting {
    Skin carriers;     ///< of the places of the carriers themselves
    TriangleMesh mesh; ///< the surface of the opened part, split
    Skin surface;      ///< of its vertices
};

/// How the shape of a body is filled anew.
struct RefillManner {
    double spacing = 0;                       ///< of the new filling [m], > 0
    std::optional<Eigen::Index> rowAxis = {}; ///< as in FillOptions
    bool keepsCarriers = false;               ///< those of its former shape, however far these have been drawn apart
};

/// Fills the shape that a body has now: the surface of the opened part, carried to where the objects are, becomes the one that is
/// filled. Surfaces that have come to overlap are filled as one where they wind around material.
///
/// The map that carries it is fitted anew to the carriers of the first filling (FormerShape), to where they have come, and at the
/// surface to where that touches tools: trilinearly between objects. So the first one follows the objects within what their map
/// smooths, and later ones lose what is finer than the spacing of the carriers in the opened part. Where that map stretches more than
/// FormerShape::mostStretch, the present objects are the carriers from here on.
/// @param surface of the opened part
/// @param displacements one per object of `present` [m]
/// @param fitting of the filling before, or null; afterwards that of this one. It saves time and changes no bit
/// @param move what the surface keeps clear of; null: nothing
/// @return with its former shape, never null
/// @throws Problem when the shape cannot be filled; Cancelled
std::shared_ptr<const Aggregate> refilled(const TriangleMesh& surface, const std::shared_ptr<const Aggregate>& present,
                                          std::span<const Vec3> displacements, const RefillManner& manner,
                                          std::shared_ptr<const ShapeFitting>& fitting,
                                          const MovePlaces& move = nullptr, TaskControl& control = TaskControl::none());

/// Which objects of an aggregate lie where some of the first filling did when it was filled; those themselves where it is the first.
/// @param first objects of the first filling, ascending
std::vector<ObjectIndex> objectsInFilling(const Aggregate& aggregate, const std::vector<ObjectIndex>& first);

/// The surface of an opened part as an aggregate was filled from it: split and carried, or as it is. That of a body that was in pieces
/// is the surfaces of all of these.
/// @param longestEdge as far as what was carried is split [spacings]
TriangleMesh surfaceWhenFilled(const TriangleMesh& surface, const Aggregate& aggregate,
                               double longestEdge = refilledEdge);

} // namespace knead
