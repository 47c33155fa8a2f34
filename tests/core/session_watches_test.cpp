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
            QVERIFY(watch.see(now).said.empty());
        QCOMPARE(watch.see(now).said.size(), std::size_t{1});
        for (int i = 0; i < 100; ++i)
            QVERIFY(watch.see(now).said.empty());
        now.playing = false;
        now.penetration = 0.2;
        const std::vector<Remark> said = watch.see(now).said;
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(said[0].sentence.english().find("0.2 spacings into material") != std::string::npos);
        now.addedMass = now.penetration = 0;
        QVERIFY(watch.see(now).said.empty());
        now.addedMass = 0.02;
        QVERIFY(watch.see(now).said.empty()); // it came and went
        now.addedMass = 0;
        ++now.resets;
        QVERIFY(watch.see(now).said.empty());
        now.addedMass = 0.02;
        QCOMPARE(watch.see(now).said.size(), std::size_t{1});
    }

    /// A thumb as it comes is no reason to stop; what grows beyond that is said anew.
    void whatIsMinorIsSaidAgainWhenItIsNot()
    {
        QualityWatch watch;
        Snapshot now;
        now.penetration = 0.36;
        std::vector<Remark> said = watch.see(now).said;
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(said[0].isMinor);
        QVERIFY(watch.see(now).said.empty());
        now.penetration = 0.6;
        said = watch.see(now).said;
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(!said[0].isMinor);
        now.penetration = 0.4;
        QVERIFY(watch.see(now).said.empty());
    }

    /// Undone, a sentence is no longer so; where it still is, it stays.
    void whatIsUndonePasses()
    {
        QualityWatch watch;
        Snapshot now;
        now.penetration = 0.6;
        now.addedMass = 0.02;
        QCOMPARE(watch.see(now).said.size(), std::size_t{2});
        now.penetration = 0;
        QVERIFY(watch.see(now).passed.empty()); // it was so
        ++now.arrivals;
        const std::vector<Message> passed = watch.see(now).passed;
        QCOMPARE(passed.size(), std::size_t{1});
        QVERIFY(passed[0].english().find("0.6 spacings into material") != std::string::npos);
        QVERIFY(watch.see(now).passed.empty());
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
