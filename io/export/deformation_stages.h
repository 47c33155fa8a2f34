#pragma once

#include "core/geometry/smooth_map.h"
#include "core/model/export_job.h"
#include "core/task/task_control.h"

#include <TopoDS_Shape.hxx>

#include <memory>

namespace knead {

/// A part that is to be carried by what it has of deformations.
struct StagedPart {
    PartToExport part;
    TopoDS_Shape shape;     ///< [mm]
    bool isCarried = false; ///< by stages before: half of the tolerance is used up
};

/// Makes a part ready for being carried by deformations that are smooth only between planes: its faces end at these. Where such a
/// deformation follows others, those are carried out first, since its planes lie in what they make of the part. What cannot be
/// divided soundly stays whole; a remark says so, as one says how many faces were divided.
/// @param shape at rest [mm]
/// @param own what the objects of the part make of it; null: they leave it where it is
/// @param tolerance [m]
/// @return the part as it is before the last of its stages, with the deformations of that one
/// @throws Cancelled
StagedPart inStages(const PartToExport& part, const TopoDS_Shape& shape, const std::shared_ptr<const SmoothMap>& own,
                    double tolerance, TaskControl& control);

} // namespace knead
