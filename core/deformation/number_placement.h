#pragma once

#include "core/deformation/number_deformation.h"
#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"

#include <optional>
#include <span>

namespace knead {

/// Where a deformation of a part may begin: its axis along the longest side of the box through the middle, toward the shortest one,
/// planes at a quarter and three quarters of it, the neutral plane in the middle. It does nothing yet: angle 0, factor 1.
/// @pre the box is not empty
NumberDeformation suggestedDeformation(NumberKind kind, const Box& box);

/// How far material reaches toward the side of a deformation between its planes, from the origin [m]; empty where there is none.
struct HeightRange {
    double least = 0;
    double most = -1;

    bool isEmpty() const { return most < least; }
};
HeightRange heightsBetweenPlanes(const NumberDeformation& deformation, const TriangleMesh& mesh);
/// Of several parts together.
HeightRange heightsBetweenPlanes(const NumberDeformation& deformation, std::span<const TriangleMesh> meshes);

/// NumberDeformation::neutral of a bent sheet: k of its thickness from the surface on the inner side, as sheet metal workers give it,
/// 0.5 being the middle. Its angle says which side is the inner one.
///   neutral = inner + k (outer - inner)
/// @pre heights are not empty
double neutralOfSheet(const NumberDeformation& deformation, const HeightRange& heights, double kFactor);

/// The smallest radius that a bend may have at its neutral plane, so that the material on the inner side is not folded over itself
/// [m]: as far as that reaches from the neutral plane; 0 where there is none.
double smallestRadius(const NumberDeformation& deformation, const HeightRange& heights);

/// The smallest radius that a bend has at its neutral plane [m]: length / angle, or, where it eases, 8/15 of it.
/// @pre the angle is not 0
double radiusOf(const NumberDeformation& deformation);

/// Why a deformation would fold material over itself, and what to do; none where it does not.
std::optional<Message> foldOf(const NumberDeformation& deformation, const HeightRange& heights);
std::optional<Message> foldOf(const NumberDeformation& deformation, const TriangleMesh& mesh);

} // namespace knead
