// Motion: vibration, waves, spinning, accounts of energy.
#include "core/aggregate/fill.h"
#include "support/shapes.h"
#include "verify/cases.h"
#include "verify/experiment.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr double modulus = 1e6; // [Pa]
constexpr double density = 1000;
constexpr const char* chapter = "Motion";

Material undamped(double nu)
{
    Material material = elastic(modulus, nu);
    material.density = density;
    material.dampingRatio = 0;
    return material;
}

/// A body held beyond a zone, that swings.
Scene heldScene(const TriangleMesh& surface, const Material& material, double spacing,
                const std::function<double(const Vec3&)>& zone)
{
    Scene scene;
    scene.bodies.push_back({.name = "body",
                            .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = spacing})),
                            .material = material});
    std::vector<ObjectIndex> objects;
    const Lattice& lattice = scene.bodies[0].aggregate->lattice;
    for (ObjectIndex i = 0; i < lattice.size(); ++i)
        if (zone(lattice.position(i)) <= 0.5 * spacing)
            objects.push_back(i);
    scene.fixtures.push_back({"clamp", 0, objects});
    return scene;
}

/// Mean displacement of the objects along a direction [m].
double meanWay(const Snapshot& shot, const Vec3& direction)
{
    double sum = 0;
    for (ObjectIndex i = 0; i < shot.bodies[0].positions.size(); ++i)
        sum += shot.bodies[0].displacement(i).dot(direction);
    return sum / static_cast<double>(shot.bodies[0].positions.size());
}

/// Time between the first and third time that a signal crosses zero, found by looking 200 times in `expected` [s].
double periodOf(Experiment& experiment, double expected, const std::function<double(const Snapshot&)>& signal)
{
    std::vector<double> crossings;
    double last = 0, lastTime = 0;
    while (crossings.size() < 3 && experiment.time() < 4 * expected) {
        experiment.runUntil(experiment.time() + expected / 200);
        const double now = signal(*experiment.simulation().snapshot());
        if (last * now < 0)
            crossings.push_back(lastTime + (experiment.time() - lastTime) * last / (last - now));
        last = now;
        lastTime = experiment.time();
    }
    return crossings.size() < 3 ? std::nan("") : crossings[2] - crossings[0];
}

/// Swings about the balance under a gravity that begins at once.
/// @param sag about that of the balance, in the mean; any level that it crosses will do [m]
Case swinging(Case base, const std::function<TriangleMesh()>& mesh, const Material& material, double acrossLength,
              const std::function<double(const Vec3&)>& zone, const Vec3& direction, double gravity, double sag,
              double frequency)
{
    base.run = [=](double cells) {
        const TriangleMesh surface = mesh();
        Scene scene = heldScene(surface, material, acrossLength / cells, zone);
        scene.gravity = gravity * direction;
        Experiment experiment(scene);
        const double period =
            periodOf(experiment, 1 / frequency, [&](const Snapshot& shot) { return meanWay(shot, direction) - sag; });
        return experiment.outcome({1 / period}, surface);
    };
    return base;
}

void addSwings(std::vector<Case>& cases)
{
    static constexpr double h = 0.02, length = 0.24;
    const double speed = std::sqrt(modulus / density);
    const double first = 0.5596 * h / std::sqrt(12.0) * speed / (length * length);
    // Mean sag of a cantilever q L^4 / (20 EI) for one of 0.2 % of the length.
    const double sag = 0.002 * length;
    const double gravity = sag * 20 * modulus * h * h / 12 / (density * std::pow(length, 4));
    const auto clamp = [](const Vec3& p) { return p.x() + length / 2; };
    cases.push_back(swinging(
        {.id = "cantilever-frequency",
         .group = chapter,
         .title = "Cantilever swings",
         .source = "0.5596 sqrt(E I / (rho A L^4)), less 1.2 % for shear and rotary inertia.",
         .quantities = {{"frequency", "Hz", 0.988 * first, 0.06}},
         .across = "the bar",
         .run = {}},
        [] {
            return shapes::box({length, h, h});
        },
        undamped(0.3), h, clamp, -Vec3::UnitZ(), gravity, sag, first));
    const double wave = speed / (4 * length);
    const double stretch = 0.001 * length; // mean of rho g L^2 / (3 E)
    cases.push_back(swinging(
        {.id = "bar-frequency",
         .group = chapter,
         .title = "Bar held at one end swings along itself",
         .source = "sqrt(E / rho) / (4 L).",
         .quantities = {{"frequency", "Hz", wave, 0.03}},
         .across = "the bar",
         .run = {}},
        [] {
            return shapes::box({length, h, h});
        },
        undamped(0.3), h, clamp, Vec3::UnitX(), stretch * 3 * modulus / (density * length * length), stretch, wave));
    // In its plane; a plate of any thickness.
    Material steel = undamped(0.3);
    steel.youngsModulus = 200e9;
    steel.density = 8000;
    const auto plate = [] { return shapes::prism({{0, -2.5}, {10, -0.5}, {10, 0.5}, {0, 2.5}}, 1); };
    const double tapered = 44.623;
    cases.push_back(swinging(
        {.id = "nafems-fv32",
         .group = "Published measurements",
         .title = "Tapered plate held at its wide end swings in its plane",
         .source = "NAFEMS benchmark FV32: 10 m long, 5 m wide at the root and 1 m at the end, steel of 200 GPa and "
                   "8000 kg/m^3: 44.623 Hz.",
         .quantities = {{"frequency", "Hz", tapered, 0.05, Origin::measured}},
         .cells = 10,
         .across = "the root",
         .run = {}},
        plate, steel, 5, [](const Vec3& p) { return p.x(); }, Vec3::UnitY(), 1, 0.8 / std::pow(2 * pi * tapered, 2),
        tapered));
}

