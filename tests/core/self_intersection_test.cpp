#include "support/thread_limit.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/self_intersection.h"
#include "core/geometry/triangle_crossing.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace knead;

namespace {

TriangleMesh turned(const TriangleMesh& mesh, const Vec3& position = Vec3::Zero())
{
    return shapes::moved(mesh, shapes::tilt(0.7, position));
}

/// Triangles anywhere in a box of 1, with sides of about `size`.
TriangleMesh soup(std::size_t count, double size, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return 2.0 * random() / std::mt19937::max() - 1; };
    TriangleMesh mesh;
    for (std::size_t t = 0; t < count; ++t) {
        const Vec3 middle = 0.5 * Vec3(number(), number(), number());
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int i = 0; i < 3; ++i)
            mesh.vertices.push_back(middle + size * Vec3(number(), number(), number()));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Six times the volume of a tetrahedron.
long double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 w = d - a;
    return static_cast<long double>(u.dot(v.cross(w)));
}

using Corners = std::array<Vec3, 3>;

bool edgePierces(const Vec3& from, const Vec3& to, const Corners& t)
{
    if (volume(t[0], t[1], t[2], from) * volume(t[0], t[1], t[2], to) >= 0)
        return false;
    const bool left = volume(from, to, t[0], t[1]) > 0;
    return left == (volume(from, to, t[1], t[2]) > 0) && left == (volume(from, to, t[2], t[0]) > 0);
}

/// Triangles in general position cross when an edge of one goes through the other.
bool cross(const Corners& a, const Corners& b)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (edgePierces(a[i], a[(i + 1) % 3], b) || edgePierces(b[i], b[(i + 1) % 3], a))
            return true;
    return false;
}

bool haveCommonCorner(const TriangleMesh::Triangle& a, const TriangleMesh::Triangle& b)
{
    return std::any_of(a.begin(), a.end(),
                       [&](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

Corners corners(const TriangleMesh& mesh, std::size_t t)
{
    return {mesh.vertices[mesh.triangles[t][0]], mesh.vertices[mesh.triangles[t][1]],
            mesh.vertices[mesh.triangles[t][2]]};
}

/// All but those with a common corner.
std::vector<std::array<std::uint32_t, 2>> allPairs(const TriangleMesh& mesh)
{
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a)
        for (std::uint32_t b = a + 1; b < mesh.triangles.size(); ++b)
            if (!haveCommonCorner(mesh.triangles[a], mesh.triangles[b]) && cross(corners(mesh, a), corners(mesh, b)))
                pairs.push_back({a, b});
    return pairs;
}

/// A plate of thickness 0.1 that is bent up into a ring, over its beginning when `turns` is more than 1; its radius begins with 1
/// and ends with 1 + `growth`.
TriangleMesh rolledPlate(double turns, double growth)
{
    constexpr int along = 120;
    const double thickness = 0.1;
    TriangleMesh mesh;
    const auto place = [&](int i, double offset, double y) {
        const double angle = 2 * std::numbers::pi * turns * i / along;
        const double radius = 1 + offset + growth * i / along;
        return Vec3(radius * std::cos(angle), y, radius * std::sin(angle));
    };
    for (int i = 0; i <= along; ++i)
        for (const auto& [offset, y] :
             std::vector<std::pair<double, double>>{{0, 0}, {0, 0.5}, {thickness, 0.5}, {thickness, 0}})
            mesh.vertices.push_back(place(i, offset, y));
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t k = 0; k < 4; ++k)
            quad(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k);
    quad(3, 2, 1, 0);
    quad(4 * along, 4 * along + 1, 4 * along + 2, 4 * along + 3);
    return mesh;
}

TriangleMesh gear(int teeth)
{
    std::vector<Eigen::Vector2d> outline{{0, 0}}; // a sector, so that it is star-shaped from its first corner
    for (int i = 0; i <= 2 * teeth; ++i)
        for (const double radius : {i % 2 == 0 ? 0.9 : 1.1, i % 2 == 0 ? 1.1 : 0.9}) {
            const double angle = std::numbers::pi * i / (2.5 * teeth);
            outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
    return shapes::prism(outline, 0.3);
}

bool same(const Crossings& a, const Crossings& b)
{
    return a.count == b.count && a.some == b.some && a.where.min() == b.where.min() && a.where.max() == b.where.max();
}

} // namespace

class SelfIntersectionTest : public QObject {
    Q_OBJECT

private slots:
    void cleanSurfacesHaveNone_data();
    void cleanSurfacesHaveNone();
    void overlappingSpheresCrossAlongTheirCircle();
    void boxPushedThroughItselfIsFound();
    void rolledPlateCrossesWhereItsEndsMeet_data();
    void rolledPlateCrossesWhereItsEndsMeet();
    void trianglesWithACommonCornerMayCross();
    void foldedFanAroundAVertexIsFound();
    void touchingIsNoCrossing();
    void crossingCountsBeyondTheTolerance();
    void soupEqualsBruteForce_data();
    void soupEqualsBruteForce();
    void anyNumberOfThreadsGivesTheSame();
    void fewPairsComeFromAllOver();
    void degenerateTrianglesDoNotMatter();
    void emptyMeshHasNone();
    void canBeCancelled();
};

void SelfIntersectionTest::cleanSurfacesHaveNone_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::newRow("torus") << turned(shapes::torus(0.03, 0.01, 200, 80));
    QTest::newRow("sphere") << turned(shapes::sphere(0.01, 100));
    QTest::newRow("box") << shapes::box(Vec3(1, 2, 3));
    QTest::newRow("tilted box") << turned(shapes::box(Vec3(1, 2, 3)), Vec3(100, 200, 50));
    QTest::newRow("box with a void") << turned(shapes::hollowBox(Vec3(1, 1, 1), Vec3(0.9999, 0.9999, 0.9999)));
    QTest::newRow("cylinder") << turned(shapes::cylinder(1, 5, 300));
    QTest::newRow("gear") << turned(gear(20));
    QTest::newRow("fork") << turned(shapes::fork(3, 10, 1, 2, 0.001));
    QTest::newRow("rolled plate, apart") << turned(rolledPlate(1.2, 0.9));
    QTest::newRow("triangle") << TriangleMesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}, {}};
}

