#include "core/aggregate/fill.h"
#include "core/mechanics/object_strain.h"
#include "core/simulation/simulation.h"
#include "core/skin/deformed_surface.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <functional>

using namespace knead;

namespace {

constexpr double E = 2e6;
constexpr double nu = 0.3;

Material rubber()
{
    Material material;
    material.youngsModulus = E;
    material.poissonRatio = nu;
    return material;
}

/// A block and the displacements that a map gives it.
struct Block {
    Aggregate aggregate = fill(shapes::box({0.02, 0.014, 0.012}), {.spacing = 0.002});

    RelaxedState atRest() const { return {.materials = MaterialMap(rubber(), aggregate.size())}; }

    std::vector<Vec3> displacements(const std::function<Vec3(const Vec3&)>& map) const
    {
        std::vector<Vec3> result;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            result.push_back(map(aggregate.lattice.position(i)) - aggregate.lattice.position(i));
        return result;
    }

    /// The state in which it is relaxed when it is deformed by F.
    RelaxedState relaxedAt(const Mat3& f) const
    {
        RelaxedState relaxed = atRest();
        const Mat3 metric = aggregate.lattice.axes.transpose() * f.transpose() * f * aggregate.lattice.axes;
        const double entries[] = {metric(0, 0), metric(1, 1), metric(2, 2), metric(0, 1), metric(0, 2), metric(1, 2)};
        for (std::size_t n = 0; n < 6; ++n)
            relaxed.metric[n].assign(aggregate.size(), static_cast<float>(entries[n]));
        return relaxed;
    }
};

Mat3 turn(double angle)
{
    return Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

double largestDifference(const std::vector<ObjectStrain>& strains, const Mat3 ObjectStrain::*tensor, const Mat3& wanted)
{
    double most = 0;
    for (const ObjectStrain& one : strains)
        most = std::max(most, (one.*tensor - wanted).norm());
    return most;
}

/// Kirchhoff stress along an axis that is stretched by s, the other two by q and r: that of the connections along it and of the two
/// times two across faces with it, which are linear springs, and of the volumetric term.
double springStress(double s, double q, double r)
{
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    const double mu = E / (2 * (1 + nu));
    const auto acrossFaces = [&](double other) { return 2 * s * s * (1 - std::sqrt(2 / (s * s + other * other))); };
    return mu * (s * (s - 1) + acrossFaces(q) + acrossFaces(r)) + (lambda - mu) * std::log(s * q * r);
}

} // namespace

class ObjectStrainTest : public QObject {
    Q_OBJECT

private slots:
    void evenStretchIsExact();
    void simpleShearIsExact();
    void evenPressureHasNoVonMisesStress();
    void turningChangesNothing();
    void whatHasFlowedBearsNothing();
    void stretchOnTopOfFlowIsElastic();
    void acrossACrackNothingCounts();
    void sheetsAndLonelyObjectsStayFinite();
    void materialsOfRegionsCount();
    void aPulledBarBearsItsForce();
    void flowingMaterialBearsItsYieldStress();
    void fieldsOfTheSkinAreThoseOfTheMaterial();
};

/// ln of the stretches, and what the connections bear over J.
void ObjectStrainTest::evenStretchIsExact()
{
    const Block block;
    const Vec3 stretch(1.3, 0.9, 1.05);
    const auto strains = objectStrains(
        block.aggregate, block.displacements([&](const Vec3& X) -> Vec3 { return stretch.cwiseProduct(X); }),
        block.atRest());
    const Vec3 logarithms = stretch.array().log();
    QVERIFY(largestDifference(strains, &ObjectStrain::strain, logarithms.asDiagonal()) < 1e-12);
    const Vec3 stress = Vec3(springStress(1.3, 0.9, 1.05), springStress(0.9, 1.3, 1.05), springStress(1.05, 1.3, 0.9)) /
                        (stretch.x() * stretch.y() * stretch.z());
    QVERIFY(largestDifference(strains, &ObjectStrain::stress, stress.asDiagonal()) < 1e-9 * E);
    const double byHand = std::sqrt(0.5 * (std::pow(stress[0] - stress[1], 2) + std::pow(stress[1] - stress[2], 2) +
                                           std::pow(stress[2] - stress[0], 2)));
    QVERIFY(std::abs(vonMisesStress(strains.front().stress) / byHand - 1) < 1e-9);
}

/// F F^T of a shear g has the eigenvalues s^2 with s - 1/s = g; its logarithm lies in the plane of the shear.
void ObjectStrainTest::simpleShearIsExact()
{
    const Block block;
    const double g = 0.4;
    const auto strains = objectStrains(
        block.aggregate, block.displacements([&](const Vec3& X) { return Vec3(X.x() + g * X.y(), X.y(), X.z()); }),
        block.atRest());
    const double s = 0.5 * (g + std::sqrt(g * g + 4));
    for (const ObjectStrain& one : strains) {
        QVERIFY(std::abs(one.strain.trace()) < 1e-12);
        QVERIFY(std::abs(equivalentStrain(one.strain) - 2 / std::sqrt(3.0) * std::log(s)) < 1e-12);
        QVERIFY(one.strain.col(2).norm() < 1e-12);
        QVERIFY(one.strain(0, 1) > 0);
    }
}

void ObjectStrainTest::evenPressureHasNoVonMisesStress()
{
    const Block block;
    const auto strains = objectStrains(
        block.aggregate, block.displacements([](const Vec3& X) -> Vec3 { return 0.95 * X; }), block.atRest());
    const double pressure = springStress(0.95, 0.95, 0.95) / std::pow(0.95, 3);
    QVERIFY(largestDifference(strains, &ObjectStrain::stress, pressure * Mat3::Identity()) < 1e-9 * E);
    QVERIFY(vonMisesStress(strains.front().stress) < 1e-9 * E);
    QVERIFY(equivalentStrain(strains.front().strain) < 1e-12);
}

void ObjectStrainTest::turningChangesNothing()
{
    const Block block;
    const auto stretched = [](const Vec3& X) -> Vec3 { return Vec3(1.2 * X.x() + 0.1 * X.z(), 0.9 * X.y(), X.z()); };
    const auto before = objectStrains(block.aggregate, block.displacements(stretched), block.atRest());
    const auto after = objectStrains(
        block.aggregate, block.displacements([&](const Vec3& X) -> Vec3 { return turn(2.1) * stretched(X); }),
        block.atRest());
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY((turn(2.1) * before[i].stress * turn(2.1).transpose() - after[i].stress).norm() < 1e-9 * E);
        QVERIFY(std::abs(vonMisesStress(before[i].stress) - vonMisesStress(after[i].stress)) < 1e-9 * E);
    }
    const auto turned = objectStrains(
        block.aggregate, block.displacements([](const Vec3& X) -> Vec3 { return turn(1) * X; }), block.atRest());
    QVERIFY(largestDifference(turned, &ObjectStrain::strain, Mat3::Zero()) < 1e-12);
}

