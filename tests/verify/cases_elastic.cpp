// Small strain: moduli and sections.
#include "verify/cases.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]; elastic answers are in proportion to it
constexpr const char* chapter = "Elasticity at small strain";

/// A bar pulled at both ends by a thousandth.
Part pulledBar(double nu, const Pose& pose)
{
    constexpr double length = 0.16;
    const Vec3 by(0.5e-3 * length, 0, 0);
    return {.block = bar({length, 0.02, 0.02}, 2),
            .material = elastic(modulus, nu),
            .grips = {moved(beyond(0, -1, length / 2), -by), moved(beyond(0, 1, length / 2), by)},
            .pose = pose,
            .slowest = pullingFrequency(length)};
}

Case tension(double nu, const Pose& pose, const std::string& name, const std::string& words)
{
    const Measure measure = [](const std::vector<Finding>& findings) {
        const Finding& found = findings.back();
        const double stretch = slope(found, Box(Vec3(-0.04, -1, -1), Vec3(0.04, 1, 1)), 0, 0);
        const double across = slope(found, Box(Vec3(-0.02, -1, -1), Vec3(0.02, 1, 1)), 1, 1);
        const double pull = 0.5 * (forceOn(found, 0) - forceOn(found, 1)).x();
        return std::vector<double>{1e-6 * pull / (0.02 * 0.02) / stretch, -across / stretch};
    };
    const bool isTilted = pose.rotation.w() != 1;
    return partCase(
        {.id = "tension-" + name,
         .group = chapter,
         .title = "Square bar pulled, " + words,
         .source = "Typed modulus and Poisson's ratio; force over section and strain of the middle half.",
         .quantities = {{"modulus", "MPa", 1, 0.03},
                        {"Poisson's ratio", "", nu, nu == 0 ? 0.01 : 0.05, Origin::closedForm,
                         isTilted ? Expected::notYet : Expected::holds}},
         .across = "the bar",
         .run = {}},
        [=] { return pulledBar(nu, pose); }, 0.02, measure);
}

enum class Load { bending, torsion };

/// A bar whose ends are turned against each other by a little; stiffness of its section from the moment and what the middle
/// half turns.
Case section(Case base, const MappedBlock& block, double length, double height, double nu, const Pose& pose, Load load,
             double acrossLength)
{
    const double angle = load == Load::bending ? 0.02 : 0.04;
    const Vec3 axis = load == Load::bending ? Vec3::UnitY() : Vec3::UnitX();
    const auto part = [=]() -> Part {
        const auto end = [&](double sign) {
            const Grip grip = turned(beyond(0, sign, length / 2), {sign * length / 2, 0, 0}, axis, sign * angle / 2);
            return load == Load::bending ? bent(grip) : grip;
        };
        return {.block = block,
                .material = elastic(modulus, nu),
                .grips = {end(-1), end(1)},
                .pose = pose,
                .slowest = load == Load::bending ? bendingFrequency(length, height) : twistingFrequency(length, nu),
                .segments = 6};
    };
    const int about = load == Load::bending ? 1 : 0;
    const Measure measure = [=](const std::vector<Finding>& findings) {
        const Finding& found = findings.back();
        const double turn =
            sectionMotion(found, 0, length / 4).rotation[about] - sectionMotion(found, 0, -length / 4).rotation[about];
        const double moment =
            0.5 * (momentOn(found, 0, {-length / 2, 0, 0}) - momentOn(found, 1, {length / 2, 0, 0}))[about];
        const double stiffness = moment / (turn / (length / 2));
        return std::vector<double>{stiffness / (load == Load::bending ? modulus : modulus / (2 * (1 + nu))) * 1e12};
    };
    base.group = chapter;
    base.run = {};
    return partCase(std::move(base), part, acrossLength, measure);
}

Pose rolled(double degrees)
{
    return {Vec3::Zero(), Quaternion(Eigen::AngleAxisd(degrees * pi / 180, Vec3::UnitX()))};
}

Pose tilted()
{
    return {Vec3::Zero(), Quaternion(Eigen::AngleAxisd(0.6, Vec3(0.3, 1, 0.5).normalized()))};
}

