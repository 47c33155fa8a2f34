#include "support/thread_limit.h"

#include "core/aggregate/fill.h"
#include "core/skin/shape_functions.h"
#include "core/skin/skin.h"
#include "core/skin/skin_map.h"
#include "support/shapes.h"

#include <QtTest>

#include <functional>
#include <memory>
#include <random>

using namespace knead;

namespace {

using Map = std::function<Vec3(const Vec3&)>;

/// A bar of 16 x 4 x 4 cells along x, as in the tables the method was chosen by; `pose` turns it against the lattice.
struct Bar {
    Pose pose;
    Aggregate aggregate;
    std::vector<Vec3> places; // of the surface, in the bar's own axes
    std::vector<Vec3> normals;

    explicit Bar(const Pose& where)
        : pose(where)
        , aggregate(fill(shapes::moved(shapes::box(Vec3(16, 4, 4)), where), {.spacing = 1}))
    {
        for (double x = -8; x <= 8; x += 0.5)
            for (double t = -2; t <= 2; t += 0.5)
                for (const double side : {-1.0, 1.0}) {
                    places.emplace_back(x, t, 2 * side);
                    normals.emplace_back(0, 0, side);
                    places.emplace_back(x, 2 * side, t);
                    normals.emplace_back(0, side, 0);
                }
    }

    /// A map of the bar's axes, as a map of the world.
    Map inWorld(const Map& map) const
    {
        return [this, map](const Vec3& X) { return pose.toWorld(map(pose.toLocal(X))); };
    }

    std::vector<Vec3> worldPlaces(const std::vector<Vec3>& shifts) const
    {
        std::vector<Vec3> result;
        for (std::size_t i = 0; i < places.size(); ++i)
            result.push_back(pose.toWorld(places[i] + shifts[i]));
        return result;
    }
};

std::vector<Vec3> displacements(const Aggregate& aggregate, const Map& map)
{
    std::vector<Vec3> result;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        result.push_back(map(aggregate.lattice.position(i)) - aggregate.lattice.position(i));
    return result;
}

std::vector<Vec3> carried(const Aggregate& aggregate, const std::vector<Vec3>& points, const Map& map)
{
    const Skin skin(aggregate, points);
    std::vector<Vec3> places(points.size());
    skin.evaluate(displacements(aggregate, map), places);
    return places;
}

double largestError(const Aggregate& aggregate, const std::vector<Vec3>& points, const Map& map)
{
    const std::vector<Vec3> places = carried(aggregate, points, map);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        largest = std::max(largest, (places[i] - map(points[i])).norm());
    return largest;
}

Vec3 bend90(const Vec3& X)
{
    const double radius = 16 / (std::numbers::pi / 2);
    const double angle = (X.x() + 8) / radius;
    return {(radius - X.y()) * std::sin(angle), radius - (radius - X.y()) * std::cos(angle), X.z()};
}

Vec3 twist90(const Vec3& X)
{
    return Eigen::AngleAxisd(X.x() / 16 * std::numbers::pi / 2, Vec3::UnitX()) * X;
}

Vec3 turnFar(const Vec3& X)
{
    return Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()) * X + Vec3(500, -300, 200);
}

Vec3 affine(const Vec3& X)
{
    Mat3 stretch;
    stretch << 1.2, 0.2, 0, 0, 0.9, 0.1, 0.05, 0, 0.95;
    return stretch * X;
}

/// Carried by displacements that no quadratic function describes: what is left out anywhere is missed.
std::unique_ptr<const SkinMap> roughMap(const Aggregate& aggregate)
{
    std::minstd_rand random(4);
    std::vector<Vec3> rough(aggregate.size());
    for (Vec3& displacement : rough)
        for (double& component : displacement)
            component = std::uniform_real_distribution<double>(-0.1, 0.1)(random);
    return std::make_unique<const SkinMap>(aggregate, rough);
}

