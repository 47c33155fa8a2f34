#pragma once

#include "core/model/export_job.h"
#include "core/task/task_control.h"

namespace knead {

/// A job in which each part whose body has come apart is replaced by its pieces: closed surfaces at their present places, each
/// a part of its own in an assembly with the name of the whole. Parts that hang together stay as they are, and a remark says
/// where one of these is cracked, unless a crack gapes: then its sides are part of the surface, which has no smooth faces.
/// Where only knives have been between the pieces, these keep the faces of the part, see PieceCut, when that is wanted.
/// @param mostTriangles of a part before it is cut; the surface is refined so far that it can bend
/// @throws Cancelled
ExportJob withPieces(ExportJob job, std::size_t mostTriangles, TaskControl& control, bool keepsFaces = false);

} // namespace knead
