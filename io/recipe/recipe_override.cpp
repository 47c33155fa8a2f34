#include "io/recipe/recipe_override.h"

#include "core/message/message.h"
#include "io/json/json_value.h"
#include "io/recipe/recipe_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace knead {

namespace {

constexpr std::string_view asJson = "{[\""; // what begins like this is meant as JSON

bool startsAsJson(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\n");
    return first != std::string::npos && asJson.find(text[first]) != std::string_view::npos;
}

const std::string* nameOfItem(const JsonValue& item)
{
    if (const auto* object = std::get_if<JsonValue::Object>(&item.content))
        for (const auto& [key, value] : *object)
            if (key == "name")
                return std::get_if<std::string>(&value.content);
    return nullptr;
}

/// Whether a path begins with a step, which may hold dots.
bool beginsWith(std::string_view path, std::string_view step)
{
    return path.starts_with(step) && (path.size() == step.size() || path[step.size()] == '.');
}

std::optional<std::size_t> indexOf(std::string_view step)
{
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    return error == std::errc{} && end == step.data() + step.size() ? std::optional(index) : std::nullopt;
}

/// Follows one path from the root to the value it names.
class Walk {
public:
    Walk(const RecipeOverride& change, const std::string& file)
        : m_change(change)
        , m_rest(change.path)
        , m_file(file)
        , m_value(overrideValue(change))
    {
    }

    void change(JsonValue& at)
    {
        if (auto* text = std::get_if<std::string>(&at.content); text && isMaterial())
            at.content = JsonValue::Object{{"preset", JsonValue{*text}}};
        if (auto* object = std::get_if<JsonValue::Object>(&at.content))
            changeObject(*object);
        else if (auto* list = std::get_if<JsonValue::List>(&at.content))
            changeList(*list);
        else
            fail(Message("Recipe", "%1 is %2, which has nothing in it to set.").with(placeOrFile(), shortJson(at)));
    }

private:
    void changeObject(JsonValue::Object& object)
    {
        std::string key(stepUpToDot());
        for (const auto& [known, value] : object)
            if (beginsWith(m_rest, known) && known.size() > key.size())
                key = known;
        step(key);
        const auto same = [&](const auto& member) { return member.first == key; };
        auto found = std::find_if(object.begin(), object.end(), same);
        if (m_rest.empty() && takesAway()) {
            object.erase(std::remove_if(object.begin(), object.end(), same), object.end());
            return;
        }
        if (found == object.end())
            found = object.insert(found, {key, JsonValue{JsonValue::Object{}}});
        changeOrGoOn(found->second);
    }

    void changeList(JsonValue::List& list)
    {
        const std::size_t index = itemOf(list);
        if (m_rest.empty() && takesAway())
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
        else
            changeOrGoOn(list[index]);
    }

    /// The item whose name comes next; the longest name, since names may hold dots.
    const std::string* nameIn(const JsonValue::List& list) const
    {
        const std::string* best = nullptr;
        for (const JsonValue& item : list)
            if (const std::string* name = nameOfItem(item);
                name && !name->empty() && beginsWith(m_rest, *name) && (!best || name->size() > best->size()))
                best = name;
        return best;
    }

    /// By name, else by number.
    std::size_t itemOf(const JsonValue::List& list)
    {
        if (const std::string* name = nameIn(list)) {
            const auto isIt = [&](const JsonValue& item) { return nameOfItem(item) == name; };
            step(*name);
            return static_cast<std::size_t>(std::find_if(list.begin(), list.end(), isIt) - list.begin());
        }
        const Message place = placeOrFile();
        const std::string wanted(stepUpToDot());
        const std::optional<std::size_t> index = indexOf(wanted);
        if (!index || *index >= list.size())
            fail(Message("Recipe", "%1 has no item \"%2\"; allowed here: %3.").with(place, wanted, itemsOf(list)));
        step(wanted);
        return *index;
    }

