#include "core/skin/crack_lips.h"

#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/skin/fragments.h"
#include "core/skin/knife_slit.h"
#include "core/skin/label_seams.h"
#include "core/skin/torn_surface.h"
#include "support/shapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

using namespace knead;

namespace {

const Vec3 size(0.06, 0.02, 0.02);

/// Connections that go through a plane at places that are to be cut.
std::vector<BrokenConnection> cutAlong(const Aggregate& aggregate, const Vec3& point, const Vec3& normal,
                                       const std::function<bool(const Vec3&)>& isCut)
{
    std::vector<BrokenConnection> broken;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower) {
                const Vec3 from = aggregate.lattice.position(lower);
                const Vec3 way = aggregate.lattice.position(lower + static_cast<ObjectIndex>(segment.offset)) - from;
                const double here = normal.dot(from - point);
                const double there = here + normal.dot(way);
                if (aggregate.weight[d][lower] > 0 && here * there < 0 && isCut(from + here / (here - there) * way)) {
                    broken.push_back({{d, lower}});
                    broken.back().cutAt = here / (here - there);
                }
            }
    return broken;
}

/// A bar that a knife is half way through, from above.
struct CutBar {
    explicit CutBar(double spacing, double tilt)
        : aggregate(fill(shapes::box(size), {.spacing = spacing}))
        , normal(std::cos(tilt), std::sin(tilt), 0)
        , broken(cutAlong(aggregate, point, normal, [](const Vec3& place) { return place.z() > 0; }))
    {
    }
    double heightOf(const Vec3& place) const { return normal.dot(place - point); }

    Aggregate aggregate;
    Vec3 point{1e-4, 0, 0};
    Vec3 normal;
    std::vector<BrokenConnection> broken;
};

/// Vertices less edges plus faces: 2 for a ball, 0 for a ring.
long eulerNumber(const TriangleMesh& mesh)
{
    std::set<std::uint32_t> vertices;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            vertices.insert(t[i]);
            edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
        }
    return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
           static_cast<long>(mesh.triangles.size());
}

} // namespace

/// The sides of cracks that end within a body.
class CrackLipsTest : public QObject {
    Q_OBJECT

private slots:
    void sidesOfACut_data()
    {
        QTest::addColumn<double>("spacing");
        QTest::addColumn<double>("tilt");
        QTest::newRow("along the lattice") << 0.002 << 0.0;
        QTest::newRow("at an angle") << 0.002 << 0.4;
        QTest::newRow("finer") << 0.0013 << 0.2;
    }

    void sidesOfACut()
    {
        QFETCH(double, spacing);
        QFETCH(double, tilt);
        const CutBar bar(spacing, tilt);
        const Pieces pieces = findPieces(bar.aggregate, bar.broken);
        QCOMPARE(pieces.count, std::size_t{1});
        const CrackLips lips(bar.aggregate, pieces, bar.broken);
        QVERIFY(!lips.isEmpty());
        std::array<std::set<int>, 2> seen; // lips below and above, beside the cut
        for (ObjectIndex i = 0; i < bar.aggregate.size(); ++i) {
            const Vec3 place = bar.aggregate.lattice.position(i);
            const double height = bar.heightOf(place);
            if (place.z() > spacing && std::abs(height) < 3 * spacing)
                seen[height > 0 ? 1 : 0].insert(lips.ofObject()[i]);
        }
        QCOMPARE(seen[0].size(), std::size_t{1});
        QCOMPARE(seen[1].size(), std::size_t{1});
        QVERIFY(seen[0] != seen[1]);
        const Vec3 along(-bar.normal.y(), bar.normal.x(), 0);
        for (double share = -0.4; share < 0.5; share += 0.2) {
            const Vec3 low = bar.point + share * size.y() * along;
            QVERIFY(lips.isOpen(low + Vec3(0, 0, 1.5 * spacing)));
            QVERIFY(!lips.isOpen(low - Vec3(0, 0, 1.5 * spacing)));
            QVERIFY(lips.isBeside(low + Vec3(0, 0, 1.5 * spacing) + spacing * bar.normal));
            QVERIFY(!lips.isBeside(low - Vec3(0, 0, 4 * spacing)));
        }
    }

