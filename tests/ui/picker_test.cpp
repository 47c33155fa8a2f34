#include "ui/viewport/picker.h"

#include <QElapsedTimer>
#include <QtTest>

#include <cmath>
#include <random>

using namespace knead;

namespace {

/// A wavy sheet over the unit square, one CAD face per quarter.
TriangleMesh sheet(std::uint32_t cells)
{
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const double x = static_cast<double>(i) / cells;
            const double y = static_cast<double>(j) / cells;
            mesh.vertices.emplace_back(x, y, 0.1 * std::sin(9 * x) * std::cos(7 * y));
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i;
            const std::uint32_t face = (i < cells / 2 ? 0U : 1U) + (j < cells / 2 ? 0U : 2U);
            for (const auto& triangle : {TriangleMesh::Triangle{a, a + 1, a + cells + 2},
                                         TriangleMesh::Triangle{a, a + cells + 2, a + cells + 1}}) {
                mesh.triangles.push_back(triangle);
                mesh.faceOfTriangle.push_back(face);
            }
        }
    return mesh;
}

struct Drawn {
    TriangleMesh mesh;
    RenderMesh render;
    std::vector<float> points;

    explicit Drawn(std::uint32_t cells)
        : mesh(sheet(cells))
        , render(renderMesh(mesh))
        , points(renderPoints(render, mesh.vertices))
    {
    }
};

/// Every triangle, one after the other, by volumes of tetrahedra: another formula than the picker's.
std::optional<double> bruteForce(const Drawn& drawn, const Ray& ray)
{
    std::optional<double> best;
    for (const auto& t : drawn.render.triangles) {
        const auto at = [&](std::uint32_t v) -> Vec3 {
            return Eigen::Map<const Eigen::Vector3f>(drawn.points.data() + 3 * v).cast<double>();
        };
        const Vec3 a = at(t[0]) - ray.origin;
        const Vec3 b = at(t[1]) - ray.origin;
        const Vec3 c = at(t[2]) - ray.origin;
        const double u = ray.direction.dot(b.cross(c));
        const double v = ray.direction.dot(c.cross(a));
        const double w = ray.direction.dot(a.cross(b));
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0)
            continue;
        const double distance = (u * a + v * b + w * c).dot(ray.direction) / (u + v + w);
        if (distance >= 0 && (!best || distance < *best))
            best = distance;
    }
    return best;
}

} // namespace

