#include "core/mechanics/run_slots.h"
#include "support/scenes.h"

#include <QTest>

#include <set>

using namespace knead;

namespace {

Lattice latticeOf(const std::vector<Lattice::Node>& nodes)
{
    Lattice lattice;
    lattice.spacing = 1;
    lattice.nodes = nodes;
    return lattice;
}

/// A plate with a hole, whose rows begin at odd places, are apart, and miss neighbors.
Lattice ragged()
{
    std::vector<Lattice::Node> nodes;
    for (std::int32_t u = -3; u < 6; ++u)
        for (std::int32_t v = -2; v < 7; ++v)
            for (std::int32_t w = -13 + 2 * u + v; w < 41 - v * v; ++w)
                if (w < 5 || w > 5 + 4 * (u + 3)) // gaps of 1 to 33
                    nodes.push_back({u, v, w});
    return latticeOf(nodes);
}

} // namespace

class RunSlotsTest : public QObject {
    Q_OBJECT

private slots:
    void everyObjectHasASlotInABlock()
    {
        const Lattice lattice = ragged();
        const RunSlots runs(lattice);
        std::set<std::uint32_t> taken;
        for (ObjectIndex i = 0; i < lattice.size(); ++i) {
            QVERIFY(taken.insert(runs.of(i)).second);
            QVERIFY(runs.of(i) % 8 == static_cast<std::uint32_t>((lattice.nodes[i][2] % 8 + 8) % 8));
        }
        std::set<std::uint32_t> covered;
        for (const SlotBlock& block : runs.blocks())
            for (std::uint32_t lane = 0; lane < 8; ++lane)
                QVERIFY(covered.insert(block.first + lane).second);
        QVERIFY(std::includes(covered.begin(), covered.end(), taken.begin(), taken.end()));
        std::size_t objects = 0;
        for (const RunSlots::Run& run : runs.runs())
            for (ObjectIndex i = run.begin; i < run.end; ++i, ++objects)
                QCOMPARE(runs.of(i), runs.of(run.begin) + i - run.begin);
        QCOMPARE(objects, lattice.size());
    }

    /// Where a lane looks for a neighbor stands that neighbor; where there is none, nothing.
    void neighborsStandWhereBlocksSay()
    {
        const Lattice lattice = ragged();
        const RunSlots runs(lattice);
        std::vector<std::size_t> objectAt(runs.size(), lattice.size());
        for (ObjectIndex i = 0; i < lattice.size(); ++i)
            objectAt[runs.of(i)] = i;
        std::size_t met = 0;
        for (const SlotBlock& block : runs.blocks())
            for (std::uint32_t lane = 0; lane < 8; ++lane) {
                const std::size_t object = objectAt[block.first + lane];
                if (object == lattice.size())
                    continue;
                const Lattice::Node& node = lattice.nodes[object];
                for (int du = -1; du <= 1; ++du)
                    for (int dv = -1; dv <= 1; ++dv)
                        for (int dw = -1; dw <= 1; ++dw) {
                            const std::int64_t slot = static_cast<std::int64_t>(block.first) +
                                                      block.offset[3 * (du + 1) + dv + 1] + lane + dw;
                            const ObjectIndex expected = lattice.find({node[0] + du, node[1] + dv, node[2] + dw});
                            const bool isInside = slot >= 0 && slot < static_cast<std::int64_t>(runs.size());
                            QCOMPARE(isInside ? objectAt[static_cast<std::size_t>(slot)] : lattice.size(),
                                     static_cast<std::size_t>(expected));
                            ++met;
                        }
            }
        QCOMPARE(met, 27 * lattice.size());
    }

    void gapsOfWholeBlocksTakeNoSlots()
    {
        std::vector<Lattice::Node> nodes{{0, 0, 0}, {0, 0, 800}};
        QVERIFY(RunSlots(latticeOf(nodes)).size() <= 64);
    }
};

QTEST_GUILESS_MAIN(RunSlotsTest)
#include "run_slots_test.moc"