/// The largest slope of the displacement from one place to another, where a jump is a slope that grows with the number of steps.
double steepestAlong(const SkinMap& map, const Vec3& from, const Vec3& to)
{
    constexpr int count = 16000;
    std::vector<Vec3> points;
    for (int i = 0; i <= count; ++i)
        points.push_back(from + (to - from) * i / count);
    std::vector<Vec3> places(points.size());
    map.evaluate(points, places);
    double largest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        largest = std::max(largest, ((places[i] - points[i]) - (places[i - 1] - points[i - 1])).norm());
    return largest / ((to - from).norm() / count);
}

} // namespace

class SkinTest : public QObject {
    Q_OBJECT

private slots:
    void nothingMovesWithoutDisplacement()
    {
        const Bar bar(shapes::tilt(0.5, Vec3(0.1, 0.2, 0.3)));
        const std::vector<Vec3> points = bar.worldPlaces(std::vector<Vec3>(bar.places.size(), Vec3::Zero()));
        QCOMPARE(carried(bar.aggregate, points, [](const Vec3& X) { return X; }), points);
    }

    void rigidAndAffineMotionsAreExact_data()
    {
        QTest::addColumn<double>("angle");
        QTest::newRow("aligned") << 0.0;
        QTest::newRow("tilted") << 0.5;
        QTest::newRow("tilted more") << 1.1;
    }
    void rigidAndAffineMotionsAreExact()
    {
        QFETCH(double, angle);
        const Bar bar(shapes::tilt(angle));
        const std::vector<Vec3> points = bar.worldPlaces(std::vector<Vec3>(bar.places.size(), Vec3::Zero()));
        QVERIFY(largestError(bar.aggregate, points, turnFar) < 1e-6);
        QVERIFY(largestError(bar.aggregate, points, affine) < 1e-6);
    }

    void bendingAndTwistingAreSmooth_data() { rigidAndAffineMotionsAreExact_data(); }
    void bendingAndTwistingAreSmooth()
    {
        QFETCH(double, angle);
        const Bar bar(shapes::tilt(angle));
        const std::vector<Vec3> points = bar.worldPlaces(std::vector<Vec3>(bar.places.size(), Vec3::Zero()));
        const double bendError = largestError(bar.aggregate, points, bar.inWorld(bend90));
        const double twistError = largestError(bar.aggregate, points, bar.inWorld(twist90));
        QVERIFY2(bendError < 0.004, qPrintable(QString::number(bendError)));
        QVERIFY2(twistError < 0.008, qPrintable(QString::number(twistError)));
    }

    void nothingJumpsAlongTheSurface_data() { rigidAndAffineMotionsAreExact_data(); }
    void nothingJumpsAlongTheSurface()
    {
        QFETCH(double, angle);
        const Bar bar(shapes::tilt(angle, Vec3(0.13, 0.07, 0.31)));
        const auto steepest = [map = roughMap(bar.aggregate), &bar](const Vec3& from, const Vec3& to) {
            return steepestAlong(*map, bar.pose.toWorld(from), bar.pose.toWorld(to));
        };
        // A jump of 0.01 would be a slope of 7 or more.
        const double limit = 6;
        QVERIFY2(steepest({-8, -2, -2}, {8, 2, -2}) < limit, "across the bottom");
        QVERIFY2(steepest({-8, 0.3, 2}, {8, 0.4, 2}) < limit, "along the top");
        QVERIFY2(steepest({-8, -2, -2}, {8, -2, -2}) < limit, "along an edge");
        QVERIFY2(steepest({8, -2, -2}, {8, 2, 2}) < limit, "across the end");
    }