class PickerTest : public QObject {
    Q_OBJECT
private slots:
    void picksWhatBruteForcePicks()
    {
        const Drawn drawn(40);
        const SurfacePicker picker(drawn.render, drawn.points);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(-0.3, 1.3);
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec3 from(unit(random), unit(random), 1);
            const Vec3 to(unit(random), unit(random), 0);
            const Ray ray{from, (to - from).normalized()};
            const std::optional<SurfaceHit> hit = picker.pick(ray);
            const std::optional<double> expected = bruteForce(drawn, ray);
            QCOMPARE(hit.has_value(), expected.has_value());
            if (hit) {
                ++hits;
                QVERIFY(std::abs(hit->distance - *expected) < 1e-9);
            }
        }
        QVERIFY(hits > 50);
    }

    void theFaceUnderTheRayIsNamed()
    {
        const Drawn drawn(10);
        const SurfacePicker picker(drawn.render, drawn.points);
        const auto faceAt = [&](double x, double y) { return picker.pick({Vec3(x, y, 1), -Vec3::UnitZ()})->face; };
        QCOMPARE(faceAt(0.2, 0.2), 0U);
        QCOMPARE(faceAt(0.8, 0.2), 1U);
        QCOMPARE(faceAt(0.2, 0.8), 2U);
        QCOMPARE(faceAt(0.8, 0.8), 3U);
    }

    void whatAPlaneCutsOffIsNotMet()
    {
        const Drawn drawn(10);
        const SurfacePicker picker(drawn.render, drawn.points);
        const Ray ray{Vec3(0.2, 0.2, 1), -Vec3::UnitZ()};
        const double distance = picker.pick(ray)->distance;
        for (const double side : {-1.0, 1.0}) {
            const auto pick = [&](double height) {
                return picker.pick(ray, reachOf(ray, CutPlane{side * Vec3::UnitZ(), side * height}));
            };
            const double surface = 1 - distance;
            QCOMPARE(pick(surface + 0.1).has_value(), side > 0);
            QCOMPARE(pick(surface - 0.1).has_value(), side < 0);
            const CutPlane beside{side * Vec3::UnitX(), side * 0.5}; // along the ray
            QCOMPARE(picker.pick(ray, reachOf(ray, beside)).has_value(), side > 0);
        }
    }

    void aDeformedSurfaceIsFollowed()
    {
        const Drawn drawn(20);
        SurfacePicker picker(drawn.render, drawn.points);
        std::vector<float> moved = drawn.points;
        for (std::size_t i = 0; i < moved.size(); i += 3)
            moved[i] += 5; // away along x
        picker.refit(moved);
        QVERIFY(!picker.pick({Vec3(0.5, 0.5, 1), -Vec3::UnitZ()}));
        QVERIFY(picker.pick({Vec3(5.5, 0.5, 1), -Vec3::UnitZ()}).has_value());
    }

    void aTurnedBlockIsMetOnItsSurface()
    {
        Pose pose{Vec3(1, 2, 3), Quaternion(Eigen::AngleAxisd(EIGEN_PI / 4, Vec3::UnitZ()))};
        const Ray ray{Vec3(-5, 2, 3), Vec3::UnitX()};
        const std::optional<double> distance = pickBox(ray, Vec3(2, 2, 2), pose);
        QVERIFY(distance.has_value());
        QVERIFY(std::abs(*distance - (6 - std::sqrt(2.0))) < 1e-12);
        QVERIFY(!pickBox({Vec3(-5, 4, 3), Vec3::UnitX()}, Vec3(2, 2, 2), pose));
    }

    void toolsAreMetOnTheirOwnForm()
    {
        const Pose pose{Vec3(1, 2, 3), Quaternion(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
        const Vec3 size(2, 2, 2);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(-1.5, 1.5);
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec3 target = pose.position + Vec3(number(random), number(random), number(random));
            const Vec3 direction = Vec3(number(random), number(random), number(random)).normalized();
            const Ray ray{target - 10 * direction, direction};
            // Of a ball: from the quadratic equation.
            const Vec3 offset = ray.origin - pose.position;
            const double half = offset.dot(direction);
            const double discriminant = half * half - offset.squaredNorm() + 1;
            const std::optional<double> ball = pickTool(ray, {ToolKind::ball, size}, pose);
            if (std::abs(discriminant) > 1e-2)
                QCOMPARE(ball.has_value(), discriminant > 0);
            if (ball && discriminant > 1e-2)
                QVERIFY(std::abs(*ball - (-half - std::sqrt(discriminant))) < 1e-2);
            // Of the others: the place lies on the surface, and nothing before it.
            for (const ToolKind kind : {ToolKind::cylinder, ToolKind::wedge}) {
                const ToolShape shape{kind, size};
                const auto gap = [&](double distance) {
                    return surfaceOf(shape, pose.toLocal(ray.origin + distance * direction)).distance;
                };
                const std::optional<double> found = pickTool(ray, shape, pose);
                hits += found ? 1 : 0;
                QVERIFY(!found || std::abs(gap(*found)) < 1e-3);
                for (double distance = 0; distance < found.value_or(20) - 1e-2; distance += 0.05)
                    QVERIFY(gap(distance) > -1e-9);
            }
        }
        QVERIFY(hits > 100);
    }

    void shadingIsSmoothInsideFacesAndSharpBetween()
    {
        const Drawn drawn(10);
        // The vertex in the middle belongs to four faces, one on a border to two, one inside a face to one.
        const auto copies = [&](std::uint32_t vertex) {
            return std::count(drawn.render.source.begin(), drawn.render.source.end(), vertex);
        };
        QCOMPARE(copies(5 * 11 + 5), 4);
        QCOMPARE(copies(5 * 11 + 2), 2);
        QCOMPARE(copies(2 * 11 + 2), 1);
        // 40 free edges around, 20 between the faces.
        QCOMPARE(drawn.render.edges.size(), std::size_t{60});
    }

    void normalsOfASphereAreRadial()
    {
        TriangleMesh mesh;
        constexpr std::uint32_t n = 40;
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const double u = 2 * EIGEN_PI * i / n;
                const double v = EIGEN_PI * (j + 0.5) / n;
                mesh.vertices.emplace_back(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
            }
        for (std::uint32_t j = 0; j + 1 < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = j * n + i;
                const std::uint32_t b = j * n + (i + 1) % n;
                mesh.triangles.push_back({a, a + n, b});
                mesh.triangles.push_back({b, a + n, b + n});
            }
        const RenderMesh render = renderMesh(mesh);
        QCOMPARE(render.source.size(), mesh.vertices.size()); // below the crease angle nothing is split
        const std::vector<float> points = renderPoints(render, mesh.vertices);
        const std::vector<float> normals = renderNormals(render, points);
        for (std::size_t v = n; v + n < mesh.vertices.size(); ++v) {
            const Eigen::Map<const Eigen::Vector3f> normal(normals.data() + 3 * v);
            const Eigen::Map<const Eigen::Vector3f> point(points.data() + 3 * v);
            QVERIFY(normal.dot(point) > 0.995F);
        }
    }
};

QTEST_GUILESS_MAIN(PickerTest)
#include "picker_test.moc"
