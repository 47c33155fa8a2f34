#include "core/aggregate/fill.h"
#include "core/aggregate/published_fill.h"
#include "io/project/aggregate_bytes.h"
#include "support/byte_mutation.h"
#include "support/same_values.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

Aggregate filled()
{
    return fill(shapes::moved(shapes::bracket(0.03, 0.01, 0.02), shapes::tilt(0.3)), {.spacing = 0.004});
}

/// Nothing in it could lead a simulation astray.
bool isSound(const Aggregate& aggregate)
{
    const std::size_t count = aggregate.size();
    if (aggregate.volume.size() != count || aggregate.depth.size() != count || aggregate.face.size() != count)
        return false;
    for (std::size_t d = 0; d < aggregate.weight.size(); ++d)
        for (ObjectIndex i = 0; i < aggregate.weight[d].size(); ++i) {
            Lattice::Node neighbor = aggregate.lattice.nodes[i];
            for (std::size_t axis = 0; axis < 3; ++axis)
                neighbor[axis] += Lattice::directions[d][axis];
            const bool isThere = aggregate.lattice.find(neighbor) < count;
            if (!std::isfinite(aggregate.weight[d][i]) || (aggregate.weight[d][i] != 0 && !isThere && count > 0))
                return false;
        }
    return std::is_sorted(aggregate.lattice.nodes.begin(), aggregate.lattice.nodes.end());
}

/// An object without a neighbor along the row, but with others after it.
std::size_t endOfRow(const Aggregate& aggregate)
{
    const auto& nodes = aggregate.lattice.nodes;
    std::size_t i = 0;
    while (nodes[i + 1][2] == nodes[i][2] + 1)
        ++i;
    return i;
}

} // namespace

class AggregateBytesTest : public QObject {
    Q_OBJECT
private slots:
    void everythingComesBackToTheLastBit()
    {
        const Aggregate aggregate = filled();
        QVERIFY(same::values(aggregateFromBytes(aggregateToBytes(aggregate)), aggregate));
        const Aggregate published = fillAsPublished(shapes::box({0.01, 0.01, 0.03}), 0.002);
        QVERIFY(same::values(aggregateFromBytes(aggregateToBytes(published)), published));
        QVERIFY(same::values(aggregateFromBytes(aggregateToBytes({.lattice = {.spacing = 1}})),
                             {.lattice = {.spacing = 1}}));
    }

    void cutOffBytesAreRefused()
    {
        const std::string bytes = aggregateToBytes(filled());
        for (std::size_t length = 0; length < bytes.size(); length += 97)
            QVERIFY_EXCEPTION_THROWN(aggregateFromBytes(std::string_view(bytes).substr(0, length)), std::runtime_error);
    }

    void damagedBytesNeverGiveAnUnsoundAggregate()
    {
        const std::string bytes = aggregateToBytes(fill(shapes::box({0.01, 0.01, 0.02}), {.spacing = 0.005}));
        fuzz::Random random(3);
        int refused = 0;
        for (int trial = 0; trial < 5000; ++trial) {
            std::string damaged = bytes;
            for (std::size_t i = random.below(3); i < 3; ++i)
                fuzz::mutateBytes(damaged, random);
            try {
                QVERIFY(isSound(aggregateFromBytes(damaged)));
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
        QVERIFY(refused > 1000);
    }

    void whatIsWrongIsRefused()
    {
        const Aggregate sound = filled();
        const auto isRefused = [&](const auto& spoil) {
            Aggregate spoiled = sound;
            spoil(spoiled);
            try {
                aggregateFromBytes(aggregateToBytes(spoiled));
            } catch (const std::runtime_error&) {
                return true;
            }
            return false;
        };
        QVERIFY(!isRefused([](Aggregate&) {}));
        QVERIFY(isRefused([](Aggregate& a) { a.weight[0].back() = 0.5; })); // the last object has no neighbor ahead
        QVERIFY(isRefused([](Aggregate& a) { a.weight[2][0] = -1; }));
        QVERIFY(isRefused([](Aggregate& a) { a.weight[2][endOfRow(a)] = 1; })); // within a segment
        QVERIFY(isRefused([](Aggregate& a) { a.depth[3] = std::nan(""); }));
        QVERIFY(isRefused([](Aggregate& a) { std::swap(a.lattice.nodes[0], a.lattice.nodes[1]); }));
        QVERIFY(isRefused([](Aggregate& a) { a.lattice.nodes[1] = a.lattice.nodes[0]; }));
        QVERIFY(isRefused([](Aggregate& a) { a.lattice.nodes.back()[0] = 0x7fffffff; }));
        QVERIFY(isRefused([](Aggregate& a) { a.lattice.spacing = 0; }));
        QVERIFY(isRefused([](Aggregate& a) { a.lattice.axes(0, 0) += 0.1; }));
        QVERIFY(isRefused([](Aggregate& a) { a.volume.pop_back(); }));
    }
};

QTEST_GUILESS_MAIN(AggregateBytesTest)
#include "aggregate_bytes_test.moc"
