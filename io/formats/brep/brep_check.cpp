#include "io/formats/brep/brep_check.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace knead {

namespace {

constexpr int newestVersion = 3;
constexpr std::array<std::string_view, 8> sections{
    "Locations", "Curve2ds", "Curves", "Polygon3D", "PolygonOnTriangulations", "Surfaces", "Triangulations", "TShapes"};

void checkVersion(const std::string& path, const std::string& line)
{
    const std::size_t place = line.find("Topology V");
    if (place == std::string::npos)
        return;
    std::istringstream text(line.substr(place + 10));
    int version = 0;
    if (!(text >> version) || version < 1 || version > newestVersion)
        failReading(path,
                    Message("Import", "this version of BREP is unknown (\"%1\"); save the file in an older version.")
                        .with(line.substr(0, 40)));
}

} // namespace

void checkBrepText(const std::string& path)
{
    const auto size = static_cast<long long>(std::filesystem::file_size(path));
    std::ifstream file(path, std::ios::binary);
    std::size_t found = 0;
    for (std::string line; std::getline(file, line);) {
        if (found == 0)
            checkVersion(path, line);
        std::istringstream words(line);
        std::string name;
        words >> name;
        const auto* const section = std::find(sections.begin(), sections.end(), name);
        if (section == sections.end())
            continue;
        long long count = -1;
        if (!(words >> count) || count < 0 || count > size)
            failReading(
                path, Message("Import", "the BREP file states an impossible number of %1; it is damaged, get it again.")
                          .with(name));
        ++found;
    }
    if (found < sections.size())
        failReading(path,
                    Message("Import", "the BREP file is cut off or damaged: sections are missing; get it again."));
}

} // namespace knead
