#include "app/compensate/round_files.h"

#include "app/export_file.h"
#include "app/file_content.h"
#include "core/deformation/deformation.h"
#include "core/deformation/kept_faces.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/session/export_jobs.h"
#include "core/session/part_filling.h"
#include "io/files/safe_file.h"
#include "io/formats/mesh_input.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr const char* partName = "part.step";
constexpr const char* meshName = "mesh.inp";
constexpr const char* recipeField = "field.csv";
constexpr double cellsOfMesh = 5000; // where nobody chose a spacing, unless walls need more
constexpr double mostCellsOfMesh = 60'000;
constexpr std::size_t mostTrianglesOfSurface = 100'000; // of a shape that a scan is compared with

/// Two cells across the thinnest wall, as far as that is not too many.
double chosenSpacing(const Model& model, const std::vector<std::size_t>& parts, TaskControl& control)
{
    using Kind = SpacingChoice::Kind;
    const FillingSizes sizes = fillingSizes(model, parts, SpacingChoice{Kind::CellsAcrossWall, 2}, control);
    const double plain = spacingFor({Kind::Objects, cellsOfMesh}, sizes.all);
    const double finest = spacingFor({Kind::Objects, mostCellsOfMesh}, sizes.all);
    const double walls = sizes.all.thinnestWall > 0 ? sizes.all.thinnestWall / 2 : plain;
    return std::clamp(walls, finest, plain);
}

CellMesh meshOfTarget(const Model& model, double wanted, TaskControl& control)
{
    const std::vector<std::size_t> parts = partsToFill(model, false);
    if (parts.empty())
        throw std::runtime_error("{mesh} is for closed parts, and the target has none.");
    const double spacing = wanted > 0 ? wanted : chosenSpacing(model, parts, control);
    std::vector<std::shared_ptr<const Aggregate>> fillings;
    std::vector<FillingToMesh> named;
    for (const std::size_t part : parts) {
        fillings.push_back(fillPart(model.parts[part], spacing, Arrangement::cutCells, control));
        named.push_back(
            {fillings.back().get(), parts.size() == 1 ? "PART" : "PART_" + std::to_string(named.size() + 1)});
    }
    return cellMesh(named);
}

void makeAnew(const std::string& folder)
{
    std::error_code error;
    fs::remove_all(folder, error);
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
        throw std::runtime_error("The folder " + folder + " cannot be made.");
}

std::string contentOf(const std::string& path)
{
    std::optional<std::string> text = textOf(path);
    if (!text)
        throw std::runtime_error(path + ": the file cannot be read.");
    return std::move(*text);
}

bool hasMesh(const std::string& text)
{
    return text.find("{mesh}") != std::string::npos;
}

} // namespace

std::string RoundFiles::filled(std::string text, int round, const std::string& folder) const
{
    const std::array<std::pair<std::string, std::string>, 7> values{
        {{"{part}", partName},
         {"{mesh}", meshName},
         {"{field}", m_study.field},
         {"{folder}", folder},
         {"{round}", std::to_string(round)},
         {"{study}", fs::absolute(m_study.file).lexically_normal().parent_path().string()},
         {"{knead}", fs::read_symlink("/proc/self/exe").string()}}};
    for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at)) {
        const auto here = [&](const auto& value) { return text.compare(at, value.first.size(), value.first) == 0; };
        const auto found = std::ranges::find_if(values, here);
        if (found != values.end())
            text.replace(at, found->first.size(), found->second);
        at += found == values.end() ? 1 : found->second.size();
    }
    return text;
}

RoundCommand RoundFiles::command(int round, const std::string& folder) const
{
    RoundCommand command{.round = round, .folder = folder, .field = m_study.field, .timeLimit = m_study.timeLimit};
    if (m_study.recipe.empty()) {
        for (const std::string& word : m_study.command)
            command.words.push_back(filled(word, round, folder));
        return command;
    }
    command.field = recipeField;
    command.words = {fs::read_symlink("/proc/self/exe").string(),
                     "compensate-recipe",
                     fs::absolute(m_study.recipe).lexically_normal().string(),
                     "--part",
                     partName,
                     "--field",
                     recipeField,
                     "--spacing",
                     std::to_string(1000 * m_points.spacing)};
    return command;
}

bool RoundFiles::wantsMesh() const
{
    return std::ranges::any_of(m_study.command, hasMesh) ||
           std::ranges::any_of(m_study.files, [](const std::string& file) { return hasMesh(contentOf(file)); });
}

void RoundFiles::writeMesh(const std::string& path, const CompensationRound& round, TaskControl& control)
{
    if (m_mesh == nullptr)
        m_mesh = std::make_unique<const CellMesh>(meshOfTarget(m_target, m_study.meshSpacing, control));
    CellMesh mesh = *m_mesh;
    if (const std::optional<FieldDeformation> shape = shapeOf(m_points, round))
        mapOf(*shape, control)->evaluate(m_mesh->nodes, mesh.nodes);
    writeMeshInput(path, mesh);
}

void RoundFiles::prepare(const CompensationRound& round, const RoundCommand& command, TaskControl& control)
{
    makeAnew(command.folder);
    const fs::path folder(command.folder);
    TaskPortion writing(control, 0, 0.9);
    writeReportBeside(writePart((folder / partName).string(), round, writing));
    TaskPortion rest(control, 0.9, 1);
    if (wantsMesh())
        writeMesh((folder / meshName).string(), round, rest);
    for (const std::string& file : m_study.files)
        writeFileSafely((folder / fs::path(file).filename()).string(),
                        filled(contentOf(file), round.number, command.folder));
}

ExportReport RoundFiles::writePart(const std::string& path, const CompensationRound& round, TaskControl& control) const
{
    ExportJob job = exportJobOf(m_target, {}, {});
    if (const std::optional<FieldDeformation> shape = shapeOf(m_points, round)) {
        const auto deformations = std::make_shared<const std::vector<Deformation>>(1, *shape);
        for (PartToExport& part : job.parts)
            part.deformations = deformations;
    }
    return exportFile(path, std::move(job), control);
}

TriangleMesh RoundFiles::surface(const CompensationRound& round, TaskControl& control) const
{
    TriangleMesh all;
    for (const Part& part : m_target.parts)
        all = besides(std::move(all), part.mesh);
    if (const std::optional<FieldDeformation> shape = shapeOf(m_points, round)) {
        all = refine(all, m_points.spacing, mostTrianglesOfSurface);
        mapOf(Deformation(*shape), control)->evaluate(std::vector<Vec3>(all.vertices), all.vertices);
    }
    return all;
}

} // namespace knead
