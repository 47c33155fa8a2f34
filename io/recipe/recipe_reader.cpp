#include "io/recipe/recipe_reader.h"

#include "core/message/message.h"
#include "core/session/end_grips.h"
#include "core/simulation/scene_limits.h"
#include "io/json/json_value.h"
#include "io/recipe/recipe_deformations.h"
#include "io/recipe/recipe_events.h"
#include "io/recipe/recipe_exports.h"
#include "io/recipe/recipe_objects.h"
#include "io/recipe/recipe_tools.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace knead {

namespace recipe_keys {

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
        root.fail(Message(
            "Recipe", "must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects."));
    using Kind = SpacingChoice::Kind;
    if (spacing)
        return {Kind::Length, spacing->positiveThousandth()};
    if (cells)
        return {Kind::CellsAlong, cells->number(2, 1000)};
    if (wallCells)
        return {Kind::CellsAcrossWall, wallCells->number(0.5, 100)};
    return {Kind::Objects, objects->number(8, 2e7)};
}

const Choices<Arrangement>& arrangementWords()
{
    static const Choices<Arrangement> words{{"cut-cells", Arrangement::cutCells},
                                            {"published", Arrangement::published}};
    return words;
}

/// Of all bodies, and of some by their names.
void readMaterials(const JsonNode& root, const Context& context, Recipe& recipe)
{
    const MaterialWords material{context};
    if (const auto node = root.find("material"))
        recipe.material = material.read(*node).on(Material{});
    if (const auto node = root.find("body_materials"))
        for (const std::string& body : node->keys())
            recipe.bodyMaterials.emplace_back(body, material.read(node->at(body)).on(recipe.material));
}

/// An object whose keys are the names of bodies.
struct Bodies {
    const Context& context;
    std::vector<RecipeBody> read(const JsonNode& node) const
    {
        std::vector<RecipeBody> bodies;
        for (const std::string& name : node.keys())
            bodies.push_back(Object<RecipeBody>{context}.read(node.at(name), {.name = name}));
        return bodies;
    }
};

/// What is held from the start on is named in the first filling.
struct FirstFixture {
    const Context& context;
    RecipeFixture read(const JsonNode& node) const
    {
        RecipeFixture fixture = Object<RecipeFixture>{context}.read(node);
        if (fixture.objects && fixture.objects->isFilledAnew)
            node.at("filled_anew")
                .fail(Message("Recipe", "belongs to events: at the start nothing has been filled anew."));
        return fixture;
    }
};

/// A list whose items have names, each used once.
template <class Kind>
struct Named {
    Kind kind;
    auto read(const JsonNode& node) const
    {
        std::vector<decltype(kind.read(node))> all;
        for (const JsonNode& item : node.items()) {
            auto one = kind.read(item);
            if (std::ranges::any_of(all, [&](const auto& other) { return other.name == one.name; }))
                item.at("name").fail(Message("Recipe", "is used twice: \"%1\".").with(one.name));
            all.push_back(std::move(one));
        }
        return all;
    }
};
template <class Kind>
Named(Kind) -> Named<Kind>;

/// A list of files, each written once.
struct Exports {
    const Context& context;
    std::vector<RecipeExport> read(const JsonNode& node) const
    {
        std::vector<RecipeExport> exports;
        for (const JsonNode& item : node.items()) {
            RecipeExport wanted = readExport(item, context);
            if (std::ranges::any_of(exports, [&](const RecipeExport& other) { return other.file == wanted.file; }))
                item.at("file").fail(Message("Recipe", "is written twice: \"%1\".").with(wanted.file));
            exports.push_back(std::move(wanted));
        }
        return exports;
    }
};

/// As recordings do.
bool namesSteps(const Recipe& recipe)
{
    return recipe.durationSteps || recipe.timeStep || recipe.massScalingTimeStep ||
           std::ranges::any_of(recipe.events, [](const RecipeEvent& event) { return event.step.has_value(); });
}

