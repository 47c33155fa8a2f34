// Forming: upsetting, indentation, punches, crushed tubes.
#include "verify/cases.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr const char* chapter = "Forming";

/// A round billet along x between two plates, pressed to shares of its height.
Part billet(double radius, double height, const Material& material, double friction, std::vector<double> shares)
{
    Part part{.block = roundBar(radius, height, 6),
              .material = material,
              .grips = {},
              .stages = {},
              .slowest = pullingFrequency(2 * height),
              .loadPeriods = 40};
    for (const double share : shares)
        part.stages.push_back({share});
    const double last = shares.back();
    for (std::size_t s = 0; s + 1 <= shares.size(); ++s)
        part.stages[s].share = shares[s] / last;
    for (const double sign : {1.0, -1.0}) {
        Manipulator plate{.name = "plate", .size = {height, 8 * radius, 8 * radius}};
        plate.friction = friction;
        plate.pose.position = Vec3(sign * height, 0, 0);
        const Vec3 way(-sign * last * height / 2, 0, 0);
        part.tools.push_back({plate, way});
        Grip face = moved(beyond(0, sign, height / 2), way);
        face.program = Grip::Program::calculix;
        face.axes = friction > 0 ? Vec3(Vec3::Ones()) : Vec3(Vec3::UnitX());
        part.grips.push_back(face);
    }
    return part;
}

double plateForce(const Finding& found)
{
    return 0.5 * (found.toolForces.empty() ? (forceOn(found, 0) - forceOn(found, 1)).norm()
                                           : (found.toolForces[0] - found.toolForces[1]).norm());
}

/// Largest radius of points near the middle of the height, from the points furthest out.
double bulge(const Finding& found, double radius, double height)
{
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < found.rest.size(); ++i) {
        const Vec3& p = found.rest[i];
        const double r = std::hypot(p.y(), p.z());
        if (std::abs(p.x()) > height / 12 + 0.5 * found.spacing || r < radius - 1.01 * found.spacing - 1e-4 * radius)
            continue;
        // How much a ring of the material widens, carried to the skin.
        const Vec3 now = p + found.displacement[i];
        sum += std::hypot(now.y(), now.z()) / r * radius;
        count += 1;
    }
    return sum / count;
}

void addBillets(std::vector<Case>& cases)
{
    const Material metal = plastic(2e6, 0.3, 7e3, 3e3); // as 200 GPa, 700 MPa and 300 MPa, in smaller units
    cases.push_back(partCase(
        {.id = "upset-smooth",
         .group = chapter,
         .title = "Billet pressed by 30 % between smooth plates",
         .source = "Force is (yield + hardening ln(h/H)) times the section of constant volume.",
         .quantities = {{"force", "N", (7e3 - 3e3 * std::log(0.7)) * pi * 1e-4 / 0.7, 0.07}},
         .cells = 6,
         .across = "the billet",
         .run = {}},
        [=] { return billet(0.01, 0.02, metal, 0, {0.3}); }, 0.02,
        [](const std::vector<Finding>& findings) { return std::vector<double>{plateForce(findings[0])}; }, false));
    cases.push_back(partCase(
        {.id = "upset-sticking",
         .group = chapter,
         .title = "Billet pressed by 40 % between sticking plates: barrelling",
         .source =
             "CalculiX. Billet of radius 10 and height 30 mm, 200 GPa, 700 MPa and hardening 300 MPa (the billet of "
             "Lippmann's and Taylor's comparison), stresses in proportion.",
         .quantities = {{"force, 20 %", "N", 0, 0.08, Origin::calculix},
                        {"force, 40 %", "N", 0, 0.08, Origin::calculix},
                        {"widest radius, 40 %", "mm", 0, 0.03, Origin::calculix}},
         .cells = 6,
         .across = "the billet",
         .run = {},
         .finer = {1.3334, 1.6667}},
        [=] {
            Part part = billet(0.01, 0.03, metal, 2, {0.2, 0.4});
            part.law = {.firstIncrement = 0.02, .largestIncrement = 0.05};
            return part;
        },
        0.02,
        [](const std::vector<Finding>& findings) {
            return std::vector<double>{plateForce(findings[0]), plateForce(findings[1]),
                                       1000 * bulge(findings[1], 0.01, 0.03)};
        }));
}

