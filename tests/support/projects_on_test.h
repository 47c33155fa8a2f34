#pragma once

#include "support/window_on_test.h"
#include "ui/dialogs/recent_files.h"
#include "ui/project/project_keeper.h"

#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// A window with projects and recoveries in a folder that goes with the test.
class ProjectsOnTest : public WindowOnTest {
protected:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::atomic<bool> m_isDiskSlow = false;

    QString file(const char* name) const { return m_folder->filePath(name); }
    static std::string bytesOf(const QString& path) { return QFile::encodeName(path).toStdString(); }
    ProjectKeeper& projects() { return m_window->projects(); }
    std::uint64_t hash()
    {
        const History& tree = document().history().tree();
        return tree.record(tree.current()).hash;
    }

    bool isIdle()
    {
        return !m_window->tasks().isRunning() && document().history().isSettled() && !document().isGoing();
    }
    void wait()
    {
        QVERIFY2(comesTrue([this] { return isIdle(); }), "something goes on and on");
    }
    /// A gesture may be gone on with for a second, and is an entry of the history only then.
    void waitForGesture()
    {
        if (document().isPlaying())
            QTest::qWait(1200);
        QVERIFY2(comesTrue([this] { return document().isPlaying() || !document().isAnythingUnderWay(); }),
                 "what was done does not end");
        rest();
        wait();
    }

    /// A block pushed into the bracket, with keys.
    void work()
    {
        openExample("bracket.step", 12);
        pushOn();
    }

    void pushOn()
    {
        if (snapshot().tools.empty()) {
            QTest::keyClick(m_window.get(), Qt::Key_B);
            QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        }
        document().select({Selection::Kind::Tool, snapshot().tools[0].id});
        const double time = snapshot().time;
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.3, patience);
        QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        waitForGesture();
    }

    /// With its key, and until it is in the history; a task may be running.
    void switchGravity()
    {
        const std::size_t entries = document().history().tree().records().size();
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTRY_COMPARE_WITH_TIMEOUT(document().history().tree().records().size(), entries + 1, patience);
    }

    void openProject(const QString& path)
    {
        m_window->open(QStringList(path));
        wait();
    }

    void saveTo(const QString& path)
    {
        projects().saveTo(path);
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && projects().path() == path && !projects().isModified(), patience);
    }

    /// Nothing is written while the disk is slow.
    Services servicesWithSlowDisk()
    {
        Services slow = m_services;
        slow.projects.write = [this, write = m_services.projects.write](const std::string& path, const Project& project,
                                                                        TaskControl& control) {
            control.report(0.5, "waiting for the disk");
            while (m_isDiskSlow && !control.isCancelled())
                QTest::qSleep(5);
            write(path, project, control);
        };
        return slow;
    }

    void newWindow(const Services& services)
    {
        m_window.reset(); // as a crash would, but for what is on its way to the disk
        show(services);
    }

    /// Takes the first of the recoveries that are offered.
    void recoverByHand()
    {
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("recoveryRecover") != nullptr, patience);
        clickOn<QPushButton>("recoveryRecover");
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        wait();
    }

    template <class Widget>
    void clickOn(const char* name)
    {
        auto* widget = find<Widget>(name);
        QVERIFY2(widget != nullptr, name);
        QTRY_VERIFY(widget->isVisible());
        QTest::mouseClick(widget, Qt::LeftButton);
    }

    /// Answers the message that is asked.
    void answer(const char* name, QMessageBox::StandardButton button)
    {
        QTRY_VERIFY2_WITH_TIMEOUT(find<QMessageBox>(name) != nullptr && find<QMessageBox>(name)->isVisible(), name,
                                  patience);
        QVERIFY(QTest::qWaitForWindowExposed(find<QMessageBox>(name), patience));
        QTest::mouseClick(find<QMessageBox>(name)->button(button), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(find<QMessageBox>(name) == nullptr, name, patience);
        m_window->activateWindow(); // there may be no window manager that does it
    }

    std::vector<std::vector<Vec3>> statesOfSteps(int steps)
    {
        std::vector<std::vector<Vec3>> states;
        for (int i = 0; i < steps; ++i) {
            const std::uint64_t step = snapshot().step;
            document().stepOnce();
            [&] { QTRY_COMPARE_WITH_TIMEOUT(snapshot().step, step + 1, patience); }();
            for (const auto& body : snapshot().bodies)
                states.push_back(body.positions);
        }
        return states;
    }

    void begin()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        qputenv("XDG_STATE_HOME", m_folder->path().toUtf8());
        m_isDiskSlow = false;
        recent_files::clear();
        show(m_services);
    }
};

} // namespace knead
