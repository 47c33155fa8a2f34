#include "io/formats/threemf/zip_names.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace knead {

namespace {

// Sizes and places in the records are those of APPNOTE.TXT, sections 4.3.12 and 4.3.16.
constexpr std::string_view endMark = "PK\x05\x06";
constexpr std::string_view entryMark = "PK\x01\x02";
constexpr std::size_t endLength = 22;
constexpr std::size_t entryLength = 46;
constexpr std::size_t longestComment = 65'535;
constexpr std::size_t mostNames = 1000;
constexpr std::size_t longestDirectory = 1U << 20U; // read of it

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t length)
{
    std::uint32_t value = 0;
    for (std::size_t i = length; i-- > 0;)
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::string readFrom(std::ifstream& file, std::uint64_t at, std::size_t length)
{
    std::string bytes(length, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(bytes.data(), static_cast<std::streamsize>(length));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

} // namespace

std::optional<std::vector<std::string>> zipEntryNames(const std::string& path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
    const auto tailLength = static_cast<std::size_t>(std::min<std::uint64_t>(size, endLength + longestComment));
    const std::string tail = readFrom(file, size - tailLength, tailLength);
    const std::size_t end = tail.rfind(endMark);
    if (end == std::string::npos || end + endLength > tail.size())
        return std::nullopt;

    const std::uint32_t length = number(tail, end + 12, 4);
    const std::uint32_t begin = number(tail, end + 16, 4);
    const std::string directory = readFrom(file, begin, std::min<std::size_t>(length, longestDirectory));
    std::vector<std::string> names;
    for (std::size_t at = 0; at + entryLength <= directory.size() && names.size() < mostNames;) {
        if (directory.compare(at, entryMark.size(), entryMark) != 0)
            break;
        const std::size_t nameLength = number(directory, at + 28, 2);
        names.push_back(directory.substr(at + entryLength, nameLength));
        at += entryLength + nameLength + number(directory, at + 30, 2) + number(directory, at + 32, 2);
    }
    return names.empty() ? std::nullopt : std::optional(std::move(names));
}

} // namespace knead
