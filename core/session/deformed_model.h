#pragma once

#include "core/deformation/deformation.h"
#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/model/part.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <functional>
#include <memory>
#include <vector>

namespace knead {

/// Parts after a deformation, as if they had come so from a file: with exact faces where they had them, names, colors and tree.
struct DeformedModel {
    Model model;         ///< of all parts, deformed or not; its file is that of the model before
    ExportReport report; ///< on those that were written
    /// Per part: which one of the model before. Parts keep their numbers; the second and later pieces of one that has come apart follow
    /// behind all others.
    std::vector<std::size_t> origin;
    bool isOfRest = true; ///< nothing was kneaded before
};

/// What was written, read again.
struct WrittenModel {
    Model model;
    ExportReport report;
};

/// Writes a job as a CAD file, reads that again and forgets the file. Blocks. @throws std::runtime_error, in a sentence; Cancelled
using WriteAndRead = std::function<WrittenModel(ExportJob job, TaskControl&)>;

/// What was done to parts since they were opened.
struct PresentShape {
    std::vector<std::size_t> partOfBody; ///< per body of the snapshot: index into Model::parts
    SnapshotPointer snapshot;            ///< null: nothing
};

/// Carries parts through deformations: those with exact faces by way of a CAD file, whose faces, names and colors stay; meshes by
/// their triangles. What was kneaded before is in it, also of parts that are not deformed.
/// @param deformations null: none, parts as they are now
/// @param which per part of the model; empty: all
/// @throws Problem, in a sentence: nothing to deform, a map that is none. @throws Cancelled
DeformedModel deformedModel(const Model& model, const PresentShape& now,
                            const std::shared_ptr<const std::vector<Deformation>>& deformations,
                            const std::vector<bool>& which, const WriteAndRead& writeAndRead, TaskControl& control);

/// The same with parts as they were opened.
DeformedModel deformedModel(const Model& model, const std::shared_ptr<const std::vector<Deformation>>& deformations,
                            const std::vector<bool>& which, const WriteAndRead& writeAndRead, TaskControl& control);

} // namespace knead
