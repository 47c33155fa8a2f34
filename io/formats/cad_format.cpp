#include "io/formats/cad_format.h"

#include "io/formats/foreign_content.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t headLength = 4096;

std::string_view withoutByteOrderMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n\v\f");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

/// IGES is in 80 columns; column 73 of the first line is S (start section), or C in the compressed form.
bool looksLikeIges(std::string_view head)
{
    const std::string_view line = head.substr(0, std::min(head.find_first_of("\r\n"), head.size()));
    if (line.size() < 73 || (line[72] != 'S' && line[72] != 'C' && line[72] != 'G'))
        return false;
    const std::string_view number = line.substr(73, 7);
    return std::all_of(number.begin(), number.end(),
                       [](unsigned char c) { return c == ' ' || std::isdigit(c) != 0; }) &&
           number.find_first_of("0123456789") != std::string_view::npos;
}

bool looksLikeBrep(std::string_view head)
{
    const std::string_view text = trimmed(head);
    return text.starts_with("DBRep_DrawableShape") || text.starts_with("CASCADE Topology");
}

/// Binary STL has no signature: the length follows from the number of triangles.
bool looksLikeBinaryStl(std::string_view head, std::uintmax_t fileSize)
{
    if (head.size() < 84)
        return false;
    std::uint32_t count = 0;
    std::memcpy(&count, head.data() + 80, sizeof count);
    return count > 0 && fileSize == 84 + 50 * static_cast<std::uintmax_t>(count);
}

bool looksLikeAsciiStl(std::string_view head)
{
    const std::string_view text = trimmed(withoutByteOrderMark(head));
    return text.starts_with("solid") &&
           (text.find("facet") != std::string_view::npos || text.find("endsolid") != std::string_view::npos);
}

bool isText(std::string_view head)
{
    return std::none_of(head.begin(), head.end(), [](unsigned char c) { return c < 0x20 && std::isspace(c) == 0; });
}

bool isTextRead(const FileFormat& format)
{
    return format.isRead && format.text != FileFormat::Text::never;
}

/// An OBJ file is lines that start with known words; at least one of them a vertex or an object.
bool looksLikeObj(std::string_view head)
{
    if (!isText(head))
        return false;
    static constexpr std::array<std::string_view, 14> words{"v", "vn", "vt", "f",      "o",      "g",      "s",
                                                            "l", "p",  "vp", "usemtl", "mtllib", "cstype", "deg"};
    std::istringstream lines{std::string(withoutByteOrderMark(head))};
    bool found = false;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream tokens(line);
        std::string word;
        if (!(tokens >> word) || word.starts_with('#'))
            continue;
        const bool cutOff = lines.eof() && head.size() == headLength;
        if (std::find(words.begin(), words.end(), word) == words.end() && !cutOff)
            return false;
        found = found || word == "v" || word == "o" || word == "mtllib";
    }
    return found;
}

std::string readHead(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        failReading(path, Message("Import", "the file cannot be opened; check that you may read it."));
    std::string head(headLength, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (file.bad())
        failReading(path, Message("Import", "the file cannot be read; the disk or the connection to it failed."));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

/// Looks through the whole file.
bool holdsText(const std::string& path, std::string_view text)
{
    std::ifstream file(path, std::ios::binary);
    std::string window;
    std::vector<char> block(1U << 20U);
    while (file) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        window.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (window.find(text) != std::string::npos)
            return true;
        window.erase(0, window.size() - std::min(window.size(), text.size()));
    }
    return false;
}

} // namespace

std::uintmax_t sizeOfFile(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        failReading(path, Message("Import", "the file does not exist."));
    if (error)
        failReading(path, Message("Import", "the file cannot be opened (%1).").with(error.message()));
    if (status.type() == fs::file_type::directory)
        failReading(path, Message("Import", "this is a folder, not a file."));
    if (status.type() != fs::file_type::regular)
        failReading(path, Message("Import", "this is not an ordinary file."));
    const std::uintmax_t size = fs::file_size(path, error);
    if (error)
        failReading(path, Message("Import", "the file cannot be opened (%1).").with(error.message()));
    if (size == 0)
        failReading(path, Message("Import", "the file is empty."));
    return size;
}

FormatKind recognizeFormat(const std::string& path)
{
    const std::uintmax_t size = sizeOfFile(path);
    const std::string head = readHead(path);
    if (head.starts_with("PK\x03\x04")) {
        const ZipContent zip = zipContent(path);
        if (!zip.isThreeMf)
            failReading(path, zip.sentence);
        return FormatKind::ThreeMf;
    }
    if (const auto sentence = foreignContent(head))
        failReading(path, *sentence);
    if (trimmed(withoutByteOrderMark(head)).starts_with("ISO-10303-21"))
        return FormatKind::Step;
    if (looksLikeBrep(head))
        return FormatKind::Brep;
    if (looksLikeBinaryStl(head, size))
        return FormatKind::Stl;
    if (looksLikeIges(head))
        return FormatKind::Iges;
    if (looksLikeAsciiStl(head))
        return FormatKind::Stl;
    if (head.starts_with("ply\n") || head.starts_with("ply\r"))
        return FormatKind::Ply;
    if (head.starts_with("glTF"))
        return FormatKind::Gltf;
    if (trimmed(withoutByteOrderMark(head)).starts_with('{')) {
        if (!holdsText(path, "\"asset\""))
            failReading(
                path,
                Message("Import",
                        "this is a JSON text, but no glTF (\"asset\" is missing in it); export the part as STEP."));
        return FormatKind::Gltf;
    }
    if (looksLikeObj(head) || (isNamedAs(FormatKind::Obj, path) && isText(head)))
        return FormatKind::Obj;
    if (isText(head))
        failReading(
            path,
            Message("Import", "this is a text, but none of %1; export the part as STEP.").with(formatList(isTextRead)));
    failReading(path, Message("Import", "the content is none of %1; export the part as STEP.")
                          .with(formatList([](const FileFormat& format) { return format.isRead; })));
}

void failReading(const std::string& path, const Message& sentence)
{
    throw Problem(aboutFile(path, sentence));
}

} // namespace knead
