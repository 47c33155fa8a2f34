#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/deformation/deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/message/message.h"
#include "core/model/export_options.h"
#include "core/model/part.h"
#include "core/skin/knife_slit.h"
#include "core/skin/skin_fields.h"
#include "core/task/task_control.h"

#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// Where knives cut a piece out of its part.
struct PieceCut {
    std::vector<std::vector<Vec3>> sheets; ///< per cut: places that a knife went through, at rest [m]
    std::vector<Vec3> inside;              ///< places well within the piece, at rest [m]
    std::vector<Vec3> outside;             ///< and within other pieces [m]
    double spacing = 0;                    ///< of the objects [m]
};

/// A part and how its material lies now.
struct PartToExport {
    /// What a part had when it was imported.
    struct Measures {
        double volume = 0; ///< [m^3]
        int faces = 0;
        int edges = 0;
    };

    Part part;                                  ///< as imported
    std::shared_ptr<const Aggregate> aggregate; ///< its objects; null: the part is written as imported
    std::vector<Vec3> displacements;            ///< per object, from rest [m]
    std::shared_ptr<const SmoothMap> map;       ///< in place of objects; does not leave this process
    std::shared_ptr<const std::vector<Deformation>>
        deformations; ///< of what the objects make of it, one after the other; null: none
    std::shared_ptr<const SmoothMap>
        deformed; ///< the map of these, made where the part is written, see makeMaps(); does not leave this process
    std::shared_ptr<const std::vector<BrokenConnection>> broken; ///< structural connections; null: none
    std::shared_ptr<const RelaxedState> relaxed; ///< for fields; null: none; does not leave this process
    std::vector<ObjectIndex>
        loaded; ///< objects that something holds or presses on, for fields; does not leave this process
    std::shared_ptr<const SkinFields>
        fields; ///< at the vertices of the part's mesh, which is where it is now; null: none
    std::shared_ptr<const KnifeSlit>
        slit; ///< that a part whose faces are its own is cut into, whose objects are in one piece; or null
    std::optional<Measures> before;      ///< of a part that is where it is now, for the report
    std::shared_ptr<const PieceCut> cut; ///< of a piece whose part has faces of its own, which are to be cut; else null
    std::vector<Message> remarks;        ///< sentences for the report
    Message reason;                      ///< why it has no smooth faces, when something is known about that
    double density = 0;                  ///< [kg/m^3], for the report; 0: none
};

/// What is to be written into one file.
struct ExportJob {
    std::vector<PartToExport> parts;
    PartNode tree; ///< of these parts
    ExportOptions options;
};

/// Makes the maps of the deformations of parts, each once. @throws as mapOf(std::span<const Deformation>)
void makeMaps(ExportJob& job, TaskControl& control = TaskControl::none());

} // namespace knead
