#include "support/thread_limit.h"

#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_distance.h"
#include "core/geometry/turn.h"
#include "support/shapes.h"

#include <QtTest>

#include <numeric>

using namespace knead;

namespace {

double sum(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The sum of k l^2 over all connections for a Young's modulus of 1, with k = 0.4 E a w.
double stiffnessMoment(const Aggregate& aggregate)
{
    double moment = 0;
    for (std::size_t d = 0; d < aggregate.weight.size(); ++d)
        moment += sum(aggregate.weight[d]) * aggregate.lattice.direction(static_cast<int>(d)).squaredNorm();
    return 0.4 * aggregate.lattice.spacing * moment;
}

std::string messageOf(const TriangleMesh& mesh, const FillOptions& options)
{
    try {
        fill(mesh, options);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The 18 connections of an aggregate by the coordinates of their ends, the brute-force way.
double weightBetween(const Aggregate& aggregate, const Lattice::Node& from, std::size_t d)
{
    const ObjectIndex object = aggregate.lattice.find(from);
    return object < aggregate.size() ? aggregate.weight[d][object] : 0;
}

class CancelAfter final : public TaskControl {
public:
    explicit CancelAfter(int reports)
        : m_left(reports)
    {
    }
    void report(double fraction, std::string_view) override
    {
        ordered = ordered && fraction >= last - 1e-12 && fraction <= 1;
        last = fraction;
        --m_left;
    }
    bool isCancelled() const override { return m_left <= 0; }

    bool ordered = true;
    double last = 0;

private:
    int m_left;
};

} // namespace

class FillTest : public QObject {
    Q_OBJECT

private slots:
    void alignedBoxHasBulkFaceAndEdgeWeights()
    {
        const double a = 0.002;
        const Aggregate aggregate = fill(shapes::box(Vec3(8, 10, 6) * a), {.spacing = a});
        QCOMPARE(aggregate.size(), std::size_t{9 * 11 * 7});
        QCOMPARE(aggregate.cells, std::size_t{8 * 10 * 6});
        const Lattice& lattice = aggregate.lattice;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const Lattice::Node& node = lattice.nodes[i];
            const std::array<int, 3> last{6, 8, 10}; // (u, v, w) is (z, x, y): y is the longest side
            for (std::size_t d = 0; d < 3; ++d) {
                double expected = 1;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (axis != d && (node[axis] == 0 || node[axis] == last[axis]))
                        expected /= 2;
                    if (axis == d && node[axis] == last[axis])
                        expected = 0;
                }
                QVERIFY(std::abs(aggregate.weight[d][i] - expected) < 1e-12);
            }
        }
    }

    void nodesOfAnAlignedBoxLieOnItsFaces()
    {
        const double a = 0.1 / 7;
        const Aggregate aggregate =
            fill(shapes::moved(shapes::box(Vec3(0.3, 0.1, 0.2)), {Vec3(0.4, -0.7, 0.1)}), {.spacing = a});
        Box box;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            box.extend(aggregate.lattice.position(i));
        QVERIFY((box.min() - Vec3(0.25, -0.75, 0)).norm() < 1e-12);
        QVERIFY((box.max() - Vec3(0.55, -0.65, 0.2)).norm() < 1e-12);
        QCOMPARE(aggregate.size(), std::size_t{22 * 8 * 15});
    }

    void rowsRunAlongTheLongestSide_data()
    {
        QTest::addColumn<int>("longest");
        for (int axis = 0; axis < 3; ++axis)
            QTest::addRow("%c", 'x' + axis) << axis;
    }
    void rowsRunAlongTheLongestSide()
    {
        QFETCH(int, longest);
        Vec3 size(2, 2, 2);
        size[longest] = 5;
        const Lattice lattice = fill(shapes::box(size), {.spacing = 1}).lattice;
        QCOMPARE(lattice.axes.col(2), Vec3(Vec3::Unit(longest)));
        QCOMPARE(lattice.axes.determinant(), 1.0);
        QVERIFY(std::is_sorted(lattice.nodes.begin(), lattice.nodes.end()));
    }

    void volumesAreExact_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::newRow("box") << shapes::box(Vec3(0.03, 0.02, 0.01));
        for (const double angle : {0.1, 0.5, 1.3, 2.2})
            QTest::addRow("box tilted by %g", angle)
                << shapes::moved(shapes::box(Vec3(0.03, 0.02, 0.01)), shapes::tilt(angle, Vec3(0.1, 0.2, 0.3)));
        QTest::newRow("sphere") << shapes::sphere(0.012, 48);
        QTest::newRow("sphere of small triangles") << shapes::sphere(0.006, 200);
        QTest::newRow("torus") << shapes::torus(0.015, 0.005, 64, 24);
        QTest::newRow("tilted torus") << shapes::moved(shapes::torus(0.015, 0.005, 64, 24), shapes::tilt(0.7));
        QTest::newRow("cylinder") << shapes::cylinder(0.006, 0.03, 37);
        QTest::newRow("hollow box") << shapes::hollowBox(Vec3(0.03, 0.02, 0.02), Vec3(0.011, 0.007, 0.013));
        QTest::newRow("tilted hollow box")
            << shapes::moved(shapes::hollowBox(Vec3(0.03, 0.02, 0.02), Vec3(0.011, 0.007, 0.013)), shapes::tilt(0.4));
        QTest::newRow("bracket") << shapes::bracket(0.03, 0.007, 0.01);
        QTest::newRow("inside out") << shapes::insideOut(shapes::torus(0.015, 0.005, 64, 24));
    }
    void volumesAreExact()
    {
        QFETCH(TriangleMesh, mesh);
        const double volume = std::abs(massProperties(mesh).volume);
        for (const double a : {0.001, 0.00173}) {
            const Aggregate aggregate = fill(mesh, {.spacing = a});
            QVERIFY(std::abs(aggregate.filledVolume / volume - 1) < 1e-12);
            QVERIFY(std::abs(aggregate.meshVolume / volume - 1) < 1e-12);
            QVERIFY(std::abs(sum(aggregate.volume) / volume - 1) < 1e-12);
            QVERIFY(std::abs(stiffnessMoment(aggregate) / (6 * volume) - 1) < 1e-12);
        }
    }

