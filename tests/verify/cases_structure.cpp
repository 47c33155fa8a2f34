// Springs, rings and hooks.
#include "verify/cases.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr const char* chapter = "Springs, rings and hooks";

/// Force of a roller that goes down: on the tool of Knead, on the line of CalculiX.
double rollerForce(const Finding& found, std::size_t line)
{
    return std::abs(found.toolForces.empty() ? forceOn(found, line).z() : found.toolForces.front().z());
}

/// A ring with a gap, pulled open at its ends.
void addOpenRing(std::vector<Case>& cases)
{
    constexpr double inner = 0.016, outer = 0.020, thickness = 0.006, gap = 0.4, middle = 0.018, opening = 0.002;
    const auto end = [=](double sign) {
        const double angle = pi - sign * (pi - gap); // at gap and 2 pi - gap
        const Vec3 radial(std::cos(angle), std::sin(angle), 0);
        const Vec3 tangent(-std::sin(angle), std::cos(angle), 0); // towards the gap from the far end
        return moved(
            [=](const Vec3& p) {
                const double front = sign * p.dot(tangent); // but not across the gap
                return p.dot(radial) < 0 || front < -0.5 * gap * inner ? 1 : front;
            },
            {0, sign * opening / 2, 0});
    };
    const auto part = [=]() -> Part {
        return {.block = ringSector(inner, outer, thickness, gap, 2 * pi - gap, 2),
                .material = elastic(modulus, 0.3),
                .grips = {end(1), end(-1)},
                .slowest = bendingFrequency(2 * (pi - gap) * middle, outer - inner),
                .loadPeriods = 2,
                .restPeriods = 3};
    };
    cases.push_back(partCase({.id = "c-spring",
                              .group = chapter,
                              .title = "C-spring pulled open by its ends, which do not turn",
                              .source = "CalculiX.",
                              .quantities = {{"force", "mN", 0, 0.1, Origin::calculix}},
                              .across = "the spring",
                              .run = {}},
                             part, outer - inner, [](const std::vector<Finding>& findings) {
                                 return std::vector<double>{
                                     500 * std::abs((forceOn(findings.back(), 0) - forceOn(findings.back(), 1)).y())};
                             }));
}

/// Plates above and below a ring or pipe along x, and lines of CalculiX in their place.
void pressBetweenPlates(Part& part, double radius, double length, double down)
{
    for (const double sign : {1.0, -1.0}) {
        Manipulator plate{.name = "plate", .size = {2 * length, 3 * radius, radius / 2}};
        plate.kind = ToolKind::plate;
        plate.friction = 0;
        plate.pose.position = Vec3(0, 0, sign * 1.25 * radius);
        part.tools.push_back({plate, Vec3(0, 0, -sign * down / 2)});
        Grip line{[=](const Vec3& p) { return std::max(std::abs(p.y()), radius - sign * p.z()); },
                  [=](const Vec3&, double share) { return Vec3(0, 0, -sign * share * down / 2); }};
        line.axes = Vec3(0, 1, 1);
        line.program = Grip::Program::calculix;
        part.grips.push_back(line);
    }
    Grip middle{[=](const Vec3& p) {
                    return std::max({std::abs(p.x()), std::abs(p.y()), radius - p.z()});
                },
                [](const Vec3&, double) { return Vec3(Vec3::Zero()); }};
    middle.axes = Vec3::UnitX();
    middle.program = Grip::Program::calculix;
    part.grips.push_back(middle);
}

void addPressedRing(std::vector<Case>& cases)
{
    constexpr double outer = 0.021, inner = 0.019, length = 0.008, down = 0.001, middle = 0.02;
    const auto part = [=]() -> Part {
        Part ring{.block = pipe(inner, outer, length, 2),
                  .material = elastic(modulus, 0.3),
                  .grips = {},
                  .slowest = 2.68 * (outer - inner) / (std::sqrt(12.0) * middle * middle)}; // oval mode of a ring
        pressBetweenPlates(ring, outer, length, down);
        return ring;
    };
    const double stiffness = modulus * length * std::pow(outer - inner, 3) / 12 / (0.1488 * std::pow(middle, 3));
    cases.push_back(
        partCase({.id = "ring-pressed",
                  .group = chapter,
                  .title = "Thin ring pressed between plates",
                  .source = "0.1488 F R^3 / (E I) for point loads (Timoshenko, Strength of Materials). The plates "
                            "touch without friction.",
                  .quantities = {{"force", "mN", 1000 * stiffness * down, 0.15}},
                  .cells = 3,
                  .across = "the wall",
                  .run = {},
                  .quick = false},
                 part, outer - inner, [](const std::vector<Finding>& findings) {
                     return std::vector<double>{1000 * rollerForce(findings.back(), 0)};
                 }));
}

