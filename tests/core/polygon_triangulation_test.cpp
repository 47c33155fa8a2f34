#include "core/geometry/polygon_triangulation.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace knead;
using Vec2 = Eigen::Vector2d;

namespace {

struct Polygon {
    std::vector<Vec2> corners;
    std::vector<std::size_t> loopEnds;

    void add(const std::vector<Vec2>& loop)
    {
        corners.insert(corners.end(), loop.begin(), loop.end());
        loopEnds.push_back(corners.size());
    }
    auto triangles() const { return triangulate(corners, loopEnds); }

    double area() const
    {
        double sum = 0;
        std::size_t begin = 0;
        for (const std::size_t end : loopEnds) {
            for (std::size_t i = begin; i < end; ++i) {
                const Vec2& a = corners[i];
                const Vec2& b = corners[i + 1 < end ? i + 1 : begin];
                sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
            }
            begin = end;
        }
        return sum;
    }
};

std::vector<Vec2> circle(const Vec2& middle, double radius, int corners, double turns = 1)
{
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = turns * 2 * std::numbers::pi * i / corners;
        points.emplace_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// Sides of the polygon are used once, others once either way.
bool fits(const Polygon& polygon, const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            ++uses[{t[i], t[(i + 1) % 3]}];
            --uses[{t[(i + 1) % 3], t[i]}];
        }
    std::size_t begin = 0;
    for (const std::size_t end : polygon.loopEnds) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t j = i + 1 < end ? i + 1 : begin;
            --uses[{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)}];
            ++uses[{static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i)}];
        }
        begin = end;
    }
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
}

double areaOf(const Polygon& polygon, const std::array<std::uint32_t, 3>& t)
{
    const Vec2 a = polygon.corners[t[1]] - polygon.corners[t[0]];
    const Vec2 b = polygon.corners[t[2]] - polygon.corners[t[0]];
    return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

} // namespace

class PolygonTriangulationTest : public QObject {
    Q_OBJECT

private slots:
    void trianglesFillThePolygon_data()
    {
        QTest::addColumn<int>("shape");
        int shape = 0;
        for (const char* name : {"square", "star", "points on a side", "a hole", "four holes", "a comb"})
            QTest::newRow(name) << shape++;
    }
    void trianglesFillThePolygon()
    {
        QFETCH(int, shape);
        Polygon polygon;
        if (shape == 0)
            polygon.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        if (shape == 1) {
            std::vector<Vec2> star;
            for (int i = 0; i < 20; ++i)
                star.push_back(circle({0, 0}, i % 2 == 0 ? 2 : 0.5, 20)[static_cast<std::size_t>(i)]);
            polygon.add(star);
        }
        if (shape == 2)
            polygon.add({{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {1, 0}, {0.5, 1}});
        if (shape >= 3 && shape <= 4)
            polygon.add(circle({0, 0}, 3, 40));
        if (shape == 3)
            polygon.add(circle({0.5, 0.2}, 1, 12, -1));
        if (shape == 4)
            for (const Vec2& middle : {Vec2(1.2, 1.2), Vec2(-1.2, 1.1), Vec2(-1.3, -1.2), Vec2(1.2, -1.2)})
                polygon.add(circle(middle, 0.9, 9, -1));
        if (shape == 5) {
            std::vector<Vec2> comb{{0, 0}, {10, 0}};
            for (int tooth = 9; tooth >= 0; --tooth)
                comb.insert(comb.end(), {{tooth + 0.9, 5}, {tooth + 0.5, 1}});
            polygon.add(comb);
        }
        const auto triangles = polygon.triangles();
        QCOMPARE(triangles.size(), polygon.corners.size() + 2 * polygon.loopEnds.size() - 4);
        QVERIFY(fits(polygon, triangles));
        double sum = 0;
        for (const auto& t : triangles) {
            QVERIFY(areaOf(polygon, t) > 0);
            sum += areaOf(polygon, t);
        }
        QVERIFY(std::abs(sum / polygon.area() - 1) < 1e-12);
    }

    /// The best corner to cut off would leave three points in a line.
    void noNeedleIsLeftWhereNoneNeedsToBe()
    {
        Polygon polygon;
        polygon.add({{0, 0}, {0.5, 0}, {1, 0}, {0.5, 0.85}});
        for (const auto& t : polygon.triangles())
            QVERIFY(areaOf(polygon, t) > 0.2);
    }

    void aPolygonOverItselfStillFits()
    {
        Polygon polygon;
        polygon.add({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
        polygon.add({{0.5, 2}, {0.7, 2}, {0.6, 2.2}});
        QVERIFY(fits(polygon, polygon.triangles()));
    }
};

QTEST_APPLESS_MAIN(PolygonTriangulationTest)
#include "polygon_triangulation_test.moc"
