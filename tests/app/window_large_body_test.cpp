// A body of 27,000 objects in the hands of a person: whatever is done to it, the window answers at once.
#include "core/aggregate/pieces.h"
#include "core/skin/fragments.h"
#include "support/history_on_test.h"
#include "support/story_on_test.h"
#include "ui/panels/display_panel.h"
#include "ui/project/thumbnails.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"

#include <QDialogButtonBox>
#include <QPushButton>

#include <algorithm>

using namespace knead;

class WindowLargeBodyTest : public QObject, StoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepareStories();
    }

    void cleanup() { m_window.reset(); }

    void theWindowAnswersAtOnce()
    {
        beginStory("large");
        openByHand(example("handle.step"));
        fill(27'000);
        stage("filled");
        push();
        seeInColors();
        seeWhatIsInside();
        measure();
        select();
        endStory();
    }

    /// What was done to it is taken back, recorded, exported, broken, saved, and opened again.
    void itAnswersWhileWorkIsKept()
    {
        beginStory("large-kept");
        openByHand(example("handle.step"));
        fill(27'000);
        push();
        waitSimulated(0.1);
        pause();
        renormalize();
        stage("re-normalized");
        goBackAndForth();
        record();
        exportStep("exported");
        breakApart();
        exportStep("exported-cracked");
        save();
        openFromFirstPage();
        goAcrossTheFilling();
        endStory();
    }

private:
    using Entry = History::Entry;

    Entry entry() { return document().history().tree().current(); }
    std::size_t objects() { return document().content().bodies[0]->aggregate->size(); }

    /// By the number of cells across.
    void fill(double wanted)
    {
        const double cells = find<QuantityField>("cellsAcross")->value();
        constexpr double growth = 2.7; // of objects by cells; those at the surface are cut
        const double share = std::pow(wanted / static_cast<double>(objects()), 1 / growth);
        type("cellsAcross", QString::number(cells * share));
        bring(find<QPushButton>("refill"), "refill");
        clickOn<QPushButton>("refill");
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && static_cast<double>(objects()) > 0.9 * wanted, patience);
        QVERIFY(static_cast<double>(objects()) < 1.1 * wanted);
        waitForView();
    }

    /// With a block from above, while colors are looked at and the tool is driven: until it is felt, and no further, since a handle
    /// of sponge that stands on its narrow end is soon squashed there.
    void push()
    {
        view().setFocus();
        key(Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        stage("block");
        play();
        hold(Qt::Key_PageDown, [&] { return tool(0).force.norm() > 0.5; });
        stage("pushed");
    }

    /// Time runs.
    void seeInColors()
    {
        const std::pair<const char*, const char*> quantities[] = {
            {"Disp", "Displacement"},  {"Str", "Strain"},        {"Von", "Von Mises stress"},
            {"Pla", "Plastic strain"}, {"Con", "Contact force"}, {"Dist", "Distance to the original"},
            {"Part", "Part colors"}};
        for (const auto& [letters, name] : quantities) {
            choose("colorQuantity", letters, name);
            waitSimulated(0.02);
            stage(QByteArray(name).replace(' ', '-').toLower());
        }
    }

    void seeWhatIsInside()
    {
        view().setFocus();
        const std::pair<Qt::Key, const char*> sights[] = {
            {Qt::Key_C, "connections"}, {Qt::Key_R, "original"}, {Qt::Key_B, "breaks"}, {Qt::Key_S, "section"}};
        for (const auto& [letter, name] : sights) {
            key(letter, Qt::ShiftModifier);
            waitSimulated(0.02);
            stage(name);
            key(letter, Qt::ShiftModifier);
            waitSimulated(0.005);
        }
        key(Qt::Key_O);
        waitSimulated(0.02);
        stage("objects");
        key(Qt::Key_O, Qt::ShiftModifier);
        waitSimulated(0.02);
        stage("inner-objects");
        key(Qt::Key_O, Qt::ShiftModifier);
        key(Qt::Key_O);
        key(Qt::Key_V, Qt::ShiftModifier);
        waitSimulated(0.02);
        stage("divider");
        key(Qt::Key_V, Qt::ShiftModifier);
        pause();
        stage("paused");
    }

    void measure()
    {
        key(Qt::Key_Escape);
        key(Qt::Key_M);
        click(seen(0.4));
        QTest::mouseMove(&view(), seen(0.5));
        click(seen(0.6));
        key(Qt::Key_Escape);
        stage("measured");
        key(Qt::Key_M, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("comparisonDialog") != nullptr, patience);
        drawn();
        stage("compared");
        auto* dialog = find<QDialog>("comparisonDialog");
        dialog->activateWindow();
        QTRY_VERIFY(dialog->isActiveWindow());
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Close), Qt::LeftButton);
        QTRY_VERIFY(find<QDialog>("comparisonDialog") == nullptr);
        comeBack();
    }

    /// Parts, faces, edges, objects and connections: clicked, in a box, through the part, and grown.
    void select()
    {
        const std::tuple<Qt::Key, Qt::KeyboardModifiers, const char*> levels[] = {
            {Qt::Key_1, Qt::NoModifier, "parts"},
            {Qt::Key_2, Qt::NoModifier, "faces"},
            {Qt::Key_3, Qt::NoModifier, "edges"},
            {Qt::Key_4, Qt::ControlModifier, "connections"},
            {Qt::Key_4, Qt::NoModifier, "objects"}};
        for (const auto& [level, modifiers, name] : levels) {
            key(level, modifiers);
            QTest::mouseMove(&view(), seen(0.5));
            QTest::qWait(50);
            QTest::mouseClick(&view(), Qt::LeftButton, {}, seen(0.5));
            dragBox();
            drawn();
            stage(name);
        }
        QVERIFY(document().selected().region().level == Level::Object);
        key(Qt::Key_X, Qt::AltModifier);
        dragBox();
        stage("objects-through");
        key(Qt::Key_X, Qt::AltModifier);
        key(Qt::Key_D, Qt::ControlModifier);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        drawn();
        stage("objects-within");
        view().setFocus();
        key(Qt::Key_N, Qt::ShiftModifier);
        waitForGesture();
        stage("renormalized");
        key(Qt::Key_Escape);
        key(Qt::Key_1);
    }

    /// Nothing moves by it, but everything is at rest.
    void renormalize()
    {
        key(Qt::Key_Escape);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::None);
        const double pushed = snapshot().energy.elastic;
        key(Qt::Key_N);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().energy.elastic < 1e-3 * pushed, patience);
        waitForGesture();
    }

    void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    void waitFor(Entry wanted)
    {
        QTRY_VERIFY_WITH_TIMEOUT(entry() == wanted && document().isSettled() && isIdle(), patience);
    }

    /// Entry by entry to the first filling and back, and all the way in one go.
    void goBackAndForth()
    {
        const Entry last = entry();
        QVERIFY(last >= 4);
        std::vector<std::uint64_t> seen{digestOf(snapshot())};
        while (entry() > 0) {
            const Entry before = entry() - 1;
            undo();
            waitFor(before);
            seen.push_back(digestOf(snapshot()));
            QVERIFY(seen.back() != seen[seen.size() - 2]);
        }
        QVERIFY(objects() < 10'000); // as it was opened
        stage("undone");
        while (entry() < last) {
            const Entry after = entry() + 1;
            redo();
            waitFor(after);
            QCOMPARE(digestOf(snapshot()), seen[last - after]);
        }
        stage("redone");
        for (Entry i = 0; i < last; ++i)
            undo();
        waitFor(0);
        QCOMPARE(digestOf(snapshot()), seen.back());
        for (Entry i = 0; i < last; ++i)
            redo();
        waitFor(last);
        QCOMPARE(digestOf(snapshot()), seen.front());
        stage("there-and-back");
    }

    /// All that was simulated.
    void record()
    {
        answerFileDialog(file("pictures"));
        command("Record pictures");
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("recordSave") != nullptr, patience);
        clickOn<QPushButton>("recordSave");
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("pictures")) && isIdle(), patience);
        QVERIFY(QDir(file("pictures")).entryList({"*.png"}).size() > 3);
        comeBack();
        stage("recorded");
    }

    void exportStep(const char* what)
    {
        const QString name = file(what) + ".step";
        exportByHand(name);
        stage(what);
        const QString said = info(name);
        const QString parts = QString("%1 parts (%1 closed)").arg(piecesToWrite());
        QVERIFY2(said.contains(parts), qPrintable(said));
    }

    /// Those that are large enough to have a shape of their own, see FragmentOptions.
    std::size_t piecesToWrite()
    {
        std::size_t count = 0;
        for (const Snapshot::BodyState& body : snapshot().bodies) {
            const Pieces pieces =
                findPieces(*body.aggregate, body.broken ? *body.broken : std::vector<BrokenConnection>());
            std::vector<std::size_t> sizes(pieces.count);
            for (const std::uint32_t piece : pieces.ofObject)
                ++sizes[piece];
            count += static_cast<std::size_t>(
                std::ranges::count_if(sizes, [](std::size_t size) { return size >= FragmentOptions{}.leastObjects; }));
        }
        return count;
    }

    /// Connections break while they and the marks of broken ones are looked at. That is undone and redone as well.
    void breakApart()
    {
        key(Qt::Key_1);
        click(seen(0.5));
        QTRY_VERIFY(find<QWidget>("tensile_strength_pa") != nullptr);
        type("tensile_strength_pa", "500 Pa");
        QTRY_COMPARE(snapshot().materials[0].tensileStrength, 500.0);
        command("semi-implicit"); // in whose steps more break than in one of a frame
        QTRY_COMPARE(snapshot().wantedIntegrator, Integrator::semiImplicitEuler);
        waitForGesture();
        const std::uint64_t whole = digestOf(snapshot());
        const Entry before = entry();
        view().setFocus();
        key(Qt::Key_B, Qt::ShiftModifier);
        WindowOnTest::click(tool(0).pose.position);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        play();
        hold(Qt::Key_PageDown, [&] { return snapshot().broken > 100; });
        stage("breaking");
        key(Qt::Key_C, Qt::ShiftModifier);
        waitUntil([&, most = snapshot().broken + 100] { return snapshot().broken > most; });
        stage("breaking-connections");
        key(Qt::Key_C, Qt::ShiftModifier);
        pause();
        stage("broken");
        const std::uint64_t broken = digestOf(snapshot());
        const Entry after = entry();
        QVERIFY(after > before);
        for (Entry i = before; i < after; ++i)
            undo();
        waitFor(before);
        QCOMPARE(snapshot().broken, std::size_t{0});
        QCOMPARE(digestOf(snapshot()), whole);
        stage("unbroken");
        for (Entry i = before; i < after; ++i)
            redo();
        waitFor(after);
        QCOMPARE(digestOf(snapshot()), broken);
    }

    void save()
    {
        answerFileDialog(file("large.knead"));
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("large.knead")) && isIdle() && !projects().isModified(), patience);
        comeBack();
        stage("saved");
    }

    /// By its picture.
    void openFromFirstPage()
    {
        const std::uint64_t saved = digestOf(snapshot());
        QTRY_VERIFY(!thumbnails::of(file("large.knead")).isNull());
        newWindow(m_services);
        QTRY_VERIFY(find<QPushButton>("recent_large.knead") != nullptr);
        stage("first-page");
        clickOn<QPushButton>("recent_large.knead");
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty() && isIdle(), patience);
        waitForView();
        comeBack();
        QCOMPARE(digestOf(snapshot()), saved);
        stage("opened-again");
    }

    /// Back to the first filling, and to the large one, which has to be filled again where a project was opened: with progress,
    /// and cancelled at first.
    void goAcrossTheFilling()
    {
        for (Entry left = entry(); left > 0; --left)
            undo();
        waitFor(0);
        QVERIFY(objects() < 10'000);
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!projects().isModified() && isIdle(), patience);
        const Entry afterFilling = 1;
        const std::uint64_t before = document().history().documentNumber();
        openByHand(file("large.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(document().history().documentNumber() != before && isIdle(), patience);
        QCOMPARE(entry(), Entry(0));
        comeBack(); // the dialog may have gone after its file was there
        redo();
        QVERIFY(m_window->tasks().isRunning());
        key(Qt::Key_Escape);
        waitFor(0);
        QVERIFY(objects() < 10'000);
        stage("stayed");
        redo();
        waitFor(afterFilling);
        QVERIFY(objects() > 20'000);
        stage("filled-again");
    }

    void waitSimulated(double time)
    {
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().playing || !snapshot().health.ok, patience);
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
        const double end = snapshot().time + time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > end, patience);
    }

    /// A place on the part, where the view shows it.
    QPoint seen(double share)
    {
        const Box box = document().content().box;
        const Vec3 place = box.min() + share * box.sizes();
        return view().widgetPosition(place)->toPoint();
    }
    void click(const QPoint& place)
    {
        QTest::mouseMove(&view(), place);
        QTest::qWait(50);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, place);
    }

    /// From beside the part to its middle, so that the press takes nothing.
    void dragBox()
    {
        const QPoint from(view().width() / 6, view().height() / 6);
        const QPoint to(view().width() * 3 / 4, view().height() * 3 / 4);
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 8; ++i) {
            QTest::mouseMove(&view(), from + (to - from) * i / 8);
            QTest::qWait(20);
        }
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    WatchedApplication application(argc, argv);
    WindowLargeBodyTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_large_body_test.moc"
