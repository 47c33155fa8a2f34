#include "core/model/file_names.h"

#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longestShownName = 80;

} // namespace

std::string shortName(const std::string& path)
{
    std::string name = fs::path(path).filename().string();
    if (name.empty())
        name = fs::path(path).parent_path().filename().string();
    if (name.empty())
        return path.empty() ? "the file" : path;
    if (name.size() <= longestShownName)
        return name;
    std::size_t cut = longestShownName - 20;
    while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0U) == 0x80U) // not inside a UTF-8 letter
        --cut;
    return name.substr(0, cut) + "..." + fs::path(name).extension().string();
}

Message aboutFile(const std::string& path, const Message& sentence)
{
    return Message::verbatim("%1: %2").with(shortName(path), sentence);
}

} // namespace knead
