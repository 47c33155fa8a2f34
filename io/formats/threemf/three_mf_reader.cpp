#include "io/formats/threemf/three_mf_reader.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "core/model/readable_name.h"
#include "io/document/part_selection.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_reader.h"
#include "io/formats/threemf/three_mf_package.h"
#include "io/mesh/mesh_colors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr int mostObjects = 100'000; // instances; no program could show more
constexpr int deepestNesting = 200;

using Placement = Eigen::Affine3d;

class ThreeMfReader {
public:
    ThreeMfReader(const std::string& path, const ImportOptions& options, TaskControl& control)
        : m_path(path)
        , m_control(control)
        , m_selection(options.parts)
    {
    }

    Model run()
    {
        load();
        m_model.format = formatOf(FormatKind::ThreeMf).name;
        m_model.unit = m_package.unit;
        m_metres = findLengthUnit(m_model.unit)->metres;
        const std::string stem = readableName(std::string_view(std::filesystem::path(m_path).stem().string()));
        m_model.tree.name = stem.empty() ? "part" : stem;
        addBuildItems();
        m_selection.finish(m_path, m_model);
        return std::move(m_model);
    }

private:
    void load()
    {
        TaskPortion reading(m_control, 0, 0.5);
        m_package = readThreeMfPackage(m_path, reading);
        const std::size_t flaws = m_package.flaws;
        if (flaws > 0)
            m_model.warnings.push_back(flaws == 1
                                           ? Message("Import", "%1: the 3MF does not keep to the format in 1 place; "
                                                               "compare the parts with the program that wrote it.")
                                                 .with(shortName(m_path))
                                           : Message("Import", "%1: the 3MF does not keep to the format in %2 places; "
                                                               "compare the parts with the program that wrote it.")
                                                 .with(shortName(m_path), flaws));
        std::string extensions;
        for (const std::string& extension : m_package.unknownExtensions)
            extensions += (extensions.empty() ? "" : ", ") + readableName(std::string_view(extension));
        if (!extensions.empty())
            m_model.warnings.push_back(Message("Import",
                                               "%1: the 3MF requires what is not read here (%2), and parts may "
                                               "be stand-ins; compare them with the program that wrote it.")
                                           .with(shortName(m_path), extensions));
    }

    void addBuildItems()
    {
        for (const ThreeMfPlaced& item : m_package.build)
            addObject(item.object, item.placement, m_model.tree, {}, 0);
        if (m_package.build.empty())
            failReading(m_path,
                        Message("Import", "the 3MF builds no object; export it again with the parts in its build."));
    }

    void addObject(const ThreeMfId& id, const Placement& placement, PartNode& parent, const std::string& parentPath,
                   int depth)
    {
        m_control.throwIfCancelled();
        if (++m_objects > mostObjects || depth > deepestNesting)
            failReading(m_path, Message("Import", "the 3MF unfolds to more than %1 objects, or nests them more than %2 "
                                                  "deep; export the parts you need.")
                                    .with(mostObjects, deepestNesting));
        const ThreeMfObject& object = m_package.object(id);
        const std::string own = readableName(std::string_view(object.name));
        const std::string name = isGeneratedName(own) ? parent.name : own;
        if (object.isMesh)
            return addMesh(object, placement, name, parent, parentPath);
        PartNode node;
        node.name = name;
        const std::string path = parentPath.empty() ? name : parentPath + "/" + name;
        for (const ThreeMfPlaced& component : object.components)
            addObject(component.object, placement * component.placement, node, path, depth + 1);
        parent.children.push_back(std::move(node));
    }

    void addMesh(const ThreeMfObject& object, const Placement& placement, const std::string& name, PartNode& parent,
                 const std::string& parentPath)
    {
        if (!m_selection.wants(parentPath, name))
            return;
        Part part;
        part.name = name;
        part.path = parentPath.empty() ? name : parentPath + "/" + name;
        copyMesh(object, placement, part);
        if (part.mesh.empty()) {
            m_model.missing.push_back(Message("Import", "\"%1\" has no triangles.").with(part.path));
            return;
        }
        part.layer = object.layer;
        part.visible = object.layer.empty();
        parent.children.push_back({name, m_model.parts.size(), {}});
        m_model.parts.push_back(std::move(part));
    }

    void copyMesh(const ThreeMfObject& object, const Placement& placement, Part& part)
    {
        m_triangles +=
            std::max(object.mesh.triangles.size(), object.mesh.vertices.size() / 3); // none on its own has more
        if (m_triangles > mostThreeMfTriangles)
            failReading(
                m_path,
                Message("Import", "the 3MF unfolds to more than 200 million triangles; export the parts you need."));
        if (object.mesh.triangles.empty())
            return;
        part.mesh.vertices.reserve(object.mesh.vertices.size());
        for (const Vec3& vertex : object.mesh.vertices)
            part.mesh.vertices.push_back(m_metres * (placement * vertex));
        part.mesh.triangles = object.mesh.triangles;
        if (placement.linear().determinant() < 0)
            for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
                std::swap(triangle[1], triangle[2]);
        paintTriangles(part, object.colors);
    }

    const std::string& m_path;
    TaskControl& m_control;
    PartSelection m_selection;
    ThreeMfPackage m_package;
    Model m_model;
    double m_metres = 1e-3; // in one unit of the file
    int m_objects = 0;
    std::size_t m_triangles = 0;
};

} // namespace

Model readThreeMf(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    try {
        Model model = ThreeMfReader(path, options, control).run();
        measureMeshes(path, options, model, control);
        return model;
    } catch (const DamagedThreeMf&) {
        failReading(path, Message("Import", "the %1 file is damaged and cannot be read; export it again.").with("3MF"));
    }
}

} // namespace knead
