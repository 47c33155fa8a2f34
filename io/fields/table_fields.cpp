#include "core/model/length_units.h"
#include "io/fields/field_content.h"
#include "io/fields/table_columns.h"
#include "io/fields/table_lines.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t mostLinesBefore = 1000; // of text above the numbers
constexpr std::size_t linesLookedAt = 1000;   // to tell whether the first column holds whole numbers

/// A table as text: lines of numbers, with headings or without.
class TableReader {
public:
    TableReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_request(request)
        , m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "table";
        m_content.steps = {"0"};
        findNumbers();
        findColumns();
        if (!m_request.isForMesh)
            chooseVector();
        m_content.unit = m_columns.nodes.unit;
        while (!m_text.isAtEnd())
            readLine(m_text.line());
        if (m_leftOut > 0)
            m_content.warnings.push_back(
                Message("Field", "%1 lines hold no numbers where they should and were left out.").with(m_leftOut));
        return std::move(m_content);
    }

private:
    bool isNumbers(std::string_view line)
    {
        m_style = styleOf(line);
        splitLine(line, m_style, m_cells);
        // Some may be empty, as where a node has no displacement.
        const auto numbers =
            std::ranges::count_if(m_cells, [&](auto cell) { return cellNumber(cell, m_style).has_value(); });
        const auto empty = std::ranges::count_if(m_cells, [](auto cell) { return cell.empty(); });
        return numbers >= 3 && static_cast<std::size_t>(numbers + empty) == m_cells.size();
    }

    /// Goes to the first line of numbers and keeps those before.
    void findNumbers()
    {
        while (!m_text.isAtEnd() && m_before.size() < mostLinesBefore) {
            const std::size_t place = m_text.place();
            const std::string_view line = trimmedText(m_text.line());
            if (isNumbers(line)) {
                m_text.goTo(place);
                return;
            }
            if (!line.empty())
                m_before.push_back(line);
        }
        throw Problem(Message("Field", "there are no lines of numbers in it; a table has a line per node with X, Y, Z, "
                                       "DX, DY, DZ."));
    }

    static std::string_view withoutCommentMark(std::string_view line)
    {
        for (const std::string_view mark : {"\xEF\xBB\xBF", "#", "%", "//", "!", "*"})
            while (line.starts_with(mark))
                line.remove_prefix(mark.size());
        return trimmedText(line);
    }

    /// Headings stand in the last line that tells coordinates; those without a separator of numbers are split at blanks.
    std::optional<TableColumns> columnsInHeadings() const
    {
        for (auto line = m_before.rbegin(); line != m_before.rend(); ++line) {
            std::vector<std::string> headings = headingsIn(withoutCommentMark(*line));
            if (line != m_before.rbegin())
                addUnits(headings, headingsIn(withoutCommentMark(*(line - 1))));
            if (auto columns = columnsNamed(headings))
                return columns;
        }
        return {};
    }

    std::vector<std::string> headingsIn(std::string_view line) const
    {
        std::vector<std::string_view> cells;
        splitLine(line, {m_style.separator, false}, cells);
        if (cells.size() < 3 && m_style.separator != ' ')
            splitLine(line, styleOf(line), cells);
        std::vector<std::string> headings;
        for (const std::string_view cell : cells) {
            // "X [mm]" has a blank inside.
            const bool isUnit =
                m_style.separator == ' ' && !headings.empty() && (cell.starts_with('[') || cell.starts_with('('));
            if (isUnit)
                headings.back().append(" ").append(cell);
            else
                headings.emplace_back(cell);
        }
        return headings;
    }

    /// Units may stand in a line of their own below.
    static void addUnits(std::vector<std::string>& headings, const std::vector<std::string>& below)
    {
        if (below.size() != headings.size())
            return;
        for (std::size_t i = 0; i < headings.size(); ++i) {
            const std::string unit = std::string(trimmedText(below[i]));
            const std::string bare = unitIn(unit).empty() ? unit : unitIn(unit);
            if (findLengthUnit(bare) != nullptr)
                headings[i].append(" [").append(bare).append("]");
        }
    }

    void findColumns()
    {
        const auto named = columnsInHeadings();
        const auto counted = columnsCounted(m_cells.size(), isFirstWhole());
        if (named && (m_request.isForMesh || !named->vectors.empty()))
            m_columns = *named;
        else if (counted && (m_request.isForMesh || !counted->vectors.empty()))
            m_columns = *counted;
        else
            throw Problem(Message("Field",
                                  "it cannot be told what its %1 columns are; name them in the first line: X, Y, "
                                  "Z, DX, DY, DZ.")
                              .with(m_cells.size()));
    }

    /// Leaves the place as it is.
    bool isFirstWhole()
    {
        const std::size_t place = m_text.place();
        std::vector<std::string_view> cells;
        bool isWhole = true;
        for (std::size_t i = 0; i < linesLookedAt && isWhole && !m_text.isAtEnd(); ++i) {
            splitLine(m_text.line(), m_style, cells);
            isWhole = cells.empty() || !cellNumber(cells.front(), m_style) || wholeNumberIn(cells.front());
        }
        m_text.goTo(place);
        return isWhole;
    }

    void chooseVector()
    {
        for (const VectorColumns& vector : m_columns.vectors)
            m_content.names.push_back(vector.name);
        choose(m_request.choice, m_content);
        m_vector = m_columns.vectors[chosenName(m_request.choice, m_content.names)];
        m_content.valueUnit = m_vector.unit;
    }

    std::optional<Vec3> vectorIn(const VectorColumns& vector) const
    {
        Vec3 result;
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t column = vector.columns[static_cast<std::size_t>(axis)];
            const auto number = column < m_cells.size() ? cellNumber(m_cells[column], m_style) : std::nullopt;
            if (!number)
                return {};
            result[axis] = *number;
        }
        return result;
    }

    void readLine(std::string_view line)
    {
        splitLine(line, m_style, m_cells);
        if (m_cells.empty())
            return;
        const auto node = vectorIn(m_columns.nodes);
        if (!node) {
            const bool isComment = withoutCommentMark(trimmedText(line)).size() < trimmedText(line).size();
            m_leftOut += isComment ? 0 : 1;
            return;
        }
        m_content.nodes.push_back(*node);
        if (m_columns.label)
            m_content.labels.push_back(labelHere());
        if (!m_request.isForMesh)
            m_content.values.push_back(vectorIn(m_vector).value_or(noVector()));
    }

    std::int64_t labelHere() const
    {
        if (*m_columns.label >= m_cells.size())
            return 0;
        const auto label = cellNumber(m_cells[*m_columns.label], m_style);
        return label && std::abs(*label) < 1e15 ? static_cast<std::int64_t>(*label) : 0;
    }

    const FieldRequest& m_request;
    TextScanner m_text;
    std::vector<std::string_view> m_before;
    std::vector<std::string_view> m_cells;
    TableStyle m_style;
    TableColumns m_columns;
    VectorColumns m_vector;
    std::size_t m_leftOut = 0;
    FieldContent m_content;
};

} // namespace

FieldContent readTable(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return TableReader(bytes, request, control).run();
}

} // namespace knead