void ObjectStrainTest::whatHasFlowedBearsNothing()
{
    const Block block;
    Mat3 f;
    f << 1.5, 0.2, 0, 0, 0.8, 0, 0, 0, 0.85;
    const auto moved = block.displacements([&](const Vec3& X) -> Vec3 { return turn(0.7) * f * X; });
    const auto elastic = objectStrains(block.aggregate, moved, block.atRest());
    const auto flowed = objectStrains(block.aggregate, moved, block.relaxedAt(f));
    QVERIFY(vonMisesStress(elastic.front().stress) > 0.3 * E);
    for (std::size_t i = 0; i < flowed.size(); ++i) {
        QVERIFY2(flowed[i].stress.norm() < 1e-4 * E, qPrintable(QString::number(flowed[i].stress.norm() / E)));
        QVERIFY(flowed[i].strain == elastic[i].strain);
    }
}

/// Flowed to twice its length, turned, then stretched by a tenth more: mu dev(J^(-2/3) b) / J + K ln J / J of that tenth.
void ObjectStrainTest::stretchOnTopOfFlowIsElastic()
{
    const Block block;
    const double s = std::sqrt(0.5);
    const auto flow = [&](const Vec3& X) -> Vec3 { return Vec3(2 * X.x(), s * X.y(), s * X.z()); };
    RelaxedState relaxed = block.relaxedAt(Vec3(2, s, s).asDiagonal());
    Material material = rubber();
    material.yieldStress = 1e9;
    relaxed.materials.setOwn(material);
    const auto strains = objectStrains(block.aggregate, block.displacements([&](const Vec3& X) -> Vec3 {
        return turn(0.4) * Vec3(1.1, 1, 1).cwiseProduct(flow(X));
    }),
                                       relaxed);
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    const double mu = E / (2 * (1 + nu));
    const double deviator = mu * std::pow(1.1, -5.0 / 3) * (1.1 * 1.1 - 1) / 3;
    const double pressed = (lambda + 2 * mu / 3) * std::log(1.1) / 1.1;
    const Mat3 stress = Vec3(pressed + 2 * deviator, pressed - deviator, pressed - deviator).asDiagonal();
    QVERIFY(largestDifference(strains, &ObjectStrain::stress, turn(0.4) * stress * turn(0.4).transpose()) < 1e-4 * E);
}

