#include "core/session/quality_watch.h"
#include "core/session/stall_watch.h"

#include <QtTest>

using namespace knead;

/// What a window says of how a simulation goes: once, and not for nothing.
class SessionWatchesTest : public QObject {
    Q_OBJECT

private slots:
    /// Each once; again only after it was well and another moment was gone to.
    void concernsAreSaidOnce()
    {
        QualityWatch watch;
        Snapshot now;
        now.playing = true;
        now.addedMass = 0.02;
        for (int i = 0; i < 29; ++i)
            QVERIFY(watch.see(now).empty());
        QCOMPARE(watch.see(now).size(), std::size_t{1});
        for (int i = 0; i < 100; ++i)
            QVERIFY(watch.see(now).empty());
        now.playing = false;
        now.penetration = 0.2;
        const std::vector<Message> said = watch.see(now);
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(said[0].english().find("0.2 spacings into material") != std::string::npos);
        now.addedMass = now.penetration = 0;
        QVERIFY(watch.see(now).empty());
        now.addedMass = 0.02;
        QVERIFY(watch.see(now).empty()); // it came and went
        now.addedMass = 0;
        ++now.resets;
        QVERIFY(watch.see(now).empty());
        now.addedMass = 0.02;
        QCOMPARE(watch.see(now).size(), std::size_t{1});
    }

    void aStallIsSaidWithinFiveSeconds()
    {
        StallWatch watch;
        const auto lookFor = [&](double from, double to, double ratio, double speed) {
            int said = 0;
            for (double wall = from; wall < to; ++wall)
                said += watch.look({.wall = wall, .simulated = ratio * wall}, speed) ? 1 : 0;
            return said;
        };
        QCOMPARE(lookFor(0, 5, 0.001, 1), 1);
        QCOMPARE(lookFor(5, 60, 0.001, 1), 0); // no nagging
        watch = {};
        QCOMPARE(lookFor(0, 20, 0.05, 1), 0);      // slow, and seen to move
        QCOMPARE(lookFor(20, 40, 0.009, 0.01), 0); // slow motion as asked for
    }
};

QTEST_GUILESS_MAIN(SessionWatchesTest)
#include "session_watches_test.moc"
