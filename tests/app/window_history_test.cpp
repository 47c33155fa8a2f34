#include "core/document/byte_stream.h"
#include "support/fuzz_random.h"
#include "support/window_on_test.h"
#include "ui/document/entry_names.h"
#include "ui/panels/timeline_axis.h"
#include "ui/panels/timeline_panel.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include <cmath>
#include <map>

using namespace knead;

namespace {

using Entry = Document::Entry;

/// Everything that a person could see of a state, to the last bit.
std::uint64_t digestOf(const Snapshot& snapshot)
{
    ByteWriter bytes;
    bytes(snapshot.step);
    bytes(snapshot.time);
    bytes(snapshot.gravity);
    bytes(snapshot.floorHeight.has_value());
    for (const Snapshot::BodyState& body : snapshot.bodies) {
        bytes(static_cast<int>(body.kind));
        for (const Vec3& position : body.positions)
            bytes(position);
    }
    for (const Material& material : snapshot.materials)
        for (const MaterialField& field : materialFields())
            bytes(material.*field.value);
    for (const ToolState& tool : snapshot.tools) {
        bytes(tool.id);
        bytes(tool.name);
        bytes(tool.size);
        bytes(tool.pose.position);
        bytes(tool.friction);
    }
    for (const Fixture& fixture : snapshot.fixtures) {
        bytes(fixture.name);
        for (const ObjectIndex object : fixture.objects)
            bytes(object);
    }
    bytes(snapshot.energy.elastic);
    return checksumOf(bytes.take());
}

} // namespace

/// Undo and redo as a person uses them.
class WindowHistoryTest : public QObject, WindowOnTest {
    Q_OBJECT

    const History& tree() { return document().history().tree(); }
    const HistoryRecord& present() { return tree().record(tree().current()); }
    QString presentName() { return QString::fromStdString(present().name); }

