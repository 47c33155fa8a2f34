// Material beyond its yield stress: flow, bending, twisting.
#include "core/geometry/turn.h"
#include "verify/cases.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr double yield = 4e3;   // [Pa]
constexpr const char* chapter = "Plastic flow";

Part blockBetweenPlates(const Pose& pose, double periods)
{
    constexpr double h = 0.02;
    Part part{.block = bar({h, h, h}, 2),
              .material = plastic(modulus, 0.4, yield, 0),
              .grips = {},
              .stages = {{0.1}, {1}},
              .pose = pose,
              .slowest = pullingFrequency(2 * h),
              .loadPeriods = periods};
    for (const double sign : {1.0, -1.0}) {
        Manipulator plate{.name = "plate", .size = {3 * h, 3 * h, h}};
        plate.friction = 0;
        plate.pose.position = Vec3(0, 0, sign * h);
        part.tools.push_back({plate, Vec3(0, 0, -sign * 0.1 * h)}); // to 0.8 of the height
    }
    return part;
}

/// Force over the section that constant volume makes, by the yield stress, at 2 and 20 %.
std::vector<double> flowStress(const std::vector<Finding>& findings)
{
    std::vector<double> values;
    const double shortening[] = {0.02, 0.2};
    for (std::size_t s = 0; s < 2; ++s) {
        const double force = 0.5 * (findings[s].toolForces[0] - findings[s].toolForces[1]).norm();
        values.push_back(force * (1 - shortening[s]) / (4e-4 * yield));
    }
    values.push_back(findings[1].vonMises({0.01, 0, 0}) / yield);
    return values;
}

void addBlocks(std::vector<Case>& cases)
{
    struct Row {
        const char* name;
        const char* words;
        Vec3 axis;
        double periods;
    };
    // Loads run along the z of the part; the lattice stays along x, y and z of the world.
    const Row rows[] = {{"100", "along the lattice", Vec3::UnitZ(), 30},
                        {"110", "at 45 degrees to the lattice", Vec3(0, 1, 1), 30},
                        {"111", "along a space diagonal of the lattice", Vec3(1, 1, 1), 30},
                        {"slow", "along the lattice, eight times slower", Vec3::UnitZ(), 240}};
    for (const Row& row : rows) {
        const Pose pose{Vec3::Zero(), turnOnto(Vec3::UnitZ(), row.axis)};
        cases.push_back(partCase(
            {.id = std::string("flow-") + row.name,
             .group = chapter,
             .title = std::string("Block pressed between plates without friction, ") + row.words,
             .source =
                 "Perfectly plastic: force over the present section is the typed yield stress; so is von Mises stress.",
             .quantities = {{"flow / typed, 2 %", "", 1, 0.07},
                            {"flow / typed, 20 %", "", 1, 0.07},
                            {"von Mises / typed", "", 1, 0.1}},
             .across = "the block",
             .run = {}},
            [=] { return blockBetweenPlates(pose, row.periods); }, 0.02, flowStress, false));
    }
}

/// A bar pulled by a tenth, with hardening.
void addPulledBar(std::vector<Case>& cases)
{
    constexpr double h = 0.02, length = 0.12, hardening = 2 * yield;
    const auto part = [=]() -> Part {
        const Vec3 by(0.05 * length, 0, 0);
        return {.block = bar({length, h, h}, 2),
                .material = plastic(modulus, 0.3, yield, hardening),
                .grips = {moved(beyond(0, -1, length / 2), -by), moved(beyond(0, 1, length / 2), by)},
                .slowest = pullingFrequency(length),
                .loadPeriods = 20};
    };
    cases.push_back(partCase(
        {.id = "flow-pulled",
         .group = chapter,
         .title = "Bar pulled by a tenth of its length, with hardening",
         .source = "True stress of the middle is yield + hardening times plastic strain, section by constant volume.",
         .quantities = {{"force / formula", "", 1, 0.07}},
         .across = "the bar",
         .run = {}},
        part, h, [=](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            const double stretch = 1 + slope(found, Box(Vec3(-0.02, -1, -1), Vec3(0.02, 1, 1)), 0, 0);
            const double stress =
                (yield + hardening * std::log(stretch)) / (1 + hardening / modulus); // elastic strain is stress / E
            const double force = 0.5 * std::abs((forceOn(found, 0) - forceOn(found, 1)).x());
            return std::vector<double>{force / (stress * h * h / stretch)};
        }));
}

