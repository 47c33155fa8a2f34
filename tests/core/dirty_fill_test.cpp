#include "support/thread_limit.h"

#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"
#include "support/shapes.h"

#include <QtTest>

#include <random>

using namespace knead;

namespace {

constexpr double spacing = 0.17;

enum class Damage { removed, doubled, flipped };

/// The same triangles each time: a generator of fixed seed.
TriangleMesh damaged(TriangleMesh mesh, double share, std::initializer_list<Damage> kinds)
{
    mesh.faceOfTriangle.clear();
    std::mt19937 random(7);
    for (const Damage kind : kinds) {
        std::vector<TriangleMesh::Triangle> triangles;
        for (TriangleMesh::Triangle t : mesh.triangles) {
            const bool hit = static_cast<double>(random()) < share * 4294967296.0;
            if (hit && kind == Damage::flipped)
                std::swap(t[0], t[1]);
            if (!hit || kind != Damage::removed)
                triangles.push_back(t);
            if (hit && kind == Damage::doubled)
                triangles.push_back(t);
        }
        mesh.triangles = triangles;
    }
    return mesh;
}

Aggregate fillDirty(const TriangleMesh& mesh, double a = spacing)
{
    return fill(mesh, {.spacing = a, .dirty = DirtySurface::windingNumber});
}

std::string messageOf(const TriangleMesh& mesh)
{
    try {
        fillDirty(mesh);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

void compareBits(const Aggregate& a, const Aggregate& b)
{
    QVERIFY(a.lattice.nodes == b.lattice.nodes);
    QVERIFY(a.weight == b.weight);
    QVERIFY(a.volume == b.volume);
    QVERIFY(a.depth == b.depth);
    QVERIFY(a.face == b.face);
    QCOMPARE(a.filledVolume, b.filledVolume);
    QVERIFY(a.repair == b.repair);
}

TriangleMesh fineBox()
{
    return shapes::moved(refine(shapes::box(Vec3(2, 2, 3)), 0.25), shapes::tilt(0.4));
}

} // namespace

class DirtyFillTest : public QObject {
    Q_OBJECT

private slots:
    void cleanSurfacesGiveTheSameBits_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::newRow("box") << shapes::box(Vec3(2, 1.1, 3));
        QTest::newRow("tilted box") << fineBox();
        QTest::newRow("hollow box") << shapes::hollowBox(Vec3(2, 2, 3), Vec3(1, 1, 1.3));
        QTest::newRow("torus") << shapes::moved(shapes::torus(2, 0.7, 60, 30), shapes::tilt(0.9));
        QTest::newRow("inside out") << shapes::insideOut(shapes::sphere(1, 40));
    }
    void cleanSurfacesGiveTheSameBits()
    {
        QFETCH(TriangleMesh, mesh);
        compareBits(fillDirty(mesh), fill(mesh, {.spacing = spacing}));
    }

    void damagedSurfacesKeepTheirVolume_data()
    {
        QTest::addColumn<TriangleMesh>("whole");
        QTest::addColumn<TriangleMesh>("broken");
        const std::pair<const char*, TriangleMesh> shapes[] = {
            {"ball", shapes::sphere(1.5, 60)},
            {"ring", shapes::moved(shapes::torus(2, 0.7, 80, 30), shapes::tilt(0.9))},
            {"box", fineBox()},
            {"box along the lattice", refine(shapes::box(Vec3(2, 2, 3)), 0.25)}};
        for (const auto& [name, mesh] : shapes)
            for (const double share : {0.01, 0.05}) {
                const auto row = [&](const char* what, const TriangleMesh& broken) {
                    QTest::newRow(qPrintable(QString("%1, %2 %3 %").arg(name).arg(what).arg(100 * share)))
                        << mesh << broken;
                };
                row("removed", damaged(mesh, share, {Damage::removed}));
                row("doubled", damaged(mesh, share, {Damage::doubled}));
                row("flipped", damaged(mesh, share, {Damage::flipped}));
                row("all of it", damaged(mesh, share, {Damage::doubled, Damage::flipped, Damage::removed}));
            }
    }
    void damagedSurfacesKeepTheirVolume()
    {
        QFETCH(TriangleMesh, whole);
        QFETCH(TriangleMesh, broken);
        const Aggregate expected = fill(whole, {.spacing = spacing});
        const Aggregate found = fillDirty(broken);
        const double error = found.filledVolume / expected.filledVolume - 1;
        QVERIFY2(std::abs(error) < 0.003, qPrintable(QString::number(error)));
        std::size_t wrong = 0; // objects that should not be, or are not
        double material = 0;   // and what they stand for
        const auto compare = [&](const Aggregate& one, const Aggregate& other) {
            for (ObjectIndex i = 0; i < one.size(); ++i)
                if (other.lattice.find(one.lattice.nodes[i]) == other.size()) {
                    ++wrong;
                    material += one.volume[i];
                }
        };
        compare(found, expected);
        compare(expected, found);
        const double share = static_cast<double>(wrong) / static_cast<double>(expected.size());
        QVERIFY2(share < 0.015, qPrintable(QString::number(share)));
        QVERIFY2(material < 0.001 * expected.filledVolume,
                 qPrintable(QString::number(material / expected.filledVolume)));
    }

    void overlappingBoxesCountOnce()
    {
        // 2 x 1 x 1 and 1 x 1 x 2, with a corner of 1 x 0.6 x 0.7 in both.
        const TriangleMesh mesh = shapes::together(shapes::box(Vec3(2, 1, 1)),
                                                   shapes::moved(shapes::box(Vec3(1, 1, 2)), {Vec3(0.5, 0.4, 0.8)}));
        const double expected = 4 - 1 * 0.6 * 0.7;
        const Aggregate found = fillDirty(mesh, 0.07);
        const double error = found.filledVolume / expected - 1;
        QVERIFY2(std::abs(error) < 0.005, qPrintable(QString::number(error)));
        QVERIFY(found.repair.decidedCells > 0);
        QVERIFY(std::abs(fill(mesh, {.spacing = 0.07}).filledVolume - 4) < 1e-9); // what the switch is for
    }

    void boxesThatShareAFaceBecomeOne()
    {
        const TriangleMesh two = weld(
            shapes::together(shapes::box(Vec3(1, 1, 1)), shapes::moved(shapes::box(Vec3(1, 1, 1)), {Vec3(1, 0, 0)})),
            1e-9);
        const Aggregate found = fillDirty(two, 0.1);
        QVERIFY(std::abs(found.filledVolume - 2) < 1e-9);
        QCOMPARE(found.repair.removedTriangles, std::size_t{4});
        QCOMPARE(found.repair.decidedCells, std::size_t{0});
    }

    void surfacesWithLargeHolesAreRefused_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        TriangleMesh lidless = shapes::box(Vec3(2, 2, 2));
        lidless.triangles.resize(10);
        lidless.faceOfTriangle.clear();
        QTest::newRow("box without a lid") << lidless;
        QTest::newRow("tilted box without a lid") << shapes::moved(lidless, shapes::tilt(0.7));
        TriangleMesh sheet = lidless;
        sheet.triangles.resize(2);
        QTest::newRow("sheet") << sheet;
        QTest::newRow("half a ball") << [] {
            TriangleMesh half = shapes::sphere(1, 40);
            std::erase_if(half.triangles, [&](const TriangleMesh::Triangle& t) {
                return half.vertices[t[0]].z() + half.vertices[t[1]].z() + half.vertices[t[2]].z() > 0;
            });
            half.faceOfTriangle.clear();
            return half;
        }();
    }
    void surfacesWithLargeHolesAreRefused()
    {
        QFETCH(TriangleMesh, mesh);
        const std::string message = messageOf(mesh);
        QVERIFY2(message.find("does not bound a volume") != std::string::npos, message.c_str());
    }

