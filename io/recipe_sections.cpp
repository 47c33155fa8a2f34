#include "io/recipe_sections.h"

#include "io/mesh_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double farAway = 1e6; // [mm]; a kilometer is no workbench
constexpr int mostPixels = 8192;

template <class Items, class NameOf>
std::string listed(const Items& items, NameOf nameOf)
{
    std::string text;
    for (const auto& item : items)
        text += (text.empty() ? "" : ", ") + nameOf(item);
    return text;
}

Material readPreset(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    const std::string id = node.text();
    for (const MaterialPreset& preset : presets)
        if (preset.id == id)
            return preset.material;
    node.fail("names the unknown material \"" + id +
              "\"; known are: " + listed(presets, [](const MaterialPreset& preset) { return preset.id; }) + ".");
}

/// Turns about the fixed axes x, y and z, in this order.
Quaternion readRotation(const JsonNode& node)
{
    const Vec3 angles = degree * readVector(node, 3600);
    return Quaternion(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                      Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

Vec3 readPlace(const JsonNode& node)
{
    return millimeter * readVector(node, farAway);
}

Vec3 readSize(const JsonNode& node)
{
    const std::vector<double> numbers = node.numbers(3);
    const auto usable = [](double number) { return number > 0 && number <= farAway; };
    if (!std::all_of(numbers.begin(), numbers.end(), usable))
        node.failExpecting("must hold 3 positive numbers");
    return millimeter * Vec3(numbers[0], numbers[1], numbers[2]);
}

/// What a frame does not say stays as it was in the frame before.
KeyFrame readKeyFrame(const JsonNode& node, const Pose& before)
{
    node.allowOnly({"time_s", "position_mm", "rotation_deg"});
    KeyFrame frame{node.at("time_s").number(0, 3600), before};
    if (const auto position = node.find("position_mm"))
        frame.pose.position = readPlace(*position);
    if (const auto rotation = node.find("rotation_deg"))
        frame.pose.rotation = readRotation(*rotation);
    return frame;
}

/// A frame is reached from the one before it at a speed the manipulator is allowed to have.
void checkSpeed(const JsonNode& node, const KeyFrame& before, const KeyFrame& frame, double limit)
{
    const double time = frame.time - before.time;
    if (time <= 0)
        node.at("time_s").failExpecting("must be later than the frame before it");
    const double speed = (frame.pose.position - before.pose.position).norm() / time;
    if (speed > limit * (1 + 1e-9))
        node.fail("asks for a speed of " + std::to_string(std::lround(speed / millimeter)) +
                  " mm/s; speed_limit_mm_s allows " + std::to_string(std::lround(limit / millimeter)) + ".");
}

/// The motion starts at time 0 in the given pose.
FollowKeyFrames readKeyFrames(const JsonNode& node, const Pose& start, double speedLimit)
{
    FollowKeyFrames motion{{KeyFrame{0, start}}};
    for (const JsonNode& item : node.items()) {
        const KeyFrame frame = readKeyFrame(item, motion.frames.back().pose);
        checkSpeed(item, motion.frames.back(), frame, speedLimit);
        motion.frames.push_back(frame);
    }
    return motion;
}

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
        node.failExpecting("must be one of " + listed(namedViews(), [](const auto& view) { return view.first; }) +
                           " or a direction of 3 numbers");
    return found->second;
}

View readViewDirection(const JsonNode& node)
{
    const Vec3 direction = readVector(node, farAway);
    if (direction.norm() == 0)
        node.failExpecting("must be a direction of 3 numbers that are not all 0");
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

/// A recipe from somewhere else must not write outside the output folder.
void checkStaysInside(const JsonNode& node, const std::string& file)
{
    const fs::path path(file);
    const bool leaves = path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
    if (leaves)
        node.failExpecting("must be a path inside the output folder");
}

std::vector<std::string> exportEndings()
{
    std::vector<std::string> endings;
    for (const FileFormat& format : exportFormats())
        endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    endings.emplace_back("png");
    return endings;
}

} // namespace

Vec3 readVector(const JsonNode& node, double limit)
{
    const std::vector<double> numbers = node.numbers(3);
    for (const double number : numbers)
        if (std::abs(number) > limit)
            node.failExpecting("must hold 3 numbers no larger than " + std::to_string(std::lround(limit)));
    return {numbers[0], numbers[1], numbers[2]};
}

std::string lowerCaseEnding(const std::string& file)
{
    std::string ending = fs::path(file).extension().string();
    ending.erase(0, 1);
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

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

RecipeFixture readRecipeFixture(const JsonNode& node)
{
    node.allowOnly({"name", "body", "faces", "box_mm"});
    RecipeFixture fixture;
    fixture.name = node.at("name").text();
    if (const auto body = node.find("body"))
        fixture.body = body->text();

    const auto faces = node.find("faces");
    const auto box = node.find("box_mm");
    if (faces.has_value() == box.has_value())
        node.fail("must have either faces or box_mm.");
    if (faces) {
        for (const JsonNode& face : faces->items())
            fixture.faces.push_back(static_cast<std::uint32_t>(face.integer(0, std::numeric_limits<int>::max())));
        if (fixture.faces.empty())
            faces->fail("must hold at least one face.");
        return fixture;
    }
    const std::vector<double> n = box->numbers(6);
    fixture.box = Box(millimeter * Vec3(n[0], n[1], n[2]), millimeter * Vec3(n[3], n[4], n[5]));
    if (fixture.box->isEmpty())
        box->failExpecting("must hold the lowest x, y, z and then the highest x, y, z");
    return fixture;
}

Manipulator readRecipeManipulator(const JsonNode& node)
{
    node.allowOnly({"name", "size_mm", "position_mm", "rotation_deg", "friction", "speed_limit_mm_s", "force_limit_n",
                    "keyframes"});
    Manipulator manipulator;
    manipulator.name = node.at("name").text();
    manipulator.size = readSize(node.at("size_mm"));
    manipulator.pose.position = readPlace(node.at("position_mm"));
    if (const auto rotation = node.find("rotation_deg"))
        manipulator.pose.rotation = readRotation(*rotation);
    if (const auto friction = node.find("friction"))
        manipulator.friction = friction->number(0, 2);
    if (const auto limit = node.find("speed_limit_mm_s"))
        manipulator.speedLimit = limit->positive() * millimeter;
    if (const auto limit = node.find("force_limit_n"))
        manipulator.forceLimit = limit->positive();
    if (const auto frames = node.find("keyframes"))
        manipulator.motion = readKeyFrames(*frames, manipulator.pose, manipulator.speedLimit);
    return manipulator;
}

RecipeEvent readRecipeEvent(const JsonNode& node, const std::vector<MaterialPreset>& presets, double duration)
{
    node.allowOnly({"time_s", "material", "body", "remove_fixture", "remove_manipulator", "gravity_m_s2"});
    const auto material = node.find("material");
    const auto fixture = node.find("remove_fixture");
    const auto manipulator = node.find("remove_manipulator");
    const auto gravity = node.find("gravity_m_s2");
    if (material.has_value() + fixture.has_value() + manipulator.has_value() + gravity.has_value() != 1)
        node.fail("must have exactly one of the keys material, remove_fixture, remove_manipulator and gravity_m_s2.");
    const auto body = node.find("body");
    if (body && !material)
        body->fail("belongs to a change of material only.");

    RecipeEvent event;
    event.time = node.at("time_s").number(0, duration);
    if (material)
        event.action = ChangeMaterial{body ? body->text() : "", readRecipeMaterial(*material, presets)};
    if (fixture)
        event.action = ReleaseFixture{fixture->text()};
    if (manipulator)
        event.action = TakeManipulatorAway{manipulator->text()};
    if (gravity)
        event.action = ChangeGravity{readVector(*gravity, strongestGravity)};
    return event;
}

RecipeExport readRecipeExport(const JsonNode& node)
{
    const JsonNode file = node.at("file");
    RecipeExport wanted;
    wanted.file = file.text();
    checkStaysInside(file, wanted.file);

    const std::vector<std::string> endings = exportEndings();
    if (std::find(endings.begin(), endings.end(), lowerCaseEnding(wanted.file)) == endings.end())
        file.failExpecting("must end in one of " + listed(endings, [](const std::string& e) { return "." + e; }));
    if (wanted.isPicture())
        readPictureKeys(node, wanted);
    else
        node.allowOnly({"file"});
    return wanted;
}

} // namespace knead
