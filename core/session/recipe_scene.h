#pragma once

#include "core/aggregate/spacing_choice.h"
#include "core/message/message.h"
#include "core/session/recipe_parts.h"
#include "core/simulation/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// A recipe made ready to run.
struct RecipeScene {
    Scene scene;
    std::shared_ptr<const Model> model;                      ///< of all its bodies
    std::vector<std::vector<FixtureId>> fixtureIds;          ///< per fixture of the recipe; one for each body it holds
    std::vector<std::shared_ptr<const ToolPart>> eventParts; ///< as in RecipeParts
    SpacingAssessment fineness;                              ///< of all bodies together
    std::vector<Message> warnings;                           ///< sentences: of the import, and parts left out

    const std::vector<Part>& parts() const { return model->parts; } ///< one per body of the scene, same order
    std::vector<std::size_t> partOfBody() const;                    ///< as ProjectStart has it
};

/// Imports the parts and fills every closed body of it.
/// @throws UnusableInput, and std::runtime_error when the filling fails, each in a sentence. @throws Cancelled
RecipeScene buildScene(const Recipe& recipe, const RecipeFiles& files, TaskControl& control);

/// Bodies that a name in a recipe means: those whose name or path in the assembly it is; else the one that is counted so from
/// 0, "#2"; all for an empty name.
/// @throws UnusableInput when there is none
std::vector<BodyId> bodiesNamed(const std::string& name, const std::vector<Part>& parts, const Message& place);

/// Objects of a body.
struct BodyObjects {
    BodyId body = 0;
    std::vector<ObjectIndex> objects;
};

/// What a box takes of the bodies that a name means, leaving out bodies with nothing in it; the objects that are named one by
/// one; whole bodies, without objects, when there is neither.
/// @throws UnusableInput when there is no such body, nothing in the box, or another number of objects than those named belong to
std::vector<BodyObjects> objectsWithin(const RecipeScene& ready, const std::string& body, const std::optional<Box>& box,
                                       const std::optional<RecipeObjects>& objects, const Message& place);

/// The fixtures of the scene that a fixture of the recipe means: one for every body it holds.
/// @throws UnusableInput
std::vector<Fixture> fixturesOf(const Recipe& recipe, const RecipeFixture& fixture, const RecipeScene& ready);

/// The load of the scene that a load of the recipe means.
/// @throws UnusableInput
Load loadOf(const Recipe& recipe, const RecipeLoad& load, const RecipeScene& ready);

/// A manipulator of a recipe with its part.
Manipulator manipulatorOf(const RecipeManipulator& manipulator, const std::shared_ptr<const ToolPart>& part);

} // namespace knead
