#include "io/fields/field_reader.h"

#include "core/model/file_formats.h"
#include "core/model/length_units.h"
#include "core/model/readable_name.h"
#include "io/fields/field_content.h"
#include "io/fields/node_merging.h"
#include "io/fields/pvd_files.h"
#include "io/fields/text_scanner.h"
#include "io/files/neighbor_file.h"
#include "io/formats/cad_format.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace knead {

namespace {

constexpr std::size_t headLength = 4096;
constexpr std::size_t readTogether = 1U << 24U; // bytes, between two looks at whether the person cancelled

std::string bytesOfFile(const std::string& path, TaskControl& control)
{
    const auto size = static_cast<std::size_t>(sizeOfFile(path));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(size, '\0');
    std::size_t at = 0;
    while (file && at < size) {
        control.throwIfCancelled();
        file.read(bytes.data() + at, static_cast<std::streamsize>(std::min(size - at, readTogether)));
        at += static_cast<std::size_t>(file.gcount());
    }
    if (at < size)
        failReading(path, Message("Import", "the file cannot be opened; check that you may read it."));
    return bytes;
}

bool isText(std::string_view head)
{
    return std::ranges::none_of(head, [](unsigned char c) { return c < 0x20 && std::isspace(c) == 0; });
}

/// CalculiX begins with "    1C" or "    1U..." or, without them, with its nodes.
bool looksLikeFrd(std::string_view head)
{
    return head.size() > 6 && head.starts_with("    ") && (head[4] == '1' || head[4] == '2') &&
           (head[5] == 'C' || head[5] == 'U' || head[5] == 'P');
}

/// "*NODE" or "*HEADING" behind comments.
bool looksLikeInput(std::string_view head)
{
    while (head.starts_with("**"))
        head = trimmedText(head.substr(std::min(head.find('\n'), head.size())));
    return head.size() > 1 && head.front() == '*' && std::isalpha(static_cast<unsigned char>(head[1])) != 0;
}

using ReadContent = FieldContent (*)(std::string_view, const FieldRequest&, TaskControl&);

/// @throws Problem: what the file is, when it is none of those that are read
ReadContent readerFor(std::string_view bytes)
{
    const std::string_view head = bytes.substr(0, headLength);
    const std::string_view text = trimmedText(head);
    if (looksLikeFrd(head))
        return readFrd;
    if (text.starts_with("# vtk DataFile"))
        return readLegacyVtk;
    if (text.starts_with('<') && head.find("<VTKFile") != head.npos)
        return readXmlVtk;
    if (text.starts_with("$MeshFormat") || text.starts_with("$Comments"))
        return readGmsh;
    if (head.starts_with("\x1F\x8B"))
        throw Problem(Message("Import", "this is a gzip archive; unpack it and open the file inside."));
    if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF"))
        throw Problem(
            Message("Import", "the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again."));
    if (!isText(head) || text.starts_with('<') || text.starts_with("ISO-10303-21"))
        throw Problem(
            Message("Field", "this is no file of displacements; they are read from %1 files.").with(fieldEndingList()));
    if (looksLikeInput(text))
        return readInput;
    return text.find("Field Output Report") != text.npos ? readReport : readTable;
}

FieldContent contentOfBytes(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    if (bytes.starts_with("\xEF\xBB\xBF"))
        bytes.remove_prefix(3);
    FieldContent content = readerFor(bytes)(bytes, request, control);
    if (content.nodes.empty())
        throw Problem(Message("Field", "it has no nodes; write the results with the mesh."));
    return content;
}

FieldContent contentOfCollection(std::string_view bytes, const std::string& path, const FieldRequest& request,
                                 TaskControl& control)
{
    FieldContent content;
    const auto files = filesAtStep(filesOfCollection(bytes, path), request.choice, content);
    FieldRequest ofFile = request;
    ofFile.choice.step.reset();
    for (std::size_t i = 0; i < files.size(); ++i) {
        TaskPortion portion = TaskPortion::ofItem(control, i, files.size());
        if (std::error_code ignored;
            std::filesystem::exists(files[i].path, ignored) && !isNeighborFile(files[i].path, path))
            throw Problem(Message("Field", "the collection names %1, which is no ordinary file in its folder; put the "
                                           "file beside the collection and open that again.")
                              .with(readableName(files[i].path)));
        const std::string piece = bytesOfFile(files[i].path, control);
        append(content, contentOfBytes(piece, ofFile, portion));
    }
    return content;
}

/// Of ParaView, which names other files.
bool beginsAsCollection(std::string_view bytes)
{
    const std::string_view head = bytes.substr(0, headLength);
    return head.find("<VTKFile") != head.npos && head.find("\"Collection\"") != head.npos;
}

/// @throws Problem that names the file
FieldContent contentOf(const std::string& path, const FieldRequest& request, TaskControl& control)
{
    const std::string bytes = bytesOfFile(path, control);
    try {
        return beginsAsCollection(bytes) ? contentOfCollection(bytes, path, request, control)
                                         : contentOfBytes(bytes, request, control);
    } catch (const Problem& problem) {
        failReading(path, problem.message());
    }
}

/// The first of them that says something, else mm. @throws Problem, when it is not known
const LengthUnit& unitOf(const std::string& path, const std::string& wanted, const std::string& said)
{
    const std::string& text = !wanted.empty() ? wanted : said;
    const LengthUnit* unit = findLengthUnit(text.empty() ? "mm" : text);
    if (unit == nullptr)
        failReading(path, Message("Unit", "the length unit \"%1\" that was asked for is not known; known are %2.")
                              .with(readableName(text), lengthUnitNames()));
    return *unit;
}

/// What is wanted holds for both, but where the file gives displacements in another unit than places.
const LengthUnit& unitOfValues(const std::string& path, const FieldContent& content, const std::string& wanted)
{
    const LengthUnit& nodes = unitOf(path, wanted, content.unit);
    const bool isOther = !content.valueUnit.empty() &&
                         (content.unit.empty() || content.valueUnit != unitOf(path, {}, content.unit).name);
    return isOther ? unitOf(path, {}, content.valueUnit) : nodes;
}

void addRemarks(const FieldContent& content, const FieldChoice& choice, FieldFile& file)
{
    if (content.steps.size() > 1 && !choice.step)
        file.warnings.push_back(Message("Field", "The file has %1 time steps; the last one was read (%2).")
                                    .with(content.steps.size(), content.steps[content.step]));
    if (content.unit.empty() && choice.unit.empty())
        file.warnings.push_back(noUnitStated(shortName(file.path)));
}

} // namespace

