#include "core/model/readable_name.h"
#include "io/fields/byte_numbers.h"
#include "io/fields/field_content.h"
#include "io/fields/label_map.h"
#include "io/fields/text_scanner.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace knead {

namespace {

/// How the numbers of a block are written, as its first line says.
enum class FrdFormat { shortText, longText, singleBytes, doubleBytes };

/// Values at nodes, as the lines before them say.
struct FrdBlock {
    std::string name;
    std::string time;
    std::string number; ///< of the step
    FrdFormat format = FrdFormat::longText;
    std::size_t nodes = 0;      ///< that its first line promises
    std::size_t components = 0; ///< that are written
    std::size_t place = 0;      ///< of the first value in the file
};

/// An element as CalculiX numbers its types, and the same as VTK does.
struct FrdElement {
    std::uint8_t vtkType = 0;
    std::size_t nodes = 0;
    std::array<std::uint8_t, 20> order{}; ///< VTK's node i is the file's node order[i]; all 0: the same
};

constexpr std::array<FrdElement, 13> frdElements{{
    {},
    {12, 8, {}},
    {13, 6, {}},
    {10, 4, {}},
    {25, 20, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
    {26, 15, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
    {24, 10, {}},
    {5, 3, {}},
    {22, 6, {}},
    {9, 4, {}},
    {23, 8, {}},
    {3, 2, {}},
    {21, 3, {}},
}};

constexpr std::size_t numberWidth = 12;
constexpr std::size_t keyWidth = 3; // " -1"

std::string_view columns(std::string_view line, std::size_t begin, std::size_t length)
{
    return begin < line.size() ? line.substr(begin, length) : std::string_view();
}

/// CalculiX results: lines of fixed columns, or bytes behind such lines.
class FrdReader {
public:
    FrdReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_request(request)
        , m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "CalculiX results";
        while (!m_text.isAtEnd())
            readBlock(m_text.line());
        if (m_content.nodes.empty())
            throw Problem(Message("Field", "it has no nodes; write the results with the mesh."));
        if (m_request.isForMesh)
            connectCells(m_content);
        else
            readChosen();
        return std::move(m_content);
    }

private:
    void readBlock(std::string_view line)
    {
        const std::string_view key = columns(line, 0, 6);
        if (key == "    2C")
            readNodes(line);
        else if (key == "    3C")
            readElements(line);
        else if (key == "  100C")
            noteValues(line);
    }

    FrdFormat formatIn(std::string_view headLine) const
    {
        const std::string_view word = trimmedText(columns(headLine, 72, 4));
        if (word.empty())
            return FrdFormat::longText;
        if (word.size() > 1 || word.front() < '0' || word.front() > '3')
            m_text.failHere();
        return static_cast<FrdFormat>(word.front() - '0');
    }

    /// What the line promises; never more than the rest of the file can hold.
    std::size_t countIn(std::string_view headLine, std::size_t bytesOfOne) const
    {
        const auto count = wholeNumberIn(columns(headLine, 24, 12));
        if (!count || *count < 0)
            m_text.failHere();
        return std::min(static_cast<std::size_t>(*count), m_text.left() / bytesOfOne + 1);
    }

    /// Calls visit(label, numbers) for each line or record of a block.
    template <typename Visit>
    void forEachRecord(FrdFormat format, std::size_t count, std::size_t components, Visit&& visit)
    {
        if (format == FrdFormat::shortText || format == FrdFormat::longText)
            forEachLine(format, components, visit);
        else if (format == FrdFormat::singleBytes)
            forEachOfBytes<float>(count, components, visit);
        else
            forEachOfBytes<double>(count, components, visit);
    }

    template <typename Visit>
    void forEachLine(FrdFormat format, std::size_t components, Visit&& visit)
    {
        const std::size_t labelWidth = format == FrdFormat::shortText ? 5 : 10;
        std::array<double, 3> numbers{};
        while (!m_text.isAtEnd()) {
            const std::string_view line = m_text.line();
            const std::string_view key = columns(line, 0, keyWidth);
            if (key == " -3")
                return;
            if (key != " -1")
                m_text.failHere();
            const auto label = wholeNumberIn(columns(line, keyWidth, labelWidth));
            for (std::size_t i = 0; i < components; ++i) {
                const auto number = numberIn(columns(line, keyWidth + labelWidth + i * numberWidth, numberWidth));
                if (!label || !number)
                    m_text.failHere();
                numbers[i] = *number;
            }
            visit(label.value_or(0), Vec3(numbers[0], numbers[1], numbers[2]));
        }
        m_text.failHere();
    }

    template <typename Number, typename Visit>
    void forEachOfBytes(std::size_t count, std::size_t components, Visit&& visit)
    {
        std::array<double, 3> numbers{};
        for (std::size_t n = 0; n < count; ++n) {
            const std::string_view record = m_text.block(4 + components * sizeof(Number));
            for (std::size_t i = 0; i < components; ++i)
                numbers[i] = numberAt<Number>(record, 4 + i * sizeof(Number));
            visit(numberAt<std::int32_t>(record, 0), Vec3(numbers[0], numbers[1], numbers[2]));
        }
    }

    void readNodes(std::string_view line)
    {
        const FrdFormat format = formatIn(line);
        const std::size_t count = countIn(line, 16);
        m_content.nodes.reserve(count);
        m_content.labels.reserve(count);
        forEachRecord(format, count, 3, [&](std::int64_t label, const Vec3& node) {
            m_content.labels.push_back(label);
            m_content.nodes.push_back(node);
        });
    }

    void readElements(std::string_view line)
    {
        const FrdFormat format = formatIn(line);
        if (format == FrdFormat::singleBytes || format == FrdFormat::doubleBytes)
            return readElementBytes(countIn(line, 16));
        if (!m_request.isForMesh)
            return skipLines();
        const std::size_t width = format == FrdFormat::shortText ? 5 : 10;
        std::size_t type = 0;
        std::vector<std::int64_t> labels;
        while (!m_text.isAtEnd()) {
            const std::string_view row = m_text.line();
            const std::string_view key = columns(row, 0, keyWidth);
            if (key == " -1") {
                addElement(type, labels);
                labels.clear();
                type = static_cast<std::size_t>(wholeNumberIn(columns(row, keyWidth + width, 5)).value_or(0));
            } else if (key == " -2") {
                for (std::size_t at = keyWidth; at < row.size(); at += width)
                    if (const auto label = wholeNumberIn(row.substr(at, width)))
                        labels.push_back(*label);
            } else if (key == " -3") {
                return addElement(type, labels);
            } else {
                m_text.failHere();
            }
        }
        m_text.failHere();
    }

    void readElementBytes(std::size_t count)
    {
        std::vector<std::int64_t> labels;
        for (std::size_t n = 0; n < count; ++n) {
            const auto type = numberAt<std::uint32_t>(m_text.block(16), 4);
            if (type == 0 || type >= frdElements.size())
                m_text.failHere();
            labels.clear();
            for (std::size_t i = 0; i < frdElements[type].nodes; ++i)
                labels.push_back(numberAt<std::int32_t>(m_text.block(4), 0));
            if (m_request.isForMesh)
                addElement(type, labels);
        }
    }

    /// With labels in place of nodes for now.
    void addElement(std::size_t type, std::span<const std::int64_t> labels)
    {
        if (labels.empty() || type == 0 || type >= frdElements.size())
            return;
        const FrdElement& element = frdElements[type];
        if (labels.size() != element.nodes)
            m_text.failHere();
        const bool isReordered = element.order[1] != 0;
        for (std::size_t i = 0; i < labels.size(); ++i)
            m_content.cells.connectivity.push_back(labels[isReordered ? element.order[i] : i]);
        m_content.cells.endCell(element.vtkType);
    }

    /// Behind the end of the block whose lines begin here.
    void skipLines()
    {
        m_text.goTo(m_text.place() - 1); // the end of the line before: there may be none
        if (!m_text.skipBehind("\n -3"))
            m_text.failHere();
        m_text.line();
    }

    /// Reads what the lines say of values and goes behind the values.
    void noteValues(std::string_view headLine)
    {
        FrdBlock block;
        block.time = readableName(trimmedText(columns(headLine, 12, 12)));
        block.number = trimmedText(columns(headLine, 58, 5));
        block.format = formatIn(headLine);
        block.nodes = countIn(headLine, 8);
        std::size_t announced = 0;
        for (block.place = m_text.place(); !m_text.isAtEnd(); block.place = m_text.place()) {
            // The values follow the last announced component, and may be bytes.
            if (!block.name.empty() && announced == 0)
                break;
            const std::string_view line = m_text.line();
            const std::string_view key = columns(line, 0, keyWidth);
            if (key == " -4") {
                block.name = readableName(trimmedText(columns(line, 5, 8)));
                announced = static_cast<std::size_t>(wholeNumberIn(columns(line, 13, 5)).value_or(0));
            } else if (key == " -5" && announced > 0) {
                --announced;
                const bool isComputed = trimmedText(columns(line, 33, 5)) == "1";
                block.components += isComputed ? 0 : 1;
            } else {
                m_text.failHere();
            }
        }
        skipValues(block);
        if (block.components == 3)
            m_blocks.push_back(block);
    }

    void skipValues(const FrdBlock& block)
    {
        if (block.format == FrdFormat::shortText || block.format == FrdFormat::longText)
            return skipLines();
        const std::size_t width = block.format == FrdFormat::singleBytes ? 4 : 8;
        for (std::size_t n = 0; n < block.nodes; ++n)
            m_text.block(4 + width * block.components);
    }

    /// A step is a row of blocks of one number and time, each name once.
    std::vector<std::vector<const FrdBlock*>> blocksOfSteps() const
    {
        std::vector<std::vector<const FrdBlock*>> steps;
        for (const FrdBlock& block : m_blocks) {
            const auto isOther = [&](const FrdBlock* one) {
                return one->number != block.number || one->time != block.time || one->name == block.name;
            };
            if (steps.empty() || std::ranges::any_of(steps.back(), isOther))
                steps.emplace_back();
            steps.back().push_back(&block);
        }
        return steps;
    }

    void readChosen()
    {
        const auto steps = blocksOfSteps();
        if (steps.empty())
            chosenName(m_request.choice, {}); // says that there are none
        for (const auto& blocks : steps)
            m_content.steps.emplace_back(blocks.front()->time);
        const auto& blocks = steps[chosenStep(m_request.choice, steps.size())];
        for (const FrdBlock* block : blocks)
            m_content.names.push_back(block->name);
        choose(m_request.choice, m_content);
        readValues(*blocks[chosenName(m_request.choice, m_content.names)]);
    }

    void readValues(const FrdBlock& block)
    {
        m_content.values.assign(m_content.nodes.size(), noVector());
        LabelMap places(m_content.labels);
        m_text.goTo(block.place);
        forEachRecord(block.format, block.nodes, 3, [&](std::int64_t label, const Vec3& value) {
            if (const std::size_t place = places.find(label); place != LabelMap::none)
                m_content.values[place] = value;
        });
    }

    const FieldRequest& m_request;
    TextScanner m_text;
    FieldContent m_content;
    std::vector<FrdBlock> m_blocks;
};

} // namespace

FieldContent readFrd(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return FrdReader(bytes, request, control).run();
}

} // namespace knead