/// Bars turned by their ends beyond yield, then one end is let go.
void addTurnedBars(std::vector<Case>& cases)
{
    constexpr double h = 0.02, length = 0.16, curvature = 4 * 2 * yield / (modulus * h); // four times that of yield
    constexpr double r = 0.01, twistLength = 0.08, shear = 0.04;
    const double shearModulus = modulus / 2.6, shearYield = yield / std::sqrt(3.0);
    const auto twoEnds = [](const Vec3& axis, double long_, double angle) {
        return std::vector<Grip>{turned(beyond(0, -1, long_ / 2), {-long_ / 2, 0, 0}, axis, -angle / 2),
                                 turned(beyond(0, 1, long_ / 2), {long_ / 2, 0, 0}, axis, angle / 2)};
    };
    const auto bent = [=]() -> Part {
        return {
            .block = bar({length, h, h}, 3),
            .material = plastic(modulus, 0.3, yield, 0),
            .grips = arcEnds(length, curvature * length),
            .stages = {{1},
                       {0.66, {1}}}, // nearly all the way back before: what is let go at once whips and yields again
            .slowest = bendingFrequency(length, h, 10),
            .loadPeriods = 5,
            .restPeriods = 5};
    };
    const auto twisted = [=]() -> Part {
        return {.block = roundBar(r, twistLength, 4),
                .material = plastic(modulus, 0.3, yield, 0),
                .grips = twoEnds(Vec3::UnitX(), twistLength, shear * twistLength / r),
                .stages = {{1}, {0.82, {1}}},
                .slowest = twistingFrequency(twistLength, 0.3) / 2,
                .loadPeriods = 5,
                .restPeriods = 5};
    };
    const auto gauge = [](const Finding& found, double at, int about) {
        return (sectionMotion(found, 0, at).rotation - sectionMotion(found, 0, -at).rotation)[about] / (2 * at);
    };
    const auto moment = [](const Finding& found, double long_, int about) {
        return 0.5 * std::abs((momentOn(found, 0, {-long_ / 2, 0, 0}) - momentOn(found, 1, {long_ / 2, 0, 0}))[about]);
    };
    cases.push_back(partCase(
        {.id = "bending-beyond-yield",
         .group = chapter,
         .title = "Square bar bent to four times its yield curvature and let go",
         .source =
             "M = s h^3 / 4 (1 - (k_y / k)^2 / 3) at the curvature k of the middle; it springs back by M / (E I).",
         .quantities = {{"moment / formula", "", 1, 0.06}, {"left / formula", "", 1, 0.06}},
         .across = "the bar",
         .run = {}},
        bent, h, [=](const std::vector<Finding>& findings) {
            const double k = gauge(findings[0], length / 4, 1);
            const double full = yield * h * h * h / 4 * (1 - std::pow(2 * yield / (modulus * h) / k, 2) / 3);
            const double left = k - full / (modulus * std::pow(h, 4) / 12);
            return std::vector<double>{moment(findings[0], length, 1) / full, gauge(findings[1], length / 4, 1) / left};
        }));
    cases.push_back(partCase(
        {.id = "torsion-beyond-yield",
         .group = chapter,
         .title = "Round bar twisted beyond yield and let go",
         .source =
             "M = 2 pi / 3 t r^3 (1 - (g_y / g)^3 / 4) at the surface shear g, t = s / sqrt 3; back by M / (G J).",
         .quantities = {{"moment / formula", "", 1, 0.1}, {"left / formula", "", 1, 0.1}},
         .cells = 6,
         .across = "the bar",
         .run = {}},
        twisted, 2 * r, [=](const std::vector<Finding>& findings) {
            const double g = gauge(findings[0], twistLength / 4, 0);
            const double full =
                2 * pi / 3 * shearYield * r * r * r * (1 - std::pow(shearYield / shearModulus / (g * r), 3) / 4);
            const double left = g - full / (shearModulus * pi * std::pow(r, 4) / 2);
            return std::vector<double>{moment(findings[0], twistLength, 0) / full,
                                       gauge(findings[1], twistLength / 4, 0) / left};
        }));
}

