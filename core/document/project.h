#pragma once

#include "core/aggregate/spacing_choice.h"
#include "core/document/history_record.h"
#include "core/document/recipe_deformation.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/simulation/scene.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What a person asked to be opened, and how.
struct ImportChoices {
    std::vector<std::string> paths; ///< at least one
    ImportOptions options;
    std::optional<SpacingChoice> spacing; ///< none: for real time, somewhat finer for thin walls
    Touching touching = Touching::separate;
    bool fillsOpenParts = false; ///< tries winding numbers on surfaces that are not closed
};

/// A state that steps are counted from: the model filled once, with its tools and fixtures.
struct ProjectStart {
    Scene scene;
    std::vector<std::size_t> partOfBody; ///< per body of the scene: index into Model::parts
    std::shared_ptr<const Model> model =
        {}; ///< whose parts these are, deformed or added since; null: those of the project
    /// What made that model of the parts of the project, one after the other; none: a recipe cannot say it, as of added parts.
    std::vector<RecipeDeformation> deformations = {};
};

/// Words that a person put at an entry of the history.
struct ProjectMark {
    std::uint32_t entry = 0; ///< index into Project::entries
    std::string text;
};

/// From where the person looked.
struct ProjectCamera {
    Vec3 position = Vec3::UnitX();  ///< of the eye [m]
    Vec3 focalPoint = Vec3::Zero(); ///< what turns in place when the view is turned [m]
    Vec3 up = Vec3::UnitZ();        ///< unit
    double parallelScale = 1;       ///< half of the height that is seen at the focal point [m]
    bool perspective = true;
};

struct ProjectView {
    ProjectCamera camera;
    std::vector<std::size_t> hiddenParts; ///< indices into Model::parts
    std::vector<std::byte> thumbnail;     ///< a PNG picture; empty: none
};

/// All that a project file keeps. A plain value; what is large in it is immutable and shared.
struct Project {
    std::shared_ptr<const Model> model; ///< with its exact shapes; null: nothing was opened yet
    ImportChoices import;
    std::vector<ProjectStart> starts;
    std::vector<HistoryRecord> entries; ///< parents come before what follows them
    std::uint32_t current = 0;          ///< the entry that is shown; 0 also when there is none
    std::vector<ProjectMark> marks;
    ProjectView view;
    std::map<std::string, std::string> panels; ///< what panels keep for themselves: JSON texts by name
};

/// The parts that a start was filled from.
inline const std::shared_ptr<const Model>& modelOf(const Project& project, const ProjectStart& start)
{
    return start.model ? start.model : project.model;
}

/// The parts that are shown: those of the start of the current entry. @pre there is such a start, or there are no entries
std::shared_ptr<const Model> shownModel(const Project& project);

/// ProjectStart::deformations of a start that follows another one with a deformed model of its own.
/// @param said what made this model of the one before; empty: a recipe cannot say it
std::vector<RecipeDeformation> deformationsUntil(const ProjectStart& before, const std::shared_ptr<const Model>& model,
                                                 std::vector<RecipeDeformation> said);

/// Imported parts that its tools are made of, in the order in which they were first used.
std::vector<std::shared_ptr<const ToolPart>> toolPartsOf(const Project& project);

} // namespace knead
