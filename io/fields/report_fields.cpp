#include "core/model/readable_name.h"
#include "io/fields/field_content.h"
#include "io/fields/table_columns.h"
#include "io/fields/text_scanner.h"

#include <algorithm>

namespace knead {

namespace {

struct ReportWord {
    std::string_view text;
    std::size_t end = 0; ///< behind it in its line
};

std::vector<ReportWord> wordsIn(std::string_view line)
{
    std::vector<ReportWord> words;
    std::size_t end = 0;
    while (true) {
        const std::size_t begin = line.find_first_not_of(" \t", end);
        if (begin == line.npos)
            return words;
        end = std::min(line.find_first_of(" \t", begin), line.size());
        words.push_back({line.substr(begin, end - begin), end});
    }
}

bool areNumbers(const std::vector<ReportWord>& words)
{
    return !words.empty() &&
           std::ranges::all_of(words, [](const ReportWord& word) { return numberIn(word.text).has_value(); });
}

/// A table of the report, at one frame.
struct ReportTable {
    std::string frame;
    TableColumns columns;
    std::size_t count = 0; ///< of columns
    std::size_t place = 0; ///< of the first line of numbers
};

/// A report of values at nodes as Abaqus writes it: tables behind headings whose columns end where those of the numbers do.
class ReportReader {
public:
    ReportReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_request(request)
        , m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "Abaqus report";
        while (!m_text.isAtEnd())
            takeLine();
        if (m_tables.empty())
            throw Problem(
                m_hasTable
                    ? Message("Field", "the report has no coordinates; write COORD of the nodes into it beside U.")
                    : Message("Field", "the report has no table with values of nodes."));
        m_content.warnings.push_back(Message(
            "Field",
            "The coordinates are those in the report; where Abaqus computed with large displacements they are the "
            "moved ones: take those of the first frame then."));
        chooseTables();
        return std::move(m_content);
    }

private:
    void takeLine()
    {
        const std::size_t place = m_text.place();
        const std::string_view line = m_text.line();
        const std::string_view text = trimmedText(line);
        if (text.starts_with("Step:"))
            m_step = readableName(trimmedText(text.substr(5)));
        else if (text.starts_with("Frame:"))
            m_frame = readableName(trimmedText(text.substr(6)));
        if (text.size() > 8 && text.find_first_not_of('-') == text.npos)
            m_isBelowRule = true;
        else if (text.empty() && !m_isBelowRule)
            m_headings.clear();
        else if (const auto words = wordsIn(line); m_isBelowRule && areNumbers(words))
            beginTable(words, place);
        else if (!text.empty() && !m_isBelowRule)
            m_headings.push_back(line);
        else if (!text.empty())
            m_isBelowRule = false;
    }

    /// The words above that end within a column are its heading.
    void beginTable(const std::vector<ReportWord>& numbers, std::size_t place)
    {
        std::vector<std::string> headings(numbers.size());
        for (const std::string_view line : m_headings)
            for (const ReportWord& word : wordsIn(line)) {
                const auto column =
                    std::ranges::find_if(numbers, [&](const ReportWord& one) { return word.end <= one.end; });
                if (column != numbers.end())
                    headings[static_cast<std::size_t>(column - numbers.begin())] += word.text;
            }
        for (std::string& heading : headings) // "U.U1@Loc1"
            heading.resize(std::min(heading.find('@'), heading.size()));
        m_hasTable = true;
        if (const auto columns = columnsNamed(headings))
            m_tables.push_back({m_step.empty() ? m_frame : m_step + ", " + m_frame, *columns, numbers.size(), place});
        while (!m_text.isAtEnd() && !trimmedText(m_text.line()).empty()) {}
        m_isBelowRule = false;
        m_headings.clear();
    }

    /// Tables of one frame are of one step: there is one per part.
    void chooseTables()
    {
        std::vector<std::vector<const ReportTable*>> steps;
        for (const ReportTable& table : m_tables) {
            if (steps.empty() || steps.back().front()->frame != table.frame)
                steps.emplace_back();
            steps.back().push_back(&table);
        }
        for (const auto& tables : steps)
            m_content.steps.push_back(tables.front()->frame.empty() ? "0" : tables.front()->frame);
        const auto& tables = steps[chosenStep(m_request.choice, steps.size())];
        for (const VectorColumns& vector : tables.front()->columns.vectors)
            m_content.names.push_back(vector.name);
        if (!m_request.isForMesh)
            choose(m_request.choice, m_content);
        for (const ReportTable* table : tables)
            readNumbers(*table);
    }

    void readNumbers(const ReportTable& table)
    {
        const auto& vectors = table.columns.vectors;
        const auto chosen = std::ranges::find(vectors, m_content.name, &VectorColumns::name);
        m_text.goTo(table.place);
        while (!m_text.isAtEnd()) {
            const auto words = wordsIn(m_text.line());
            if (words.size() != table.count || !areNumbers(words))
                return;
            const auto vectorAt = [&](const VectorColumns& vector) {
                Vec3 result;
                for (int axis = 0; axis < 3; ++axis)
                    result[axis] = *numberIn(words[vector.columns[static_cast<std::size_t>(axis)]].text);
                return result;
            };
            m_content.nodes.push_back(vectorAt(table.columns.nodes));
            if (table.columns.label)
                m_content.labels.push_back(wholeNumberIn(words[*table.columns.label].text).value_or(0));
            if (!m_request.isForMesh)
                m_content.values.push_back(chosen == vectors.end() ? noVector() : vectorAt(*chosen));
        }
    }

    const FieldRequest& m_request;
    TextScanner m_text;
    std::string m_step;
    std::string m_frame;
    std::vector<std::string_view> m_headings; ///< lines since the last empty one
    bool m_isBelowRule = false;               ///< of dashes
    bool m_hasTable = false;
    std::vector<ReportTable> m_tables;
    FieldContent m_content;
};

} // namespace

FieldContent readReport(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return ReportReader(bytes, request, control).run();
}

} // namespace knead
