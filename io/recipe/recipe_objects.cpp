#include "io/recipe/recipe_objects.h"

#include "core/message/message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace knead::recipe_keys {

namespace {

constexpr std::uint64_t mostObjects = 1 << 28; // of a body
constexpr double fastestGripTurn = 5e5;        // [degrees/s]
constexpr double fastestGripInRadians = 5e3;   // [rad/s]

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

Vec3 readAxis(const JsonNode& node)
{
    const Vec3 axis = readVector(node, farAway);
    if (axis.norm() == 0)
        node.failExpecting(Message("Recipe", "must be a direction of 3 numbers that are not all 0"));
    return axis.normalized();
}

} // namespace

RecipeMaterial MaterialWords::read(const JsonNode& node) const
{
    if (node.isString())
        return {readPreset(node, context.presets), {}};
    if (!node.isObject())
        node.failExpecting(Message("Recipe", "must be the name of a material or an object in { }"));

    std::vector<std::string> allowed{"preset"};
    RecipeMaterial material;
    if (const auto preset = node.find("preset"))
        material.preset = readPreset(*preset, context.presets);
    for (const MaterialField& field : materialFields()) {
        allowed.emplace_back(field.key);
        if (const auto number = node.find(field.key))
            material.overrides.emplace_back(field.value, number->number(field.minimum, field.maximum));
    }
    node.allowOnly(allowed);
    return material;
}

/// A preset has no numbers of its own beside it here.
std::string MaterialWords::text(const RecipeMaterial& material) const
{
    for (const MaterialPreset& preset : context.presets)
        if (material.preset == preset.material)
            return quoted(preset.id);
    ObjectText numbers;
    for (const auto& [member, value] : material.overrides)
        for (const MaterialField& field : materialFields())
            if (field.value == member)
                numbers.number(field.key, value);
    return numbers.take();
}

std::optional<RecipeObjects> readObjects(const JsonNode& node)
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

void putObjects(ObjectText& text, const RecipeObjects& objects)
{
    text.put("objects", stretchesText(objects.numbers)).put("objects_in_body", std::to_string(objects.of));
    if (objects.isFilledAnew)
        text.put("filled_anew", "true");
}

void readPlaceOf(const JsonNode& node, RecipeRegion& region)
{
    const auto faces = node.find("faces");
    const auto box = node.find("box_mm");
    region.objects = readObjects(node);
    if (faces.has_value() + box.has_value() + region.objects.has_value() != 1)
        node.fail(Message("Recipe", "must have exactly one of the keys faces, box_mm and objects."));
    if (faces)
        region.faces = readFaces(*faces);
    if (box)
        region.box = readBox(*box);
}

void eachFaceOnce(std::vector<std::uint32_t>& faces)
{
    std::ranges::sort(faces);
    const auto same = std::ranges::unique(faces);
    faces.erase(same.begin(), same.end());
}

void putPlaceOf(ObjectText& text, const RecipeRegion& region)
{
    if (region.objects)
        putObjects(text, *region.objects);
    else if (region.box)
        text.put("box_mm", BoxInMillimeters::text(*region.box));
    else
        text.put("faces", listText(region.faces, wholeText));
}

void readTurn(const JsonNode& node, GripTurn& turn)
{
    const auto radians = node.find("angular_velocity_rad_s");
    if (radians && (node.find("axis") || node.find("speed_deg_s")))
        node.fail(Message("Recipe", "must have either axis and speed_deg_s, or angular_velocity_rad_s."));
    if (radians)
        turn.angularVelocity = readVector(*radians, fastestGripInRadians);
    else
        turn.angularVelocity = radiansPerDegree * node.at("speed_deg_s").number(-fastestGripTurn, fastestGripTurn) *
                               readAxis(node.at("axis"));
    const auto degrees = node.find("angle_deg");
    const auto angle = node.find("angle_rad");
    if (degrees && angle)
        node.fail(Message("Recipe", "must have only one of the keys angle_deg and angle_rad."));
    if (degrees)
        turn.angle = radiansPerDegree * degrees->positive();
    if (angle)
        turn.angle = angle->positive();
}

void putTurn(ObjectText& text, const GripTurn& turn)
{
    text.numbers("angular_velocity_rad_s", turn.angularVelocity);
    if (std::isfinite(turn.angle))
        text.number("angle_rad", turn.angle);
}

std::vector<std::string> readPartFiles(const JsonNode& node, const Context& context)
{
    const auto file = node.find("file");
    const auto files = node.find("files");
    if (file.has_value() == files.has_value())
        node.fail(Message("Recipe", "must have either file or files."));
    if (file)
        return {readFilePath(*file, context.recipePath)};
    std::vector<std::string> paths = ListOf{FilePath{context}}.read(*files);
    if (paths.empty())
        files->fail(Message("Recipe", "must hold at least one file."));
    return paths;
}

void putPartFiles(ObjectText& text, const std::vector<std::string>& files)
{
    if (files.size() == 1)
        text.text("file", files.front());
    else
        text.put("files", listText(files, quoted));
}

} // namespace knead::recipe_keys
