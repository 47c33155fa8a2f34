#pragma once

#include "core/document/project.h"
#include "core/session/recipe.h"
#include "io/recipe/recipe_fields.h"
#include "io/recipe/recipe_names.h"

#include <memory>
#include <string>
#include <vector>

namespace knead {

/// A bundled material, or the numbers that differ from another one.
RecipeMaterial materialWords(const Material& material, const Material& base,
                             const std::vector<MaterialPreset>& presets);

/// A file as a recipe names it. @param recipePath empty: by its whole path
std::string fileSeenFrom(const std::string& recipePath, const std::string& file);

/// What recipes say of the things of a session.
struct RecipeWords {
    const Project& project;
    const ProjectStart& start;
    RecipeNames& names;
    recipe_keys::Context context;
    std::string toolPartFile; ///< the project, as the recipe names it; empty: it was not saved
    std::vector<std::shared_ptr<const ToolPart>> toolParts;

    const Aggregate& aggregateOf(BodyId body) const { return *start.scene.bodies.at(body).aggregate; }

    /// Objects of a body that faces may mean. @param objectsInBody see RecordedCommand
    RecipeRegion place(BodyId body, const std::vector<ObjectIndex>& objects, std::uint32_t objectsInBody = 0) const;

    RecipeMaterial material(const Material& material, const Material& base) const
    {
        return materialWords(material, base, context.presets);
    }
    RecipeManipulator manipulator(const Manipulator& manipulator) const; ///< and gives the next tool its name
    RecipeFixture fixture(const Fixture& fixture, std::uint32_t objectsInBody = 0) const; ///< and names the next one
    RecipeLoad load(const Load& load) const;                                              ///< and names the next one

    /// @throws Problem for a part that no saved project keeps
    RecipeManipulator named(const Manipulator& manipulator, const std::string& name) const;
};

} // namespace knead
