#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/aggregate/surface_cells.h"
#include "support/shapes.h"

#include <QtTest>

#include <numeric>
#include <set>

using namespace knead;

namespace {

std::vector<BrokenConnection> acrossMiddle(const Aggregate& aggregate)
{
    std::vector<BrokenConnection> broken;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex o = segment.begin; o < segment.end; ++o) {
                const ObjectIndex other = o + static_cast<ObjectIndex>(segment.offset);
                const bool isAbove = aggregate.lattice.position(o).x() > 0.3;
                if (aggregate.weight[d][o] > 0 && isAbove != (aggregate.lattice.position(other).x() > 0.3))
                    broken.push_back({d, o});
            }
    return broken;
}

} // namespace

class PiecesTest : public QObject {
    Q_OBJECT

private slots:
    void aBarFallsInTwo()
    {
        const Aggregate aggregate = fill(shapes::box({8, 3, 3}), {.spacing = 0.5});
        QCOMPARE(findPieces(aggregate).count, std::size_t{1});
        std::vector<BrokenConnection> broken = acrossMiddle(aggregate);
        const Pieces pieces = findPieces(aggregate, broken);
        QCOMPARE(pieces.count, std::size_t{2});
        QCOMPARE(pieces.ofObject[0], 0U);
        for (ObjectIndex o = 0; o < aggregate.size(); ++o)
            QCOMPARE(pieces.ofObject[o] == pieces.ofObject[0],
                     (aggregate.lattice.position(o).x() > 0.3) == (aggregate.lattice.position(0).x() > 0.3));
        broken.pop_back();
        QCOMPARE(findPieces(aggregate, broken).count, std::size_t{1});
    }

    void allObjectsMakeTheSameAggregate()
    {
        const Aggregate aggregate = fill(shapes::torus(6, 2, 30, 12), {.spacing = 0.7});
        std::vector<ObjectIndex> all(aggregate.size());
        std::iota(all.begin(), all.end(), 0U);
        const Aggregate part = extract(aggregate, all, brokenDirections(aggregate, {}));
        QVERIFY(part.lattice.nodes == aggregate.lattice.nodes);
        QVERIFY(part.weight == aggregate.weight);
        QVERIFY(part.volume == aggregate.volume);
        QCOMPARE(part.connectionCount(), aggregate.connectionCount());
    }

    void piecesKeepTheConnectionsThatHold()
    {
        const Aggregate aggregate = fill(shapes::box({8, 3, 3}), {.spacing = 0.5});
        const std::vector<BrokenConnection> broken = acrossMiddle(aggregate);
        const Pieces pieces = findPieces(aggregate, broken);
        std::size_t connections = 0;
        double volume = 0;
        for (std::uint32_t piece = 0; piece < pieces.count; ++piece) {
            std::vector<ObjectIndex> objects;
            for (ObjectIndex o = 0; o < aggregate.size(); ++o)
                if (pieces.ofObject[o] == piece)
                    objects.push_back(o);
            const Aggregate part = extract(aggregate, objects, brokenDirections(aggregate, broken));
            QCOMPARE(findPieces(part).count, std::size_t{1});
            connections += part.connectionCount();
            volume += part.filledVolume;
            for (std::size_t i = 0; i < objects.size(); ++i)
                QVERIFY(part.lattice.position(static_cast<ObjectIndex>(i)) == aggregate.lattice.position(objects[i]));
        }
        QCOMPARE(connections + broken.size(), aggregate.connectionCount());
        QVERIFY(std::abs(volume / aggregate.filledVolume - 1) < 1e-12);
    }

    /// Points of the triangle, close together, are all in cells that are visited; and few others are.
    void touchedCellsCoverTriangles()
    {
        const std::array<Vec3, 3> triangles[] = {
            {Vec3(0.2, 0.3, 0.1), Vec3(7.7, 1.2, 3.4), Vec3(2.1, 6.3, 8.8)},
            {Vec3(0, 0, 0), Vec3(6, 6, 0), Vec3(3, 3, 7)},
            {Vec3(1, 2, 3), Vec3(9, 2, 3), Vec3(1, 2, 9)},
            {Vec3(-3.5, -2.5, 4), Vec3(5.5, -2.5, 4), Vec3(-3.5, 6.25, 4)},
        };
        for (const std::array<Vec3, 3>& corners : triangles) {
            std::set<Lattice::Node> visited;
            forEachTouchedCell(corners, 1e-3, [&](const Lattice::Node& cell) { QVERIFY(visited.insert(cell).second); });
            std::set<Lattice::Node> needed;
            constexpr int steps = 400;
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const Vec3 X = (i * corners[0] + j * corners[1] + (steps - i - j) * corners[2]) / steps;
                    needed.insert({static_cast<std::int32_t>(std::floor(X.x())),
                                   static_cast<std::int32_t>(std::floor(X.y())),
                                   static_cast<std::int32_t>(std::floor(X.z()))});
                }
            QVERIFY(std::includes(visited.begin(), visited.end(), needed.begin(), needed.end()));
            // A triangle in a border between cells touches those on either side.
            QVERIFY2(visited.size() <= 4 * needed.size(), qPrintable(QString::number(visited.size())));
        }
    }
};

QTEST_APPLESS_MAIN(PiecesTest)
#include "pieces_test.moc"
