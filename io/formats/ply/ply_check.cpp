#include "io/formats/ply/ply_check.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t longestHeaderLine = 4096; // of a header; honest ones stay under 100

/// Bytes of a number in a binary file; nothing for what is no type.
std::optional<std::uint64_t> sizeOf(const std::string& type)
{
    struct Entry {
        std::string_view type;
        std::uint64_t size;
    };
    static constexpr std::array entries{
        Entry{"char", 1},  Entry{"uchar", 1},  Entry{"int8", 1},    Entry{"uint8", 1},
        Entry{"short", 2}, Entry{"ushort", 2}, Entry{"int16", 2},   Entry{"uint16", 2},
        Entry{"int", 4},   Entry{"uint", 4},   Entry{"int32", 4},   Entry{"uint32", 4},
        Entry{"float", 4}, Entry{"double", 8}, Entry{"float32", 4}, Entry{"float64", 8}};
    for (const Entry& entry : entries)
        if (entry.type == type)
            return entry.size;
    return std::nullopt;
}

class PlyHeader {
public:
    explicit PlyHeader(const std::string& path)
        : m_path(path)
        , m_file(path, std::ios::binary)
    {
    }

    /// Reads up to the end of the header. An element takes a byte, a number in a text two.
    void check()
    {
        std::string line = nextLine();
        while (line != "end_header") {
            take(line);
            line = nextLine();
        }
        const auto begin = static_cast<std::uint64_t>(m_file.tellg());
        const std::uint64_t size = std::filesystem::file_size(m_path);
        std::uint64_t least = 0;
        for (const Element& element : m_elements) {
            if (element.least > 0 && element.count > size / element.least)
                failCut();
            least += element.count * element.least;
        }
        if (least > size - std::min(begin, size) + 1) // the last line of a text may lack its end
            failCut();
    }

private:
    struct Element {
        std::uint64_t count = 0;
        std::uint64_t least = 0; ///< bytes that one takes in the file at the least
    };

    std::string nextLine()
    {
        std::string line;
        char character = '\0';
        while (m_file.get(character) && character != '\n' && line.size() < longestHeaderLine)
            line += character;
        if (!m_file || line.size() == longestHeaderLine)
            failEndless();
        line.resize(line.find_last_not_of(" \t\r") + 1); // npos + 1 is 0
        return line;
    }

    void take(const std::string& line)
    {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "format") {
            words >> word;
            m_isText = word == "ascii";
        } else if (word == "element") {
            Element element;
            long long count = -1;
            if (!(words >> word >> count) || count < 0)
                failDamaged(line);
            element.count = static_cast<std::uint64_t>(count);
            m_elements.push_back(element);
        } else if (word == "property") {
            takeProperty(words, line);
        } else if (!word.empty() && word != "ply" && word != "comment" && word != "obj_info") {
            failDamaged(line);
        }
    }

    void takeProperty(std::istringstream& words, const std::string& line)
    {
        std::string type;
        words >> type;
        std::string name;
        std::string itemType = type;
        const bool isList = type == "list";
        if (isList)
            words >> type >> itemType;
        const std::optional<std::uint64_t> size = sizeOf(type);
        if (!(words >> name) || !size || !sizeOf(itemType) || m_elements.empty())
            failDamaged(line);
        m_elements.back().least += m_isText ? 2 : *size;
    }

    [[noreturn]] void failDamaged(std::string line) const
    {
        if (std::any_of(line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }))
            failEndless();
        line.resize(std::min<std::size_t>(line.size(), 40));
        failReading(
            m_path,
            Message("Import", "the line \"%1\" in the header of the PLY file is damaged; get it again.").with(line));
    }

    [[noreturn]] void failEndless() const
    {
        failReading(m_path, Message("Import",
                                    "the header of the PLY file has no end; it is cut off or damaged, get it again."));
    }

    [[noreturn]] void failCut() const
    {
        failReading(m_path,
                    Message("Import",
                            "the PLY file holds fewer numbers than its header promises; it is cut off, get it again."));
    }

    const std::string& m_path;
    std::ifstream m_file;
    std::vector<Element> m_elements;
    bool m_isText = false;
};

} // namespace

void checkPly(const std::string& path)
{
    PlyHeader(path).check();
}

} // namespace knead
