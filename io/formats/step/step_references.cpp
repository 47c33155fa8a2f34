#include "io/formats/step/step_references.h"

#include "core/message/message.h"
#include "core/model/readable_name.h"
#include "io/files/neighbor_file.h"
#include "io/formats/cad_format.h"
#include "io/formats/step/step_check.h"

#include <STEPConstruct_ExternRefs.hxx>
#include <STEPControl_Reader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

namespace knead {

namespace {

Message missingWords(const std::vector<std::string>& names)
{
    constexpr std::size_t mostNamed = 5;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), mostNamed); ++i)
        list += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > mostNamed)
        list += ", ...";
    if (names.size() == 1)
        return Message("Step", "the assembly refers to the file %1, which is not there: its parts are missing. Put it "
                               "beside the assembly and open that again.")
            .with(list);
    return Message("Step", "the assembly refers to %1 files that are not there: %2. Their parts are missing; put them "
                           "beside the assembly and open that again.")
        .with(names.size(), list);
}

} // namespace

Message checkReferredFiles(const STEPControl_Reader& reader, const std::string& path, TaskControl& control)
{
    STEPConstruct_ExternRefs references(reader.WS());
    references.LoadExternRefs();
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::set<std::string> names;
    for (int i = 1; i <= references.NbExternRefs(); ++i)
        if (const char* name = references.FileName(i); name != nullptr && *name != '\0')
            names.insert(name);
    std::vector<std::string> missing;
    for (const std::string& name : names) {
        control.throwIfCancelled();
        const std::filesystem::path file = folder / name;
        if (!isNamedAs(FormatKind::Step, name))
            continue; // a drawing or another document, which holds no parts
        std::error_code error;
        if (!std::filesystem::exists(file, error))
            missing.push_back(name);
        else if (isNeighborFile(file.string(), path))
            checkStepText(file.string(), control);
        else // the reader would open it
            failReading(path, Message("Step", "the assembly refers to %1, which is no ordinary file in its folder; put "
                                              "the file beside the assembly and open that again.")
                                  .with(readableName(name)));
    }
    return missing.empty() ? Message() : missingWords(missing);
}

Message otherContent(const std::string& path)
{
    struct Kind {
        std::string_view word;
        Message sentence;
    };
    const Message triangles = Message("Step", "the file holds triangles only (tessellated geometry of AP242), which "
                                              "are not read from STEP; export exact solids, or a mesh as 3MF or STL.");
    const Message curves =
        Message("Step", "the file holds curves and points only, no solid and no surface; export the part as a solid.");
    // In the order in which they are worth telling.
    const std::array kinds{
        Kind{"TRIANGULATED_FACE", triangles},
        Kind{"TRIANGULATED_SURFACE_SET", triangles},
        Kind{"GEOMETRIC_CURVE_SET", curves},
        Kind{"GEOMETRICALLY_BOUNDED_WIREFRAME", curves},
    };
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    for (const Kind& kind : kinds)
        if (text.find(kind.word) != std::string::npos)
            return kind.sentence;
    return {};
}

} // namespace knead
