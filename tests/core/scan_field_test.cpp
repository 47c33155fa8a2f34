#include "core/deformation/field_map.h"
#include "core/deformation/scan_field.h"
#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"
#include "support/shapes.h"

#include <QtTest>

#include <random>

using namespace knead;

namespace {

/// An L of unequal legs: it looks otherwise however it is turned.
TriangleMesh partOnTest()
{
    TriangleMesh mesh = shapes::bracket(0.08, 0.02, 0.03);
    for (Vec3& vertex : mesh.vertices)
        vertex.x() *= 0.6;
    return mesh;
}

Vec3 warp(const Vec3& p)
{
    return {2e-3 * std::sin(30 * p.y()), 0, 0.1 * p.y() * p.y()};
}

/// As a scanner sees the warped part: fine triangles, noise along each axis.
TriangleMesh scanned(double noise)
{
    TriangleMesh scan = refine(partOnTest(), 0.0025);
    std::minstd_rand random(3);
    const auto chance = [&] { return noise * (2.0 * static_cast<double>(random() % 100003) / 100003 - 1); };
    for (Vec3& vertex : scan.vertices)
        vertex += warp(vertex) + Vec3(chance(), chance(), chance());
    return scan;
}

/// How far the part, deformed by the field, is from a surface at most: at vertices of fine triangles.
double deviation(const DisplacementField& field, const TriangleMesh& from)
{
    const auto map = fieldMap({.field = std::make_shared<const DisplacementField>(field)});
    const SurfaceDistance surface(from);
    const TriangleMesh fine = refine(partOnTest(), 0.003);
    std::vector<Vec3> places(fine.vertices.size());
    map->evaluate(fine.vertices, places);
    double worst = 0;
    for (const Vec3& place : places)
        worst = std::max(worst, surface.nearest(place).distance);
    return worst;
}

constexpr std::size_t fewSamples = 5000;

} // namespace

class ScanFieldTest : public QObject {
    Q_OBJECT

private slots:
    void warpedPartIsFoundFromItsScan()
    {
        const TriangleMesh scan = scanned(0);
        const ScanField found = scanField(scan, partOnTest(), {.samples = fewSamples, .staysInPlace = true});
        QVERIFY(found.toPart.position.isZero());
        QVERIFY(found.outliers < found.samples / 50);
        const double off = deviation(found.field, scan);
        qInfo("off by %.3g mm of 2.3 mm", 1e3 * off);
        QVERIFY(off < 2e-4);
    }

    void farMotionsOfSlenderPartsAreFound_data()
    {
        QTest::addColumn<double>("angle"); // of a bend [rad]; 0: it sags
        QTest::newRow("sags") << 0.0;
        QTest::newRow("10 degrees") << 0.1745;
        QTest::newRow("20 degrees") << 0.349;
    }
    /// By more than the bar is thick: neither folded nor stuck at the end, where the face looks along the bar.
    void farMotionsOfSlenderPartsAreFound()
    {
        QFETCH(double, angle);
        const Vec3 size(0.16, 0.02, 0.02);
        const TriangleMesh part =
            refine(shapes::moved(shapes::box(size), {Vec3(size / 2), Quaternion::Identity()}), 0.006);
        const auto displaced = [&](const Vec3& p) -> Vec3 {
            if (angle == 0)
                return p + Vec3(0, 0, 0.0096 * std::pow(p.x() / size.x(), 2));
            const double radius = size.x() / angle;
            const double r = radius - (p.z() - size.z() / 2);
            const double turned = p.x() / radius;
            return {r * std::sin(turned), p.y(), radius - r * std::cos(turned) + size.z() / 2};
        };
        TriangleMesh scan = part;
        for (Vec3& vertex : scan.vertices)
            vertex = displaced(vertex);
        const ScanField found = scanField(scan, part, {.samples = fewSamples, .staysInPlace = true});
        QVERIFY2(found.outliers < found.samples / 50, qPrintable(QString::number(found.outliers)));
        const auto map = fieldMap({.field = std::make_shared<const DisplacementField>(found.field)});
        const Vec3 end(size.x(), size.y() / 2, size.z() / 2);
        const double motion = (displaced(end) - end).norm();
        QVERIFY((map->at(end) - displaced(end)).norm() < 0.05 * motion);
        const SurfaceDistance surface(scan);
        for (const Vec3& vertex : part.vertices) {
            const double off = surface.nearest(map->at(vertex)).distance;
            QVERIFY2(off < 0.05 * motion, qPrintable(QString::number(off))); // most at corners
            QVERIFY(map->gradient(vertex).determinant() > 0);
        }
    }

    void scanIsLaidOnThePartHoweverItLies()
    {
        const TriangleMesh part = partOnTest();
        for (const double angle : {0.05, 1.0, 3.0}) {
            const Pose pose = shapes::tilt(angle, Vec3(0.3, -0.2, 0.5) * angle);
            const ScanField found = scanField(shapes::moved(refine(part, 0.005), pose), part, {.samples = 1000});
            QVERIFY(found.outliers <= found.samples / 100); // such as points on edges
            for (const Vec3& vertex : part.vertices)
                QVERIFY((found.toPart.toWorld(pose.toWorld(vertex)) - vertex).norm() < 1e-6);
            for (const Vec3& displacement : found.field.displacements)
                QVERIFY(displacement.norm() < 1e-6);
            QVERIFY(!found.remarks.empty());
        }
    }

    void noiseAndHolesAreCopedWith()
    {
        const double noise = 1e-4;
        TriangleMesh scan = scanned(noise);
        const Vec3 hole(0.024, 0.01, 0.03);
        std::erase_if(scan.triangles,
                      [&](const TriangleMesh::Triangle& t) { return (scan.vertices[t[0]] - hole).norm() < 0.008; });
        scan.faceOfTriangle.clear();
        // Dust above the part.
        scan = shapes::together(scan, shapes::moved(shapes::box(Vec3(0.003, 0.003, 0.003)),
                                                    {Vec3(0.006, 0.06, 0.0345), Quaternion::Identity()}));
        const ScanField found = scanField(scan, partOnTest(), {.samples = fewSamples, .staysInPlace = true});
        QVERIFY(found.outliers > 10 && found.outliers < found.samples / 10);
        QVERIFY(!found.remarks.empty());
        QVERIFY(deviation(found.field, scanned(0)) < 4e-4);
    }

    void scanOfSomethingElseIsRefused()
    {
        QVERIFY_THROWS_EXCEPTION(Problem, scanField(shapes::box(Vec3(2, 0.1, 0.1)), partOnTest(), {.samples = 500}));
        QVERIFY_THROWS_EXCEPTION(Problem, scanField({}, partOnTest()));
        TriangleMesh flat = shapes::box(Vec3(1, 1, 1));
        for (Vec3& vertex : flat.vertices)
            vertex.setZero();
        QVERIFY_THROWS_EXCEPTION(Problem, scanField(flat, partOnTest()));
    }
};

QTEST_GUILESS_MAIN(ScanFieldTest)
#include "scan_field_test.moc"
