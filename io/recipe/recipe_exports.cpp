// Files that a recipe writes at the end.
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/model/length_units.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr int mostPixels = 8192;

struct View {
    Vec3 direction;
    Vec3 up;
};

const std::map<std::string, View>& namedViews()
{
    static const std::map<std::string, View> views{
        {"back", {-Vec3::UnitY(), Vec3::UnitZ()}}, {"bottom", {Vec3::UnitZ(), -Vec3::UnitY()}},
        {"front", {Vec3::UnitY(), Vec3::UnitZ()}}, {"isometric", {Vec3(-1, 1, -1), Vec3::UnitZ()}},
        {"left", {Vec3::UnitX(), Vec3::UnitZ()}},  {"right", {-Vec3::UnitX(), Vec3::UnitZ()}},
        {"top", {-Vec3::UnitZ(), Vec3::UnitY()}},
    };
    return views;
}

View readNamedView(const JsonNode& node)
{
    const auto found = namedViews().find(node.text());
    if (found == namedViews().end())
        node.failExpecting(Message("Recipe", "must be one of %1 or a direction of 3 numbers")
                               .with(listed(namedViews(), [](const auto& view) { return view.first; })));
    return found->second;
}

View readViewDirection(const JsonNode& node)
{
    const Vec3 direction = readVector(node, farAway);
    if (direction.norm() == 0)
        node.failExpecting(Message("Recipe", "must be a direction of 3 numbers that are not all 0"));
    const bool vertical = direction.head<2>().norm() < 1e-6 * direction.norm();
    return {direction, vertical ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ())};
}

void readPictureKeys(const JsonNode& node, RecipeExport& picture)
{
    node.allowOnly({"file", "width", "height", "view", "show_tools"});
    if (const auto width = node.find("width"))
        picture.width = width->integer(16, mostPixels);
    if (const auto height = node.find("height"))
        picture.height = height->integer(16, mostPixels);
    if (const auto tools = node.find("show_tools"))
        picture.showTools = tools->boolean();
    if (const auto viewNode = node.find("view")) {
        const View view = viewNode->isString() ? readNamedView(*viewNode) : readViewDirection(*viewNode);
        picture.viewDirection = view.direction;
        picture.up = view.up;
    }
}

void readFileKeys(const JsonNode& node, RecipeExport& file)
{
    node.allowOnly({"file", "unit", "tolerance_mm", "ap214", "text", "report"});
    if (const auto unit = node.find("unit")) {
        file.options.unit = unit->text();
        if (findLengthUnit(file.options.unit) == nullptr)
            unit->failExpecting(Message("Recipe", "must be one of %1").with(lengthUnitNames()));
    }
    if (const auto tolerance = node.find("tolerance_mm"))
        file.options.tolerance = 1e-3 * tolerance->number(1e-6, 1e3);
    if (const auto ap214 = node.find("ap214"))
        file.options.useAp214 = ap214->boolean();
    if (const auto text = node.find("text"))
        file.options.isText = text->boolean();
    if (const auto report = node.find("report"))
        file.wantsReport = report->boolean();
}

/// A recipe from somewhere else must not write outside the output folder.
void checkStaysInside(const JsonNode& node, const std::string& file)
{
    const fs::path path(file);
    const bool leaves = path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
    if (leaves)
        node.failExpecting(Message("Recipe", "must be a path inside the output folder"));
}

} // namespace

RecipeExport readRecipeExport(const JsonNode& node)
{
    const JsonNode file = node.at("file");
    RecipeExport wanted;
    wanted.file = file.text();
    checkStaysInside(file, wanted.file);

    if (!wanted.isPicture() && formatToWrite(wanted.file) == nullptr)
        file.failExpecting(Message("Recipe", "must end in one of %1").with(formatEndings(", ") + ", .png"));
    if (wanted.isPicture())
        readPictureKeys(node, wanted);
    else
        readFileKeys(node, wanted);
    return wanted;
}

} // namespace knead
