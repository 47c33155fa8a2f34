#include "app/recipe_scene.h"

#include "core/aggregate/fill.h"
#include "io/importer.h"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace knead {

namespace {

// Shares of the progress of making a scene.
constexpr double importShare = 0.5;

std::string fileName(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

[[noreturn]] void refuse(const Recipe& recipe, const std::string& saying)
{
    throw UnusableInput(fileName(recipe.file) + ": " + saying);
}

TriangleMesh joined(const std::vector<Part>& parts)
{
    TriangleMesh all;
    for (const Part& part : parts) {
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
        for (const TriangleMesh::Triangle& t : part.mesh.triangles)
            all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return all;
}

double spacingFor(const RecipeResolution& resolution, const std::vector<Part>& parts)
{
    using Kind = RecipeResolution::Kind;
    switch (resolution.kind) {
    case Kind::CellsAcross:
        return spacingForCellsAcross(joined(parts), resolution.value);
    case Kind::Objects:
        return spacingForObjectCount(joined(parts), resolution.value);
    case Kind::Spacing:
        break;
    }
    return resolution.value;
}

Model import(const Recipe& recipe, TaskControl& control)
{
    try {
        return importFile(recipe.part, {}, control);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UnusableInput(error.what());
    }
}

void importParts(const Recipe& recipe, RecipeScene& result, TaskControl& control)
{
    Model model = import(recipe, control);
    result.warnings = std::move(model.warnings);
    for (Part& part : model.parts) {
        result.warnings.insert(result.warnings.end(), part.warnings.begin(), part.warnings.end());
        if (part.canBeFilled())
            result.parts.push_back(std::move(part));
        else
            result.warnings.push_back("\"" + part.name + "\" is not closed and is left out.");
    }
    if (result.parts.empty())
        throw UnusableInput(fileName(recipe.part) +
                            ": no closed body found. Close the surfaces in the CAD program and export again.");
}

/// The filling knows no names; in an assembly they matter.
Aggregate fillPart(const Part& part, const FillOptions& options, TaskControl& control)
{
    try {
        return fill(part.mesh, options, control);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("\"" + part.name + "\": " + error.what());
    }
}

void fillParts(const Recipe& recipe, RecipeScene& result, TaskControl& control)
{
    const FillOptions options{.spacing = spacingFor(recipe.resolution, result.parts)};
    const auto count = static_cast<double>(result.parts.size());
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        TaskPortion portion(control, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        const Part& part = result.parts[i];
        auto aggregate = std::make_shared<const Aggregate>(fillPart(part, options, portion));
        result.scene.bodies.push_back(
            {.name = part.name, .aggregate = std::move(aggregate), .material = recipe.material});
    }
}

void assignBodyMaterials(const Recipe& recipe, RecipeScene& result)
{
    for (const auto& [name, material] : recipe.bodyMaterials)
        for (const BodyId body : bodiesNamed(name, result.parts, fileName(recipe.file) + ": body_materials"))
            result.scene.bodies[body].material = material;
}

std::vector<ObjectIndex> objectsAtFaces(const Recipe& recipe, const RecipeFixture& fixture, const Part& part,
                                        const Aggregate& aggregate)
{
    const std::string quoted = "\"" + part.name + "\"";
    if (part.faces.empty())
        refuse(recipe, "the fixture \"" + fixture.name + "\" names faces, but " + quoted +
                           " is a mesh without CAD faces; use box_mm.");
    for (const std::uint32_t face : fixture.faces)
        if (face >= part.faces.size())
            refuse(recipe, "the fixture \"" + fixture.name + "\" names the face " + std::to_string(face) + ", but " +
                               quoted + " has faces 0 to " + std::to_string(part.faces.size() - 1) + ".");
    return objectsAtFaces(aggregate, part.mesh, fixture.faces);
}

/// Adds one fixture of the scene for every body it holds.
std::vector<FixtureId> addFixture(const Recipe& recipe, const RecipeFixture& fixture, RecipeScene& result)
{
    const std::string place = fileName(recipe.file) + ": the fixture \"" + fixture.name + "\"";
    const std::vector<BodyId> bodies = bodiesNamed(fixture.body, result.parts, place);
    if (!fixture.box && bodies.size() > 1)
        refuse(recipe, "the fixture \"" + fixture.name + "\" names faces of one body among several; add the key body.");

    std::vector<FixtureId> ids;
    for (const BodyId body : bodies) {
        const Aggregate& aggregate = *result.scene.bodies[body].aggregate;
        std::vector<ObjectIndex> objects = fixture.box ? objectsInBox(aggregate, *fixture.box)
                                                       : objectsAtFaces(recipe, fixture, result.parts[body], aggregate);
        if (objects.empty())
            continue;
        ids.push_back(static_cast<FixtureId>(result.scene.fixtures.size()));
        result.scene.fixtures.push_back({fixture.name, body, std::move(objects)});
    }
    if (ids.empty())
        refuse(recipe, "the fixture \"" + fixture.name + "\" holds nothing: no object lies there.");
    return ids;
}

} // namespace

std::vector<BodyId> bodiesNamed(const std::string& name, const std::vector<Part>& parts, const std::string& place)
{
    std::vector<BodyId> bodies;
    std::string known;
    for (BodyId body = 0; body < parts.size(); ++body) {
        if (name.empty() || parts[body].name == name || parts[body].path == name)
            bodies.push_back(body);
        known += (known.empty() ? "\"" : ", \"") + parts[body].name + "\"";
    }
    if (bodies.empty())
        throw UnusableInput(place + " names the body \"" + name + "\"; the part has: " + known + ".");
    return bodies;
}

RecipeScene buildScene(const Recipe& recipe, TaskControl& control)
{
    RecipeScene result;
    TaskPortion importing(control, 0, importShare);
    importParts(recipe, result, importing);
    TaskPortion filling(control, importShare, 1);
    fillParts(recipe, result, filling);

    assignBodyMaterials(recipe, result);
    for (const RecipeFixture& fixture : recipe.fixtures)
        result.fixtureIds.push_back(addFixture(recipe, fixture, result));
    result.scene.manipulators = recipe.manipulators;
    result.scene.gravity = recipe.gravity;
    if (recipe.floor) {
        result.scene.floorHeight = recipe.floor->height;
        result.scene.floorFriction = recipe.floor->friction;
    }
    return result;
}

} // namespace knead
