#include "core/model/field_formats.h"

#include "core/model/file_formats.h"

#include <algorithm>

namespace knead {

namespace {

bool isOf(const FieldFormat& format, const std::string& path)
{
    return std::ranges::find(format.endings, lowerCaseEnding(path)) != format.endings.end();
}

} // namespace

const std::vector<FieldFormat>& fieldFormats()
{
    static const std::vector<FieldFormat> all{
        {Message("Field", "CalculiX results"), {"frd"}},
        {Message("Field", "VTK"), {"vtu", "vtp", "vts", "pvd", "vtk"}},
        {Message("Field", "Gmsh"), {"msh"}},
        {Message("Field", "Table"), {"csv", "txt", "dat"}},
        {Message("Field", "Abaqus report"), {"rpt"}},
        {Message("Field", "Abaqus or CalculiX input"), {"inp"}, true},
    };
    return all;
}

bool isFieldFile(const std::string& path)
{
    return std::ranges::any_of(fieldFormats(),
                               [&](const FieldFormat& format) { return !format.isMeshOnly && isOf(format, path); });
}

bool isNodalMeshFile(const std::string& path)
{
    return std::ranges::any_of(fieldFormats(), [&](const FieldFormat& format) { return isOf(format, path); });
}

bool isScanFile(const std::string& path)
{
    return std::ranges::any_of(fileFormats, [&](const FileFormat& format) {
        return format.isRead && !format.isSmooth && isNamedAs(format.kind, path);
    });
}

Message fieldEndingList()
{
    std::vector<std::string> endings;
    for (const FieldFormat& format : fieldFormats())
        if (!format.isMeshOnly)
            for (const std::string& ending : format.endings)
                endings.push_back("." + ending);
    std::string list;
    for (std::size_t i = 0; i + 1 < endings.size(); ++i)
        list += (i == 0 ? "" : ", ") + endings[i];
    return Message("File", "%1 and %2").with(list, endings.back());
}

} // namespace knead
