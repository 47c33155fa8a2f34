// What a hand does to clay and rubber under the cursor, as commands: each brush does what its name says.
#include "core/session/sculpting.h"
#include "support/kneaded_clay.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3; // [m]

/// A simulation and a hand on it that looks once in a frame.
class Workplace {
public:
    explicit Workplace(Scene scene)
        : m_simulation(std::move(scene))
        , m_now(m_simulation.snapshot())
    {
    }

    const Snapshot& now() const { return *m_now; }
    const std::vector<Vec3>& positions() const { return m_now->bodies[0].positions; }

    SculptStroke begin(const SculptChoice& choice, const SurfaceSpot& spot, const Vec3& right = Vec3::UnitX())
    {
        SculptStroke stroke(choice, 0, *m_now, spot, right);
        post(stroke.begin());
        return stroke;
    }

    void hold(SculptStroke& stroke, double duration)
    {
        const double end = m_simulation.time() + duration;
        while (m_simulation.time() < end && m_simulation.health().ok) {
            frame();
            m_largestForce = std::max(m_largestForce, stroke.force(*m_now));
            post(stroke.follow(*m_now, true));
        }
    }

    /// @return whether nothing of the hand is left
    bool release(SculptStroke& stroke)
    {
        post(stroke.release(*m_now, true));
        for (int n = 0; n < 200 && !stroke.isOver(); ++n) {
            frame();
            post(stroke.follow(*m_now, true));
        }
        frame();
        if (!m_now->health.ok || !m_now->notice.empty())
            qWarning("%s %s", m_now->health.message.english().c_str(), m_now->notice.english().c_str());
        return stroke.isOver() && m_now->tools.empty() && m_now->fixtures.empty() && m_now->health.ok &&
               m_now->notice.empty();
    }

    double largestForce() const { return m_largestForce; } ///< of the hand so far [N]

    /// Mean height of what lies within a radius of a place on top [m].
    double height(const Vec3& place, double radius) const
    {
        double highest = -1;
        for (const Vec3& position : positions())
            if ((position - place).head<2>().norm() < radius)
                highest = std::max(highest, position.z());
        return highest;
    }

private:
    void frame()
    {
        const double end = m_simulation.time() + 1.0 / 60;
        while (m_simulation.time() < end - 1e-9 && m_simulation.health().ok)
            m_simulation.step();
        m_now = m_simulation.snapshot();
    }

    void post(const std::vector<Command>& commands)
    {
        for (const Command& command : commands)
            m_simulation.post(command);
    }

    Simulation m_simulation;
    std::shared_ptr<const Snapshot> m_now;
    double m_largestForce = 0;
};

Scene lump(const Eigen::Vector3i& cells)
{
    Scene scene;
    scene.bodies.push_back(scenes::box(cells, spacing, scenes::kneadedClay()));
    scene.integrator = Integrator::implicitEuler;
    return scene;
}

/// On top of a box around the origin.
SurfaceSpot onTop(double x, double y, double height)
{
    const Vec3 place(x, y, height);
    return {place, Vec3::UnitZ(), place};
}

SculptChoice choiceOf(SculptBrush brush, double radius)
{
    return {.brush = brush, .radius = radius, .speed = 0.1};
}

/// Of the rotation about the middle that takes the objects from where they were to where they are, about an axis [rad].
double angleAbout(const Vec3& axis, const std::vector<Vec3>& before, const std::vector<Vec3>& after,
                  const std::vector<std::size_t>& objects)
{
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    for (const std::size_t object : objects) {
        from += before[object] / static_cast<double>(objects.size());
        to += after[object] / static_cast<double>(objects.size());
    }
    double sine = 0;
    double cosine = 0;
    for (const std::size_t object : objects) {
        const Vec3 a = before[object] - from;
        const Vec3 b = after[object] - to;
        sine += axis.dot(a.cross(b));
        cosine += (a - a.dot(axis) * axis).dot(b - b.dot(axis) * axis);
    }
    return std::atan2(sine, cosine);
}

} // namespace