double rollerForce(const Finding& found, std::size_t line)
{
    return std::abs(found.toolForces.empty() ? forceOn(found, line).z() : found.toolForces.front().z());
}

/// Steel, 120 x 12 x 6 mm, held at an end, pressed down 100 mm away by a roller, which then goes.
void addSteelStrip(std::vector<Case>& cases)
{
    const auto part = [=]() -> Part {
        MappedBlock block = bar({0.12, 0.012, 0.006}, 4);
        block.cells = {48, 2, 4};
        block.place = [](double u, double v, double w) { return Vec3(0.12 * u, 0.012 * (v - 0.5), 0.006 * (w - 1)); };
        Part strip{.block = block,
                   .material = plastic(210e9, 0.3, 250e6, 700e6),
                   .grips = {held([](const Vec3& p) { return p.x(); })},
                   .stages = {{0.5}, {1}, {0.75, {1}, true}},
                   .slowest = bendingFrequency(0.12, 0.006, 3.516),
                   .loadPeriods = 2,
                   .restPeriods = 3,
                   .law = {.firstIncrement = 0.05, .largestIncrement = 0.1}};
        pressByRoller(strip, {0.1, 0, 0}, 0.004, 0.024, 0.00793);
        return strip;
    };
    cases.push_back(partCase(
        {.id = "steel-strip",
         .group = chapter,
         .title = "Steel strip bent 8 mm over a roller and let go",
         .source = "CalculiX (309 N, -5.65 mm): 210 GPa, yield 250 MPa, hardening 700 MPa, 100 mm from the clamp.",
         .quantities = {{"load", "N", 0, 0.06, Origin::calculix}, {"left", "mm", 0, 0.06, Origin::calculix}},
         .across = "the strip",
         .run = {},
         .quick = false,
         .finer = {1.25, 1.5}},
        part, 0.006, [](const std::vector<Finding>& findings) {
            const Vec3 left = meanDisplacement(findings[2], Box(Vec3(0.1, -0.006, -0.006), Vec3(0.1, 0.006, -0.006)));
            return std::vector<double>{rollerForce(findings[1], 1), 1000 * left.z()};
        }));
}

/// Supports below, a roller above; limit load.
void addThreePointBending(std::vector<Case>& cases)
{
    constexpr double h = 0.01, span = 0.1, down = 0.005;
    const auto part = [=]() -> Part {
        Part beam{.block = bar({1.2 * span, h, h}, 2),
                  .material = plastic(modulus, 0.3, yield, 0),
                  .grips = {},
                  .slowest = bendingFrequency(span, h, 9.87),
                  .loadPeriods = 6};
        pressByRoller(beam, {0, 0, h / 2}, 0.005, 2 * h, down);
        for (const double sign : {-1.0, 1.0}) {
            Tool support = beam.tools.front();
            support.manipulator.pose.position = Vec3(sign * span / 2, 0, -h / 2 - 0.005);
            support.way = Vec3::Zero();
            beam.tools.push_back(support);
            Grip line = held([=](const Vec3& p) { return std::max(std::abs(p.x() - sign * span / 2), p.z() + h / 2); });
            line.axes = Vec3::UnitZ();
            line.program = Grip::Program::calculix;
            beam.grips.push_back(line);
        }
        Grip center = held([=](const Vec3& p) { return std::max(std::abs(p.x()), std::abs(p.z() - h / 2)); });
        center.axes = Vec3(1, 1, 0);
        center.program = Grip::Program::calculix;
        beam.grips.push_back(center);
        return beam;
    };
    cases.push_back(partCase({.id = "three-point-bending",
                              .group = chapter,
                              .title = "Three-point bending to the plastic hinge",
                              .source = "Limit load F = s b h^2 / span (4 M_p / span).",
                              .quantities = {{"force", "mN", 1000 * yield * h * h * h / span, 0.12}},
                              .across = "the beam",
                              .run = {}},
                             part, h, [](const std::vector<Finding>& findings) {
                                 return std::vector<double>{1000 * rollerForce(findings.back(), 0)};
                             }));
}

} // namespace

void addPlasticCases(std::vector<Case>& cases)
{
    addBlocks(cases);
    addPulledBar(cases);
    addTurnedBars(cases);
    addSteelStrip(cases);
    addThreePointBending(cases);
}

} // namespace knead::book
