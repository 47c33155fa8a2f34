#include "core/session/recipe_scene.h"

#include "core/aggregate/fill.h"
#include "core/message/message.h"
#include "core/model/file_names.h"
#include "core/model/joined_model.h"
#include "core/model/part_tree.h"
#include "core/model/readable_name.h"
#include "core/session/part_filling.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace knead {

namespace {

// Shares of the progress of making a scene.
constexpr double importShare = 0.5;

[[noreturn]] void refuse(const Recipe& recipe, const Message& saying)
{
    throw UnusableInput(aboutFile(recipe.file, saying));
}

/// The filling knows no names; in an assembly they matter.
std::shared_ptr<const Aggregate> fillNamed(const Part& part, Arrangement arrangement, double spacing,
                                           TaskControl& control)
{
    try {
        return fillPart(part, spacing, arrangement, control);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw Problem(Message::verbatim("\"%1\": %2").with(part.name, messageOf(error)));
    }
}

void fillParts(const Recipe& recipe, RecipeScene& result, TaskControl& control)
{
    TaskPortion measuring(control, 0, 0.1);
    const FillingSize size = fillingSizes(*result.model, result.partOfBody(), recipe.spacing, measuring).all;
    const double spacing = spacingFor(recipe.spacing, size);
    result.fineness = assessSpacing(spacing, size);
    if (recipe.arrangement == Arrangement::published)
        result.fineness.warning = {}; // of cut cells
    if (!result.fineness.warning.empty())
        result.warnings.push_back(result.fineness.warning);
    TaskPortion filling(control, 0.1, 1);
    const auto count = static_cast<double>(result.parts().size());
    for (std::size_t i = 0; i < result.parts().size(); ++i) {
        TaskPortion portion(filling, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        const Part& part = result.parts()[i];
        auto aggregate = fillNamed(part, recipe.arrangement, spacing, portion);
        result.scene.bodies.push_back({.name = part.name,
                                       .aggregate = std::move(aggregate),
                                       .material = recipe.material,
                                       .structuralFriction = recipe.structuralFriction,
                                       .surface = std::make_shared<const TriangleMesh>(part.mesh)});
    }
}

void assignBodyMaterials(const Recipe& recipe, RecipeScene& result)
{
    for (const auto& [name, material] : recipe.bodyMaterials)
        for (const BodyId body :
             bodiesNamed(name, result.parts(), aboutFile(recipe.file, Message::verbatim("body_materials"))))
            result.scene.bodies[body].material = material;
}

void startBodies(const Recipe& recipe, RecipeScene& result)
{
    for (const RecipeBody& start : recipe.bodies)
        for (const BodyId id :
             bodiesNamed(start.name, result.parts(), aboutFile(recipe.file, Message::verbatim("bodies")))) {
            Body& body = result.scene.bodies[id];
            body.kind = start.kind;
            body.velocity = start.velocity;
            body.angularVelocity = start.angularVelocity;
        }
}

/// A region of a recipe, as sentences name it.
struct NamedRegion {
    Message what; ///< with a place for its name: "the fixture \"%1\""
    const RecipeRegion& region;

    Message saying() const { return what.with(region.name); }
};

std::vector<ObjectIndex> objectsAtFaces(const Recipe& recipe, const NamedRegion& named, const Part& part,
                                        const Aggregate& aggregate)
{
    if (part.faces.empty())
        refuse(recipe, Message("Recipe", "%1 names faces, but \"%2\" is a mesh without CAD faces; use box_mm.")
                           .with(named.saying(), part.name));
    for (const std::uint32_t face : named.region.faces)
        if (face >= part.faces.size())
            refuse(recipe, Message("Recipe", "%1 names the face %2, but \"%3\" has faces 0 to %4.")
                               .with(named.saying(), face, part.name, part.faces.size() - 1));
    return objectsAtFaces(aggregate, part.mesh, named.region.faces);
}

/// The objects of a region in every body that has some there.
std::vector<BodyObjects> objectsOf(const Recipe& recipe, const NamedRegion& named, const RecipeScene& ready)
{
    const RecipeRegion& region = named.region;
    const Message place = aboutFile(recipe.file, named.saying());
    if (region.box || region.objects)
        return objectsWithin(ready, region.body, region.box, region.objects, place);
    const std::vector<BodyId> bodies = bodiesNamed(region.body, ready.parts(), place);
    if (bodies.size() > 1)
        refuse(recipe,
               Message("Recipe", "%1 names faces of one body among several; add the key body.").with(named.saying()));
    const BodyId body = bodies.front();
    std::vector<ObjectIndex> objects =
        objectsAtFaces(recipe, named, ready.parts()[body], *ready.scene.bodies[body].aggregate);
    if (objects.empty())
        refuse(recipe, Message("Recipe", "%1 holds nothing: no object lies there.").with(named.saying()));
    return {{body, std::move(objects)}};
}

void addRegion(const Recipe& recipe, const RecipeMaterialRegion& region, RecipeScene& result)
{
    for (BodyObjects& at : objectsOf(recipe, {Message("Recipe", "the region \"%1\""), region}, result)) {
        Body& body = result.scene.bodies[at.body];
        body.regions.push_back({region.name, std::move(at.objects), region.material.on(body.material)});
    }
}

/// Adds one fixture of the scene for every body it holds.
std::vector<FixtureId> addFixture(const Recipe& recipe, const RecipeFixture& fixture, RecipeScene& result)
{
    std::vector<FixtureId> ids;
    for (Fixture& one : fixturesOf(recipe, fixture, result)) {
        ids.push_back(static_cast<FixtureId>(result.scene.fixtures.size()));
        result.scene.fixtures.push_back(std::move(one));
    }
    return ids;
}

/// All bodies as one model, with the names of the assembly.
std::shared_ptr<const Model> modelOf(const Recipe& recipe, Model source, std::vector<Part> bodies)
{
    auto model = std::make_shared<Model>(withParts(std::move(source), std::move(bodies)));
    model->file = recipe.part;
    return model;
}

void setWorld(const Recipe& recipe, Scene& scene)
{
    scene.gravity = recipe.gravity;
    if (recipe.floor) {
        scene.floorHeight = recipe.floor->height;
        scene.floorFriction = recipe.floor->friction;
        scene.floorAdhesion = recipe.floor->adhesion;
    }
    scene.touching = recipe.touching;
    scene.integrator = recipe.analysis == Analysis::equilibrium ? Integrator::implicitEuler : recipe.integrator;
    scene.vicinity = recipe.vicinity;
    scene.refilling = recipe.refilling;
    scene.timeStep = recipe.timeStep;
    // Implicit steps last so long if nothing is said [s]. A run that is shorter is a step of its own.
    constexpr double longest = 1.0 / 60;
    if (recipe.integrator == Integrator::implicitEuler && !recipe.durationSteps && recipe.duration < longest)
        scene.timeStep = std::min(recipe.duration, recipe.timeStep.value_or(longest));
    scene.massScalingTimeStep = recipe.massScalingTimeStep;
}

} // namespace

std::vector<std::size_t> RecipeScene::partOfBody() const
{
    std::vector<std::size_t> all(parts().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::vector<BodyId> bodiesNamed(const std::string& name, const std::vector<Part>& parts, const Message& place)
{
    std::vector<BodyId> bodies;
    std::string known;
    for (BodyId body = 0; body < parts.size(); ++body) {
        if (name.empty() || parts[body].name == name || parts[body].path == name)
            bodies.push_back(body);
        known += (known.empty() ? "\"" : ", \"") + parts[body].name + "\"";
    }
    const bool isFormer =
        bodies.empty(); // as versions wrote it that did not know the names of bodies, or took stock ones
    for (BodyId body = 0; body < parts.size(); ++body)
        if (isFormer && (parts[body].bodyOf == name || formerPath(parts[body]) == name))
            bodies.push_back(body);
    if (bodies.empty() && parts.size() == 1 && isGeneratedName(name))
        bodies.push_back(0);
    for (BodyId body = 0; body < parts.size() && bodies.empty(); ++body)
        if (name == '#' + std::to_string(body))
            return {body};
    if (bodies.empty())
        throw UnusableInput(Message("Recipe", "%1 names the body \"%2\"; the part has: %3.").with(place, name, known));
    return bodies;
}

namespace {

/// Numbers of objects belong to one filling; in another they would be elsewhere.
void requireFilling(const RecipeObjects& objects, std::size_t bodies, std::size_t count, const Message& place)
{
    if (bodies != 1)
        throw UnusableInput(
            Message("Recipe", "%1 names objects of one body among several; add the key body.").with(place));
    if (!objects.isFilledAnew && objects.of != count)
        throw UnusableInput(Message("Recipe", "%1 names objects of a body that is filled with %2, and here it is "
                                              "filled with %3. Name a box instead, or keep the spacing.")
                                .with(place, objects.of, count));
}

} // namespace

std::vector<BodyObjects> objectsWithin(const RecipeScene& ready, const std::string& body, const std::optional<Box>& box,
                                       const std::optional<RecipeObjects>& objects, const Message& place)
{
    const std::vector<BodyId> bodies = bodiesNamed(body, ready.parts(), place);
    const auto aggregateOf = [&](BodyId id) -> const Aggregate& { return *ready.scene.bodies[id].aggregate; };
    if (objects) {
        requireFilling(*objects, bodies.size(), aggregateOf(bodies.front()).size(), place);
        return {{bodies.front(), objects->numbers}};
    }
    std::vector<BodyObjects> found;
    for (const BodyId id : bodies) {
        std::vector<ObjectIndex> inside;
        if (box)
            inside = objectsInBox(aggregateOf(id), *box);
        if (!box || !inside.empty())
            found.push_back({id, std::move(inside)});
    }
    if (found.empty())
        throw UnusableInput(Message("Recipe", "%1 holds nothing: no object lies there.").with(place));
    return found;
}

std::vector<Fixture> fixturesOf(const Recipe& recipe, const RecipeFixture& fixture, const RecipeScene& ready)
{
    std::vector<Fixture> fixtures;
    for (BodyObjects& at : objectsOf(recipe, {Message("Recipe", "the fixture \"%1\""), fixture}, ready))
        fixtures.push_back({fixture.name, at.body, std::move(at.objects), fixture.velocity, fixture.turn});
    return fixtures;
}

Load loadOf(const Recipe& recipe, const RecipeLoad& load, const RecipeScene& ready)
{
    const Message saying = Message("Recipe", "the load \"%1\"").with(load.name);
    const std::vector<BodyId> bodies = bodiesNamed(load.body, ready.parts(), aboutFile(recipe.file, saying));
    if (bodies.size() > 1)
        refuse(recipe, Message("Recipe", "%1 is on one body among several; add the key body.").with(saying));
    const Part& part = ready.parts()[bodies.front()];
    const Aggregate& aggregate = *ready.scene.bodies[bodies.front()].aggregate;
    const RecipeRegion region{.name = load.name, .body = load.body, .faces = load.faces};
    if (!load.faces.empty())
        objectsAtFaces(recipe, {Message("Recipe", "the load \"%1\""), region}, part,
                       aggregate); // refuses faces that are not there
    Load result{.name = load.name,
                .body = bodies.front(),
                .faces = load.faces,
                .box = load.box,
                .patch = loadPatch(aggregate, part.mesh, load.faces, load.box),
                .amount = load.amount,
                .ramp = load.ramp};
    if (result.patch.empty())
        refuse(recipe, Message("Recipe", "%1 acts on nothing: no surface lies there.").with(saying));
    return result;
}

Manipulator manipulatorOf(const RecipeManipulator& manipulator, const std::shared_ptr<const ToolPart>& part)
{
    Manipulator result = manipulator;
    result.part = part;
    result.size = fittingSize(result.kind, result.size, part.get());
    return result;
}

RecipeScene buildScene(const Recipe& recipe, const RecipeFiles& files, TaskControl& control)
{
    TaskPortion importing(control, 0, importShare);
    RecipeParts parts = importParts(recipe, files, importing);
    RecipeScene result;
    result.model = modelOf(recipe, std::move(parts.source), std::move(parts.bodies));
    result.warnings = std::move(parts.warnings);
    TaskPortion filling(control, importShare, 1);
    fillParts(recipe, result, filling);

    assignBodyMaterials(recipe, result);
    startBodies(recipe, result);
    for (const RecipeMaterialRegion& region : recipe.regions)
        addRegion(recipe, region, result);
    for (const RecipeFixture& fixture : recipe.fixtures)
        result.fixtureIds.push_back(addFixture(recipe, fixture, result));
    for (const RecipeLoad& load : recipe.loads)
        result.scene.loads.push_back(loadOf(recipe, load, result));
    for (std::size_t i = 0; i < recipe.manipulators.size(); ++i)
        result.scene.manipulators.push_back(manipulatorOf(recipe.manipulators[i], parts.toolParts[i]));
    result.eventParts = std::move(parts.eventParts);
    setWorld(recipe, result.scene);
    return result;
}

} // namespace knead
