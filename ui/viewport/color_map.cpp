#include "ui/viewport/color_map.h"

#include <QtGlobal>
#include <map>

#include <algorithm>
#include <cmath>
#include <span>

namespace knead {

namespace {

/// Places along the maps, evenly spaced, red green blue.
// Viridis (van der Walt and Smith) and cividis (Nunez, Anderton, Renslow) by ten of their published colors, in which they are
// told apart from the whole table by less than a person sees.
constexpr std::uint32_t viridis[] = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                     0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
constexpr std::uint32_t cividis[] = {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173,
                                     0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838};
constexpr std::uint32_t gray[] = {0x262626, 0xf0f0f0};
// From CIELAB: lightness 38 .. 95 .. 38 in even steps, hue 262 degrees below and 52 above, chroma up to 62 and 50.
constexpr std::uint32_t diverging[] = {0x0061aa, 0x007cba, 0x5f98c9, 0x93b4d8, 0xc1d2e6, 0xf1f1f1,
                                       0xeacabb, 0xdca58b, 0xc9815d, 0xb45e32, 0x9b3b01};

constexpr ColorMapChoice choices[] = {{ColorMap::viridis, "Viridis", QT_TRANSLATE_NOOP("ColorMap", "Viridis")},
                                      {ColorMap::cividis, "Cividis", QT_TRANSLATE_NOOP("ColorMap", "Cividis")},
                                      {ColorMap::gray, "Gray", QT_TRANSLATE_NOOP("ColorMap", "Gray")}};

std::span<const std::uint32_t> placesOf(ColorMap map)
{
    switch (map) {
    case ColorMap::viridis:
        return viridis;
    case ColorMap::cividis:
        return cividis;
    case ColorMap::gray:
        return gray;
    case ColorMap::diverging:
        break;
    }
    return diverging;
}

Color colorOf(std::uint32_t code)
{
    const auto channel = [code](unsigned shift) { return static_cast<float>(code >> shift & 0xffU) / 255.0F; };
    return {channel(16), channel(8), channel(0)};
}

ColorTable tableOf(ColorMap map)
{
    ColorTable table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Color color = colorAt(map, static_cast<double>(i) / (table.size() - 1));
        const auto byteOf = [](float value) { return static_cast<unsigned char>(std::lround(255.0F * value)); };
        table[i] = {byteOf(color.r), byteOf(color.g), byteOf(color.b)};
    }
    return table;
}

} // namespace

std::span<const ColorMapChoice> colorMapChoices()
{
    return choices;
}

Color colorAt(ColorMap map, double share)
{
    const std::span<const std::uint32_t> places = placesOf(map);
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(places.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), places.size() - 2);
    const Color a = colorOf(places[low]);
    const Color b = colorOf(places[low + 1]);
    const auto s = static_cast<float>(at - static_cast<double>(low));
    return {a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b)};
}

const ColorTable& colorTable(ColorMap map)
{
    static const auto tables = [] {
        std::map<ColorMap, ColorTable> all{{ColorMap::diverging, tableOf(ColorMap::diverging)}};
        for (const ColorMapChoice& choice : choices)
            all.emplace(choice.map, tableOf(choice.map));
        return all;
    }();
    return tables.at(map);
}

} // namespace knead
