#include "io/formats/threemf/color_groups.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace knead {

namespace {

std::optional<Color> ownColorOf(const MeshBody& body, std::size_t triangle)
{
    if (body.faceColors.empty() || body.mesh.faceOfTriangle.empty())
        return std::nullopt;
    const std::uint32_t face = body.mesh.faceOfTriangle[triangle];
    return face < body.faceColors.size() ? body.faceColors[face] : std::nullopt;
}

} // namespace

ColorBytes toBytes(const Color& color)
{
    const auto byte = [](float channel) {
        return static_cast<unsigned char>(std::lround(255 * std::clamp(channel, 0.0F, 1.0F)));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

std::string hexDigits(const Color& color)
{
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned char channel : toBytes(color)) {
        text += digits[channel >> 4U];
        text += digits[channel & 15U];
    }
    return text;
}

std::string materialName(const Color& color)
{
    return "color_" + hexDigits(color);
}

Color colorOf(const MeshBody& body, std::size_t triangle)
{
    return ownColorOf(body, triangle).value_or(body.color);
}

bool hasFaceColors(const MeshBody& body)
{
    const ColorBytes usual = toBytes(body.color);
    return !body.mesh.faceOfTriangle.empty() &&
           std::any_of(body.faceColors.begin(), body.faceColors.end(),
                       [&](const std::optional<Color>& color) { return color && toBytes(*color) != usual; });
}

ColorGroups groupByColor(const MeshBody& body)
{
    const std::size_t count = body.mesh.triangles.size();
    if (!hasFaceColors(body))
        return {{{body.color, 0, count}}, {}};
    ColorGroups result;
    std::map<ColorBytes, std::size_t> places;
    std::vector<std::uint32_t> groupOf(count);
    for (std::size_t t = 0; t < count; ++t) {
        const Color color = colorOf(body, t);
        const auto [place, isNew] = places.emplace(toBytes(color), result.groups.size());
        if (isNew)
            result.groups.push_back({color, 0, 0});
        groupOf[t] = static_cast<std::uint32_t>(place->second);
        ++result.groups[place->second].end; // its size for now
    }
    std::size_t begin = 0;
    for (ColorGroups::Group& group : result.groups) {
        group.begin = begin;
        begin += group.end;
        group.end = group.begin; // where its next triangle goes
    }
    result.order.resize(count);
    for (std::size_t t = 0; t < count; ++t)
        result.order[result.groups[groupOf[t]].end++] = static_cast<std::uint32_t>(t);
    return result;
}

Palette::Palette(const std::vector<const MeshBody*>& bodies)
{
    const auto add = [this](const Color& color) {
        if (places.emplace(toBytes(color), colors.size()).second)
            colors.push_back(color);
    };
    for (const MeshBody* body : bodies) {
        add(body->color);
        for (const std::optional<Color>& color : body->faceColors)
            add(color.value_or(body->color));
    }
}

} // namespace knead
