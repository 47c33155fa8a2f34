// Large deflections of slender bars.
#include "verify/cases.h"

#include <array>
#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr const char* chapter = "Bending by much";

/// Deflection of the end of a heavy bar that sticks out, over its length: EI theta'' = -q (L - s) cos theta, by shooting.
/// @param weight q L^3 / EI
double heavyElastica(double weight)
{
    // theta(0) = 0, theta'(1) = 0; Runge-Kutta from s = 0 with the slope that is looked for.
    const auto shoot = [&](double slope, double& deflection) {
        constexpr int steps = 400;
        constexpr double h = 1.0 / steps;
        std::array<double, 3> y{0, slope, 0}; // theta, theta', deflection
        const auto rate = [&](double s, const std::array<double, 3>& v) {
            return std::array<double, 3>{v[1], -weight * (1 - s) * std::cos(v[0]), std::sin(v[0])};
        };
        const auto plus = [](std::array<double, 3> a, const std::array<double, 3>& b, double f) {
            for (std::size_t i = 0; i < 3; ++i)
                a[i] += f * b[i];
            return a;
        };
        for (int i = 0; i < steps; ++i) {
            const double s = i * h;
            const auto k1 = rate(s, y);
            const auto k2 = rate(s + h / 2, plus(y, k1, h / 2));
            const auto k3 = rate(s + h / 2, plus(y, k2, h / 2));
            const auto k4 = rate(s + h, plus(y, k3, h));
            y = plus(plus(plus(plus(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
        }
        deflection = y[2];
        return y[1];
    };
    double low = 0, high = weight; // theta'(1) rises with theta'(0)
    double deflection = 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (shoot(middle, deflection) > 0 ? high : low) = middle;
    }
    return deflection;
}

/// A bar along x from 0, held there, under its own weight.
/// @param weight q L^3 / EI
Part heavyBar(double slenderness, double weight, double nu)
{
    const double h = 0.02, length = slenderness * h, clamp = 0.02;
    const double gravity = weight * modulus * h * h / 12 / (1000 * std::pow(length, 3)); // q = rho g A
    MappedBlock block = bar({length + clamp, h, h}, 2);
    block.place = [place = block.place, length, clamp](double u, double v, double w) {
        return Vec3(place(u, v, w) + Vec3((length - clamp) / 2, 0, 0));
    };
    return {.block = block,
            .material = elastic(modulus, nu),
            .grips = {held([](const Vec3& p) { return p.x(); })},
            .gravity = Vec3(0, 0, -gravity),
            .slowest = bendingFrequency(length, h, 3.516),
            .loadPeriods = 1,
            .restPeriods = 4};
}

/// Mean deflection of the last section over the length. Objects that are held reach half a spacing further.
Measure endDeflection(double length, double scale)
{
    return [=](const std::vector<Finding>& findings) {
        return std::vector<double>{-scale * sectionMotion(findings.back(), 0, length).displacement.z() / length};
    };
}

void addHeavyBars(std::vector<Case>& cases)
{
    const double nu = 0.3;
    const auto shear = [=](double slenderness) { // share of the deflection, k = 5/6
        return 1 + 4.0 / 12 * 2 * (1 + nu) * 6 / 5 / (slenderness * slenderness);
    };
    cases.push_back(partCase(
        {.id = "cantilever-weight",
         .group = chapter,
         .title = "Cantilever under its weight, small deflection",
         .source = "q L^4 / (8 E I) and shear q L^2 / (2 k G A), k = 5/6.",
         .quantities = {{"deflection / L", "%", 100 * 0.02 / 8 * shear(8), 0.1}},
         .across = "the bar",
         .run = {}},
        [=] { return heavyBar(8, 0.02, nu); }, 0.02, endDeflection(0.16, 100)));
    cases.push_back(partCase(
        {.id = "elastica-heavy",
         .group = chapter,
         .title = "Cantilever under its weight, large deflection",
         .source = "Heavy elastica, q L^3 / (E I) = 10, its equation solved by shooting; shear as for small ones.",
         .quantities = {{"deflection / L", "", heavyElastica(10) * shear(12), 0.06}},
         .across = "the bar",
         .run = {}},
        [=] { return heavyBar(12, 10, nu); }, 0.02, endDeflection(0.24, 1)));
    cases.push_back(partCase(
        {.id = "elastica-steel-ruler",
         .group = "Published measurements",
         .title = "Steel ruler of 400 mm that sticks out",
         .source =
             "Measured by Belendez, Neipp and Belendez, European Journal of Physics 23 (2002) 371: the end of a ruler "
             "of 0.4 x 25 x 400 mm and 0.3032 N, E = 200 GPa, hangs 89 mm low. Knead bends a thicker bar with the same "
             "q L^3 / (E I) = 1.82.",
         .quantities = {{"deflection", "mm", 89, 0.1, Origin::measured}},
         .across = "the bar",
         .run = {}},
        [=] { return heavyBar(12, 0.3032 * 0.4 * 0.4 / (200e9 * 0.025 * std::pow(0.0004, 3) / 12), nu); }, 0.02,
        endDeflection(0.24, 400)));
}

/// Bent to an arc of a circle by its ends.
void addArc(std::vector<Case>& cases)
{
    constexpr double h = 0.01, length = 16 * h, angle = pi / 2;
    const auto part = [=]() -> Part {
        return {.block = bar({length, h, h}, 2),
                .material = elastic(modulus, 0.25),
                .grips = arcEnds(length, angle),
                .stages = {{0.25}, {0.5}, {0.75}, {1}},
                .slowest = bendingFrequency(length, h),
                .loadPeriods = 2};
    };
    const Measure measure = [=](const std::vector<Finding>& findings) {
        const Finding& found = findings.back();
        Vec3 middle = Vec3::Zero();
        for (const PointForce& force : found.reactions[1])
            middle += force.now / static_cast<double>(found.reactions[1].size());
        return std::vector<double>{1000 * momentOn(found, 1, middle).norm()};
    };
    cases.push_back(
        partCase({.id = "quarter-circle",
                  .group = chapter,
                  .title = "Bar bent into a quarter of a circle",
                  .source = "M = E I angle / L.",
                  .quantities = {{"moment", "N mm", 1000 * modulus * std::pow(h, 4) / 12 * angle / length, 0.1}},
                  .across = "the bar",
                  .run = {}},
                 part, h, measure));
}

/// A strut between two grips, with a bow of a hundredth of its height.
void addStrut(std::vector<Case>& cases)
{
    static constexpr double h = 0.01;
    constexpr double length = 20 * h, shortening = 0.1;
    const double stiffness = modulus * std::pow(h, 4) / 12;
    // Clamped elastica: P = EI (4 K / L)^2, shortening 2 (1 - E / K) and P / (E A).
    double low = 0, high = 0.9;
    double force = 0;
    for (int i = 0; i < 60; ++i) {
        const double k = (low + high) / 2;
        force = stiffness * std::pow(4 * std::comp_ellint_1(k) / length, 2);
        const double reached = 2 * (1 - std::comp_ellint_2(k) / std::comp_ellint_1(k)) + force / (modulus * h * h);
        (reached > shortening ? high : low) = k;
    }
    const auto part = [=]() -> Part {
        MappedBlock block = bar({length, h, h}, 2);
        block.place = [place = block.place](double u, double v, double w) {
            return Vec3(place(u, v, w) + Vec3(0, 0, 0.01 * h * std::pow(std::sin(pi * u), 2)));
        };
        const Vec3 by(shortening * length / 2, 0, 0);
        return {.block = block,
                .material = elastic(modulus, 0.3),
                .grips = {moved(beyond(0, -1, length / 2), by), moved(beyond(0, 1, length / 2), -by)},
                .stages = {{0.25}, {1}},
                .slowest = bendingFrequency(length, h),
                .loadPeriods = 6,
                .restPeriods = 30,
                .law = {.firstIncrement = 0.01, .largestIncrement = 0.05}};
    };
    force /= 1 + 1.2 * force / (modulus / 2.6 * h * h); // Engesser: shear
    cases.push_back(
        partCase({.id = "strut",
                  .group = chapter,
                  .title = "Strut pressed beyond buckling by a tenth of its length",
                  .source = "Euler's strut with held ends (4 pi^2 E I / L^2) as clamped elastica, with elliptic "
                            "integrals; with compression P / (E A) and shear.",
                  .quantities = {{"force", "N", force, 0.1}},
                  .across = "the strut",
                  .run = {},
                  .quick = false},
                 part, h, [](const std::vector<Finding>& findings) {
                     return std::vector<double>{std::abs(forceOn(findings.back(), 1).x())};
                 }));
}

} // namespace

void addBendingCases(std::vector<Case>& cases)
{
    addHeavyBars(cases);
    addArc(cases);
    addStrut(cases);
}

} // namespace knead::book
