#pragma once

#include "core/geometry/vec3.h"
#include "core/message/message.h"
#include "io/json/json_reader.h"

#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace knead {

// What the sections of a recipe have in common. All readers throw as readRecipe() does.

constexpr double farAway = 1e6;                  ///< [mm]; a kilometer is no workbench
constexpr std::uint64_t mostSteps = 1ULL << 40U; ///< of a run
constexpr double radiansPerDegree = std::numbers::pi / 180;

/// Words of a recipe with what they mean, in the order of messages.
template <class Choice>
using Choices = std::vector<std::pair<std::string, Choice>>;

template <class Items, class NameOf>
std::string listed(const Items& items, NameOf nameOf)
{
    std::string text;
    for (const auto& item : items)
        text += (text.empty() ? "" : ", ") + nameOf(item);
    return text;
}

template <class Choice>
Choice readChoice(const JsonNode& node, const Choices<Choice>& choices)
{
    for (const auto& [word, choice] : choices)
        if (node.isString() && node.text() == word)
            return choice;
    node.failExpecting(
        Message("Recipe", "must be one of %1").with(listed(choices, [](const auto& named) { return named.first; })));
}

/// Three numbers, none larger than `limit` in size.
Vec3 readVector(const JsonNode& node, double limit);

/// The same, of millimeters [m], or of millimeters per second [m/s].
Vec3 readMillimeters(const JsonNode& node, double limit);

/// Three coordinates in millimeters [m].
Vec3 readPlace(const JsonNode& node);

/// `[x0, y0, z0, x1, y1, z1]` in millimeters [m].
Box readBox(const JsonNode& node);

/// Three angles in degrees: turns about the fixed axes x, y and z, in this order.
Quaternion readRotation(const JsonNode& node);

/// Four numbers w, x, y, z of a quaternion of length 1, which keeps its bits.
Quaternion readQuaternion(const JsonNode& node);

/// Place and rotation: `position_mm`, and `rotation_deg` or, to the last bit, `rotation_wxyz`. What is not said is as in `pose`.
Pose readPose(const JsonNode& node, Pose pose);

/// Numbers greater than 0 in millimeters [m].
std::vector<double> readLengths(const JsonNode& node, std::size_t count);

/// A file that exists, seen from the folder of the recipe; ready to open.
std::string readFilePath(const JsonNode& node, const std::string& recipePath);

} // namespace knead