    /// Waits until everything that was done is in the history and shown.
    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        QVERIFY(snapshot().step == present().step && snapshot().time == present().time);
    }

    std::uint64_t digest()
    {
        settle();
        return digestOf(snapshot());
    }

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }
    void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

    void simulate(double seconds)
    {
        const double end = snapshot().time + seconds;
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time >= end, patience);
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
    }

    /// In both themes and two sizes.
    void pictures(const QString& name)
    {
        for (const Theme theme : {Theme::Dark, Theme::Light})
            for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
                m_window->setTheme(theme);
                m_window->resize(size);
                QTest::qWait(200);
                const char* word = theme == Theme::Dark ? "dark" : "light";
                picture(qPrintable(QString("%1-%2-%3").arg(name, word).arg(size.width())));
            }
    }

    double spacingOfObjects(double count)
    {
        return std::cbrt(document().content().bodies[0]->aggregate->meshVolume / count);
    }

    void addBlock()
    {
        const std::size_t before = snapshot().tools.size();
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), before + 1);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
    }

    /// Undo and redo lead exactly back and forth.
    void verifyUndo(std::uint64_t before, const QString& name)
    {
        const std::uint64_t after = digest();
        QCOMPARE(presentName(), name);
        QCOMPARE(action("undo")->text(), QString("Undo \"%1\"").arg(name));
        undo();
        QCOMPARE(digest(), before);
        QCOMPARE(action("redo")->text(), QString("Redo \"%1\"").arg(name));
        redo();
        QCOMPARE(digest(), after);
        QVERIFY(!action("redo")->isEnabled());
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            QSKIP("The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        show(m_services);
        QVERIFY(!action("undo")->isEnabled() && !action("redo")->isEnabled());
        openExample("bar.step", 12);
        settle();
    }

    void cleanup() { m_window.reset(); }

    void importingAndFillingAreEntries()
    {
        QCOMPARE(tree().record(0).name, std::string("Import bar.step"));
        QCOMPARE(tree().records().size(), std::size_t{2});
        QVERIFY(presentName().startsWith("Refill "));
        QVERIFY(present().wallTime > 1.7e9);
        const std::size_t objects = snapshot().objects;
        const std::uint64_t after = digest();
        undo();
        settle();
        QCOMPARE(tree().current(), Entry{0});
        QVERIFY(snapshot().objects != objects);
        QCOMPARE(document().content().bodies[0]->aggregate->size(), snapshot().objects);
        QVERIFY(!action("undo")->isEnabled());
        redo();
        QCOMPARE(digest(), after);
        QCOMPARE(snapshot().objects, objects);
    }

    void aTime()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        const std::uint64_t before = digest();
        simulate(0.2);
        settle();
        QVERIFY2(presentName().startsWith("Simulate ") && presentName().endsWith(" ms") == false,
                 qPrintable(presentName()));
        verifyUndo(before, presentName());
        // From there on everything happens again as it did.
        const std::uint64_t step = snapshot().step;
        undo();
        settle();
        simulate(0.05);
        QVERIFY(snapshot().step < step);
    }

    void toolsComeAndGo()
    {
        const std::uint64_t empty = digest();
        addBlock();
        verifyUndo(empty, "Add Block 1");
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        click(snapshot().tools[0].pose.position);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        const std::uint64_t withBlock = digest();
        key(Qt::Key_Delete);
        QTRY_VERIFY(snapshot().tools.empty());
        verifyUndo(withBlock, "Remove Block 1");
        undo();
        undo();
        QCOMPARE(digest(), empty);
        QVERIFY(document().selection().kind != Selection::Kind::Tool);
        addBlock();
        QCOMPARE(snapshot().tools[0].name, std::string("Block 1"));
    }

    void aDraggedToolIsOneEntry()
    {
        addBlock();
        key(Qt::Key_F);
        QTest::qWait(500);
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        ViewportWidget& view = m_window->viewport();
        const QPoint from = view.widgetPosition(snapshot().tools[0].pose.position)->toPoint();
        QTest::mouseMove(&view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 8; ++i) {
            QTest::mouseMove(&view, from + QPoint(10 * i, 0));
            QTest::qWait(20);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(80, 0));
        verifyUndo(before, "Move Block 1");
        QCOMPARE(tree().records().size(), entries + 1);
        // A click that moves nothing is none.
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.widgetPosition(snapshot().tools[0].pose.position)->toPoint());
        settle();
        QCOMPARE(tree().records().size(), entries + 1);
    }

    void keysWithinASecondAreOneEntry()
    {
        addBlock();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        m_window->viewport().setFocus();
        for (int i = 0; i < 5; ++i) {
            const double z = snapshot().tools[0].pose.position.z();
            QTest::keyClick(&m_window->viewport(), Qt::Key_PageDown);
            QTRY_VERIFY(snapshot().tools[0].pose.position.z() < z);
        }
        QTRY_COMPARE(tree().records().size(), entries + 1);
        verifyUndo(before, "Move Block 1");
    }

    void aPushIsOneEntryAndWhatCameBeforeAnother()
    {
        addBlock();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.15, patience);
        QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().tools[0].force.z() > 0.05, patience);
        QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_COMPARE_WITH_TIMEOUT(tree().records().size(), entries + 2, patience);
        QCOMPARE(presentName(), QString("Push with Block 1"));
        QVERIFY(tree().record(present().parent).name.starts_with("Simulate "));
        QVERIFY(snapshot().playing);
        // Undone while it plays: what was simulated since is kept as well.
        QTest::qWait(200);
        undo();
        settle();
        QVERIFY(!snapshot().playing);
        QCOMPARE(tree().records().size(), entries + 3);
        QCOMPARE(presentName(), QString("Push with Block 1"));
        QVERIFY(action("redo")->text().contains("Simulate"));
        for (int i = 0; i < 2; ++i)
            undo();
        QCOMPARE(digest(), before);
        redo();
        redo();
        settle();
        QCOMPARE(presentName(), QString("Push with Block 1"));
    }

    void materialsAreUndone()
    {
        const std::uint64_t before = digest();
        const double softness = snapshot().materials[0].youngsModulus;
        auto* preset = find<QComboBox>("materialPreset");
        preset->setCurrentText("Modeling clay");
        emit preset->activated(preset->currentIndex());
        QTRY_VERIFY(snapshot().materials[0].youngsModulus != softness);
        verifyUndo(before, QString::fromUtf8("Material of Bar → Modeling clay"));
        undo();
        settle();
        QCOMPARE(snapshot().materials[0].youngsModulus, softness);
        QVERIFY(preset->currentText() != "Modeling clay");
        redo();
        settle();
        QCOMPARE(preset->currentText(), QString("Modeling clay"));
    }

    void fixturesAreUndone()
    {
        const std::uint64_t before = digest();
        key(Qt::Key_X);
        const Box box = document().content().box;
        click(Vec3(box.center().x(), box.center().y(), box.max().z()));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        verifyUndo(before, "Fix face");
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        const std::vector<std::uint32_t> faces = document().fixtures().list()[0].faces;
        QCOMPARE(faces.size(), std::size_t{1});
        undo();
        settle();
        QVERIFY(document().fixtures().list().empty());
        redo();
        settle();
        QCOMPARE(document().fixtures().list().at(0).faces, faces);
        const std::uint64_t fixed = digest();
        click(Vec3(box.center().x(), box.center().y(), box.max().z()));
        QTRY_VERIFY(snapshot().fixtures.empty());
        verifyUndo(fixed, "Free face");
    }

    void switchesFollow()
    {
        const std::uint64_t before = digest();
        key(Qt::Key_G);
        QTRY_VERIFY(!snapshot().gravity.isZero());
        verifyUndo(before, "Gravity on");
        QVERIFY(action("gravity")->isChecked());
        undo();
        settle();
        QVERIFY(!action("gravity")->isChecked());
    }

    void resetAndRenormalizationAreUndone()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.1);
        const std::uint64_t bent = digest();
        key(Qt::Key_N);
        settle();
        verifyUndo(bent, "Re-normalize");
        undo();
        settle();
        key(Qt::Key_Backspace);
        settle();
        verifyUndo(bent, "Reset");
        undo();
        QCOMPARE(digest(), bent);
    }

    void manyStepsBackMakeOneJourney()
    {
        std::vector<std::uint64_t> digests{digest()};
        for (int i = 0; i < 6; ++i) {
            key(Qt::Key_Period);
            QTest::qWait(1100); // or they would be one
            digests.push_back(digest());
        }
        for (int i = 0; i < 6; ++i)
            undo();
        QCOMPARE(digest(), digests[0]);
        for (int i = 0; i < 4; ++i)
            redo();
        undo();
        redo();
        QCOMPARE(digest(), digests[4]);
        document().goToEntry(tree().current() - 2);
        QCOMPARE(digest(), digests[2]);
    }

    void aProjectComesBackWithItsHistory()
    {
        key(Qt::Key_X);
        const Box box = document().content().box;
        click(Vec3(box.center().x(), box.center().y(), box.max().z()));
        settle();
        const std::uint64_t fixed = digest();
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.05, patience);
        const std::uint64_t revision = document().history().revision();
        std::optional<Project> project;
        document().whenSettled([&] { project = document().project(); }); // while it plays
        QTRY_VERIFY(project.has_value());
        QVERIFY(document().history().revision() > revision);
        QCOMPARE(project->entries.size(), std::size_t{4});
        QCOMPARE(project->starts.size(), std::size_t{2});
        key(Qt::Key_Space);
        project->entries[2].moment = nullptr; // as if it had been thinned

        show(m_services); // another window
        document().open(prepareProject(*project, m_services.packing, TaskControl::none()));
        settle();
        QCOMPARE(tree().records().size(), std::size_t{4});
        QVERIFY(presentName().startsWith("Simulate"));
        QCOMPARE(document().fixtures().list().at(0).faces.size(), std::size_t{1});
        undo();
        QCOMPARE(digest(), fixed);
        const std::size_t objects = snapshot().objects;
        undo();
        undo();
        settle();
        QCOMPARE(tree().current(), Entry{0});
        QVERIFY(snapshot().objects != objects); // a content that was not shown before
        QVERIFY(document().fixtures().list().empty());
        addBlock();
        settle();
        QCOMPARE(presentName(), QString("Add Block 1"));
    }

    void aClickInThePanelGoesThere()
    {
        auto* panel = find<QTreeWidget>("historyTree");
        find<QDockWidget>("historyDock")->raise();
        const auto itemOf = [&](Entry entry) -> QTreeWidgetItem* {
            for (QTreeWidgetItemIterator it(panel); *it != nullptr; ++it)
                if ((*it)->data(0, Qt::UserRole).toUInt() == entry)
                    return *it;
            return nullptr;
        };
        QTRY_VERIFY(itemOf(0) != nullptr);
        const auto clickItem = [&](Entry entry, int column = 0) {
            const QRect row = panel->visualItemRect(itemOf(entry));
            const int x = panel->columnViewportPosition(column) + (column == 0 ? row.left() + 40 : 8);
            QTest::mouseClick(panel->viewport(), Qt::LeftButton, {}, QPoint(x, row.center().y()));
        };
        addBlock();
        settle();
        const Entry withBlock = tree().current();
        const std::uint64_t blockDigest = digest();
        key(Qt::Key_G);
        settle();
        simulate(0.15);
        settle();
        const Entry simulated = tree().current();
        QTRY_VERIFY(itemOf(simulated) != nullptr && itemOf(simulated)->font(0).bold());
        clickItem(withBlock);
        settle();
        QCOMPARE(tree().current(), withBlock);
        QCOMPARE(digest(), blockDigest);
        QTRY_VERIFY(itemOf(withBlock)->font(0).bold() && !itemOf(simulated)->font(0).bold());

        // Something else begins a branch; what was done before moves aside.
        simulate(0.1);
        settle();
        QTRY_VERIFY(itemOf(tree().current()) != nullptr);
        QCOMPARE(itemOf(simulated)->parent(), itemOf(withBlock));
        QCOMPARE(itemOf(tree().current())->parent(), nullptr);
        clickItem(simulated);
        settle();
        QCOMPARE(tree().current(), simulated);

        clickItem(simulated, 1);
        QVERIFY(tree().record(simulated).isKey);
        panel->setCurrentItem(itemOf(simulated), 0);
        panel->setFocus();
        QTest::keyClick(panel, Qt::Key_F2);
        auto* editor = panel->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, "hanging down");
        picture("history");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(tree().record(simulated).name, std::string("hanging down"));
        QTRY_COMPARE(itemOf(simulated)->text(0), QString("hanging down"));
        QVERIFY(find<QLabel>("historyMemory")->text().endsWith(" kB"));
        auto* allowed = find<QSpinBox>("historyMemoryAllowed");
        allowed->setValue(100);
        QCOMPARE(document().history().memoryLimit(), std::size_t{100} << 20U);
        allowed->setValue(512);
        m_window->setTheme(Theme::Dark);
        QTest::qWait(200);
        picture("history-dark");
        m_window->setTheme(Theme::Light);
    }

    void anySequenceOfEditsComesBack_data()
    {
        QTest::addColumn<int>("seed");
        QTest::newRow("1") << 1;
        QTest::newRow("2") << 2;
    }
    void anySequenceOfEditsComesBack()
    {
        QFETCH(int, seed);
        fuzz::Random random(static_cast<std::uint64_t>(seed));
        std::map<Entry, std::uint64_t> digests{{tree().current(), digest()}};
        const Box box = document().content().box;
        int goings = 0;
        for (int i = 0; i < 60; ++i) {
            const std::size_t what = random.below(14);
            switch (what) {
            case 0:
                key(Qt::Key_B);
                break;
            case 1:
                key(Qt::Key_Delete);
                break;
            case 2:
                key(Qt::Key_G);
                break;
            case 3:
                document().toggleFace(0, static_cast<std::uint32_t>(random.below(6)));
                break;
            case 4:
                document().post(SetMaterial{0, {.youngsModulus = 1e5 * static_cast<double>(1 + random.below(9))}});
                break;
            case 5:
                key(Qt::Key_N);
                break;
            case 6:
                key(Qt::Key_Period);
                break;
            case 7:
            case 8:
                key(Qt::Key_Space);
                QTest::qWait(static_cast<int>(random.below(120)));
                key(Qt::Key_Space);
                break;
            case 9:
                if (random.below(4) == 0) {
                    m_window->refill(document().size() / static_cast<double>(8 + random.below(6)));
                    QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
                }
                break;
            case 10:
                document().goToEntry(static_cast<Entry>(random.below(tree().records().size())));
                ++goings;
                break;
            default:
                for (std::size_t times = 1 + random.below(3); times > 0; --times)
                    random.below(3) == 0 ? redo() : undo();
                ++goings;
            }
            if (random.below(3) == 0)
                continue; // at once something else
            const std::uint64_t now = digest();
            if (QTest::currentTestFailed())
                return;
            const auto [known, isNew] = digests.emplace(tree().current(), now);
            QVERIFY2(known->second == now,
                     qPrintable(QString("%1: entry %2, after %3").arg(i).arg(tree().current()).arg(what)));
        }
        for (const auto& [entry, before] : digests) {
            document().goToEntry(entry);
            QCOMPARE(digest(), before);
        }
        qInfo("%zu entries, %zu seen, %d goings, %zu bytes", tree().records().size(), digests.size(), goings,
              tree().memory());
    }

    void thinnedEntriesAreFoundAgainAndAGoingCanBeCancelled()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.3);
        const std::uint64_t first = digest();
        const Entry thinned = tree().current();
        document().post(SetGravity{Vec3(0, 0, 5)});
        settle();
        std::vector<HistoryRecord> records = tree().records();
        for (Entry entry = 1; entry < records.size(); ++entry)
            if (entry != tree().current())
                records[entry].moment = nullptr;
        Project project = document().project();
        project.entries = records;
        document().open(prepareProject(project, m_services.packing, TaskControl::none()));
        const std::uint64_t last = digest();
        undo();
        QVERIFY(m_window->tasks().isRunning());
        m_window->tasks().cancel();
        settle();
        QCOMPARE(digest(), last);
        QCOMPARE(tree().current(), project.current);
        QVERIFY(!tree().record(thinned).moment);
        undo();
        QVERIFY(m_window->tasks().isRunning());
        QCOMPARE(digest(), first);
        QCOMPARE(tree().current(), thinned);
        QVERIFY(tree().record(thinned).moment != nullptr);
    }

    void aHundredEntriesOfALargeBodyStayWithinMemoryWhileTheWindowAnswers()
    {
        m_window->refill(spacingOfObjects(27'000));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(snapshot().objects > 20'000);
        settle();
        constexpr std::size_t memory = std::size_t{48} << 20U;
        document().history().setMemory(memory);
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        QElapsedTimer clock;
        qint64 longest = 0;
        for (int i = 0; i < 100; ++i) {
            document().stepOnce();
            document().finishGesture();
            clock.start();
            QTest::qWait(10);
            longest = std::max(longest, clock.elapsed());
            QVERIFY(tree().memory() <= memory);
        }
        settle();
        QVERIFY(tree().records().size() >= 100);
        QVERIFY(tree().memory() <= memory);
        const std::uint64_t end = digest();
        for (int i = 0; i < 5; ++i)
            undo();
        settle();
        for (int i = 0; i < 5; ++i)
            redo();
        QCOMPARE(digest(), end);
        document().history().setMemory(History::defaultMemory);
        qInfo("%zu entries, %zu bytes, the window answered within %lld ms", tree().records().size(), tree().memory(),
              longest);
    }

    void theTimelineLooksBackAndBranches()
    {
        addBlock();
        key(Qt::Key_G);
        simulate(0.4);
        document().history().setKey(tree().current(), true);
        key(Qt::Key_G);
        simulate(0.4);
        const std::uint64_t end = digest();
        const Entry last = tree().current();
        auto* panel = find<TimelinePanel>("timelinePanel");
        auto* axis = find<TimelineAxis>("timelineAxis");
        auto* caption = find<QLabel>("pastCaption");
        QTRY_COMPARE(axis->timeline().ticks.back().entry, last);
        const Timeline line = axis->timeline();
        QVERIFY(line.pictures.size() > 10);
        QCOMPARE(line.end, present().time);
        QCOMPARE(line.present, line.end);

        // A drag looks back; nothing changes but the view.
        const Timeline::Picture& middle = line.pictures[line.pictures.size() / 3];
        const auto dragTo = [&](double at) {
            QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(line.present));
            QTest::mouseMove(axis, axis->placeOf(0.6 * line.end));
            QTest::mouseMove(axis, axis->placeOf(at));
        };
        dragTo(middle.at + 0.4 * Film::interval);
        QVERIFY(panel->isLookingBack() && caption->isVisible());
        QVERIFY(caption->text().startsWith("Looking back at "));
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at + 0.4 * Film::interval));
        QVERIFY(panel->isLookingBack());
        QCOMPARE(digest(), end);
        QCOMPARE(tree().current(), last);
        pictures("timeline");

        // The film plays to its end, at any rate.
        find<QComboBox>("filmRate")->setCurrentText("8x");
        QTest::mouseClick(find<QToolButton>("filmPlay"), Qt::LeftButton);
        QTRY_COMPARE(find<QLabel>("filmState")->text(), timeText(line.end) + " / " + timeText(line.end));
        QTest::mouseClick(find<QToolButton>("filmBack"), Qt::LeftButton);
        QVERIFY(panel->isLookingBack());
        QTest::mouseClick(find<QToolButton>("filmReturn"), Qt::LeftButton);
        QVERIFY(!panel->isLookingBack() && !caption->isVisible());

        // What one sees is where a branch begins.
        dragTo(middle.at + 0.4 * Film::interval);
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at + 0.4 * Film::interval));
        QTest::mouseClick(find<QToolButton>("filmBranch"), Qt::LeftButton);
        settle();
        QVERIFY(presentName().startsWith("Branch at "));
        QVERIFY(tree().current() != last && !panel->isLookingBack());
        QCOMPARE(present().step, middle.frame->step);
        QCOMPARE(present().time, middle.frame->time);
        for (std::size_t i = 0; i < snapshot().bodies[0].positions.size(); ++i)
            for (Eigen::Index axisIndex = 0; axisIndex < 3; ++axisIndex)
                QCOMPARE(static_cast<float>(snapshot().bodies[0].positions[i][axisIndex]),
                         middle.frame->objects[0][3 * i + static_cast<std::size_t>(axisIndex)]);
        QTRY_COMPARE(axis->timeline().end, middle.at);
        QCOMPARE(axis->timeline().pictures.back().frame, middle.frame);
        const std::uint64_t branch = digest();
        simulate(0.1);
        settle();
        undo();
        QCOMPARE(digest(), branch);

        // A tick of an entry goes there.
        document().goToEntry(last);
        QCOMPARE(digest(), end);
        QTRY_COMPARE(axis->timeline().end, line.end);
        const Timeline::Tick key =
            *std::find_if(line.ticks.begin(), line.ticks.end(), [](const Timeline::Tick& tick) { return tick.isKey; });
        dragTo(key.at);
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(key.at));
        settle();
        QVERIFY(tree().current() != last && present().time == tree().record(key.entry).time);
        QVERIFY(!panel->isLookingBack());
        dragTo(middle.at + 0.4 * Film::interval);
        QTest::keyClick(m_window.get(), Qt::Key_Space); // time goes on from the present
        QTRY_VERIFY(snapshot().playing);
        QVERIFY(!panel->isLookingBack());
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at));
    }

    void whatIsDoneOnTheWayHappensThere()
    {
        addBlock();
        settle();
        undo();
        key(Qt::Key_G); // before the simulation is there
        settle();
        QTRY_VERIFY(!snapshot().gravity.isZero());
        QVERIFY(snapshot().tools.empty());
        settle();
        QCOMPARE(presentName(), QString("Gravity on"));
        QCOMPARE(present().parent, Entry{1});
        QVERIFY(!action("redo")->isEnabled());
        document().goToEntry(2);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowHistoryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_history_test.moc"
