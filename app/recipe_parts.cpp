#include "app/recipe_parts.h"

#include "app/cad_process.h"

#include <filesystem>
#include <map>

namespace knead {

namespace {

/// A file with its bodies.
struct Opened {
    std::vector<Part> parts; ///< closed ones, at least one
    std::vector<std::string> warnings;
};

Model import(const std::string& file, TaskControl& control)
{
    try {
        return importInChild(file, {}, control);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UnusableInput(error.what());
    }
}

Opened open(const std::string& file, TaskControl& control)
{
    Model model = import(file, control);
    Opened opened{{}, std::move(model.warnings)};
    for (Part& part : model.parts) {
        opened.warnings.insert(opened.warnings.end(), part.warnings.begin(), part.warnings.end());
        if (part.canBeFilled())
            opened.parts.push_back(std::move(part));
        else
            opened.warnings.push_back("\"" + part.name + "\" is not closed and is left out.");
    }
    if (opened.parts.empty())
        throw UnusableInput(std::filesystem::path(file).filename().string() +
                            ": no closed body found. Close the surfaces in the CAD program and export again.");
    return opened;
}

/// Opens each file once.
class Files {
public:
    explicit Files(TaskControl& control)
        : m_control(control)
    {
    }

    const Opened& operator[](const std::string& file)
    {
        const auto known = m_files.find(file);
        return known != m_files.end() ? known->second : m_files.emplace(file, open(file, m_control)).first->second;
    }

private:
    TaskControl& m_control;
    std::map<std::string, Opened> m_files;
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
        part.name = parts.size() > 1 ? part.name : extra.name;
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

RecipeParts importParts(const Recipe& recipe, TaskControl& control)
{
    Files files(control);
    RecipeParts result{files[recipe.part].parts, {}, files[recipe.part].warnings};
    for (const RecipeExtraPart& extra : recipe.extraParts) {
        const Opened& opened = files[extra.file];
        for (Part& part : placed(opened.parts, extra))
            result.bodies.push_back(std::move(part));
        result.warnings.insert(result.warnings.end(), opened.warnings.begin(), opened.warnings.end());
    }
    for (const RecipeManipulator& manipulator : recipe.manipulators)
        result.toolParts.push_back(manipulator.kind == ToolKind::part
                                       ? std::make_shared<const ToolPart>(joinedMesh(files[manipulator.partFile].parts))
                                       : nullptr);
    return result;
}

} // namespace knead
