#include "io/formats/mesh_reader.h"

#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/model/readable_name.h"
#include "io/brep/millimeter.h"
#include "io/document/part_selection.h"
#include "io/document/size_limits.h"
#include "io/files/neighbor_file.h"
#include "io/formats/gltf/gltf_check.h"
#include "io/formats/ply/ply_check.h"
#include "io/mesh/mesh_colors.h"
#include "io/mesh/mesh_repair.h"
#include "io/mesh/open_borders.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

namespace knead {

namespace {

constexpr double weldingShare = 2e-7; // of the diagonal: what single precision of the files leaves of equal points

class AssimpProgress final : public Assimp::ProgressHandler {
public:
    explicit AssimpProgress(TaskControl& control)
        : m_control(control)
    {
    }

    bool Update(float fraction) override
    {
        m_control.report(std::clamp(static_cast<double>(fraction), 0.0, 1.0) / 2, "reading the file");
        return !m_control.isCancelled();
    }

private:
    TaskControl& m_control;
};

/// assimp goes by the ending, we by the content: shows it the file under a name that ends as its content is. Files
/// beside it, which hold colors and numbers, are found as usual; there are no others.
class NamedByContent final : public Assimp::DefaultIOSystem {
public:
    NamedByContent(std::string path, const std::string& ending)
        : m_path(std::move(path))
        , m_shownPath(m_path + "." + ending)
    {
    }

    const std::string& shownPath() const { return m_shownPath; }
    bool Exists(const char* file) const override { return isOwn(file) && DefaultIOSystem::Exists(real(file)); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        return isOwn(file) ? DefaultIOSystem::Open(real(file), mode) : nullptr;
    }

private:
    bool isOwn(const char* file) const { return file == m_shownPath || isNeighborFile(file, m_path); }
    const char* real(const char* file) const { return file == m_shownPath ? m_path.c_str() : file; }

    std::string m_path;
    std::string m_shownPath;
};

std::string endingFor(const std::string& path, FormatKind kind)
{
    if (kind != FormatKind::Gltf)
        return formatOf(kind).endings.front();
    std::ifstream file(path, std::ios::binary);
    return file.peek() == 'g' ? "glb" : "gltf";
}

/// assimp trusts the numbers of vertices that a file gives.
bool hasAllVertices(const aiScene& scene)
{
    const auto isWhole = [](const aiMesh* mesh) {
        return std::all_of(mesh->mFaces, mesh->mFaces + mesh->mNumFaces, [&](const aiFace& face) {
            return face.mNumIndices > 0 && std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
                                                       [&](unsigned vertex) { return vertex < mesh->mNumVertices; });
        });
    };
    return std::all_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, isWhole);
}

const aiScene* load(Assimp::Importer& importer, const std::string& path, FormatKind kind)
{
    constexpr unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    auto* files = new NamedByContent(path, endingFor(path, kind));
    importer.SetIOHandler(files); // which owns it
    const aiScene* scene = importer.ReadFile(files->shownPath(), 0);
    if (scene != nullptr && !hasAllVertices(*scene))
        failReading(
            path,
            Message("Import", "the %1 file has triangles with corners that are not there; it is damaged, get it again.")
                .with(formatOf(kind).name));
    return scene == nullptr ? nullptr : importer.ApplyPostProcessing(steps);
}

Color toColor(const aiColor4D& color)
{
    return {std::clamp(color.r, 0.0F, 1.0F), std::clamp(color.g, 0.0F, 1.0F), std::clamp(color.b, 0.0F, 1.0F)};
}

/// The color of the material, unless it is assimp's own default; or that of the vertices when they agree.
std::optional<Color> ownColorOf(const aiScene& scene, const aiMesh& mesh, FormatKind kind)
{
    if (const aiColor4D* colors = mesh.mColors[0]; colors != nullptr && mesh.mNumVertices > 0) {
        const bool agree =
            std::all_of(colors, colors + mesh.mNumVertices, [&](const aiColor4D& c) { return c == colors[0]; });
        return agree ? std::optional(toColor(colors[0])) : std::nullopt;
    }
    if (mesh.mMaterialIndex >= scene.mNumMaterials)
        return std::nullopt;
    const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
    aiString name;
    aiColor4D color;
    material.Get(AI_MATKEY_NAME, name);
    // In a glTF materials may have no name, and assimp's own is the last.
    const bool isOwn = kind == FormatKind::Gltf ? mesh.mMaterialIndex + 1 < scene.mNumMaterials
                                                : name.length > 0 && name != aiString(AI_DEFAULT_MATERIAL_NAME);
    if (!isOwn || material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS)
        return std::nullopt;
    return toColor(color);
}