void ObjectStrainTest::acrossACrackNothingCounts()
{
    const Block block;
    std::vector<BrokenConnection> broken;
    const auto isBeyond = [](const Vec3& X) { return X.x() > 0.0005; };
    for (std::uint32_t d = 0; d < Lattice::isotropicCount; ++d)
        for (ObjectIndex i = 0; i < block.aggregate.size(); ++i) {
            const Vec3 X = block.aggregate.lattice.position(i);
            if (block.aggregate.weight[d][i] > 0 &&
                isBeyond(X) != isBeyond(X + block.aggregate.lattice.direction(static_cast<int>(d))))
                broken.push_back({d, i});
        }
    const auto apart = block.displacements(
        [&](const Vec3& X) -> Vec3 { return isBeyond(X) ? Vec3(turn(0.9) * X + Vec3(0.03, 0, 0)) : X; });
    const auto strains = objectStrains(block.aggregate, apart, block.atRest(), broken);
    QVERIFY(largestDifference(strains, &ObjectStrain::strain, Mat3::Zero()) < 1e-12);
    QVERIFY(largestDifference(objectStrains(block.aggregate, apart, block.atRest()), &ObjectStrain::strain,
                              Mat3::Zero()) > 0.5);
}

/// A block all of whose connections are broken but those in a sheet, on a row, or none.
void ObjectStrainTest::sheetsAndLonelyObjectsStayFinite()
{
    const Block block;
    for (const int dimensions : {2, 1, 0}) {
        std::vector<BrokenConnection> broken;
        for (std::uint32_t d = 0; d < Lattice::isotropicCount; ++d) {
            const Vec3 step = block.aggregate.lattice.direction(static_cast<int>(d)) / block.aggregate.lattice.spacing;
            const bool isIn =
                (dimensions > 1 || std::abs(step.y()) < 0.5) && std::abs(step.z()) < 0.5 && dimensions > 0;
            for (ObjectIndex i = 0; i < block.aggregate.size(); ++i)
                if (!isIn && block.aggregate.weight[d][i] > 0)
                    broken.push_back({d, i});
        }
        const auto strains = objectStrains(block.aggregate, block.displacements([](const Vec3& X) -> Vec3 {
            return turn(0.8) * Vec3(1.25 * X.x(), 0.8 * X.y(), 1.1 * X.z());
        }),
                                           block.atRest(), broken);
        const Vec3 seen(dimensions > 0 ? std::log(1.25) : 0, dimensions > 1 ? std::log(0.8) : 0, 0);
        const Mat3 wanted = dimensions > 0 ? Mat3(turn(0.8) * seen.asDiagonal() * turn(0.8).transpose()) : Mat3::Zero();
        QVERIFY2(largestDifference(strains, &ObjectStrain::strain, wanted) < 1e-9,
                 qPrintable(QString::number(dimensions)));
    }
}

