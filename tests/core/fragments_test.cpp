#include "support/thread_limit.h"

#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/simulation/simulation.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/fragments.h"
#include "core/skin/skin.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QtTest>

#include <functional>
#include <map>
#include <set>

using namespace knead;

namespace {

/// Which part a place is in; connections between objects in different parts break.
using Parts = std::function<int(const Vec3&)>;

std::vector<BrokenConnection> brokenBetween(const Aggregate& aggregate, const Parts& parts)
{
    std::vector<BrokenConnection> broken;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex o = segment.begin; o < segment.end; ++o)
                if (aggregate.weight[d][o] > 0 &&
                    parts(aggregate.lattice.position(o)) !=
                        parts(aggregate.lattice.position(o + static_cast<ObjectIndex>(segment.offset))))
                    broken.push_back({d, o});
    return broken;
}

/// A body and how it is broken.
struct Break {
    TriangleMesh mesh;
    Aggregate aggregate;
    std::vector<BrokenConnection> broken;

    Break(const TriangleMesh& skin, double spacing, const Parts& parts)
        : mesh(skin)
        , aggregate(fill(skin, {.spacing = spacing}))
        , broken(brokenBetween(aggregate, parts))
    {
    }
    std::vector<Fragment> fragments() const { return fragmentsOf(aggregate, mesh, broken); }
};

using Corners = std::array<std::array<double, 3>, 3>;

Corners cornersOf(const TriangleMesh& mesh, std::size_t t)
{
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            corners[i][j] = mesh.vertices[mesh.triangles[t][i]][static_cast<Eigen::Index>(j)];
    const auto least = std::min_element(corners.begin(), corners.end());
    std::rotate(corners.begin(), least, corners.end());
    return corners;
}

Vec3 areaOf(const TriangleMesh& mesh, std::size_t t)
{
    const auto& [a, b, c] = mesh.triangles[t];
    return 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

/// What every set of fragments owes, whatever broke. Empty when it is all there.
std::string complaint(const Break& b, const std::vector<Fragment>& fragments)
{
    std::ostringstream text;
    const double whole = massProperties(b.mesh).volume;
    double sum = 0;
    std::vector<int> owners(b.aggregate.size(), 0);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& fragment = fragments[i];
        sum += fragment.volume;
        if (!isWatertight(fragment.mesh))
            text << "fragment " << i << " is open. ";
        if (fragment.volume <= 0)
            text << "fragment " << i << " has a volume of " << fragment.volume << ". ";
        if (fragment.isUncut)
            text << "fragment " << i << " is uncut. ";
        if (std::abs(fragment.volume - massProperties(fragment.mesh).volume) > 1e-12 * whole)
            text << "fragment " << i << " tells another volume than it has. ";
        for (const auto& objects : {fragment.objects, fragment.dust})
            for (const ObjectIndex object : objects)
                ++owners[object];
    }
    if (std::abs(sum / whole - 1) > 1e-9)
        text << "volumes add up to " << sum / whole << " of the whole. ";
    if (std::any_of(owners.begin(), owners.end(), [](int n) { return n != 1; }))
        text << "objects are not shared out. ";

    // Each crack triangle is there twice, once either way round, with the same bits.
    std::map<Corners, int> cracks;
    for (const Fragment& fragment : fragments)
        for (std::size_t t = 0; t < fragment.mesh.triangles.size(); ++t)
            if (fragment.mesh.faceOfTriangle.size() > t && fragment.mesh.faceOfTriangle[t] == Fragment::crackFace) {
                Corners corners = cornersOf(fragment.mesh, t);
                const bool isTurned = corners[2] < corners[1];
                if (isTurned)
                    std::swap(corners[1], corners[2]);
                cracks[corners] += isTurned ? 1 : -1;
            }
    if (std::any_of(cracks.begin(), cracks.end(), [](const auto& c) { return c.second != 0; }))
        text << "a crack has two shapes. ";
    return text.str();
}