void addSquareBars(std::vector<Case>& cases)
{
    constexpr double h = 0.02;
    struct Row {
        double cells;
        const char* name;
        const char* words;
        Pose pose;
        double tolerance;
    };
    const Row rows[] = {
        {1, "1", "1 cell", {}, 0.3},
        {1.3, "1.3", "1.3 cells", {}, 0.3},
        {1.75, "1.75", "1.75 cells", {}, 0.1},
        {2, "2", "2 cells", {}, 0.1},
        {2.5, "2.5", "2.5 cells", {}, 0.1},
        {3.3, "3.3", "3.3 cells", {}, 0.1},
        {4, "4", "4 cells", {}, 0.1},
        {2.5, "2.5-rolled", "2.5 cells, rolled by 29 degrees", rolled(29), 0.1},
        {4, "4-rolled", "4 cells, rolled by 29 degrees", rolled(29), 0.1},
        {2.5, "2.5-tilted", "2.5 cells, tilted about three axes", tilted(), 0.1},
        {4, "4-tilted", "4 cells, tilted about three axes", tilted(), 0.1},
    };
    for (const Row& row : rows) {
        // Finer runs of the coarse ones would repeat the others.
        const std::vector<double> finer = row.cells == 4 ? std::vector<double>{1.5, 2} : std::vector<double>{};
        cases.push_back(
            section({.id = std::string("bending-") + row.name,
                     .group = {},
                     .title = std::string("Bending stiffness of a square bar, ") + row.words,
                     .source = "E I with I = h^4 / 12; moment at the ends over curvature of the middle half.",
                     .quantities = {{"EI / E", "mm^4", 1e12 * std::pow(h, 4) / 12, row.tolerance}},
                     .cells = row.cells,
                     .across = "the bar",
                     .run = {},
                     .finer = finer},
                    bar({0.16, h, h}, 2), 0.16, h, 0.3, row.pose, Load::bending, h));
    }
    cases.push_back(
        section({.id = "torsion-square",
                 .group = {},
                 .title = "Torsion stiffness of a square bar",
                 .source = "J = 0.1406 h^4 (Timoshenko and Goodier, Theory of Elasticity, torsion of prisms).",
                 .quantities = {{"GJ / G", "mm^4", 1e12 * 0.14058 * std::pow(h, 4), 0.15}},
                 .across = "the bar",
                 .run = {}},
                bar({0.12, h, h}, 3), 0.12, h, 0.3, {}, Load::torsion, h));
    cases.push_back(section({.id = "torsion-round",
                             .group = {},
                             .title = "Torsion stiffness of a round bar",
                             .source = "J = pi r^4 / 2.",
                             .quantities = {{"GJ / G", "mm^4", 1e12 * pi * std::pow(h / 2, 4) / 2, 0.15}},
                             .across = "the bar",
                             .run = {}},
                            roundBar(h / 2, 0.12, 6), 0.12, h, 0.3, tilted(), Load::torsion, h));
}

/// Walls of 3 mm in a square pipe of 30 mm, and a round pipe.
void addPipes(std::vector<Case>& cases)
{
    constexpr double b = 0.03, t = 0.003, length = 0.12;
    const double inner = b - 2 * t, middle = b - t;
    const double bending = (std::pow(b, 4) - std::pow(inner, 4)) / 12;
    // Bredt's tube and, less, what its wall is as an open strip.
    const double torsion = 4 * std::pow(middle, 4) * t / (4 * middle) + 4 * middle * std::pow(t, 3) / 3;
    for (const double cells : {2.0, 2.5})
        for (const Load load : {Load::bending, Load::torsion}) {
            const bool bends = load == Load::bending;
            const std::string number = cells == 2 ? "2" : "2.5";
            cases.push_back(section(
                {.id = (bends ? "box-bending-" : "box-torsion-") + number,
                 .group = {},
                 .title = std::string(bends ? "Bending" : "Torsion") + " stiffness of a square pipe, walls of " +
                          number + " cells",
                 .source =
                     bends ? "E I of the square less that of its hole." : "Bredt: J = 4 A^2 t / s, and s t^3 / 3.",
                 .quantities = {{bends ? "EI / E" : "GJ / G", "mm^4", 1e12 * (bends ? bending : torsion), 0.15}},
                 .cells = cells,
                 .across = "a wall",
                 .run = {},
                 .quick = false,
                 .finer = cells == 2 ? std::vector<double>{1.5} : std::vector<double>{}},
                squarePipe(b, t, length, 1), length, b, 0.3, {}, load, t));
        }
    constexpr double ri = 0.009, ro = 0.012;
    cases.push_back(
        section({.id = "pipe-torsion",
                 .group = {},
                 .title = "Torsion stiffness of a round pipe",
                 .source = "J = pi (R^4 - r^4) / 2.",
                 .quantities = {{"GJ / G", "mm^4", 1e12 * pi * (std::pow(ro, 4) - std::pow(ri, 4)) / 2, 0.15}},
                 .cells = 2,
                 .across = "the wall",
                 .run = {},
                 .quick = false,
                 .finer = {1.5}},
                pipe(ri, ro, 0.1, 2), 0.1, 2 * ro, 0.3, {}, Load::torsion, ro - ri));
}

