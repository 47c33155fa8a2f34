// What of a skin is drawn where material has broken: cracks are seen live, in films and where no surface could be made of
// them.
#include "core/session/crack_gaps.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/refine.h"
#include "core/session/frame.h"
#include "core/session/playback_cache.h"
#include "support/material_scenes.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace knead;

namespace {

constexpr double spacing = 2.5e-3; // [m]
const Vec3 size(0.08, 0.02, 0.02);

/// A bar as the window shows it, and the simulation of it.
struct Bar {
    explicit Bar(const Material& material)
    {
        const TriangleMesh mesh = shapes::box(size);
        Body filled = scenes::body(mesh, spacing, material);
        auto shown = std::make_shared<FilledBody>();
        shown->mesh = refine(mesh, spacing, 100'000);
        shown->render = renderMesh(shown->mesh);
        shown->aggregate = filled.aggregate;
        shown->skin.emplace(*filled.aggregate, shown->mesh.vertices);
        bodies.push_back(withNewFillings(shown));
        scene.bodies.push_back(std::move(filled));
    }

    std::vector<ObjectIndex> objectsFrom(double low, double high) const
    {
        return objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(low, -1, -1), Vec3(high, 1, 1)));
    }

    Scene scene;
    FilledBodies bodies;
};

/// The longest edge of what is drawn [spacings].
double longestDrawn(const Frame& frame)
{
    const std::vector<Vec3>& places = frame.bodies[0]->places;
    const std::vector<TriangleMesh::Triangle>& triangles = frame.filled[0]->mesh.triangles;
    double longest = 0;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        if (!std::ranges::binary_search(frame.bodies[0]->acrossCracks, t))
            for (std::size_t i = 0; i < 3; ++i)
                longest = std::max(longest, (places[triangles[t][i]] - places[triangles[t][(i + 1) % 3]]).norm());
    return longest / spacing;
}

/// A state in which what is beyond the middle has moved along the bar.
SnapshotPointer pulledApart(const Bar& bar, double gap, std::vector<BrokenConnection> broken)
{
    auto snapshot = std::make_shared<Snapshot>();
    const std::shared_ptr<const Aggregate>& aggregate = bar.scene.bodies[0].aggregate;
    std::vector<Vec3> positions = aggregate->lattice.positions();
    for (Vec3& place : positions)
        place.x() += place.x() > 0 ? gap : 0;
    snapshot->step = static_cast<std::uint64_t>(1e6 * gap);
    snapshot->time = gap;
    snapshot->bodies.push_back(
        {.positions = std::move(positions),
         .aggregate = aggregate,
         .broken =
             broken.empty() ? nullptr : std::make_shared<const std::vector<BrokenConnection>>(std::move(broken))});
    return snapshot;
}

/// By which the connections that hold are stretched at most.
double stretchOfMaterial(const Frame& frame)
{
    const Snapshot::BodyState& state = frame.snapshot->bodies[0];
    const Aggregate& aggregate = *state.aggregate;
    const std::vector<std::uint16_t> isBroken =
        state.broken ? brokenDirections(aggregate, *state.broken) : std::vector<std::uint16_t>(aggregate.size(), 0);
    double most = 1;
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        if ((isBroken[lower] >> d & 1U) == 0)
            most = std::max(most, (state.positions[upper] - state.positions[lower]).norm() /
                                      aggregate.lattice.direction(static_cast<int>(d)).norm());
    });
    return most;
}

/// All connections across the middle.
std::vector<BrokenConnection> acrossTheMiddle(const Aggregate& aggregate)
{
    std::vector<BrokenConnection> broken;
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        if ((aggregate.lattice.position(lower).x() > 0) != (aggregate.lattice.position(upper).x() > 0))
            broken.push_back({{d, lower}});
    });
    return broken;
}

} // namespace

class CrackGapsTest : public QObject {
    Q_OBJECT

private slots:
    /// Neither whole nor in pieces does a body stay in memory when nobody has it any more.
    void aBodyThatNobodyHasIsGone()
    {
        std::weak_ptr<const Aggregate> aggregate;
        std::weak_ptr<const Aggregate> other;
        {
            Bar bar(scenes::clay());
            aggregate = bar.bodies[0]->aggregate;
            Simulation simulation(bar.scene);
            bar.scene = {};
            simulation.post(Cut{.body = 0, .point = Vec3(0.3e-3, 0, 0), .normal = Vec3::UnitX()});
            simulation.applyCommands();
            const FramePointer cut = prepareFrame(bar.bodies, simulation.snapshot(), nullptr);
            QVERIFY(cut->filled[0]->whole);
            const auto again = std::make_shared<const Aggregate>(*bar.bodies[0]->aggregate);
            other = again;
            const auto filled = filledAs(cut->filled[0], again);
            bar.bodies = {filledAs(filled, bar.bodies[0]->aggregate)}; // as when one goes back
            QVERIFY(filledAs(bar.bodies[0], again) == filled);
            QVERIFY(prepareFrame(bar.bodies, simulation.snapshot(), nullptr)->filled == cut->filled);
        }
        QVERIFY(aggregate.expired() && other.expired());
    }

    void noSkinSpansABarThatIsPulledInTwo_data()
    {
        QTest::addColumn<Material>("material");
        Material brittle;
        brittle.tensileStrength = 3e4;
        QTest::newRow("brittle") << brittle;
        Material clay;
        clay.yieldStress = 2e4;
        clay.elongationAtBreak = 0.5;
        QTest::newRow("clay") << clay;
    }