    void trianglesOnCellBordersAreCountedOnce()
    {
        // Every face of this box lies in a plane of nodes, and its void too.
        const TriangleMesh mesh = shapes::hollowBox(Vec3(8, 6, 10), Vec3(2, 4, 4));
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        QVERIFY(std::abs(aggregate.filledVolume - (480 - 32)) < 1e-10);
        QCOMPARE(aggregate.cells, std::size_t{480 - 32});
    }

    void layersOverThreeFullCellsAreKept()
    {
        // The void's faces across lie beyond a plane of nodes by that: 4 x 4 columns of cells end there on both sides.
        struct Row {
            double side;
            double beyond;
            std::size_t kept;
        };
        for (const auto& [side, beyond, kept] :
             {Row{10, 0.05, 32}, Row{10, 0.2, 32}, Row{10, 0.02, 0}, Row{8, 0.2, 0}, Row{8, 0.3, 32}}) {
            const Aggregate aggregate = fill(shapes::hollowBox({10, 10, side}, {4, 4, 4 - 2 * beyond}), {.spacing = 1});
            QCOMPARE(aggregate.cells, static_cast<std::size_t>(100 * side) - 64 + kept);
            QVERIFY(std::abs(aggregate.filledVolume / (100 * side - 16 * (4 - 2 * beyond)) - 1) < 1e-12);
        }
    }

