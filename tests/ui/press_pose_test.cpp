#include "core/session/press_pose.h"

#include "core/geometry/triangle_mesh.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

Quaternion random(int seed)
{
    const Vec3 axis(std::sin(1.0 + seed), std::cos(3.0 * seed), std::sin(0.3 + 2 * seed));
    return Quaternion(Eigen::AngleAxisd(0.7 * seed, axis.normalized()));
}

/// Least distance of points of the surface of a tool from a plane, along its normal.
double lowest(const ToolShape& shape, const Pose& pose, const Vec3& place, const Vec3& normal)
{
    double low = 1e9;
    constexpr int steps = 24;
    const Vec3 half = 0.5 * shape.size;
    const auto look = [&](const Vec3& point) {
        low = std::min(low, (pose.position + pose.rotation * point - place).dot(normal));
    };
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k <= steps; ++k) {
            const double around = 2 * std::numbers::pi * i / steps;
            const double up = std::numbers::pi * (1.0 * k / steps - 0.5);
            if (shape.kind == ToolKind::ball)
                look(half.x() * Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)));
            else if (shape.kind == ToolKind::cylinder)
                look(Vec3(half.x() * std::cos(around), half.x() * std::sin(around), (k % 2 == 0 ? 1 : -1) * half.z()));
            else if (shape.kind == ToolKind::wedge)
                look(Vec3((i % 2 == 0 ? 1 : -1) * half.x(), k % 3 == 0 ? 0 : (k % 3 == 1 ? half.y() : -half.y()),
                          k % 3 == 0 ? -half.z() : half.z()));
            else
                look(Vec3((i % 2 == 0 ? 1 : -1) * half.x(), (k % 2 == 0 ? 1 : -1) * half.y(),
                          (k / 2 % 2 == 0 ? 1 : -1) * half.z()));
        }
    return low;
}

} // namespace

class PressPoseTest : public QObject {
    Q_OBJECT

private slots:
    void comesStraightOntoThePlace_data()
    {
        QTest::addColumn<ToolKind>("kind");
        for (const ToolKind kind : toolKinds)
            if (kind != ToolKind::part)
                QTest::newRow(std::string(nameOf(kind)).c_str()) << kind;
    }
    void comesStraightOntoThePlace()
    {
        QFETCH(ToolKind, kind);
        const ToolShape shape{kind, fittingSize(kind, Vec3(0.02, 0.013, 0.03), nullptr), nullptr};
        const Vec3 place(0.1, -0.2, 0.05);
        for (int seed = 0; seed < 20; ++seed) {
            const Vec3 normal = random(seed + 50) * Vec3::UnitZ();
            const PressPoses poses = pressPoses(shape, random(seed), place, normal, 1e-3);
            QVERIFY(std::abs(poses.away.rotation.norm() - 1) < 1e-12);
            QVERIFY(poses.away.rotation.angularDistance(poses.deep.rotation) < 1e-12);
            // Its lowest points are as far from the place as was asked for.
            const double low = lowest(shape, poses.away, place, normal);
            QVERIFY2(low > 1e-3 - 1e-9 && low < 1.3e-3, qPrintable(QString::number(low)));
            const Vec3 way = poses.deep.position - poses.away.position;
            QVERIFY(way.cross(normal).norm() < 1e-12 && way.dot(normal) < -0.01);
            QVERIFY((poses.away.position - place).cross(normal).norm() < 1e-12);
        }
    }

