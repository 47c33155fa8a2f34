// Contact: pressing, rolling, sliding, sticking.
#include "core/aggregate/fill.h"
#include "support/shapes.h"
#include "verify/cases.h"
#include "verify/experiment.h"

#include <algorithm>
#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr const char* chapter = "Contact";

/// A ball pressed into an elastic block at a place that is none of the lattice's.
Part ballOnBlock(double radius, double down, const Vec3& off)
{
    constexpr double width = 0.072, depth = 0.044;
    Part part{.block = bar({width, width, depth}, 2),
              .material = elastic(modulus, 0.25),
              .grips = {held(beyond(2, -1, depth / 2))},
              .slowest = pullingFrequency(2 * depth)};
    Manipulator ball{.name = "ball", .size = Vec3::Constant(2 * radius)};
    ball.kind = ToolKind::ball;
    ball.friction = 0;
    ball.pose.position = Vec3(0, 0, depth / 2 + radius) + off;
    part.tools.push_back({ball, Vec3(0, 0, -down)});
    return part;
}

void addHertz(std::vector<Case>& cases)
{
    constexpr double radius = 0.024, down = 0.002;
    const double print = 2 * std::sqrt(radius * down);
    const double force = 4.0 / 3 * modulus / (1 - 0.0625) * std::sqrt(radius) * std::pow(down, 1.5);
    cases.push_back(partCase(
        {.id = "hertz-ball",
         .group = chapter,
         .title = "Ball pressed into an elastic block",
         .source = "Hertz: 4/3 E / (1 - nu^2) sqrt(R) d^1.5.",
         .quantities = {{"force", "N", force, 0.1}, {"sideways / down", "", 0, 0.01}},
         .cells = 7,
         .across = "the print",
         .run = {},
         .quick = false,
         .finer = {1.25, 1.5}},
        [=] {
            return ballOnBlock(radius, down, {0.0007, 0.0003, 0});
        },
        print,
        [](const std::vector<Finding>& findings) {
            const Vec3 push = findings.back().toolForces[0];
            return std::vector<double>{std::abs(push.z()), std::hypot(push.x(), push.y()) / std::abs(push.z())};
        },
        false));
}

/// A block between smooth plates.
Part pressedBlock(double nu, double share)
{
    constexpr double h = 0.02;
    Part part{.block = bar({h, h, h}, 2),
              .material = elastic(modulus, nu),
              .grips = {},
              .slowest = pullingFrequency(2 * h),
              .loadPeriods = share > 0.1 ? 40.0 : 20.0};
    for (const double sign : {1.0, -1.0}) {
        Manipulator plate{.name = "plate", .size = {5 * h, 5 * h, h}};
        plate.kind = ToolKind::box;
        plate.friction = 0;
        plate.pose.position = Vec3(0, 0, sign * h);
        part.tools.push_back({plate, Vec3(0, 0, -sign * share * h / 2)});
    }
    return part;
}

void addPlates(std::vector<Case>& cases)
{
    constexpr double h = 0.02;
    cases.push_back(partCase(
        {.id = "pressed-a-little",
         .group = chapter,
         .title = "Block pressed by a hundredth between smooth plates",
         .source = "F = E A strain; the contacts must not give way.",
         .quantities = {{"force", "N", modulus * h * h * 0.01, 0.05, Origin::closedForm, Expected::notYet}},
         .across = "the block",
         .run = {}},
        [] { return pressedBlock(0.3, 0.01); }, h,
        [](const std::vector<Finding>& findings) {
            const auto& forces = findings.back().toolForces;
            return std::vector<double>{0.5 * (forces[0] - forces[1]).norm()};
        },
        false));
    cases.push_back(partCase(
        {.id = "crushed",
         .group = chapter,
         .title = "Block crushed by 80 % between smooth plates",
         .source = "No object may pass a plate.",
         .quantities = {{"penetration", "spacings", 0, 0.1}},
         .across = "the block",
         .run = {}},
        [] { return pressedBlock(0.3, 0.8); }, h,
        [](const std::vector<Finding>& findings) {
            const Finding& found = findings.back();
            double deepest = 0;
            for (std::size_t i = 0; i < found.rest.size(); ++i)
                deepest = std::max(deepest, std::abs((found.rest[i] + found.displacement[i]).z()) - 0.1 * h);
            return std::vector<double>{deepest / found.spacing};
        },
        false));
}

/// Gravity as on a slope of an angle that goes down along x.
Vec3 gravityOnSlope(double angle)
{
    return 9.81 * Vec3(std::sin(angle), 0, -std::cos(angle));
}

/// A block or cylinder that lies on the floor of a slope for a while; how far it gets along x, less `before` [m].
Case slope(Case base, const std::function<TriangleMesh()>& mesh, BodyKind kind, double angle, double friction,
           double length, double duration, double unit)
{
    base.group = chapter;
    base.run = [=](double cells) {
        Scene scene;
        const TriangleMesh surface = mesh();
        Material material = elastic(1e7, 0.25);
        material.friction = friction;
        scene.bodies.push_back(
            {.name = "body",
             .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = length / cells})),
             .material = material,
             .kind = kind});
        scene.gravity = gravityOnSlope(angle);
        scene.floorFriction = friction;
        double low = 0;
        for (const Vec3& vertex : surface.vertices)
            low = std::min(low, vertex.z());
        scene.floorHeight = low;
        const auto place = [](const Snapshot& shot) {
            Vec3 sum = Vec3::Zero();
            for (const Vec3& p : shot.bodies[0].positions)
                sum += p;
            return sum.x() / static_cast<double>(shot.bodies[0].positions.size());
        };
        Experiment experiment(scene);
        const double start = place(*experiment.simulation().snapshot());
        experiment.runUntil(duration);
        const double way = place(*experiment.simulation().snapshot()) - start;
        return experiment.outcome({unit * way}, surface);
    };
    return base;
}