/// Largest difference between a fragment's share of the volume and that of its objects.
double largestShareError(const Break& b, const std::vector<Fragment>& fragments)
{
    const double whole = massProperties(b.mesh).volume;
    double largest = 0;
    for (const Fragment& fragment : fragments) {
        double volume = 0;
        for (const auto& objects : {fragment.objects, fragment.dust})
            for (const ObjectIndex object : objects)
                volume += b.aggregate.volume[object];
        largest = std::max(largest, std::abs(fragment.volume - volume) / whole);
    }
    return largest;
}

/// Largest angle of crack triangles to a plane, those below a hundredth of a cell's face left out [degrees]; and the
/// share of their area more than 25 degrees off.
std::pair<double, double> roughness(const std::vector<Fragment>& fragments, const Vec3& normal, double spacing)
{
    double largest = 0;
    double off = 0;
    double all = 0;
    for (const Fragment& fragment : fragments)
        for (std::size_t t = 0; t < fragment.mesh.triangles.size(); ++t) {
            if (fragment.mesh.faceOfTriangle[t] != Fragment::crackFace)
                continue;
            const Vec3 area = areaOf(fragment.mesh, t);
            const double angle =
                std::acos(std::min(1.0, std::abs(area.dot(normal)) / area.norm())) * 180 / std::numbers::pi;
            all += area.norm();
            off += angle > 25 ? area.norm() : 0;
            if (area.norm() > 0.01 * spacing * spacing)
                largest = std::max(largest, angle);
        }
    return {largest, off / all};
}

/// Triangles of a mesh that are in none of the fragments.
std::size_t changedTriangles(const Break& b, const std::vector<Fragment>& fragments,
                             const std::function<bool(const Vec3&)>& where)
{
    std::set<Corners> kept;
    for (const Fragment& fragment : fragments)
        for (std::size_t t = 0; t < fragment.mesh.triangles.size(); ++t)
            kept.insert(cornersOf(fragment.mesh, t));
    std::size_t changed = 0;
    for (std::size_t t = 0; t < b.mesh.triangles.size(); ++t) {
        const auto& corners = b.mesh.triangles[t];
        const bool isWanted =
            std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return where(b.mesh.vertices[v]); });
        changed += isWanted && !kept.contains(cornersOf(b.mesh, t)) ? 1 : 0;
    }
    return changed;
}

Parts halves(const Vec3& normal, double offset = 0)
{
    return [normal, offset](const Vec3& X) { return normal.dot(X) > offset ? 1 : 0; };
}

/// Which of five seeds is nearest to a place in the x-y plane: a plate broken into five.
int nearestSeed(const Vec3& X)
{
    const double seeds[5][2] = {{0.3, 0.2}, {-6, 4}, {6.5, 5}, {5, -5.5}, {-5.5, -4.5}};
    int best = 0;
    for (int i = 1; i < 5; ++i)
        if (std::hypot(X.x() - seeds[i][0], X.y() - seeds[i][1]) <
            std::hypot(X.x() - seeds[best][0], X.y() - seeds[best][1]))
            best = i;
    return best;
}

/// Two disks with a thin neck between.
struct Spool {
    std::pair<double, double> operator()(std::uint32_t ring) const
    {
        constexpr std::pair<double, double> rings[] = {{4, 0}, {4, 4}, {0.15, 4}, {0.15, 8}, {4, 8}, {4, 12}};
        return rings[ring];
    }
    std::pair<double, double> tips() const { return {0, 12}; }
};

struct Case {
    const char* name;
    std::function<Break()> make;
    std::size_t fragments;
    double shareError; // of the whole volume
};