    /// At every moment, live and looking back, also between two pictures of the film.
    void noSkinSpansABarThatIsPulledInTwo()
    {
        QFETCH(Material, material);
        constexpr double more = 1.4; // than the material is stretched, of an edge that is a spacing long at rest
        const auto spansNothing = [](const Frame& frame) {
            return longestDrawn(frame) < more * stretchOfMaterial(frame);
        };
        Bar bar(material);
        const double held = 0.425 * size.x();
        bar.scene.fixtures.push_back({"left", 0, bar.objectsFrom(-1, -held)});
        bar.scene.fixtures.push_back({"right", 0, bar.objectsFrom(held, 1), Vec3(0.3, 0, 0)});
        Simulation simulation(bar.scene);
        PlaybackCache film;
        FramePointer live;
        double moment = 0;
        while (simulation.time() < 0.08) {
            simulation.step();
            QVERIFY(simulation.health().ok);
            if (simulation.time() < moment)
                continue;
            moment = simulation.time() + 1.0 / 120;
            const SnapshotPointer now = simulation.snapshot();
            live = prepareFrame(bar.bodies, now, live, true);
            QVERIFY2(spansNothing(*live),
                     qPrintable(QString("live at %1: %2").arg(now->time).arg(longestDrawn(*live))));
            film.add(*now);
        }
        QVERIFY(live->snapshot->components > 1);
        const std::vector<PlaybackFramePointer>& pictures = film.underWay();
        for (std::size_t i = 1; i < pictures.size(); ++i)
            for (const double share : {0.0, 0.5, 0.9}) {
                const FramePointer seen = drawable(between(*pictures[i - 1], *pictures[i], share), bar.bodies);
                QVERIFY2(spansNothing(*seen),
                         qPrintable(QString("film at %1: %2").arg(pictures[i]->time).arg(longestDrawn(*seen))));
            }
    }

    /// Half way between a picture in which the bar is whole and one in which it is in two, four spacings apart.
    void aCrackOpensBetweenTwoPicturesOfAFilm()
    {
        const Bar bar({});
        const std::vector<BrokenConnection> broken = acrossTheMiddle(*bar.scene.bodies[0].aggregate);
        PlaybackCache film;
        film.add(*pulledApart(bar, 0, {}));
        film.add(*pulledApart(bar, 8 * spacing, broken));
        const PlaybackFrame& whole = *film.underWay()[0];
        const PlaybackFrame& apart = *film.underWay()[1];
        QVERIFY(!drawable(between(whole, apart, 0), bar.bodies)->filled[0]->whole);
        for (const auto& [from, to] : {std::pair(whole, apart), std::pair(apart, whole)}) {
            const FramePointer seen = drawable(between(from, to, 0.5), bar.bodies);
            QVERIFY(seen->filled[0]->whole); // with the sides of the crack
            QVERIFY2(longestDrawn(*seen) < 1.1, qPrintable(QString::number(longestDrawn(*seen))));
            QVERIFY(seen->bodies[0]->acrossCracks.empty());
        }
    }

    /// Damage that has no sides, in a bar that is pulled apart there: what spans the gap is not
    /// drawn, and all else is.
    void damageThatGapesIsAGap()
    {
        const Bar bar({});
        const Aggregate& aggregate = *bar.scene.bodies[0].aggregate;
        std::vector<BrokenConnection> broken = acrossTheMiddle(aggregate);
        const auto across = broken.size();
        const auto goesAcross = [&](ObjectIndex lower, ObjectIndex upper) {
            return (aggregate.lattice.position(lower).x() > 0) != (aggregate.lattice.position(upper).x() > 0);
        };
        std::mt19937 random(1);
        aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
            const double x = aggregate.lattice.position(lower).x() + aggregate.lattice.position(upper).x();
            if (std::abs(x) < 8 * spacing && random() % 2 == 0 && !goesAcross(lower, upper))
                broken.push_back({{d, lower}});
        });
        QVERIFY(broken.size() > across);
        std::erase_if(broken, [&, n = 0](const BrokenConnection&) mutable { return ++n % 40 == 0; }); // threads
        const FramePointer seen = prepareFrame(bar.bodies, pulledApart(bar, 4 * spacing, broken), nullptr);
        QVERIFY2(longestDrawn(*seen) < 2, qPrintable(QString::number(longestDrawn(*seen))));
        QVERIFY(!seen->bodies[0]->acrossCracks.empty());
        const std::size_t all = seen->filled[0]->mesh.triangles.size();
        QVERIFY(seen->bodies[0]->acrossCracks.size() < all / 10);
        const FramePointer closed = prepareFrame(bar.bodies, pulledApart(bar, 0, broken), nullptr);
        QVERIFY(closed->bodies[0]->acrossCracks.empty());
    }

    /// Rubber that is drawn out to three times its length with a scratch in it is all drawn.
    void whatIsDrawnOutIsNoGap()
    {
        const Bar bar({});
        std::vector<BrokenConnection> few = acrossTheMiddle(*bar.scene.bodies[0].aggregate);
        few.resize(8);
        auto snapshot = std::make_shared<Snapshot>(*pulledApart(bar, 0, few));
        for (Vec3& place : snapshot->bodies[0].positions)
            place.x() *= 3;
        const FramePointer seen = prepareFrame(bar.bodies, snapshot, nullptr);
        QVERIFY(longestDrawn(*seen) > 2);
        QVERIFY(seen->bodies[0]->acrossCracks.empty());
    }
};

QTEST_GUILESS_MAIN(CrackGapsTest)
#include "crack_gaps_test.moc"
