#pragma once

#include "io/fields/text_scanner.h"

#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// How the cells of a table are told apart.
struct TableStyle {
    char separator = ' ';         ///< a blank means any row of blanks
    bool hasDecimalComma = false; ///< "1,5"
};

/// How a line of a table is most likely meant.
TableStyle styleOf(std::string_view line);

/// The cells of a line without blanks around them. They stay where they are: `cells` holds what is the line's.
void splitLine(std::string_view line, const TableStyle& style, std::vector<std::string_view>& cells);

/// The number in a cell, which may be in quotes.
std::optional<double> cellNumber(std::string_view cell, const TableStyle& style);

} // namespace knead
