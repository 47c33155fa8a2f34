// What a person can do wrong while working with a part: each gets a sentence, and loses nothing.
#include "io/project/recovery.h"
#include "support/errors_on_test.h"
#include "support/sample_project.h"
#include "ui/interaction/hands.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"

#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include <atomic>
#include <cmath>
#include <new>

using namespace knead;

class WindowWorkErrorsTest : public QObject, ErrorsOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { begin(); }
    void cleanup() { end(); }

    // --- what goes on, and what is not there yet -------------------------------------------------------------------------

    void oneThingIsDoneAtATime()
    {
        openWithBlock();
        remember();
        hold();
        m_window->features().exports->exportTo(m_folder->filePath("part.stl"));
        verifySaid("is still going on", true);
        m_window->banner().hide();
        m_window->open(QStringList(example("plate.step")));
        verifySaid("is still going on", true);
        m_window->banner().hide();
        m_window->projects().saveTo(m_folder->filePath("part.knead"));
        verifySaid("save again", true);
        m_window->banner().hide();
        m_window->open(QStringList(example("bend-bar.recipe.json")));
        verifySaid("is still going on", true);
        letGo();
        QVERIFY(QDir(m_folder->path()).isEmpty());
        verifyNothingLost();
    }

    void recoveringWaitsForWhatGoesOn()
    {
        RecoveryFile(recoveryFolder()).begin(sample::project(), {}); // as a crash leaves it
        const std::size_t left = findRecoveries().size();
        QVERIFY(left > 0);
        hold();
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        QTest::mouseClick(find<QPushButton>("recoveryRecover"), Qt::LeftButton);
        verifySaid("Waiting is still going on: wait for it, or cancel it with Esc.", true);
        letGo();
        QVERIFY(document().isEmpty());
        QTRY_COMPARE(findRecoveries().size(), left); // the window looks for what waits at the same time
    }

    void aBranchWaitsForWhatGoesOn()
    {
        openWithBlock();
        simulate(0.3);
        settle();
        QTRY_VERIFY(action("filmBack")->isEnabled());
        for (int i = 0; i < 4; ++i)
            QTest::mouseClick(find<QToolButton>("filmBack"), Qt::LeftButton);
        QTRY_VERIFY(action("filmBranch")->isEnabled());
        remember();
        hold();
        QTest::mouseClick(find<QToolButton>("filmBranch"), Qt::LeftButton);
        verifySaid("cancel it with Esc, then branch again", true);
        letGo();
        verifyNothingLost();
    }

    /// Where the last moment has to be found by repeating what was done, which is a task of its own.
    void aFarJourneyWaitsForWhatGoesOn()
    {
        openWithBlock();
        Project project = document().project();
        const Entry before = project.entries[project.current].parent;
        project.entries[before].moment = nullptr; // as when the memory for undo is full
        document().open(prepareProject(std::move(project), m_services.packing, TaskControl::none()));
        remember();
        hold();
        undo();
        verifySaid("Waiting is still going on: wait for it, or cancel it with Esc, then go to ", true);
        letGo();
        verifyNothingLost();
        undo();
        settle();
        QCOMPARE(tree().current(), before);
        QVERIFY(snapshot().tools.empty());
    }

    void aMomentThatFindsNoMemoryIsNotGoneTo()
    {
        std::atomic<bool> isMemoryFull = false;
        Services services = m_services;
        services.packing.unpack = [&isMemoryFull, unpack = m_services.packing.unpack](std::span<const std::byte> packed,
                                                                                      std::size_t size) {
            if (isMemoryFull)
                throw std::bad_alloc();
            return unpack(packed, size);
        };
        show(services);
        openWithBlock();
        remember();
        isMemoryFull = true;
        undo();
        verifySaid("There is not enough memory to go to ");
        isMemoryFull = false;
        verifyNothingLost();
        undo();
        settle();
        QVERIFY(snapshot().tools.empty());
        m_window.reset(); // before what its services use
    }

    void thereMayBeNothingToRecordOrWrite()
    {
        openWithBlock();
        remember();
        action("recordVideo")->trigger();
        verifySaid("nothing to record yet");
        m_window->features().hands->exportForces(m_folder->filePath("forces.csv"));
        verifySaid("no forces to write yet");
        verifyNothingLost();
    }

    // --- numbers and names ----------------------------------------------------------------------------------------------

    void numbersThatAreNoneAndNumbersOutOfRange()
    {
        openWithBlock();
        document().select({Selection::Kind::Body, 0});
        remember();
        auto* field = find<QuantityField>("poisson_ratio");
        QVERIFY(field != nullptr);
        const double before = field->value();
        type(field, "soft");
        QVERIFY(field->hasProblem() && field->toolTip().contains("is not a number here"));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!field->hasProblem());
        type(field, "7");
        QVERIFY(field->hasProblem() && field->toolTip().startsWith("Allowed is "));
        picture("field-out-of-range");
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->value(), before);
        verifyNothingLost();
    }

    void namesThatAreTaken()
    {
        openWithBlock();
        addBall();
        remember();
        renameLine("Ball 1", "Block 1");
        verifySaid("Something is called \"Block 1\" already");
        Region face;
        face.add(0, 0);
        face.level = Level::Face;
        QVERIFY(document().keepSet("Top", face) && document().keepSet("Side", face));
        renameLine("Side", "Top");
        verifySaid("There is a selection called \"Top\" already");
        QCOMPARE(document().notes().sets().size(), std::size_t{2});
        verifyNothingLost();
    }

    void selectionsNeedANameToBeKept()
    {
        openWithBlock();
        key(Qt::Key_2); // faces
        rest();
        click(towardsEye());
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Region);
        remember();
        auto* name = find<QLineEdit>("setName");
        QTRY_VERIFY(name->isVisible());
        name->setFocus();
        name->selectAll();
        QTest::keyClick(name, Qt::Key_Space);
        QTest::keyClick(name, Qt::Key_Return);
        verifySaid("A selection needs a name: type one, then save it.");
        QVERIFY(document().notes().sets().empty());
        verifyNothingLost();
    }

    void aSpacingThatIsTooFineIsNotFilled()
    {
        openWithBlock();
        document().select({Selection::Kind::Body, 0});
        remember();
        type(find<QuantityField>("spacing"), "0.01 mm");
        QTest::mouseClick(find<QPushButton>("refill"), Qt::LeftButton);
        verifySaid("Choose a larger spacing");
        verifyNothingLost();
    }

    /// Of several parts the others are filled; what is only shown from then on is named.
    void aPartThatIsTooSmallForTheSpacingIsNamed()
    {
        openExample("bracket.step", 16);
        settle();
        const std::size_t bodies = document().content().bodies.size();
        QCOMPARE(bodies, std::size_t{2});
        m_window->features().imports->refill(document().size() / 2);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
        verifySaid("\"Bushing\" is not simulated: ");
        verifySaid("Choose a smaller spacing");
        settle(); // the filling is an entry of the history before it is undone
        undo();
        QTRY_COMPARE_WITH_TIMEOUT(document().content().bodies.size(), bodies, patience);
        settle();
        remember();
        m_window->features().imports->refill(document().size()); // and here no part is left
        verifySaid("Choose a smaller spacing");
        verifyNothingLost();
    }

    void whatIsLockedIsNotChanged()
    {
        openWithBlock();
        const Selection block{Selection::Kind::Tool, snapshot().tools[0].id};
        document().select(block);
        document().setLocked(block, true);
        remember();
        QTest::keyClick(m_window.get(), Qt::Key_Delete);
        verifySaid("is locked in the model tree");
        verifyNothingLost();
    }

    // --- hands, selections, measuring -----------------------------------------------------------------------------------

    void onlyMaterialThatDeformsIsPulled()
    {
        openWithBlock();
        document().post(SetBodyKind{0, BodyKind::rigid});
        QTRY_VERIFY(snapshot().bodies[0].kind == BodyKind::rigid);
        settle();
        remember();
        QTest::keyClick(m_window.get(), Qt::Key_F6);
        pressOnPart();
        verifySaid("does not deform");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        verifyNothingLost();
    }

    void whatIsHeldIsNotPulled()
    {
        openWithBlock();
        Region all = regionOf(Level::Part, 0, {0});
        document().fixRegion(all);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        settle();
        remember();
        QTest::keyClick(m_window.get(), Qt::Key_F6);
        pressOnPart();
        verifySaid("is held at this place");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        verifyNothingLost();
    }

    void placesBesideThePartAndMeshesHaveNothingToMeasure()
    {
        writeCube("cube.stl", 1);
        m_window->open(QStringList(m_folder->filePath("cube.stl")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !document().isEmpty(), patience);
        rest();
        settle();
        remember();
        ViewportWidget& view = m_window->viewport();
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(6, view.height() - 6));
        verifySaid("There is nothing at that place");
        action("measureRadiusOfFace")->setChecked(true);
        click(towardsEye());
        verifySaid("This part is a mesh without CAD faces");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QTest::keyClick(m_window.get(), Qt::Key_X);
        click(towardsEye());
        verifySaid("is a mesh without CAD faces: open it as STEP");
        verifyNothingLost();
    }

    void facesThatHoldNothing()
    {
        openExample("bracket.step", 2);
        settle();
        m_window->banner().hide(); // the bushing does not suit the spacing
        const auto faces = static_cast<std::uint32_t>(document().content().model->parts[0].faces.size());
        std::uint32_t next = 0;
        for (; next < faces && m_window->banner().sentence().isEmpty(); ++next)
            document().setMaterialOf(regionOf(Level::Face, 0, {next}), {.youngsModulus = 1e6}, {});
        verifySaid("The selection holds no objects");
        m_window->banner().hide();
        document().toggleFace(0, next - 1); // the one that was said to hold none
        verifySaid("holds no objects: its faces are smaller than the spacing");
        QVERIFY(!document().fixtures().list().empty());
    }

    void connectionsOfAnotherFilling()
    {
        openWithBlock();
        Region some = regionOf(Level::Connection, 0, {connectionItem({0, 0})});
        QVERIFY(document().keepSet("Joints", some));
        m_window->features().imports->refill(document().size() / 7);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        settle();
        remember();
        clickLine("Joints");
        verifySaid("names edges or connections of another filling");
        verifyNothingLost();
        QCOMPARE(document().notes().sets().size(), std::size_t{1});
    }

    // --- what cannot be done now -----------------------------------------------------------------------------------------

    void thePaletteSaysWhyNot()
    {
        verifyWhyNot("fit", "Open a part first.");
        QCOMPARE(action("fit")->statusTip(), QString("Open a part first.")); // for the status bar
        openBarHere();
        QVERIFY(action("fit")->isEnabled() && action("fit")->statusTip().isEmpty());
        verifyWhyNot("redo", "There is nothing to redo.");
        document().selected().select({});
        document().select({});
        verifyWhyNot("remove", "Select a tool or a fixture first.");
        verifyWhyNot("fix selection", "Select something first.");
        verifyWhyNot("color map gray", "Color the skin by a quantity first.");
        verifyWhyNot("play the film", "Simulate something first, and look back at it.");
        verifyWhyNot("next view", "Show two or four views first.");
        action("play")->trigger();
        QTRY_VERIFY(snapshot().playing);
        QTRY_VERIFY(!action("step")->isEnabled());
        verifyWhyNot("step", "Pause first.");
        action("play")->trigger();
    }

    /// In every state of the window: whatever is gray has a reason of its own.
    void whateverIsGraySaysWhy()
    {
        QStringList silent;
        const auto look = [&](const char* state) {
            key(Qt::Key_K, Qt::ControlModifier);
            auto* list = find<QListWidget>("paletteList");
            QTRY_VERIFY(list->isVisible());
            for (int row = 0; row < list->count(); ++row)
                for (int role = Qt::UserRole; role < Qt::UserRole + 4; ++role)
                    if (list->item(row)->data(role).toString() == "Not possible now.")
                        silent << QString("%1: %2").arg(state, list->item(row)->data(Qt::DisplayRole).toString());
            QTest::keyClick(find<QLineEdit>("paletteField"), Qt::Key_Escape);
        };
        look("nothing is open");
        openWithBlock();
        look("a tool is selected");
        document().select({});
        look("nothing is selected");
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        look("time runs");
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join('\n')));
    }

private:
    void addBall()
    {
        action("addBall")->trigger();
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{2});
        settle();
    }

    /// A place of the part that is seen from the eye, and nothing is in front of it.
    Vec3 towardsEye()
    {
        ViewportWidget& view = m_window->viewport();
        for (const Vec3& vertex : document().frame()->bodies[0]->places) {
            const Vec3 inwards = vertex + 0.2 * (document().content().box.center() - vertex);
            const QPointF seen = *view.widgetPosition(inwards);
            const PickHit hit = view.hitAt(seen);
            if (hit.kind == PickHit::Kind::Body)
                return inwards;
        }
        return document().content().box.center();
    }

    void pressOnPart()
    {
        rest();
        const QPoint place = m_window->viewport().widgetPosition(towardsEye())->toPoint();
        QTest::mouseMove(&m_window->viewport(), place);
        QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, place);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowWorkErrorsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_work_errors_test.moc"