/// Who numbers steps, or says how long they are, means those of the explicit scheme, whose they have always been. So does who wants
/// to see less than some frames: implicit steps last a frame each, and take no note of what a blow does in between. Recordings of
/// before know nothing of refilling.
void chooseMethod(const JsonNode& root, Recipe& recipe)
{
    constexpr double shortestOfFrames = 1.0 / 6; // [s]
    const bool isShort = !recipe.durationSteps && recipe.duration < shortestOfFrames;
    const bool staysExplicit = isShort || (!root.find("integrator") && namesSteps(recipe));
    if (recipe.integrator == Integrator::automatic && staysExplicit)
        recipe.integrator = Integrator::semiImplicitEuler;
    if (!root.find("refilling"))
        recipe.refilling = !namesSteps(recipe);
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
        if (const auto* deform = std::get_if<DeformByPhysics>(&action))
            for (const NumberEnd end : {NumberEnd::first, NumberEnd::second})
                take(node.at("deform_by_physics"), m_fixtures, nameOfGrip(deform->what, end));
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
            node.fail(Message("Recipe", "names \"%1\", which is not in the recipe.").with(name));
    }
    static void take(const JsonNode& node, std::set<std::string>& known, const std::string& name)
    {
        if (!known.insert(name).second)
            node.fail(Message("Recipe", "is used twice: \"%1\".").with(name));
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
            node.at("time_s").failExpecting(Message("Recipe", "must not be earlier than that of the event before it"));
        if (event.step && *event.step < m_step)
            node.at("step").failExpecting(Message("Recipe", "must not be less than that of the event before it"));
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

std::vector<RecipeEvent> readEvents(const JsonNode& node, const Recipe& recipe, const Context& context)
{
    const double latest = latestTime(node, recipe);
    EventNames names(recipe);
    EventOrder order;
    std::vector<RecipeEvent> events;
    const std::vector<JsonNode> items = node.items();
    for (std::size_t i = 0; i < items.size(); ++i)
        for (RecipeEvent& event : readEvent(items[i], latest, context)) {
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
        root.fail(Message("Recipe", "must have only one of the keys duration_s and duration_steps."));
    if (steps) {
        recipe.durationSteps = steps->count(mostSteps);
        return;
    }
    recipe.duration = root.at("duration_s").positive();
    if (recipe.duration > longestDuration)
        root.at("duration_s").failExpecting(Message("Recipe", "must be at most 3600 s"));
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
                found->fail(Message("Recipe", "belongs to a dynamic analysis only."));
    } else if (steps) {
        steps->fail(Message("Recipe", "belongs to a static analysis only."));
    }
}

/// Messages about a changed recipe say that it is one: what they name need not be in the file.
JsonNode rootOf(JsonValue recipe, const std::string& path, const std::vector<RecipeOverride>& changes)
{
    const std::string file = std::filesystem::path(path).filename().string();
    applyOverrides(recipe, changes, file);
    return JsonNode::ofValue(std::move(recipe), changes.empty() ? file : file + " with --set");
}

} // namespace

template <class Fields>
void describeKeys(Fields& fields, RecipeExtraPart& part)
{
    fields.needed("file", part.file, FilePath{fields.context});
    fields.optional("name", part.name, Text{});
    fields.optional("position_mm", part.pose.position, VectorInMillimeters{});
    fields.optional("rotation_deg", part.pose.rotation, RotationInDegrees{});
}

