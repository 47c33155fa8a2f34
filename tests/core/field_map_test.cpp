#include "core/deformation/field_map.h"
#include "core/geometry/surface_distance.h"
#include "core/message/message.h"
#include "support/shapes.h"

#include <QtTest>

#include <functional>
#include <limits>
#include <numbers>
#include <random>

using namespace knead;

namespace {

using Function = std::function<Vec3(const Vec3&)>;

class Chance {
public:
    double next(double low, double high)
    {
        return low + (high - low) * static_cast<double>(m_random() % 1000003) / 1000003;
    }
    Vec3 next(const Vec3& low, const Vec3& high)
    {
        return {next(low.x(), high.x()), next(low.y(), high.y()), next(low.z(), high.z())};
    }

private:
    std::minstd_rand m_random{11};
};

/// Nodes as a mesh of tetrahedra has them: those inside a little off a lattice.
std::shared_ptr<const DisplacementField> nodesOf(const Vec3& size, double spacing, const Function& u)
{
    DisplacementField field;
    Chance chance;
    const Eigen::Vector3i count = (size / spacing).array().round().cast<int>();
    for (int i = 0; i <= count.x(); ++i)
        for (int j = 0; j <= count.y(); ++j)
            for (int k = 0; k <= count.z(); ++k) {
                Vec3 node = spacing * Vec3(i, j, k);
                const Eigen::Vector3i at(i, j, k);
                for (int axis = 0; axis < 3; ++axis)
                    if (at[axis] > 0 && at[axis] < count[axis])
                        node[axis] += chance.next(-0.2, 0.2) * spacing;
                field.nodes.push_back(node);
                field.displacements.push_back(u(node));
            }
    return std::make_shared<const DisplacementField>(std::move(field));
}

std::vector<Vec3> skinPoints(const Vec3& size, int count)
{
    Chance chance;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        Vec3 point = chance.next(Vec3::Zero(), size);
        point[i % 3] = i % 2 == 0 ? 0 : size[i % 3];
        points.push_back(point);
    }
    return points;
}

double largestError(const SmoothMap& map, const std::vector<Vec3>& points, const Function& u)
{
    std::vector<Vec3> places(points.size());
    map.evaluate(points, places);
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        worst = std::max(worst, (places[i] - points[i] - u(points[i])).norm());
    return worst;
}

const Vec3 barSize(0.1, 0.01, 0.01);

Vec3 quadratic(const Vec3& p)
{
    return {0.3 * p.x() * p.y() + 0.02 * p.z(), p.x() * p.x() - 3 * p.z() * p.z() + p.y() * p.z(), 0.01 + 0.1 * p.y()};
}

/// A bar clamped at x = 0 that is bent by a force at its end, by a fifth of its length: Timoshenko's solution with Poisson's ratio 0.3.
Vec3 cantilever(const Vec3& p)
{
    const double length = barSize.x();
    const double rate = 0.6 / (length * length); // of curvature
    const double x = p.x();
    const double y = p.y() - barSize.y() / 2;
    const double z = p.z() - barSize.z() / 2;
    const double slope = rate * (length * x - x * x / 2);
    return {-z * slope, 0.3 * rate * (length - x) * y * z,
            rate * (length * x * x / 2 - x * x * x / 6) + 0.15 * rate * (length - x) * (z * z - y * y)};
}

std::shared_ptr<const SmoothMap> mapOfNodes(std::vector<Vec3> nodes, const Function& u)
{
    DisplacementField field{std::move(nodes), {}};
    for (const Vec3& node : field.nodes)
        field.displacements.push_back(u(node));
    return fieldMap({.field = std::make_shared<const DisplacementField>(std::move(field))});
}

std::string refusal(const FieldDeformation& deformation)
{
    try {
        static_cast<void>(fieldMap(deformation));
    } catch (const Problem& problem) {
        return problem.what();
    }
    return {};
}

} // namespace

class FieldMapTest : public QObject {
    Q_OBJECT

private slots:
    void quadraticFieldsComeBackExactly()
    {
        for (const Vec3& size : {barSize, Vec3(0.03, 0.03, 0.002)}) { // a plate of two layers
            const auto map = fieldMap({.field = nodesOf(size, 0.001, quadratic)});
            QVERIFY(largestError(*map, skinPoints(size, 2000), quadratic) < 1e-12);
            std::vector<Vec3> outside = skinPoints(size, 500);
            for (Vec3& point : outside)
                point += point - size / 2;
            QVERIFY(largestError(*map, outside, quadratic) < 1e-11);
        }
    }