bool isFieldCollection(const std::string& path)
{
    std::string head(std::min<std::size_t>(sizeOfFile(path), headLength), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    return beginsAsCollection(head);
}

FieldFile readField(const std::string& path, const FieldChoice& choice, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.9);
    const FieldContent content = contentOf(path, {choice, false}, reading);
    const LengthUnit& unit = unitOf(path, choice.unit, content.unit);
    FieldFile file{.path = path,
                   .format = content.format,
                   .steps = content.steps,
                   .names = content.names,
                   .step = content.step,
                   .name = content.name,
                   .unit = unit.name,
                   .warnings = content.warnings};
    addRemarks(content, choice, file);
    file.field = mergedField(content, unit.metres, unitOfValues(path, content, choice.unit).metres, file.warnings);
    if (file.field.isEmpty())
        failReading(path, Message("Field", "no node in it has a displacement; write the displacements into it, too."));
    control.report(1, "done");
    return file;
}

NodalMesh readNodes(const std::string& path, const std::string& unit, TaskControl& control)
{
    FieldRequest request;
    request.isForMesh = true;
    FieldContent content = contentOf(path, request, control);
    const LengthUnit& known = unitOf(path, unit, content.unit);
    for (Vec3& node : content.nodes) {
        node *= known.metres;
        if (!isSensible(node))
            failReading(path, Message("Field", "a node has a coordinate that is no number, or far too large; write the "
                                               "file again."));
    }
    const auto count = static_cast<std::int64_t>(content.nodes.size());
    if (std::ranges::any_of(content.cells.connectivity, [&](std::int64_t node) { return node < 0 || node >= count; }))
        failReading(path, Message("Field", "the file is damaged; write it again with the program it comes from."));
    return {path,
            content.format,
            known.name,
            std::move(content.nodes),
            std::move(content.labels),
            std::move(content.cells),
            std::move(content.warnings)};
}

} // namespace knead
