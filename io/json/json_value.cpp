#include "io/json/json_value.h"

#include "core/message/message.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace knead {

namespace {

constexpr std::size_t maximumDepth = 100; // deeper nesting is no recipe and would exhaust the stack
constexpr std::size_t shortLength = 60;

Message lineAndColumn(const std::string& text, std::size_t end)
{
    const auto stop = text.begin() + static_cast<std::ptrdiff_t>(std::min(end, text.size()));
    const auto line = 1 + std::count(text.begin(), stop, '\n');
    const auto start = std::find(std::make_reverse_iterator(stop), text.rend(), '\n').base();
    return Message("Recipe", "line %1, column %2").with(line, std::max<std::ptrdiff_t>(stop - start, 1));
}

/// What the parser complains about, without its own prefix: "unexpected '}'; expected string literal".
std::string complaint(const std::string& message)
{
    const std::string mark = "syntax error ";
    const std::size_t at = message.find(mark);
    if (at == std::string::npos)
        return message;
    const std::size_t dash = message.find(" - ", at);
    return message.substr(dash == std::string::npos ? at + mark.size() : dash + 3);
}

/// The number that digits say, with its point three places further left. JSON has no others than from_chars reads.
double thousandthOf(const std::string& digits, double value)
{
    const std::size_t exponentAt = std::min(digits.find_first_of("eE"), digits.size());
    long exponent = 0;
    if (exponentAt < digits.size())
        exponent = std::strtol(digits.c_str() + exponentAt + 1, nullptr, 10);
    const std::string shifted = digits.substr(0, exponentAt) + "e" + std::to_string(exponent - 3);
    double result = 0;
    const auto [end, error] = std::from_chars(shifted.data(), shifted.data() + shifted.size(), result);
    return error == std::errc{} ? result : value / 1000;
}

/// Where the parser is in the text.
struct Place {
    std::uint32_t line = 1;
    bool isAfterBreak = false; ///< the last character was a line break
};

/// Goes through a text and counts its lines.
class CountedCharacter {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountedCharacter(const char* at, Place* place)
        : m_at(at)
        , m_place(place)
    {
    }

    reference operator*() const { return *m_at; }
    CountedCharacter& operator++()
    {
        m_place->isAfterBreak = *m_at++ == '\n';
        m_place->line += m_place->isAfterBreak ? 1 : 0;
        return *this;
    }
    CountedCharacter operator++(int)
    {
        const CountedCharacter before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountedCharacter& a, const CountedCharacter& b) { return a.m_at == b.m_at; }
    friend bool operator!=(const CountedCharacter& a, const CountedCharacter& b) { return a.m_at != b.m_at; }

private:
    const char* m_at;
    Place* m_place;
};

/// Builds the tree from the parser's events. A value is complete when its last event has come.
class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(const std::string& text, std::string file, const Place& place)
        : m_text(text)
        , m_file(std::move(file))
        , m_place(place)
    {
    }

    JsonValue take() { return std::move(m_root); }

    bool null() override { return add(JsonValue{}, m_place.line); }
    bool boolean(bool value) override { return add(JsonValue{value}, m_place.line); }
    bool number_integer(number_integer_t value) override
    {
        return addNumber(static_cast<double>(value), std::to_string(value));
    }
    bool number_unsigned(number_unsigned_t value) override
    {
        return addNumber(static_cast<double>(value), std::to_string(value));
    }
    bool number_float(number_float_t value, const string_t& digits) override { return addNumber(value, digits); }
    bool string(string_t& value) override { return add(JsonValue{value}, m_place.line); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonValue{JsonValue::Object{}}); }
    bool start_array(std::size_t) override { return open(JsonValue{JsonValue::List{}}); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        const auto& object = std::get<JsonValue::Object>(m_open.back().content);
        for (const auto& member : object)
            if (member.first == name)
                throw Problem(
                    Message("Recipe", "%1: the key \"%2\" is given twice in the same object.").with(m_file, name));
        m_keys.back() = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error) override
    {
        throw Problem(
            Message::verbatim("%1: %2: %3.").with(m_file, lineAndColumn(m_text, position), complaint(error.what())));
    }

private:
    bool open(JsonValue value)
    {
        if (m_open.size() == maximumDepth)
            throw Problem(
                Message("Recipe", "%1: lists and objects are nested more than %2 deep.").with(m_file, maximumDepth));
        value.line = m_place.line;
        m_open.push_back(std::move(value));
        m_keys.emplace_back();
        return true;
    }

    bool close()
    {
        JsonValue value = std::move(m_open.back());
        m_open.pop_back();
        m_keys.pop_back();
        const std::uint32_t line = value.line;
        return add(std::move(value), line);
    }

    /// The parser has read the character after a number too.
    bool addNumber(double value, const std::string& digits)
    {
        return add(JsonValue{JsonNumber{value, thousandthOf(digits, value)}},
                   m_place.line - (m_place.isAfterBreak ? 1U : 0U));
    }

    bool add(JsonValue value, std::uint32_t line)
    {
        value.line = line;
        if (m_open.empty())
            m_root = std::move(value);
        else if (auto* list = std::get_if<JsonValue::List>(&m_open.back().content))
            list->push_back(std::move(value));
        else
            std::get<JsonValue::Object>(m_open.back().content).emplace_back(m_keys.back(), std::move(value));
        return true;
    }

    const std::string& m_text;
    std::string m_file;
    const Place& m_place;
    JsonValue m_root;
    std::vector<JsonValue> m_open;   ///< objects and lists whose end has not come yet
    std::vector<std::string> m_keys; ///< for each of them, the key its next value belongs to
};

void print(const JsonValue& value, std::ostream& out);

template <class Items, class PrintItem>
void printItems(const Items& items, char open, char close, std::ostream& out, PrintItem printItem)
{
    out << open;
    bool first = true;
    for (const auto& item : items) {
        out << (first ? "" : ", ");
        printItem(item);
        first = false;
    }
    out << close;
}

struct Printer {
    std::ostream& out;

    void operator()(std::monostate) const { out << "null"; }
    void operator()(bool value) const { out << (value ? "true" : "false"); }
    void operator()(const JsonNumber& number) const { out << number.value; }
    void operator()(const std::string& value) const { out << '"' << value << '"'; }
    void operator()(const JsonValue::List& list) const
    {
        printItems(list, '[', ']', out, [this](const JsonValue& item) { print(item, out); });
    }
    void operator()(const JsonValue::Object& object) const
    {
        printItems(object, '{', '}', out, [this](const auto& member) {
            out << '"' << member.first << "\": ";
            print(member.second, out);
        });
    }
};

void print(const JsonValue& value, std::ostream& out)
{
    std::visit(Printer{out}, value.content);
}

} // namespace

JsonValue parseJson(const std::string& text, const std::string& file)
{
    Place place;
    TreeBuilder builder(text, file, place);
    const char* const begin = text.data();
    nlohmann::json::sax_parse(CountedCharacter(begin, &place), CountedCharacter(begin + text.size(), &place), &builder);
    return builder.take();
}

std::string shortJson(const JsonValue& value)
{
    std::ostringstream out;
    print(value, out);
    const std::string text = out.str();
    return text.size() <= shortLength ? text : text.substr(0, shortLength) + "...";
}

} // namespace knead
