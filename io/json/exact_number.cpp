#include "io/json/exact_number.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace knead {

namespace {

constexpr int fewestPlaces = -5; // digits further right or left than this are written with an exponent
constexpr int mostPlaces = 15;

std::string digitsOf(std::string_view mantissa)
{
    std::string digits(mantissa);
    std::erase(digits, '.');
    return digits;
}

/// @param exponent of the first digit
std::string textOf(const std::string& digits, int exponent)
{
    if (exponent < fewestPlaces || exponent > mostPlaces)
        return digits.substr(0, 1) + (digits.size() > 1 ? '.' + digits.substr(1) : std::string()) + 'e' +
               std::to_string(exponent);
    if (exponent < 0)
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    const auto whole = static_cast<std::size_t>(exponent + 1);
    if (digits.size() <= whole)
        return digits + std::string(whole - digits.size(), '0');
    return digits.substr(0, whole) + '.' + digits.substr(whole);
}

} // namespace

std::string exactText(double value)
{
    if (std::isnan(value))
        return "\"nan\"";
    if (std::isinf(value))
        return value > 0 ? "\"infinity\"" : "\"-infinity\"";
    if (value == 0)
        return std::signbit(value) ? "-0.0" : "0"; // "-0" would be a whole number, which has no sign
    char text[32];
    const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    return {std::begin(text), end};
}

std::string exactThousandfold(double value)
{
    if (value == 0)
        return exactText(value);
    char text[32];
    const auto end =
        std::to_chars(std::begin(text), std::end(text), std::abs(value), std::chars_format::scientific).ptr;
    const std::string_view whole(text, static_cast<std::size_t>(end - text));
    const std::size_t exponentAt = whole.find('e');
    const int exponent = std::atoi(std::string(whole.substr(exponentAt + 1)).c_str());
    const std::string size = textOf(digitsOf(whole.substr(0, exponentAt)), exponent + 3);
    return value < 0 ? '-' + size : size;
}

} // namespace knead
