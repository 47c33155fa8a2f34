#include "io/json/json_reader.h"

#include "core/message/message.h"
#include "io/json/json_value.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace knead {

namespace {

std::string contentOf(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw Problem(Message("File", "%1: no such file.").with(path));
    if (std::filesystem::is_directory(path, error))
        throw Problem(Message("File", "%1: this is a folder; name a file.").with(path));
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file)
        throw Problem(Message("File", "%1: the file cannot be read; check its permissions.").with(path));
    return text.str();
}

std::string plain(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

} // namespace

struct JsonDocument {
    std::string file; ///< name without folders
    JsonValue root;
    bool hasLines = true; ///< that a person can look up
};

JsonValue readJsonFile(const std::string& path)
{
    return parseJson(contentOf(path), std::filesystem::path(path).filename().string());
}

JsonNode::JsonNode(std::shared_ptr<const JsonDocument> document, const JsonValue* value, std::string place)
    : m_document(std::move(document))
    , m_value(value)
    , m_place(std::move(place))
{
}

JsonNode JsonNode::readFile(const std::string& path)
{
    return ofValue(readJsonFile(path), std::filesystem::path(path).filename().string());
}

JsonNode JsonNode::readText(const std::string& text, const std::string& source)
{
    auto document = std::make_shared<JsonDocument>(JsonDocument{source, parseJson(text, source), false});
    const JsonValue* value = &document->root;
    return {std::move(document), value, ""};
}

JsonNode JsonNode::ofValue(JsonValue root, const std::string& file)
{
    auto document = std::make_shared<JsonDocument>(JsonDocument{file, std::move(root)});
    const JsonValue* value = &document->root;
    return {std::move(document), value, ""};
}

JsonNode JsonNode::child(const JsonValue& value, const std::string& place) const
{
    return {m_document, &value, place};
}

void JsonNode::fail(const Message& saying) const
{
    const bool hasLine = m_document->hasLines && m_value->line > 0 && !m_place.empty();
    const Message place = m_place.empty() ? Message("Recipe", "the file") : Message::verbatim(m_place);
    if (hasLine)
        throw Problem(Message("Recipe", "%1, line %2: %3 %4").with(m_document->file, m_value->line, place, saying));
    throw Problem(Message::verbatim("%1: %2 %3").with(m_document->file, place, saying));
}

void JsonNode::failExpecting(const Message& verbAndExpectation) const
{
    fail(Message("Recipe", "%1, got %2.").with(verbAndExpectation, shortJson(*m_value)));
}

bool JsonNode::isObject() const
{
    return std::holds_alternative<JsonValue::Object>(m_value->content);
}

bool JsonNode::isString() const
{
    return std::holds_alternative<std::string>(m_value->content);
}

bool JsonNode::isList() const
{
    return std::holds_alternative<JsonValue::List>(m_value->content);
}

