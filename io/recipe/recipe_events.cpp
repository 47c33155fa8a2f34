// Events of a recipe: what changes on the way.
#include "core/message/message.h"
#include "core/simulation/scene_limits.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"
#include "io/recipe/scene_words.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace knead {

namespace {

constexpr double longestAnnealing = 3600; // [s]
constexpr double fastestGrip = 1e5;       // [mm/s]
constexpr double largestNormal = 1e6;
constexpr double shortestBalance = 1e-6; // [s]
constexpr double longestBalance = 3600;  // [s]

std::string readOptionalText(const JsonNode& node, const std::string& key)
{
    const auto text = node.find(key);
    return text ? text->text() : "";
}

/// Objects are those of one body.
template <class Action>
void readWhere(const JsonNode& node, Action& action)
{
    action.body = readOptionalText(node, "body");
    if (const auto box = node.find("box_mm"))
        action.box = readBox(*box);
    action.objects = readRecipeObjects(node);
    if (action.objects && action.box)
        node.fail(Message("Recipe", "must have only one of the keys box_mm and objects."));
}

RecipeAction readRenormalize(const JsonNode& node)
{
    node.allowOnly({"body", "box_mm", "objects", "objects_in_body", "filled_anew", "duration_s"});
    RenormalizeBodies action;
    readWhere(node, action);
    if (const auto duration = node.find("duration_s"))
        action.duration = duration->number(0, longestAnnealing);
    return action;
}

RecipeAction readChangeOfKind(const JsonNode& node)
{
    node.allowOnly({"body", "kind"});
    return ChangeBodyKind{node.at("body").text(), readBodyKind(node.at("kind"))};
}

RecipeAction readChangeOfFloor(const JsonNode& node)
{
    node.allowOnly({"height_mm", "friction", "adhesion_pa"});
    ChangeFloor action;
    if (const auto height = node.find("height_mm"))
        action.height = height->thousandth();
    if (const auto friction = node.find("friction"))
        action.friction = friction->number(0, 2);
    if (const auto adhesion = node.find("adhesion_pa"))
        action.adhesion = adhesion->number(0, 1e9);
    return action;
}

RecipeAction readMoveOfFixture(const JsonNode& node)
{
    node.allowOnly({"name", "velocity_mm_s", "turn"});
    const auto velocity = node.find("velocity_mm_s");
    const auto turn = node.find("turn");
    if (!velocity && !turn)
        node.fail(Message("Recipe", "must have at least one of the keys velocity_mm_s and turn."));
    return MoveRecipeFixture{.fixture = node.at("name").text(),
                             .velocity = velocity ? readMillimeters(*velocity, fastestGrip) : Vec3(Vec3::Zero()),
                             .turn = turn ? readGripTurn(*turn) : GripTurn{}};
}

RecipeAction readPlacing(const JsonNode& node)
{
    node.allowOnly(withPoseKeys({"name"}));
    node.at("position_mm");
    return PlaceRecipeManipulator{node.at("name").text(), readPose(node, {})};
}

/// Path apart, which is several events.
RecipeAction readMove(const JsonNode& node)
{
    return MoveRecipeManipulator{node.at("name").text(), readMotion(node)};
}

RecipeAction readRefill(const JsonNode& node)
{
    node.allowOnly({"body", "spacing_mm"});
    RefillBodies refill;
    if (const auto body = node.find("body"))
        refill.body = body->text();
    if (const auto spacing = node.find("spacing_mm"))
        refill.spacing = spacing->positiveThousandth();
    return refill;
}

RecipeAction readCut(const JsonNode& node)
{
    node.allowOnly({"body", "point_mm", "normal"});
    CutBodies cut;
    if (const auto body = node.find("body"))
        cut.body = body->text();
    cut.point = readPlace(node.at("point_mm"));
    cut.normal = readVector(node.at("normal"), largestNormal);
    if (cut.normal.isZero(0))
        node.at("normal").fail(Message("Recipe", "must not be 0: it says which way the plane faces."));
    return cut;
}

RecipeAction readReset(const JsonNode& node)
{
    if (!node.boolean())
        node.fail(Message("Recipe", "must be true."));
    return StartAgain{};
}

/// What can happen, by its key. A change of material has other keys beside its own.
struct ActionReader {
    std::string key;
    std::function<RecipeAction(const JsonNode& event, const JsonNode& action, const EventContext&)> read;
};

template <class Read>
ActionReader plain(const char* key, Read read)
{
    return {key, [read](const JsonNode&, const JsonNode& action, const EventContext&) { return read(action); }};
}

RecipeAction readMaterialChange(const JsonNode& event, const JsonNode& action, const EventContext& context)
{
    ChangeMaterial change;
    readWhere(event, change);
    change.material = readRecipeMaterial(action, context.presets);
    return change;
}

const std::vector<ActionReader>& actionReaders()
{
    using Node = const JsonNode&;
    static const std::vector<ActionReader> readers{
        {"material", readMaterialChange},
        plain("remove_fixture", [](Node node) { return ReleaseFixture{node.text()}; }),
        plain("remove_manipulator", [](Node node) { return TakeManipulatorAway{node.text()}; }),
        plain("gravity_m_s2", [](Node node) { return ChangeGravity{readVector(node, strongestGravity)}; }),
        plain("renormalize", readRenormalize),
        plain("body_kind", readChangeOfKind),
        plain("floor", readChangeOfFloor),
        plain("integrator", [](Node node) { return ChangeIntegrator{readChoice(node, integratorWords())}; }),
        plain("pace", [](Node node) { return ChangePace{readChoice(node, paceWords())}; }),
        plain("add_fixture", [](Node node) { return AddRecipeFixture{readRecipeFixture(node)}; }),
        plain("move_fixture", readMoveOfFixture),
        {"add_manipulator",
         [](Node, Node node, const EventContext& context) {
             return AddRecipeManipulator{readRecipeManipulator(node, context.recipePath)};
         }},
        plain("move_manipulator", readMove),
        plain("place_manipulator", readPlacing),
        {"reshape_manipulator",
         [](Node, Node node, const EventContext& context) {
             return ReshapeRecipeManipulator{readReshaping(node, context.recipePath)};
         }},
        plain("add_load", [](Node node) { return AddRecipeLoad{readRecipeLoad(node)}; }),
        plain("change_load", readChangeOfLoad),
        plain("remove_load", [](Node node) { return TakeLoadAway{node.text()}; }),
        plain("find_balance_s", [](Node node) { return SettleScene{node.number(shortestBalance, longestBalance)}; }),
        plain("refill", readRefill),
        plain("cut", readCut),
        plain("reset", readReset),
        plain("keep_moment", [](Node node) { return MarkMoment{node.anyText()}; }),
    };
    return readers;
}

std::string allKeys()
{
    return listed(actionReaders(), [](const ActionReader& reader) { return reader.key; });
}

/// The one key that says what happens.
const ActionReader& readerFor(const JsonNode& node)
{
    std::vector<const ActionReader*> found;
    for (const ActionReader& reader : actionReaders())
        if (node.find(reader.key))
            found.push_back(&reader);
    if (found.size() > 1)
        node.fail(Message("Recipe", "must have only one of the keys %1 and %2.").with(found[0]->key, found[1]->key));
    if (found.empty())
        node.fail(Message("Recipe", "must have exactly one of the keys %1.").with(allKeys()));
    return *found.front();
}

RecipeEvent readWhen(const JsonNode& node, const EventContext& context)
{
    const auto time = node.find("time_s");
    const auto step = node.find("step");
    if (time.has_value() == step.has_value())
        node.fail(Message("Recipe", "must have either time_s or step."));
    RecipeEvent event;
    if (time)
        event.time = time->number(0, context.duration);
    else
        event.step = step->count(mostSteps);
    return event;
}

std::vector<RecipeEvent> readPathEvents(const JsonNode& path, const std::string& name, const RecipeEvent& when)
{
    if (!when.step)
        path.fail(Message("Recipe", "needs an event with a step; say keyframes for times."));
    std::vector<RecipeEvent> events;
    for (const PathRow& row : readPath(path))
        events.push_back({0, *when.step + row.step, MoveRecipeManipulator{name, GoTo{row.target}}});
    return events;
}

/// The keys of a move, which may be a path.
std::optional<JsonNode> pathIn(const JsonNode& move)
{
    std::vector<std::string> allowed{"name", "path"};
    allowed.insert(allowed.end(), motionKeys().begin(), motionKeys().end());
    move.allowOnly(allowed);
    const auto path = move.find("path");
    for (const std::string& key : motionKeys())
        if (path && move.find(key))
            move.fail(Message("Recipe", "must have only one of the keys path and %1.").with(key));
    return path;
}

} // namespace

std::vector<RecipeEvent> readRecipeEvent(const JsonNode& node, const EventContext& context)
{
    std::vector<std::string> allowed{"time_s", "step", "body", "box_mm", "objects", "objects_in_body", "filled_anew"};
    for (const ActionReader& reader : actionReaders())
        allowed.push_back(reader.key);
    node.allowOnly(allowed);
    RecipeEvent event = readWhen(node, context);
    const ActionReader& reader = readerFor(node);
    const JsonNode action = node.at(reader.key);
    if (reader.key != "material")
        for (const char* detail : {"body", "box_mm", "objects", "objects_in_body", "filled_anew"})
            if (const auto found = node.find(detail))
                found->fail(Message("Recipe", "belongs to a change of material only."));
    if (reader.key == "move_manipulator")
        if (const auto path = pathIn(action))
            return readPathEvents(*path, action.at("name").text(), event);
    event.action = reader.read(node, action, context);
    return {event};
}

} // namespace knead