template <class Fields>
void describeKeys(Fields& fields, Recipe& recipe)
{
    const Context& context = fields.context;
    int version = 1;
    fields.needed("version", version, Whole{1, 1});
    fields.together({"part"}, [&](const JsonNode& root) {
        PartFiles part = Object<PartFiles>{context}.read(root.at("part"));
        recipe.part = part.files.front();
        recipe.partsBeside.assign(part.files.begin() + 1, part.files.end());
        recipe.import = part.import;
        recipe.fillsOpenParts = part.fillsOpenParts;
    });
    fields.optional("deform", recipe.deformations, ListOf{DeformationWords{context}});
    fields.optional("extra_parts", recipe.extraParts, ListOf{Object<RecipeExtraPart>{context}});
    fields.together({"spacing_mm", "cells_across", "cells_across_wall", "objects"},
                    [&](const JsonNode& root) { recipe.spacing = readSpacing(root); });
    fields.optional("arrangement", recipe.arrangement, Word{arrangementWords()});
    fields.check([&](const JsonNode& root) {
        if (recipe.arrangement == Arrangement::published && recipe.spacing.kind != SpacingChoice::Kind::Length)
            root.at("arrangement").fail(Message("Recipe", "is \"published\", which needs spacing_mm."));
    });
    fields.together({"material", "body_materials"},
                    [&](const JsonNode& root) { readMaterials(root, context, recipe); });
    fields.optional("regions", recipe.regions, Named{Object<RecipeMaterialRegion>{context}});
    fields.optional("bodies", recipe.bodies, Bodies{context});
    fields.optional("structural_friction", recipe.structuralFriction, Number{0, 2});
    fields.optional("fixtures", recipe.fixtures, Named{FirstFixture{context}});
    fields.optional("loads", recipe.loads, Named{Object<RecipeLoad>{context}});
    fields.optional("probes", recipe.probes, Named{Object<RecipeProbe>{context}});
    fields.together({"analysis", "load_steps"}, [&](const JsonNode& root) { readAnalysis(root, recipe); });
    fields.optional("manipulators", recipe.manipulators, Named{Object<RecipeManipulator>{context}});
    fields.optional("gravity_m_s2", recipe.gravity, Vector{strongestGravity});
    fields.optional("floor", recipe.floor, Object<RecipeFloor>{context});
    fields.optional("touching", recipe.touching, Word{touchingWords()});
    fields.optional("integrator", recipe.integrator, Word{integratorWords()});
    fields.optional("vicinity", recipe.vicinity, Word{vicinityWords()});
    fields.optional("refilling", recipe.refilling, Flag{});
    fields.optional("time_step_s", recipe.timeStep, Number{shortestTimeStep, longestTimeStep});
    fields.optional("mass_scaling_time_step_s", recipe.massScalingTimeStep, Number{shortestTimeStep, longestTimeStep});
    fields.together({"duration_s", "duration_steps"}, [&](const JsonNode& root) { readDuration(root, recipe); });
    fields.together({"events"}, [&](const JsonNode& root) {
        if (const auto node = root.find("events"))
            recipe.events = readEvents(*node, recipe, context);
    });
    fields.optional("exports", recipe.exports, Exports{context});
    fields.check([&](const JsonNode& root) { chooseMethod(root, recipe); });
}

namespace {

Recipe readRoot(const JsonNode& root, const std::string& path, const std::vector<MaterialPreset>& presets)
{
    const Context context{presets, path};
    Recipe recipe;
    recipe.file = path;
    return Object<Recipe>{context}.read(root, std::move(recipe));
}

} // namespace

} // namespace recipe_keys

Recipe readRecipe(const std::string& path, const std::vector<MaterialPreset>& presets,
                  const std::vector<RecipeOverride>& changes)
{
    return recipe_keys::readRoot(recipe_keys::rootOf(readJsonFile(path), path, changes), path, presets);
}

Recipe readRecipeText(const std::string& text, const std::string& path, const std::vector<MaterialPreset>& presets,
                      const std::vector<RecipeOverride>& changes)
{
    JsonValue root = parseJson(text, std::filesystem::path(path).filename().string());
    forgetLines(root);
    return recipe_keys::readRoot(recipe_keys::rootOf(std::move(root), path, changes), path, presets);
}

} // namespace knead
