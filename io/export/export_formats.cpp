#include "io/export/export_formats.h"

#include "io/formats/mesh_writer.h"

#include <algorithm>

namespace knead {

namespace {

bool has(const FileFormat& format, const std::string& ending)
{
    return std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end();
}

} // namespace

std::optional<FormatKind> cadFormatFor(const std::string& path)
{
    const std::string ending = lowerCaseEnding(path);
    if (ending == "step" || ending == "stp")
        return FormatKind::Step;
    if (ending == "iges" || ending == "igs")
        return FormatKind::Iges;
    if (ending == "brep" || ending == "brp")
        return FormatKind::Brep;
    return std::nullopt;
}

const std::vector<FileFormat>& allExportFormats()
{
    static const std::vector<FileFormat> formats = [] {
        std::vector<FileFormat> all{{"STEP", {"step", "stp"}}, {"IGES", {"iges", "igs"}}, {"BREP", {"brep", "brp"}}};
        all.insert(all.end(), exportFormats().begin(), exportFormats().end());
        return all;
    }();
    return formats;
}

bool isExportPath(const std::string& path)
{
    const std::string ending = lowerCaseEnding(path);
    return std::any_of(allExportFormats().begin(), allExportFormats().end(),
                       [&](const FileFormat& format) { return has(format, ending); });
}

std::string exportEndings()
{
    std::vector<std::string> endings;
    for (const FileFormat& format : allExportFormats())
        endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    std::string words;
    for (std::size_t i = 0; i < endings.size(); ++i)
        words += (i == 0 ? "." : i + 1 < endings.size() ? ", ." : " and .") + endings[i];
    return words;
}

} // namespace knead
