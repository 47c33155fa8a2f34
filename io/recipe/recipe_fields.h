#pragma once

#include "core/aggregate/material.h"
#include "io/json/json_reader.h"
#include "io/json/json_text.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace knead::recipe_keys {

// An object of a recipe says once which keys it has, in which order, what they hold and within which bounds:
//
//     template <class Fields>
//     void describeKeys(Fields& fields, RecipeFloor& floor)
//     {
//         fields.needed("height_mm", floor.height, Millimeters{});
//         fields.optional("friction", floor.friction, Number{0, 2});
//         fields.optional("adhesion_pa", floor.adhesion, Number{0, 1e9}, floor.adhesion > 0);
//     }
//
// From that it is read and written, and follows what a reader says is allowed in it. What keys hold is a kind, see
// recipe_kinds.h.

/// What objects are read and written with.
struct Context {
    const std::vector<MaterialPreset>& presets;
    std::string recipePath; ///< that files are named as seen from
};

/// For those who ask for keys only.
inline const Context& nowhere()
{
    static const std::vector<MaterialPreset> none;
    static const Context context{none, {}};
    return context;
}

/// Notes which keys an object has.
class KeyNames {
public:
    explicit KeyNames(const Context& known)
        : context(known)
    {
    }

    template <class Value, class Kind>
    void needed(const char* key, Value& /*value*/, const Kind& /*kind*/)
    {
        names.emplace_back(key);
    }
    template <class Value, class Kind>
    void optional(const char* key, Value& /*value*/, const Kind& /*kind*/, bool /*isWritten*/ = true)
    {
        names.emplace_back(key);
    }
    template <class... Steps>
    void together(std::initializer_list<const char*> keys, const Steps&... /*readAndWrite*/)
    {
        names.insert(names.end(), keys.begin(), keys.end());
    }
    template <class Check>
    void check(const Check& /*check*/)
    {
    }

    const Context& context;
    std::vector<std::string> names;
};

/// Reads what an object holds. Failures are Problems with the place in the recipe.
class Reading {
public:
    Reading(const JsonNode& node, const Context& known)
        : context(known)
        , m_node(node)
    {
    }

    /// A key that must be there.
    template <class Value, class Kind>
    void needed(const char* key, Value& value, const Kind& kind)
    {
        value = kind.read(m_node.at(key));
    }
    /// A key that may be left out: the value stays as it is.
    template <class Value, class Kind>
    void optional(const char* key, Value& value, const Kind& kind, bool /*isWritten*/ = true)
    {
        if (const auto found = m_node.find(key))
            value = kind.read(*found);
    }
    /// Keys that depend on each other: one function reads them all from the object, another puts them.
    template <class Read, class... Write>
    void together(std::initializer_list<const char*> /*keys*/, const Read& read, const Write&... /*write*/)
    {
        read(m_node);
    }
    /// What has to be seen to once the keys before are read.
    template <class Check>
    void check(const Check& check)
    {
        check(m_node);
    }

    const Context& context;

private:
    const JsonNode& m_node;
};

/// Writes what an object holds.
class Writing {
public:
    Writing(ObjectText& text, const Context& known)
        : context(known)
        , m_text(text)
    {
    }

    template <class Value, class Kind>
    void needed(const char* key, const Value& value, const Kind& kind)
    {
        m_text.put(key, kind.text(value));
    }
    /// @param isWritten false: it goes without saying
    template <class Value, class Kind>
    void optional(const char* key, const Value& value, const Kind& kind, bool isWritten = true)
    {
        if (isWritten)
            needed(key, value, kind);
    }
    template <class Value, class Kind>
    void optional(const char* key, const std::optional<Value>& value, const Kind& kind)
    {
        if (value)
            needed(key, *value, kind);
    }
    template <class Read, class Write>
    void together(std::initializer_list<const char*> /*keys*/, const Read& /*read*/, const Write& write)
    {
        write(m_text);
    }
    template <class Check>
    void check(const Check& /*check*/)
    {
    }

    const Context& context;

private:
    ObjectText& m_text;
};

/// The keys of an object, in the order of messages.
template <class Value>
const std::vector<std::string>& keysOf()
{
    static const std::vector<std::string> keys = [] {
        KeyNames fields(nowhere());
        Value value;
        describeKeys(fields, value);
        return fields.names;
    }();
    return keys;
}

/// Keys of an object beside others.
template <class Value>
void readInto(const JsonNode& node, Value& value, const Context& context)
{
    Reading fields(node, context);
    describeKeys(fields, value);
}

template <class Value>
void putInto(ObjectText& text, Value value, const Context& context)
{
    Writing fields(text, context);
    describeKeys(fields, value);
}

/// The kind of an object with its own keys, and no others.
template <class Value>
struct Object {
    using Of = Value;
    const Context& context;

    Value read(const JsonNode& node, Value value = {}) const
    {
        node.allowOnly(keysOf<Value>());
        readInto(node, value, context);
        return value;
    }
    std::string text(const Value& value) const
    {
        ObjectText object;
        putInto(object, value, context);
        return object.take();
    }
};

/// The kind of a list.
template <class Kind>
struct ListOf {
    Kind kind;

    auto read(const JsonNode& node) const
    {
        std::vector<decltype(kind.read(node))> values;
        for (const JsonNode& item : node.items())
            values.push_back(kind.read(item));
        return values;
    }
    template <class Value>
    std::string text(const std::vector<Value>& values) const
    {
        return listText(values, [this](const Value& value) { return kind.text(value); });
    }
};
template <class Kind>
ListOf(Kind) -> ListOf<Kind>;

/// The kind of an object that stands for itself by one value.
template <class Action, class Value, class Kind>
struct Only {
    using Of = Action;
    Value Action::*member;
    Kind kind;

    Action read(const JsonNode& node) const
    {
        Action action;
        action.*member = kind.read(node);
        return action;
    }
    std::string text(const Action& action) const { return kind.text(action.*member); }
};
template <class Action, class Value, class Kind>
Only(Value Action::*, Kind) -> Only<Action, Value, Kind>;

} // namespace knead::recipe_keys