void JsonNode::mustBeObject() const
{
    if (!isObject())
        failExpecting(Message("Recipe", "must be an object in { }"));
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const
{
    mustBeObject();
    for (const auto& [name, value] : std::get<JsonValue::Object>(m_value->content))
        if (name == key)
            return child(value, m_place.empty() ? name : m_place + "." + name);
    return std::nullopt;
}

JsonNode JsonNode::at(std::string_view key) const
{
    if (std::optional<JsonNode> found = find(key))
        return *found;
    fail(Message("Recipe", "must have the key \"%1\".").with(key));
}

std::vector<std::string> JsonNode::keys() const
{
    mustBeObject();
    std::vector<std::string> names;
    for (const auto& member : std::get<JsonValue::Object>(m_value->content))
        names.push_back(member.first);
    return names;
}

void JsonNode::allowOnly(const std::vector<std::string>& allowed) const
{
    for (const std::string& key : keys()) {
        if (std::find(allowed.begin(), allowed.end(), key) != allowed.end())
            continue;
        std::string list;
        for (const std::string& name : allowed)
            list += (list.empty() ? "" : ", ") + name;
        find(key)->fail(Message("Recipe", "is not a known key; allowed here: %1.").with(list));
    }
}

std::vector<JsonNode> JsonNode::items() const
{
    if (!isList())
        failExpecting(Message("Recipe", "must be a list in [ ]"));
    std::vector<JsonNode> nodes;
    for (const JsonValue& value : std::get<JsonValue::List>(m_value->content))
        nodes.push_back(child(value, m_place + "[" + std::to_string(nodes.size()) + "]"));
    return nodes;
}

std::string JsonNode::text() const
{
    const auto* text = std::get_if<std::string>(&m_value->content);
    if (!text || text->empty())
        failExpecting(Message("Recipe", "must be a text in quotes that is not empty"));
    return *text;
}

std::string JsonNode::anyText() const
{
    const auto* text = std::get_if<std::string>(&m_value->content);
    if (!text)
        failExpecting(Message("Recipe", "must be a text in quotes"));
    return *text;
}

bool JsonNode::boolean() const
{
    const auto* value = std::get_if<bool>(&m_value->content);
    if (!value)
        failExpecting(Message("Recipe", "must be true or false"));
    return *value;
}

double JsonNode::number() const
{
    return number(-std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
}

const JsonNumber& JsonNode::finite(const Message& expectation) const
{
    const auto* number = std::get_if<JsonNumber>(&m_value->content);
    if (!number || !std::isfinite(number->value))
        failExpecting(expectation);
    return *number;
}

double JsonNode::number(double minimum, double maximum) const
{
    const double number = finite(Message("Recipe", "must be a number")).value;
    if (number < minimum || number > maximum)
        failExpecting(Message("Recipe", "must be a number between %1 and %2").with(plain(minimum), plain(maximum)));
    return number;
}

double JsonNode::positive() const
{
    const double number = finite(Message("Recipe", "must be a positive number")).value;
    if (number <= 0)
        failExpecting(Message("Recipe", "must be a positive number"));
    return number;
}

double JsonNode::thousandth() const
{
    return finite(Message("Recipe", "must be a number")).thousandth;
}

double JsonNode::positiveThousandth() const
{
    positive();
    return thousandth();
}

int JsonNode::integer(int minimum, int maximum) const
{
    const auto* number = std::get_if<JsonNumber>(&m_value->content);
    if (!number || number->value != std::floor(number->value) || number->value < minimum || number->value > maximum)
        failExpecting(Message("Recipe", "must be a whole number between %1 and %2").with(minimum, maximum));
    return static_cast<int>(number->value);
}

std::uint64_t JsonNode::count(std::uint64_t maximum) const
{
    const auto* number = std::get_if<JsonNumber>(&m_value->content);
    if (!number || number->value != std::floor(number->value) || number->value < 0 ||
        number->value > static_cast<double>(maximum))
        failExpecting(Message("Recipe", "must be a whole number between 0 and %1").with(maximum));
    return static_cast<std::uint64_t>(number->value);
}

std::vector<JsonNumber> JsonNode::finiteNumbers(std::size_t count) const
{
    std::vector<JsonNumber> numbers;
    if (const auto* list = std::get_if<JsonValue::List>(&m_value->content))
        for (const JsonValue& value : *list)
            if (const auto* number = std::get_if<JsonNumber>(&value.content); number && std::isfinite(number->value))
                numbers.push_back(*number);
    // Anything that is no number was left out, so a wrong element shows as a wrong count.
    const bool complete =
        isList() && numbers.size() == count && std::get<JsonValue::List>(m_value->content).size() == count;
    if (!complete)
        failExpecting(Message("Recipe", "must hold %1 numbers").with(count));
    return numbers;
}

std::vector<double> JsonNode::numbers(std::size_t count) const
{
    std::vector<double> values;
    for (const JsonNumber& number : finiteNumbers(count))
        values.push_back(number.value);
    return values;
}

std::vector<double> JsonNode::thousandths(std::size_t count) const
{
    std::vector<double> values;
    for (const JsonNumber& number : finiteNumbers(count))
        values.push_back(number.thousandth);
    return values;
}

} // namespace knead
