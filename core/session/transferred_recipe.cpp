#include "core/session/transferred_recipe.h"

#include "core/session/end_grips.h"
#include "core/session/moved_regions.h"
#include "core/session/moved_tools.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace knead {

namespace {

/// Keeps the events that have a place on the other part.
class EventMover {
public:
    EventMover(const TransferGround& ground, MovedRegions& regions, MovedTools& tools, TransferReport& report)
        : m_ground(ground)
        , m_turn(ground.base.linear)
        , m_regions(regions)
        , m_tools(tools)
        , m_report(report)
    {
    }

    /// Moves what an event does; false where nothing of it is left.
    bool operator()(AddRecipeFixture& add) { return fixture(add.fixture); }
    bool operator()(MoveRecipeFixture& move)
    {
        if (m_goneFixtures.contains(move.fixture))
            return false;
        move.velocity = m_turn.carried(move.velocity);
        m_regions.moveTurn(move.fixture, move.turn);
        return true;
    }
    bool operator()(ReleaseFixture& release) { return !m_goneFixtures.contains(release.fixture); }
    bool operator()(AddRecipeLoad& add) { return load(add.load); }
    bool operator()(ChangeRecipeLoad& change)
    {
        m_turn.carry(change.amount);
        return !m_goneLoads.contains(change.load);
    }
    bool operator()(TakeLoadAway& away) { return !m_goneLoads.contains(away.load); }
    bool operator()(AddRecipeManipulator& add) { return m_tools.move(add.manipulator); }
    bool operator()(MoveRecipeManipulator& move)
    {
        return m_tools.isThere(move.manipulator) && m_tools.move(move.manipulator, move.motion);
    }
    bool operator()(PlaceRecipeManipulator& place)
    {
        if (!m_tools.isThere(place.manipulator))
            return false;
        place.pose = m_tools.moved(place.manipulator, place.pose);
        return true;
    }
    bool operator()(ReshapeRecipeManipulator& reshape) { return m_tools.reshape(reshape.manipulator); }
    bool operator()(TakeManipulatorAway& away) { return m_tools.isThere(away.manipulator); }
    bool operator()(ChangeMaterial& change)
    {
        return m_regions.moveWhere(change, Message("Transfer", "a change of material"));
    }
    bool operator()(RenormalizeBodies& wanted)
    {
        return m_regions.moveWhere(wanted, Message("Transfer", "a relaxation"));
    }
    bool operator()(ChangeBodyKind& change) { return m_regions.moveBody(change.body); }
    bool operator()(RefillBodies& refill)
    {
        refill.spacing *= m_turn.scale();
        return m_regions.moveBody(refill.body);
    }
    bool operator()(CutBodies& cut)
    {
        const Vec3 place = placeOnPart(m_ground.bodies, cut.point);
        m_report.moved.push_back({Message("Transfer", "a cut"), place - cut.point});
        cut.point = place;
        cut.normal = m_turn.turn() * cut.normal;
        return m_regions.moveBody(cut.body);
    }
    bool operator()(DeformByPhysics& deform)
    {
        NumberDeformation& numbers = deform.what.numbers;
        numbers.origin = m_ground.base.at(numbers.origin);
        numbers.axis = m_turn.turn() * numbers.axis;
        numbers.side = m_turn.turn() * numbers.side;
        for (double* length : {&numbers.from, &numbers.to, &numbers.shift, &numbers.neutral})
            *length *= m_turn.scale();
        if (numbers.kind == NumberKind::twist && m_turn.mirrors())
            numbers.angle = -numbers.angle;
        const bool isThere = m_regions.moveBody(deform.body);
        if (!isThere)
            for (const NumberEnd end : {NumberEnd::first, NumberEnd::second})
                m_goneFixtures.insert(nameOfGrip(deform.what, end));
        return isThere;
    }
    bool operator()(ChangeGravity& change)
    {
        change.gravity = m_turn.turn() * change.gravity;
        return true;
    }
    bool operator()(ChangeFloor& floor) { return !floor.height || moveFloor(*floor.height); }
    bool operator()(auto& /*of the whole scene*/) { return true; }

