#include "core/session/filled_model.h"

#include "core/geometry/refine.h"
#include "core/model/face_names.h"
#include "core/session/face_fixtures.h"
#include "core/session/frame.h"
#include "core/session/part_filling.h"
#include "core/session/relief.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>
#include <stdexcept>

namespace knead {

namespace {

constexpr double importShare = 0.4;   // of the progress bar
constexpr double measuredShare = 0.1; // of the filling
constexpr double preparedShare = 0.92;

std::string fileName(const Model& model)
{
    return std::filesystem::path(model.file).filename().string();
}

/// Why a part cannot be filled.
Message openSentence(const Part& part)
{
    if (part.mesh.empty())
        return Message("Filling", "\"%1\" has no surface, so it is not shown.").with(part.name);
    return Message("Filling",
                   "\"%1\" is not a closed solid: it is shown, and not simulated. Close its surfaces and import "
                   "it again.")
        .with(part.name);
}

std::shared_ptr<const FilledSurface> makeSurface(const Model& model, std::size_t index)
{
    const Part& part = model.parts[index];
    auto body = std::make_shared<FilledBody>();
    body->part = index;
    body->name = part.name;
    body->color = part.color.value_or(Color{});
    body->mesh = part.mesh;
    body->render = renderMesh(body->mesh);
    auto surface = std::make_shared<FilledSurface>();
    surface->frame.places = body->mesh.vertices;
    surface->frame.points = renderPoints(body->render, body->mesh.vertices);
    surface->frame.normals = renderNormals(body->render, surface->frame.points);
    surface->frame.shades = reliefShades(body->render, surface->frame.points, surface->frame.normals);
    surface->body = std::move(body);
    return surface;
}

/// Of parts that nothing is filled of.
void addSurfaces(const Model& model, const std::vector<std::size_t>& filled, FilledModel& content)
{
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (!model.parts[p].mesh.empty() && std::ranges::find(filled, p) == filled.end())
            content.surfaces.push_back(makeSurface(model, p));
}

/// A part becomes a body; or a surface, when it has no inside or no cell of the lattice fits into it.
void addPart(const Model& model, std::size_t index, std::set<std::string>& names, FilledModel& content,
             TaskControl& control)
{
    const Part& part = model.parts[index];
    try {
        TaskPortion filling(control, 0, 0.6);
        std::shared_ptr<const Aggregate> aggregate = fillPart(part, content.spacing, Arrangement::cutCells, filling);
        TaskPortion preparing(control, 0.6, 1);
        content.bodies.push_back(
            filledBody(model, index, uniqueName(part.name, names), std::move(aggregate), preparing));
        return;
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        content.unfilled[index] = messageOf(error);
        content.warnings.push_back(Message("Filling", "\"%1\" is not simulated: %2").with(part.name, messageOf(error)));
    }
    content.surfaces.push_back(makeSurface(model, index));
}

/// What there is of a model before any part is filled.
FilledModel emptyFilledModel(const Model& model, const ImportChoices& request)
{
    FilledModel content;
    content.request = request;
    const auto warn = [&](const std::vector<Message>& sentences) {
        content.warnings.insert(content.warnings.end(), sentences.begin(), sentences.end());
    };
    warn(model.missing);
    warn(model.warnings);
    for (const Part& part : model.parts) {
        warn(part.warnings);
        if (!part.canBeFilled() && !request.fillsOpenParts)
            content.warnings.push_back(openSentence(part));
        content.box.extend(boxOfPlaces(part.mesh.vertices));
    }
    if (content.box.isEmpty())
        throw Problem(Message("Filling", "%1: the file holds no solid and no surface; export the part as a solid.")
                          .with(fileName(model)));
    return content;
}

void assess(FilledModel& content, const FillingSizes& sizes)
{
    content.fineness = assessSpacing(content.spacing, sizes.all);
    if (!content.fineness.warning.empty())
        content.warnings.push_back(content.fineness.warning);
}

/// Fills every part that has an inside; the others become surfaces.
FilledModel fillModel(std::shared_ptr<const Model> model, const ImportChoices& request, TaskControl& control)
{
    const std::vector<std::size_t> parts = partsToFill(*model, request.fillsOpenParts);
    FilledModel content = emptyFilledModel(*model, request);
    if (!parts.empty()) {
        TaskPortion measuring(control, 0, measuredShare);
        const FillingSizes sizes = fillingSizes(*model, parts, request.spacing, measuring);
        content.spacing = spacingOf(request.spacing, sizes);
        assess(content, sizes);
    }
    TaskPortion filling(control, measuredShare, 1);
    std::set<std::string> names;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        TaskPortion portion = TaskPortion::ofItem(filling, i, parts.size());
        addPart(*model, parts[i], names, content, portion);
    }
    addSurfaces(*model, parts, content);
    content.model = std::move(model);
    return content;
}

/// Bodies at rest on a floor.
Scene restScene(const FilledModel& content)
{
    Scene scene;
    for (const auto& body : content.bodies)
        scene.bodies.push_back(
            {.name = body->name, .aggregate = body->aggregate, .surface = surfaceOf(content.model, body->part)});
    scene.floorHeight = content.box.min().z();
    scene.integrator = Integrator::automatic;
    scene.touching = content.request.touching;
    return scene;
}

PreparedModel withFrame(FilledModel content, Scene scene)
{
    Simulation simulation(scene);
    Gesture first = endGesture(simulation);
    FramePointer frame = prepareFrame(content.bodies, simulation.snapshot(), nullptr);
    return {.content = std::move(content),
            .scene = std::move(scene),
            .simulation = std::move(simulation),
            .frame = std::move(frame),
            .first = std::move(first)};
}

} // namespace

