#include "core/model/field_file.h"
#include "core/model/file_preview.h"
#include "fuzz/targets.h"
#include "io/export/job_file.h"
#include "io/fields/field_bytes.h"
#include "io/worker/model_file.h"

#include <utility>

namespace knead::fuzz {

namespace {

FieldFile fieldFile()
{
    FieldFile file{.path = "/home/ann/a.frd", .format = "CalculiX results", .steps = {"0.5", "1"}, .names = {"DISP"}};
    file.name = "DISP";
    file.unit = "mm";
    file.field.nodes = {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 1.0 / 3, 0)};
    file.field.displacements = {Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0, 0, -1e-300)};
    file.warnings = {Message("Field", "The file has %1 time steps; the last one was read (%2).").with(2, "1")};
    return file;
}

NodalMesh nodalMesh()
{
    NodalMesh mesh{.path = "a.inp", .format = "Abaqus or CalculiX input", .unit = "mm"};
    mesh.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    mesh.labels = {1, 2, 5, 9};
    mesh.cells.connectivity = {0, 1, 2, 3};
    mesh.cells.endCell(10);
    mesh.cells.labels = {7};
    mesh.cells.points = {4};
    return mesh;
}

FilePreview preview()
{
    FilePreview preview{.file = "a.step", .size = 12345, .format = "STEP AP242", .solids = 2, .faces = 12, .parts = 2};
    preview.tree = {"root", std::nullopt, {{"a", std::nullopt, {{"one", std::nullopt, {}}}}, {"b", std::nullopt, {}}}};
    return preview;
}

ExportedFile exported()
{
    ExportedFile file{.bytes = std::string("ISO\0;", 5), .report = {}};
    PartExportReport& part = file.report.parts.emplace_back();
    part.name = "Würfel";
    part.reason = Message("Export", "%1 faces").with(3);
    part.remarks = {Message::verbatim("is odd.")};
    part.restVolume = 1.0 / 3;
    part.fold = Vec3(1, 2, 3);
    return file;
}

/// A kind, which comes first, and the bytes.
std::vector<std::string> answers()
{
    return {'\0' + fieldToBytes(fieldFile()), '\1' + meshToBytes(nodalMesh()), '\2' + previewToBytes(preview()),
            '\3' + failureToBytes(Message("Import", "%1: no.").with("bad.step")), '\4' + exportedToBytes(exported())};
}

bool readAnswer(std::string_view input)
{
    if (input.empty())
        return false;
    const std::string_view bytes = input.substr(1);
    return isTaken([&] {
        switch (static_cast<unsigned char>(input.front()) % 5) {
        case 0:
            return requireSameBack(fieldFromBytes(bytes), fieldToBytes, fieldFromBytes);
        case 1:
            return requireSameBack(meshFromBytes(bytes), meshToBytes, meshFromBytes);
        case 2:
            return requireSameBack(previewFromBytes(bytes), previewToBytes, previewFromBytes);
        case 3:
            return requireSameBack(failureIn(bytes), failureToBytes, failureIn);
        default:
            return requireSameBack(exportedFromBytes(bytes), exportedToBytes, exportedFromBytes);
        }
    });
}

} // namespace

Target answerTarget()
{
    return {answers, readAnswer};
}

} // namespace knead::fuzz
