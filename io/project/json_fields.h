#pragma once

#include "core/geometry/vec3.h"
#include "core/mechanics/tool_shape.h"
#include "core/message/message.h"
#include "io/json/json_reader.h"
#include "io/json/json_text.h"
#include "io/recipe/recipe_values.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace knead {

// A type says once which fields it has, and is written and read by that:
//
//     template <class Fields> void describe(Fields& fields, Field<Fields, SetGravity> command)
//     {
//         fields("gravity_m_s2", command.gravity);
//     }
//
// Doubles keep their bits; those that JSON has no numbers for are the texts "infinity", "-infinity" and "nan".

/// Tool parts of a project by their numbers. Those who use the same part share it.
class ToolPartTable {
public:
    /// Its number; a new one when it was not seen before.
    std::uint32_t numberOf(const std::shared_ptr<const ToolPart>& part);

    const std::vector<std::shared_ptr<const ToolPart>>& parts() const { return m_parts; }

    /// Gives the next number to a part. Null: it could not be read, and neither can what uses it.
    void add(std::shared_ptr<const ToolPart> part) { m_parts.push_back(std::move(part)); }

private:
    std::vector<std::shared_ptr<const ToolPart>> m_parts;
};

class FieldWriter;

/// What describe() gets: a value to read into, or one to write.
template <class Fields, class Value>
using Field = std::conditional_t<std::is_same_v<Fields, FieldWriter>, const Value&, Value&>;

/// Writes fields as a JSON object on one line.
class FieldWriter {
public:
    explicit FieldWriter(ToolPartTable& tools)
        : m_tools(tools)
    {
    }

    void operator()(const char* key, bool value) { m_object.put(key, value ? "true" : "false"); }
    void flag(const char* key, bool value, bool /*missing*/) { (*this)(key, value); }
    /// Left out where it is not set.
    void flagIfSet(const char* key, bool value)
    {
        if (value)
            (*this)(key, value);
    }
    /// Left out where it is 0.
    template <class Number>
    void numberIfAny(const char* key, Number value)
    {
        if (value != 0)
            (*this)(key, value);
    }
    void operator()(const char* key, double value) { m_object.number(key, value); }
    void operator()(const char* key, std::uint32_t value) { m_object.put(key, std::to_string(value)); }
    void operator()(const char* key, std::uint64_t value) { m_object.put(key, std::to_string(value)); }
    void operator()(const char* key, const std::string& value) { m_object.text(key, value); }
    void operator()(const char* key, const std::vector<std::string>& value)
    {
        m_object.put(key, listText(value, quoted));
    }
    /// Left out without a value.
    void operator()(const char* key, const std::optional<double>& value)
    {
        if (value)
            (*this)(key, *value);
    }
    void operator()(const char* key, const Vec3& value) { m_object.numbers(key, value); }
    void operator()(const char* key, const Quaternion& value) { m_object.numbers(key, value); }
    void operator()(const char* key, const std::vector<std::uint32_t>& value)
    {
        m_object.put(key, stretchesText(value));
    }
    /// By its number; left out without a part.
    void operator()(const char* key, const std::shared_ptr<const ToolPart>& value);

    template <class Choice>
    void choice(const char* key, Choice value, const Choices<Choice>& words)
    {
        for (const auto& [word, meaning] : words)
            if (meaning == value)
                return (*this)(key, word);
    }

    template <class Value>
    void object(const char* key, const Value& value)
    {
        m_object.put(key, objectText(value));
    }

    /// Left out without a value.
    template <class Value>
    void object(const char* key, const std::optional<Value>& value)
    {
        if (value)
            object(key, *value);
    }

    template <class Value>
    void list(const char* key, const std::vector<Value>& values)
    {
        m_object.put(key, listText(values, [this](const Value& value) { return objectText(value); }));
    }

    /// Left out when empty.
    template <class Value>
    void listIfAny(const char* key, const std::vector<Value>& values)
    {
        if (!values.empty())
            list(key, values);
    }

    /// The object; the writer is empty again.
    std::string take() { return std::exchange(m_object, {}).take(); }

private:
    template <class Value>
    std::string objectText(const Value& value)
    {
        FieldWriter fields(m_tools);
        describe(fields, value);
        return fields.take();
    }

