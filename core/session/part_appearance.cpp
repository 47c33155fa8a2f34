#include "core/session/part_appearance.h"

#include "core/session/filled_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

namespace knead {

namespace {

int byteOf(float channel)
{
    return static_cast<int>(std::lround(255 * std::clamp(channel, 0.0F, 1.0F)));
}

} // namespace

std::string textOf(const Color& color)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byteOf(color.r), byteOf(color.g), byteOf(color.b));
    return text;
}

std::optional<Color> colorOf(const std::string& text)
{
    const auto isHex = [](char c) { return std::string("0123456789abcdefABCDEF").find(c) != std::string::npos; };
    if (text.size() != 7 || text[0] != '#' || !std::all_of(text.begin() + 1, text.end(), isHex))
        return std::nullopt;
    const auto channel = [&](std::size_t begin) {
        return static_cast<float>(std::stoi(text.substr(begin, 2), nullptr, 16)) / 255.0F;
    };
    return Color{channel(1), channel(3), channel(5)};
}

PartAppearance PartAppearance::at(const History& tree, History::Entry entry)
{
    PartAppearance appearance;
    for (const History::Entry step : tree.pathTo(entry))
        for (const RecordedCommand& recorded : tree.record(step).commands)
            appearance.follow(recorded.command);
    return appearance;
}

void PartAppearance::follow(const Command& command)
{
    if (const auto* look = std::get_if<SetPartLook>(&command))
        m_chosen[look->part] = {look->name, colorOf(look->color)};
}

std::string PartAppearance::chosenName(std::size_t part) const
{
    const auto found = m_chosen.find(part);
    return found == m_chosen.end() ? std::string() : found->second.name;
}

std::optional<Color> PartAppearance::chosenColor(std::size_t part) const
{
    const auto found = m_chosen.find(part);
    return found == m_chosen.end() ? std::nullopt : found->second.color;
}

Color PartAppearance::faceColor(const Model& model, std::size_t part, std::uint32_t face) const
{
    const std::optional<Color> chosen = chosenColor(part);
    return chosen ? *chosen : knead::faceColor(model.parts[part], face);
}

Color PartAppearance::partColor(const Model& model, std::size_t part) const
{
    return chosenColor(part).value_or(model.parts[part].color.value_or(Color{}));
}

void PartAppearance::dress(Part& copy, std::size_t part) const
{
    if (const std::string name = chosenName(part); !name.empty())
        copy.name = name;
    if (const std::optional<Color> color = chosenColor(part)) {
        copy.color = color;
        for (PartFace& face : copy.faces)
            face.color.reset();
    }
}

PartNode PartAppearance::dressed(const PartNode& tree) const
{
    PartNode result = tree;
    if (tree.part)
        if (const std::string name = chosenName(*tree.part); !name.empty())
            result.name = name;
    for (PartNode& child : result.children)
        child = dressed(child);
    return result;
}

} // namespace knead
