#pragma once

#include "io/json/json_text.h"
#include "io/recipe/recipe_names.h"

#include <span>
#include <string>
#include <vector>

namespace knead {

/// What recipes say of the things of a session.
struct RecipeWords {
    const Project& project;
    const ProjectStart& start;
    RecipeNames& names;
    const std::vector<MaterialPreset>& presets;
    std::string toolPartFile; ///< the project, as the recipe names it; empty: it was not saved
    std::vector<std::shared_ptr<const ToolPart>> toolParts;

    const TriangleMesh& meshOf(BodyId body) const { return project.model->parts[start.partOfBody.at(body)].mesh; }
    const Aggregate& aggregateOf(BodyId body) const { return *start.scene.bodies.at(body).aggregate; }

    /// The id of a bundled material, or the numbers that differ from another one.
    std::string material(const Material& material, const Material& base) const;
    std::string manipulator(const Manipulator& manipulator) const; ///< and gives the next tool its name
    /// And gives the next fixture its name. @param objectsInBody see RecordedCommand
    std::string fixture(const Fixture& fixture, std::uint32_t objectsInBody = 0) const;
    std::string load(const Load& load) const; ///< and gives the next load its name
    ObjectText reshaping(const Manipulator& form, const std::string& name) const;
};

/// Puts place and, where it is turned, rotation.
void putPose(ObjectText& text, const Pose& pose);
void putMotion(ObjectText& text, const Motion& motion);

/// Puts `turn`, for a grip that does.
void putTurn(ObjectText& text, const GripTurn& turn);

/// Puts what of an amount is not 0, and the ramp.
void putAmount(ObjectText& text, const LoadAmount& amount, double ramp);

/// One gesture of a session.
struct RecipeGesture {
    std::string name;
    std::span<const RecordedCommand> commands;
};

/// Commands as events of a recipe, one item each; a tool that goes from place to place is one.
/// @throws Problem, for what a recipe cannot say
std::vector<std::string> eventTexts(const RecipeWords& words, std::span<const RecipeGesture> gestures);

} // namespace knead