    static Message itemsOf(const JsonValue::List& list)
    {
        if (list.empty())
            return Message("Recipe", "a whole list, since this one is empty");
        const Message numbers = list.size() == 1 ? Message("Recipe", "the number 0")
                                                 : Message("Recipe", "the numbers 0 to %1").with(list.size() - 1);
        std::vector<std::string> names;
        for (const JsonValue& item : list)
            if (const std::string* name = nameOfItem(item))
                names.push_back(*name);
        if (names.empty())
            return numbers;
        return Message("Recipe", "%1 and the names %2").with(numbers, listed(names, [](const std::string& name) {
                                                                 return name;
                                                             }));
    }

    void changeOrGoOn(JsonValue& found)
    {
        if (m_rest.empty())
            found = m_value;
        else
            change(found);
    }

    bool takesAway() const { return std::holds_alternative<std::monostate>(m_value.content); }

    /// What the steps so far lead to may be the name of a material.
    bool isMaterial() const
    {
        const std::size_t count = m_steps.size();
        return count > 0 && (m_steps[count - 1] == "material" || (count == 2 && m_steps[0] == "body_materials"));
    }

    std::string_view stepUpToDot() const
    {
        const std::string_view step = m_rest.substr(0, m_rest.find('.'));
        if (step.empty())
            fail(Message("Recipe",
                         "the path has an empty step; between two dots there must be a key, a name or a number."));
        return step;
    }

    /// Goes past a step. @pre the rest begins with it
    void step(const std::string& taken)
    {
        m_steps.push_back(taken);
        m_place += (m_place.empty() ? "" : ".") + taken;
        const bool isLast = m_rest.size() == taken.size();
        m_rest.remove_prefix(isLast ? taken.size() : taken.size() + 1);
        if (!isLast && m_rest.empty())
            fail(Message("Recipe", "the path ends with a dot; name what is to be set after it."));
    }

    Message placeOrFile() const { return m_place.empty() ? Message("Recipe", "the file") : Message::verbatim(m_place); }

    [[noreturn]] void fail(const Message& saying) const
    {
        throw Problem(Message("Recipe", "%1: %2 cannot be set: %3").with(m_file, m_change.path, saying));
    }

    const RecipeOverride& m_change;
    std::string_view m_rest; ///< of the path
    const std::string& m_file;
    JsonValue m_value;
    std::string m_place; ///< of the path, as far as the walk has come
    std::vector<std::string> m_steps;
};

/// A recipe says in one way how finely parts are filled: what is set takes the place of what the file says.
void forgetOtherFilling(const std::string& key, JsonValue& recipe)
{
    constexpr std::array<std::string_view, 4> ways{"spacing_mm", "cells_across", "cells_across_wall", "objects"};
    auto* object = std::get_if<JsonValue::Object>(&recipe.content);
    const auto isSet = [&] {
        return std::ranges::any_of(*object, [&](const auto& item) { return item.first == key; });
    };
    if (object == nullptr || std::ranges::find(ways, key) == ways.end() || !isSet())
        return;
    std::erase_if(*object, [&](const auto& item) {
        return item.first != key && std::ranges::find(ways, item.first) != ways.end();
    });
}

} // namespace

RecipeOverride parseOverride(const std::string& text)
{
    const std::size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos)
        throw Problem(Message("Recipe", "\"%1\" sets nothing; write PATH=VALUE, for example spacing_mm=3.").with(text));
    return {text.substr(0, sign), text.substr(sign + 1)};
}

void forgetLines(JsonValue& value)
{
    value.line = 0;
    if (auto* list = std::get_if<JsonValue::List>(&value.content))
        for (JsonValue& item : *list)
            forgetLines(item);
    if (auto* object = std::get_if<JsonValue::Object>(&value.content))
        for (auto& member : *object)
            forgetLines(member.second);
}

/// What is set stands in no line of the file.
JsonValue overrideValue(const RecipeOverride& change)
{
    try {
        JsonValue value = parseJson(change.value, "the value of " + change.path);
        forgetLines(value);
        return value;
    } catch (const std::runtime_error&) {
        if (startsAsJson(change.value))
            throw;
        return JsonValue{change.value};
    }
}

void applyOverrides(JsonValue& recipe, const std::vector<RecipeOverride>& changes, const std::string& file)
{
    for (const RecipeOverride& change : changes) {
        Walk(change, file).change(recipe);
        forgetOtherFilling(change.path, recipe);
    }
}

} // namespace knead
