#pragma once

#include "core/message/message.h"
#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"
#include "io/formats/cad_writer.h"
#include "io/morph/brep_morph.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What the faces of a part are to be: what comes first is better, what comes last always works.
enum class FaceManner {
    own,     ///< one for each of its own
    divided, ///< those that close in themselves in two, see withoutClosedFaces()
    flat,    ///< triangles
};

/// What to begin with.
struct FaceChoice {
    FaceManner from = FaceManner::own; ///< what comes before did not come back sound
    Message reason;                    ///< why they do not: a sentence; empty for `own`
    std::vector<std::uint32_t> flat;   ///< faces of that manner that are to be triangles among smooth ones

    /// Faces of the manner before that did not come back fit, should there be none of this manner.
    std::vector<std::uint32_t> misfits;

    std::size_t firstFace = 0; ///< that is written first, see withFaceFirst()
};

/// A part as it will be written, and what the check needs to know about it.
struct ReadyPart {
    CadPartToWrite out;
    FaceManner manner = FaceManner::own; ///< in which its faces are
    std::optional<FaceManner> next; ///< what to try when it does not come back sound; none: nothing would be better
    PartExportReport report;        ///< what is known before the file is read back
    TopoDS_Shape source;            ///< of an exact part, at rest [mm]
    std::vector<std::uint32_t> originOfDivided; ///< where faces of it were divided: of which of the part each is
    std::shared_ptr<const SmoothMap> map;       ///< that took it where it is [m]
    bool findsForms = false; ///< see MorphOptions: for maps that a person gave, which make simple forms of such
    std::vector<MorphedFaceNote> notes; ///< on the faces of `source`; none where they stayed or are flat
    std::vector<std::uint32_t> origin;  ///< per written face, which of `source` it is or is a part of; none: in order
    TriangleMesh skin;                  ///< where the surface that is written as flat faces is, finely [m]
    std::vector<std::uint32_t>
        misfits; ///< faces of `source` that did not come back fit at all, as checkWritten() finds

    bool cameBackInsideOut = false; ///< as checkWritten() finds

    /// Whether a face of `source` is written as triangles among smooth ones.
    bool isFlat(std::size_t face) const { return face < notes.size() && notes[face].kind == MorphedFaceKind::flat; }
};

/// Makes the shape of a part: its own faces, carried through the skin's map; or, with the reason, another manner where these
/// would not make a sound solid or there are none.
/// @param shape of part.exact, as its bytes have it; null for a mesh
ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    const FaceChoice& choice, TaskControl& control);

} // namespace knead
