#include "app/sweep/sweep_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <vector>

namespace knead {

using Json = nlohmann::ordered_json;

namespace {

/// Of the machine, or written beside the table, or no numbers.
const std::set<std::string>& leftOut()
{
    static const std::set<std::string> keys{"wall_s", "ratio", "files", "exports", "warnings"};
    return keys;
}

using Cells = std::vector<std::pair<std::string, std::string>>; // column and text

std::string textOfValue(const Json& value)
{
    return value.is_string() ? value.get<std::string>() : value.dump();
}

void addCells(const Json& value, const std::string& name, Cells& cells);

bool isVector(const Json& list)
{
    return list.size() == 3 && std::all_of(list.begin(), list.end(), [](const Json& item) { return item.is_number(); });
}

/// A vector by axes, things by their names, anything else by number.
std::string nameOfItem(const Json& list, std::size_t index)
{
    static constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    if (isVector(list))
        return axes.at(index);
    const Json& item = list[index];
    return item.is_object() && item.contains("name") ? textOfValue(item.at("name")) : std::to_string(index);
}

std::string within(const std::string& name, const std::string& member)
{
    return std::string(name).append(".").append(member);
}

void addItems(const Json& list, const std::string& name, Cells& cells)
{
    std::set<std::string> used;
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::string item = nameOfItem(list, i);
        if (!used.insert(item).second)
            item.append("#").append(std::to_string(i));
        addCells(list[i], within(name, item), cells);
    }
}

void addCells(const Json& value, const std::string& name, Cells& cells)
{
    if (value.is_array()) {
        addItems(value, name, cells);
    } else if (value.is_object()) {
        for (const auto& [key, member] : value.items())
            if (key != "name")
                addCells(member, within(name, key), cells);
    } else {
        cells.emplace_back(name, textOfValue(value));
    }
}

Cells cellsOf(const std::string& report)
{
    Cells cells;
    if (report.empty())
        return cells;
    const Json json = Json::parse(report);
    for (const auto& [key, value] : json.items())
        if (!leftOut().contains(key))
            addCells(value, key, cells);
    return cells;
}

std::string quotedCell(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string result = "\"";
    for (const char character : text)
        result.append(character == '"' ? 2 : 1, character);
    result += '"';
    return result;
}

std::string lineOf(const std::vector<std::string>& cells)
{
    std::string line;
    for (const std::string& cell : cells)
        line.append(&cell == &cells.front() ? "" : ",").append(quotedCell(cell));
    line += '\n';
    return line;
}

/// A text as it is meant, without the quotes of JSON.
std::string shownValue(const std::string& value)
{
    const Json json = Json::parse(value, nullptr, false);
    return json.is_string() ? json.get<std::string>() : value;
}

/// The columns of the reports in the order in which the points bring them up.
class Columns {
public:
    void add(const Cells& cells)
    {
        for (const auto& [name, text] : cells)
            if (m_numbers.try_emplace(name, m_names.size()).second)
                m_names.push_back(name);
    }

    const std::vector<std::string>& names() const { return m_names; }

    std::vector<std::string> row(const Cells& cells) const
    {
        std::vector<std::string> texts(m_names.size());
        for (const auto& [name, text] : cells)
            texts[m_numbers.at(name)] = text;
        return texts;
    }

private:
    std::vector<std::string> m_names;
    std::unordered_map<std::string, std::size_t> m_numbers;
};

std::string joined(std::vector<std::string> first, const std::vector<std::string>& more)
{
    first.insert(first.end(), more.begin(), more.end());
    return lineOf(first);
}

/// Number, what varied, status and message.
std::vector<std::string> headOf(const SweepPlan& plan, std::size_t point, const std::optional<PointResult>& result,
                                const LostPoints& lost)
{
    std::vector<std::string> head{std::to_string(point)};
    for (const std::string& value : plan.points[point])
        head.push_back(shownValue(value));
    const auto reason = lost.find(point);
    head.push_back(result ? std::to_string(result->status) : "");
    head.push_back(result ? result->message : reason != lost.end() ? reason->second : "");
    return head;
}

std::vector<std::string> titleOf(const SweepPlan& plan)
{
    std::vector<std::string> title{"index"};
    title.insert(title.end(), plan.paths.begin(), plan.paths.end());
    title.insert(title.end(), {"status", "message"});
    return title;
}

/// `objects` may be asked for and counted: then it is `result.objects` that was counted.
std::vector<std::string> namesBeside(const std::vector<std::string>& paths, std::vector<std::string> names)
{
    for (std::string& name : names)
        if (std::find(paths.begin(), paths.end(), name) != paths.end())
            name.insert(0, "result.");
    return names;
}

} // namespace

std::string tableOf(const SweepFolder& folder, const SweepPlan& plan, const LostPoints& lost)
{
    std::vector<std::vector<std::string>> heads;
    std::vector<Cells> reports;
    Columns columns;
    for (std::size_t i = 0; i < plan.points.size(); ++i) {
        const std::optional<PointResult> result = folder.result(plan, i);
        heads.push_back(headOf(plan, i, result, lost));
        reports.push_back(result ? cellsOf(result->report) : Cells{});
        columns.add(reports.back());
    }

    std::string table = joined(titleOf(plan), namesBeside(plan.paths, columns.names()));
    for (std::size_t i = 0; i < heads.size(); ++i)
        table += joined(heads[i], columns.row(reports[i]));
    return table;
}

std::string timingOf(const SweepFolder& folder, const SweepPlan& plan)
{
    std::string table = "index,elapsed_s,wall_s,ratio\n";
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        if (const std::optional<PointResult> result = folder.result(plan, i)) {
            const Json report = result->report.empty() ? Json::object() : Json::parse(result->report);
            const auto cell = [&](const char* key) { return report.contains(key) ? report.at(key).dump() : ""; };
            table += lineOf({std::to_string(i), Json(result->elapsed).dump(), cell("wall_s"), cell("ratio")});
        }
    return table;
}

} // namespace knead
