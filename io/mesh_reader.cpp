#include "io/mesh_reader.h"

#include "core/geometry/mass_properties.h"
#include "io/mesh_repair.h"
#include "io/open_borders.h"
#include "io/readable_name.h"
#include "io/size_limits.h"

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace knead {

namespace {

constexpr double millimeter = 1e-3;
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

std::string stemOf(const std::string& path)
{
    const std::string stem = readableName(std::string_view(std::filesystem::path(path).stem().string()));
    return stem.empty() ? "part" : stem;
}

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// assimp goes by the ending, we by the content. An OBJ is read by its path so that its colors, in a second file, are
/// found.
const aiScene* load(Assimp::Importer& importer, const std::string& path, FormatKind kind)
{
    constexpr unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType;
    const std::string hint = lowerCase(formatName(kind));
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    if (lowerCase(std::filesystem::path(path).extension().string()) == "." + hint)
        return importer.ReadFile(path, steps);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, hint.c_str());
}

Color toColor(const aiColor4D& color)
{
    return {std::clamp(color.r, 0.0F, 1.0F), std::clamp(color.g, 0.0F, 1.0F), std::clamp(color.b, 0.0F, 1.0F)};
}

/// The color of the material, unless it is assimp's own default; or that of the vertices when they agree.
std::optional<Color> colorOf(const aiScene& scene, const aiMesh& mesh)
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
    const bool isOwn = material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS && name.length > 0 &&
                       name != aiString(AI_DEFAULT_MATERIAL_NAME);
    if (!isOwn || material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS)
        return std::nullopt;
    return toColor(color);
}

void append(const aiMesh& from, TriangleMesh& to)
{
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    for (unsigned v = 0; v < from.mNumVertices; ++v)
        to.vertices.push_back(millimeter * Vec3(from.mVertices[v].x, from.mVertices[v].y, from.mVertices[v].z));
    for (unsigned f = 0; f < from.mNumFaces; ++f)
        if (const aiFace& face = from.mFaces[f]; face.mNumIndices == 3)
            to.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
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
    part.warnings.emplace_back("was inside out and has been turned.");
    for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
        std::swap(triangle[1], triangle[2]);
}

void measure(Part& part, bool heal)
{
    const double diagonal = part.box.diagonal().norm();
    part.mesh = weld(part.mesh, weldingShare * diagonal);
    if (heal) {
        RepairedMesh better = repaired(std::move(part.mesh));
        part.mesh = std::move(better.mesh);
        part.repairs = std::move(better.repairs);
    }
    part.watertight = isWatertight(part.mesh);
    part.area = massProperties(part.mesh).area;
    if (!part.watertight) {
        part.openEdges = openBordersOf(part.mesh);
        part.warnings.push_back("is not a closed surface: " + describeBorders(part.openEdges) +
                                ". It is shown and cannot be filled.");
        return;
    }
    if (!heal)
        turnIfInsideOut(part);
    part.volume = std::abs(massProperties(part.mesh).volume);
    part.valid = part.volume > 0;
    if (!part.valid) {
        part.watertight = false;
        part.warnings.emplace_back("has no volume; it cannot be filled.");
    }
}

class MeshModelMaker {
public:
    MeshModelMaker(const aiScene& scene, const std::string& path, const ImportOptions& options, TaskControl& control)
        : m_scene(scene)
        , m_path(path)
        , m_options(options)
        , m_control(control)
    {
    }

    Model run()
    {
        m_model.tree.name = stemOf(m_path);
        addNode(*m_scene.mRootNode);
        checkAnyPart(m_path, m_model);
        for (std::size_t i = 0; i < m_model.parts.size(); ++i) {
            m_control.throwIfCancelled();
            m_control.report(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(m_model.parts.size()),
                             "measuring parts");
            measure(m_model.parts[i], m_options.heal);
        }
        return std::move(m_model);
    }

private:
    void addNode(const aiNode& node)
    {
        if (node.mNumMeshes > 0)
            addPart(node);
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            addNode(*node.mChildren[i]);
    }

    /// An object with several materials is several meshes in assimp's scene and one part here.
    void addPart(const aiNode& node)
    {
        Part part;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *m_scene.mMeshes[node.mMeshes[i]];
            append(mesh, part.mesh);
            if (!part.color)
                part.color = colorOf(m_scene, mesh);
        }
        part.box = boxOf(part.mesh);
        if (part.mesh.empty())
            return;
        part.name = nameOf(node);
        part.path = part.name;
        if (const auto sickness = sicknessOf(part)) {
            m_model.missing.push_back(leftOut(part.name, *sickness));
            return;
        }
        m_model.tree.children.push_back({part.name, m_model.parts.size(), {}});
        m_model.parts.push_back(std::move(part));
    }

    /// The root is named by assimp, after the format or the file.
    std::string nameOf(const aiNode& node) const
    {
        const std::string name = readableName(std::string_view(node.mName.C_Str(), node.mName.length));
        const bool isMadeUp = &node == m_scene.mRootNode || isGeneratedName(name) || name == "defaultobject";
        return isMadeUp ? m_model.tree.name : name;
    }

    const aiScene& m_scene;
    const std::string& m_path;
    const ImportOptions& m_options;
    TaskControl& m_control;
    Model m_model;
};

} // namespace

Model readMesh(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control)
{
    Assimp::Importer importer;
    importer.SetProgressHandler(new AssimpProgress(control)); // the importer owns it
    const aiScene* scene = load(importer, path, kind);
    control.throwIfCancelled();
    if (scene == nullptr || scene->mRootNode == nullptr)
        failReading(path, "the " + formatName(kind) + " file is damaged and cannot be read; export it again.");
    Model model = MeshModelMaker(*scene, path, options, control).run();
    model.format = formatName(kind);
    model.warnings.push_back(shortName(path) + ": " + model.format +
                             " files state no length unit; millimetres were taken.");
    return model;
}

} // namespace knead