    void ribsAndFoilsAreNoLayers()
    {
        // On a block of 8 x 8 x 8 cells, beside a pillar that puts its upper face on nodes: what lies on it, or above it.
        const auto cells = [](const TriangleMesh& part) { return fill(part, {.spacing = 1}).cells; };
        const auto boxAt = [](const Vec3& sides, const Vec3& middle) {
            return shapes::moved(shapes::box(sides), {middle, Quaternion::Identity()});
        };
        const auto blockWith = [&](const TriangleMesh& more) {
            const TriangleMesh block = shapes::together(boxAt({8, 8, 8}, {0, 0, 0}), boxAt({1, 8, 4}, {-3.5, 0, 6}));
            return shapes::together(block, more);
        };
        const std::size_t bare = 512 + 32;
        QCOMPARE(cells(blockWith(boxAt({2, 2, 0.1}, {1, 1, 4.05}))), bare + 4);    // a layer
        QCOMPARE(cells(blockWith(boxAt({0.45, 2, 0.45}, {0.5, 1, 4.225}))), bare); // a rib
        QCOMPARE(cells(blockWith(boxAt({2, 2, 0.1}, {1, 1, 4.5}))), bare);         // a foil over it
        QCOMPARE(cells(blockWith(boxAt({2, 2, 4.1}, {1, 1, 6.95}))), bare + 16);   // what hangs down to near it
    }

    void gapsOfNearlyTwoCellsStayOpen()
    {
        for (const double gap : {1.6, 1.8, 1.9}) {
            const double side = 5 - gap / 2;
            const auto blockAt = [&](double way) {
                return shapes::moved(shapes::box({10, 10, side}),
                                     {Vec3(0, 0, way * (gap + side) / 2), Quaternion::Identity()});
            };
            const Aggregate aggregate = fill(shapes::together(blockAt(-1), blockAt(1)), {.spacing = 1});
            for (ObjectIndex i = 0; i < aggregate.size(); ++i)
                QVERIFY2(std::abs(aggregate.lattice.position(i).z()) > 0.4, qPrintable(QString::number(gap)));
        }
    }

    void cornersOfCellsBelowTheThresholdAreDropped()
    {
        // A bar of 4 x 4 cells with a chamfer that leaves half the square of `rest` of the cells along an edge.
        const auto bar = [](double rest) {
            return shapes::prism({{0, 0}, {4, 0}, {4, 2 + rest}, {2 + rest, 4}, {0, 4}}, 6);
        };
        for (const auto& [rest, least, cells] :
             {std::tuple{0.8, 0.25, 16}, std::tuple{0.6, 0.25, 15}, std::tuple{0.8, 0.4, 15}, std::tuple{0.9, 0.4, 16}})
            QCOMPARE(fill(bar(rest), {.spacing = 1, .minimumFraction = least}).cells,
                     static_cast<std::size_t>(6 * cells));
    }

    void centerOfMassIsNearThatOfTheMesh()
    {
        const TriangleMesh mesh = shapes::moved(shapes::bracket(0.03, 0.01, 0.012), shapes::tilt(0.9));
        const Aggregate aggregate = fill(mesh, {.spacing = 0.001});
        Vec3 moment = Vec3::Zero();
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            moment += aggregate.volume[i] * aggregate.lattice.position(i);
        QVERIFY((moment / aggregate.filledVolume - massProperties(mesh).centroid).norm() < 0.05 * 0.001);
    }

