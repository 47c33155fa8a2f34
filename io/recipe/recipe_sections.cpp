// Materials, parts, bodies and regions of a recipe.
#include "io/recipe/recipe_sections.h"

#include "core/message/message.h"
#include "io/recipe/recipe_values.h"
#include "io/recipe/scene_words.h"

#include <cstdint>
#include <limits>

namespace knead {

namespace {

constexpr double fastestStart = 1e5;           // [mm/s] and [degrees/s]
constexpr std::uint64_t mostObjects = 1 << 28; // of a body

Material readPreset(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    const std::string id = node.text();
    for (const MaterialPreset& preset : presets)
        if (preset.id == id)
            return preset.material;
    node.fail(Message("Recipe", "names the unknown material \"%1\"; known are: %2.")
                  .with(id, listed(presets, [](const MaterialPreset& preset) { return preset.id; })));
}

std::vector<std::uint32_t> readFaces(const JsonNode& node)
{
    std::vector<std::uint32_t> faces;
    for (const JsonNode& face : node.items())
        faces.push_back(static_cast<std::uint32_t>(face.integer(0, std::numeric_limits<int>::max())));
    if (faces.empty())
        node.fail(Message("Recipe", "must hold at least one face."));
    return faces;
}

/// A number, or the first and the last of a stretch.
std::pair<std::uint64_t, std::uint64_t> readStretch(const JsonNode& node)
{
    if (!node.isList())
        return {node.count(mostObjects), node.count(mostObjects)};
    const std::vector<JsonNode> ends = node.items();
    if (ends.size() != 2)
        node.failExpecting(Message("Recipe", "must hold the first and the last number of a stretch"));
    return {ends[0].count(mostObjects), ends[1].count(mostObjects)};
}

RecipeRegion readRegion(const JsonNode& node)
{
    RecipeRegion region = readRecipePlace(node);
    region.name = node.at("name").text();
    return region;
}

} // namespace

RecipeMaterial readRecipeMaterial(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    if (node.isString())
        return {readPreset(node, presets), {}};
    if (!node.isObject())
        node.failExpecting(Message("Recipe", "must be the name of a material or an object in { }"));

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

std::optional<RecipeObjects> readRecipeObjects(const JsonNode& node)
{
    const auto list = node.find("objects");
    const auto count = node.find("objects_in_body");
    if (list.has_value() != count.has_value())
        node.fail(Message("Recipe", "must have both of the keys objects and objects_in_body, or none."));
    if (const auto anew = node.find("filled_anew"); anew && !list)
        anew->fail(Message("Recipe", "belongs to objects."));
    if (!list)
        return std::nullopt;
    RecipeObjects objects{{}, count->count(mostObjects)};
    if (const auto anew = node.find("filled_anew"))
        objects.isFilledAnew = anew->boolean();
    for (const JsonNode& item : list->items()) {
        const auto [first, last] = readStretch(item);
        if (last < first || last >= objects.of || (!objects.numbers.empty() && first <= objects.numbers.back()))
            item.failExpecting(Message("Recipe", "must go on upwards, below objects_in_body"));
        for (std::uint64_t number = first; number <= last; ++number)
            objects.numbers.push_back(static_cast<ObjectIndex>(number));
    }
    if (objects.numbers.empty())
        list->fail(Message("Recipe", "must hold at least one object."));
    return objects;
}

RecipeRegion readRecipePlace(const JsonNode& node)
{
    RecipeRegion region;
    if (const auto body = node.find("body"))
        region.body = body->text();
    const auto faces = node.find("faces");
    const auto box = node.find("box_mm");
    region.objects = readRecipeObjects(node);
    if (faces.has_value() + box.has_value() + region.objects.has_value() != 1)
        node.fail(Message("Recipe", "must have exactly one of the keys faces, box_mm and objects."));
    if (faces)
        region.faces = readFaces(*faces);
    if (box)
        region.box = readBox(*box);
    return region;
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
    node.allowOnly({"kind", "velocity_mm_s", "angular_velocity_deg_s", "angular_velocity_rad_s"});
    RecipeBody body;
    body.name = name;
    if (const auto kind = node.find("kind"))
        body.kind = readBodyKind(*kind);
    if (const auto velocity = node.find("velocity_mm_s"))
        body.velocity = readMillimeters(*velocity, fastestStart);
    const auto turns = node.find("angular_velocity_deg_s");
    const auto radians = node.find("angular_velocity_rad_s");
    if (turns && radians)
        node.fail(
            Message("Recipe", "must have only one of the keys angular_velocity_deg_s and angular_velocity_rad_s."));
    if (turns)
        body.angularVelocity = radiansPerDegree * readVector(*turns, fastestStart);
    if (radians)
        body.angularVelocity = readVector(*radians, fastestStart);
    return body;
}

RecipeFixture readRecipeFixture(const JsonNode& node)
{
    node.allowOnly({"name", "body", "faces", "box_mm", "objects", "objects_in_body", "filled_anew", "velocity_mm_s",
                    "turn", "moment_center_mm"});
    RecipeFixture fixture{readRegion(node)};
    if (const auto velocity = node.find("velocity_mm_s"))
        fixture.velocity = readMillimeters(*velocity, fastestStart);
    if (const auto turn = node.find("turn"))
        fixture.turn = readGripTurn(*turn);
    if (const auto center = node.find("moment_center_mm"))
        fixture.momentCenter = readPlace(*center);
    return fixture;
}

RecipeMaterialRegion readRecipeMaterialRegion(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    node.allowOnly({"name", "body", "faces", "box_mm", "objects", "objects_in_body", "material"});
    return {readRegion(node), readRecipeMaterial(node.at("material"), presets)};
}

} // namespace knead
