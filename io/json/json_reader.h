#pragma once

#include "core/message/message.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

struct JsonDocument;
struct JsonNumber;
struct JsonValue;

/// Reads and parses a whole file. @throws Problem
JsonValue readJsonFile(const std::string& path);

/// A value of a JSON file that knows its place in it, for strict reading: every failure is a sentence that names the
/// file, the place ("manipulators[0].size_mm") and what is allowed there. All failures are Problems.
class JsonNode {
public:
    /// Reads a whole file. Syntax errors and keys given twice are named with line and column, all others with their line.
    static JsonNode readFile(const std::string& path);
    /// The root of a value. @param file name for messages, which name the lines that values have
    static JsonNode ofValue(JsonValue root, const std::string& file);

    /// Reads a text from elsewhere, whose lines nobody sees. @param source what messages call it
    static JsonNode readText(const std::string& text, const std::string& source);

    /// The value of a key that must be there.
    JsonNode at(std::string_view key) const;
    std::optional<JsonNode> find(std::string_view key) const;

    /// Keys of an object, in the order of the file.
    std::vector<std::string> keys() const;
    /// Fails for the first key that is not among those allowed.
    void allowOnly(const std::vector<std::string>& allowed) const;

    bool isObject() const;
    bool isString() const;
    bool isList() const;

    std::vector<JsonNode> items() const; ///< of a list, which may be empty
    std::string text() const;            ///< a string that is not empty
    std::string anyText() const;         ///< a string that may be empty
    bool boolean() const;
    double number() const; ///< finite
    double number(double minimum, double maximum) const;
    double positive() const;           ///< > 0
    double thousandth() const;         ///< of a number: of millimeters in m, to the last bit
    double positiveThousandth() const; ///< the same of a number > 0
    int integer(int minimum, int maximum) const;
    std::uint64_t count(std::uint64_t maximum) const; ///< a whole number 0 .. maximum, which is below 2^53
    std::vector<double> numbers(std::size_t count) const;
    std::vector<double> thousandths(std::size_t count) const;

    /// @throws Problem "FILE, line 7: PLACE SAYING"; the saying continues the place: "must hold 3 numbers, got 2."
    [[noreturn]] void fail(const Message& saying) const;
    /// The same with what is there added: "PLACE must be EXPECTED, got VALUE."
    [[noreturn]] void failExpecting(const Message& verbAndExpectation) const;

private:
    JsonNode(std::shared_ptr<const JsonDocument> document, const JsonValue* value, std::string place);
    JsonNode child(const JsonValue& value, const std::string& place) const;
    void mustBeObject() const;
    const JsonNumber& finite(const Message& expectation) const;
    std::vector<JsonNumber> finiteNumbers(std::size_t count) const;

    std::shared_ptr<const JsonDocument> m_document;
    const JsonValue* m_value;
    std::string m_place; ///< empty for the whole file
};

} // namespace knead
