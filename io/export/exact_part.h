#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"
#include "io/cad_writer.h"
#include "io/morph/brep_morph.h"

#include <memory>
#include <string>

namespace knead {

/// A part as it will be written, and what the check needs to know about it.
struct ReadyPart {
    CadPartToWrite out;
    PartExportReport report;              ///< what is known before the file is read back
    TopoDS_Shape source;                  ///< of an exact part, at rest [mm]
    std::shared_ptr<const SmoothMap> map; ///< that took it where it is [m]
    std::vector<MorphedFaceNote> notes;
};

/// Makes the shape of a part: its own faces, carried through the skin's map; flat triangles, with the reason, where these would
/// not make a sound solid or there are none.
/// @param shape of part.exact, as its bytes have it; null for a mesh
/// @param flatBecause why its own faces will not do, a sentence; empty: that is not known yet
ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    const std::string& flatBecause, TaskControl& control);

} // namespace knead