void ObjectStrainTest::materialsOfRegionsCount()
{
    const Block block;
    RelaxedState relaxed = block.atRest();
    Material harder = rubber();
    harder.youngsModulus = 3 * E;
    relaxed.materials.set({5}, harder);
    const auto strains = objectStrains(
        block.aggregate, block.displacements([](const Vec3& X) -> Vec3 { return Vec3(1.01, 1, 1).cwiseProduct(X); }),
        relaxed);
    QVERIFY((strains[5].stress - 3 * strains[6].stress).norm() < 1e-9 * E);
}

/// Stress times section is the force on the grips, inside of a bar pulled by a simulation.
void ObjectStrainTest::aPulledBarBearsItsForce()
{
    Material material = rubber();
    material.shapeDamping = 200;
    constexpr double spacing = 2e-3;
    Scene scene;
    scene.bodies.push_back(scenes::box({20, 6, 6}, spacing, material));
    const Aggregate& aggregate = *scene.bodies[0].aggregate;
    for (const double side : {-1.0, 1.0}) {
        const double end = side * 10 * spacing;
        scene.fixtures.push_back(
            {"grip", 0, objectsInBox(aggregate, Box(Vec3(end - spacing / 2, -1, -1), Vec3(end + spacing / 2, 1, 1))),
             Vec3(0.0004 * side, 0, 0)});
    }
    Simulation simulation(scene);
    while (simulation.health().ok && simulation.time() < 0.25)
        simulation.step();
    const auto shot = simulation.snapshot();
    const Snapshot::BodyState& body = shot->bodies[0];
    const auto strains = objectStrains(aggregate, body.displacements(), *body.relaxed);
    double sum = 0;
    int count = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (const Vec3 X = aggregate.lattice.position(i);
            std::abs(X.x()) < 4.1 * spacing && std::abs(X.y()) < 1.1 * spacing && std::abs(X.z()) < 1.1 * spacing) {
            sum += strains[i].stress(0, 0);
            ++count;
        }
    const double stretch =
        body.positions[objectsInBox(aggregate, Box(Vec3(4.5 * spacing, -1e-4, -1e-4), Vec3(5.5 * spacing, 1e-4, 1e-4)))
                           .front()]
            .x() /
        (5 * spacing);
    // Across, it gets thinner by Poisson's ratio.
    const double section = std::pow(6 * spacing * std::pow(stretch, -nu), 2);
    const double force = 0.5 * (std::abs(shot->fixtureForces[0].x()) + std::abs(shot->fixtureForces[1].x()));
    qInfo("stretch %.4f, stress %.4g Pa, force by section %.4g Pa", stretch, sum / count, force / section);
    QVERIFY(std::abs(sum / count / (force / section) - 1) < 0.03);
}

