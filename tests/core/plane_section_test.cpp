#include "core/geometry/plane_section.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

PlaneSection cut(const TriangleMesh& mesh, const CutPlane& plane)
{
    return planeSection(mesh.vertices, mesh.triangles, plane);
}

bool isNear(double value, double wanted, double share = 1e-9)
{
    return std::abs(value - wanted) <= share * std::abs(wanted);
}

/// Corners in the plane, triangles facing along its normal, the outline closed.
bool isSound(const PlaneSection& section, const CutPlane& plane)
{
    for (const Vec3& point : section.points)
        if (std::abs(plane.distance(point)) > 1e-12)
            return false;
    for (const auto& t : section.triangles) {
        const Vec3 normal =
            (section.points[t[1]] - section.points[t[0]]).cross(section.points[t[2]] - section.points[t[0]]);
        if (normal.dot(plane.normal) < -1e-15)
            return false;
    }
    std::vector<int> ends(section.points.size(), 0);
    for (const auto& side : section.outline) {
        ++ends[side[0]];
        --ends[side[1]];
    }
    return std::all_of(ends.begin(), ends.end(), [](int end) { return end == 0; });
}

const CutPlane tilted{Vec3(1, 2, 3).normalized(), 0.0004};

} // namespace

class PlaneSectionTest : public QObject {
    Q_OBJECT

private slots:
    void aBoxGivesARectangle()
    {
        const TriangleMesh box = shapes::box({0.04, 0.01, 0.02});
        for (const CutPlane& plane :
             {CutPlane{Vec3::UnitX(), 0.003}, CutPlane{-Vec3::UnitX(), -0.003}, CutPlane{Vec3::UnitX(), 0}}) {
            const PlaneSection section = cut(box, plane);
            QVERIFY(isSound(section, plane));
            QCOMPARE(section.points.size(), std::size_t{4});
            QVERIFY(isNear(section.area(), 0.01 * 0.02));
        }
    }

    /// The length of a slanted cut grows with one over the cosine.
    void aSlantedCutOfABarIsLonger()
    {
        const TriangleMesh bar = shapes::box({0.1, 0.01, 0.02});
        const CutPlane plane{Vec3(std::cos(0.6), std::sin(0.6), 0), 0.002};
        const PlaneSection section = cut(bar, plane);
        QVERIFY(isSound(section, plane));
        QVERIFY(isNear(section.area(), 0.01 * 0.02 / std::cos(0.6)));
    }

    void aVoidIsAHole()
    {
        const TriangleMesh hollow = shapes::hollowBox({0.04, 0.03, 0.02}, {0.02, 0.01, 0.012});
        const CutPlane plane{Vec3::UnitZ(), 0.001};
        const PlaneSection section = cut(hollow, plane);
        QVERIFY(isSound(section, plane));
        QVERIFY(isNear(section.area(), 0.04 * 0.03 - 0.02 * 0.01));
        QVERIFY(isNear(cut(hollow, {Vec3::UnitZ(), 0.008}).area(), 0.04 * 0.03));
    }

    /// Polygons of so many corners instead of circles.
    void aTorusGivesTwoDisksOrARing()
    {
        constexpr int around = 120;
        const TriangleMesh torus = shapes::torus(0.03, 0.01, around, around);
        const double polygon = 0.5 * around * std::sin(2 * std::numbers::pi / around);
        const CutPlane across{Vec3::UnitY(), 0};
        const PlaneSection disks = cut(torus, across);
        QVERIFY(isSound(disks, across));
        QVERIFY(isNear(disks.area(), 2 * polygon * 1e-4, 1e-6));
        const CutPlane flat{Vec3::UnitZ(), 1e-7};
        const PlaneSection ring = cut(torus, flat);
        QVERIFY(isSound(ring, flat));
        QVERIFY(isNear(ring.area(), polygon * (0.04 * 0.04 - 0.02 * 0.02), 1e-4));
    }

    void anIslandInAHoleIsMaterial()
    {
        const TriangleMesh nested = shapes::together(shapes::hollowBox({0.04, 0.04, 0.04}, {0.03, 0.03, 0.03}),
                                                     shapes::hollowBox({0.02, 0.02, 0.02}, {0.01, 0.01, 0.01}));
        const PlaneSection section = cut(nested, {Vec3::UnitX(), 0.001});
        QVERIFY(isNear(section.area(), 1.6e-3 - 9e-4 + 4e-4 - 1e-4));
    }

    /// Vertices, edges and faces in the plane neither tear loops nor count twice.
    void aPlaneThroughVerticesIsNoTrouble()
    {
        const TriangleMesh sphere = shapes::sphere(0.01, 64);
        double equator = 0;
        for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
            const PlaneSection section = cut(sphere, {normal, 0});
            QVERIFY(isSound(section, {normal, 0}));
            equator = std::max(equator, section.area());
            QVERIFY(isNear(section.area(), std::numbers::pi * 1e-4, 0.01));
        }
        const TriangleMesh box = shapes::box({0.02, 0.02, 0.02});
        QVERIFY(isNear(cut(box, {Vec3::UnitX(), 0.01}).area(), 4e-4)); // the far face, at most once
        QCOMPARE(cut(box, {Vec3::UnitX(), -0.01}).area(), 0.0);        // all of it is cut off
    }

    void nothingIsCutOutside()
    {
        const PlaneSection section = cut(shapes::box({0.02, 0.02, 0.02}), {Vec3::UnitX(), 0.02});
        QVERIFY(section.points.empty() && section.triangles.empty() && section.outline.empty());
    }

    /// Volume is the integral of the area over the way of the plane.
    void areasAddUpToTheVolume()
    {
        const TriangleMesh sphere = shapes::moved(shapes::sphere(0.01, 96), shapes::tilt(0.7, {0.002, 0, -0.001}));
        double volume = 0;
        constexpr int slices = 400;
        constexpr double step = 0.03 / slices;
        for (int i = 0; i < slices; ++i)
            volume += step * cut(sphere, {tilted.normal, -0.015 + (i + 0.5) * step}).area();
        QVERIFY(isNear(volume, 4.0 / 3 * std::numbers::pi * 1e-6, 0.01));
    }

    void cornersOfFlatFacesAreLeftOut()
    {
        TriangleMesh mesh = shapes::closedGrid(4, 200, [](double a, double b) {
            const Vec2 corner(std::cos(a), std::sin(a));
            return Vec3((3 + std::cos(b)) * corner.x(), (3 + std::cos(b)) * corner.y(), std::sin(b));
        });
        const CutPlane plane{Vec3::UnitZ(), 0.3};
        const PlaneSection whole = planeSection(mesh.vertices, mesh.triangles, plane);
        QCOMPARE(whole.points.size(), std::size_t{8}); // a square ring
        QVERIFY(isSound(whole, plane));
    }

    void framesAreRightHanded()
    {
        for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitZ()), Vec3(tilted.normal)}) {
            const Mat3 frame = frameOf({normal, 1});
            QVERIFY((frame.transpose() * frame - Mat3::Identity()).norm() < 1e-12);
            QVERIFY(std::abs(frame.determinant() - 1) < 1e-12);
            QVERIFY((frame.col(2) - normal).norm() < 1e-12);
        }
    }

private:
    using Vec2 = Eigen::Vector2d;
};

QTEST_APPLESS_MAIN(PlaneSectionTest)
#include "plane_section_test.moc"
