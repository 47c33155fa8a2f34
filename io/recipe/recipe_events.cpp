#include "io/recipe/recipe_events.h"

#include "core/message/message.h"
#include "core/simulation/scene_limits.h"
#include "io/recipe/recipe_objects.h"
#include "io/recipe/recipe_physics.h"
#include "io/recipe/recipe_tools.h"

namespace knead::recipe_keys {

namespace {

constexpr double longestAnnealing = 3600; // [s]
constexpr double fastestGrip = 1e5;       // [mm/s]
constexpr double largestNormal = 1e6;
constexpr double shortestBalance = 1e-6; // [s]
constexpr double longestBalance = 3600;  // [s]

/// True, since whoever does not want it leaves it out.
struct ResetWord {
    using Of = StartAgain;
    static StartAgain read(const JsonNode& node)
    {
        if (!node.boolean())
            node.fail(Message("Recipe", "must be true."));
        return {};
    }
    static std::string text(const StartAgain&) { return "true"; }
};

} // namespace

template <class Fields>
void describeKeys(Fields& fields, RenormalizeBodies& action)
{
    describeWhere(fields, action);
    fields.optional("duration_s", action.duration, Number{0, longestAnnealing}, action.duration != 0);
}

template <class Fields>
void describeKeys(Fields& fields, ChangeBodyKind& change)
{
    fields.needed("body", change.body, Text{});
    fields.needed("kind", change.kind, Word{bodyKindWords()});
}

template <class Fields>
void describeKeys(Fields& fields, ChangeFloor& floor)
{
    fields.optional("height_mm", floor.height, Millimeters{});
    fields.optional("friction", floor.friction, Number{0, 2});
    fields.optional("adhesion_pa", floor.adhesion, Number{0, 1e9}, floor.adhesion > 0);
}

template <class Fields>
void describeKeys(Fields& fields, MoveRecipeFixture& move)
{
    fields.needed("name", move.fixture, Text{});
    fields.optional("velocity_mm_s", move.velocity, VectorInMillimeters{fastestGrip});
    fields.optional("turn", move.turn, Object<GripTurn>{fields.context}, move.turn.turns());
    fields.check([](const JsonNode& node) {
        if (!node.find("velocity_mm_s") && !node.find("turn"))
            node.fail(Message("Recipe", "must have at least one of the keys velocity_mm_s and turn."));
    });
}

template <class Fields>
void describeKeys(Fields& fields, MoveRecipeManipulator& move)
{
    fields.needed("name", move.manipulator, Text{});
    describeKeys(fields, move.motion);
}

template <class Fields>
void describeKeys(Fields& fields, PlaceRecipeManipulator& place)
{
    fields.needed("name", place.manipulator, Text{});
    describePose(fields, place.pose);
}

template <class Fields>
void describeKeys(Fields& fields, ReshapeRecipeManipulator& reshape)
{
    describeForm(fields, reshape.manipulator);
}

template <class Fields>
void describeKeys(Fields& fields, ChangeRecipeLoad& change)
{
    fields.needed("name", change.load, Text{});
    describeAmount(fields, change.amount, change.ramp);
}

template <class Fields>
void describeKeys(Fields& fields, RefillBodies& refill)
{
    fields.optional("body", refill.body, Text{}, !refill.body.empty());
    fields.optional("spacing_mm", refill.spacing, PositiveMillimeters{}, refill.spacing != 0);
}

template <class Fields>
void describeKeys(Fields& fields, CutBodies& cut)
{
    fields.optional("body", cut.body, Text{}, !cut.body.empty());
    fields.needed("point_mm", cut.point, VectorInMillimeters{});
    fields.needed("normal", cut.normal, Vector{largestNormal});
    fields.check([&](const JsonNode& node) {
        if (cut.normal.isZero(0))
            node.at("normal").fail(Message("Recipe", "must not be 0: it says which way the plane faces."));
    });
}

namespace {

/// What can happen, by its key, but for a change of material, which has other keys beside its own.
template <class Visit>
void forEachAction(const Context& context, const Visit& visit)
{
    visit("remove_fixture", Only{&ReleaseFixture::fixture, Text{}});
    visit("remove_manipulator", Only{&TakeManipulatorAway::manipulator, Text{}});
    visit("gravity_m_s2", Only{&ChangeGravity::gravity, Vector{strongestGravity}});
    visit("renormalize", Object<RenormalizeBodies>{context});
    visit("body_kind", Object<ChangeBodyKind>{context});
    visit("floor", Object<ChangeFloor>{context});
    visit("integrator", Only{&ChangeIntegrator::integrator, Word{integratorWords()}});
    visit("pace", Only{&ChangePace::pace, Word{paceWords()}});
    visit("add_fixture", Only{&AddRecipeFixture::fixture, Object<RecipeFixture>{context}});
    visit("move_fixture", Object<MoveRecipeFixture>{context});
    visit("add_manipulator", Only{&AddRecipeManipulator::manipulator, Object<RecipeManipulator>{context}});
    visit("move_manipulator", Object<MoveRecipeManipulator>{context});
    visit("place_manipulator", Object<PlaceRecipeManipulator>{context});
    visit("reshape_manipulator", Object<ReshapeRecipeManipulator>{context});
    visit("add_load", Only{&AddRecipeLoad::load, Object<RecipeLoad>{context}});
    visit("change_load", Object<ChangeRecipeLoad>{context});
    visit("remove_load", Only{&TakeLoadAway::load, Text{}});
    visit("find_balance_s", Only{&SettleScene::duration, Number{shortestBalance, longestBalance}});
    visit("refill", Object<RefillBodies>{context});
    visit("cut", Object<CutBodies>{context});
    visit("deform_by_physics", PhysicsWords{});
    visit("reset", ResetWord{});
    visit("keep_moment", Only{&MarkMoment::name, AnyText{}});
}

/// Which objects a change of material is about is said beside it.
struct Where : ChangeMaterial {};

template <class Fields>
void describeKeys(Fields& fields, Where& where)
{
    describeWhere(fields, where);
}

const std::vector<std::string>& actionKeys()
{
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all{"material"};
        forEachAction(nowhere(), [&](const char* key, const auto&) { all.emplace_back(key); });
        return all;
    }();
    return keys;
}

/// The one key that says what happens.
std::string actionKeyOf(const JsonNode& node)
{
    std::vector<std::string> found;
    for (const std::string& key : actionKeys())
        if (node.find(key))
            found.push_back(key);
    if (found.size() > 1)
        node.fail(Message("Recipe", "must have only one of the keys %1 and %2.").with(found[0], found[1]));
    if (found.empty())
        node.fail(Message("Recipe", "must have exactly one of the keys %1.")
                      .with(listed(actionKeys(), [](const std::string& key) { return key; })));
    return found.front();
}

RecipeAction readAction(const JsonNode& node, const std::string& wanted, const Context& context)
{
    RecipeAction action;
    if (wanted == "material") {
        Where change;
        readInto(node, change, context);
        change.material = MaterialWords{context}.read(node.at("material"));
        return change;
    }
    forEachAction(context, [&](const char* key, const auto& kind) {
        if (key == wanted)
            action = kind.read(node.at(key));
    });
    return action;
}

RecipeEvent readWhen(const JsonNode& node, double latest)
{
    const auto time = node.find("time_s");
    const auto step = node.find("step");
    if (time.has_value() == step.has_value())
        node.fail(Message("Recipe", "must have either time_s or step."));
    RecipeEvent event;
    if (time)
        event.time = time->number(0, latest);
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

/// Of a move, which may be one.
std::optional<JsonNode> pathIn(const JsonNode& move)
{
    std::vector<std::string> allowed{"name", "path"};
    allowed.insert(allowed.end(), keysOf<Motion>().begin(), keysOf<Motion>().end());
    move.allowOnly(allowed);
    const auto path = move.find("path");
    for (const std::string& key : keysOf<Motion>())
        if (path && move.find(key))
            move.fail(Message("Recipe", "must have only one of the keys path and %1.").with(key));
    return path;
}

} // namespace

std::vector<RecipeEvent> readEvent(const JsonNode& node, double latest, const Context& context)
{
    std::vector<std::string> allowed{"time_s", "step"};
    for (const auto& keys : {keysOf<Where>(), actionKeys()})
        allowed.insert(allowed.end(), keys.begin(), keys.end());
    node.allowOnly(allowed);
    RecipeEvent event = readWhen(node, latest);
    const std::string key = actionKeyOf(node);
    if (key != "material")
        for (const std::string& detail : keysOf<Where>())
            if (const auto found = node.find(detail))
                found->fail(Message("Recipe", "belongs to a change of material only."));
    if (key == "move_manipulator")
        if (const auto path = pathIn(node.at(key)))
            return readPathEvents(*path, node.at(key).at("name").text(), event);
    event.action = readAction(node, key, context);
    return {event};
}

void putAction(ObjectText& event, const RecipeAction& action, const Context& context)
{
    if (const auto* change = std::get_if<ChangeMaterial>(&action)) {
        event.put("material", MaterialWords{context}.text(change->material));
        putInto(event, Where{*change}, context);
        return;
    }
    forEachAction(context, [&]<class Kind>(const char* key, const Kind& kind) {
        if (const auto* wanted = std::get_if<typename Kind::Of>(&action))
            event.put(key, kind.text(*wanted));
    });
}

} // namespace knead::recipe_keys
