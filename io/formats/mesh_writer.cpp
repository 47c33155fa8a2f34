#include "io/formats/mesh_writer.h"

#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/model/length_units.h"
#include "core/model/readable_name.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_formats.h"

#include <algorithm>
#include <string_view>

namespace knead {

namespace {

const MeshWriter& writerFor(const std::string& path)
{
    const auto* const writer = std::find_if(meshWriters.begin(), meshWriters.end(),
                                            [&](const MeshWriter& one) { return one.ending == lowerCaseEnding(path); });
    if (writer == meshWriters.end())
        failReading(path, Message("Export", "the ending is none of %1; name the file after its format.")
                              .with(endingList([](const FileFormat& format) { return !format.isSmooth; })));
    return *writer;
}

const LengthUnit& unitOf(const std::string& path, const ExportOptions& options)
{
    const LengthUnit* unit = findLengthUnit(options.unit.empty() ? "mm" : options.unit);
    if (unit == nullptr)
        failReading(path, Message("Export", "the length unit \"%1\" is not known; known are %2.")
                              .with(options.unit, lengthUnitNames()));
    return *unit;
}

/// Single precision must hold the numbers, in any unit.
void checkNumbers(const std::string& path, const MeshBody& body)
{
    constexpr double farthest = 1e25; // [m]
    const auto isGood = [](const Vec3& vertex) {
        return vertex.cwiseAbs().maxCoeff() < farthest && vertex.allFinite();
    };
    if (!std::all_of(body.mesh.vertices.begin(), body.mesh.vertices.end(), isGood))
        failReading(path,
                    Message("Export",
                            "the surface of \"%1\" leads to infinity; go back to where it was whole and export again.")
                        .with(body.name));
}

MeshFile fileFor(const std::string& path, const std::vector<MeshBody>& bodies, const ExportOptions& options,
                 TaskControl& control)
{
    const LengthUnit& unit = unitOf(path, options);
    MeshFile file{path, unit.name, 1 / unit.metres, options.isText, control};
    for (const MeshBody& body : bodies) {
        if (body.mesh.empty())
            continue;
        checkNumbers(path, body);
        const std::string name = readableName(std::string_view(body.name));
        file.bodies.push_back(&body);
        file.names.push_back(name.empty() ? "part" : name);
        file.vertexCount += body.mesh.vertices.size();
        file.triangleCount += body.mesh.triangles.size();
    }
    if (file.bodies.empty())
        failReading(path, Message("Export", "there is no surface to write."));
    if (std::max(file.vertexCount, file.triangleCount) > INT32_MAX)
        failReading(path,
                    Message("Export", "the surface has more than 2147483647 points or triangles, which the formats "
                                      "cannot count; export fewer bodies."));
    return file;
}

} // namespace

void writeMeshes(const std::string& path, const std::vector<MeshBody>& bodies, const ExportOptions& options,
                 TaskControl& control)
{
    const MeshWriter& writer = writerFor(path);
    control.throwIfCancelled();
    writer.write(fileFor(path, bodies, options, control));
    control.report(1, "writing the file");
}

} // namespace knead