    void weightsAreSymmetricInTheMiddlePlane()
    {
        const Aggregate aggregate = fill(shapes::sphere(5.3, 60), {.spacing = 1});
        const Lattice::Node last{11, 11, 11};
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const Lattice::Node& node = aggregate.lattice.nodes[i];
            // The sphere is centered, so a half turn about any axis maps it onto itself: (u, v, w) -> (L-u, L-v, w).
            const Lattice::Node turned{last[0] - node[0], last[1] - node[1], node[2]};
            QVERIFY(std::abs(aggregate.weight[2][i] - weightBetween(aggregate, turned, 2)) < 1e-10);
        }
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        const TriangleMesh mesh = shapes::moved(shapes::torus(0.015, 0.005, 96, 32), shapes::tilt(0.7));
        const auto fillWith = [&](int threads) {
            return onThreads(threads, [&] { return fill(mesh, {.spacing = 0.0007}); });
        };
        const Aggregate one = fillWith(1);
        for (const int threads : {2, 4}) {
            const Aggregate other = fillWith(threads);
            QVERIFY(one.lattice.nodes == other.lattice.nodes);
            QVERIFY(one.weight == other.weight);
            QVERIFY(one.volume == other.volume);
            QVERIFY(one.depth == other.depth);
            QVERIFY(one.filledVolume == other.filledVolume);
        }
    }

    void depthIsTheDistanceToTheSurface()
    {
        const TriangleMesh mesh = shapes::moved(shapes::hollowBox(Vec3(16, 20, 14), Vec3(3, 4, 3)), shapes::tilt(0.6));
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        const SurfaceDistance surface(mesh);
        int deep = 0;
        int outside = 0;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const SurfaceDistance::Hit hit = surface.nearest(aggregate.lattice.position(i));
            const double depth = aggregate.depth[i];
            if (-hit.signedDistance <= 2) {
                QVERIFY(std::abs(depth + hit.signedDistance) < 1e-12);
                QCOMPARE(aggregate.face[i], mesh.faceOfTriangle[hit.triangle]);
            } else {
                QVERIFY(depth >= 2 && depth <= -hit.signedDistance + 1e-12);
                ++deep;
            }
            outside += depth < 0 ? 1 : 0;
        }
        QVERIFY(deep > 0);
        QVERIFY(outside > 0);
    }

    void plainMeshesHaveNoFaces()
    {
        const Aggregate aggregate = fill(shapes::torus(0.015, 0.005, 32, 16), {.spacing = 0.001});
        for (const std::uint32_t face : aggregate.face)
            QCOMPARE(face, std::uint32_t{Aggregate::noFace});
    }

    void slenderDiagonalPartsCostOnlyTheirOwnCells()
    {
        // The bounding box has 2e9 cells, the part 20 000: anything stored per cell of the box would not fit.
        const Pose diagonal{Vec3::Zero(), turnOnto(Vec3::UnitZ(), Vec3(1, 1, 1.01))};
        const TriangleMesh mesh = shapes::moved(shapes::box(Vec3(3, 3, 2200)), diagonal);
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        QVERIFY(aggregate.size() < 80'000);
        QVERIFY(std::abs(aggregate.filledVolume / (9 * 2200) - 1) < 1e-12);
    }

    void degenerateTrianglesAreHarmless()
    {
        // The middle of an edge becomes a vertex of its own: on one side as a triangle without area.
        TriangleMesh mesh = shapes::box(Vec3(4, 4, 6));
        mesh.faceOfTriangle.clear();
        const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
        const TriangleMesh::Triangle first = mesh.triangles[0];
        mesh.vertices.push_back((mesh.vertices[first[0]] + mesh.vertices[first[1]]) / 2);
        mesh.triangles[0] = {first[0], middle, first[2]};
        mesh.triangles.push_back({middle, first[1], first[2]});
        mesh.triangles.push_back({first[0], first[1], middle});
        QVERIFY(isWatertight(mesh));
        const Aggregate aggregate = fill(shapes::moved(mesh, shapes::tilt(0.3)), {.spacing = 0.7});
        QVERIFY(std::abs(aggregate.filledVolume / 96 - 1) < 1e-12);
        for (const double depth : aggregate.depth)
            QVERIFY(std::isfinite(depth));
    }

    void voidsStayEmpty()
    {
        const double radius = 0.7;
        const TriangleMesh ball = shapes::sphere(radius, 80);
        const TriangleMesh mesh =
            shapes::moved(shapes::together(shapes::box(Vec3(2, 2.2, 2.4)), shapes::insideOut(ball)), shapes::tilt(0.4));
        const double a = 0.1;
        const Aggregate aggregate = fill(mesh, {.spacing = a});
        const double expected = 2 * 2.2 * 2.4 - massProperties(ball).volume;
        QVERIFY(std::abs(aggregate.filledVolume / expected - 1) < 1e-12);
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const double fromMiddle = aggregate.lattice.position(i).norm();
            QVERIFY(fromMiddle > radius - 1.2 * a); // the corners of cut cells stick out
            if (fromMiddle < radius - 0.01 * a)
                QVERIFY(aggregate.depth[i] < 0);
        }
    }

    void separatePiecesAreFilledTogether()
    {
        const TriangleMesh mesh =
            shapes::together(shapes::box(Vec3(2, 2, 2)), shapes::moved(shapes::box(Vec3(1, 1, 1)), {Vec3(0, 30.3, 0)}));
        const Aggregate aggregate = fill(mesh, {.spacing = 0.25});
        QVERIFY(std::abs(aggregate.filledVolume - 9) < 1e-11);
    }

    void openMeshesAreRefusedInASentence()
    {
        TriangleMesh mesh = shapes::box(Vec3(1, 1, 1));
        mesh.triangles.pop_back();
        mesh.faceOfTriangle.pop_back();
        const std::string message = messageOf(mesh, {.spacing = 0.1});
        QVERIFY2(contains(message, "not closed: 3 edges"), message.c_str());
    }

    void impossibleRequestsAreRefusedInASentence()
    {
        const TriangleMesh mesh = shapes::box(Vec3(1, 1, 1));
        QVERIFY(contains(messageOf({}, {.spacing = 0.1}), "nothing to fill"));
        QVERIFY(contains(messageOf(mesh, {.spacing = 0}), "0 mm"));
        QVERIFY(contains(messageOf(mesh, {.spacing = std::nan("")}), "length above 0"));
        QVERIFY(contains(messageOf(shapes::box(Vec3(1, 1, 0.001)), {.spacing = 0.1}), "too thin"));
        TriangleMesh broken = mesh;
        broken.vertices[3].x() = std::nan("");
        QVERIFY(contains(messageOf(broken, {.spacing = 0.1}), "finite"));
    }

    void tooManyObjectsAreRefusedBeforeTheyAreMade()
    {
        const TriangleMesh mesh = shapes::box(Vec3(1, 1, 1));
        QVERIFY(contains(messageOf(mesh, {.spacing = 1e-9}), "more than 20000000 objects"));
        // 11^3 corners of 10^3 cells: only counting the corners tells.
        QVERIFY(contains(messageOf(mesh, {.spacing = 0.1, .maximumObjects = 1330}), "more than 1330 objects"));
        QCOMPARE(fill(mesh, {.spacing = 0.1, .maximumObjects = 1331}).size(), std::size_t{1331});
    }

    void cancellationEndsTheFilling()
    {
        const TriangleMesh mesh = shapes::sphere(1, 40);
        CancelAfter patient(1'000'000);
        fill(mesh, {.spacing = 0.03}, patient);
        QVERIFY(patient.ordered);
        QCOMPARE(patient.last, 1.0);
        for (const int reports : {1, 3, 10}) {
            CancelAfter control(reports);
            QVERIFY_EXCEPTION_THROWN(fill(mesh, {.spacing = 0.03}, control), Cancelled);
        }
    }

    void spacingForCellsAcrossDividesTheLongestSide()
    {
        QCOMPARE(spacingForCellsAcross(shapes::box(Vec3(1, 3, 2)), 12), 0.25);
    }

    void spacingForObjectCountComesClose_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::newRow("box") << shapes::box(Vec3(1, 2, 3));
        QTest::newRow("sheet") << shapes::moved(shapes::box(Vec3(0.1, 2, 3)), shapes::tilt(0.5));
        QTest::newRow("sphere") << shapes::sphere(1, 60);
        QTest::newRow("torus") << shapes::torus(1, 0.3, 60, 30);
    }
    void spacingForObjectCountComesClose()
    {
        QFETCH(TriangleMesh, mesh);
        const double spacing = spacingForObjectCount(mesh, 50'000);
        const auto objects = static_cast<double>(fill(mesh, {.spacing = spacing}).size());
        QVERIFY2(std::abs(objects / 50'000 - 1) < 0.05, qPrintable(QString::number(objects)));
    }
};

QTEST_GUILESS_MAIN(FillTest)
#include "fill_test.moc"
