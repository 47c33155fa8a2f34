#include "ui/document/content.h"

#include "core/aggregate/spacing_choice.h"
#include "core/geometry/refine.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace knead {

namespace {

constexpr double wantedObjects = 3000; // soft rubber of so many runs about in real time on a small machine
constexpr double mostObjects = 8000;   // unasked, for the sake of thin walls
constexpr double importShare = 0.4;    // of the progress bar
constexpr double measuredShare = 0.1;  // of the filling
constexpr double preparedShare = 0.92;
constexpr double surfaceDepth = 0.9; // objects less deep than this many spacings are drawn

std::string fileName(const Model& model)
{
    return std::filesystem::path(model.file).filename().string();
}

std::vector<std::size_t> closedParts(const Model& model)
{
    std::vector<std::size_t> parts;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (model.parts[p].canBeFilled())
            parts.push_back(p);
    return parts;
}

/// Why a part cannot be filled.
std::string openSentence(const Part& part)
{
    if (part.mesh.empty())
        return "\"" + part.name + "\" has no surface, so it is not simulated.";
    return "\"" + part.name +
           "\" is not a closed solid, so it is not simulated: close its surfaces and import it again.";
}

[[noreturn]] void refuse(const Model& model)
{
    if (model.parts.empty())
        throw std::runtime_error(fileName(model) +
                                 ": there is no solid in this file. Export the part as a solid and open it again.");
    int shells = 0;
    for (const Part& part : model.parts)
        shells += part.shells;
    throw std::runtime_error(
        fileName(model) + ": no closed solid found" +
        (shells > 0 ? ", only " + std::to_string(shells) + " open shell" + (shells > 1 ? "s" : "") : "") +
        ". Material needs an inside: close the surfaces and import again.");
}

/// To two digits: a number a person can read and type.
double roundedDown(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

/// Of the parts that are filled.
struct FillingSizes {
    FillingSize all;
    FillingSize largest; ///< by volume
};

FillingSizes measure(const Model& model, const std::vector<std::size_t>& parts, TaskControl& control)
{
    FillingSizes sizes;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double count = static_cast<double>(parts.size());
        TaskPortion portion(control, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        const FillingSize size = sizeWithWalls(model.parts[parts[i]].mesh, portion);
        if (i == 0 || size.volume > sizes.largest.volume)
            sizes.largest = size;
        sizes.all.add(size);
    }
    return sizes;
}

/// One spacing for all bodies: the one that suits the largest, given its share of the objects; finer for the sake of thin
/// walls as far as that is not much slower.
double chosenSpacing(const FillingSizes& sizes)
{
    const auto& [all, largest] = sizes;
    const double share = all.volume > 0 ? largest.volume / all.volume : 1;
    const double usual = spacingFor({SpacingChoice::Kind::Objects, std::max(500.0, wantedObjects * share)}, largest);
    const double forWalls = spacingFor({SpacingChoice::Kind::CellsAcrossWall, fewestCellsAcrossWall}, all);
    const double finest = spacingFor({SpacingChoice::Kind::Objects, mostObjects}, all);
    return roundedDown(std::min(usual, std::max(forWalls, finest)));
}

std::string uniqueName(const std::string& name, std::set<std::string>& taken)
{
    const std::string base = name.empty() ? "Part" : name;
    std::string candidate = base;
    for (int i = 2; !taken.insert(candidate).second; ++i)
        candidate = base + " " + std::to_string(i);
    return candidate;
}

std::vector<ObjectIndex> surfaceObjects(const Aggregate& aggregate)
{
    std::vector<ObjectIndex> objects;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (aggregate.depth[i] < surfaceDepth * aggregate.lattice.spacing)
            objects.push_back(i);
    return objects;
}

std::shared_ptr<const ContentBody> makeBody(const Model& model, std::size_t index, const std::string& name,
                                            double spacing, TaskControl& control)
{
    const Part& part = model.parts[index];
    auto body = std::make_shared<ContentBody>();
    body->part = index;
    body->name = name;
    body->color = part.color.value_or(Color{});
    TaskPortion filling(control, 0, 0.6);
    body->aggregate = std::make_shared<const Aggregate>(fill(part.mesh, {.spacing = spacing}, filling));
    control.report(0.6, "preparing the surface");
    body->mesh = refine(part.mesh, spacing);
    control.throwIfCancelled();
    body->render = renderMesh(body->mesh);
    TaskPortion skinning(control, 0.7, 1);
    body->skin.emplace(*body->aggregate, body->mesh.vertices, skinning);
    body->surfaceObjects = surfaceObjects(*body->aggregate);
    return body;
}

/// Fills every closed part. @param spacing chosen when 0 [m]
Content fillContent(std::shared_ptr<const Model> model, double spacing, TaskControl& control)
{
    const std::vector<std::size_t> parts = closedParts(*model);
    if (parts.empty())
        refuse(*model);

    Content content;
    content.warnings = model->warnings;
    for (const Part& part : model->parts) {
        content.warnings.insert(content.warnings.end(), part.warnings.begin(), part.warnings.end());
        if (!part.canBeFilled())
            content.warnings.push_back(openSentence(part));
    }
    TaskPortion measuring(control, 0, measuredShare);
    const FillingSizes sizes = measure(*model, parts, measuring);
    content.spacing = spacing > 0 ? spacing : chosenSpacing(sizes);
    if (const std::string warning = assessSpacing(content.spacing, sizes.all).warning; !warning.empty())
        content.warnings.push_back(warning);
    TaskPortion filling(control, measuredShare, 1);
    std::set<std::string> names;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double count = static_cast<double>(parts.size());
        TaskPortion portion(filling, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        const Part& part = model->parts[parts[i]];
        content.bodies.push_back(makeBody(*model, parts[i], uniqueName(part.name, names), content.spacing, portion));
        for (const Vec3& vertex : part.mesh.vertices)
            content.box.extend(vertex);
    }
    content.model = std::move(model);
    return content;
}

/// Bodies at rest on a floor.
Scene restScene(const Content& content)
{
    Scene scene;
    for (const auto& body : content.bodies)
        scene.bodies.push_back({.name = body->name, .aggregate = body->aggregate});
    scene.floorHeight = content.box.min().z();
    scene.integrator = Integrator::automatic;
    return scene;
}

} // namespace

Color faceColor(const Part& part, std::uint32_t face)
{
    const Color own = part.color.value_or(Color{});
    return face < part.faces.size() ? part.faces[face].color.value_or(own) : own;
}

PreparedContent prepareFile(const Services& services, const std::string& path, const Material& material,
                            TaskControl& control)
{
    TaskPortion importing(control, 0, importShare);
    auto model = std::make_shared<const Model>(services.import(path, importing));
    TaskPortion filling(control, importShare, preparedShare);
    Content content = fillContent(std::move(model), 0, filling);
    control.report(preparedShare, "preparing the simulation");
    Scene scene = restScene(content);
    for (Body& body : scene.bodies)
        body.material = material;
    Simulation simulation(std::move(scene));
    return {std::move(content), std::move(simulation)};
}

PreparedContent prepareRefill(std::shared_ptr<const Model> model, double spacing, const Snapshot& now,
                              TaskControl& control)
{
    TaskPortion filling(control, 0, preparedShare);
    Content content = fillContent(std::move(model), spacing, filling);
    control.report(preparedShare, "preparing the simulation");
    Scene scene = restScene(content);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        scene.bodies[b].material = now.materials[b];
        scene.bodies[b].kind = now.bodies[b].kind;
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
                                      .part = tool.part});
    scene.gravity = now.gravity;
    scene.integrator = now.wantedIntegrator;
    scene.floorHeight = now.floorHeight;
    Simulation simulation(std::move(scene));
    return {std::move(content), std::move(simulation)};
}

} // namespace knead