/// A hook whose thickness falls to half towards its end, pressed aside there.
void addSnapHook(std::vector<Case>& cases)
{
    constexpr double length = 0.019, width = 0.0095, root = 0.00328, aside = 0.0024, clamp = 0.003, beyondTip = 0.001;
    const auto part = [=]() -> Part {
        MappedBlock block = bar({length + clamp + beyondTip, width, root}, 2);
        block.cells = {23, 4, 2}; // of 1 mm: nodes of CalculiX lie where the hook is pressed
        block.place = [=](double u, double v, double w) {
            const double x = -clamp + u * (length + clamp + beyondTip);
            const double thick = root * (1 - 0.5 * std::clamp(x / length, 0.0, 1.0));
            return Vec3(x, (v - 0.5) * width, -w * thick); // its upper side is flat
        };
        Part hook{.block = block,
                  .material = elastic(1.815e9, 0.38),
                  .grips = {held([](const Vec3& p) { return p.x(); })},
                  .slowest = bendingFrequency(length, root, 3.516),
                  .loadPeriods = 2};
        pressByRoller(hook, {length, 0, 0}, 0.002, 2 * width, aside);
        return hook;
    };
    cases.push_back(partCase(
        {.id = "snap-fit",
         .group = "Published measurements",
         .title = "Snap-fit hook of polycarbonate pressed aside by its undercut",
         .source = "Design guide Snap-Fit Joints for Plastics (Bayer), first example: 19 mm long, 9.5 mm wide, 3.28 mm "
                   "thick at "
                   "the root and half of that at the end, secant modulus 1815 MPa, 2.4 mm aside: 2 % strain, "
                   "P = b h^2 E strain / (6 l) = 32.5 N.",
         .quantities = {{"force", "N", 32.5, 0.15, Origin::measured}},
         .across = "the root",
         .run = {}},
        part, root,
        [](const std::vector<Finding>& findings) { return std::vector<double>{rollerForce(findings.back(), 1)}; }));
}

/// A flat round punch on a block.
void addRoundPunch(std::vector<Case>& cases)
{
    constexpr double size = 0.06, depth = 0.04, radius = 0.008, down = 2e-4;
    const auto part = [=]() -> Part {
        Part block{.block = bar({size, size, depth}, 20),
                   .material = elastic(modulus, 0.3),
                   .grips = {held(beyond(2, -1, depth / 2))},
                   .slowest = pullingFrequency(2 * depth)};
        Manipulator punch{.name = "punch", .size = {2 * radius, 2 * radius, 0.02}};
        punch.kind = ToolKind::cylinder;
        punch.friction = 0;
        punch.pose.position = Vec3(0, 0, depth / 2 + 0.01);
        block.tools.push_back({punch, Vec3(0, 0, -down)});
        return block;
    };
    cases.push_back(partCase(
        {.id = "round-punch",
         .group = chapter,
         .title = "Flat round punch on an elastic block",
         .source = "Boussinesq: F = 2 a E / (1 - nu^2) depth, for a half-space; the block is 7.5 punch radii wide and "
                   "5 deep, "
                   "which makes it up to 10 % stiffer.",
         .quantities = {{"force", "mN", 1000 * 2 * radius * modulus / (1 - 0.09) * down, 0.15}},
         .cells = 6,
         .across = "the punch",
         .run = {},
         .quick = false,
         .finer = {4.0 / 3, 5.0 / 3}},
        part, 2 * radius,
        [](const std::vector<Finding>& findings) {
            return std::vector<double>{1000 * rollerForce(findings.back(), 0)};
        },
        false));
}

} // namespace

void addStructureCases(std::vector<Case>& cases)
{
    addOpenRing(cases);
    addPressedRing(cases);
    addSnapHook(cases);
    addRoundPunch(cases);
}

} // namespace knead::book
