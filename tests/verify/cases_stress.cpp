// Stress where a person looks for it: at the skin.
#include "verify/cases.h"

#include <array>
#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr const char* chapter = "Stress at the skin";

/// Bars bent by their ends; stress at the middle of the top over what the moment makes of it.
void addBentBars(std::vector<Case>& cases)
{
    constexpr double h = 0.02, length = 0.16, angle = 0.02;
    const auto part = [=]() -> Part {
        return {.block = bar({length, h, h}, 4),
                .material = elastic(modulus, 0.3),
                .grips = {turned(beyond(0, -1, length / 2), {-length / 2, 0, 0}, Vec3::UnitY(), -angle / 2),
                          turned(beyond(0, 1, length / 2), {length / 2, 0, 0}, Vec3::UnitY(), angle / 2)},
                .slowest = bendingFrequency(length, h)};
    };
    const Measure measure = [=](const std::vector<Finding>& findings) {
        const Finding& found = findings.back();
        const double moment =
            0.5 * std::abs((momentOn(found, 0, {-length / 2, 0, 0}) - momentOn(found, 1, {length / 2, 0, 0})).y());
        return std::vector<double>{found.vonMises({0, 0, h / 2}) / (6 * moment / (h * h * h))};
    };
    for (const double cells : {2.0, 3.0, 4.0}) {
        const std::string number = std::to_string(static_cast<int>(cells));
        cases.push_back(partCase({.id = "bending-stress-" + number,
                                  .group = chapter,
                                  .title = "Stress at the top of a bent square bar, " + number + " cells",
                                  .source = "M h / (2 I), with the moment at the ends.",
                                  .quantities = {{"stress / formula", "", 1, cells == 2 ? 0.2 : 0.1}},
                                  .cells = cells,
                                  .across = "the bar",
                                  .run = {},
                                  .finer = cells == 4 ? std::vector<double>{1.5, 2} : std::vector<double>{}},
                                 part, h, measure));
    }
}

void addTwistedBar(std::vector<Case>& cases)
{
    constexpr double h = 0.02, length = 0.12;
    const auto part = [=]() -> Part {
        return {.block = bar({length, h, h}, 4),
                .material = elastic(modulus, 0.3),
                .grips = {turned(beyond(0, -1, length / 2), {0, 0, 0}, Vec3::UnitX(), -0.02),
                          turned(beyond(0, 1, length / 2), {0, 0, 0}, Vec3::UnitX(), 0.02)},
                .slowest = twistingFrequency(length, 0.3)};
    };
    cases.push_back(partCase(
        {.id = "torsion-stress",
         .group = chapter,
         .title = "Stress at the middle of a side of a twisted square bar",
         .source = "sqrt(3) M / (0.208 h^3) (Timoshenko and Goodier).",
         .quantities = {{"stress / formula", "", 1, 0.1, Origin::closedForm, Expected::notYet}},
         .cells = 6,
         .across = "the bar",
         .run = {}},
        part, h, [=](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            const double moment =
                0.5 * std::abs((momentOn(found, 0, Vec3::Zero()) - momentOn(found, 1, Vec3::Zero())).x());
            return std::vector<double>{found.vonMises({0, 0, h / 2}) / (std::sqrt(3) * moment / (0.208 * h * h * h))};
        }));
}

/// A strip with a hole, pulled at its ends.
void addHole(std::vector<Case>& cases)
{
    constexpr double width = 0.04, length = 0.08, radius = 0.005, thickness = 0.005;
    const auto part = [=]() -> Part {
        const Vec3 by(0.5e-3 * length, 0, 0);
        return {.block = plateWithHole(length, width, radius, thickness, 48),
                .material = elastic(modulus, 0.3),
                .grips = {moved(beyond(0, -1, length / 2), -by), moved(beyond(0, 1, length / 2), by)},
                .slowest = pullingFrequency(length)};
    };
    const double share = 2 * radius / width;
    cases.push_back(partCase(
        {.id = "plate-with-hole",
         .group = "Published measurements",
         .title = "Strip with a hole, pulled",
         .source =
             "Stress at the hole over force by gross section: (2 + (1 - d/w)^3) / (1 - d/w) of Heywood, which fits "
             "Howland's solution and what is measured photoelastically (Peterson, Stress Concentration Factors): the "
             "mean over "
             "the thickness, in the middle of which stress is higher.",
         .quantities = {{"stress factor", "", (2 + std::pow(1 - share, 3)) / (1 - share), 0.1, Origin::measured}},
         .cells = 8,
         .across = "the hole",
         .run = {},
         .finer = {1.25, 1.5}},
        part, 2 * radius, [=](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            const double pull = 0.5 * std::abs((forceOn(found, 0) - forceOn(found, 1)).x());
            constexpr std::array<double, 5> simpson{1.0 / 12, 4.0 / 12, 2.0 / 12, 4.0 / 12, 1.0 / 12};
            double mean = 0;
            for (std::size_t i = 0; i < simpson.size(); ++i)
                mean += simpson[i] * found.vonMises({0, radius, (0.25 * static_cast<double>(i) - 0.5) * thickness});
            return std::vector<double>{mean / (pull / (width * thickness))};
        }));
}

