// Rubber by its strain energy.
#include "verify/cases.h"

#include <Eigen/Dense>

#include <cmath>

namespace knead::book {

namespace {

constexpr double nu = 0.49;
constexpr double shearModulus = 4e5;                    // [Pa]
constexpr double modulus = 2 * (1 + nu) * shearModulus; // [Pa]
constexpr const char* chapter = "Rubber";

/// Neo-Hooke.
Material rubber()
{
    Material material = elastic(modulus, nu);
    material.rubberlike = 1;
    return material;
}

/// W = mu/2 (J^(-2/3) tr F F^T - 3) + K/2 (ln J)^2 [Pa].
double energyDensity(const Mat3& F)
{
    const Material material = rubber();
    const double J = F.determinant();
    const double bulk = material.lameLambda() + 2.0 / 3 * material.shearModulus();
    return material.shearModulus() / 2 * (F.squaredNorm() / std::cbrt(J * J) - 3) +
           bulk / 2 * std::log(J) * std::log(J);
}

/// First Piola-Kirchhoff stress of it [Pa].
Mat3 stressOf(const Mat3& F)
{
    const Material material = rubber();
    const double J = F.determinant();
    const double bulk = material.lameLambda() + 2.0 / 3 * material.shearModulus();
    const Mat3 inverse = F.inverse().transpose();
    return material.shearModulus() / std::cbrt(J * J) * (F - F.squaredNorm() / 3 * inverse) +
           bulk * std::log(J) * inverse;
}

/// Stretches whose marked ones (0 or 1) are given and whose others are free of stress.
Mat3 freeSideways(const Vec3& stretch, const Vec3& isFree)
{
    const auto at = [&](double side) {
        Mat3 F = Mat3::Zero();
        for (Eigen::Index i = 0; i < 3; ++i)
            F(i, i) = isFree[i] != 0 ? side : stretch[i];
        return F;
    };
    const Eigen::Index index = isFree[2] != 0 ? 2 : 1;
    double low = 0.1, high = 3; // stress rises with the stretch
    for (int i = 0; i < 80; ++i) {
        const double middle = (low + high) / 2;
        (stressOf(at(middle))(index, index) > 0 ? high : low) = middle;
    }
    return at(low);
}

/// A cube whose whole surface is moved as F does.
Case cube(Case base, const Mat3& F, Eigen::Index row, Eigen::Index column)
{
    constexpr double h = 0.02;
    const Mat3 gradient = F - Mat3::Identity();
    const auto part = [=]() -> Part {
        return {.block = bar({h, h, h}, 3),
                .material = rubber(),
                .grips = {{[h](const Vec3& p) { return h / 2 - p.cwiseAbs().maxCoeff(); },
                           [gradient](const Vec3& p, double share) { return Vec3(share * (gradient * p)); }}},
                .slowest = pullingFrequency(h),
                .loadPeriods = 40,
                .law = {.isRubber = true}};
    };
    const Measure measure = [=](const std::vector<Finding>& findings) {
        const Finding& found = findings.back();
        Mat3 stress = Mat3::Zero();
        for (const PointForce& force : found.reactions[0])
            stress -= force.force * force.place.transpose() / (h * h * h);
        const double energy = found.spacing > 0 ? found.elasticEnergy / (h * h * h) / energyDensity(F) : std::nan("");
        return std::vector<double>{stress(row, column) / stressOf(F)(row, column), energy};
    };
    base.group = base.group.empty() ? chapter : base.group;
    if (base.quantities.empty())
        base.quantities = {{"force / formula", "", 1, 0.03, Origin::closedForm},
                           {"energy / formula", "", 1, 0.03, Origin::closedForm}};
    base.source += base.source.empty()
                       ? "Neo-Hooke: W = mu/2 (J^(-2/3) tr F F^T - 3) + K/2 (ln J)^2, nu = 0.49. The whole surface is "
                         "moved; CalculiX has another volume term."
                       : "";
    base.across = "the cube";
    base.run = {};
    return partCase(std::move(base), part, h, measure);
}

void addCubes(std::vector<Case>& cases)
{
    const Mat3 two = freeSideways({2, 0, 0}, {0, 1, 1});
    cases.push_back(cube({.id = "rubber-uniaxial-2",
                          .group = {},
                          .title = "Rubber stretched to 2",
                          .source = {},
                          .quantities = {},
                          .across = {},
                          .run = {}},
                         two, 0, 0));
    cases.push_back(cube({.id = "rubber-uniaxial-3",
                          .group = {},
                          .title = "Rubber stretched to 3",
                          .source = {},
                          .quantities = {{"force / formula", "", 1, 0.06, Origin::closedForm},
                                         {"energy / formula", "", 1, 0.06, Origin::closedForm}},
                          .across = {},
                          .run = {}},
                         freeSideways({3, 0, 0}, {0, 1, 1}), 0, 0));
    cases.push_back(cube({.id = "rubber-biaxial",
                          .group = {},
                          .title = "Rubber stretched to 1.5 in two directions",
                          .source = {},
                          .quantities = {},
                          .across = {},
                          .run = {}},
                         freeSideways({1.5, 1.5, 0}, {0, 0, 1}), 0, 0));
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = 1;
    cases.push_back(cube({.id = "rubber-shear",
                          .group = {},
                          .title = "Rubber sheared by its height",
                          .source = {},
                          .quantities = {},
                          .across = {},
                          .run = {}},
                         shear, 0, 1));
    Mat3 confined = Mat3::Identity();
    confined(2, 2) = 0.8;
    cases.push_back(cube({.id = "rubber-confined",
                          .group = {},
                          .title = "Rubber pressed to 0.8 without room to give way",
                          .source = {},
                          .quantities = {},
                          .across = {},
                          .run = {}},
                         confined, 2, 2));
    // Measured: nominal stress over that of the formula, whose modulus is that of the typed one over Treloar's.
    const Mat3 treloar = freeSideways({1.94, 1.94, 0}, {0, 0, 1});
    cases.push_back(cube(
        {.id = "rubber-treloar",
         .group = "Published measurements",
         .title = "Sheet of rubber stretched to 1.94 in two directions",
         .source = "Treloar, Transactions of the Faraday Society 40 (1944) 59: 0.77 MPa of the undeformed section, "
                   "shear modulus 0.39 MPa from small strains of the same rubber.",
         .quantities = {{"force / formula", "", 0.77e6 / (0.39e6 / shearModulus * stressOf(treloar)(0, 0)), 0.08,
                         Origin::measured}},
         .across = {},
         .run = {}},
        treloar, 0, 0));
}

/// A bar with free sides, pulled to twice its length: force for the stretch of its middle.
void addBar(std::vector<Case>& cases)
{
    constexpr double h = 0.02, length = 0.1;
    const auto part = [=]() -> Part {
        const Vec3 by(length / 2, 0, 0);
        return {.block = bar({length, h, h}, 2),
                .material = rubber(),
                .grips = {moved(beyond(0, -1, length / 2), -by), moved(beyond(0, 1, length / 2), by)},
                .slowest = pullingFrequency(length),
                .loadPeriods = 6,
                .law = {.isRubber = true}};
    };
    cases.push_back(partCase({.id = "rubber-bar",
                              .group = chapter,
                              .title = "Rubber bar with free sides pulled to twice its length",
                              .source = "Neo-Hooke at the stretch of its middle.",
                              .quantities = {{"force / formula", "", 1, 0.03, Origin::closedForm}},
                              .across = "the bar",
                              .run = {}},
                             part, h, [=](const std::vector<Finding>& findings) {
                                 const Finding& found = findings.back();
                                 const double stretch =
                                     1 + slope(found, Box(Vec3(-0.015, -1, -1), Vec3(0.015, 1, 1)), 0, 0);
                                 const double force = 0.5 * std::abs((forceOn(found, 0) - forceOn(found, 1)).x());
                                 const Mat3 F = freeSideways({stretch, 0, 0}, {0, 1, 1});
                                 return std::vector<double>{force / (h * h * stressOf(F)(0, 0))};
                             }));
}

/// A ring of round section squeezed between smooth plates.
void addSeal(std::vector<Case>& cases)
{
    constexpr double cord = 0.0035, diameter = 0.02, share = 0.2;
    const auto part = [=]() -> Part {
        MappedBlock block = roundBar(cord / 2, 1, 6);
        block.closed = true;
        block.cells[0] = 48;
        block.place = [section = block.place](double u, double v, double w) {
            const Vec3 p = section(0, v, w);
            const double r = diameter / 2 + p.y();
            return Vec3(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), p.z());
        };
        Part ring{.block = block, .material = rubber(), .grips = {}, .slowest = 2 / diameter, .loadPeriods = 3};
        for (const double sign : {1.0, -1.0}) {
            Manipulator plate{.name = "plate", .size = {2 * diameter, 2 * diameter, diameter / 4}};
            plate.friction = 0;
            plate.pose.position = Vec3(0, 0, sign * (cord / 2 + diameter / 8));
            ring.tools.push_back({plate, Vec3(0, 0, -sign * share * cord / 2)});
        }
        return ring;
    };
    const double force = pi * diameter * cord * modulus * (1.25 * std::pow(share, 1.5) + 50 * std::pow(share, 6));
    cases.push_back(partCase(
        {.id = "o-ring",
         .group = "Published measurements",
         .title = "O-ring squeezed by a fifth",
         .source = "Lindley, Journal of Strain Analysis 2 (1967) 190, from measurements: "
                   "F / (pi D d E) = 1.25 c^1.5 + 50 c^6.",
         .quantities = {{"force", "N", force, 0.12, Origin::measured}},
         .cells = 6,
         .across = "the cord",
         .run = {},
         .finer = {4.0 / 3, 5.0 / 3}},
        part, cord,
        [](const std::vector<Finding>& findings) {
            const auto& forces = findings.back().toolForces;
            return std::vector<double>{0.5 * (forces[0] - forces[1]).norm()};
        },
        false));
}

} // namespace

void addRubberCases(std::vector<Case>& cases)
{
    addCubes(cases);
    addBar(cases);
    addSeal(cases);
}

} // namespace knead::book