void SelfIntersectionTest::cleanSurfacesHaveNone()
{
    QFETCH(TriangleMesh, mesh);
    const Crossings crossings = findCrossings(mesh);
    QCOMPARE(crossings.count, std::size_t(0));
    QVERIFY(crossings.some.empty() && crossings.where.isEmpty());
}

void SelfIntersectionTest::overlappingSpheresCrossAlongTheirCircle()
{
    // Two of radius 1 whose middles are 1 apart cross in the plane between them, in a circle of radius sqrt(3/4).
    const TriangleMesh sphere = shapes::sphere(1, 48);
    const TriangleMesh turnedSphere = shapes::moved(sphere, {Vec3(1, 0, 0), shapes::tilt(0.3).rotation});
    const TriangleMesh both = shapes::together(sphere, turnedSphere);
    const Crossings crossings = findCrossings(both, TaskControl::none(), 100'000);
    QVERIFY(crossings.count > 48);
    QCOMPARE(crossings.some.size(), crossings.count);
    QCOMPARE(crossings.some, allPairs(both));
    const double radius = std::sqrt(0.75);
    QVERIFY((crossings.where.min() - Vec3(0.5, -radius, -radius)).norm() < 1e-2);
    QVERIFY((crossings.where.max() - Vec3(0.5, radius, radius)).norm() < 1e-2);
}

void SelfIntersectionTest::boxPushedThroughItselfIsFound()
{
    // The middle of the top goes down through the bottom.
    TriangleMesh mesh = shapes::box(Vec3(1, 1, 1));
    std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v].z() > 0; });
    });
    mesh.faceOfTriangle.clear();
    mesh.vertices.emplace_back(0.1, 0.2, -0.7);
    for (const auto& [a, b] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{{4, 5}, {5, 7}, {7, 6}, {6, 4}})
        mesh.triangles.push_back({a, b, 8});
    QVERIFY(isWatertight(mesh));
    const Crossings crossings = findCrossings(mesh);
    QVERIFY(crossings.count >= 4); // each side of the dent goes through the bottom
    QCOMPARE(crossings.some, allPairs(mesh));
    QVERIFY(std::abs(crossings.where.min().z() + 0.5) < 1e-12 && std::abs(crossings.where.max().z() + 0.5) < 1e-12);

    mesh.vertices.back().z() = -0.49;
    QCOMPARE(findCrossings(mesh).count, std::size_t(0));
}

