#include "app/sweep/variation.h"

#include "io/json/json_value.h"
#include "io/recipe/recipe_override.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace knead {

namespace {

constexpr const char* forms = "write PATH=A:B:lin:N, PATH=A:B:log:N or PATH=V,W,...";

[[noreturn]] void fail(const std::string& text, const std::string& saying)
{
    throw std::runtime_error("--vary " + text + ": " + saying + "; " + forms + ".");
}

/// Not a number when the text is none.
double numberOf(const std::string& text)
{
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    return isNumber ? number : std::nan("");
}

bool isNumber(const std::string& text)
{
    return !std::isnan(numberOf(text));
}

/// The fewest digits that give the number back.
std::string shortest(double number)
{
    const double size = std::abs(number);
    const auto format = size >= 1e-4 && size < 1e15 ? std::chars_format::fixed : std::chars_format::general;
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format).ptr;
    return {text.data(), end};
}

/// 0.1 + 0.2 / 2 is written as 0.2, not as 0.20000000000000001: values are read by people.
double rounded(double number)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.12g", number);
    return numberOf(text.data());
}

/// Parts a text at a character.
std::vector<std::string> parts(const std::string& text, char mark)
{
    std::vector<std::string> found(1);
    for (const char character : text)
        if (character == mark)
            found.emplace_back();
        else
            found.back() += character;
    return found;
}

/// Parts a text at commas outside of brackets, braces and quotes.
std::vector<std::string> listItems(const std::string& text)
{
    std::vector<std::string> items(1);
    int depth = 0;
    bool isQuoted = false;
    bool isEscaped = false;
    for (const char character : text) {
        if (character == '"' && !isEscaped)
            isQuoted = !isQuoted;
        isEscaped = isQuoted && character == '\\' && !isEscaped;
        if (!isQuoted && (character == '[' || character == '{'))
            ++depth;
        if (!isQuoted && (character == ']' || character == '}'))
            --depth;
        if (character == ',' && depth == 0 && !isQuoted)
            items.emplace_back();
        else
            items.back() += character;
    }
    return items;
}

bool looksLikeRange(const std::vector<std::string>& fields)
{
    const bool hasWord = fields.size() > 2 && (fields[2] == "lin" || fields[2] == "log");
    return hasWord || (fields.size() > 1 && isNumber(fields[0]) && isNumber(fields[1]));
}

std::vector<std::string> rangeOf(const std::string& text, const std::vector<std::string>& fields)
{
    const bool hasWord = fields.size() == 4 && (fields[2] == "lin" || fields[2] == "log");
    if (!hasWord || !isNumber(fields[0]) || !isNumber(fields[1]) || !isNumber(fields[3]))
        fail(text, "this is no range");
    const double begin = numberOf(fields[0]);
    const double end = numberOf(fields[1]);
    const double count = numberOf(fields[3]);
    if (count != std::floor(count) || count < 2 || count > static_cast<double>(mostPoints))
        fail(text, "a range takes 2 to " + std::to_string(mostPoints) + " values");
    const bool isLogarithmic = fields[2] == "log";
    if (isLogarithmic && (begin <= 0 || end <= 0))
        fail(text, "equal ratios need a beginning and an end above 0");

    std::vector<std::string> values;
    const auto last = static_cast<std::size_t>(count) - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(last);
        const double value = isLogarithmic ? begin * std::pow(end / begin, share) : begin + share * (end - begin);
        values.push_back(shortest(i == 0 ? begin : i == last ? end : rounded(value)));
    }
    return values;
}

void checkPathsDiffer(const std::vector<Variation>& variations)
{
    for (std::size_t i = 0; i < variations.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (variations[i].path == variations[j].path)
                throw std::runtime_error("--vary names " + variations[i].path +
                                         " twice; give all of its values at once.");
}

SweepPoints goTogether(const std::vector<Variation>& variations)
{
    SweepPoints points(variations.front().values.size());
    for (const Variation& variation : variations) {
        if (variation.values.size() != points.size())
            throw std::runtime_error("--zip needs as many values of each --vary, but " + variations.front().path +
                                     " has " + std::to_string(points.size()) + " and " + variation.path + " has " +
                                     std::to_string(variation.values.size()) + ".");
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].push_back(variation.values[i]);
    }
    return points;
}

SweepPoints gridOf(const std::vector<Variation>& variations)
{
    SweepPoints points(1);
    for (const Variation& variation : variations) {
        if (points.size() * variation.values.size() > mostPoints)
            throw std::runtime_error("The sweep has more than " + std::to_string(mostPoints) +
                                     " points; vary less, or take fewer values.");
        SweepPoints finer;
        for (const std::vector<std::string>& point : points)
            for (const std::string& value : variation.values) {
                finer.push_back(point);
                finer.back().push_back(value);
            }
        points = std::move(finer);
    }
    return points;
}

} // namespace

Variation parseVariation(const std::string& text)
{
    const std::size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos || sign + 1 == text.size())
        fail(text, "this varies nothing");
    const std::string value = text.substr(sign + 1);
    Variation variation{text.substr(0, sign), {}};
    const std::vector<std::string> fields = parts(value, ':');
    variation.values = looksLikeRange(fields) ? rangeOf(text, fields) : listItems(value);
    if (std::find(variation.values.begin(), variation.values.end(), "") != variation.values.end())
        fail(text, "there is nothing between two commas");
    for (const std::string& one : variation.values)
        overrideValue({variation.path, one});
    return variation;
}

SweepPoints combine(const std::vector<Variation>& variations, Combination combination)
{
    checkPathsDiffer(variations);
    return combination == Combination::together ? goTogether(variations) : gridOf(variations);
}

} // namespace knead