/// The colors of a glTF are linear (glTF 2.0, section 3.9.2), ours are sRGB (IEC 61966-2-1).
Color fromLinear(const Color& color)
{
    const auto channel = [](float x) { return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F; };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

std::optional<Color> colorOf(const aiScene& scene, const aiMesh& mesh, FormatKind kind)
{
    const std::optional<Color> color = ownColorOf(scene, mesh, kind);
    return color && kind == FormatKind::Gltf ? fromLinear(*color) : color;
}

using Placement = Eigen::Affine3d;

/// From the numbers of the file to metres. In a glTF y is up (glTF 2.0, section 3.4), in CAD z is.
Placement placementOfFile(FormatKind kind)
{
    if (kind != FormatKind::Gltf)
        return Placement(Eigen::Scaling(millimeter));
    Placement upright = Placement::Identity();
    upright.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return upright;
}

Placement toPlacement(const aiMatrix4x4& m)
{
    Placement placement = Placement::Identity();
    placement.matrix().topRows<3>() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
    return placement;
}

void append(const aiMesh& from, const Placement& placement, TriangleMesh& to)
{
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    const bool isMirrored = placement.linear().determinant() < 0;
    for (unsigned v = 0; v < from.mNumVertices; ++v)
        to.vertices.push_back(placement * Vec3(from.mVertices[v].x, from.mVertices[v].y, from.mVertices[v].z));
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3)
            continue;
        to.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
        if (isMirrored)
            std::swap(to.triangles.back()[1], to.triangles.back()[2]);
    }
}

/// Empty when a number is none.
Box boxOf(const TriangleMesh& mesh)
{
    Box box;
    for (const Vec3& vertex : mesh.vertices) {
        if (!vertex.allFinite())
            return {};
        box.extend(vertex);
    }
    return box;
}

/// A mesh that is taken as it is must still face outward to be filled.
void turnIfInsideOut(Part& part)
{
    if (massProperties(part.mesh).volume >= 0)
        return;
    part.warnings.push_back(Message("Import", "was inside out and has been turned."));
    for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
        std::swap(triangle[1], triangle[2]);
}

void measure(Part& part, const ImportOptions& options)
{
    const double diagonal = part.box.diagonal().norm();
    part.mesh = weld(part.mesh, weldingShare * diagonal);
    if (options.heal) {
        RepairedMesh better = repaired(std::move(part.mesh), options.capsFlatOpenings);
        part.mesh = std::move(better.mesh);
        part.repairs = std::move(better.repairs);
    }
    part.watertight = isWatertight(part.mesh);
    part.area = massProperties(part.mesh).area;
    if (!part.watertight) {
        part.openEdges = openBordersOf(part.mesh);
        part.warnings.push_back(Message("Import", "is not a closed surface: %1. It is shown and cannot be filled.")
                                    .with(describeBorders(part.openEdges)));
        return;
    }
    if (!options.heal)
        turnIfInsideOut(part);
    part.volume = std::abs(massProperties(part.mesh).volume);
    part.valid = part.volume > 0;
    if (!part.valid) {
        part.watertight = false;
        part.warnings.push_back(Message("Import", "has no volume; it cannot be filled."));
    }
}

class MeshModelMaker {
public:
    MeshModelMaker(const aiScene& scene, const std::string& path, FormatKind kind, const ImportOptions& options)
        : m_scene(scene)
        , m_path(path)
        , m_kind(kind)
        , m_selection(options.parts)
    {
    }