void addSlopes(std::vector<Case>& cases)
{
    const double friction = 0.4;
    const auto block = [] { return shapes::box({0.03, 0.03, 0.015}); };
    const auto cylinder = [] {
        return shapes::moved(shapes::cylinder(0.01, 0.02, 64),
                             {Vec3::Zero(), Quaternion(Eigen::AngleAxisd(pi / 2, Vec3::UnitX()))});
    };
    const double steep = std::atan(1.3 * friction), flat = std::atan(0.9 * friction), ten = 10 * pi / 180;
    const double slide = 0.5 * 9.81 * (std::sin(steep) - friction * std::cos(steep)) * 0.09;
    cases.push_back(slope({.id = "slide",
                           .group = {},
                           .title = "Block slides down a slope for 0.3 s",
                           .source = "g (sin a - u cos a) t^2 / 2.",
                           .quantities = {{"way", "mm", 1000 * slide, 0.05}},
                           .cells = 4,
                           .across = "the height",
                           .run = {}},
                          block, BodyKind::deformable, steep, friction, 0.015, 0.3, 1000));
    cases.push_back(slope({.id = "stick",
                           .group = {},
                           .title = "Block at 0.9 of its friction angle for 10 s",
                           .source = "It stays. As it settles its middle may move by a thousandth of a millimeter.",
                           .quantities = {{"way", "mm", 0, 0.01}},
                           .cells = 4,
                           .across = "the height",
                           .run = {},
                           .finer = {1.5}},
                          block, BodyKind::deformable, flat, friction, 0.015, 10, 1000));
    for (const BodyKind kind : {BodyKind::rigid, BodyKind::deformable}) {
        const bool rigid = kind == BodyKind::rigid;
        cases.push_back(
            slope({.id = rigid ? "roll-rigid" : "roll",
                   .group = {},
                   .title = std::string(rigid ? "Rigid" : "Elastic") + " cylinder rolls down 10 degrees for 0.4 s",
                   .source = "g sin a t^2 / 3: 90.9 mm.",
                   .quantities = {{"way", "mm", 1000 * 9.81 * std::sin(ten) * 0.16 / 3, 0.05}},
                   .cells = 8,
                   .across = "the cylinder",
                   .run = {},
                   .finer = {1.5}},
                  cylinder, kind, ten, friction, 0.02, 0.4, 1000));
    }
}

/// A rubber ball hits the floor.
void addBounce(std::vector<Case>& cases)
{
    constexpr double radius = 0.01, speed = 0.5, density = 1000;
    const double mass = density * 4 / 3 * pi * std::pow(radius, 3);
    const double reduced = modulus / (1 - 0.0625);
    const double duration = 2.87 * std::pow(mass * mass / (radius * reduced * reduced * speed), 0.2);
    Case bounce{.id = "bounce",
                .group = chapter,
                .title = "Elastic ball bounces off the floor",
                .source = "Hertz: in contact for 2.87 (m^2 / (R E*^2 v))^(1/5); it leaves nearly as fast as it came.",
                .quantities = {{"duration", "ms", 1000 * duration, 0.1}, {"speed after / before", "", 1, 0.05}},
                .cells = 10,
                .across = "the ball",
                .run = {},
                .finer = {1.5}};
    bounce.run = [=](double cells) {
        const TriangleMesh surface = shapes::sphere(radius, 48);
        Scene scene;
        Material material = elastic(modulus, 0.25);
        material.density = density;
        material.dampingRatio = 0;
        material.friction = 0;
        scene.bodies.push_back(
            {.name = "ball",
             .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = 2 * radius / cells})),
             .material = material,
             .velocity = Vec3(0, 0, -speed)});
        scene.floorHeight = -radius - 1e-4;
        scene.floorFriction = 0;
        Experiment experiment(scene);
        const auto momentum = [&] { return experiment.simulation().snapshot()->momentum.z(); };
        const double before = momentum();
        // It slows down from 2 % on and is as fast as it gets at the end: half of that way twice is the duration.
        double begin = 0, turn = 0;
        while (experiment.time() < 4e-4 + 4 * duration) {
            experiment.runUntil(experiment.time() + duration / 100);
            const double now = momentum() / before;
            begin = now > 0.99 ? experiment.time() : begin;
            turn = now > 0 ? experiment.time() : turn;
        }
        // Until 1 % of the momentum is lost, 0.142 of the half time passes (Hertz's equation of motion).
        const double half = (turn - begin) / (1 - 0.142);
        return experiment.outcome({2000 * half, -momentum() / before}, surface);
    };
    cases.push_back(std::move(bounce));
}

} // namespace

void addContactCases(std::vector<Case>& cases)
{
    addPlates(cases);
    addHertz(cases);
    addSlopes(cases);
    addBounce(cases);
}

} // namespace knead::book
