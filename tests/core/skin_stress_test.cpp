#include "support/thread_limit.h"

#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/geometry/refine.h"
#include "core/simulation/simulation.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/skin_stress.h"
#include "support/scenes.h"
#include "support/shapes.h"
#include "support/static_solver.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <numbers>

using namespace knead;

namespace {

constexpr double E = 2e6;
constexpr double nu = 0.3;

Material rubber(double poissonRatio = nu)
{
    Material material;
    material.youngsModulus = E;
    material.poissonRatio = poissonRatio;
    return material;
}

/// A body, its surface as fine as its lattice, and where a map takes it.
struct Specimen {
    std::shared_ptr<const Aggregate> aggregate;
    TriangleMesh mesh;
    SkinStress skin;
    RelaxedState relaxed;
    std::vector<Vec3> displacements;

    Specimen(const TriangleMesh& surface, double spacing, const Material& material = rubber())
        : aggregate(std::make_shared<const Aggregate>(fill(surface, {.spacing = spacing})))
        , mesh(refine(surface, spacing))
        , skin(*aggregate, mesh)
        , relaxed{.materials = MaterialMap(material, aggregate->size())}
        , displacements(aggregate->size(), Vec3::Zero())
    {
    }

    /// @param map of places at rest to displacements
    void move(const std::function<Vec3(const Vec3&)>& map)
    {
        for (ObjectIndex i = 0; i < aggregate->size(); ++i)
            displacements[i] = map(aggregate->lattice.position(i));
    }

    SkinStresses stresses(const std::vector<ObjectIndex>& loaded = {},
                          const std::vector<BrokenConnection>& broken = {}) const
    {
        return skin.stresses(ObjectStrains(*aggregate, displacements, relaxed, broken), loaded, true);
    }
};

/// What was found at points of a surface by what it should be.
struct Comparison {
    double least = 1e9;
    double most = -1e9;
    double error = 0; ///< estimated, the largest

    void add(double found, double wanted, double estimated)
    {
        least = std::min(least, found / wanted - 1);
        most = std::max(most, found / wanted - 1);
        error = std::max(error, estimated / wanted);
    }
    double worst() const { return std::max(-least, most); }
};

/// The middle of the top and the bottom of a bar along x that is bent about y to a curvature so small that all is linear.
Comparison bentBar(double cellsAcross, double curvature = 1e-4)
{
    constexpr double thickness = 0.01;
    Specimen bar(shapes::box({0.06, thickness, thickness}), thickness / cellsAcross);
    bar.move([&](const Vec3& X) {
        return Vec3(curvature * Vec3(-X.x() * X.z(), nu * X.y() * X.z(),
                                     0.5 * (X.x() * X.x() + nu * (X.z() * X.z() - X.y() * X.y()))));
    });
    const SkinStresses stresses = bar.stresses();
    Comparison comparison;
    for (std::size_t v = 0; v < bar.mesh.vertices.size(); ++v)
        if (const Vec3& X = bar.mesh.vertices[v]; std::abs(X.x()) < 0.015 && std::abs(X.z()) > 0.00499)
            comparison.add(static_cast<double>(stresses.vonMises[v]), E * curvature * thickness / 2,
                           static_cast<double>(stresses.error[v]));
    return comparison;
}

/// A square bar held at its low end and pressed down at its high end, between one and eight thicknesses from there.
Comparison cantilever(int cellsAcross)
{
    constexpr double thickness = 0.01;
    constexpr double length = 0.1;
    constexpr double force = 1e-4;
    Specimen bar(shapes::box({length, thickness, thickness}), thickness / cellsAcross);
    StaticBody body(bar.aggregate, rubber());
    body.loads.assign(body.size(), Vec3::Zero());
    double volume = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (body.place(i).x() < -length / 2 + 1e-9)
            body.prescribe(i, Vec3::Zero());
        if (body.place(i).x() > length / 2 - 1e-9)
            volume += bar.aggregate->volume[i];
    }
    for (std::size_t i = 0; i < body.size(); ++i)
        if (body.place(i).x() > length / 2 - 1e-9)
            body.loads[i].z() = -force * bar.aggregate->volume[i] / volume;
    body.solve();
    for (ObjectIndex i = 0; i < body.size(); ++i)
        bar.displacements[i] = body.displacement(i);
    const SkinStresses stresses = bar.stresses();
    Comparison comparison;
    for (std::size_t v = 0; v < bar.mesh.vertices.size(); ++v) {
        const Vec3& X = bar.mesh.vertices[v];
        const double arm = length / 2 - X.x();
        if (std::abs(X.z()) > thickness / 2 - 1e-9 && arm > thickness && arm < 8 * thickness)
            comparison.add(static_cast<double>(stresses.vonMises[v]), 6 * force * arm / std::pow(thickness, 3),
                           static_cast<double>(stresses.error[v]));
    }
    return comparison;
}