    Model run()
    {
        m_model.format = formatOf(m_kind).name;
        if (m_kind == FormatKind::Gltf)
            m_model.unit = std::string("m");
        m_model.tree.name = partNameFor(m_path);
        addNode(*m_scene.mRootNode, placementOfFile(m_kind), m_model.tree, {});
        m_selection.finish(m_path, m_model);
        return std::move(m_model);
    }

private:
    /// A node with others below is an assembly; what meshes it has itself are a part in it. A root of assimp's own is the file.
    void addNode(const aiNode& node, const Placement& above, PartNode& parent, const std::string& parentPath)
    {
        const Placement placement = above * toPlacement(node.mTransformation);
        const bool isAssembly = node.mNumChildren > 0 && !isMadeUpRoot(node);
        if (!isAssembly) {
            if (node.mNumMeshes > 0)
                addPart(node, placement, parent, parentPath);
            for (unsigned i = 0; i < node.mNumChildren; ++i)
                addNode(*node.mChildren[i], placement, parent, parentPath);
            return;
        }
        PartNode assembly;
        assembly.name = nameOf(node, parent);
        const std::string path = joined(parentPath, assembly.name);
        if (node.mNumMeshes > 0)
            addPart(node, placement, assembly, path);
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            addNode(*node.mChildren[i], placement, assembly, path);
        parent.children.push_back(std::move(assembly));
    }

    /// An object with several materials is several meshes in assimp's scene and one part here.
    void addPart(const aiNode& node, const Placement& placement, PartNode& parent, const std::string& parentPath)
    {
        Part part;
        part.name = nameOf(node, parent);
        part.path = joined(parentPath, part.name);
        if (!m_selection.wants(parentPath, part.name))
            return;
        std::vector<std::optional<Color>> colors;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *m_scene.mMeshes[node.mMeshes[i]];
            append(mesh, placement, part.mesh);
            colors.resize(part.mesh.triangles.size(), colorOf(m_scene, mesh, m_kind));
        }
        if (part.mesh.empty())
            return;
        paintTriangles(part, colors);
        parent.children.push_back({part.name, m_model.parts.size(), {}});
        m_model.parts.push_back(std::move(part));
    }

    static std::string joined(const std::string& parent, const std::string& name)
    {
        return parent.empty() ? name : parent + "/" + name;
    }

    /// assimp makes a root of its own, named after the format or the file, but in a glTF takes the only one there is.
    bool isMadeUpRoot(const aiNode& node) const
    {
        return &node == m_scene.mRootNode && (m_kind != FormatKind::Gltf || isMadeUp(readable(node.mName)));
    }

    std::string nameOf(const aiNode& node, const PartNode& parent) const
    {
        const std::string name = readable(node.mName);
        return isMadeUpRoot(node) || isMadeUp(name) ? parent.name : name;
    }

    static std::string readable(const aiString& name)
    {
        return readableName(std::string_view(name.C_Str(), name.length));
    }

    static bool isMadeUp(const std::string& name)
    {
        return isGeneratedName(name) || name == "defaultobject" || name == "ROOT" || name.starts_with("nodes[");
    }

    const aiScene& m_scene;
    const std::string& m_path;
    FormatKind m_kind;
    PartSelection m_selection;
    Model m_model;
};

} // namespace

Model readMesh(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control)
{
    if (kind == FormatKind::Gltf)
        checkGltf(path);
    else if (kind == FormatKind::Ply)
        checkPly(path);
    Assimp::Importer importer;
    importer.SetProgressHandler(new AssimpProgress(control)); // the importer owns it
    const aiScene* scene = load(importer, path, kind);
    control.throwIfCancelled();
    if (scene == nullptr || scene->mRootNode == nullptr)
        failReading(
            path,
            Message("Import", "the %1 file is damaged and cannot be read; export it again.").with(formatOf(kind).name));
    Model model = MeshModelMaker(*scene, path, kind, options).run();
    measureMeshes(path, options, model, control);
    return model;
}

void measureMeshes(const std::string& path, const ImportOptions& options, Model& model, TaskControl& control)
{
    for (Part& part : model.parts)
        part.box = boxOf(part.mesh);
    leaveOutSickParts(model);
    checkAnyPart(path, model);
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        control.throwIfCancelled();
        control.report(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(model.parts.size()), "measuring parts");
        measure(model.parts[i], options);
    }
}

} // namespace knead
