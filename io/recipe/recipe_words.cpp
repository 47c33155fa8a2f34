#include "io/recipe/recipe_words.h"

#include "core/message/message.h"
#include "io/recipe/recipe_places.h"

#include <algorithm>
#include <filesystem>

namespace knead {

RecipeRegion RecipeWords::place(BodyId body, const std::vector<ObjectIndex>& objects, std::uint32_t objectsInBody) const
{
    if (objectsInBody > 0)
        return laterPlaceOf(objectsInBody, objects);
    return placeOf(aggregateOf(body), &modelOf(project, start)->parts[start.partOfBody.at(body)].mesh, objects);
}

RecipeMaterial materialWords(const Material& material, const Material& base, const std::vector<MaterialPreset>& presets)
{
    const auto isIt = [&](const MaterialPreset& preset) { return preset.material == material; };
    if (std::ranges::any_of(presets, isIt))
        return {material, {}};
    RecipeMaterial numbers;
    for (const MaterialField& field : materialFields())
        if (material.*field.value != base.*field.value)
            numbers.overrides.emplace_back(field.value, material.*field.value);
    return numbers;
}

std::string fileSeenFrom(const std::string& recipePath, const std::string& file)
{
    namespace fs = std::filesystem;
    const fs::path whole = fs::absolute(file).lexically_normal();
    if (recipePath.empty())
        return whole.string();
    return whole.lexically_proximate(fs::absolute(recipePath).parent_path().lexically_normal()).string();
}

RecipeManipulator RecipeWords::named(const Manipulator& manipulator, const std::string& name) const
{
    RecipeManipulator tool{manipulator, {}, {}};
    tool.name = name;
    if (tool.kind != ToolKind::part)
        return tool;
    const auto part = std::ranges::find(toolParts, tool.part);
    if (toolPartFile.empty() || part == toolParts.end())
        throw Problem(
            Message("Recipe", "the tool \"%1\" is an imported part, which only a saved project keeps.").with(name));
    tool.partFile = toolPartFile;
    tool.partNumber = static_cast<std::size_t>(part - toolParts.begin());
    return tool;
}

RecipeManipulator RecipeWords::manipulator(const Manipulator& manipulator) const
{
    return named(manipulator, names.tools.add(manipulator.name, "tool"));
}

RecipeFixture RecipeWords::fixture(const Fixture& fixture, std::uint32_t objectsInBody) const
{
    RecipeFixture words{place(fixture.body, fixture.objects, objectsInBody), fixture.velocity, fixture.turn};
    words.name = names.fixtures.add(fixture.name, "fixture");
    if (names.hasManyBodies())
        words.body = names.body(fixture.body);
    return words;
}

RecipeLoad RecipeWords::load(const Load& load) const
{
    RecipeLoad words{
        {.name = names.loads.add(load.name, "load"), .faces = load.faces, .box = load.box}, load.amount, load.ramp};
    if (names.hasManyBodies())
        words.body = names.body(load.body);
    return words;
}

} // namespace knead
