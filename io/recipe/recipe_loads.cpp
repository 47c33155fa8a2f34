// Loads of a recipe, and grips that turn.
#include "core/message/message.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double largestLoad = 1e12;         // [N], [N m], [Pa]
constexpr double longestRamp = 3600;         // [s]
constexpr double fastestGripTurn = 5e5;      // [degrees/s]
constexpr double fastestGripInRadians = 5e3; // [rad/s]

LoadAmount readAmount(const JsonNode& node)
{
    LoadAmount amount;
    if (const auto force = node.find("force_n"))
        amount.force = readVector(*force, largestLoad);
    if (const auto moment = node.find("moment_nm"))
        amount.moment = readVector(*moment, largestLoad);
    if (const auto pressure = node.find("pressure_pa"))
        amount.pressure = pressure->number(-largestLoad, largestLoad);
    return amount;
}

double readRamp(const JsonNode& node)
{
    const auto ramp = node.find("ramp_s");
    return ramp ? ramp->number(0, longestRamp) : 0;
}

Vec3 readAxis(const JsonNode& node)
{
    const Vec3 axis = readVector(node, farAway);
    if (axis.norm() == 0)
        node.failExpecting(Message("Recipe", "must be a direction of 3 numbers that are not all 0"));
    return axis.normalized();
}

} // namespace

RecipeLoad readRecipeLoad(const JsonNode& node)
{
    node.allowOnly({"name", "body", "faces", "box_mm", "force_n", "moment_nm", "pressure_pa", "ramp_s"});
    const RecipeRegion place = readRecipePlace(node);
    RecipeLoad load{.name = node.at("name").text(), .body = place.body, .faces = place.faces, .box = place.box};
    std::sort(load.faces.begin(), load.faces.end());
    load.faces.erase(std::unique(load.faces.begin(), load.faces.end()), load.faces.end());
    load.amount = readAmount(node);
    load.ramp = readRamp(node);
    return load;
}

ChangeRecipeLoad readChangeOfLoad(const JsonNode& node)
{
    node.allowOnly({"name", "force_n", "moment_nm", "pressure_pa", "ramp_s"});
    return {.load = node.at("name").text(), .amount = readAmount(node), .ramp = readRamp(node)};
}

GripTurn readGripTurn(const JsonNode& node)
{
    node.allowOnly({"center_mm", "axis", "speed_deg_s", "angle_deg", "angular_velocity_rad_s", "angle_rad"});
    GripTurn turn;
    turn.center = readPlace(node.at("center_mm"));
    const auto radians = node.find("angular_velocity_rad_s");
    if (radians && (node.find("axis") || node.find("speed_deg_s")))
        node.fail(Message("Recipe", "must have either axis and speed_deg_s, or angular_velocity_rad_s."));
    if (radians)
        turn.angularVelocity = readVector(*radians, fastestGripInRadians);
    else
        turn.angularVelocity = radiansPerDegree * node.at("speed_deg_s").number(-fastestGripTurn, fastestGripTurn) *
                               readAxis(node.at("axis"));
    const auto degrees = node.find("angle_deg");
    const auto angle = node.find("angle_rad");
    if (degrees && angle)
        node.fail(Message("Recipe", "must have only one of the keys angle_deg and angle_rad."));
    if (degrees)
        turn.angle = radiansPerDegree * degrees->positive();
    if (angle)
        turn.angle = angle->positive();
    return turn;
}

} // namespace knead
