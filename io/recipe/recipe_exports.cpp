#include "io/recipe/recipe_exports.h"

#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "io/recipe/recipe_kinds.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace knead::recipe_keys {

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

View readView(const JsonNode& node)
{
    return node.isString() ? readNamedView(node) : readViewDirection(node);
}

struct Picture : RecipeExport {};

template <class Fields>
void describeKeys(Fields& fields, Picture& picture)
{
    fields.needed("file", picture.file, Text{});
    fields.optional("width", picture.width, Whole{16, mostPixels});
    fields.optional("height", picture.height, Whole{16, mostPixels});
    fields.together({"view"}, [&](const JsonNode& node) {
        if (const auto found = node.find("view")) {
            const View view = readView(*found);
            picture.viewDirection = view.direction;
            picture.up = view.up;
        }
    });
    fields.optional("show_tools", picture.showTools, Flag{});
}

struct PartFile : RecipeExport {};

struct Tolerance {
    static double read(const JsonNode& node) { return 1e-3 * node.number(1e-6, 1e3); }
};

template <class Fields>
void describeKeys(Fields& fields, PartFile& file)
{
    fields.needed("file", file.file, Text{});
    fields.optional("unit", file.options.unit, LengthUnitName{});
    fields.optional("tolerance_mm", file.options.tolerance, Tolerance{});
    fields.optional("ap214", file.options.useAp214, Flag{});
    fields.optional("text", file.options.isText, Flag{});
    fields.optional("report", file.wantsReport, Flag{});
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

RecipeExport readExport(const JsonNode& node, const Context& context)
{
    const JsonNode file = node.at("file");
    const RecipeExport wanted{.file = file.text()};
    checkStaysInside(file, wanted.file);
    if (wanted.isPicture())
        return Object<Picture>{context}.read(node);
    if (formatToWrite(wanted.file) == nullptr)
        file.failExpecting(Message("Recipe", "must end in one of %1").with(formatEndings(", ") + ", .png"));
    return Object<PartFile>{context}.read(node);
}

} // namespace knead::recipe_keys