/// A bar pulled far beyond yield: with all of that elastic it would bear several times as much.
void ObjectStrainTest::flowingMaterialBearsItsYieldStress()
{
    Material material = rubber();
    constexpr double yieldStress = 4e4;
    material.yieldStress = yieldStress;
    material.hardening =
        3 * yieldStress; // more than the stress, or the bar would neck and bear its yield stress there only
    material.shapeDamping = 200;
    constexpr double spacing = 2e-3;
    Scene scene;
    scene.bodies.push_back(scenes::box({16, 4, 4}, spacing, material));
    const Aggregate& aggregate = *scene.bodies[0].aggregate;
    for (const double side : {-1.0, 1.0}) {
        const double end = side * 8 * spacing;
        scene.fixtures.push_back(
            {"grip", 0, objectsInBox(aggregate, Box(Vec3(end - spacing / 2, -1, -1), Vec3(end + spacing / 2, 1, 1))),
             Vec3(0.02 * side, 0, 0)});
    }
    Simulation simulation(scene);
    const auto before = simulation.snapshot();
    QVERIFY(!before->bodies[0].relaxed->hasFlowed());
    while (simulation.health().ok && simulation.time() < 0.2)
        simulation.step();
    const auto shot = simulation.snapshot();
    QVERIFY(shot->bodies[0].relaxed->hasFlowed());
    QVERIFY(!before->bodies[0].relaxed->hasFlowed());
    QCOMPARE(simulation.snapshot()->bodies[0].relaxed.get(), shot->bodies[0].relaxed.get());
    const std::vector<Vec3> moved = shot->bodies[0].displacements();
    const auto strains = objectStrains(aggregate, moved, *shot->bodies[0].relaxed);
    const ObjectStrains objects(aggregate, moved, *shot->bodies[0].relaxed);
    const Material flowing = material;
    material.yieldStress = 0;
    const auto asElastic =
        objectStrains(aggregate, moved, RelaxedState{.materials = MaterialMap(material, aggregate.size())});
    double borne = 0;
    double elastic = 0;
    double count = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (std::abs(aggregate.lattice.position(i).x()) < 4.1 * spacing) {
            const double here = vonMisesStress(strains[i].stress) / flowStress(flowing, objects.plasticStrain(i));
            QVERIFY(here < 1 + 1e-9);
            borne += here;
            elastic += vonMisesStress(asElastic[i].stress) / yieldStress;
            count += 1;
        }
    qInfo("of the flow stress borne %.3f, all elastic %.3f", borne / count, elastic / count);
    QVERIFY(borne / count > 0.95);
    QVERIFY(elastic > 4 * borne);
}

/// Of a bar that is pulled at its ends and free across: then there is no traction to take off its sides.
void ObjectStrainTest::fieldsOfTheSkinAreThoseOfTheMaterial()
{
    const Block block;
    // As narrow as makes the stress across zero.
    double low = 0.9;
    double high = 1;
    for (int i = 0; i < 60; ++i)
        (springStress((low + high) / 2, (low + high) / 2, 1.2) > 0 ? high : low) = (low + high) / 2;
    const double across = low;
    const auto moved =
        block.displacements([&](const Vec3& X) -> Vec3 { return Vec3(1.2 * X.x(), across * X.y(), across * X.z()); });
    const RelaxedState relaxed = block.atRest();
    const ObjectStrains objects(block.aggregate, moved, relaxed);
    const ObjectStrain inside = objects.of(0);
    const auto ends = objectsInBox(block.aggregate, Box(Vec3(-1, -1, -1), Vec3(-0.0099, 1, 1)));
    const TriangleMesh mesh = shapes::box({0.02, 0.014, 0.012});
    const StrainedSurface surface = strainedSurface(mesh, block.aggregate, objects, ends);
    QCOMPARE(surface.mesh.vertices, deformedSurface(mesh, block.aggregate, moved).vertices);
    QVERIFY(surface.mesh.vertices.size() > mesh.vertices.size());
    for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
        const Vec3& x = surface.mesh.vertices[v];
        const Vec3 way(x.x() / 6, x.y() * (1 - 1 / across), x.z() * (1 - 1 / across));
        QVERIFY((surface.fields.displacement[v] - way).norm() < 1e-8);
        QVERIFY(std::abs(static_cast<double>(surface.fields.strain[v]) - equivalentStrain(inside.strain)) < 1e-5);
        if (x.x() < 0.0119) // the high end is not held: nothing is borne there
            QVERIFY(std::abs(static_cast<double>(surface.fields.vonMisesStress[v]) / vonMisesStress(inside.stress) -
                             1) < 1e-4);
        QVERIFY(static_cast<double>(surface.fields.stressError[v]) < 1e-3 * vonMisesStress(inside.stress) ||
                std::abs(x.x()) > 0.0119);
    }
}

QTEST_APPLESS_MAIN(ObjectStrainTest)
#include "object_strain_test.moc"
