#include "ui/tasks/task_runner.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>
#include <thread>

using namespace knead;

class TaskRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void theResultArrivesOnTheThreadThatAsked()
    {
        TaskRunner runner;
        int result = 0;
        std::thread::id workThread;
        std::thread::id finishThread;
        runner.run<int>(
            "adding",
            [&](TaskControl&) {
                workThread = std::this_thread::get_id();
                return 42;
            },
            [&](int sum) {
                result = sum;
                finishThread = std::this_thread::get_id();
            });
        QTRY_COMPARE(result, 42);
        QVERIFY(workThread != std::this_thread::get_id());
        QVERIFY(finishThread == std::this_thread::get_id());
        QVERIFY(!runner.isRunning());
    }

    void progressIsToldWithItsStage()
    {
        TaskRunner runner;
        QSignalSpy progress(&runner, &TaskRunner::progressed);
        std::atomic<bool> go = false;
        runner.run<int>(
            "reading",
            [&](TaskControl& control) {
                control.report(0.25, "reading faces");
                while (!go)
                    std::this_thread::yield();
                return 0;
            },
            [](int) {});
        QTRY_VERIFY(!progress.isEmpty() && progress.last()[1].toString() == "reading faces");
        QCOMPARE(progress.last()[0].toDouble(), 0.25);
        go = true;
        QTRY_VERIFY(!runner.isRunning());
    }

    void aFailureIsOneSentenceAndNoResult()
    {
        TaskRunner runner;
        QSignalSpy failures(&runner, &TaskRunner::failed);
        bool hasResult = false;
        runner.run<int>(
            "opening", [](TaskControl&) -> int { throw std::runtime_error("part.step: no solid found."); },
            [&](int) { hasResult = true; });
        QTRY_COMPARE(failures.size(), 1);
        QCOMPARE(failures[0][1].toString(), QString("part.step: no solid found."));
        QVERIFY(!hasResult);
    }

    void cancelIsFeltAtOnceEvenByWorkThatDoesNotListen()
    {
        TaskRunner runner;
        QSignalSpy cancels(&runner, &TaskRunner::cancelled);
        std::atomic<bool> go = false;
        bool hasResult = false;
        runner.run<int>(
            "stubborn",
            [&](TaskControl&) {
                while (!go)
                    std::this_thread::yield();
                return 1;
            },
            [&](int) { hasResult = true; });
        runner.cancel();
        QCOMPARE(cancels.size(), 1);
        QVERIFY(!runner.isRunning());
        int next = 0;
        QVERIFY(runner.run<int>(
            "next", [](TaskControl&) { return 7; }, [&](int value) { next = value; }));
        QTRY_COMPARE(next, 7);
        go = true;
        QTest::qWait(50);
        QVERIFY(!hasResult);
    }

    void workThatListensStops()
    {
        TaskRunner runner;
        std::atomic<bool> stopped = false;
        runner.run<int>(
            "listening",
            [&](TaskControl& control) -> int {
                try {
                    for (;;)
                        control.throwIfCancelled();
                } catch (const Cancelled&) {
                    stopped = true;
                    throw;
                }
            },
            [](int) {});
        runner.cancel();
        QTRY_VERIFY(stopped);
    }

    void oneTaskAtATime()
    {
        TaskRunner runner;
        std::atomic<bool> go = false;
        const auto wait = [&](TaskControl&) {
            while (!go)
                std::this_thread::yield();
            return 0;
        };
        QVERIFY(runner.run<int>("first", wait, [](int) {}));
        QVERIFY(!runner.run<int>("second", wait, [](int) {}));
        go = true;
        QTRY_VERIFY(!runner.isRunning());
    }
};

QTEST_GUILESS_MAIN(TaskRunnerTest)
#include "task_runner_test.moc"