void SelfIntersectionTest::rolledPlateCrossesWhereItsEndsMeet_data()
{
    QTest::addColumn<double>("turns");
    QTest::newRow("ends go through triangles") << 1.21;
    QTest::newRow("ends go through edges, of which the 100th lie at the beginning") << 1.2;
}

void SelfIntersectionTest::rolledPlateCrossesWhereItsEndsMeet()
{
    // The end lies half a thickness above the beginning, so that either goes through the other's side.
    QFETCH(double, turns);
    const TriangleMesh mesh = turned(rolledPlate(turns, 0.05 * turns));
    QVERIFY(isWatertight(mesh));
    const Crossings crossings = findCrossings(mesh);
    QVERIFY(crossings.count >= 4);
    QCOMPARE(findCrossings(turned(rolledPlate(0.95, 0))).count, std::size_t(0));
}

void SelfIntersectionTest::trianglesWithACommonCornerMayCross()
{
    const auto lineOf = [](const Vec3& other, const Vec3& another) {
        const TriangleMesh mesh{
            {Vec3::Zero(), Vec3(2, -1, 0), Vec3(2, 1, 0), other, another}, {{0, 1, 2}, {0, 3, 4}}, {}};
        const HalfEdges halfEdges = findHalfEdges(mesh);
        return crossingOf({mesh, halfEdges, 0}, {mesh, halfEdges, 1}, 1e-9);
    };
    const auto line = lineOf(Vec3(1, 0.1, -1), Vec3(1, 0.1, 1));
    QVERIFY(line.has_value());
    QVERIFY(std::abs((line->end - line->begin).norm() - std::hypot(1, 0.1)) < 1e-12);
    QVERIFY(!lineOf(Vec3(-1, 0.1, -1), Vec3(-1, 0.1, 1))); // on the other side of the corner
    QVERIFY(!lineOf(Vec3(0.1, 1, -1), Vec3(0.1, 1, 1)));   // beside the triangle
}

void SelfIntersectionTest::foldedFanAroundAVertexIsFound()
{
    // A fan of six around a vertex, of which two spokes have changed places and left the plane.
    TriangleMesh mesh;
    mesh.vertices.emplace_back(0, 0, 0);
    for (int i = 0; i < 6; ++i)
        mesh.vertices.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0);
    for (std::uint32_t i = 0; i < 6; ++i)
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
    QCOMPARE(findCrossings(mesh).count, std::size_t(0));
    mesh.vertices[2] = Vec3(std::cos(0.9), std::sin(0.9), 0.4);
    QCOMPARE(findCrossings(mesh).count, std::size_t(0));
    mesh.vertices[2] = Vec3(std::cos(4.0), std::sin(4.0), 0.4); // above the others, on the far side
    mesh.vertices[3] = Vec3(std::cos(0.2), std::sin(0.2), -0.4);
    QVERIFY(findCrossings(mesh).count > 0);
}

void SelfIntersectionTest::touchingIsNoCrossing()
{
    const TriangleMesh box = shapes::box(Vec3(1, 1, 1));
    for (const Vec3& shift : {Vec3(1, 0, 0), Vec3(1, 0.3, 0.2), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(0, 0, 0)}) {
        QCOMPARE(findCrossings(shapes::together(box, shapes::moved(box, {shift}))).count, std::size_t(0));
        // The same tilted, where rounding pushes faces into each other.
        const TriangleMesh pair = turned(shapes::together(box, shapes::moved(box, {shift})), Vec3(3, 1, 4));
        QCOMPARE(findCrossings(pair).count, std::size_t(0));
        TriangleMesh rounded = pair;
        for (Vec3& vertex : rounded.vertices)
            vertex = (vertex - Vec3(3, 1, 4)).cast<float>().cast<double>();
        QCOMPARE(findCrossings(rounded).count, std::size_t(0));
    }
    // A corner that stands on a face.
    const TriangleMesh cone{{Vec3(0, 0, 0.5), Vec3(0.1, 0, 1), Vec3(0, 0.1, 1), Vec3(-0.1, -0.1, 1)},
                            {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}},
                            {}};
    QCOMPARE(findCrossings(shapes::together(box, cone)).count, std::size_t(0));
}

