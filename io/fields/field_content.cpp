#include "io/fields/field_content.h"

#include "core/model/length_units.h"
#include "io/fields/label_map.h"
#include "io/files/lower_case.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace knead {

namespace {

/// Words that names of displacements begin with, the surest first, in lower case.
constexpr std::array<std::string_view, 9> wordsForDisplacement{
    "disp", "deplacement", "verschiebung", "verplaatsing", "spostamento", "desplazamiento", "deform", "u", "d"};

/// The short ones must be all of the name.
bool meansDisplacement(const std::string& name, std::string_view word)
{
    const std::string lower = lowerCase(std::string(withoutUnit(name)));
    return word.size() == 1 ? lower == word : lower.starts_with(word);
}

std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t mostNamed = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), mostNamed); ++i)
        list += (i == 0 ? "" : ", ") + names[i];
    return names.size() > mostNamed ? list + " ..." : list;
}

} // namespace

Vec3 noVector()
{
    return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::size_t chosenStep(const FieldChoice& choice, std::size_t count)
{
    if (!choice.step)
        return count - 1;
    if (*choice.step >= count)
        throw Problem(Message("Field", "it has %1 time steps, there is no number %2; choose another one.")
                          .with(count, *choice.step + 1));
    return *choice.step;
}

std::size_t chosenName(const FieldChoice& choice, const std::vector<std::string>& names)
{
    if (names.empty())
        throw Problem(
            Message("Field", "it has no vectors at nodes; write the displacements of the nodes into it, too."));
    if (!choice.name.empty()) {
        const auto found = std::ranges::find_if(
            names, [&](const std::string& name) { return name == choice.name || withoutUnit(name) == choice.name; });
        if (found == names.end())
            throw Problem(Message("Field", "it has no vectors called %1 at its nodes; it has %2.")
                              .with(choice.name, listed(names)));
        return static_cast<std::size_t>(found - names.begin());
    }
    for (const std::string_view word : wordsForDisplacement)
        for (std::size_t i = 0; i < names.size(); ++i)
            if (meansDisplacement(names[i], word))
                return i;
    if (names.size() > 1)
        throw Problem(
            Message("Field", "several vectors could be the displacements: %1; say which.").with(listed(names)));
    return 0;
}

void choose(const FieldChoice& choice, FieldContent& content)
{
    content.step = chosenStep(choice, content.steps.size());
    content.name = content.names[chosenName(choice, content.names)];
}

std::string_view withoutUnit(std::string_view name)
{
    while (name.ends_with(' '))
        name.remove_suffix(1);
    if (!name.ends_with(']') && !name.ends_with(')'))
        return name;
    const std::size_t begin = name.find_last_of("[(");
    if (begin == name.npos || begin == 0)
        return name;
    name = name.substr(0, begin);
    while (name.ends_with(' '))
        name.remove_suffix(1);
    return name;
}

std::string unitIn(std::string_view name)
{
    const std::size_t begin = name.find_last_of("[(");
    const std::size_t end = name.find_last_of("])");
    if (begin == name.npos || end == name.npos || end < begin)
        return {};
    const LengthUnit* unit = findLengthUnit(name.substr(begin + 1, end - begin - 1));
    return unit == nullptr ? std::string() : unit->name;
}

std::string shortNumber(double number)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

void appendVectors(std::span<const double> numbers, std::vector<Vec3>& vectors)
{
    if (numbers.size() % 3 != 0)
        failAsDamaged();
    vectors.reserve(vectors.size() + numbers.size() / 3);
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
}

void checkCount(const std::string& name, std::size_t values, std::size_t nodes)
{
    if (values != nodes)
        throw Problem(
            Message("Field", "%1 has %2 values for %3 nodes; write the file again with the program it comes from.")
                .with(name, values, nodes));
}

void connectCells(FieldContent& content)
{
    LabelMap places(content.labels);
    for (std::int64_t& node : content.cells.connectivity) {
        const std::size_t place = places.find(node);
        if (place == LabelMap::none)
            throw Problem(
                Message("Field", "an element has node %1, which is missing; write the file again.").with(node));
        node = static_cast<std::int64_t>(place);
    }
}

void failAsDamaged()
{
    throw Problem(Message("Field", "the file is damaged; write it again with the program it comes from."));
}

} // namespace knead