const std::vector<Case>& cases()
{
    using namespace shapes;
    static const std::vector<Case> all{
        {"box between nodes",
         [] {
             return Break(box({16, 4, 4}), 1, halves(Vec3::UnitX(), 0.5));
         },
         2, 0.01},
        {"box, refined",
         [] {
             return Break(refine(box({16, 4, 4}), 1), 1, halves(Vec3::UnitX(), 0.5));
         },
         2, 0.01},
        {"box, refined to halves",
         [] {
             return Break(refine(box({16, 4, 4}), 0.5), 1, halves(Vec3::UnitY(), 0.5));
         },
         2, 0.01},
        {"box, slanted",
         [] {
             return Break(box({16, 6, 6}), 1, halves(Vec3(1, 0.7, 0.3).normalized(), 0.2));
         },
         2, 0.01},
        {"box, slanted, fine",
         [] {
             return Break(box({16, 6, 6}), 0.4, halves(Vec3(1, 0.7, 0.3).normalized(), 0.2));
         },
         2, 0.01},
        {"box, rough",
         [] {
             return Break(box({16, 6, 6}), 0.5, [](const Vec3& X) {
                 return X.x() + 0.4 * X.y() + 0.5 * std::sin(3 * X.y()) * std::sin(2.3 * X.z() + 1) > 0.1 ? 1 : 0;
             });
         },
         2, 0.01},
        {"tilted box",
         [] {
             return Break(moved(box({16, 4, 4}), tilt(0.6)), 0.5, halves(Vec3(1, 0.2, -0.3)));
         },
         2, 0.01},
        {"tube",
         [] {
             // A tube along z: a torus stretched into one.
             TriangleMesh mesh = closedGrid(60, 4, [](double a, double b) {
                 const double r = 4 + std::sqrt(2.0) * 0.8 * std::cos(b + std::numbers::pi / 4);
                 return Vec3(r * std::cos(a), r * std::sin(a), std::sqrt(2.0) * 8 * std::sin(b + std::numbers::pi / 4));
             });
             return Break(mesh, 0.5, halves(Vec3(0.1, 0.2, 1).normalized(), 0.3));
         },
         2, 0.01},
        {"torus in three",
         [] {
             return Break(torus(6, 2, 80, 30), 0.5, [](const Vec3& X) {
                 return static_cast<int>(std::floor((std::atan2(X.y(), X.x()) + 4) / 2.4));
             });
         },
         3, 0.01},
        {"cylinder in eight",
         [] {
             return Break(cylinder(4, 10, 48), 0.5, [](const Vec3& X) {
                 return (X.x() > 0.1 ? 1 : 0) + (X.y() > 0.2 ? 2 : 0) + (X.z() > -0.3 ? 4 : 0);
             });
         },
         8, 0.01},
        {"plate in five",
         [] {
             return Break(box({20, 16, 1.5}), 0.5, nearestSeed);
         },
         5, 0.01},
        {"tilted plate in five",
         [] {
             const Pose pose = tilt(0.4);
             return Break(moved(box({20, 16, 1.5}), pose), 0.5,
                          [pose](const Vec3& X) { return nearestSeed(pose.toLocal(X)); });
         },
         5, 0.01},
        {"a crater in a large face",
         [] {
             return Break(box({16, 16, 6}), 0.5,
                          [](const Vec3& X) { return (X - Vec3(0.2, -0.1, 3.1)).norm() < 2.6 ? 1 : 0; });
         },
         2, 0.01},
        {"a core within",
         [] {
             return Break(box({12, 12, 12}), 0.5, [](const Vec3& X) { return X.norm() < 3 ? 1 : 0; });
         },
         2, 0.01},
        {"a void within",
         [] {
             return Break(hollowBox({12, 8, 8}, {5, 3, 3}), 0.5, halves(Vec3(1, 0.1, 0), 0.1));
         },
         2, 0.01},
        {"a void in one half",
         [] {
             return Break(hollowBox({12, 8, 8}, {5, 3, 3}), 0.5, halves(Vec3(1, 0.1, 0), 4));
         },
         2, 0.01},
        {"fork", [] { return Break(fork(6, 16, 3, 5, 1.5), 0.5, halves(Vec3::UnitY(), 9.1)); }, 3, 0.01},
        {"two solids, one broken",
         [] {
             return Break(together(box({4, 4, 12}), moved(box({4, 4, 12}), {Vec3(6, 0, 0), Quaternion::Identity()})), 1,
                          [](const Vec3& X) { return X.x() < 3 && X.z() > 0.2 ? 1 : 0; });
         },
         3, 0.01},
        {"two lumps in one shell",
         [] {
             // The neck is too thin to hold objects, so the lumps never were connected. One of them breaks.
             return Break(revolution(24, 6, Spool{}), 1,
                          [](const Vec3& X) { return X.z() < 6 && X.x() > 0.2 ? 1 : 0; });
         },
         3, 0.01},
        {"sphere of planes", [] { return Break(sphere(5, 40), 0.5, halves(Vec3::UnitZ(), 0.1)); }, 2, 0.01},
    };
    return all;
}

