#pragma once

#include "core/model/export_job.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <optional>

namespace knead {

/// A surface of a part as a part of its own: its name and a number, its colors, and a face without any for what a crack made, behind
/// those of the part.
Part pieceOf(const Part& whole, TriangleMesh mesh, std::size_t number);

/// A part in one piece as it is where a crack in it gapes: with the sides of the crack. A flat cut by a knife leaves it its own faces,
/// see KnifeSlit, when that is wanted; else it has none. None where no crack gapes, so that its own faces do as they are.
/// @param whole with broken connections and a closed mesh
/// @param mostTriangles as in withPieces()
/// @throws Cancelled
std::optional<PartToExport> gaping(const PartToExport& whole, std::size_t mostTriangles, bool keepsFaces,
                                   TaskControl& control);

} // namespace knead