/// A rectangular plate in x and y with a round hole in its middle.
TriangleMesh plateWithHole(double radius, double halfLength, double halfWidth, double thickness)
{
    constexpr std::uint32_t around = 96; // a multiple of 8, so that there are rays to the corners of a square
    constexpr std::uint32_t rings = 10;
    std::vector<double> angles;
    const double corner = std::atan2(halfWidth, halfLength);
    for (std::uint32_t i = 0; i < around; ++i)
        angles.push_back(2 * std::numbers::pi * i / around);
    for (const double angle :
         {corner, std::numbers::pi - corner, std::numbers::pi + corner, 2 * std::numbers::pi - corner})
        angles.push_back(angle);
    std::sort(angles.begin(), angles.end());
    const auto count = static_cast<std::uint32_t>(angles.size());
    TriangleMesh mesh;
    for (const double z : {-thickness / 2, thickness / 2})
        for (std::uint32_t ring = 0; ring <= rings; ++ring)
            for (const double angle : angles) {
                const Vec3 way(std::cos(angle), std::sin(angle), 0);
                const double out = std::min(halfLength / std::max(std::abs(way.x()), 1e-12),
                                            halfWidth / std::max(std::abs(way.y()), 1e-12));
                const double share = std::pow(static_cast<double>(ring) / rings, 2);
                mesh.vertices.push_back((radius + share * (out - radius)) * way + Vec3(0, 0, z));
            }
    const auto at = [&](std::uint32_t side, std::uint32_t ring, std::uint32_t i) {
        return (side * (rings + 1) + ring) * count + i % count;
    };
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            quad(at(1, ring, i), at(1, ring + 1, i), at(1, ring + 1, i + 1), at(1, ring, i + 1));
            quad(at(0, ring, i), at(0, ring, i + 1), at(0, ring + 1, i + 1), at(0, ring + 1, i));
        }
        quad(at(0, 0, i), at(1, 0, i), at(1, 0, i + 1), at(0, 0, i + 1));
        quad(at(0, rings, i), at(0, rings, i + 1), at(1, rings, i + 1), at(1, rings, i));
    }
    return mesh;
}

} // namespace

class SkinStressTest : public QObject {
    Q_OBJECT

private slots:
    /// The strain of pure bending is linear: quadratic displacements, of which the map knows the gradient. One cell
    /// across does not determine it whole.
    void bendingIsReadAtTheSkin()
    {
        for (const double cells : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
            const Comparison bent = bentBar(cells);
            qInfo("%g cells across: %+.2g to %+.2g %%, estimated %.2g %%", cells, 100 * bent.least, 100 * bent.most,
                  100 * bent.error);
            QVERIFY(bent.worst() < (cells > 1 ? 1e-3 : 0.04));
            QVERIFY(bent.worst() < bent.error);
        }
    }

    void errorFallsWithTheResolution()
    {
        QVERIFY(bentBar(4).error < 0.6 * bentBar(2).error);
        QVERIFY(bentBar(8).error < 0.6 * bentBar(4).error);
        QVERIFY(bentBar(8).error < 0.1);
    }

    /// M c / I; what is left is how much too stiff the lattice is, besides.
    void cantileverBearsItsMoment()
    {
        const Comparison bar = cantilever(4);
        qInfo("4 cells across: %+.2g to %+.2g %%, estimated %.2g %%", 100 * bar.least, 100 * bar.most, 100 * bar.error);
        QVERIFY(bar.worst() < 0.1);
        QVERIFY(bar.worst() < bar.error);
    }

