#include "io/recipe/recipe.h"

#include "core/simulation/scene_limits.h"
#include "io/formats/cad_format.h"
#include "io/json/json_reader.h"
#include "io/json/json_value.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"
#include "io/recipe/scene_words.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace knead {

namespace {

constexpr double longestDuration = 3600; // [s]; a longer run is a mistyped number
constexpr int mostLoadSteps = 10000;
constexpr double shortestTimeStep = 1e-9; // [s]
constexpr double longestTimeStep = 1;     // [s]

SpacingChoice readSpacing(const JsonNode& root)
{
    const auto spacing = root.find("spacing_mm");
    const auto cells = root.find("cells_across");
    const auto wallCells = root.find("cells_across_wall");
    const auto objects = root.find("objects");
    if (spacing.has_value() + cells.has_value() + wallCells.has_value() + objects.has_value() != 1)
        root.fail("must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects.");
    using Kind = SpacingChoice::Kind;
    if (spacing)
        return {Kind::Length, spacing->positiveThousandth()};
    if (cells)
        return {Kind::CellsAlong, cells->number(2, 1000)};
    if (wallCells)
        return {Kind::CellsAcrossWall, wallCells->number(0.5, 100)};
    return {Kind::Objects, objects->number(8, 2e7)};
}

std::vector<std::pair<std::string, Material>> readBodyMaterials(const JsonNode& node, const Material& base,
                                                                const std::vector<MaterialPreset>& presets)
{
    std::vector<std::pair<std::string, Material>> materials;
    for (const std::string& body : node.keys())
        materials.emplace_back(body, readRecipeMaterial(node.at(body), presets).on(base));
    return materials;
}

RecipeFloor readFloor(const JsonNode& node)
{
    node.allowOnly({"height_mm", "friction", "adhesion_pa"});
    RecipeFloor floor;
    floor.height = node.at("height_mm").thousandth();
    if (const auto friction = node.find("friction"))
        floor.friction = friction->number(0, 2);
    if (const auto adhesion = node.find("adhesion_pa"))
        floor.adhesion = adhesion->number(0, 1e9);
    return floor;
}

template <class Named>
void checkNameIsNew(const JsonNode& node, const std::vector<Named>& others, const std::string& name)
{
    const auto same = [&](const Named& other) { return other.name == name; };
    if (std::any_of(others.begin(), others.end(), same))
        node.at("name").fail("is used twice: \"" + name + "\".");
}

/// What is held from the start on is named in the first filling.
RecipeFixture readFirstFixture(const JsonNode& node)
{
    RecipeFixture fixture = readRecipeFixture(node);
    if (fixture.objects && fixture.objects->isFilledAnew)
        node.at("filled_anew").fail("belongs to events: at the start nothing has been filled anew.");
    return fixture;
}

/// A list whose items have names, each used once.
template <class Read>
auto readNamed(const JsonNode& node, Read read)
{
    std::vector<decltype(read(node))> all;
    for (const JsonNode& item : node.items()) {
        auto one = read(item);
        checkNameIsNew(item, all, one.name);
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<RecipeExport> readExports(const JsonNode& node)
{
    std::vector<RecipeExport> exports;
    for (const JsonNode& item : node.items()) {
        RecipeExport wanted = readRecipeExport(item);
        const auto same = [&](const RecipeExport& other) { return other.file == wanted.file; };
        if (std::any_of(exports.begin(), exports.end(), same))
            item.at("file").fail("is written twice: \"" + wanted.file + "\".");
        exports.push_back(std::move(wanted));
    }
    return exports;
}

std::optional<double> readTimeStep(const JsonNode& root, const char* key)
{
    const auto node = root.find(key);
    return node ? std::optional(node->number(shortestTimeStep, longestTimeStep)) : std::nullopt;
}

/// As recordings do.
bool namesSteps(const Recipe& recipe)
{
    return recipe.durationSteps || recipe.timeStep || recipe.massScalingTimeStep ||
           std::ranges::any_of(recipe.events, [](const RecipeEvent& event) { return event.step.has_value(); });
}

/// Recordings of before know nothing of it.
bool readRefilling(const JsonNode& root, const Recipe& recipe)
{
    const auto node = root.find("refilling");
    return node ? node->boolean() : !namesSteps(recipe);
}

/// Who numbers steps, or says how long they are, means those of the explicit scheme, whose they have always been. So does who wants
/// to see less than some frames: implicit steps last a frame each, and take no note of what a blow does in between.
Integrator readIntegrator(const JsonNode& root, const Recipe& recipe)
{
    constexpr double shortestOfFrames = 1.0 / 6; // [s]
    const auto node = root.find("integrator");
    const Integrator chosen = node ? readChoice(*node, integratorWords()) : Integrator::automatic;
    const bool isShort = !recipe.durationSteps && recipe.duration < shortestOfFrames;
    const bool staysExplicit = isShort || (!node && namesSteps(recipe));
    return chosen == Integrator::automatic && staysExplicit ? Integrator::semiImplicitEuler : chosen;
}

/// How the scene is calculated.
void readMethod(const JsonNode& root, Recipe& recipe)
{
    if (const auto node = root.find("vicinity"))
        recipe.vicinity = readChoice(*node, vicinityWords());
    recipe.timeStep = readTimeStep(root, "time_step_s");
    recipe.massScalingTimeStep = readTimeStep(root, "mass_scaling_time_step_s");
}

/// Where the objects are: parts and how they are filled.
void readParts(const JsonNode& root, Recipe& recipe)
{
    readRecipePart(root.at("part"), recipe);
    if (const auto node = root.find("extra_parts"))
        for (const JsonNode& item : node->items())
            recipe.extraParts.push_back(readRecipeExtraPart(item, recipe.file));
    recipe.spacing = readSpacing(root);
    if (const auto node = root.find("arrangement"))
        recipe.arrangement = readChoice<Arrangement>(
            *node, {{"cut-cells", Arrangement::cutCells}, {"published", Arrangement::published}});
    if (recipe.arrangement == Arrangement::published && recipe.spacing.kind != SpacingChoice::Kind::Length)
        root.at("arrangement").fail("is \"published\", which needs spacing_mm.");
}

/// What the bodies are made of, how they begin and what holds them.
void readBodies(const JsonNode& root, const std::vector<MaterialPreset>& presets, Recipe& recipe)
{
    if (const auto node = root.find("material"))
        recipe.material = readRecipeMaterial(*node, presets).on(Material{});
    if (const auto node = root.find("body_materials"))
        recipe.bodyMaterials = readBodyMaterials(*node, recipe.material, presets);
    if (const auto node = root.find("regions"))
        recipe.regions =
            readNamed(*node, [&](const JsonNode& item) { return readRecipeMaterialRegion(item, presets); });
    if (const auto node = root.find("bodies"))
        for (const std::string& name : node->keys())
            recipe.bodies.push_back(readRecipeBody(node->at(name), name));
    if (const auto node = root.find("touching"))
        recipe.touching = readChoice(*node, touchingWords());
    if (const auto node = root.find("structural_friction"))
        recipe.structuralFriction = node->number(0, 2);
    if (const auto node = root.find("fixtures"))
        recipe.fixtures = readNamed(*node, readFirstFixture);
    if (const auto node = root.find("loads"))
        recipe.loads = readNamed(*node, readRecipeLoad);
}

/// Names of fixtures and manipulators as they come up, each used once.
class EventNames {
public:
    explicit EventNames(const Recipe& recipe)
    {
        for (const RecipeFixture& fixture : recipe.fixtures)
            m_fixtures.insert(fixture.name);
        for (const RecipeManipulator& manipulator : recipe.manipulators)
            m_manipulators.insert(manipulator.name);
        for (const RecipeLoad& load : recipe.loads)
            m_loads.insert(load.name);
    }

    void check(const JsonNode& node, const RecipeAction& action)
    {
        if (const auto* release = std::get_if<ReleaseFixture>(&action))
            require(node.at("remove_fixture"), m_fixtures, release->fixture);
        if (const auto* move = std::get_if<MoveRecipeFixture>(&action))
            require(node.at("move_fixture").at("name"), m_fixtures, move->fixture);
        if (const auto* add = std::get_if<AddRecipeFixture>(&action))
            take(node.at("add_fixture").at("name"), m_fixtures, add->fixture.name);
        if (const auto* add = std::get_if<AddRecipeLoad>(&action))
            take(node.at("add_load").at("name"), m_loads, add->load.name);
        if (const auto* change = std::get_if<ChangeRecipeLoad>(&action))
            require(node.at("change_load").at("name"), m_loads, change->load);
        if (const auto* away = std::get_if<TakeLoadAway>(&action))
            require(node.at("remove_load"), m_loads, away->load);
        if (const auto* away = std::get_if<TakeManipulatorAway>(&action))
            require(node.at("remove_manipulator"), m_manipulators, away->manipulator);
        if (const auto* move = std::get_if<MoveRecipeManipulator>(&action))
            require(node.at("move_manipulator").at("name"), m_manipulators, move->manipulator);
        if (const auto* place = std::get_if<PlaceRecipeManipulator>(&action))
            require(node.at("place_manipulator").at("name"), m_manipulators, place->manipulator);
        if (const auto* reshape = std::get_if<ReshapeRecipeManipulator>(&action))
            require(node.at("reshape_manipulator").at("name"), m_manipulators, reshape->manipulator.name);
        if (const auto* add = std::get_if<AddRecipeManipulator>(&action))
            take(node.at("add_manipulator").at("name"), m_manipulators, add->manipulator.name);
    }

private:
    static void require(const JsonNode& node, const std::set<std::string>& known, const std::string& name)
    {
        if (!known.contains(name))
            node.fail("names \"" + name + "\", which is not in the recipe.");
    }
    static void take(const JsonNode& node, std::set<std::string>& known, const std::string& name)
    {
        if (!known.insert(name).second)
            node.fail("is used twice: \"" + name + "\".");
    }

    std::set<std::string> m_fixtures;
    std::set<std::string> m_manipulators;
    std::set<std::string> m_loads;
};

/// Times and steps go on upwards, from 0 again after a reset.
class EventOrder {
public:
    void check(const JsonNode& node, const RecipeEvent& event)
    {
        if (!event.step && event.time < m_time)
            node.at("time_s").failExpecting("must not be earlier than that of the event before it");
        if (event.step && *event.step < m_step)
            node.at("step").failExpecting("must not be less than that of the event before it");
        m_time = event.step ? m_time : event.time;
        m_step = event.step.value_or(m_step);
        if (std::holds_alternative<StartAgain>(event.action))
            *this = {};
    }

private:
    double m_time = 0;
    std::uint64_t m_step = 0;
};

/// The longest time that an event may have: that of the run, where no reset begins it anew.
double latestTime(const JsonNode& node, const Recipe& recipe)
{
    const std::vector<JsonNode> items = node.items();
    const bool resets = std::any_of(items.begin(), items.end(),
                                    [](const JsonNode& item) { return item.isObject() && item.find("reset"); });
    return resets || recipe.durationSteps ? longestDuration : recipe.duration;
}

std::vector<RecipeEvent> readEvents(const JsonNode& node, const Recipe& recipe,
                                    const std::vector<MaterialPreset>& presets)
{
    const EventContext context{presets, recipe.file, latestTime(node, recipe)};
    EventNames names(recipe);
    EventOrder order;
    std::vector<RecipeEvent> events;
    const std::vector<JsonNode> items = node.items();
    for (std::size_t i = 0; i < items.size(); ++i)
        for (RecipeEvent& event : readRecipeEvent(items[i], context)) {
            names.check(items[i], event.action);
            order.check(items[i], event);
            event.item = i;
            events.push_back(std::move(event));
        }
    return events;
}

void readDuration(const JsonNode& root, Recipe& recipe)
{
    const auto steps = root.find("duration_steps");
    if (steps && root.find("duration_s"))
        root.fail("must have only one of the keys duration_s and duration_steps.");
    if (steps) {
        recipe.durationSteps = steps->count(mostSteps);
        return;
    }
    recipe.duration = root.at("duration_s").positive();
    if (recipe.duration > longestDuration)
        root.at("duration_s").failExpecting("must be at most 3600 s");
}

/// Balance has no steps of time: what says so does not go with it.
void readAnalysis(const JsonNode& root, Recipe& recipe)
{
    if (const auto node = root.find("analysis"))
        recipe.analysis =
            readChoice<Analysis>(*node, {{"dynamic", Analysis::dynamic}, {"static", Analysis::equilibrium}});
    const auto steps = root.find("load_steps");
    if (recipe.analysis == Analysis::equilibrium) {
        if (steps)
            recipe.loadSteps = steps->integer(1, mostLoadSteps);
        for (const char* key : {"integrator", "time_step_s", "mass_scaling_time_step_s", "duration_steps"})
            if (const auto found = root.find(key))
                found->fail("belongs to a dynamic analysis only.");
    } else if (steps) {
        steps->fail("belongs to a static analysis only.");
    }
}

/// Messages about a changed recipe say that it is one: what they name need not be in the file.
JsonNode rootOf(JsonValue recipe, const std::string& path, const std::vector<RecipeOverride>& changes)
{
    const std::string file = std::filesystem::path(path).filename().string();
    applyOverrides(recipe, changes, file);
    return JsonNode::ofValue(std::move(recipe), changes.empty() ? file : file + " with --set");
}

Recipe readRoot(const JsonNode& root, const std::string& path, const std::vector<MaterialPreset>& presets)
{
    root.allowOnly({"version",
                    "part",
                    "extra_parts",
                    "spacing_mm",
                    "cells_across",
                    "cells_across_wall",
                    "objects",
                    "arrangement",
                    "material",
                    "body_materials",
                    "regions",
                    "bodies",
                    "structural_friction",
                    "fixtures",
                    "loads",
                    "analysis",
                    "load_steps",
                    "manipulators",
                    "gravity_m_s2",
                    "floor",
                    "touching",
                    "integrator",
                    "vicinity",
                    "refilling",
                    "time_step_s",
                    "mass_scaling_time_step_s",
                    "duration_s",
                    "duration_steps",
                    "events",
                    "exports"});
    root.at("version").integer(1, 1);

    Recipe recipe;
    recipe.file = path;
    readParts(root, recipe);
    readMethod(root, recipe);
    readDuration(root, recipe);
    readAnalysis(root, recipe);
    readBodies(root, presets, recipe);
    if (const auto node = root.find("manipulators"))
        recipe.manipulators = readNamed(*node, [&](const JsonNode& item) { return readRecipeManipulator(item, path); });
    if (const auto node = root.find("gravity_m_s2"))
        recipe.gravity = readVector(*node, strongestGravity);
    if (const auto node = root.find("floor"))
        recipe.floor = readFloor(*node);
    if (const auto node = root.find("events"))
        recipe.events = readEvents(*node, recipe, presets);
    if (const auto node = root.find("exports"))
        recipe.exports = readExports(*node);
    recipe.integrator = readIntegrator(root, recipe);
    recipe.refilling = readRefilling(root, recipe);
    return recipe;
}

} // namespace

Material RecipeMaterial::on(const Material& base) const
{
    Material material = preset.value_or(base);
    for (const auto& [member, number] : overrides)
        material.*member = number;
    return material;
}

bool RecipeExport::isPicture() const
{
    return knead::isPicture(file);
}

Recipe readRecipe(const std::string& path, const std::vector<MaterialPreset>& presets,
                  const std::vector<RecipeOverride>& changes)
{
    return readRoot(rootOf(readJsonFile(path), path, changes), path, presets);
}

Recipe readRecipeText(const std::string& text, const std::string& path, const std::vector<MaterialPreset>& presets,
                      const std::vector<RecipeOverride>& changes)
{
    JsonValue recipe = parseJson(text, std::filesystem::path(path).filename().string());
    forgetLines(recipe);
    return readRoot(rootOf(std::move(recipe), path, changes), path, presets);
}

} // namespace knead