    /// No more than it takes.
    void isTurnedTheLeast()
    {
        const Vec3 up = Vec3::UnitZ();
        const Quaternion tilted(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
        const auto turnOf = [&](ToolKind kind, const Quaternion& rotation) {
            const ToolShape shape{kind, fittingSize(kind, Vec3(0.02, 0.013, 0.03), nullptr), nullptr};
            return pressPoses(shape, rotation, Vec3::Zero(), up, 0).away.rotation.angularDistance(rotation);
        };
        QVERIFY(std::abs(turnOf(ToolKind::box, tilted) - 0.3) < 1e-9);
        QVERIFY(turnOf(ToolKind::ball, tilted) < 1e-12);
        const Quaternion lying(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()));
        QVERIFY(turnOf(ToolKind::cylinder, lying) < 1e-9);
        QVERIFY(std::abs(turnOf(ToolKind::cylinder, tilted * lying) - 0.3) < 1e-9);
        QVERIFY(std::abs(turnOf(ToolKind::cylinder, tilted) - 0.3) < 1e-9); // it stands
        QVERIFY(std::abs(turnOf(ToolKind::plate, lying) - 0.5 * std::numbers::pi) < 1e-9);
        // A wedge comes with its edge, even when that looked up.
        const Quaternion over(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()));
        QVERIFY(std::abs(turnOf(ToolKind::wedge, over) - std::numbers::pi) < 1e-9);
    }

    void partsReachAsFarAsTheirVertices()
    {
        TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {0.04, 0, 0}, {0, 0.04, 0}, {0, 0, 0.04}};
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        const auto part = std::make_shared<const ToolPart>(std::move(mesh));
        const PressPoses poses =
            pressPoses({ToolKind::part, part->size(), part}, Quaternion::Identity(), Vec3::Zero(), Vec3::UnitX(), 2e-3);
        QVERIFY((poses.away.position - Vec3(0.022, 0, 0)).norm() < 1e-12);
        QVERIFY((poses.deep.position - Vec3(-0.02, 0, 0)).norm() < 1e-12);
    }

    /// Beside an edge the other side does not count, nor what is far away.
    void theNormalIsTheMeanOfThatSide()
    {
        // Two triangles that lean towards x by the same angle to either side, one that is the other side, one far away.
        const std::vector<float> points{0,  0, 0,    1, 0, 0.5F, 1, 1, 0.5F, 0, 1, 0,
                                        -1, 0, 0.5F, 9, 0, 0,    9, 0, 1,    9, 1, 0};
        const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 3}, {0, 3, 4}, {0, 3, 1}, {5, 6, 7}};
        const Vec3 place(0.05, 0.3, 0.02);
        const SurfaceSpot both = surfaceSpot(triangles, points, 0, place, 2);
        QCOMPARE(both.place, place);
        QVERIFY((both.normal - Vec3::UnitZ()).norm() < 1e-6);
        QVERIFY2((both.level - Vec3(0, 4.0 / 9, 1.0 / 6)).norm() < 0.2, "between the middles of the two");
        const Vec3 alone = surfaceSpot(triangles, points, 0, Vec3(0.4, 0.3, 0.2), 0.2).normal;
        QVERIFY((alone - Vec3(-0.5, 0, 1).normalized()).norm() < 1e-6);
        const Vec3 other = surfaceSpot(triangles, points, 2, place, 2).normal;
        QVERIFY((other + Vec3(-0.5, 0, 1).normalized()).norm() < 1e-6);
    }

    void aThumbIsAsStrongAsTheMaterial()
    {
        const double radius = 5e-3;
        Material material{.density = 1000, .youngsModulus = 1e6, .poissonRatio = 0.3};
        const double elastic = thumbForce(material, radius);
        const double depth = radius / 3;
        QVERIFY(std::abs(elastic / (4.0 / 3 * 1e6 / (1 - 0.09) * std::sqrt(radius) * std::pow(depth, 1.5)) - 1) < 1e-9);
        material.yieldStress = 1e4;
        const double flows = thumbForce(material, radius);
        const double rim = std::sqrt(radius * radius - (radius - depth) * (radius - depth));
        QVERIFY(std::abs(flows / (2.8e4 * std::numbers::pi * rim * rim) - 1) < 1e-9);
        material.yieldStress = 1e9; // it gives elastically long before
        QCOMPARE(thumbForce(material, radius), elastic);
    }
};

QTEST_GUILESS_MAIN(PressPoseTest)
#include "press_pose_test.moc"
