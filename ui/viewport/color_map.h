#pragma once

#include "core/model/part.h"

#include <array>
#include <cstdint>
#include <span>

namespace knead {

/// Ways to show numbers as colors. Lightness changes evenly along each of them, so that equal steps look equal, also for people
/// who see few colors and on gray paper.
enum class ColorMap : std::uint8_t {
    viridis = 0,  ///< dark violet, green, yellow
    cividis = 1,  ///< dark blue, gray, yellow: looks nearly alike to all people
    gray = 2,     ///< dark to light
    diverging = 3 ///< blue below, white in the middle, orange above: for numbers with a sign
};

/// A map that a person may choose, for numbers without a sign.
struct ColorMapChoice {
    ColorMap map;
    const char* name;  ///< ends the name of its action
    const char* title; ///< to be translated in the context "ColorMap"
};
std::span<const ColorMapChoice> colorMapChoices();

/// The color of a number. @param share 0 .. 1 along the map; beyond, the color of its end
Color colorAt(ColorMap map, double share);

/// The map in 256 steps, red green blue.
using ColorTable = std::array<std::array<unsigned char, 3>, 256>;
const ColorTable& colorTable(ColorMap map);

} // namespace knead
