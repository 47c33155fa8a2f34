#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace knead {

/// A number as parsed.
struct JsonNumber {
    double value = 0;
    double thousandth = 0; ///< of the digits in the text, rounded once: 12.3 mm are 0.0123 m to the last bit
};

/// A JSON value as parsed: null, true or false, number, string, list, object with its keys in the order of the file.
struct JsonValue {
    using List = std::vector<JsonValue>;
    using Object = std::vector<std::pair<std::string, JsonValue>>;
    std::variant<std::monostate, bool, JsonNumber, std::string, List, Object> content;
    std::uint32_t line = 0; ///< of the text, from 1, where the value begins, or ends when it is a text; 0: of none
};

/// Parses a text.
/// @param file name for messages
/// @throws Problem with line and column, for wrong syntax and for keys given twice.
JsonValue parseJson(const std::string& text, const std::string& file);

/// The value as JSON in one line, shortened with dots when longer than about 60 characters.
std::string shortJson(const JsonValue& value);

} // namespace knead