    void objectsAtAHoleKnowTheirDepth()
    {
        // One of the four triangles in the middle of a face, wider than a cell, is missing.
        const TriangleMesh whole = refine(shapes::box(Vec3(2, 2, 3)), 0.6);
        TriangleMesh holed = whole;
        std::size_t nearest = 0;
        const auto distance = [&](std::size_t t) {
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t v : whole.triangles[t])
                sum += whole.vertices[v] / 3;
            return (sum - Vec3(1, 0, 0)).norm();
        };
        for (std::size_t t = 0; t < whole.triangles.size(); ++t)
            nearest = distance(t) < distance(nearest) ? t : nearest;
        holed.triangles.erase(holed.triangles.begin() + static_cast<std::ptrdiff_t>(nearest));
        holed.faceOfTriangle.erase(holed.faceOfTriangle.begin() + static_cast<std::ptrdiff_t>(nearest));
        const Aggregate expected = fill(whole, {.spacing = 0.1});
        const Aggregate found = fillDirty(holed, 0.1);
        QVERIFY(std::abs(found.filledVolume / 12 - 1) < 1e-3);
        std::size_t different = 0;
        for (ObjectIndex i = 0; i < found.size(); ++i) {
            const ObjectIndex same = expected.lattice.find(found.lattice.nodes[i]);
            if (same == expected.size())
                continue;
            // Where the rim is nearer than two spacings the distance to it is taken, so depths are too large by less.
            different += std::abs(found.depth[i] - expected.depth[same]) > 0.1 ? 1 : 0;
            QVERIFY(found.depth[i] >= expected.depth[same] - 0.1);
        }
        QVERIFY2(different < 20, qPrintable(QString::number(different)));
    }

    void sameForAnyNumberOfThreads()
    {
        const TriangleMesh mesh = damaged(fineBox(), 0.05, {Damage::doubled, Damage::flipped, Damage::removed});
        const Aggregate one = onThreads(1, [&] { return fillDirty(mesh); });
        for (const int threads : {2, 4})
            compareBits(onThreads(threads, [&] { return fillDirty(mesh); }), one);
    }

    void facesStayWithTheirTriangles()
    {
        TriangleMesh mesh = refine(shapes::box(Vec3(2, 2, 3)), 0.25);
        std::swap(mesh.triangles[17][0], mesh.triangles[17][1]);
        mesh.triangles.push_back(mesh.triangles[40]);
        mesh.faceOfTriangle.push_back(mesh.faceOfTriangle[40]);
        const Aggregate found = fillDirty(mesh);
        const Aggregate expected = fill(shapes::box(Vec3(2, 2, 3)), {.spacing = spacing});
        QCOMPARE(found.repair.removedTriangles, std::size_t{1});
        QCOMPARE(found.repair.flippedTriangles, std::size_t{1});
        QCOMPARE(found.repair.decidedCells, std::size_t{0});
        for (ObjectIndex i = 0; i < found.size(); ++i)
            if (std::abs(found.depth[i]) < 0.03) // elsewhere edges and corners may tie
                QVERIFY(found.face[i] != Aggregate::noFace);
        QVERIFY(std::abs(found.filledVolume / expected.filledVolume - 1) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(DirtyFillTest)
#include "dirty_fill_test.moc"
