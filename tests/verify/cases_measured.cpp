// Published measurements that have no chapter of their own.
#include "core/aggregate/fill.h"
#include "support/shapes.h"
#include "verify/cases.h"
#include "verify/experiment.h"

#include <cmath>

namespace knead::book {

namespace {

constexpr const char* chapter = "Published measurements";

/// A disc of rubber between plates that it sticks to.
void addBondedDisc(std::vector<Case>& cases)
{
    constexpr double radius = 0.02, height = 0.01, share = 0.01, modulus = 1e6, nu = 0.49;
    const auto part = [=]() -> Part {
        const Vec3 by(share * height / 2, 0, 0);
        return {.block = roundBar(radius, height, 12),
                .material = elastic(modulus, nu),
                .grips = {moved(beyond(0, -1, height / 2), by), moved(beyond(0, 1, height / 2), -by)},
                .slowest = pullingFrequency(height),
                .loadPeriods = 8};
    };
    cases.push_back(partCase(
        {.id = "bonded-disc",
         .group = chapter,
         .title = "Disc of rubber bonded to plates, pressed",
         .source = "Gent and Lindley, Proceedings of the Institution of Mechanical Engineers 173 (1959) 111: stiffness "
                   "E A / t "
                   "(1 + 2 k S^2), shape factor S = d / (4 t) = 1, k measured 0.85 for soft rubber and 1 in theory; in "
                   "series "
                   "with the bulk modulus of Poisson's ratio 0.49: 2.32 to 2.54.",
         .quantities = {{"stiffness over E A / t", "", 2.43, 0.1, Origin::measured, Expected::notYet}},
         .cells = 4,
         .across = "the height",
         .run = {}},
        part, height, [=](const std::vector<Finding>& findings) {
            const double force = 0.5 * std::abs((forceOn(findings.back(), 0) - forceOn(findings.back(), 1)).x());
            return std::vector<double>{force / (modulus * pi * radius * radius * share)};
        }));
}

/// The steel ball with which the clay behind body armor is calibrated.
void addBallDrop(std::vector<Case>& cases)
{
    constexpr double radius = 0.03175, mass = 1.043, width = 0.16, depth = 0.08;
    const double speed = std::sqrt(2 * 9.81 * 2.0);
    Case drop{
        .id = "clay-ball-drop",
        .group = chapter,
        .title = "Steel ball of 1.043 kg falls 2 m into clay",
        .source =
            "NIJ Standard 0101.04 for clay behind body armor (Roma Plastilina No. 1): a ball of 63.5 mm leaves a print "
            "of 19 +- 2 mm. The clay has a flow stress of 0.25 MPa, about what is published for rates of 100/s: it "
            "is not measured in the same test. The block is 160 x 160 x 80 mm.",
        .quantities = {{"depth", "mm", 19, 2.0 / 19, Origin::measured}},
        .cells = 8,
        .across = "the radius of the ball",
        .run = {},
        .quick = false,
        .finer = {1.25}};
    drop.run = [=](double cells) {
        const double spacing = radius / cells;
        const TriangleMesh surface = shapes::box({width, width, depth});
        Scene scene;
        Material clay = plastic(2e7, 0.45, 2.5e5, 0);
        clay.density = 1530;
        clay.friction = 0.3;
        scene.bodies.push_back({.name = "clay",
                                .aggregate = std::make_shared<const Aggregate>(fill(surface, {.spacing = spacing})),
                                .material = clay});
        std::vector<ObjectIndex> ground;
        const Lattice& lattice = scene.bodies[0].aggregate->lattice;
        for (ObjectIndex i = 0; i < lattice.size(); ++i)
            if (lattice.position(i).z() < -depth / 2 + 0.5 * spacing)
                ground.push_back(i);
        scene.fixtures.push_back({"ground", 0, ground});
        Material steel = elastic(2e8, 0.3); // rigid: only its contact has a stiffness
        steel.density = mass / (4.0 / 3 * pi * std::pow(radius, 3));
        steel.friction = 0.3;
        scene.bodies.push_back(
            {.name = "ball",
             .aggregate = std::make_shared<const Aggregate>(
                 fill(shapes::moved(shapes::sphere(radius, 64),
                                    {Vec3(0.2e-3, 0.3e-3, depth / 2 + 1.02 * radius), Quaternion::Identity()}),
                      {.spacing = spacing})),
             .material = steel,
             .velocity = Vec3(0, 0, -speed),
             .kind = BodyKind::rigid});
        scene.gravity = Vec3(0, 0, -9.81);
        Experiment experiment(scene);
        double lowest = 1;
        while (experiment.time() < 0.012) {
            experiment.runUntil(experiment.time() + 2e-4);
            double sum = 0;
            const auto shot = experiment.simulation().snapshot();
            for (const Vec3& p : shot->bodies[1].positions)
                sum += p.z();
            lowest = std::min(lowest, sum / static_cast<double>(shot->bodies[1].positions.size()));
        }
        return experiment.outcome({1000 * (depth / 2 + radius - lowest)}, surface);
    };
    cases.push_back(std::move(drop));
}

} // namespace

void addMeasuredCases(std::vector<Case>& cases)
{
    addBondedDisc(cases);
    addBallDrop(cases);
}

} // namespace knead::book