/// Radius of the print that a ball at `center` leaves in the face z = top, whose rim has piled up [m]: where the gap between both,
/// as a line over the distance from the middle, begins.
double printRadius(const Finding& found, double top, const Vec3& center, double radius)
{
    double n = 0, g = 0, r = 0, gg = 0, gr = 0;
    for (std::size_t i = 0; i < found.rest.size(); ++i) {
        if (found.rest[i].z() < top - 0.01 * found.spacing)
            continue;
        const Vec3 place = found.rest[i] + found.displacement[i] - center;
        const double gap = place.norm() - radius;
        if (gap < 0.05 * found.spacing || gap > 0.6 * found.spacing)
            continue;
        const double out = place.head<2>().norm();
        n += 1;
        g += gap;
        r += out;
        gg += gap * gap;
        gr += gap * out;
    }
    const double slope = (n * gr - g * r) / (n * gg - g * g);
    return (r - slope * g) / n;
}

/// A ball pressed into a block until the print is 0.4 of it, by how deep it is.
void addIndentation(std::vector<Case>& cases)
{
    struct Row {
        const char* id;
        const char* group;
        const char* title;
        const char* source;
        Material material;
        double ratio;
        double tolerance;
        Origin origin;
    };
    const Row rows[] = {
        {"ball-in-clay", chapter, "Ball pressed into clay",
         "Mean pressure 2.8 times yield (Tabor; 2.5 to 3.2): fully plastic, no hardening.", plastic(2e6, 0.45, 4e3, 0),
         2.85, 0.12, Origin::closedForm},
        {"brinell-steel", "Published measurements", "Brinell ball in work-hardened mild steel",
         "Measured by Tabor (The Hardness of Metals, 1951): mean pressure over yield of heavily worked mild steel, "
         "copper, "
         "aluminum and lead 2.8 to 2.9. Steel of 650 MPa; stresses in proportion.",
         plastic(1.3e6, 0.3, 4e3, 0), 2.85, 0.1, Origin::measured},
    };
    constexpr double radius = 0.02, print = 0.4 * radius, width = 0.048, depth = 0.024;
    const double down = radius - std::sqrt(radius * radius - print * print);
    for (const Row& row : rows) {
        const auto part = [=, material = row.material]() -> Part {
            Part block{.block = bar({width, width, depth}, 8),
                       .material = material,
                       .grips = {held(beyond(2, -1, depth / 2))},
                       .slowest = pullingFrequency(2 * depth),
                       .loadPeriods = 20};
            Manipulator ball{.name = "ball", .size = Vec3::Constant(2 * radius)};
            ball.kind = ToolKind::ball;
            ball.friction = 0;
            ball.pose.position = Vec3(0, 0, depth / 2 + radius);
            block.tools.push_back({ball, Vec3(0, 0, -down)});
            return block;
        };
        const double yield = row.material.yieldStress;
        cases.push_back(partCase(
            {.id = row.id,
             .group = row.group,
             .title = row.title,
             .source = row.source,
             .quantities = {{"mean pressure / yield", "", row.ratio, row.tolerance, row.origin}},
             .cells = 8,
             .across = "the print",
             .run = {},
             .quick = false,
             .finer = {1.25, 1.5}},
            part, 2 * print,
            [=](const std::vector<Finding>& findings) {
                const Vec3 center(0, 0, depth / 2 + radius - down);
                const double reached = printRadius(findings[0], depth / 2, center, radius);
                return std::vector<double>{findings[0].toolForces[0].norm() / (pi * reached * reached) / yield};
            },
            false));
    }
}

