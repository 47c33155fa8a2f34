#include "support/history_on_test.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QtTest>

#include <algorithm>
#include <semaphore>

using namespace knead;

namespace {

/// A fixture comes before the first step.
class FixesSomething final : public ScriptedEvents {
public:
    bool carryOutDue(Simulation& simulation) override
    {
        simulation.applyCommands();
        if (simulation.stepCount() == 0)
            simulation.post(AddFixture{{"by recipe", 0, {0, 1, 2}}});
        return false;
    }
    void ended(const Gesture&) override {}
    void wentTo(const Moment&, std::uint64_t) override {}
};

} // namespace

/// Undo and redo as a person uses them.
class WindowHistoryTest : public QObject, HistoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { openRefilledBar(); }
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

    void fillingsThatWereLeftTakeNoMemory()
    {
        const auto spacingOf = [this] { return document().content().request.spacing; };
        const std::optional<SpacingChoice> first = spacingOf();
        const Entry firstEntry = tree().current();
        const std::uint64_t before = digest();
        std::vector<std::weak_ptr<const FilledModel>> contents;
        for (const double cells : {6.0, 7.0, 8.0, 9.0}) {
            m_window->features().imports->refill(document().size() / cells);
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
            settle();
            contents.push_back(document().history().starts().back().content);
        }
        const auto isGone = [](const std::weak_ptr<const FilledModel>& content) { return content.expired(); };
        QTRY_COMPARE(std::count_if(contents.begin(), contents.end(), isGone), 2);
        QVERIFY(!isGone(contents[2]) && !isGone(contents[3])); // undo is quick
        document().goToEntry(firstEntry);
        QCOMPARE(digest(), before);
        QVERIFY(first && spacingOf() && spacingOf()->kind == first->kind && spacingOf()->value == first->value);
        const Project project = document().project();
        document().open(prepareProject(project, m_services.packing, TaskControl::none()));
        document().goToEntry(firstEntry + 2);
        settle();
        QCOMPARE(spacingOf()->value, document().content().spacing);
        QVERIFY(spacingOf()->value != first->value);
    }

    void whatIsDoneWhileItIsFilledIsInTheNewFilling()
    {
        const double spacing = document().size() / 9;
        m_window->features().imports->refill(spacing);
        key(Qt::Key_B);
        QVERIFY(m_window->tasks().isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(document().content().spacing, spacing, patience);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QVERIFY2(presentName().startsWith("Refill "), qPrintable(presentName()));
        QVERIFY(!m_window->tasks().isRunning());
        verifyStraightRun();
    }

    void undoAndResetHoldInTheFillingThatIsUnderWay()
    {
        addBlock();
        settle();
        const auto height = [this] { return snapshot().tools[0].pose.position.z(); };
        const double added = height();
        for (const bool resets : {false, true}) {
            document().select({Selection::Kind::Tool, snapshot().tools[0].id}); // no longer in a new filling
            key(Qt::Key_Space);
            QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
            QTRY_VERIFY_WITH_TIMEOUT(height() < added, patience);
            QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
            key(Qt::Key_Space);
            settle();
            QVERIFY(height() < added);
            const double spacing = document().content().spacing * 1.1;
            m_window->features().imports->refill(spacing);
            resets ? key(Qt::Key_R, Qt::ControlModifier) : undo();
            QTRY_COMPARE_WITH_TIMEOUT(document().content().spacing, spacing, patience);
            settle();
            QCOMPARE(height(), added);
        }
        verifyStraightRun();
    }

    void stepsAfterAnUndoBeginWhereItLeads()
    {
        addBlock();
        const auto height = [this] { return snapshot().tools[0].pose.position.z(); };
        const double added = height();
        QTest::keyClick(&m_window->viewport(), Qt::Key_PageDown);
        settle();
        const double step = added - height();
        QVERIFY(step > 0);
        undo();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&m_window->viewport(), Qt::Key_PageUp);
        settle();
        QVERIFY2(std::abs(height() - added - 3 * step) < 1e-12, qPrintable(QString::number((height() - added) / step)));
    }

    /// Time was begun and stopped before a step: what was ahead stays there.
    void whatComesToNothingLeavesRedo()
    {
        addBlock();
        settle();
        undo();
        settle();
        const std::size_t entries = tree().records().size();
        std::binary_semaphore isStopped(0); // the simulation goes on when time was begun and stopped
        document().lookAtGesture([&](const auto&, auto) { isStopped.acquire(); });
        document().play();
        const bool isAheadMeanwhile = action("redo")->isEnabled();
        document().pause();
        isStopped.release();
        settle();
        QVERIFY(!isAheadMeanwhile);
        QCOMPARE(tree().records().size(), entries);
        QVERIFY(action("redo")->isEnabled());
    }

    void oneStepsRightAfterAPause()
    {
        const double end = snapshot().time + 0.1;
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time >= end, patience);
        QVERIFY(!action("step")->isEnabled());
        key(Qt::Key_Space);
        key(Qt::Key_Period);
        settle();
        QCOMPARE(present().step, tree().record(present().parent).step + 1);
    }

    void aFaceThatIsFreedWhileARecipeFixesAnotherIsTheOneMeant()
    {
        PreparedModel prepared =
            prepareRefill(document().content(), document().content().spacing, snapshot(), {}, TaskControl::none());
        prepared.script = [] { return std::make_unique<FixesSomething>(); };
        m_window->projects().open(std::move(prepared));
        settle();
        document().stepOnce(); // by which the recipe fixes something, as the window does not know yet
        document().toggleFace(0, 1);
        document().toggleFace(0, 1);
        settle();
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        QCOMPARE(snapshot().fixtures[0].name, std::string("by recipe"));
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        QCOMPARE(document().fixtures().list()[0].id, std::optional<FixtureId>(0));
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
        document().stepOnce();
        settle();
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
        rest();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        ViewportWidget& view = m_window->viewport();
        QPointF seen; // until the view has turned
        QTRY_VERIFY(std::exchange(seen, *view.widgetPosition(snapshot().tools[0].pose.position)) ==
                    *view.widgetPosition(snapshot().tools[0].pose.position));
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
        const double z = snapshot().tools[0].pose.position.z();
        QTest::keyClick(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY(snapshot().tools[0].pose.position.z() < z);
        const double step = z - snapshot().tools[0].pose.position.z();
        for (int i = 1; i < 5; ++i) // faster than frames that show them
            QTest::keyClick(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY(std::abs(z - snapshot().tools[0].pose.position.z() - 5 * step) < 1e-12);
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
        const double played = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > played + 0.1, patience);
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
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowHistoryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_history_test.moc"