class SculptingTest : public QObject {
    Q_OBJECT

private slots:
    void aThumbLeavesADentAndIsGone()
    {
        Workplace place(lump({14, 14, 6}));
        const double top = 3 * spacing;
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::thumb, 6e-3), onTop(0, 0, top));
        place.hold(stroke, 0.5);
        QVERIFY2(place.height(Vec3::Zero(), 2e-3) < top - 1e-3,
                 qPrintable(QString::number(place.height(Vec3::Zero(), 2e-3))));
        QVERIFY(stroke.isAtLimit(place.now()));
        const double limit = thumbForce(scenes::kneadedClay(), 6e-3);
        QVERIFY2(place.largestForce() < 1.15 * limit,
                 qPrintable(QString("%1 N, limit %2 N").arg(place.largestForce()).arg(limit)));
        QVERIFY(place.release(stroke));
        QVERIFY2(place.height(Vec3::Zero(), 2e-3) < top - 0.7e-3, "clay keeps the dent");
        QVERIFY2(std::abs(place.height(Vec3(12e-3, 12e-3, 0), 3e-3) - top) < 0.5e-3, "beside it nothing happened");
    }

    /// More force than suits the material goes deeper.
    void moreStrengthGoesDeeper()
    {
        double depth[2];
        for (const bool isMore : {false, true}) {
            Workplace place(lump({14, 14, 6}));
            SculptStroke stroke = place.begin(choiceOf(SculptBrush::thumb, 6e-3), onTop(0, 0, 3 * spacing));
            place.hold(stroke, 0.3);
            if (isMore)
                stroke.strengthen(2);
            place.hold(stroke, 0.4);
            depth[isMore ? 1 : 0] = 3 * spacing - place.height(Vec3::Zero(), 2e-3);
        }
        QVERIFY2(depth[1] > 1.3 * depth[0],
                 qPrintable(QString("%1 and %2 mm").arg(1e3 * depth[0]).arg(1e3 * depth[1])));
    }

    /// A drawn thumb leaves a groove.
    void aThumbIsDrawnAlong()
    {
        Workplace place(lump({20, 10, 6}));
        const double top = 3 * spacing;
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::thumb, 4e-3), onTop(-10e-3, 0, top));
        place.hold(stroke, 0.25);
        for (double x = -10e-3; x < 12e-3; x += 0.7e-3) {
            stroke.moveTo(onTop(x, 0, top));
            place.hold(stroke, 1.0 / 60);
        }
        place.hold(stroke, 0.3);
        QVERIFY(place.release(stroke));
        for (const double x : {-10e-3, -5e-3, 0.0, 5e-3})
            QVERIFY2(place.height(Vec3(x, 0, 0), 1.6e-3) < top - 0.5e-3,
                     qPrintable(QString("at %1 mm: %2 mm deep")
                                    .arg(1e3 * x)
                                    .arg(1e3 * (top - place.height(Vec3(x, 0, 0), 1.6e-3)))));
    }

    /// The ring around it is where it is, and not where the hand is already.
    void aThumbThatIsBehindIsSeenWhereItIs()
    {
        Workplace place(lump({16, 16, 6}));
        const double top = 3 * spacing;
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::thumb, 4e-3), onTop(-10e-3, 0, top));
        place.hold(stroke, 0.2);
        QVERIFY((stroke.placeNow(place.now()) - Vec3(-10e-3, 0, top)).norm() < 0.1e-3);
        stroke.moveTo(onTop(10e-3, 0, top)); // at once, and faster than fingers are
        place.hold(stroke, 0.05);
        const Vec3 seen = stroke.placeNow(place.now());
        const double isAt = place.now().tools.at(0).pose.position.x();
        QVERIFY2(isAt < 0 && std::abs(seen.x() - isAt) < 1e-9 && std::abs(seen.z() - top) < 1e-9,
                 qPrintable(QString("%1 %2 %3").arg(isAt).arg(seen.x()).arg(seen.z())));
        QVERIFY(place.release(stroke));
    }

    void whatIsDoneIsDoneAcrossThePlanesToo()
    {
        Workplace place(lump({20, 12, 6}));
        SculptChoice choice = choiceOf(SculptBrush::thumb, 5e-3);
        choice.mirrored = {true, false, false};
        SculptStroke stroke = place.begin(choice, onTop(11e-3, 3e-3, 3 * spacing));
        place.hold(stroke, 0.4);
        QCOMPARE(place.now().tools.size(), std::size_t{2});
        QVERIFY(place.release(stroke));
        const double left = place.height(Vec3(-11e-3, 3e-3, 0), 2e-3);
        const double right = place.height(Vec3(11e-3, 3e-3, 0), 2e-3);
        QVERIFY(left < 3 * spacing - 0.5e-3);
        QVERIFY2(std::abs(left - right) < 0.05e-3, qPrintable(QString("%1 and %2").arg(left).arg(right)));
        QVERIFY2(place.height(Vec3(11e-3, -9e-3, 0), 2e-3) > 3 * spacing - 0.5e-3, "not across the others");
    }

    /// On the plane itself one hand is enough.
    void onThePlaneItIsDoneOnce()
    {
        Workplace place(lump({20, 12, 6}));
        SculptChoice choice = choiceOf(SculptBrush::pull, 5e-3);
        choice.mirrored = {true, true, false};
        SculptStroke stroke = place.begin(choice, onTop(1e-3, 8e-3, 3 * spacing));
        place.hold(stroke, 0.05);
        const auto grips = std::ranges::count_if(
            place.now().fixtures, [](const Fixture& fixture) { return fixture.name.starts_with("Grip"); });
        QCOMPARE(grips, 2);
        QVERIFY(place.release(stroke));
    }

    void aPulledPatchComesAlong()
    {
        Workplace place(lump({14, 14, 6}));
        const double top = 3 * spacing;
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::pull, 5e-3), onTop(0, 0, top));
        stroke.moveTo(Vec3(0, 0, top + 8e-3));
        place.hold(stroke, 0.8);
        QVERIFY(place.release(stroke));
        QVERIFY2(place.height(Vec3::Zero(), 2e-3) > top + 2e-3,
                 qPrintable(QString::number(1e3 * place.height(Vec3::Zero(), 2e-3))));
        QVERIFY2(std::abs(place.height(Vec3(12e-3, 12e-3, 0), 3e-3) - top) < 1e-3, "the other hand holds the rest");
    }

    /// A body that is held needs no other hand.
    void whatIsFixedStaysFixed()
    {
        Scene scene = lump({10, 10, 6});
        scene.fixtures.push_back(
            {"foot", 0, objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -2.9 * spacing)))});
        Workplace place(std::move(scene));
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::pull, 5e-3), onTop(0, 0, 3 * spacing));
        place.hold(stroke, 0.05);
        QCOMPARE(place.now().fixtures.size(), std::size_t{2});
        for (const Command& command : stroke.release(place.now(), true))
            QVERIFY(std::holds_alternative<RemoveFixture>(command));
        const SurfaceSpot below{Vec3(0, 0, -4 * spacing), -Vec3::UnitZ(), Vec3(0, 0, -4 * spacing)};
        SculptStroke nothing = place.begin(choiceOf(SculptBrush::pull, 1e-3), below);
        QVERIFY2(nothing.isEmpty(), "all of it is held");
    }

    void aPinchDrawsMaterialTogether()
    {
        Workplace place(lump({18, 18, 6}));
        const double top = 3 * spacing;
        const std::vector<Vec3> before = place.positions();
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::pinch, 8e-3), onTop(0, 0, top));
        place.hold(stroke, 0.8);
        QVERIFY(place.release(stroke));
        double was = 0;
        double is = 0;
        for (std::size_t object = 0; object < before.size(); ++object)
            if (before[object].z() > top - 1e-3 && std::abs(before[object].head<2>().norm() - 8e-3) < 1e-3 &&
                before[object].head<2>().cwiseAbs().minCoeff() < 2.1e-3) {
                was += before[object].head<2>().norm();
                is += place.positions()[object].head<2>().norm();
            }
        QVERIFY2(is < 0.85 * was, qPrintable(QString("%1 of %2").arg(is).arg(was)));
        QVERIFY(place.height(Vec3::Zero(), 2e-3) > top + 0.2e-3);
    }

    void whatIsSmearedGoesAlong()
    {
        Workplace place(lump({20, 10, 6}));
        const double top = 3 * spacing;
        const std::vector<Vec3> before = place.positions();
        SculptStroke stroke = place.begin(choiceOf(SculptBrush::smear, 5e-3), onTop(-10e-3, 0, top));
        place.hold(stroke, 0.2);
        for (double x = -10e-3; x < 10e-3; x += 0.7e-3) {
            stroke.moveTo(onTop(x, 0, top));
            place.hold(stroke, 1.0 / 60);
        }
        place.hold(stroke, 0.2);
        QVERIFY(place.release(stroke));
        double way = 0;
        int count = 0;
        for (std::size_t object = 0; object < before.size(); ++object)
            if (before[object].z() > top - 1e-3 && std::abs(before[object].x()) < 6e-3 &&
                std::abs(before[object].y()) < 2.5e-3) {
                way += place.positions()[object].x() - before[object].x();
                ++count;
            }
        QVERIFY2(way / count > 1e-3, qPrintable(QString("%1 mm").arg(1e3 * way / count)));
    }

    /// What stands out of a surface is pressed down to it; the surface around it stays.
    void smoothAndFlattenLevelABump_data()
    {
        QTest::addColumn<int>("brush");
        QTest::newRow("smooth") << static_cast<int>(SculptBrush::smooth);
        QTest::newRow("flatten") << static_cast<int>(SculptBrush::flatten);
    }
    void smoothAndFlattenLevelABump()
    {
        QFETCH(int, brush);
        Workplace place(lump({18, 18, 6}));
        const double top = 3 * spacing;
        SculptStroke pull = place.begin(choiceOf(SculptBrush::pull, 4e-3), onTop(0, 0, top));
        pull.moveTo(Vec3(0, 0, top + 7e-3));
        place.hold(pull, 0.8);
        QVERIFY(place.release(pull));
        const double bump = place.height(Vec3::Zero(), 2e-3) - top;
        QVERIFY(bump > 1.5e-3);
        SurfaceSpot spot = onTop(0, 0, top + bump);
        spot.level = Vec3(0, 0, top);
        SculptStroke stroke = place.begin(choiceOf(static_cast<SculptBrush>(brush), 6e-3), spot);
        place.hold(stroke, 0.6);
        QVERIFY(place.release(stroke));
        const double left = place.height(Vec3::Zero(), 2e-3) - top;
        QVERIFY2(left < 0.6 * bump, qPrintable(QString("%1 of %2 mm").arg(1e3 * left).arg(1e3 * bump)));
        QVERIFY(std::abs(place.height(Vec3(15e-3, 15e-3, 0), 3e-3) - top) < 0.7e-3);
    }

    /// The end of a rubber bar, held by the other hand, turns as the hand does, with a moment that has a limit.
    void bendTiltsAndTwistTurns_data()
    {
        QTest::addColumn<int>("brush");
        QTest::addColumn<Vec3>("axis");
        QTest::newRow("bend") << static_cast<int>(SculptBrush::bend) << Vec3(0, 0, 1);
        QTest::newRow("twist") << static_cast<int>(SculptBrush::twist) << Vec3(-1, 0, 0);
    }
    void bendTiltsAndTwistTurns()
    {
        QFETCH(int, brush);
        QFETCH(Vec3, axis);
        Scene scene;
        scene.bodies.push_back(scenes::box(
            {24, 5, 5}, spacing, {.density = 1100, .youngsModulus = 1e6, .poissonRatio = 0.3, .dampingRatio = 0.2}));
        scene.integrator = Integrator::implicitEuler;
        Workplace place(std::move(scene));
        const std::vector<Vec3> before = place.positions();
        std::vector<std::size_t> end;
        for (std::size_t object = 0; object < before.size(); ++object)
            if (before[object].x() > 22e-3)
                end.push_back(object);
        const Vec3 tip(24e-3, 0, 0);
        const double radius = 7.5e-3;
        SculptStroke stroke =
            place.begin(choiceOf(static_cast<SculptBrush>(brush), radius), {tip, Vec3::UnitX(), tip}, Vec3::UnitY());
        stroke.moveTo(Vec3(tip + Vec3(0, 0.6 * radius, 0))); // 0.6 rad
        place.hold(stroke, 1.5);
        const double angle = angleAbout(axis, before, place.positions(), end);
        QVERIFY2(angle > 0.2 && angle < 0.65, qPrintable(QString::number(angle)));
        QVERIFY(place.release(stroke));
    }
};

QTEST_APPLESS_MAIN(SculptingTest)
#include "sculpting_test.moc"