    void bentBarIsMetFarBelowItsTolerance()
    {
        const auto map = fieldMap({.field = nodesOf(barSize, barSize.z() / 8, cantilever)});
        const double error = largestError(*map, skinPoints(barSize, 5000), cantilever);
        qInfo("largest error on the skin: %.2g of the size", error / barSize.norm());
        QVERIFY(error < 1e-5 * barSize.norm());
        QVERIFY(map->featureSize() >= barSize.z() / 8);
        QVERIFY(map->featureSize() <= barSize.x() / 2);
    }

    void nodesAtAHoleAreMet()
    {
        // Kirsch's plate under tension: a field that quadratic functions over nodes a quarter of the radius apart miss by a hundredth.
        const double radius = 0.01;
        const auto kirsch = [&](const Vec3& p) {
            const double r = std::hypot(p.x(), p.y()) / radius;
            const double a = std::atan2(p.y(), p.x());
            const double k = 2;
            return Vec3(1e-6 * (r * (k + 1) * std::cos(a) + 2 / r * ((1 + k) * std::cos(a) + std::cos(3 * a)) -
                                2 / (r * r * r) * std::cos(3 * a)),
                        1e-6 * (r * (k - 3) * std::sin(a) + 2 / r * ((1 - k) * std::sin(a) + std::sin(3 * a)) -
                                2 / (r * r * r) * std::sin(3 * a)),
                        0);
        };
        std::vector<Vec3> nodes;
        for (int ring = 0; ring < 16; ++ring)
            for (int i = 0; i < 25 + 5 * ring; ++i)
                for (int layer = 0; layer < 3; ++layer) {
                    const double angle = 2 * std::numbers::pi * (i + 0.5 * (ring % 2)) / (25 + 5 * ring);
                    const double r = radius * (1 + 0.25 * ring);
                    nodes.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0025 * layer);
                }
        const auto map = mapOfNodes(nodes, kirsch);
        const double span = 2 * kirsch(Vec3(4.75 * radius, 0, 0)).x();
        QVERIFY(largestError(*map, nodes, kirsch) < 2e-4 * span);
    }

    void noiseIsSmoothed()
    {
        Chance chance;
        const double noise = 2e-5;
        const auto noisy = [&](const Vec3& p) {
            return Vec3(cantilever(p) + noise * chance.next(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
        };
        const auto map = fieldMap({.field = nodesOf(barSize, barSize.z() / 12, noisy)});
        const std::vector<Vec3> points = skinPoints(barSize, 3000);
        std::vector<Vec3> places(points.size());
        map->evaluate(points, places);
        double squares = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            squares += (places[i] - points[i] - cantilever(points[i])).squaredNorm();
        // Of uniform noise in three components the root mean square is the amplitude.
        QVERIFY(std::sqrt(squares / static_cast<double>(points.size())) < 0.5 * noise);
    }

    void fineNodesInOnePlaceAreFollowedThere()
    {
        Chance chance;
        const Vec3 center(0.05, 0.05, 0);
        const auto bump = [&](const Vec3& p) {
            return Vec3(0, 0, 1e-3 * std::exp(-(p - center).squaredNorm() / (2 * 1e-3 * 1e-3)));
        };
        std::vector<Vec3> nodes;
        for (int i = 0; i < 15000; ++i) {
            const Vec3 toward = chance.next(Vec3(-1, -1, -1), Vec3(1, 1, 1)).normalized();
            nodes.push_back(center + 2e-4 * std::pow(250, chance.next(0, 1)) * toward);
        }
        const auto map = mapOfNodes(nodes, bump);
        std::vector<Vec3> points;
        for (int i = 0; i < 500; ++i)
            points.push_back(center + chance.next(0, 0.03) * chance.next(Vec3(-1, -1, -1), Vec3(1, 1, 1)).normalized());
        QVERIFY(largestError(*map, points, bump) < 0.02 * 1e-3);
    }

    void nodesThatSpanNoSpaceGiveALowerOrder()
    {
        const auto linear = [](const Vec3& p) { return Vec3(0.1 * p.x() + 0.001, 0.2 * p.x(), -0.1 * p.x()); };
        QVERIFY(largestError(*mapOfNodes({Vec3(1, 2, 3)}, linear), {Vec3(1, 2, 3)}, linear) < 1e-12);
        QVERIFY(largestError(*mapOfNodes({Vec3(1, 0, 0), Vec3(2, 0, 0)}, linear),
                             {Vec3(1, 0, 0), Vec3(1.5, 0, 0), Vec3(2.5, 0, 0)}, linear) < 1e-9);
        std::vector<Vec3> line;
        std::vector<Vec3> plane;
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 12; ++j) {
                line.emplace_back(i + 12 * j, 0, 0);
                plane.emplace_back(i, j, 0);
            }
        QVERIFY(largestError(*mapOfNodes(line, linear), {Vec3(3.5, 0, 0), Vec3(3.5, 5, -5)}, linear) < 1e-6);
        QVERIFY(largestError(*mapOfNodes(plane, linear), {Vec3(3.5, 2.5, 0), Vec3(5.5, 4, 3)}, linear) < 1e-6);
    }

    void farOutsideItIsLinear()
    {
        const auto map = fieldMap({.field = nodesOf(barSize, barSize.z() / 4, cantilever)});
        const Vec3 from(3, -2, 1);
        const auto moved = [&](double t) { return Vec3(map->at(t * from) - t * from); };
        QVERIFY((moved(1) - 2 * moved(2) + moved(3)).norm() < 1e-9 * moved(3).norm());
        QVERIFY(moved(1).norm() < 3 * from.norm());
    }

    void secondDerivativesAreContinuous()
    {
        const auto waves = [](const Vec3& p) {
            return Vec3(1e-3 * std::sin(300 * p.x()), 0, 1e-3 * std::sin(300 * p.y()));
        };
        const auto map = fieldMap({.field = nodesOf(Vec3(0.03, 0.03, 0.01), 0.0015, waves),
                                   .kept = shapes::box(Vec3(0.01, 0.01, 0.002)),
                                   .fade = 0.008});
        // Along a line through kept corners, leaves of the octree and out of the nodes: over shorter steps jumps get no smaller.
        const auto largestJump = [&](double h) {
            double worst = 0;
            std::array<Vec3, 4> points;
            std::array<Vec3, 4> places;
            for (int i = 0; i < 4000; ++i) {
                const Vec3 start = Vec3(-0.005, -0.003, -0.002) + 1e-5 * i * Vec3(1, 0.8, 0.3);
                for (int j = 0; j < 4; ++j)
                    points[static_cast<std::size_t>(j)] = start + j * h * Vec3(1, 0.8, 0.3);
                map->evaluate(points, places);
                worst = std::max(worst, (places[3] - 3 * places[2] + 3 * places[1] - places[0]).norm() / (h * h));
            }
            return worst;
        };
        const double coarse = largestJump(4e-5);
        QVERIFY(largestJump(1e-5) < 0.35 * coarse);
    }

    void keptFacesStayAndTheFieldFades()
    {
        const TriangleMesh kept{{{0, 0, 0}, {0, 0.01, 0}, {0, 0.01, 0.01}, {0, 0, 0.01}}, {{0, 2, 1}, {0, 3, 2}}, {}};
        const auto away = [](const Vec3&) { return Vec3(0.002, 0.001, -0.003); };
        const auto map = fieldMap({.field = nodesOf(barSize, barSize.z() / 4, away), .kept = kept, .fade = 0.02});
        Chance chance;
        double before = 0;
        for (int i = 0; i < 500; ++i) {
            const Vec3 on = chance.next(Vec3::Zero(), Vec3(0, 0.01, 0.01));
            QVERIFY((map->at(on) - on).norm() < 1e-15);
            const Vec3 behind = chance.next(Vec3(0.02, 0, 0), barSize);
            QVERIFY((map->at(behind) - behind - away(behind)).norm() < 1e-15);
            const Vec3 between(0.02 * i / 500, 0.004, 0.006);
            const double now = (map->at(between) - between).norm();
            QVERIFY(now >= before - 1e-15);
            before = now;
        }
    }

    void keptFacesDoNotTellHowTheyAreTriangulated()
    {
        const auto away = [](const Vec3&) { return Vec3(0, 0, 1e-3); };
        const auto field = nodesOf(Vec3(0.1, 0.1, 0.01), 0.01, away);
        const TriangleMesh coarse{{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}};
        TriangleMesh other = coarse;
        other.vertices.emplace_back(0.031, 0.057, 0);
        other.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
        const auto one = fieldMap({.field = field, .kept = coarse, .fade = 0.02});
        const auto two = fieldMap({.field = field, .kept = other, .fade = 0.02});
        Chance chance;
        for (int i = 0; i < 300; ++i) {
            const Vec3 point = chance.next(Vec3::Zero(), Vec3(0.1, 0.1, 0.02));
            QVERIFY((one->at(point) - two->at(point)).norm() < 0.01 * 1e-3);
        }
    }

    void lockedDirectionsAndTheFactorCount()
    {
        const auto field = nodesOf(barSize, barSize.z() / 4, quadratic);
        const auto map = fieldMap({.field = field, .factor = -2, .locked = {false, true, false}});
        for (const Vec3& point : skinPoints(barSize, 100)) {
            Vec3 expected = -2 * quadratic(point);
            expected.y() = 0;
            QVERIFY((map->at(point) - point - expected).norm() < 1e-12);
        }
    }

    /// To the last bit, whatever the map before was of.
    void aMapMadeFromAnEarlierOneIsAsIfMadeAnew()
    {
        const auto field = nodesOf(barSize, barSize.z() / 4, cantilever);
        const auto other = nodesOf(barSize, barSize.z() / 4, quadratic);
        const auto plain = fieldMap({.field = field});
        const FieldDeformation changed{.field = field, .factor = -2, .locked = {false, true, false}};
        for (const auto& earlier : {plain, fieldMap(changed), fieldMap({.field = other})}) {
            const auto fromThat = fieldMap(changed, TaskControl::none(), earlier.get());
            const auto anew = fieldMap(changed);
            QVERIFY(fromThat->featureSize() == anew->featureSize());
            for (const Vec3& point : skinPoints(barSize, 100))
                QVERIFY(fromThat->at(point) == anew->at(point));
        }
    }

    void nodesInOnePlaceAreOne()
    {
        DisplacementField twice = *nodesOf(barSize, barSize.z() / 4, quadratic);
        const std::size_t count = twice.nodes.size();
        for (std::size_t i = 0; i < count; ++i) {
            twice.nodes.push_back(twice.nodes[i]);
            twice.displacements.push_back(twice.displacements[i] + Vec3(2e-3, 0, 0));
        }
        const auto map = fieldMap({.field = std::make_shared<const DisplacementField>(twice)});
        const auto mean = [](const Vec3& p) { return Vec3(quadratic(p) + Vec3(1e-3, 0, 0)); };
        QVERIFY(largestError(*map, skinPoints(barSize, 200), mean) < 1e-12);
    }

    void pointsAreTakenToTheSamePlacesAloneAndTogether()
    {
        const auto field = nodesOf(barSize, barSize.z() / 6, cantilever);
        const auto map = fieldMap({.field = field});
        const auto again = fieldMap({.field = field});
        const std::vector<Vec3> points = skinPoints(barSize, 1000);
        std::vector<Vec3> places(points.size());
        map->evaluate(points, places);
        for (std::size_t i = 0; i < points.size(); ++i)
            QVERIFY(places[i] == again->at(points[i]));
    }

    void whatIsNoFieldIsRefused()
    {
        const auto with = [](const DisplacementField& field) {
            return FieldDeformation{.field = std::make_shared<const DisplacementField>(field)};
        };
        QVERIFY(refusal(with({})).find("no nodes") != std::string::npos);
        QVERIFY(refusal(with({{Vec3::Zero()}, {}})).find("1 nodes, but 0 displacements") != std::string::npos);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(refusal(with({{Vec3::Zero(), Vec3::Ones()}, {Vec3::Zero(), Vec3(nan, 0, 0)}})).starts_with("Node 2"));
        QVERIFY(refusal(with({{Vec3(1e30, 0, 0)}, {Vec3::Zero()}})).starts_with("Node 1"));
        FieldDeformation kept = with({{Vec3::Zero()}, {Vec3::Ones()}});
        kept.kept = shapes::box(Vec3(1, 1, 1));
        QVERIFY(refusal(kept).find("fades") != std::string::npos);
        FieldDeformation factor = with({{Vec3::Zero()}, {Vec3::Ones()}});
        factor.factor = nan;
        QVERIFY(!refusal(factor).empty());
    }
};

QTEST_GUILESS_MAIN(FieldMapTest)
#include "field_map_test.moc"
