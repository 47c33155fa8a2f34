#include "io/fields/table_lines.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::string_view cellBlanks = " \t\r\v\f";

void splitAtBlanks(std::string_view line, std::vector<std::string_view>& cells)
{
    while (true) {
        const std::size_t begin = line.find_first_not_of(cellBlanks);
        if (begin == line.npos)
            return;
        line.remove_prefix(begin);
        const std::size_t end = std::min(line.find_first_of(cellBlanks), line.size());
        cells.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

/// "1,5 2,5 -3,0": blanks between numbers, each with a comma inside or none, and one comma at least.
bool hasCommasInsideWords(std::string_view line)
{
    std::vector<std::string_view> words;
    splitAtBlanks(line, words);
    bool hasComma = false;
    for (const std::string_view word : words) {
        const auto commas = std::ranges::count(word, ',');
        if (commas > 1 || word.starts_with(',') || word.ends_with(','))
            return false;
        hasComma = hasComma || commas == 1;
    }
    return hasComma && words.size() >= 3;
}

} // namespace

TableStyle styleOf(std::string_view line)
{
    const bool hasComma = line.find(',') != line.npos;
    for (const char separator : {';', '\t', '|'})
        if (line.find(separator) != line.npos)
            return {separator, hasComma};
    if (!hasComma)
        return {};
    return hasCommasInsideWords(line) ? TableStyle{' ', true} : TableStyle{',', false};
}

void splitLine(std::string_view line, const TableStyle& style, std::vector<std::string_view>& cells)
{
    cells.clear();
    if (style.separator == ' ')
        return splitAtBlanks(line, cells);
    while (true) {
        const std::size_t end = std::min(line.find(style.separator), line.size());
        cells.push_back(trimmedText(line.substr(0, end)));
        if (end == line.size())
            break;
        line.remove_prefix(end + 1);
    }
    // A separator at the end of a line begins no column.
    if (cells.back().empty())
        cells.pop_back();
}

std::optional<double> cellNumber(std::string_view cell, const TableStyle& style)
{
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
        cell = cell.substr(1, cell.size() - 2);
    if (!style.hasDecimalComma)
        return numberIn(cell);
    const std::size_t comma = cell.find(',');
    if (comma == cell.npos)
        return numberIn(cell);
    constexpr std::size_t mostDigits = 64;
    if (cell.size() > mostDigits || cell.find(',', comma + 1) != cell.npos)
        return {};
    std::string text(cell);
    text[comma] = '.';
    return numberIn(text);
}

} // namespace knead