    void normalsOfABentBarAreRight_data() { rigidAndAffineMotionsAreExact_data(); }
    void normalsOfABentBarAreRight()
    {
        QFETCH(double, angle);
        const Bar bar(shapes::tilt(angle));
        const double h = 1e-3;
        std::vector<Vec3> along(bar.places.size());
        std::vector<Vec3> across(bar.places.size());
        for (std::size_t i = 0; i < along.size(); ++i) {
            along[i] = h * Vec3::UnitX();
            across[i] = h * bar.normals[i].cross(Vec3::UnitX());
        }
        const auto differences = [&](const std::vector<Vec3>& steps, const Map& map, bool exact) {
            std::vector<Vec3> back = steps;
            for (Vec3& step : back)
                step = -step;
            const std::vector<Vec3> ahead = bar.worldPlaces(steps);
            const std::vector<Vec3> behind = bar.worldPlaces(back);
            std::vector<Vec3> to = carried(bar.aggregate, ahead, map);
            std::vector<Vec3> from = carried(bar.aggregate, behind, map);
            for (std::size_t i = 0; i < steps.size(); ++i)
                to[i] = exact ? Vec3(map(ahead[i]) - map(behind[i])) : Vec3(to[i] - from[i]);
            return to;
        };
        const Map map = bar.inWorld(bend90);
        const auto du = differences(along, map, false);
        const auto dv = differences(across, map, false);
        const auto exactDu = differences(along, map, true);
        const auto exactDv = differences(across, map, true);
        std::vector<double> degrees;
        for (std::size_t i = 0; i < du.size(); ++i) {
            const double sine = du[i].cross(dv[i]).normalized().cross(exactDu[i].cross(exactDv[i]).normalized()).norm();
            degrees.push_back(std::asin(std::min(sine, 1.0)) * 180 / std::numbers::pi);
        }
        std::sort(degrees.begin(), degrees.end());
        const double usual = degrees[degrees.size() * 99 / 100];
        QVERIFY2(usual < 0.2, qPrintable(QString::number(usual)));
        QVERIFY2(degrees.back() < 1, qPrintable(QString::number(degrees.back()))); // at the sharpest corners
    }

    void weightsSumToOne()
    {
        const TriangleMesh mesh = shapes::moved(shapes::torus(5, 1.5, 60, 30), shapes::tilt(0.4));
        const Skin skin(fill(mesh, {.spacing = 0.5}), mesh.vertices);
        for (std::size_t point = 0; point < skin.size(); ++point) {
            double sum = 0;
            for (const Skin::Influence& influence : skin.influences(point))
                sum += static_cast<double>(influence.weight);
            QVERIFY(std::abs(sum - 1) < 1e-6);
        }
    }

