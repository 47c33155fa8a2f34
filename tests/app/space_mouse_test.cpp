#include "app/space_mouse.h"
#include "support/stand_in_spacenavd.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <vector>

using namespace knead;

namespace {

/// What a listener was told.
class Heard {
public:
    std::function<void(const SpaceEvent&)> listener()
    {
        return [this](const SpaceEvent& event) {
            const std::lock_guard lock(m_mutex);
            m_events.push_back(event);
        };
    }
    std::vector<SpaceEvent> all() const
    {
        const std::lock_guard lock(m_mutex);
        return m_events;
    }
    std::ptrdiff_t count(SpaceEvent::Kind kind) const
    {
        const std::vector<SpaceEvent> events = all();
        return std::count_if(events.begin(), events.end(), [kind](const SpaceEvent& e) { return e.kind == kind; });
    }

private:
    mutable std::mutex m_mutex;
    std::vector<SpaceEvent> m_events;
};

} // namespace

/// A 3D mouse, played by a daemon that speaks as spacenavd does.
class SpaceMouseTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::string path() { return m_folder.filePath("spnav.sock").toStdString(); }

private slots:
    void initTestCase() { qputenv("SPNAV_SOCKET", path().c_str()); }

    void noDaemonIsNoError()
    {
        Heard heard;
        const auto listening = listenToSpaceMouse(heard.listener());
        QTest::qWait(50);
        QVERIFY(heard.all().empty() || std::filesystem::exists("/var/run/spnav.sock"));
    }

    void motionsAndButtonsArrive_data()
    {
        QTest::addColumn<bool>("answersVersion");
        QTest::newRow("spacenavd 1.0") << true;
        QTest::newRow("older, which does not answer") << false;
    }
    void motionsAndButtonsArrive()
    {
        QFETCH(bool, answersVersion);
        StandInSpacenavd daemon(path(), answersVersion);
        Heard heard;
        const auto listening = listenToSpaceMouse(heard.listener());
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::connected), 1);
        daemon.move({350, 0, -175}, {0, 70, 0}, 16);
        daemon.pressAndRelease(1);
        daemon.move({0, 0, 0}, {0, 0, 0}, 16);
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::motion), 2);
        const std::vector<SpaceEvent> events = heard.all();
        QCOMPARE(events[1].motion.push, Vec3(1, 0, 0.5)); // away from the person is away from the eye
        QCOMPARE(events[1].motion.turn, Vec3(0, 0.2, 0));
        QCOMPARE(events[1].motion.seconds, 0.016);
        QCOMPARE(events[2].kind, SpaceEvent::Kind::buttonPressed);
        QCOMPARE(events[2].button, 1);
        QVERIFY(events[3].motion.isRest());
    }

    void aDaemonThatGoesAndComesIsFollowed()
    {
        Heard heard;
        const auto listening = listenToSpaceMouse(heard.listener());
        {
            StandInSpacenavd daemon(path());
            QTRY_COMPARE(heard.count(SpaceEvent::Kind::connected), 1);
        }
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::disconnected), 1);
        StandInSpacenavd daemon(path());
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::connected), 2);
        daemon.move({0, 350, 0}, {0, 0, 0}, 8);
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::motion), 1);
    }

    void nothingIsToldAfterTheEnd()
    {
        StandInSpacenavd daemon(path());
        Heard heard;
        auto listening = listenToSpaceMouse(heard.listener());
        QTRY_COMPARE(heard.count(SpaceEvent::Kind::connected), 1);
        listening.reset();
        const std::size_t told = heard.all().size();
        daemon.move({350, 0, 0}, {0, 0, 0}, 8);
        QTest::qWait(50);
        QCOMPARE(heard.all().size(), told);
    }
};

QTEST_GUILESS_MAIN(SpaceMouseTest)
#include "space_mouse_test.moc"
