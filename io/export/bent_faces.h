#pragma once

#include "core/message/message.h"
#include "io/export/exact_part.h"

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

// How fine flat faces are, where smooth ones cannot be.
inline constexpr double facetDeflection = 1.0 / 400; ///< of the size of a part
inline constexpr double facetAngle = 0.35;           ///< between chords [rad]
inline constexpr std::size_t mostFacets = 60'000;    ///< of a part: more than CAD programs can work with

/// Carries the faces of `ready.source` through its map: its own ones, or those that close in themselves in two where that is
/// needed, or some of them as triangles where nothing else goes.
/// @return why they make no solid, a sentence; empty when `ready` has one
/// @throws Cancelled
Message bendFaces(const PartToExport& part, const FaceChoice& choice, TaskControl& control, ReadyPart& ready);

/// The part of a skin that triangles among smooth faces stand for.
/// @param skin numbered by the faces of the part
TriangleMesh skinOfFlatFaces(const ReadyPart& ready, const TriangleMesh& skin);

/// Gives faces that are written the colors and names of those that they are of.
/// @param origin per face that is written: which of the part it is of
void setFaces(const Part& part, const std::vector<std::uint32_t>& origin, CadPartToWrite& out);

/// Writes another face of each solid first, see withFaceFirst().
void putFaceFirst(const Part& part, std::size_t first, ReadyPart& ready);

/// A closed shape with its outside outside.
TopoDS_Shape outward(const TopoDS_Shape& shape);

} // namespace knead