class Stop final : public TaskControl {
public:
    explicit Stop(int after)
        : m_left(after)
    {
    }
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return m_left-- <= 0; }

private:
    mutable int m_left;
};

} // namespace

class FragmentsTest : public QObject {
    Q_OBJECT

private slots:
    void fragmentsAreClosedAndAddUp_data()
    {
        QTest::addColumn<std::size_t>("number");
        for (std::size_t i = 0; i < cases().size(); ++i)
            QTest::newRow(cases()[i].name) << i;
    }
    void fragmentsAreClosedAndAddUp()
    {
        QFETCH(std::size_t, number);
        const Break b = cases()[number].make();
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), cases()[number].fragments);
        const std::string text = complaint(b, fragments);
        QVERIFY2(text.empty(), text.c_str());
        const double error = largestShareError(b, fragments);
        qInfo("shares of the volume differ by %.4f", error);
        QVERIFY(error < cases()[number].shareError);
    }

    void aPlaneCrackIsSmooth_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<double>("degrees");
        QTest::newRow("along the lattice") << 1.0 << 0.0 << 0.0 << 3.0;
        QTest::newRow("across a face") << 1.0 << 1.0 << 0.0 << 20.0;
        QTest::newRow("slightly slanted") << 1.0 << 0.2 << 0.1 << 20.0;
        QTest::newRow("slanted") << 1.0 << 0.7 << 0.3 << 20.0;
    }
    void aPlaneCrackIsSmooth()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(double, degrees);
        const Vec3 normal = Vec3(x, y, z).normalized();
        const Break b(shapes::box({24, 10, 10}), 0.5, halves(normal, 0.23));
        const auto [largest, share] = roughness(b.fragments(), normal, 0.5);
        qInfo("at most %.2f degrees from the plane, %.4f of the area above 25", largest, share);
        QVERIFY(largest < degrees);
        QVERIFY(share < 0.01);
    }

    void trianglesOffTheCrackStay()
    {
        const Break b(refine(shapes::moved(shapes::cylinder(3, 16, 40), shapes::tilt(0.5)), 0.6), 0.5,
                      halves(Vec3(1, 1, 0).normalized()));
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), std::size_t{2});
        const auto isFar = [](const Vec3& X) { return std::abs(X.dot(Vec3(1, 1, 0).normalized())) > 1.0; };
        QCOMPARE(changedTriangles(b, fragments, isFar), std::size_t{0});
        QVERIFY(changedTriangles(b, fragments, [](const Vec3&) { return true; }) > 0);
        for (const Fragment& fragment : fragments)
            for (std::size_t t = 0; t < fragment.mesh.triangles.size(); ++t)
                QVERIFY(fragment.mesh.faceOfTriangle[t] == Fragment::crackFace || fragment.mesh.faceOfTriangle[t] <= 2);
    }

    void aCrackThatDoesNotSeverLeavesTheSurface()
    {
        Break b(shapes::box({16, 4, 4}), 0.5, halves(Vec3::UnitX(), 0.3));
        std::erase_if(b.broken, [&](const ConnectionId& c) { return b.aggregate.lattice.position(c.lower).y() > 1; });
        QVERIFY(!b.broken.empty());
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), std::size_t{1});
        QVERIFY(fragments[0].mesh.vertices == b.mesh.vertices);
        QVERIFY(fragments[0].mesh.triangles == b.mesh.triangles);
        QVERIFY(fragments[0].mesh.faceOfTriangle == b.mesh.faceOfTriangle);
        QCOMPARE(fragments[0].objects.size(), b.aggregate.size());
        QVERIFY(std::abs(fragments[0].volume / 256 - 1) < 1e-12);
    }

    void dustJoinsWhatItBrokeOff()
    {
        // Two objects in the middle of the high half come loose; the bar is severed elsewhere.
        const auto parts = [](const Vec3& X) { return X.x() < 0.3 ? 0 : (X - Vec3(4, 0, 0.25)).norm() < 0.4 ? 1 : 2; };
        const Break b(shapes::box({16, 4, 4}), 0.5, parts);
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), std::size_t{2});
        QVERIFY2(complaint(b, fragments).empty(), complaint(b, fragments).c_str());
        QCOMPARE(fragments[0].dust.size(), std::size_t{0});
        QCOMPARE(fragments[1].dust.size(), std::size_t{2});
        QVERIFY(parts(b.aggregate.lattice.position(fragments[1].dust[0])) == 1);

        // Taken for a piece by themselves, they have a shape.
        const std::vector<Fragment> all = fragmentsOf(b.aggregate, b.mesh, b.broken, {.leastObjects = 2});
        QCOMPARE(all.size(), std::size_t{3});
        QVERIFY2(complaint(b, all).empty(), complaint(b, all).c_str());
        const auto speck =
            std::min_element(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.volume < q.volume; });
        qInfo("two objects of 0.25 together have a shape of %.3f", speck->volume);
        QVERIFY(speck->volume > 0.1 && speck->volume < 0.4);
    }

    void aBodyOfDustStaysWhole()
    {
        const Break b(shapes::box({4, 4, 4}), 1, [](const Vec3& X) {
            return static_cast<int>(std::lround(X.x()) * 100 + std::lround(X.y()) * 10 + std::lround(X.z()));
        });
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), std::size_t{1});
        QCOMPARE(fragments[0].objects.size(), std::size_t{1});
        QCOMPARE(fragments[0].dust.size(), b.aggregate.size() - 1);
        QVERIFY(!fragments[0].isUncut);
        QVERIFY(fragments[0].mesh.triangles == b.mesh.triangles);
    }

    void openSurfacesAreRefused()
    {
        Break b(shapes::box({8, 2, 2}), 0.5, halves(Vec3::UnitX(), 0.3));
        b.mesh.triangles.pop_back();
        QVERIFY_EXCEPTION_THROWN(b.fragments(), std::invalid_argument);
    }

    void bitsDoNotDependOnThreads()
    {
        const Break b(refine(shapes::box({20, 16, 1.5}), 0.5), 0.25, nearestSeed);
        const auto on = [&](int threads) { return onThreads(threads, [&] { return b.fragments(); }); };
        const std::vector<Fragment> one = on(1);
        QCOMPARE(one.size(), std::size_t{5});
        for (const int threads : {2, 4}) {
            const std::vector<Fragment> more = on(threads);
            QCOMPARE(more.size(), one.size());
            for (std::size_t i = 0; i < one.size(); ++i) {
                QVERIFY(more[i].mesh.vertices == one[i].mesh.vertices);
                QVERIFY(more[i].mesh.triangles == one[i].mesh.triangles);
                QVERIFY(more[i].mesh.faceOfTriangle == one[i].mesh.faceOfTriangle);
                QVERIFY(more[i].objects == one[i].objects);
            }
        }
    }

    void cancelStopsIt()
    {
        const Break b(shapes::box({20, 16, 1.5}), 0.5, nearestSeed);
        for (int after : {0, 1, 2, 3, 5}) {
            Stop stop(after);
            QVERIFY_EXCEPTION_THROWN(fragmentsOf(b.aggregate, b.mesh, b.broken, {}, stop), Cancelled);
        }
    }

    /// Each half moves its own way; a skin that gathered across the crack would pull its vertices along.
    void fragmentsAreCarriedByTheirOwnObjects()
    {
        const Break b(shapes::moved(shapes::box({16, 5, 5}), shapes::tilt(0.4)), 0.5,
                      halves(Vec3(1, 0.3, 0.2).normalized(), 0.1));
        const std::vector<Fragment> fragments = b.fragments();
        QCOMPARE(fragments.size(), std::size_t{2});
        std::vector<Vec3> displacement(b.aggregate.size());
        std::vector<Pose> moves(2);
        for (std::size_t i = 0; i < 2; ++i) {
            moves[i] = shapes::tilt(i == 0 ? 0.8 : -0.5, Vec3(i == 0 ? -9 : 7, 3, 1));
            for (const ObjectIndex object : fragments[i].objects) {
                const Vec3 X = b.aggregate.lattice.position(object);
                displacement[object] = moves[i].toWorld(X) - X;
            }
        }
        const auto places = carried(b.aggregate, fragments, b.broken, displacement);
        for (std::size_t i = 0; i < 2; ++i) {
            double worst = 0;
            for (std::size_t v = 0; v < places[i].places.size(); ++v)
                worst = std::max(worst, (places[i].places[v] - moves[i].toWorld(fragments[i].mesh.vertices[v])).norm());
            qInfo("largest error %.2e", worst);
            QVERIFY(worst < 1e-4); // weights are in single precision
        }
    }

    void aStripPulledApartKeepsClosedPieces()
    {
        constexpr double spacing = 2e-3;
        Scene scene;
        Material material;
        material.youngsModulus = 1e6;
        material.dampingRatio = 0.1;
        material.tensileStrength = 2e4;
        scene.bodies.push_back(scenes::box({24, 5, 5}, spacing, material));
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        Material strong = material; // where it is gripped
        strong.tensileStrength = 0;
        const double half = 12 * spacing;
        for (const double side : {-1.0, 1.0}) {
            const auto between = [&](double from, double to) {
                return objectsInBox(aggregate, Box(Vec3(std::min(side * from, side * to), -1, -1),
                                                   Vec3(std::max(side * from, side * to), 1, 1)));
            };
            scene.bodies[0].regions.push_back({"shoulder", between(half - 6.1 * spacing, 1), strong});
            scene.fixtures.push_back({"grip", 0, between(half - 1e-6, 1), Vec3(0.02 * side, 0, 0)});
        }
        Simulation simulation(scene);
        while (simulation.health().ok && simulation.time() < 0.12)
            simulation.step();
        QVERIFY2(simulation.health().ok, simulation.health().message.english().c_str());
        const auto shot = simulation.snapshot();
        QVERIFY(shot->components >= 2);
        const Snapshot::BodyState& body = shot->bodies[0];
        QVERIFY(body.broken && body.broken->size() == shot->broken);
        QCOMPARE(simulation.snapshot()->bodies[0].broken.get(), body.broken.get());

        const TriangleMesh skin = refine(shapes::box({24 * spacing, 5 * spacing, 5 * spacing}), spacing);
        const std::vector<Fragment> fragments = fragmentsOf(aggregate, skin, *body.broken);
        QVERIFY(fragments.size() >= 2);
        const auto places = carried(aggregate, fragments, *body.broken, body.displacements());
        const double cell = std::pow(spacing, 3);
        double sum = 0;
        double farthest = 0;
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            QVERIFY(isWatertight(fragments[i].mesh));
            TriangleMesh moved = fragments[i].mesh;
            moved.vertices = places[i].places;
            const double volume = massProperties(moved).volume;
            sum += volume;
            qInfo("%zu objects, %zu of dust, volume %.3f cells at rest and %.3f as it is", fragments[i].objects.size(),
                  fragments[i].dust.size(), fragments[i].volume / cell, volume / cell);
            QVERIFY(std::abs(volume / fragments[i].volume - 1) < 0.1);
            for (const Vec3& place : places[i].places) {
                double nearest = 1;
                for (const ObjectIndex object : fragments[i].objects)
                    nearest = std::min(nearest, (place - body.positions[object]).norm());
                farthest = std::max(farthest, nearest);
            }
        }
        qInfo("no vertex is more than %.2f spacings from an object", farthest / spacing);
        QVERIFY(farthest < 1.5 * spacing);
        QVERIFY(std::abs(sum / (600 * cell) - 1) < 0.05);
    }
};

QTEST_APPLESS_MAIN(FragmentsTest)
#include "fragments_test.moc"
