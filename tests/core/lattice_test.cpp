#include "core/aggregate/fill.h"
#include "core/aggregate/lattice_rows.h"
#include "support/shapes.h"

#include <QtTest>

#include <random>
#include <set>

using namespace knead;

namespace {

Lattice::Node sum(const Lattice::Node& a, const Lattice::Node& b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// A lattice with holes, gaps in rows and missing rows.
Lattice spongeLattice()
{
    Lattice lattice;
    lattice.spacing = 1;
    std::minstd_rand random(7);
    for (std::int32_t u = -4; u < 9; ++u)
        for (std::int32_t v = 2; v < 12; ++v)
            for (std::int32_t w = -7; w < 6; ++w)
                if (random() % 5 != 0 && !(u == 3 || v == 7))
                    lattice.nodes.push_back({u, v, w});
    findSegments(lattice);
    return lattice;
}

/// The neighbor that the segments give an object, or size().
ObjectIndex neighborBySegments(const Lattice& lattice, ObjectIndex object, std::size_t d)
{
    for (const Lattice::Segment& segment : lattice.segments[d]) {
        if (object < segment.begin || object >= segment.end)
            continue;
        const auto neighbor = object + static_cast<ObjectIndex>(segment.offset);
        if (neighbor < lattice.size() && lattice.nodes[neighbor] == sum(lattice.nodes[object], Lattice::directions[d]))
            return neighbor;
    }
    return static_cast<ObjectIndex>(lattice.size());
}

} // namespace

class LatticeTest : public QObject {
    Q_OBJECT

private slots:
    void directionsAreHalfOfTheEighteenNeighborsThenOfTheTwentySix()
    {
        std::set<Lattice::Node> both;
        for (std::size_t i = 0; i < Lattice::directionCount; ++i) {
            const Lattice::Node& d = Lattice::directions[i];
            const int squaredLength = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            if (i < Lattice::isotropicCount)
                QVERIFY(squaredLength == 1 || squaredLength == 2);
            else
                QCOMPARE(squaredLength, 3);
            QVERIFY((d > Lattice::Node{0, 0, 0}));
            both.insert(d);
            both.insert({-d[0], -d[1], -d[2]});
            QCOMPARE(both.size(), 2 * (i + 1));
        }
    }

    void findReturnsEachObjectAndNothingElse()
    {
        const Lattice lattice = spongeLattice();
        for (ObjectIndex i = 0; i < lattice.size(); ++i)
            QCOMPARE(lattice.find(lattice.nodes[i]), i);
        for (const Lattice::Node& absent : {Lattice::Node{3, 3, 0}, {0, 7, 0}, {-5, 2, 0}, {20, 0, 0}, {0, 2, 6}})
            QCOMPARE(lattice.find(absent), static_cast<ObjectIndex>(lattice.size()));
    }

    void segmentsGiveTheSameNeighborsAsFind()
    {
        const Lattice lattice = spongeLattice();
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            for (ObjectIndex i = 0; i < lattice.size(); ++i)
                QCOMPARE(neighborBySegments(lattice, i, d),
                         lattice.find(sum(lattice.nodes[i], Lattice::directions[d])));
    }

    void segmentsAscendAndStayInside()
    {
        const Lattice lattice = spongeLattice();
        for (const auto& segments : lattice.segments) {
            ObjectIndex last = 0;
            for (const Lattice::Segment& segment : segments) {
                QVERIFY(segment.begin >= last && segment.begin < segment.end && segment.offset > 0);
                QVERIFY(segment.end + static_cast<ObjectIndex>(segment.offset) <= lattice.size());
                last = segment.end;
            }
        }
    }

    void bulkHasFewLongSegments()
    {
        const Lattice lattice = fill(shapes::box(Vec3(20, 20, 30)), {.spacing = 1}).lattice;
        QCOMPARE(lattice.segments[0].size(), std::size_t{1});
        QCOMPARE(lattice.segments[2].size(), std::size_t{1});
        QVERIFY(lattice.segments[1].size() <= 21);
    }

    void everyConnectionIsCoveredByItsOffset()
    {
        const Aggregate aggregate =
            fill(shapes::moved(shapes::torus(6, 2, 40, 20), shapes::tilt(0.8)), {.spacing = 0.5});
        std::size_t connections = 0;
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
                if (aggregate.weight[d][i] <= 0)
                    continue;
                ++connections;
                const ObjectIndex neighbor = neighborBySegments(aggregate.lattice, i, d);
                QVERIFY(neighbor < aggregate.size());
                const Vec3 across = aggregate.lattice.position(neighbor) - aggregate.lattice.position(i);
                QVERIFY((across - aggregate.lattice.direction(static_cast<int>(d))).norm() < 1e-12);
            }
        QCOMPARE(aggregate.connectionCount(), connections);
    }

    void coordinatesInvertPosition()
    {
        const Lattice lattice = fill(shapes::box(Vec3(3, 1, 2)), {.spacing = 0.3}).lattice;
        for (ObjectIndex i = 0; i < lattice.size(); ++i) {
            const Lattice::Node& node = lattice.nodes[i];
            QVERIFY((lattice.coordinates(lattice.position(i)) - Vec3(node[0], node[1], node[2])).norm() < 1e-12);
        }
    }

    void rowsFindTheSameObjects()
    {
        const Lattice lattice = spongeLattice();
        const LatticeRows rows(lattice);
        for (std::int32_t u = -6; u < 11; ++u)
            for (std::int32_t v = 0; v < 14; ++v)
                for (std::int32_t w = -9; w < 8; ++w)
                    QCOMPARE(rows.find({u, v, w}), lattice.find({u, v, w}));
    }

    void rowsFindTheNearestObject()
    {
        const Lattice lattice = spongeLattice();
        const LatticeRows rows(lattice);
        std::minstd_rand random(3);
        const auto number = [&](double low, double high) { return low + (high - low) * (random() % 10007) / 10007.0; };
        for (int i = 0; i < 500; ++i) {
            const Vec3 place(number(-4, 8), number(2, 11), number(-7, 5));
            double least = 1e9;
            for (ObjectIndex object = 0; object < lattice.size(); ++object)
                least = std::min(least, (lattice.position(object) - place).norm());
            QCOMPARE((lattice.position(rows.nearest(place)) - place).norm(), least);
        }
        QCOMPARE(lattice.nodes[rows.nearest(Vec3(1e6, 1e6, 1e6))][0], 8);
    }
};

QTEST_GUILESS_MAIN(LatticeTest)
#include "lattice_test.moc"