void SelfIntersectionTest::crossingCountsBeyondTheTolerance()
{
    const TriangleMesh box = shapes::box(Vec3(1, 1, 1)); // two of them have a box of about 2
    const auto pair = [&](double depth) {
        return shapes::together(box, shapes::moved(shapes::box(Vec3(1, 0.5, 0.3)), {Vec3(1 - depth, 0.1, 0.07)}));
    };
    QCOMPARE(findCrossings(pair(1e-7)).count, std::size_t(0));
    QVERIFY(findCrossings(pair(3e-7)).count > 0);
}

void SelfIntersectionTest::soupEqualsBruteForce_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("size");
    QTest::newRow("two") << 2 << 1.0;
    QTest::newRow("large ones") << 60 << 0.8;
    QTest::newRow("middle ones") << 600 << 0.1;
    QTest::newRow("small ones") << 2000 << 0.04;
}

void SelfIntersectionTest::soupEqualsBruteForce()
{
    QFETCH(int, count);
    QFETCH(double, size);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const TriangleMesh mesh = soup(static_cast<std::size_t>(count), size, seed);
        const auto expected = allPairs(mesh);
        const Crossings crossings = findCrossings(mesh, TaskControl::none(), 1'000'000);
        QCOMPARE(crossings.count, expected.size());
        QCOMPARE(crossings.some, expected);
        QVERIFY(count < 10 || !expected.empty());
    }
}

void SelfIntersectionTest::anyNumberOfThreadsGivesTheSame()
{
    const TriangleMesh mesh = shapes::together(soup(20'000, 0.03, 7), turned(shapes::torus(0.4, 0.1, 150, 60)));
    const Crossings one = onThreads(1, [&] { return findCrossings(mesh); });
    QVERIFY(one.count > 1000);
    QCOMPARE(one.some.size(), std::size_t(100));
    for (const int threads : {2, 4})
        QVERIFY(same(one, onThreads(threads, [&] { return findCrossings(mesh); })));
    QVERIFY(same(one, findCrossingsAlone(mesh)));
}

void SelfIntersectionTest::fewPairsComeFromAllOver()
{
    const TriangleMesh mesh = soup(30'000, 0.03, 3);
    const Crossings crossings = findCrossings(mesh, TaskControl::none(), 50);
    QCOMPARE(crossings.some.size(), std::size_t(50));
    Box box;
    for (const auto& pair : crossings.some)
        box.extend(mesh.vertices[mesh.triangles[pair[0]][0]]);
    QVERIFY(box.sizes().minCoeff() > 0.5);
}

void SelfIntersectionTest::degenerateTrianglesDoNotMatter()
{
    TriangleMesh mesh = turned(shapes::torus(0.03, 0.01, 60, 24));
    mesh.triangles.push_back({5, 5, 9});
    mesh.triangles.push_back({7, 7, 7});
    mesh.triangles.push_back(mesh.triangles.front()); // twice
    QCOMPARE(findCrossings(mesh).count, std::size_t(0));
    const TriangleMesh point{{Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}, {{0, 1, 2}, {2, 1, 0}}, {}};
    QCOMPARE(findCrossings(point).count, std::size_t(0));
}

void SelfIntersectionTest::emptyMeshHasNone()
{
    QCOMPARE(findCrossings({}).count, std::size_t(0));
}

void SelfIntersectionTest::canBeCancelled()
{
    struct Cancelling final : TaskControl {
        void report(double, std::string_view) override {}
        bool isCancelled() const override { return true; }
    } control;
    QVERIFY_EXCEPTION_THROWN(findCrossings(shapes::sphere(1, 20), control), Cancelled);
}

QTEST_GUILESS_MAIN(SelfIntersectionTest)
#include "self_intersection_test.moc"
