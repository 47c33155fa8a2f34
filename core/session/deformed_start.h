#pragma once

#include "core/document/recipe_deformation.h"
#include "core/session/deformed_model.h"
#include "core/session/filled_model.h"
#include "core/session/frame.h"
#include "core/session/skin_place.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Which parts are to be deformed, and how.
struct DeformationRequest {
    std::shared_ptr<const std::vector<Deformation>> deformations; ///< one after the other, at least one
    std::vector<bool> which;                                      ///< per part of the model; empty: all
    /// The same as a recipe says it, of all parts; empty: it cannot.
    std::vector<RecipeDeformation> said = {};
};

/// The parts after a deformation, filled again, with the report on their faces.
struct PreparedDeformation {
    PreparedModel prepared;
    ExportReport report;
    std::vector<RecipeDeformation>
        said;                     ///< what was done; empty: a recipe cannot say it, as of what was kneaded before
    CarriedSurfaces carried = {}; ///< for what is on the skins of the content before
};

/// What means a part of a model and no other one: its name, or its path; none: both mean others, too.
std::optional<std::string> nameOfPartAlone(const Model& model, std::size_t part);

/// Deforms the parts of a content as a frame shows them, and fills them again with the same spacing. Materials, kinds of bodies, tools,
/// gravity and floor stay; the floor goes down where parts reach below it. Fixtures stay on their faces, wherever these are now and
/// however many they have become. Runs on a task thread.
/// @param shown a frame of the content
/// @throws as deformedModel() and prepareRefill()
PreparedDeformation prepareDeformation(const FilledModel& before, const FramePointer& shown,
                                       const std::vector<FaceFixture>& fixtures, const DeformationRequest& request,
                                       const WriteAndRead& writeAndRead, TaskControl& control);

} // namespace knead