    /// Of a plate 12 radii wide that is pulled, with 8 cells across the hole. Heywood: the stress at the hole is
    /// 2 + (1 - d / w)^3 times that on the net section, 2.58 here; quadratic finite elements of this very plate, by CalculiX, say
    /// 2.60 in the middle of its thickness and 2.46 at its faces.
    void holeConcentratesStress_data()
    {
        QTest::addColumn<double>("cells"); // across the radius
        QTest::addColumn<double>("bound");
        QTest::newRow("8 across") << 4.0 << 0.1;
        QTest::newRow("8.22 across") << 4.11 << 0.1; // that the lattice does not divide
        QTest::newRow("10.44 across") << 5.22 << 0.1;
    }
    void holeConcentratesStress()
    {
        QFETCH(double, cells);
        QFETCH(double, bound);
        constexpr double radius = 0.004;
        const double spacing = radius / cells;
        const double halfWidth = std::round(6 * cells) * spacing;
        const double halfLength = std::round(7 * cells) * spacing;
        const double thickness = 2 * std::round(cells / 2) * spacing;
        constexpr double pull = 1e-6;
        Specimen plate(plateWithHole(radius, halfLength, halfWidth, thickness), spacing);
        StaticBody body(plate.aggregate, rubber());
        for (std::size_t i = 0; i < body.size(); ++i)
            if (std::abs(body.place(i).x()) > halfLength - 1e-9)
                body.prescribe(i, Vec3(std::copysign(pull, body.place(i).x()), 0, 0), Vec3::UnitX());
        body.solve(1e-6);
        const std::vector<Vec3> reactions = body.reactions();
        double force = 0;
        for (ObjectIndex i = 0; i < body.size(); ++i) {
            plate.displacements[i] = body.displacement(i);
            force += 0.5 * std::abs(body.place(i).x() > halfLength - 1e-9 || body.place(i).x() < -halfLength + 1e-9
                                        ? reactions[i].x()
                                        : 0);
        }
        const double factor = 2 + std::pow(1 - radius / halfWidth, 3);
        const double wanted = factor * force / (2 * (halfWidth - radius) * thickness);
        const SkinStresses stresses = plate.stresses();
        double most = 0;
        double estimated = 0;
        for (std::size_t v = 0; v < plate.mesh.vertices.size(); ++v)
            if (plate.mesh.vertices[v].head<2>().norm() < 2 * radius &&
                static_cast<double>(stresses.vonMises[v]) > most) {
                most = static_cast<double>(stresses.vonMises[v]);
                estimated = static_cast<double>(stresses.error[v]) / most;
            }
        qInfo("factor %.3f, wanted %.3f (%+.2g %%), estimated error %.2g %%, where largest %.2g %%",
              factor * most / wanted, factor, 100 * (most / wanted - 1), 100 * estimated, 100 * stresses.errorShare);
        QVERIFY(std::abs(most / wanted - 1) < bound);
        QVERIFY(std::abs(most / wanted - 1) < estimated);
        QVERIFY(stresses.errorShare > 0.5 * estimated && stresses.errorShare < 2 * estimated);
    }