    bool fixture(RecipeFixture& fixture)
    {
        if (!m_regions.move(fixture, Message("Transfer", "the fixture \"%1\"").with(fixture.name))) {
            m_goneFixtures.insert(fixture.name);
            return false;
        }
        fixture.velocity = m_turn.carried(fixture.velocity);
        m_regions.moveTurn(fixture.name, fixture.turn);
        if (fixture.momentCenter)
            fixture.momentCenter = placeOnPart(m_ground.bodies, *fixture.momentCenter);
        return true;
    }

    bool load(RecipeLoad& load)
    {
        m_turn.carry(load.amount);
        const bool isThere = m_regions.move(load, Message("Transfer", "the load \"%1\"").with(load.name));
        if (!isThere)
            m_goneLoads.insert(load.name);
        return isThere;
    }

    /// It keeps its distance from the lowest place of the part.
    bool moveFloor(double& height)
    {
        const Vec3 up = m_turn.turn() * Vec3::UnitZ();
        if (std::abs(up.z() - 1) > 1e-9) {
            m_report.leftOut.push_back(
                Message("Transfer", "The floor is left out: its mirror image would be no floor."));
            return false;
        }
        height = lowest(m_ground.after) + m_turn.scale() * (height - lowest(m_ground.before));
        return true;
    }

private:
    static double lowest(const RecipeScene& scene)
    {
        Box box;
        for (const Part& part : scene.parts())
            box.extend(boxOfPlaces(part.mesh.vertices));
        return box.min().z();
    }

    const TransferGround& m_ground;
    CarriedVectors m_turn;
    MovedRegions& m_regions;
    MovedTools& m_tools;
    TransferReport& m_report;
    std::set<std::string> m_goneFixtures;
    std::set<std::string> m_goneLoads;
};

void moveBodies(Recipe& recipe, const CarriedVectors& vectors, MovedRegions& regions)
{
    std::erase_if(recipe.bodies, [&](RecipeBody& body) {
        body.velocity = vectors.carried(body.velocity);
        body.angularVelocity = vectors.spun(body.angularVelocity);
        return !regions.moveBody(body.name);
    });
    std::erase_if(recipe.bodyMaterials, [&](auto& body) { return !regions.moveBody(body.first); });
}

void moveProbes(Recipe& recipe, const TransferGround& ground, MovedRegions& regions, TransferReport& report)
{
    for (RecipeProbe& probe : recipe.probes) {
        const Vec3 place = placeOnPart(ground.bodies, probe.place);
        report.moved.push_back(
            {Message("Transfer", "the probe \"%1\"").with(probe.name), place - std::exchange(probe.place, place)});
        if (!probe.body.empty() && !regions.moveBody(probe.body))
            probe.body.clear();
    }
}

} // namespace

std::size_t TransferReport::found() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(faces, [](const Face& face) { return face.after.has_value(); }));
}

Recipe transferredRecipe(const Recipe& original, const TransferGround& ground, TransferReport& report)
{
    Recipe recipe = original;
    const CarriedVectors vectors(ground.base.linear);
    MovedRegions regions(ground, report);
    MovedTools tools(ground, report);
    EventMover mover(ground, regions, tools, report);
    moveBodies(recipe, vectors, regions);
    std::erase_if(recipe.regions, [&](RecipeMaterialRegion& region) {
        return !regions.move(region, Message("Transfer", "the region \"%1\"").with(region.name));
    });
    std::erase_if(recipe.fixtures, [&](RecipeFixture& fixture) { return !mover.fixture(fixture); });
    std::erase_if(recipe.loads, [&](RecipeLoad& load) { return !mover.load(load); });
    std::erase_if(recipe.manipulators, [&](RecipeManipulator& tool) { return !tools.move(tool); });
    std::erase_if(recipe.events, [&](RecipeEvent& event) { return !std::visit(mover, event.action); });
    moveProbes(recipe, ground, regions, report);
    recipe.gravity = vectors.turn() * recipe.gravity;
    if (recipe.floor && !mover.moveFloor(recipe.floor->height))
        recipe.floor.reset();
    return recipe;
}

} // namespace knead