std::string uniqueName(const std::string& name, std::set<std::string>& taken)
{
    const std::string base = name.empty() ? "Part" : name;
    std::string candidate = base;
    for (int i = 2; !taken.insert(candidate).second; ++i)
        candidate = base + " " + std::to_string(i);
    return candidate;
}

std::shared_ptr<const FilledBody> filledBody(const Model& model, std::size_t index, const std::string& name,
                                             std::shared_ptr<const Aggregate> aggregate, TaskControl& control)
{
    const Part& part = model.parts[index];
    auto body = std::make_shared<FilledBody>();
    body->part = index;
    body->name = name;
    body->color = part.color.value_or(Color{});
    body->aggregate = std::move(aggregate);
    control.report(0, "preparing the surface");
    body->mesh = refine(part.mesh, body->aggregate->lattice.spacing);
    control.throwIfCancelled();
    body->render = renderMesh(body->mesh);
    TaskPortion skinning(control, 0.25, 1);
    body->skin.emplace(*body->aggregate, body->mesh.vertices, skinning);
    body->surfaceObjects = surfaceObjects(*body->aggregate);
    return withNewFillings(body);
}

Color faceColor(const Part& part, std::uint32_t face)
{
    const Color own = part.color.value_or(Color{});
    return face < part.faces.size() ? part.faces[face].color.value_or(own) : own;
}

std::string nameOfFace(const FilledModel& content, BodyId body, std::uint32_t face)
{
    return tellingName(content.model->parts[content.bodies[body]->part].faces, face);
}

std::set<std::size_t> FilledModel::hiddenAtFirst() const
{
    std::set<std::size_t> hidden;
    for (std::size_t p = 0; p < model->parts.size(); ++p)
        if (!model->parts[p].visible)
            hidden.insert(p);
    return hidden;
}

PreparedModel prepareFiles(const ImportFiles& import, const ImportChoices& request, const Material& material,
                           TaskControl& control)
{
    TaskPortion importing(control, 0, importShare);
    auto model = std::make_shared<const Model>(import(request.paths, request.options, importing));
    TaskPortion filling(control, importShare, 1);
    return prepareModel(std::move(model), request, material, filling);
}

PreparedModel prepareModel(std::shared_ptr<const Model> model, const ImportChoices& request, const Material& material,
                           TaskControl& control)
{
    TaskPortion filling(control, 0, preparedShare);
    FilledModel content = fillModel(std::move(model), request, filling);
    control.report(preparedShare, "preparing the simulation");
    Scene scene = restScene(content);
    for (Body& body : scene.bodies)
        body.material = material;
    return withFrame(std::move(content), std::move(scene));
}

PreparedModel prepareRecipe(RecipeStart recipe, TaskControl& control)
{
    TaskPortion preparing(control, 0, preparedShare);
    FilledModel content = contentOf(recipe.model, recipe.choices, recipe.start, preparing);
    content.warnings = std::move(recipe.warnings);
    control.report(preparedShare, "preparing the simulation");
    PreparedModel prepared = withFrame(std::move(content), std::move(recipe.start.scene));
    prepared.script = std::move(recipe.script);
    prepared.fixtures = std::move(recipe.fixtures);
    return prepared;
}

namespace {

/// As a moment has it, with the bodies of another content.
Scene keptScene(const FilledModel& content, const PartsInstead& parts, const FilledModel& before, const Snapshot& now)
{
    Scene scene = restScene(content);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        scene.bodies[b].material = parts.material;
        for (std::size_t earlier = 0; earlier < before.bodies.size(); ++earlier)
            if (before.bodies[earlier]->part == parts.origin[content.bodies[b]->part]) {
                scene.bodies[b].material = now.materials[earlier];
                scene.bodies[b].kind = now.bodies[earlier].kind;
            }
    }
    for (const ToolState& tool : now.tools)
        scene.manipulators.push_back({.name = tool.name,
                                      .size = tool.size,
                                      .pose = tool.pose,
                                      .friction = tool.friction,
                                      .speedLimit = tool.speedLimit,
                                      .forceLimit = tool.forceLimit,
                                      .motion = HoldStill{},
                                      .kind = tool.kind,
                                      .part = tool.part,
                                      .adhesion = tool.adhesion,
                                      .rollsFreely = tool.rollsFreely});
    scene.gravity = now.gravity;
    scene.integrator = now.wantedIntegrator;
    scene.floorHeight = now.floorHeight;
    scene.floorFriction = now.floorFriction;
    scene.floorAdhesion = now.floorAdhesion;
    return scene;
}