    void materialAcrossASlotDoesNotPull_data()
    {
        QTest::addColumn<double>("slot");
        QTest::addColumn<double>("angle");
        QTest::newRow("slot of one cell") << 1.0 << 0.0;
        QTest::newRow("slot of two cells") << 2.0 << 0.0;
        QTest::newRow("tilted slot of two and a half cells") << 2.5 << 0.3;
    }
    void materialAcrossASlotDoesNotPull()
    {
        QFETCH(double, slot);
        QFETCH(double, angle);
        const double width = 8 + slot;
        const Pose pose = shapes::tilt(angle);
        const TriangleMesh mesh = shapes::moved(shapes::fork(width, 24, 4, 8, slot), pose);
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        std::vector<Vec3> walls;
        for (double y = 16; y <= 24; y += 0.5)
            for (double z = 0; z <= 4; z += 0.5)
                for (const double x : {4.0, 4 + slot})
                    walls.push_back(pose.toWorld(Vec3(x, y, z)));
        const Skin skin(aggregate, walls);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const bool left = i % 2 == 0;
            for (const Skin::Influence& influence : skin.influences(i)) {
                const double x = pose.toLocal(aggregate.lattice.position(influence.object)).x();
                QCOMPARE(x < 4 + slot / 2, left);
            }
        }
    }

    void nothingJumpsAroundASlot_data() { materialAcrossASlotDoesNotPull_data(); }
    void nothingJumpsAroundASlot()
    {
        QFETCH(double, slot);
        QFETCH(double, angle);
        const Pose pose = shapes::tilt(angle);
        const TriangleMesh mesh = shapes::moved(shapes::fork(8 + slot, 24, 4, 8, slot), pose);
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        const auto map = roughMap(aggregate);
        // Away from its end, objects on the other side can only be reached in more and more steps.
        for (const double z : {0.0, 1.3, 2.5, 4.0})
            for (const double x : {4.0, 4 + slot})
                QVERIFY2(steepestAlong(*map, pose.toWorld(Vec3(x, 8, z)), pose.toWorld(Vec3(x, 24, z))) < 1,
                         qPrintable(QString("along the wall at %1, %2").arg(x).arg(z)));
        // Across, at its end and a little above it, the nearest cells are those below one wall, of the end, below the other.
        for (const double z : {0.0, 1.3, 4.0})
            for (const double y : {8.0, 8.4})
                QVERIFY2(steepestAlong(*map, pose.toWorld(Vec3(4, y, z)), pose.toWorld(Vec3(4 + slot, y, z))) < 1,
                         qPrintable(QString("across at %1, %2").arg(y).arg(z)));
    }

    void finsTooThinForTheLatticeTurnWithTheBody()
    {
        // A block with a fin of a tenth of a spacing, which no object fills.
        const TriangleMesh fin =
            shapes::prism({{4, 4}, {-4, 4}, {-4, -4}, {4, -4}, {4, 0}, {9, 0}, {9, 0.1}, {4, 0.1}}, 6);
        const Aggregate aggregate = fill(fin, {.spacing = 1});
        QVERIFY(aggregate.size() < 900);
        const auto turn = [](const Vec3& X) { return Vec3(Eigen::AngleAxisd(0.8, Vec3(1, 2, 3).normalized()) * X); };
        QVERIFY(largestError(aggregate, fin.vertices, turn) < 1e-5);
    }

    void thinSheetsFollowAffineMotions()
    {
        // One cell through the thickness: the quadratic basis is singular there.
        const TriangleMesh mesh = shapes::box(Vec3(12, 9, 1));
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        QVERIFY(largestError(aggregate, mesh.vertices, affine) < 1e-6);
    }

    void aSingleRowOfCellsFollowsItsEnds()
    {
        // Nearly a cell thick: what fills one gets three layers of objects.
        const TriangleMesh mesh = shapes::box(Vec3(0.9, 0.9, 0.9));
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        QCOMPARE(aggregate.size(), std::size_t{8});
        QVERIFY(largestError(aggregate, mesh.vertices, affine) < 1e-6);
    }

    void shapeFunctionsFallBackToConstants()
    {
        const std::vector<Vec3> one{Vec3(0.5, 0.2, 0)};
        QCOMPARE(shapeFunctions(one, 2.6).front(), 1.0);
        const std::vector<Vec3> line{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), Vec3(1.5, 0, 0)};
        double sum = 0;
        for (const double function : shapeFunctions(line, 2.6)) {
            QVERIFY(function > 0);
            sum += function;
        }
        QVERIFY(std::abs(sum - 1) < 1e-14);
    }

    void shapeFunctionsReproduceQuadratics()
    {
        std::minstd_rand random(9);
        std::vector<Vec3> offsets;
        for (int u = -3; u <= 3; ++u)
            for (int v = -3; v <= 3; ++v)
                for (int w = -3; w <= 3; ++w)
                    offsets.push_back(Vec3(u, v, w) + Vec3(0.3, 0.1, -0.2));
        const std::vector<double> functions = shapeFunctions(offsets, 2.6);
        double value = 0;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            const Vec3& x = offsets[i];
            value += functions[i] * (3 + x.x() - 2 * x.y() + x.z() * x.z() - 4 * x.x() * x.y() + x.y() * x.y());
        }
        QVERIFY(std::abs(value - 3) < 1e-12);
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        const TriangleMesh mesh = shapes::moved(shapes::torus(5, 1.5, 120, 60), shapes::tilt(0.4));
        const Aggregate aggregate = fill(mesh, {.spacing = 0.5});
        const auto carry = [&](int threads) {
            return onThreads(threads, [&] { return carried(aggregate, mesh.vertices, bend90); });
        };
        const std::vector<Vec3> one = carry(1);
        QVERIFY(one == carry(2));
        QVERIFY(one == carry(4));
    }

    void emptyAggregateIsRefused()
    {
        const std::vector<Vec3> points{Vec3::Zero()};
        QVERIFY_EXCEPTION_THROWN(Skin(Aggregate(), points), std::invalid_argument);
    }
};

QTEST_GUILESS_MAIN(SkinTest)
#include "skin_test.moc"
