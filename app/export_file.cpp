#include "app/export_file.h"

#include "app/cad_process.h"
#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/former_shape.h"
#include "core/skin/torn_parts.h"
#include "io/export/job_file.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_writer.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t mostFlatFaces = 10'000; // of a torn part: CAD programs are slow with more
constexpr std::size_t mostTriangles = 400'000;
constexpr double surfaceShare = 0.7; // of the progress; the rest is writing

PartExportReport reportOn(const PartToExport& part, const TriangleMesh& mesh)
{
    const MassProperties properties = massProperties(mesh);
    PartExportReport report;
    report.name = part.part.name;
    report.form = PartExportReport::Form::mesh;
    report.remarks = part.remarks;
    report.density = part.density;
    report.solidsBefore = report.solidsAfter = part.part.solids;
    report.facesBefore = static_cast<int>(part.part.faces.size());
    report.facesAfter = static_cast<int>(mesh.triangles.size());
    report.edgesBefore = report.edgesAfter = part.part.edges;
    report.restVolume = part.part.volume;
    report.restVolumeOfMesh = massProperties(part.part.mesh).volume;
    if (part.before) { // its mesh is not that of the import
        report.restVolumeOfMesh = 0;
        report.restVolume = part.before->volume;
        report.facesBefore = part.before->faces;
    }
    report.skinVolume = report.volume = properties.volume;
    report.wasClosed = part.part.watertight;
    report.closed = isWatertight(mesh);
    report.valid = !report.closed || properties.volume > 0;
    report.nameKept = report.colorsKept = true;
    return report;
}

std::vector<MeshField> toMeshFields(const SkinFields& fields)
{
    MeshField displacement{"displacement [m]", 3, {}};
    displacement.values.reserve(3 * fields.displacement.size());
    for (const Vec3& moved : fields.displacement)
        for (const double coordinate : moved)
            displacement.values.push_back(static_cast<float>(coordinate));
    return {std::move(displacement),
            {"equivalent strain", 1, fields.strain},
            {"von Mises stress [Pa]", 1, fields.vonMisesStress},
            {"von Mises stress error [Pa]", 1, fields.stressError}};
}

/// Puts fields into a mesh, and what is to be said of them into the report.
void addFields(const SkinFields& fields, MeshBody& body, PartExportReport& report)
{
    body.fields = toMeshFields(fields);
    if (!fields.vonMisesStress.empty())
        report.largestStress =
            static_cast<double>(*std::max_element(fields.vonMisesStress.begin(), fields.vonMisesStress.end()));
    report.stressErrorShare = fields.stressErrorShare;
}

/// The surface of a part at its present place, with fields.
StrainedSurface strained(const PartToExport& part, TaskControl& control)
{
    const std::vector<BrokenConnection> none;
    const ObjectStrains objects(*part.aggregate, part.displacements, *part.relaxed, part.broken ? *part.broken : none);
    return strainedSurface(part.part.mesh, *part.aggregate, objects, part.loaded, mostTriangles, control);
}

/// What the deformations of a part make of its surface, fine enough to bend.
TriangleMesh deformedMesh(const PartToExport& part, const TriangleMesh& mesh)
{
    constexpr double edges = 200; // across the part
    const double longest = std::max(part.deformed->featureSize() / 4, part.part.box.diagonal().norm() / edges);
    return carriedMesh(mesh, *part.deformed, longest, mostTriangles);
}

ExportReport exportMeshes(const std::string& path, const ExportJob& job, TaskControl& control)
{
    const FileFormat* format = formatToWrite(path); // null: writeMeshes() says so
    const auto start = std::chrono::steady_clock::now();
    ExportReport report;
    report.file = path;
    report.format = "triangles";
    report.unit = format != nullptr && format->isInMetres ? "m" : job.options.unit.empty() ? "mm" : job.options.unit;
    std::vector<MeshBody> bodies;
    const auto count = static_cast<double>(job.parts.size());
    for (const PartToExport& part : job.parts) {
        const auto done = static_cast<double>(bodies.size());
        TaskPortion portion(control, surfaceShare * done / count, surfaceShare * (done + 1) / count);
        MeshBody body{part.part.name, part.part.color.value_or(Color{}), part.part.mesh};
        body.faceColors = faceColorsOf(part.part);
        std::optional<SkinFields> fields;
        if (part.relaxed) {
            StrainedSurface surface = strained(part, portion);
            body.mesh = std::move(surface.mesh);
            fields = std::move(surface.fields);
        } else if (part.aggregate != nullptr) {
            body.mesh = deformedSurface(part.part.mesh, *part.aggregate, part.displacements, mostTriangles, portion);
        }
        if (part.deformed)
            body.mesh = deformedMesh(part, body.mesh);
        if (part.fields)
            fields = *part.fields;
        report.parts.push_back(reportOn(part, body.mesh));
        if (fields)
            addFields(*fields, body, report.parts.back());
        bodies.push_back(std::move(body));
    }
    TaskPortion writing(control, surfaceShare, 1);
    writing.report(0, "writing triangles");
    writeMeshes(path, bodies, job.options, writing);
    std::error_code error;
    report.bytes = std::filesystem::file_size(path, error);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

} // namespace

ExportReport exportFile(const std::string& path, ExportJob job, TaskControl& control)
{
    if (job.parts.empty())
        failReading(path, Message("Export", "there is nothing to export."));
    const FileFormat* format = formatToWrite(path);
    const bool isCad = format != nullptr && format->isSmooth;
    for (PartToExport& part : job.parts)
        if (format == nullptr || !format->holdsFields)
            part.relaxed.reset();
    TaskPortion tearing(control, 0, 0.1);
    ExportJob whole = withPieces(std::move(job), isCad ? mostFlatFaces : mostTriangles, tearing, isCad);
    TaskPortion writing(control, 0.1, 1);
    if (isCad)
        return exportInChild(path, whole, writing);
    makeMaps(whole, writing);
    return exportMeshes(path, whole, writing);
}

std::string problemWithName(const std::string& path)
{
    if (isPicture(path) || formatToWrite(path) != nullptr)
        return {};
    return path + ": the ending is none of " + formatEndings(" and ") + ", nor .png; name the file after its format.";
}

std::string writeReportBeside(const ExportReport& report)
{
    const std::string path = report.file + ".report.json";
    writeFileSafely(path, reportToJson(report));
    return path;
}

} // namespace knead