/// A thin ring that spins widens by rho w^2 R^3 / E.
void addSpinningRing(std::vector<Case>& cases)
{
    constexpr double inner = 0.028, outer = 0.032, length = 0.008, middle = 0.03;
    const double spin = 0.1 * std::sqrt(modulus / density) / middle; // strain of a hundredth
    const double widening = density * spin * spin * std::pow(middle, 3) / modulus;
    Case ring{.id = "spinning-ring",
              .group = chapter,
              .title = "Thin ring that spins freely widens",
              .source = "rho w^2 R^3 / E, with the spin that it keeps when it has widened; its momentum stays.",
              .quantities = {{"widening", "mm", 1000 * widening / std::pow(1 + 0.0095, 4), 0.06},
                             {"lost momentum", "", 0, 1e-4}},
              .cells = 3,
              .across = "the wall",
              .run = {},
              .finer = {1.5}};
    ring.run = [=](double cells) {
        const TriangleMesh surface = surfaceOf(pipe(inner, outer, length, 2));
        Scene scene;
        Material material = undamped(0.3);
        material.dampingRatio = 0.1;
        material.shapeDamping = 500;
        scene.bodies.push_back(
            {.name = "ring",
             .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = (outer - inner) / cells})),
             .material = material,
             .angularVelocity = Vec3(spin, 0, 0)});
        Experiment experiment(scene);
        const double before = experiment.simulation().snapshot()->angularMomentum.x();
        experiment.runUntil(0.05);
        const auto shot = experiment.simulation().snapshot();
        const Lattice& lattice = shot->bodies[0].aggregate->lattice;
        double sum = 0;
        for (ObjectIndex i = 0; i < lattice.size(); ++i) {
            const Vec3 rest = lattice.position(i);
            const Vec3& now = shot->bodies[0].positions[i];
            sum += (std::hypot(now.y(), now.z()) / std::hypot(rest.y(), rest.z()) - 1) * middle;
        }
        return experiment.outcome(
            {1000 * sum / static_cast<double>(lattice.size()), std::abs(shot->angularMomentum.x() / before - 1)},
            surface);
    };
    cases.push_back(std::move(ring));
}

/// A box thrown with a spin about its middle axis tumbles; gravity pulls it.
void addTumbling(std::vector<Case>& cases)
{
    Case box{.id = "tumbling",
             .group = chapter,
             .title = "Elastic box thrown so that it tumbles",
             .source = "Angular momentum stays; what gravity gives is in the motion.",
             .quantities = {{"lost momentum", "", 0, 1e-4}, {"imbalance", "", 0, 0.01}},
             .across = "the box",
             .run = {},
             .finer = {1.5}};
    box.run = [](double cells) {
        const TriangleMesh surface = shapes::box({0.04, 0.03, 0.02});
        Scene scene;
        scene.bodies.push_back(
            {.name = "box",
             .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = 0.02 / cells})),
             .material = undamped(0.3),
             .velocity = Vec3(1, 0, 1),
             .angularVelocity = Vec3(0.3, 20, 0.2)});
        Experiment experiment(scene);
        const Vec3 before = experiment.simulation().snapshot()->angularMomentum;
        experiment.runUntil(0.3);
        const Vec3 after = experiment.simulation().snapshot()->angularMomentum;
        Outcome outcome = experiment.outcome({(after - before).norm() / before.norm(), 0}, surface);
        outcome.values[1] = outcome.imbalance;
        return outcome;
    };
    cases.push_back(std::move(box));
}

/// A rubber block hits another one of the same kind.
void addCollision(std::vector<Case>& cases)
{
    Case collision{.id = "collision",
                   .group = chapter,
                   .title = "Ball hits a ball of the same rubber",
                   .source = "Without damping the second goes on as fast as the first came; momentum stays.",
                   .quantities = {{"speed of the second", "m/s", 0.5, 0.05}, {"lost momentum", "", 0, 1e-9}},
                   .cells = 6,
                   .across = "a ball",
                   .run = {},
                   .finer = {1.5}};
    collision.run = [](double cells) {
        const TriangleMesh surface = shapes::sphere(0.01, 32);
        Material material = undamped(0.25);
        material.friction = 0;
        Scene scene;
        for (const double place : {0.0, 0.0202})
            scene.bodies.push_back(
                {.name = "ball",
                 .aggregate = std::make_shared<const Aggregate>(fill(
                     shapes::moved(surface, {Vec3(place, 0, 0), Quaternion::Identity()}), {.spacing = 0.02 / cells})),
                 .material = material});
        scene.bodies[0].velocity = Vec3(0.5, 0, 0);
        Experiment experiment(scene);
        const Vec3 before = experiment.simulation().snapshot()->momentum;
        const auto place = [&] {
            Vec3 sum = Vec3::Zero();
            const auto shot = experiment.simulation().snapshot();
            for (const Vec3& p : shot->bodies[1].positions)
                sum += p;
            return Vec3(sum / static_cast<double>(shot->bodies[1].positions.size()));
        };
        experiment.runUntil(0.02);
        const Vec3 from = place();
        const double begin = experiment.time();
        experiment.runUntil(0.04);
        const double speed = (place() - from).x() / (experiment.time() - begin);
        const Vec3 after = experiment.simulation().snapshot()->momentum;
        return experiment.outcome({speed, (after - before).norm() / before.norm()}, surface);
    };
    cases.push_back(std::move(collision));
}

} // namespace

void addMotionCases(std::vector<Case>& cases)
{
    addSwings(cases);
    addSpinningRing(cases);
    addTumbling(cases);
    addCollision(cases);
}

} // namespace knead::book