    void damageHasNoSides()
    {
        const Aggregate aggregate = fill(shapes::box(size), {.spacing = 0.002});
        std::mt19937 random(3);
        std::vector<BrokenConnection> spread;
        for (std::uint32_t d = 0; d < Lattice::isotropicCount; ++d)
            for (ObjectIndex i = 0; i < aggregate.size(); ++i)
                if (aggregate.weight[d][i] > 0 && random() % 4 == 0)
                    spread.push_back({{d, i}});
        QVERIFY(spread.size() > 1000);
        QVERIFY(CrackLips(aggregate, findPieces(aggregate, spread), spread).isEmpty());
        const CutBar bar(0.002, 0);
        const std::vector<BrokenConnection> few(bar.broken.begin(), bar.broken.begin() + 6);
        QVERIFY(CrackLips(bar.aggregate, findPieces(bar.aggregate, few), few).isEmpty());
        QVERIFY(CrackLips(bar.aggregate, findPieces(bar.aggregate), {}).isEmpty());
    }

    void surfacesOpen_data() { sidesOfACut_data(); }

    /// Closed and of the volume it had at rest; and where the sides are turned apart each goes its own way, to the edge of the cut.
    void surfacesOpen()
    {
        QFETCH(double, spacing);
        QFETCH(double, tilt);
        const CutBar bar(spacing, tilt);
        const TriangleMesh skin = refine(shapes::box(size), spacing, 200'000);
        const auto torn = tornSurface(bar.aggregate, skin, bar.broken);
        QVERIFY(torn);
        QVERIFY(isWatertight(torn->mesh));
        QCOMPARE(eulerNumber(torn->mesh), 2L);
        QVERIFY(std::abs(massProperties(torn->mesh).volume / size.prod() - 1) < 1e-9);
        const auto expected = [&](const Vec3& place, double side) {
            const double way = 20 * std::pow(std::max(0.0, place.z()), 2);
            return Vec3(side * way * bar.normal);
        };
        std::vector<Vec3> displacement;
        for (ObjectIndex i = 0; i < bar.aggregate.size(); ++i) {
            const Vec3 place = bar.aggregate.lattice.position(i);
            displacement.push_back(expected(place, bar.heightOf(place) > 0 ? 1 : -1));
        }
        std::vector<Vec3> places(torn->mesh.vertices.size());
        torn->skin.evaluate(displacement, places);
        std::size_t onCut = 0;
        double lowest = 1;
        for (std::size_t t = 0; t < torn->mesh.triangles.size(); ++t) {
            if (torn->mesh.faceOfTriangle[t] != Fragment::crackFace)
                continue;
            const auto& [a, b, c] = torn->mesh.triangles[t];
            const std::vector<Vec3>& v = torn->mesh.vertices;
            const double side = (v[b] - v[a]).cross(v[c] - v[a]).dot(bar.normal) > 0 ? -1 : 1; // outwards
            for (const std::uint32_t corner : {a, b, c}) {
                lowest = std::min(lowest, v[corner].z());
                QVERIFY(std::abs(bar.heightOf(v[corner])) < 0.1 * spacing);
                if (v[corner].z() < 1.5 * spacing)
                    continue;
                ++onCut;
                const double off = (places[corner] - v[corner] - expected(v[corner], side)).norm();
                QVERIFY2(off < 0.1 * spacing, qPrintable(QString::number(off / spacing)));
            }
        }
        QVERIFY(onCut > 100);
        QVERIFY2(std::abs(lowest) < spacing, qPrintable(QString::number(lowest / spacing)));
    }

    /// Two cubes side by side as one piece: whole, cut into along one of the two triangles between them, and parted.
    void cubesAreSewn()
    {
        CutTriangles cubes;
        const auto point = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return 4 * x + 2 * y + z; };
        const auto placeOf = [](std::uint32_t p) { return Vec3(p / 4, p / 2 % 2, p % 2); };
        for (std::uint32_t cube = 0; cube < 2; ++cube)
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (std::uint32_t side = 0; side < 2; ++side) {
                    std::array<std::uint32_t, 4> corners{};
                    constexpr std::array<std::array<std::uint32_t, 2>, 4> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
                    for (std::size_t i = 0; i < 4; ++i) {
                        std::array<std::uint32_t, 3> at{};
                        at[axis] = side;
                        at[(axis + 1) % 3] = around[i][0];
                        at[(axis + 2) % 3] = around[i][1];
                        corners[side == 1 ? i : 3 - i] = point(cube + at[0], at[1], at[2]);
                    }
                    for (const TriangleMesh::Triangle& t :
                         {TriangleMesh::Triangle{corners[0], corners[1], corners[2]},
                          TriangleMesh::Triangle{corners[0], corners[2], corners[3]}}) {
                        if (axis == 0 && side == 1 && cube == 0)
                            cubes.cracks.push_back({t, 0, 1});
                        else if (axis != 0 || side == 1 || cube == 0)
                            cubes.skin.push_back({t, 7, cube});
                    }
                }
        QCOMPARE(cubes.cracks.size(), std::size_t{2});
        const auto sewnWhere = [&](const std::function<bool(const Vec3&)>& isOpen) {
            const std::vector<SewnMesh> pieces =
                sewn(cubes, placeOf, {.pieceOf = [](std::uint32_t) { return 5U; }, .isOpen = isOpen});
            return pieces.size() == 1 && pieces[0].piece == 5 ? pieces[0] : SewnMesh{};
        };
        const auto onCrack = [](const SewnMesh& sewn) {
            return std::ranges::count(sewn.mesh.faceOfTriangle, Fragment::crackFace);
        };
        const SewnMesh whole = sewnWhere([](const Vec3&) { return false; });
        const SewnMesh half = sewnWhere([](const Vec3& place) { return place.y() > place.z(); });
        const SewnMesh parted = sewnWhere([](const Vec3&) { return true; });
        for (const SewnMesh* each : {&whole, &half, &parted}) {
            QVERIFY(isWatertight(each->mesh));
            QVERIFY(std::abs(massProperties(each->mesh).volume - 2) < 1e-12);
        }
        QCOMPARE(onCrack(whole), 0);
        QCOMPARE(onCrack(half), 2);
        QCOMPARE(onCrack(parted), 4);
        QCOMPARE(whole.mesh.vertices.size(), std::size_t{12});
        QCOMPARE(half.mesh.vertices.size(), std::size_t{13});
        QCOMPARE(parted.mesh.vertices.size(), std::size_t{16});
        QCOMPARE(std::ranges::count(whole.labelOfVertex, SewnMesh::manyLabels), 4);
        QCOMPARE(std::ranges::count(parted.labelOfVertex, SewnMesh::manyLabels), 0);
    }

