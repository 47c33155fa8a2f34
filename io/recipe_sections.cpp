// Materials, parts, bodies and regions of a recipe.
#include "io/recipe_sections.h"

#include "io/recipe_values.h"
#include "io/scene_words.h"

#include <cstdint>
#include <limits>
#include <numbers>

namespace knead {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double fastest = 1e5; // [mm/s] and [degrees/s]

Material readPreset(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    const std::string id = node.text();
    for (const MaterialPreset& preset : presets)
        if (preset.id == id)
            return preset.material;
    node.fail("names the unknown material \"" + id +
              "\"; known are: " + listed(presets, [](const MaterialPreset& preset) { return preset.id; }) + ".");
}

std::vector<std::uint32_t> readFaces(const JsonNode& node)
{
    std::vector<std::uint32_t> faces;
    for (const JsonNode& face : node.items())
        faces.push_back(static_cast<std::uint32_t>(face.integer(0, std::numeric_limits<int>::max())));
    if (faces.empty())
        node.fail("must hold at least one face.");
    return faces;
}

RecipeRegion readRegion(const JsonNode& node)
{
    RecipeRegion region;
    region.name = node.at("name").text();
    if (const auto body = node.find("body"))
        region.body = body->text();
    const auto faces = node.find("faces");
    const auto box = node.find("box_mm");
    if (faces.has_value() == box.has_value())
        node.fail("must have either faces or box_mm.");
    if (faces)
        region.faces = readFaces(*faces);
    else
        region.box = readBox(*box);
    return region;
}

} // namespace

RecipeMaterial readRecipeMaterial(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    if (node.isString())
        return {readPreset(node, presets), {}};
    if (!node.isObject())
        node.failExpecting("must be the name of a material or an object in { }");

    std::vector<std::string> allowed{"preset"};
    RecipeMaterial material;
    if (const auto preset = node.find("preset"))
        material.preset = readPreset(*preset, presets);
    for (const MaterialField& field : materialFields()) {
        allowed.emplace_back(field.key);
        if (const auto number = node.find(field.key))
            material.overrides.emplace_back(field.value, number->number(field.minimum, field.maximum));
    }
    node.allowOnly(allowed);
    return material;
}

RecipeExtraPart readRecipeExtraPart(const JsonNode& node, const std::string& recipePath)
{
    node.allowOnly({"file", "name", "position_mm", "rotation_deg"});
    RecipeExtraPart part;
    part.file = readFilePath(node.at("file"), recipePath);
    if (const auto name = node.find("name"))
        part.name = name->text();
    if (const auto position = node.find("position_mm"))
        part.pose.position = readPlace(*position);
    if (const auto rotation = node.find("rotation_deg"))
        part.pose.rotation = readRotation(*rotation);
    return part;
}

BodyKind readBodyKind(const JsonNode& node)
{
    return readChoice(node, bodyKindWords());
}

RecipeBody readRecipeBody(const JsonNode& node, const std::string& name)
{
    node.allowOnly({"kind", "velocity_mm_s", "angular_velocity_deg_s"});
    RecipeBody body;
    body.name = name;
    if (const auto kind = node.find("kind"))
        body.kind = readBodyKind(*kind);
    if (const auto velocity = node.find("velocity_mm_s"))
        body.velocity = millimeter * readVector(*velocity, fastest);
    if (const auto velocity = node.find("angular_velocity_deg_s"))
        body.angularVelocity = degree * readVector(*velocity, fastest);
    return body;
}

RecipeFixture readRecipeFixture(const JsonNode& node)
{
    node.allowOnly({"name", "body", "faces", "box_mm"});
    return readRegion(node);
}

RecipeMaterialRegion readRecipeMaterialRegion(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    node.allowOnly({"name", "body", "faces", "box_mm", "material"});
    return {readRegion(node), readRecipeMaterial(node.at("material"), presets)};
}

} // namespace knead