    /// A bar that is pulled to 1.3 of its length: force by its section now, in the middle.
    void longStretchAgreesWithForceBySection_data()
    {
        QTest::addColumn<double>("poissonRatio");
        QTest::newRow("a quarter") << 0.25;
        QTest::newRow("nearly incompressible") << 0.45;
    }
    void longStretchAgreesWithForceBySection()
    {
        QFETCH(double, poissonRatio);
        constexpr double spacing = 2e-3;
        constexpr int cells = 12;
        Material material = rubber(poissonRatio);
        material.shapeDamping = 300;
        material.dampingRatio = 0.3;
        Scene scene;
        scene.bodies.push_back(scenes::box({cells, 5, 5}, spacing, material));
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const double end = 0.5 * cells * spacing;
        constexpr double duration = 0.2;
        for (const double side : {-1.0, 1.0})
            scene.fixtures.push_back({"grip", 0,
                                      objectsInBox(aggregate, Box(Vec3(side * end - spacing / 2, -1, -1),
                                                                  Vec3(side * end + spacing / 2, 1, 1))),
                                      Vec3(side * 0.15 * 2 * end / duration, 0, 0)});
        Simulation simulation(scene);
        while (simulation.health().ok && simulation.time() < duration)
            simulation.step();
        const auto shot = simulation.snapshot();
        const std::vector<Vec3> moved = shot->bodies[0].displacements();
        const TriangleMesh mesh = refine(shapes::box(spacing * Vec3(cells, 5, 5)), spacing);
        const ObjectStrains objects(aggregate, moved, *shot->bodies[0].relaxed);
        const StrainedSurface surface = strainedSurface(mesh, aggregate, objects, loadedObjects(*shot, 0));
        double width = 0; // of the middle now
        Comparison comparison;
        const double force = 0.5 * (std::abs(shot->fixtureForces[0].x()) + std::abs(shot->fixtureForces[1].x()));
        for (const Vec3& place : surface.mesh.vertices)
            if (std::abs(place.x()) < 0.1 * spacing)
                width = std::max(width, 2 * place.z());
        QVERIFY(width > 4 * spacing && width < 5 * spacing);
        for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v)
            if (std::abs(surface.mesh.vertices[v].x()) < 2.5 * spacing)
                comparison.add(static_cast<double>(surface.fields.vonMisesStress[v]), force / (width * width), 0);
        qInfo("stretch about %.3g, force by section %.4g Pa: %+.2g to %+.2g %%", 1.3, force / (width * width),
              100 * comparison.least, 100 * comparison.most);
        QVERIFY(comparison.worst() < 0.03);
    }

    /// A block of material that flows while a hard plate bends it: whatever was extrapolated, no more than it can bear.
    void afterFlowNoMoreIsBorneThanTheFlowStress()
    {
        constexpr double spacing = 2e-3;
        Material material = rubber(0.45);
        material.yieldStress = 2e4;
        material.hardening = 4e4;
        material.shapeDamping = 100;
        Scene scene = scenes::cantilever({14, 4, 4}, spacing, material, Vec3::Zero());
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        scene.fixtures.push_back(
            {"grip", 0, objectsInBox(aggregate, Box(Vec3(6.5 * spacing, -1, -1), Vec3(1, 1, 1))), Vec3(0, 0, -0.1)});
        Simulation simulation(scene);
        while (simulation.health().ok && simulation.time() < 0.1)
            simulation.step();
        const auto shot = simulation.snapshot();
        const RelaxedState& relaxed = *shot->bodies[0].relaxed;
        QVERIFY(relaxed.hasFlowed());
        const std::vector<Vec3> moved = shot->bodies[0].displacements();
        const ObjectStrains objects(aggregate, moved, relaxed);
        double hardest = 0;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const double plastic = objects.plasticStrain(i);
            hardest = std::max(hardest, plastic);
            QVERIFY(vonMisesStress(objects.of(i).stress) < (1 + 1e-6) * flowStress(material, plastic));
        }
        const SkinStresses stresses =
            SkinStress(aggregate, refine(shapes::box(spacing * Vec3(14, 4, 4)), spacing)).stresses(objects, {}, true);
        const double most = static_cast<double>(*std::max_element(stresses.vonMises.begin(), stresses.vonMises.end()));
        qInfo("plastic strain up to %.3g, flow stress %.4g Pa, at the skin up to %.4g Pa", hardest,
              flowStress(material, hardest), most);
        QVERIFY(hardest > 0.05);
        QVERIFY(most > material.yieldStress && most < 1.1 * flowStress(material, hardest));
    }

    /// Squeezed along x between plates. Were nothing known of them, the ends would bear what it takes to widen them so much.
    void whatIsPressedKeepsItsTraction()
    {
        constexpr double squeeze = 1e-3;
        Specimen block(shapes::box({0.012, 0.012, 0.012}), 0.002);
        block.move([&](const Vec3& X) { return Vec3(squeeze * Vec3(-X.x(), nu * X.y(), nu * X.z())); });
        std::vector<ObjectIndex> ends = objectsInBox(*block.aggregate, Box(Vec3(-1, -1, -1), Vec3(-0.0059, 1, 1)));
        const auto others = objectsInBox(*block.aggregate, Box(Vec3(0.0059, -1, -1), Vec3(1, 1, 1)));
        ends.insert(ends.end(), others.begin(), others.end());
        const SkinStresses known = block.stresses(ends);
        const SkinStresses unknown = block.stresses();
        int faces = 0;
        for (std::size_t v = 0; v < block.mesh.vertices.size(); ++v) {
            const Vec3& X = block.mesh.vertices[v];
            QVERIFY(std::abs(static_cast<double>(known.vonMises[v]) / (E * squeeze) - 1) < 0.01);
            if (std::abs(X.x()) > 0.0059 && X.tail<2>().cwiseAbs().maxCoeff() < 0.0059) {
                ++faces;
                QVERIFY(std::abs(static_cast<double>(unknown.vonMises[v]) / (E * squeeze) - nu / (1 - nu)) < 0.01);
            }
        }
        QVERIFY(faces > 10);
    }

    /// Two halves that were torn apart and stretched alike: F does not see the gap between them.
    void acrossACrackNothingIsStretched()
    {
        constexpr double stretch = 1e-3;
        Specimen bar(shapes::box({0.024, 0.012, 0.012}), 0.002);
        const Lattice& lattice = bar.aggregate->lattice;
        std::vector<BrokenConnection> broken;
        for (std::uint32_t d = 0; d < Lattice::isotropicCount; ++d)
            for (const Lattice::Segment& segment : lattice.segments[d])
                for (ObjectIndex i = segment.begin; i < segment.end; ++i)
                    if (bar.aggregate->weight[d][i] > 0 &&
                        (lattice.position(i).x() < 0.001) !=
                            (lattice.position(i + static_cast<ObjectIndex>(segment.offset)).x() < 0.001))
                        broken.push_back({d, i});
        bar.move([&](const Vec3& X) {
            return Vec3(stretch * Vec3(X.x(), -nu * X.y(), -nu * X.z()) + Vec3(X.x() > 0.001 ? 0.01 : 0, 0, 0));
        });
        const SkinStresses whole = bar.stresses();
        const SkinStresses torn = bar.stresses({}, broken);
        double most = 0;
        for (std::size_t v = 0; v < bar.mesh.vertices.size(); ++v)
            if (std::abs(bar.mesh.vertices[v].x()) < 0.0119) {
                most = std::max(most, static_cast<double>(whole.vonMises[v]));
                QVERIFY(std::abs(static_cast<double>(torn.vonMises[v]) / (E * stretch) - 1) < 0.02);
            }
        QVERIFY(most > 100 * E * stretch);
    }

    /// Half a cell thick: no quadratic is determined across it.
    void wallThinnerThanACellIsRead()
    {
        Specimen sheet(shapes::box({0.03, 0.02, 0.0011}), 0.002);
        constexpr double stretch = 1e-3;
        sheet.move([&](const Vec3& X) { return Vec3(stretch * Vec3(X.x(), -nu * X.y(), -nu * X.z())); });
        const SkinStresses stresses = sheet.stresses();
        for (std::size_t v = 0; v < sheet.mesh.vertices.size(); ++v)
            if (std::abs(sheet.mesh.vertices[v].x()) < 0.0149)
                QVERIFY(std::abs(static_cast<double>(stresses.vonMises[v]) / (E * stretch) - 1) < 0.05);
    }

    /// They say no gradient across them: there the stress is that of the body's objects.
    void whereObjectsLieInAPlaneTheStressIsTheirs()
    {
        Specimen block(shapes::box({0.012, 0.012, 0.012}), 0.002);
        constexpr double stretch = 1e-3;
        block.move([&](const Vec3& X) { return Vec3(stretch * Vec3(X.x(), -nu * X.y(), -nu * X.z())); });
        const auto plane = objectsInBox(*block.aggregate, Box(Vec3(-1, -1, -1e-4), Vec3(1, 1, 1e-4)));
        const Aggregate piece =
            extract(*block.aggregate, plane, std::vector<std::uint16_t>(block.aggregate->size(), 0));
        const std::vector<Vec3> points{Vec3(0.0003, 0.0004, 0), Vec3(0.001, -0.002, 0.0005)};
        const SkinStress skin(piece, points, std::vector<FreeSurface>(points.size()), plane);
        const ObjectStrains objects(*block.aggregate, block.displacements, block.relaxed);
        for (const float stress : skin.stresses(objects, {}, false).vonMises)
            QVERIFY(std::abs(static_cast<double>(stress) / (E * stretch) - 1) < 0.01);
    }

    /// Bent by 40 degrees and turned by 90: strain and stress stay as they were.
    void turningChangesNothing()
    {
        Specimen bar(shapes::box({0.06, 0.01, 0.01}), 0.0025);
        const auto bent = [](const Vec3& X) {
            const double angle = 12 * X.x();
            const double radius = 1 / 12.0 - X.z();
            return Vec3(radius * std::sin(angle), X.y(), 1 / 12.0 - radius * std::cos(angle));
        };
        bar.move([&](const Vec3& X) { return Vec3(bent(X) - X); });
        const SkinStresses before = bar.stresses();
        const Mat3 turn = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3(1, 1, 0.3).normalized()).toRotationMatrix();
        bar.move([&](const Vec3& X) { return Vec3(turn * bent(X) + Vec3(0.5, -0.2, 0.1) - X); });
        const SkinStresses after = bar.stresses();
        for (std::size_t v = 0; v < bar.mesh.vertices.size(); ++v)
            QVERIFY(std::abs(static_cast<double>(after.vonMises[v] - before.vonMises[v])) < 1e-5 * E);
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        const auto bent = [](int threads) {
            return onThreads(threads, [] {
                Specimen bar(shapes::box({0.06, 0.01, 0.01}), 0.001);
                bar.move([](const Vec3& X) { return Vec3(3 * Vec3(-X.x() * X.z(), 0, 0.5 * X.x() * X.x())); });
                return bar.stresses();
            });
        };
        const SkinStresses one = bent(1);
        const SkinStresses four = bent(4);
        QCOMPARE(one.vonMises, four.vonMises);
        QCOMPARE(one.error, four.error);
        QCOMPARE(one.errorShare, four.errorShare);
    }
};

QTEST_APPLESS_MAIN(SkinStressTest)
#include "skin_stress_test.moc"