    /// It is one piece still, and no ring any more.
    void ringsAreCutOpen()
    {
        const TriangleMesh mesh = shapes::torus(0.02, 0.006, 64, 24);
        QCOMPARE(eulerNumber(mesh), 0L);
        const Aggregate aggregate = fill(mesh, {.spacing = 0.0015});
        const std::vector<BrokenConnection> broken =
            cutAlong(aggregate, Vec3(0, 2e-4, 0), Vec3::UnitY(), [](const Vec3& place) { return place.x() > 0; });
        QCOMPARE(findPieces(aggregate, broken).count, std::size_t{1});
        const auto torn = tornSurface(aggregate, refine(mesh, 0.0015, 200'000), broken);
        QVERIFY(torn);
        QVERIFY(isWatertight(torn->mesh));
        QCOMPARE(eulerNumber(torn->mesh), 2L);
        QVERIFY(std::abs(massProperties(torn->mesh).volume / massProperties(mesh).volume - 1) < 1e-9);
        const auto slit = findKnifeSlit(aggregate, broken);
        QVERIFY(slit);
        QVERIFY(!slit->hasTip);
        QVERIFY(std::abs(slit->normal().y()) > 1 - 1e-9);
    }

    void slitsOfKnives_data() { sidesOfACut_data(); }

    void slitsOfKnives()
    {
        QFETCH(double, spacing);
        QFETCH(double, tilt);
        const CutBar bar(spacing, tilt);
        const auto slit = findKnifeSlit(bar.aggregate, bar.broken);
        QVERIFY(slit);
        QVERIFY(slit->hasTip);
        QVERIFY((slit->opening - Vec3::UnitZ()).norm() < 0.05);
        QVERIFY(std::abs(std::abs(slit->normal().dot(bar.normal)) - 1) < 1e-6);
        QVERIFY2(std::abs(slit->origin.z()) < 0.6 * spacing, qPrintable(QString::number(slit->origin.z() / spacing)));
        QVERIFY(std::abs(bar.heightOf(slit->origin)) < 0.01 * spacing);
        QVERIFY(slit->origin.z() + slit->length > size.z() / 2);
        const double sense = slit->normal().dot(bar.normal);
        std::vector<Vec3> apart;
        for (ObjectIndex i = 0; i < bar.aggregate.size(); ++i) {
            const Vec3 place = bar.aggregate.lattice.position(i);
            const double height = bar.heightOf(place);
            if (place.z() > spacing && std::abs(height) < 3 * spacing)
                QCOMPARE(int(slit->lipOfObject[i]), height * sense > 0 ? 2 : 1);
            apart.push_back((height > 0 ? 20 : -20) * std::pow(std::max(0.0, place.z()), 2) * bar.normal);
        }
        const SlitMap map(bar.aggregate, *slit, apart);
        for (const double z : {2 * spacing, 0.35 * size.z(), 0.49 * size.z()})
            for (const double side : {-1.0, 1.0}) {
                const Vec3 place = bar.point + side * 1e-4 * spacing * bar.normal + Vec3(0, 0, z);
                const Vec3 off = map.at(place) - place - side * 20 * z * z * bar.normal;
                QVERIFY2(off.norm() < 0.05 * spacing, qPrintable(QString::number(off.norm() / spacing)));
                // A face on this side is carried on beyond the cut as it was before it.
                const std::vector<Vec3> face{place, place + side * spacing * bar.normal};
                const Vec3 behind = place - side * 0.2 * spacing * bar.normal;
                const Vec3 there = map.ofFace(face).at(behind) - behind - side * 20 * z * z * bar.normal;
                QVERIFY2(there.norm() < 0.1 * spacing, qPrintable(QString::number(there.norm() / spacing)));
            }
        // No jumps on the way through the material below the tip.
        for (double z = -0.45 * size.z(); z < -0.5 * spacing; z += 0.1 * spacing) {
            const Vec3 below = bar.point + Vec3(0, 0, z) - 1e-4 * spacing * bar.normal;
            const Vec3 above = bar.point + Vec3(0, 0, z) + 1e-4 * spacing * bar.normal;
            QVERIFY((map.at(above) - map.at(below)).norm() < 0.01 * spacing);
        }
        QVERIFY(&map.ofFace(std::vector<Vec3>{bar.point - 0.01 * bar.normal, bar.point + 0.01 * bar.normal}) == &map);
    }

    void whatIsNoSlit()
    {
        CutBar bar(0.002, 0);
        std::vector<BrokenConnection> torn = bar.broken;
        torn.front().cutAt = 0;
        QVERIFY(!findKnifeSlit(bar.aggregate, torn));
        std::vector<BrokenConnection> severed =
            cutAlong(bar.aggregate, bar.point, bar.normal, [](const Vec3&) { return true; });
        QVERIFY(!findKnifeSlit(bar.aggregate, severed));
        std::vector<BrokenConnection> two = bar.broken; // and another, elsewhere
        const auto other = cutAlong(bar.aggregate, Vec3(0.015, 0, 0), Vec3(1, 0, 0),
                                    [](const Vec3& place) { return place.z() > 0.003; });
        two.insert(two.end(), other.begin(), other.end());
        std::ranges::sort(two, {}, [](const BrokenConnection& one) { return ConnectionId(one); });
        QVERIFY(!findKnifeSlit(bar.aggregate, two));
        // A knife that is narrower than the bar leaves a slot, whose end is not straight.
        const auto slot = cutAlong(bar.aggregate, bar.point, bar.normal,
                                   [](const Vec3& place) { return place.z() > 0 && std::abs(place.y()) < 0.004; });
        QVERIFY(!findKnifeSlit(bar.aggregate, slot));
        QVERIFY(!findKnifeSlit(bar.aggregate, {}));
    }

    /// Two cuts, one of them a slot, in any place: closed, of the same volume, and no ball with handles.
    void anyTwoCutsOpen()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> real(-1, 1);
        const double spacing = 0.0016;
        const Aggregate aggregate = fill(shapes::box(size), {.spacing = spacing});
        const TriangleMesh skin = refine(shapes::box(size), spacing, 200'000);
        int opened = 0;
        for (int run = 0; run < 8; ++run) {
            std::map<ConnectionId, BrokenConnection> broken;
            for (int cut = 0; cut < 2; ++cut) {
                const Vec3 normal = Vec3(1, 0.6 * real(random), 0.6 * real(random)).normalized();
                const Vec3 point(0.014 * (2 * cut - 1) + 0.004 * real(random), 0, 0);
                const double depth = 0.006 * real(random);
                const double half = cut == 0 ? 1 : 0.005;
                for (const BrokenConnection& one : cutAlong(aggregate, point, normal, [&](const Vec3& place) {
                         return place.z() > depth && std::abs(place.y()) < half;
                     }))
                    broken[one] = one;
            }
            std::vector<BrokenConnection> all;
            for (const auto& [id, one] : broken)
                all.push_back(one);
            if (findPieces(aggregate, all).count > 1)
                continue;
            const auto torn = tornSurface(aggregate, skin, all);
            QVERIFY(torn);
            QVERIFY(isWatertight(torn->mesh));
            QVERIFY(std::abs(massProperties(torn->mesh).volume / size.prod() - 1) < 1e-9);
            QCOMPARE(eulerNumber(torn->mesh), 2L);
            ++opened;
        }
        QVERIFY(opened > 5);
    }
};

QTEST_APPLESS_MAIN(CrackLipsTest)
#include "crack_lips_test.moc"
