#include "core/session/recipe_parts.h"

#include "core/model/file_names.h"
#include "core/session/recipe_deforming.h"

#include <map>

namespace knead {

namespace {

/// A file with its bodies.
struct Opened {
    std::vector<Part> parts; ///< closed ones, at least one
    std::vector<Message> warnings;
    Model source = {}; ///< without its parts
};

/// What is wrong with a file is wrong with what the person asked for.
template <class Read>
auto asInput(Read read)
{
    try {
        return read();
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UnusableInput(messageOf(error));
    }
}

Opened opened(Model model, const std::string& file, bool fillsOpenParts)
{
    Opened opened;
    const auto warn = [&](const std::vector<Message>& sentences) {
        opened.warnings.insert(opened.warnings.end(), sentences.begin(), sentences.end());
    };
    warn(model.warnings);
    warn(model.missing);
    for (Part& part : model.parts) {
        warn(part.warnings);
        if (part.canBeFilled() || (fillsOpenParts && !part.mesh.empty()))
            opened.parts.push_back(std::move(part));
        else
            opened.warnings.push_back(Message("Recipe", "\"%1\" is not closed and is left out.").with(part.name));
    }
    model.parts.clear();
    opened.source = std::move(model);
    if (opened.parts.empty())
        throw UnusableInput(
            Message("Filling", "%1: no closed body found. Close the surfaces in the CAD program and export again.")
                .with(shortName(file)));
    return opened;
}

/// Opens each file once.
class Files {
public:
    Files(const RecipeFiles& files, TaskControl& control)
        : m_io(files)
        , m_control(control)
    {
    }

    /// With the choices that the importer makes.
    const Opened& operator[](const std::string& file)
    {
        const auto known = m_files.find(file);
        if (known != m_files.end())
            return known->second;
        return m_files.emplace(file, opened(asInput([&] { return m_io.import({file}, {}, m_control); }), file, false))
            .first->second;
    }

    /// The part of a recipe, with the choices of the recipe.
    Opened part(const Recipe& recipe)
    {
        std::vector<Message> warnings;
        Model model = asInput([&] { return deformedParts(modelFor(recipe), recipe, m_io, warnings, m_control); });
        Opened part = opened(std::move(model), recipe.part, recipe.fillsOpenParts);
        part.warnings.insert(part.warnings.end(), warnings.begin(), warnings.end());
        return part;
    }

    std::shared_ptr<const ToolPart> toolPart(const RecipeManipulator& manipulator)
    {
        if (manipulator.kind != ToolKind::part)
            return nullptr;
        if (!m_io.isProject(manipulator.partFile))
            return std::make_shared<const ToolPart>(joinedMesh((*this)[manipulator.partFile].parts));
        const auto parts = toolPartsOf(project(manipulator.partFile));
        const std::size_t number = manipulator.partNumber.value_or(0);
        if (number >= parts.size())
            throw UnusableInput(Message("Recipe", "%1 has no tool part %2; it has %3 of them, counted from 0.")
                                    .with(shortName(manipulator.partFile), number, parts.size()));
        return parts[number];
    }

private:
    /// As it is in the file, or in the project.
    Model modelFor(const Recipe& recipe)
    {
        if (m_io.isProject(recipe.part))
            return modelOf(recipe.part);
        std::vector<std::string> paths{recipe.part};
        paths.insert(paths.end(), recipe.partsBeside.begin(), recipe.partsBeside.end());
        return m_io.import(paths, recipe.import, m_control);
    }

    const Project& project(const std::string& file)
    {
        const auto known = m_projects.find(file);
        if (known != m_projects.end())
            return known->second;
        return m_projects.emplace(file, asInput([&] { return m_io.readProject(file, m_control); })).first->second;
    }

    Model modelOf(const std::string& file)
    {
        const std::shared_ptr<const Model> model = shownModel(project(file));
        if (model == nullptr)
            throw UnusableInput(aboutFile(file, Message("Recipe", "the project has no parts.")));
        return *model;
    }

    const RecipeFiles& m_io;
    TaskControl& m_control;
    std::map<std::string, Opened> m_files;
    std::map<std::string, Project> m_projects;
};

void place(Part& part, const Pose& pose)
{
    part.box = Box();
    for (Vec3& vertex : part.mesh.vertices) {
        vertex = pose.toWorld(vertex);
        part.box.extend(vertex);
    }
}

/// Two parts of one file differ by their names: the body takes the name, or several get it as the first of their path.
std::vector<Part> placed(std::vector<Part> parts, const RecipeExtraPart& extra)
{
    for (Part& part : parts) {
        place(part, extra.pose);
        if (extra.name.empty())
            continue;
        part.path = parts.size() > 1 ? extra.name + "/" + part.path : extra.name;
        if (parts.size() > 1)
            continue;
        part.name = extra.name;
        part.bodyOf.clear();
    }
    return parts;
}

} // namespace

TriangleMesh joinedMesh(const std::vector<Part>& parts)
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

RecipeParts importParts(const Recipe& recipe, const RecipeFiles& io, TaskControl& control)
{
    Files files(io, control);
    Opened part = files.part(recipe);
    RecipeParts result{std::move(part.source), std::move(part.parts), {}, {}, std::move(part.warnings)};
    for (const RecipeExtraPart& extra : recipe.extraParts) {
        const Opened& opened = files[extra.file];
        for (Part& body : placed(opened.parts, extra))
            result.bodies.push_back(std::move(body));
        result.warnings.insert(result.warnings.end(), opened.warnings.begin(), opened.warnings.end());
    }
    for (const RecipeManipulator& manipulator : recipe.manipulators)
        result.toolParts.push_back(files.toolPart(manipulator));
    for (const RecipeEvent& event : recipe.events) {
        const auto* add = std::get_if<AddRecipeManipulator>(&event.action);
        const auto* reshape = std::get_if<ReshapeRecipeManipulator>(&event.action);
        result.eventParts.push_back(add != nullptr       ? files.toolPart(add->manipulator)
                                    : reshape != nullptr ? files.toolPart(reshape->manipulator)
                                                         : nullptr);
    }
    return result;
}

} // namespace knead