/// A block whose whole surface is moved as simple shear, or pressed in one direction only.
Part movedCube(double nu, const Mat3& gradient)
{
    constexpr double h = 0.02;
    return {.block = bar({h, h, h}, 3),
            .material = elastic(modulus, nu),
            .grips = {{[](const Vec3& p) { return h / 2 - p.cwiseAbs().maxCoeff(); },
                       [gradient](const Vec3& p, double share) { return Vec3(share * (gradient * p)); }}},
            .slowest = 2 * pullingFrequency(h),
            .loadPeriods = 30};
}

/// The first column of tractions on the faces: sum of force times place over volume is the mean stress (Gauss).
Mat3 meanStress(const Finding& found, double volume)
{
    Mat3 sum = Mat3::Zero();
    for (const PointForce& force : found.reactions.at(0))
        sum -= force.force * force.place.transpose(); // forces are on the grip
    return sum / volume;
}

void addCubes(std::vector<Case>& cases)
{
    constexpr double volume = 8e-6;
    constexpr double strain = 1e-3;
    Mat3 shear = Mat3::Zero();
    shear(0, 1) = strain;
    cases.push_back(partCase(
        {.id = "simple-shear",
         .group = chapter,
         .title = "Cube sheared at its whole surface",
         .source = "G = E / (2 (1 + nu)); mean stress from the forces at the surface.",
         .quantities = {{"shear modulus", "MPa", 1 / 2.6, 0.02}},
         .across = "the cube",
         .run = {}},
        [=] { return movedCube(0.3, shear); }, 0.02,
        [=](const std::vector<Finding>& findings) {
            return std::vector<double>{1e-6 * meanStress(findings.back(), volume)(0, 1) / strain};
        }));
    Mat3 press = Mat3::Zero();
    press(2, 2) = -strain;
    const double nu = 0.4;
    cases.push_back(partCase(
        {.id = "confined-press",
         .group = chapter,
         .title = "Cube pressed in one direction without room to give way",
         .source = "Modulus E (1 - nu) / ((1 + nu) (1 - 2 nu)), sideways pressure nu / (1 - nu) of it.",
         .quantities = {{"modulus", "MPa", (1 - nu) / ((1 + nu) * (1 - 2 * nu)), 0.02},
                        {"sideways share", "", nu / (1 - nu), 0.02}},
         .across = "the cube",
         .run = {}},
        [=] { return movedCube(nu, press); }, 0.02,
        [=](const std::vector<Finding>& findings) {
            const Mat3 stress = meanStress(findings.back(), volume);
            return std::vector<double>{-1e-6 * stress(2, 2) / strain, stress(0, 0) / stress(2, 2)};
        }));
}

} // namespace

void addElasticCases(std::vector<Case>& cases)
{
    cases.push_back(tension(0, {}, "nu-0", "Poisson's ratio 0"));
    cases.push_back(tension(0.25, {}, "nu-0.25", "Poisson's ratio 0.25"));
    cases.push_back(tension(0.45, {}, "nu-0.45", "Poisson's ratio 0.45"));
    cases.push_back(tension(0.35, tilted(), "tilted", "tilted about three axes, Poisson's ratio 0.35"));
    addCubes(cases);
    addSquareBars(cases);
    addPipes(cases);
}

} // namespace knead::book