FilledModel filledAgain(std::shared_ptr<const Model> model, const ImportChoices& choices, double spacing,
                        TaskControl& control)
{
    TaskPortion filling(control, 0, preparedShare);
    ImportChoices request = choices;
    if (spacing > 0) // else there were only surfaces
        request.spacing = SpacingChoice{SpacingChoice::Kind::Length, spacing};
    FilledModel content = fillModel(std::move(model), request, filling);
    if (content.bodies.empty() && !content.unfilled.empty())
        throw Problem(content.unfilled.begin()->second);
    control.report(preparedShare, "preparing the simulation");
    return content;
}

} // namespace

PreparedModel prepareRefill(const FilledModel& before, double spacing, const Snapshot& now,
                            const std::vector<FaceFixture>& fixtures, TaskControl& control)
{
    FilledModel content = filledAgain(before.model, before.request, spacing, control);
    PartsInstead same{.model = before.model, .origin = std::vector<std::size_t>(before.model->parts.size())};
    std::iota(same.origin.begin(), same.origin.end(), std::size_t{0});
    Scene scene = keptScene(content, same, before, now);
    scene.fixtures = sceneFixtures(content, fixtures);
    return withFrame(std::move(content), std::move(scene));
}

namespace {

/// Those that hold no faces, on bodies whose objects are the same ones as before.
void keepFixturesOfObjects(const FilledModel& content, const PartsInstead& parts, const FilledModel& before,
                           const Snapshot& now, std::vector<Fixture>& fixtures)
{
    for (const Fixture& held : now.fixtures) {
        if (std::ranges::count(fixtures, held.name, &Fixture::name) > 0)
            continue;
        const Lattice& then = now.bodies[held.body].aggregate->lattice;
        for (BodyId body = 0; body < content.bodies.size(); ++body) {
            const Lattice& lattice = content.bodies[body]->aggregate->lattice;
            if (parts.origin[content.bodies[body]->part] == before.bodies[held.body]->part &&
                lattice.nodes == then.nodes && lattice.origin == then.origin)
                fixtures.push_back({held.name, body, held.objects});
        }
    }
}

} // namespace

PreparedModel prepareInstead(const FilledModel& before, const PartsInstead& parts, const Snapshot& now,
                             const std::function<std::vector<FaceFixture>(const FilledModel&)>& fixturesIn,
                             TaskControl& control)
{
    FilledModel content = filledAgain(parts.model, before.request, before.spacing, control);
    Scene scene = keptScene(content, parts, before, now);
    if (scene.floorHeight) // what reaches below it now would be thrown up
        scene.floorHeight = std::min(*scene.floorHeight, content.box.min().z());
    std::vector<FaceFixture> fixtures = fixturesIn(content);
    scene.fixtures = sceneFixtures(content, fixtures);
    keepFixturesOfObjects(content, parts, before, now, scene.fixtures);
    PreparedModel prepared = withFrame(std::move(content), std::move(scene));
    prepared.fixtures = std::move(fixtures);
    return prepared;
}

FilledModel contentOf(std::shared_ptr<const Model> model, const ImportChoices& choices, const ProjectStart& start,
                      TaskControl& control)
{
    FilledModel content = emptyFilledModel(*model, choices);
    const std::vector<Body>& bodies = start.scene.bodies;
    if (!bodies.empty()) {
        content.spacing = bodies.front().aggregate->lattice.spacing;
        TaskPortion measuring(control, 0, measuredShare);
        assess(content, fillingSizes(*model, start.partOfBody, choices.spacing, measuring));
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        TaskPortion rest(control, measuredShare, 1);
        TaskPortion portion = TaskPortion::ofItem(rest, b, bodies.size());
        content.bodies.push_back(filledBody(*model, start.partOfBody[b], bodies[b].name, bodies[b].aggregate, portion));
    }
    addSurfaces(*model, start.partOfBody, content);
    content.model = std::move(model);
    return content;
}

ProjectStart startOf(const FilledModel& content, Scene scene)
{
    ProjectStart start{.scene = std::move(scene), .partOfBody = {}};
    for (const auto& body : content.bodies)
        start.partOfBody.push_back(body->part);
    return start;
}

} // namespace knead