/// A thick quarter of a ring bent by its ends.
void addCurvedBar(std::vector<Case>& cases)
{
    constexpr double inner = 0.01, outer = 0.02, thickness = 0.01, half = 1.2, middle = 0.015;
    const auto end = [=](double sign) {
        const Vec3 radial(std::cos(half), sign * std::sin(half), 0);
        const Vec3 tangent(-sign * std::sin(half), std::cos(half), 0);
        return turned([=](const Vec3& p) { return p.dot(radial) < 0 ? 1 : -sign * p.dot(tangent); }, middle * radial,
                      Vec3::UnitZ(), 0.01 * sign);
    };
    const auto part = [=]() -> Part {
        MappedBlock block = ringSector(inner, outer, thickness, -half, half, 6);
        block.cells = {24, 12, 2}; // CalculiX extrapolates stress to its nodes
        return {.block = block,
                .material = elastic(modulus, 0),
                .grips = {end(-1), end(1)},
                .slowest = bendingFrequency(2 * half * middle, outer - inner)};
    };
    const double depth = outer - inner, area = depth * thickness;
    cases.push_back(partCase(
        {.id = "curved-bar",
         .group = chapter,
         .title = "Stress inside a thick curved bar, bent",
         .source =
             "Golovin's exact solution (Timoshenko and Goodier, curved bars) for R / r = 2: 1.2515 N / A + 7.755 M / "
             "(A h), with force and moment of the middle section from the ends; Poisson's ratio 0.",
         .quantities = {{"stress / formula", "", 1, 0.1, Origin::closedForm, Expected::notYet}},
         .cells = 6,
         .across = "the bar",
         .run = {}},
        part, depth, [=](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            // The grips at the high end pull the middle section; about its center of gravity.
            const Vec3 center(middle, 0, 0);
            const double force = -forceOn(found, 1).y();
            const double moment = -momentOn(found, 1, center).z(); // positive closes the ring
            const double stress = 1.2515 * force / area - 7.755 * moment / (area * depth);
            return std::vector<double>{found.vonMises({inner, 0, 0}) / std::abs(stress)};
        }));
}

/// A thick tube widened at its bore, by Lame's displacements of an inner pressure with free ends.
void addThickTube(std::vector<Case>& cases)
{
    constexpr double inner = 0.01, outer = 0.02, length = 0.02, nu = 0.3, pressure = 1e-3 * modulus;
    const double a = pressure * inner * inner / (outer * outer - inner * inner); // hoop and radial: a (1 +- ro^2 / r^2)
    const auto radial = [=](double r) { return a / modulus * ((1 - nu) * r + (1 + nu) * outer * outer / r); };
    const auto part = [=]() -> Part {
        return {.block = pipe(inner, outer, length, 4),
                .material = elastic(modulus, nu),
                .grips = {{[=](const Vec3& p) { return std::hypot(p.y(), p.z()) - inner; },
                           [=](const Vec3& p, double share) {
                               const double r = std::hypot(p.y(), p.z());
                               const Vec3 out = Vec3(0, p.y(), p.z()) / r;
                               return Vec3(share * (radial(r) * out - Vec3(2 * nu * a / modulus * p.x(), 0, 0)));
                           }}},
                .slowest = pullingFrequency(2 * (outer - inner)),
                .loadPeriods = 6};
    };
    cases.push_back(
        partCase({.id = "thick-tube",
                  .group = chapter,
                  .title = "Thick tube under inner pressure",
                  .source = "Lame, open ends: hoop stress 2 p r^2 / (R^2 - r^2) outside, and its displacement.",
                  .quantities = {{"widening outside", "um", 1e6 * radial(outer), 0.04},
                                 {"stress outside", "kPa", 1e-3 * 2 * a, 0.1}},
                  .cells = 6,
                  .across = "the wall",
                  .run = {},
                  .quick = false,
                  .finer = {1.5}},
                 part, outer - inner, [=](const std::vector<Finding>& findings) {
                     const Finding& found = findings.back();
                     double sum = 0, count = 0;
                     for (std::size_t i = 0; i < found.rest.size(); ++i) {
                         const Vec3 p(0, found.rest[i].y(), found.rest[i].z());
                         if (std::abs(p.norm() - outer) <= std::max(0.5 * found.spacing, 1e-9) &&
                             std::abs(found.rest[i].x()) < length / 4) {
                             // To the radius outside by Lame's slope, which is small.
                             sum += p.dot(found.displacement[i]) / p.norm() - radial(p.norm()) + radial(outer);
                             count += 1;
                         }
                     }
                     return std::vector<double>{1e6 * sum / count, 1e-3 * found.vonMises({0, 0, outer})};
                 }));
}

} // namespace

void addStressCases(std::vector<Case>& cases)
{
    addBentBars(cases);
    addTwistedBar(cases);
    addCurvedBar(cases);
    addThickTube(cases);
    addHole(cases);
}

} // namespace knead::book