    ToolPartTable& m_tools;
    ObjectText m_object;
};

/// Reads fields from a JSON object; failures are Problems and name the field.
class FieldReader {
public:
    /// @param longList elements that all lists of numbers read with it may have together; counts down
    FieldReader(JsonNode node, const ToolPartTable& tools, std::size_t& longList)
        : m_node(std::move(node))
        , m_tools(tools)
        , m_longList(longList)
    {
    }

    void operator()(const char* key, bool& value) const { value = m_node.at(key).boolean(); }
    /// @param missing what it was before there was such a field
    void flag(const char* key, bool& value, bool missing) const
    {
        const auto node = m_node.find(key);
        value = node ? node->boolean() : missing;
    }
    void flagIfSet(const char* key, bool& value) const { flag(key, value, false); }
    template <class Number>
    void numberIfAny(const char* key, Number& value) const
    {
        value = 0;
        if (m_node.find(key))
            (*this)(key, value);
    }
    void operator()(const char* key, double& value) const;
    void operator()(const char* key, std::uint32_t& value) const;
    void operator()(const char* key, std::uint64_t& value) const;
    void operator()(const char* key, std::string& value) const { value = m_node.at(key).anyText(); }
    void operator()(const char* key, std::vector<std::string>& value) const;
    void operator()(const char* key, std::optional<double>& value) const;
    void operator()(const char* key, Vec3& value) const;
    void operator()(const char* key, Quaternion& value) const;
    void operator()(const char* key, std::vector<std::uint32_t>& value) const;
    void operator()(const char* key, std::shared_ptr<const ToolPart>& value) const;

    template <class Choice>
    void choice(const char* key, Choice& value, const Choices<Choice>& words) const
    {
        value = readChoice(m_node.at(key), words);
    }

    template <class Value>
    void object(const char* key, Value& value) const
    {
        read(m_node.at(key), value);
    }

    template <class Value>
    void object(const char* key, std::optional<Value>& value) const
    {
        value.reset();
        if (const std::optional<JsonNode> node = m_node.find(key))
            read(*node, value.emplace());
    }

    template <class Value>
    void list(const char* key, std::vector<Value>& values) const
    {
        values.clear();
        for (const JsonNode& item : m_node.at(key).items())
            read(item, values.emplace_back());
    }

    template <class Value>
    void listIfAny(const char* key, std::vector<Value>& values) const
    {
        values.clear();
        if (m_node.find(key))
            list(key, values);
    }

    const JsonNode& node() const { return m_node; }

private:
    template <class Value>
    void read(const JsonNode& node, Value& value) const
    {
        const FieldReader fields(node, m_tools, m_longList);
        describe(fields, value);
    }

    JsonNode m_node;
    const ToolPartTable& m_tools;
    std::size_t& m_longList;
};

template <class Alternative>
struct NoWord;

/// The word for an alternative of a variant.
template <class Alternative>
inline constexpr NoWord<Alternative> wordOf{};

/// What has no members has no fields.
template <class Fields, class Value>
requires std::is_empty_v<Value>
void describe(Fields&, Value&) {}

/// A variant as the fields of what it holds, with the word for it under a key. An alternative without wordOf or describe()
/// does not compile.
template <class... Alternatives>
void describeVariant(FieldWriter& fields, const char* key, const std::variant<Alternatives...>& variant)
{
    std::visit(
        [&]<class Value>(const Value& value) {
            fields(key, std::string(wordOf<Value>));
            describe(fields, value);
        },
        variant);
}

template <class... Alternatives>
void describeVariant(const FieldReader& fields, const char* key, std::variant<Alternatives...>& variant)
{
    std::string word;
    fields(key, word);
    const auto readAs = [&]<class Value>(Value value) {
        describe(fields, value);
        variant = std::move(value);
        return true;
    };
    const bool isKnown = ((word == wordOf<Alternatives> && readAs(Alternatives{})) || ...);
    if (!isKnown)
        fields.node().at(key).failExpecting(Message("Recipe", "must be one of those that this program knows"));
}

} // namespace knead
