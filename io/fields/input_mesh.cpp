#include "io/fields/field_content.h"
#include "io/fields/text_scanner.h"
#include "io/files/lower_case.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

/// An element as Abaqus and CalculiX call it, and the same as VTK does.
struct InputElement {
    std::string_view begin; ///< of the name, which may go on with letters: "C3D8" of "C3D8R"
    std::size_t nodes = 0;
    std::uint8_t vtkType = 0;
    bool hasMiddleInside = false; ///< its second node of three is the one at the middle
};

/// Where one name begins another, the longer one comes first.
constexpr std::array<InputElement, 29> inputElements{{
    {"c3d20", 20, 25}, {"c3d15", 15, 26},    {"c3d10", 10, 24}, {"c3d8", 8, 12},       {"c3d6", 6, 13}, {"c3d5", 5, 14},
    {"c3d4", 4, 10},   {"stri65", 6, 22},    {"stri3", 3, 5},   {"s8", 8, 23},         {"s6", 6, 22},   {"s4", 4, 9},
    {"s3", 3, 5},      {"m3d8", 8, 23},      {"m3d6", 6, 22},   {"m3d4", 4, 9},        {"m3d3", 3, 5},  {"cps8", 8, 23},
    {"cps6", 6, 22},   {"cps4", 4, 9},       {"cps3", 3, 5},    {"cpe8", 8, 23},       {"cpe6", 6, 22}, {"cpe4", 4, 9},
    {"cpe3", 3, 5},    {"b32", 3, 21, true}, {"b31", 2, 3},     {"t3d3", 3, 21, true}, {"t3d2", 2, 3},
}};

/// At how many points CalculiX integrates a solid element; with fewer ones where the name ends with an R.
struct IntegrationPoints {
    std::string_view begin;
    std::uint8_t count = 0;
    std::uint8_t reduced = 0;
};
constexpr std::array<IntegrationPoints, 6> integrationPoints{
    {{"c3d20", 27, 8}, {"c3d15", 9, 9}, {"c3d10", 4, 4}, {"c3d8", 8, 1}, {"c3d6", 2, 2}, {"c3d4", 1, 1}}};

/// 0 where it is not known.
std::uint8_t pointsOf(std::string_view element)
{
    for (const IntegrationPoints& one : integrationPoints)
        if (element.starts_with(one.begin))
            return element.substr(one.begin.size()).starts_with('r') ? one.reduced : one.count;
    return 0;
}

/// Nodes and elements of an input of Abaqus or CalculiX.
class InputReader {
public:
    InputReader(std::string_view bytes, TaskControl& control)
        : m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "Abaqus or CalculiX input";
        m_content.steps = {"0"};
        while (!m_text.isAtEnd())
            takeLine(trimmedText(m_text.line()));
        endElement();
        if (m_content.nodes.empty())
            throw Problem(m_hasOtherFiles
                              ? Message("Field", "its nodes stand in other files that it includes; give the "
                                                 "file with *NODE.")
                              : Message("Field", "it has no nodes; a mesh has them behind *NODE."));
        if (m_unknown > 0)
            m_content.warnings.push_back(
                Message("Field", "%1 elements are of kinds that are not read and were left out.").with(m_unknown));
        connectCells(m_content);
        return std::move(m_content);
    }

private:
    enum class Block { other, nodes, elements };

    void takeLine(std::string_view line)
    {
        if (line.empty() || line.starts_with("**"))
            return;
        if (line.front() == '*')
            beginBlock(lowerCase(std::string(line)));
        else if (m_block == Block::nodes)
            takeNode(line);
        else if (m_block == Block::elements)
            takeElement(line);
    }

    void beginBlock(std::string line)
    {
        endElement();
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
        const std::string_view keyword = std::string_view(line).substr(0, line.find(','));
        m_hasOtherFiles = m_hasOtherFiles || keyword == "*include" || line.find(",input=") != line.npos;
        m_block = keyword == "*node" ? Block::nodes : keyword == "*element" ? Block::elements : Block::other;
        if (m_block != Block::elements)
            return;
        const std::size_t type = line.find(",type=");
        const std::string_view name = type == line.npos ? std::string_view() : std::string_view(line).substr(type + 6);
        const auto found =
            std::ranges::find_if(inputElements, [&](const InputElement& one) { return name.starts_with(one.begin); });
        m_element = found == inputElements.end() ? nullptr : &*found;
        m_points = pointsOf(name);
    }

    /// The next piece up to a comma.
    static std::string_view piece(std::string_view& line)
    {
        const std::size_t comma = std::min(line.find(','), line.size());
        const std::string_view piece = line.substr(0, comma);
        line.remove_prefix(std::min(comma + 1, line.size()));
        return piece;
    }

    void takeNode(std::string_view line)
    {
        const auto label = wholeNumberIn(piece(line));
        Vec3 node = Vec3::Zero();
        for (double& coordinate : node) {
            const std::string_view text = trimmedText(piece(line));
            const auto number = text.empty() ? 0.0 : numberIn(text); // what is left out is 0
            if (!label || !number)
                m_text.failHere();
            coordinate = *number;
        }
        m_content.labels.push_back(*label);
        m_content.nodes.push_back(node);
    }

    /// The number of the element and of its nodes, over several lines where there are many.
    void takeElement(std::string_view line)
    {
        if (m_element == nullptr) {
            m_unknown += m_isContinued ? 0 : 1;
            m_isContinued = line.ends_with(',');
            return;
        }
        while (!line.empty()) {
            const std::string_view text = trimmedText(piece(line));
            if (text.empty())
                continue;
            const auto number = wholeNumberIn(text);
            if (!number)
                m_text.failHere();
            m_numbers.push_back(*number);
        }
        if (m_numbers.size() > m_element->nodes)
            endElement();
    }

    /// With labels in place of nodes for now.
    void endElement()
    {
        m_isContinued = false;
        if (m_numbers.empty() || m_element == nullptr)
            return;
        if (m_numbers.size() != m_element->nodes + 1)
            m_text.failHere();
        if (m_element->hasMiddleInside)
            std::swap(m_numbers[2], m_numbers[3]);
        auto& all = m_content.cells.connectivity;
        all.insert(all.end(), m_numbers.begin() + 1, m_numbers.end());
        m_content.cells.endCell(m_element->vtkType);
        m_content.cells.labels.push_back(m_numbers.front());
        m_content.cells.points.push_back(m_points);
        m_numbers.clear();
    }

    TextScanner m_text;
    Block m_block = Block::other;
    const InputElement* m_element = nullptr;
    std::uint8_t m_points = 0;           ///< at which it is integrated
    std::vector<std::int64_t> m_numbers; ///< of one element
    bool m_isContinued = false;
    bool m_hasOtherFiles = false;
    std::size_t m_unknown = 0;
    FieldContent m_content;
};

} // namespace

FieldContent readInput(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    if (!request.isForMesh)
        throw Problem(Message(
            "Field", "this is an input of Abaqus or CalculiX, without displacements; give the results (.frd)."));
    return InputReader(bytes, control).run();
}

} // namespace knead
