#include "core/aggregate/lattice_runs.h"
#include "support/scenes.h"

#include <QTest>

using namespace knead;

namespace {

constexpr double spacing = 1e-3;

std::vector<Aggregate> parts()
{
    std::vector<Aggregate> all;
    all.push_back(fill(shapes::box(spacing * Vec3(9, 7, 20)), {.spacing = spacing}));
    all.push_back(
        fill(shapes::moved(shapes::cylinder(4 * spacing, 30 * spacing, 48), shapes::tilt(0.7)), {.spacing = spacing}));
    all.push_back(
        fill(shapes::moved(shapes::box(spacing * Vec3(40, 30, 1.2)), shapes::tilt(0.3)), {.spacing = spacing}));
    // Rows with holes in them: every third and seventh object is gone.
    Aggregate holed = fill(shapes::box(spacing * Vec3(9, 7, 20)), {.spacing = spacing});
    std::vector<Lattice::Node> left;
    for (std::size_t i = 0; i < holed.size(); ++i)
        if (i % 3 != 0 && i % 7 != 0)
            left.push_back(holed.lattice.nodes[i]);
    holed.lattice.nodes = left;
    findSegments(holed.lattice, Lattice::directionCount);
    all.push_back(holed);
    return all;
}

} // namespace

class LatticeRunsTest : public QObject {
    Q_OBJECT

private slots:
    void runsCoverTheObjectsAndLeadToTheirNeighbors()
    {
        for (const Aggregate& part : parts())
            for (const RunNeighbors neighbors : {RunNeighbors::ahead, RunNeighbors::all}) {
                const Lattice& lattice = part.lattice;
                ObjectIndex next = 0;
                for (const LatticeRun& run : findRuns(lattice, neighbors)) {
                    QCOMPARE(run.begin, next);
                    QVERIFY(run.end > run.begin);
                    next = run.end;
                    for (ObjectIndex i = run.begin; i < run.end; ++i)
                        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
                            checkNeighbors(lattice, run, i, d, neighbors);
                }
                QCOMPARE(next, static_cast<ObjectIndex>(lattice.size()));
            }
    }

    /// Or it has a connection of weight 0 from there, where segments go on over gaps.
    void whatIsBehindAnObjectIsItsOwn()
    {
        for (const Aggregate& part : parts()) {
            const Lattice& lattice = part.lattice;
            const std::vector<std::uint32_t> masks = neighborsBehind(lattice);
            for (const LatticeRun& run : findRuns(lattice, RunNeighbors::all))
                for (ObjectIndex i = run.begin; i < run.end; ++i)
                    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
                        const Lattice::Node& node = lattice.nodes[i];
                        const Lattice::Node& o = Lattice::directions[d];
                        const ObjectIndex behind = lattice.find({node[0] - o[0], node[1] - o[1], node[2] - o[2]});
                        if (behind < lattice.size() && !lattice.segments[d].empty())
                            QVERIFY((masks[i] >> d & 1U) != 0);
                        if ((masks[i] >> d & 1U) == 0)
                            continue;
                        const Lattice::Node& from = lattice.nodes[i - static_cast<ObjectIndex>(run.behind[d])];
                        const ObjectIndex partner = lattice.find({from[0] + o[0], from[1] + o[1], from[2] + o[2]});
                        QVERIFY(partner == i || partner == lattice.size());
                    }
        }
    }

    void aBoxIsAFewRunsWhateverItsSize()
    {
        for (const double size : {5.0, 20.0}) {
            const Aggregate box = fill(shapes::box(spacing * Vec3(size, size, size)), {.spacing = spacing});
            QVERIFY(findRuns(box.lattice, RunNeighbors::ahead).size() <= 7); // its last rows and objects lack neighbors
        }
    }

    void aRoundBarIsAboutOneRunPerRow()
    {
        const Aggregate bar = fill(shapes::cylinder(5 * spacing, 40 * spacing, 48), {.spacing = spacing});
        std::size_t rows = 1;
        for (std::size_t i = 1; i < bar.size(); ++i)
            rows += bar.lattice.nodes[i][2] != bar.lattice.nodes[i - 1][2] + 1 ? 1 : 0;
        QVERIFY(findRuns(bar.lattice, RunNeighbors::ahead).size() <= 2 * rows);
    }

private:
    static void checkNeighbors(const Lattice& lattice, const LatticeRun& run, ObjectIndex i, std::size_t d,
                               RunNeighbors neighbors)
    {
        const Lattice::Node& node = lattice.nodes[i];
        const Lattice::Node& o = Lattice::directions[d];
        const bool directionIsUsed = !lattice.segments[d].empty();
        const ObjectIndex ahead = lattice.find({node[0] + o[0], node[1] + o[1], node[2] + o[2]});
        if (ahead < lattice.size() && directionIsUsed) {
            QVERIFY((run.forward >> d & 1U) != 0);
            QCOMPARE(i + static_cast<ObjectIndex>(run.ahead[d]), ahead);
        }
        QVERIFY(i + static_cast<ObjectIndex>(run.ahead[d]) < lattice.size());
        if (neighbors == RunNeighbors::ahead || !directionIsUsed)
            return;
        const ObjectIndex behind = lattice.find({node[0] - o[0], node[1] - o[1], node[2] - o[2]});
        if (behind < lattice.size()) {
            QVERIFY((run.backward >> d & 1U) != 0);
            QCOMPARE(i - static_cast<ObjectIndex>(run.behind[d]), behind);
        }
        QVERIFY(i >= static_cast<ObjectIndex>(run.behind[d]));
    }
};

QTEST_GUILESS_MAIN(LatticeRunsTest)
#include "lattice_runs_test.moc"