/// A long flat punch on a slab between smooth walls: plane strain.
void addPlanePunch(std::vector<Case>& cases)
{
    constexpr double b = 0.012, width = 7 * b, depth = 3 * b, thick = b, yield = 4e3, down = 0.06 * b;
    const auto part = [=]() -> Part {
        MappedBlock block = bar({width, thick, depth}, 12);
        block.cells = {42, 1, 18};
        Part slab{.block = block,
                  .material = plastic(2e6, 0.45, yield, 0),
                  .grips = {held(beyond(2, -1, depth / 2))},
                  .slowest = pullingFrequency(2 * depth),
                  .loadPeriods = 8,
                  .law = {.firstIncrement = 0.02, .largestIncrement = 0.1}};
        Manipulator punch{.name = "punch", .size = {b, 3 * thick, b}};
        punch.friction = 0;
        punch.pose.position = Vec3(0, 0, depth / 2 + b / 2);
        slab.tools.push_back({punch, Vec3(0, 0, -down)});
        for (const double sign : {1.0, -1.0}) {
            Manipulator wall{.name = "wall", .size = {2 * width, b, 2 * depth}};
            wall.friction = 0;
            wall.pose.position = Vec3(0, sign * (thick + b) / 2, 0);
            slab.tools.push_back({wall, Vec3::Zero()});
            Grip side = held(beyond(1, sign, thick / 2));
            side.axes = Vec3::UnitY();
            side.program = Grip::Program::calculix;
            slab.grips.push_back(side);
        }
        Grip print =
            moved([=](const Vec3& p) { return std::max(std::abs(p.x()) - b / 2, depth / 2 - p.z()); }, {0, 0, -down});
        print.axes = Vec3::UnitZ();
        print.program = Grip::Program::calculix;
        slab.grips.push_back(print);
        return slab;
    };
    cases.push_back(partCase(
        {.id = "plane-punch",
         .group = chapter,
         .title = "Long flat punch, plane strain",
         .source = "Prandtl: (2 + pi) k = 2.97 yield, k = yield / sqrt 3.",
         .quantities = {{"pressure / yield", "", (2 + pi) / std::sqrt(3.0), 0.1, Origin::closedForm, Expected::notYet}},
         .across = "the punch",
         .run = {}},
        part, b, [=](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            const double force =
                found.toolForces.empty() ? forceOn(found, 3).norm() : std::abs(found.toolForces[0].z());
            return std::vector<double>{force / (b * thick) / yield};
        }));
}

/// A tube squeezed between plates.
void addTube(std::vector<Case>& cases)
{
    constexpr double outer = 0.0205, inner = 0.0180, length = 0.02, yield = 4e3, diameter = outer + inner;
    constexpr double down = 0.2 * diameter, wall = outer - inner;
    const auto part = [=]() -> Part {
        Part tube{.block = pipe(inner, outer, length, 2),
                  .material = plastic(2e6, 0.3, yield, 0),
                  .grips = {},
                  .slowest = 2.68 * wall / (std::sqrt(12.0) * diameter * diameter / 4),
                  .loadPeriods = 5};
        for (const double sign : {1.0, -1.0}) {
            Manipulator plate{.name = "plate", .size = {2 * length, 4 * outer, outer / 2}};
            plate.friction = 0.3;
            plate.pose.position = Vec3(0, 0, sign * 1.25 * outer);
            tube.tools.push_back({plate, Vec3(0, 0, -sign * down / 2)});
        }
        return tube;
    };
    const double moment = 2 / std::sqrt(3.0) * yield * wall * wall / 4; // of a hinge, per length
    cases.push_back(partCase(
        {.id = "tube-crushed",
         .group = "Published measurements",
         .title = "Tube crushed by a fifth of its diameter between plates",
         .source = "DeRuntz and Hodge, Journal of Applied Mechanics 30 (1963) 391, with tests on mild steel: 8 M_p "
                   "length / D / "
                   "sqrt(1 - (d/D)^2), M_p = 2/sqrt 3 yield t^2 / 4. Tests lie up to 20 % above, by hardening.",
         .quantities = {{"force", "mN", 1000 * 8 * moment * length / diameter / std::sqrt(1 - 0.04), 0.15,
                         Origin::measured}},
         .cells = 3,
         .across = "the wall",
         .run = {},
         .quick = false,
         .finer = {4.0 / 3}},
        part, wall,
        [](const std::vector<Finding>& findings) { return std::vector<double>{1000 * plateForce(findings.back())}; },
        false));
}

} // namespace

void addFormingCases(std::vector<Case>& cases)
{
    addBillets(cases);
    addPlanePunch(cases);
    addIndentation(cases);
    addTube(cases);
}

} // namespace knead::book
