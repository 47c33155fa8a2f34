// What designers come for, from an empty window to the file, with mouse and keys.
#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/skin/fragments.h"
#include "support/story_on_test.h"
#include "ui/interaction/press_hand.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/panels/timeline_axis.h"
#include "ui/run_window.h"

#include <QInputDialog>
#include <QListWidget>
#include <QRegularExpression>
#include <QToolButton>
#include <QTreeWidget>

using namespace knead;

class WindowStoriesTest : public QObject, StoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepareStories();
    }

    void cleanup() { m_window.reset(); }

    /// The foot of a bracket is held, its arm is bent with a block and re-normalized, and STEP comes out.
    void aBracketIsBent()
    {
        beginStory("bracket");
        openByHand(example("bracket.step"));
        stage("open");
        key(Qt::Key_X);
        QVERIFY(action("fixFaces")->isChecked());
        click(at(45, 25, 8));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        stage("fixed");
        key(Qt::Key_X);
        key(Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        placeTool(0, at(32, 25, 45));
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        waitForView();
        stage("block");
        const std::size_t top = vertexAt(at(0, 25, 60));
        play();
        hold(Qt::Key_Left, [&] { return moveOf(top).x() < -12 * millimeter; });
        stage("bent");
        pause();
        key(Qt::Key_0);
        key(Qt::Key_Escape); // nothing selected: all bodies
        QTRY_COMPARE(document().selection().kind, Selection::Kind::None);
        const double bent = snapshot().energy.elastic;
        key(Qt::Key_N);
        QTRY_VERIFY(snapshot().energy.elastic < 1e-3 * bent);
        waitForGesture();
        play();
        hold(Qt::Key_Shift, [&, end = snapshot().time + 0.3] { return snapshot().time > end; });
        pause();
        QVERIFY(moveOf(top).x() < -8 * millimeter); // nothing springs back
        stage("re-normalized");
        exportByHand(file("arm.step"));
        stage("exported");
        const QString said = info(file("arm.step"));
        QVERIFY2(said.contains("2 parts (2 closed)"), qPrintable(said));
        QVERIFY2(said.contains("Bracket", Qt::CaseInsensitive), qPrintable(said));
        endStory();
    }

    /// Rubber springs back from a thumb; clay is tuned until the print stays, and kept under a name.
    void clayHoldsAThumbPrint()
    {
        beginStory("clay");
        openByHand(example("lump.step"));
        const Box box = document().content().box;
        const Vec3 middle = box.center();
        key(Qt::Key_7, Qt::ControlModifier); // from below
        waitForView();
        key(Qt::Key_X);
        click({middle.x(), middle.y(), box.min().z()});
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        key(Qt::Key_X);
        key(Qt::Key_0);
        addTool("ball");
        type("toolSizeX", "18 mm");
        type("toolForceLimit", "1 kN");
        type("toolSpeed", "15 mm/s");
        placeTool(0, {middle.x(), middle.y(), box.max().z() + 0.0095});
        key(Qt::Key_F);
        waitForView();
        stage("thumb");
        const auto [pressed, left] = print();
        QVERIFY(pressed > 2 * millimeter);
        QVERIFY2(left < 0.2 * pressed, qPrintable(QString("%1 of %2").arg(left).arg(pressed)));
        stage("rubber");

        key(Qt::Key_R, Qt::ControlModifier);
        QTRY_COMPARE(snapshot().time, 0.0);
        waitForGesture();
        click({box.min().x() + 0.25 * box.sizes().x(), box.min().y(), middle.z()}); // the lump, beside the ball
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Body);
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        type("yield_stress_pa", "8 kPa");
        QTRY_COMPARE(snapshot().materials[0].yieldStress, 8000.0);
        QTRY_COMPARE(find<QComboBox>("materialPreset")->currentIndex(), -1); // numbers of one's own
        stage("tuned");
        clickOn<QToolButton>("saveMaterial");
        answerName("Thumb clay");
        QTRY_COMPARE(find<QComboBox>("materialPreset")->currentText(), QString("Thumb clay"));
        choose("materialPreset", "Jel", "Jelly");
        QTRY_COMPARE(snapshot().materials[0].yieldStress, 0.0);
        choose("materialPreset", "Thumb", "Thumb clay");
        QTRY_COMPARE(snapshot().materials[0].yieldStress, 8000.0);
        stage("kept");

        click(tool(0).pose.position);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        const auto [deep, stays] = print();
        // More of it the longer the thumb stays, which goes by the machine.
        QVERIFY2(stays > 0.5 * deep, qPrintable(QString("%1 of %2").arg(stays).arg(deep)));
        QVERIFY(snapshot().energy.plastic > 0);
        stage("print");
        endStory();
    }

    /// A thumb goes so deep that the lump is filled anew on the way; looking back, undo and saving cross that, and the file has the
    /// faces that were opened.
    void clayIsKneadedThrough()
    {
        beginStory("knead");
        openByHand(example("lump.step"));
        const Box box = document().content().box;
        const Vec3 middle = box.center();
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        key(Qt::Key_7, Qt::ControlModifier); // from below
        waitForView();
        key(Qt::Key_X);
        click({middle.x(), middle.y(), box.min().z()});
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        key(Qt::Key_X);
        key(Qt::Key_0);
        addTool("ball");
        type("toolSizeX", "16 mm");
        type("toolForceLimit", "1 kN");
        type("toolSpeed", "60 mm/s");
        placeTool(0, {middle.x(), middle.y(), box.max().z() + 0.0085});
        key(Qt::Key_F);
        waitForView();
        const auto filling = [&] { return document().content().bodies[0]->aggregate; };
        const auto first = filling();
        const std::uint64_t before = hash();
        const auto goTo = [&](double height) {
            type("toolPositionZ", QString::number(height / millimeter) + " mm");
            waitUntil([&] { return std::abs(tool(0).pose.position.z() - height) < 1e-9; });
        };
        play();
        goTo(box.max().z() + 0.008 - 0.016);
        stage("pressed");
        QVERIFY(snapshot().refills > 0);
        QVERIFY(filling() != first && filling()->former != nullptr);
        goTo(box.max().z() + 0.0085);
        pause();
        stage("dented");
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
        const std::uint64_t dented = hash();
        auto* axis = find<TimelineAxis>("timelineAxis");
        const Timeline line = axis->timeline();
        QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(line.present));
        for (const double share : {0.7, 0.4, 0.1, 0.5}) {
            QTest::mouseMove(axis, axis->placeOf(share * line.present));
            drawn();
        }
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(0.5 * line.present));
        QTRY_VERIFY(view().isLookingBack());
        drawn();
        stage("looking-back");
        key(Qt::Key_Escape);
        QTRY_VERIFY(!view().isLookingBack());
        comeBack();
        const auto entry = [&] { return document().history().tree().current(); };
        const auto goThrough = [&](Qt::KeyboardModifiers undoOrRedo, std::uint64_t end) {
            for (int n = 0; n < 10 && hash() != end; ++n) {
                const auto seen = entry();
                key(Qt::Key_Z, undoOrRedo);
                QTRY_VERIFY_WITH_TIMEOUT(entry() != seen && document().isSettled(), patience);
            }
            QCOMPARE(hash(), end);
            QCOMPARE(document().fixtures().list().front().faces.size(), std::size_t{1});
        };
        goThrough(Qt::ControlModifier, before);
        QVERIFY(filling() == first);
        goThrough(Qt::ControlModifier | Qt::ShiftModifier, dented);
        QVERIFY(filling()->former != nullptr);
        answerFileDialog(file("dented.knead"));
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("dented.knead")) && isIdle(), patience);
        comeBack();
        QProcess replay;
        replay.start(KNEAD_PROGRAM, {"replay", file("dented.knead")});
        QVERIFY(replay.waitForFinished(patience));
        QVERIFY2(replay.exitCode() == 0, replay.readAllStandardError().constData());
        exportByHand(file("dented.step"));
        stage("exported");
        QFile written(file("dented.step"));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count("ADVANCED_FACE("), 18);
        newWindow(m_services);
        openByHand(file("dented.knead"));
        QCOMPARE(hash(), dented);
        QVERIFY(filling()->former != nullptr);
        stage("opened-again");
        endStory();
    }

    /// A grip of clay on the table gets the prints of a thumb, pressed where one clicks; the file has the seven faces that were opened.
    void aGripIsKneaded()
    {
        beginStory("grip");
        openByHand(example("grip.step"));
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        addTool("ball");
        type("toolSizeX", "20 mm");
        type("toolForceLimit", "8 N");
        type("toolSpeed", "80 mm/s");
        placeTool(0, at(60, 0, 60));
        stage("thumb");
        waitForGesture();
        key(Qt::Key_F5);
        QVERIFY(action("press")->isChecked());
        const std::size_t entries = document().history().tree().records().size();
        const double places[] = {25, 47, 69, 91};
        for (const double x : places) {
            const QPoint pixel = view().widgetPosition(at(x, -2, 25))->toPoint();
            QTest::mouseMove(&view(), pixel);
            QTest::mousePress(&view(), Qt::LeftButton, {}, pixel);
            QVERIFY(m_window->hands().pressing().isPressing());
            const double begin = snapshot().time;
            waitUntil([&] { return m_window->hands().pressing().force() > 0.95 * 8 || snapshot().time > begin + 1; });
            if (x == places[2])
                stage("pressed");
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel);
            QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing, patience);
            waitForGesture();
        }
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
        QCOMPARE(document().history().tree().records().size(), entries + std::size(places));
        key(Qt::Key_Escape);
        placeTool(0, at(91, -2, 45));
        stage("kneaded");
        double deepest = 0;
        for (const double x : places)
            deepest = std::max(deepest, -moveOf(vertexAt(at(x, 0, 25))).z());
        QVERIFY2(deepest > 3 * millimeter, qPrintable(QString::number(deepest)));
        endStory(); // the end of its export dialog, of 14 to 43 ms, is told apart
        exportByHand(file("grip.step"));
        stage("exported");
        QFile written(file("grip.step"));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count("ADVANCED_FACE("), 7);
    }

    /// A grip is shaped for a hand with brushes only: four fingers on both sides at once, a thumb on top, smoothed, and exported as the
    /// seven faces that were opened.
    void aGripIsShapedForAHand()
    {
        beginStory("sculpt");
        openByHand(example("grip.step"));
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        const std::size_t entries = document().history().tree().records().size();
        const SculptHand& hand = m_window->hands().sculpting();
        key(Qt::Key_T);
        key(Qt::Key_Y, Qt::ShiftModifier);
        QVERIFY(action("sculptThumb")->isChecked() && action("mirrorY")->isChecked());
        const auto highest = [this](double x, double y) {
            Vec3 place = at(x, y, -1000);
            for (const Vec3& vertex : document().content().bodies[0]->mesh.vertices)
                if ((vertex - at(x, y, 0)).head<2>().norm() < 3 * millimeter && vertex.z() > place.z())
                    place = vertex;
            return place;
        };
        const auto stroke = [&](const Vec3& from, const QPoint& way, double time) {
            const QPoint pixel = view().widgetPosition(from)->toPoint();
            QTest::mouseMove(&view(), pixel);
            QTest::mousePress(&view(), Qt::LeftButton, {}, pixel);
            QVERIFY(hand.isStroking());
            const double begin = snapshot().time;
            for (int step = 0; step < 6; ++step) {
                QTest::mouseMove(&view(), pixel + way * step / 6);
                waitUntil([&] { return snapshot().time > begin + time * (step + 1) / 6; });
            }
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel + way * 5 / 6);
            QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing, patience);
            waitForGesture();
        };
        for (const double x : {25.0, 47.0, 69.0, 91.0}) {
            stroke(highest(x, -12), {}, 0.4);
            if (x == 69.0)
                stage("fingers");
        }
        key(Qt::Key_Y, Qt::ShiftModifier);
        key(Qt::Key_S);
        stroke(highest(36, -6), QPoint(60, 20), 0.6);
        stage("smoothed");
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
        QVERIFY(snapshot().tools.empty() && snapshot().fixtures.empty());
        QCOMPARE(document().history().tree().records().size(), entries + 5);
        key(Qt::Key_Escape);
        endStory();
        exportByHand(file("shaped.step"));
        stage("exported");
        QFile written(file("shaped.step"));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count("ADVANCED_FACE("), 7);
    }

    /// Two wedges bite through a bar; both pieces go into the file.
    void aBarIsCutInTwo()
    {
        beginStory("cut");
        openByHand(example("bar.step"));
        const std::pair<const char*, const char*> brittle[] = {{"density_kg_m3", "1050 kg/m³"},
                                                               {"youngs_modulus_pa", "100 kPa"},
                                                               {"damping_ratio", "0.2"},
                                                               {"shape_damping_per_s", "20 1/s"},
                                                               {"friction", "0.3"},
                                                               {"tensile_strength_pa", "7 kPa"}};
        for (const auto& [field, text] : brittle)
            type(field, text);
        QTRY_COMPARE(snapshot().materials[0].tensileStrength, 7000.0);
        type("spacing", "5 mm");
        bring(find<QPushButton>("refill"), "refill");
        clickOn<QPushButton>("refill");
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && document().content().spacing == 0.005, patience);
        QCOMPARE(snapshot().materials[0].tensileStrength, 7000.0);
        addWedge(0, at(80.6, 10, 33.5));
        addWedge(1, at(80.6, 10, -13.5));
        turn(GizmoPart::turnX, "180");
        QTRY_VERIFY((tool(1).pose.rotation * Vec3::UnitZ() + Vec3::UnitZ()).norm() < 1e-9);
        stage("wedges");
        key(Qt::Key_F4);
        QVERIFY(action("driveByKeys")->isChecked());
        play();
        QTest::keyPress(&view(), Qt::Key_PageDown); // the upper one down
        QTest::keyPress(&view(), Qt::Key_E);        // and the lower one up
        // Into two halves; crumbs may break off beside them.
        const auto isCut = [&] {
            const Snapshot::BodyState body = snapshot().bodies[0];
            if (body.broken == nullptr)
                return false;
            const Pieces pieces = findPieces(*body.aggregate, *body.broken);
            std::vector<std::size_t> sizes(pieces.count, 0);
            for (const std::uint32_t piece : pieces.ofObject)
                ++sizes[piece];
            return std::ranges::count_if(sizes, [&](std::size_t size) { return 4 * size > body.aggregate->size(); }) ==
                   2;
        };
        waitUntil(isCut);
        QTest::keyRelease(&view(), Qt::Key_PageDown);
        QTest::keyRelease(&view(), Qt::Key_E);
        pause();
        stage("cut");
        key(Qt::Key_F4);
        key(Qt::Key_Escape);
        QVERIFY(isCut());
        stage("pieces");
        exportByHand(file("pieces.step"));
        stage("exported");
        const QString said = info(file("pieces.step"));
        static const QRegularExpression parts("(\\d+) parts \\((\\d+) closed\\)");
        const QRegularExpressionMatch match = parts.match(said);
        QVERIFY2(match.hasMatch() && match.captured(1).toInt() >= 2, qPrintable(said));
        QCOMPARE(match.captured(2), match.captured(1));
        QFile written(file("pieces.step"));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count("MANIFOLD_SOLID_BREP("), match.captured(1).toInt());
        endStory();
    }

    /// A knife goes through clay on a table: the pieces are seen at once, are whole again when that is undone, and have the faces of the
    /// bar in the file.
    void aKnifeCutsClay()
    {
        beginStory("knife");
        openByHand(example("bar.step"));
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].toughness > 0);
        QVERIFY(snapshot().floorHeight.has_value());
        addTool("knife");
        const std::pair<const char*, const char*> numbers[] = {
            {"toolSizeX", "50 mm"}, {"toolSizeY", "2 mm"}, {"toolSizeZ", "40 mm"}, {"toolSpeed", "40 mm/s"}};
        for (const auto& [field, text] : numbers)
            type(field, text);
        placeTool(0, at(80.6, 10, 41.5));
        key(Qt::Key_0);
        key(Qt::Key_F);
        waitForView();
        stage("knife");
        const auto shown = [&] { return document().content().bodies[0]; };
        const std::size_t faces = document().content().model->parts[0].faces.size();
        const auto opened = [&] { // triangles on the sides of cracks
            return std::ranges::count(shown()->mesh.faceOfTriangle, Fragment::crackFace);
        };
        play();
        hold(Qt::Key_PageDown, [&] { return tool(0).pose.position.z() < 29 * millimeter; });
        stage("half-way");
        pause();
        QCOMPARE(snapshot().components, std::size_t{1});
        QTRY_VERIFY(opened() > 0);
        const auto half = opened();
        QVERIFY(isWatertight(shown()->mesh));
        play();
        hold(Qt::Key_PageDown, [&] { return snapshot().components == 2; });
        stage("cut");
        pause();
        QTRY_VERIFY(opened() > half);
        QVERIFY(shown()->mesh.triangles.size() > shown()->whole->mesh.triangles.size());
        QCOMPARE(document().frame()->bodies[0]->places.size(), shown()->mesh.vertices.size());
        key(Qt::Key_Escape);
        stage("pieces");
        exportByHand(file("pieces.step"));
        stage("exported");
        QFile written(file("pieces.step"));
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray text = written.readAll();
        QCOMPARE(text.count("MANIFOLD_SOLID_BREP("), 2);
        QVERIFY2(static_cast<std::size_t>(text.count("ADVANCED_FACE(")) <= 2 * faces, "the pieces have flat faces");
        while (snapshot().components == 2 || shown()->whole != nullptr) {
            key(Qt::Key_Z, Qt::ControlModifier);
            QTRY_VERIFY(!document().isGoing());
            QTest::qWait(400); // a frame that lags is made once more
        }
        QCOMPARE(opened(), 0);
        stage("undone");
        endStory();
    }

    /// A bar that was pressed is measured and compared with what it was, and the report is written.
    void whatBecameOfABarIsReported()
    {
        beginStory("report");
        openByHand(example("bar.step"));
        key(Qt::Key_X);
        const std::size_t tip = vertexAt(at(160, 10, 20));
        click(at(10, 10, 20));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        key(Qt::Key_X);
        key(Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        placeTool(0, at(150, 10, 40));
        play();
        hold(Qt::Key_PageDown, [&] { return moveOf(tip).z() < -0.3 * millimeter; });
        pause();
        key(Qt::Key_Escape);
        key(Qt::Key_M);
        click(placeOf(vertexAt(at(0, 0, 20))));
        click(placeOf(vertexAt(at(160, 0, 20))));
        key(Qt::Key_Escape);
        QTRY_COMPARE(find<QTreeWidget>("measurements")->topLevelItemCount(), 1);
        stage("measured");
        key(Qt::Key_M, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("comparisonDialog") != nullptr, patience);
        drawn();
        stage("compared");
        answerFileDialog(file("report.pdf"));
        clickOn<QPushButton>("writeReport");
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("report.pdf")) && isIdle(), patience);
        QVERIFY(QFileInfo(file("report.pdf")).size() > 20'000);
        endStory();
    }

    /// The window is gone in the middle of work; another one recovers it, goes back and forth, and plays it again.
    void workComesBackAfterACrash()
    {
        beginStory("crash");
        openByHand(example("bracket.step"));
        pushOn();
        const std::uint64_t left = hash();
        const double seen = view().camera().viewHeight();
        newWindow(m_services);
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        drawn();
        stage("offered");
        clickOn<QPushButton>("recoveryRecover");
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        wait();
        QCOMPARE(hash(), left);
        QVERIFY(std::abs(view().camera().viewHeight() / seen - 1) < 0.01);
        stage("recovered");
        comeBack();
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hash() != left && document().isSettled(), patience);
        stage("undone");
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hash() == left && document().isSettled(), patience);
        pushOn(); // there is a film of what is simulated from now on
        auto* axis = find<TimelineAxis>("timelineAxis");
        const Timeline line = axis->timeline();
        QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(line.present));
        QTest::mouseMove(axis, axis->placeOf(line.present - 0.2));
        QTest::mouseMove(axis, axis->placeOf(line.present - 0.15));
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(line.present - 0.15));
        QTRY_VERIFY(view().isLookingBack());
        drawn();
        stage("looking-back");
        key(Qt::Key_Escape);
        QTRY_VERIFY(!view().isLookingBack());
        answerFileDialog(file("work.knead"));
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("work.knead")) && isIdle(), patience);
        QProcess replay;
        replay.start(KNEAD_PROGRAM, {"replay", file("work.knead")});
        QVERIFY(replay.waitForFinished(patience));
        QVERIFY2(replay.exitCode() == 0, replay.readAllStandardError().constData());
        endStory();
    }

private:
    struct Print {
        double pressed = 0; ///< how deep, under the tool [m]
        double left = 0;    ///< of it, when the tool is away
    };

    /// Presses the first tool 4 mm into the middle of the top and takes it away, by numbers that it goes to while time runs.
    Print print()
    {
        const Box box = document().content().box;
        const std::size_t under =
            vertexAt({box.center().x(), box.center().y(), box.max().z()}); // clay may get other objects
        const double away = tool(0).pose.position.z();
        const auto goTo = [&](double height) {
            type("toolPositionZ", QString::number(height / millimeter) + " mm");
            waitUntil([&] { return std::abs(tool(0).pose.position.z() - height) < 1e-9; });
        };
        Print print;
        play();
        goTo(box.max().z() + tool(0).size.z() / 2 - 4 * millimeter);
        print.pressed = -moveOf(under).z();
        stage("pressed");
        goTo(away);
        waitUntil([&, end = snapshot().time + 0.3] { return snapshot().time > end; });
        pause();
        print.left = -moveOf(under).z();
        return print;
    }

    /// All its numbers are typed one after the other, faster than the simulation shows them.
    void addWedge(std::size_t index, const Vec3& place)
    {
        addTool("wedge");
        const std::pair<const char*, const char*> numbers[] = {
            {"toolSizeX", "32 mm"}, {"toolSizeY", "24 mm"}, {"toolSizeZ", "26 mm"}, {"toolForceLimit", "1 kN"}};
        for (const auto& [field, text] : numbers)
            type(field, text);
        placeTool(index, place);
        QTRY_VERIFY((tool(index).size - at(32, 24, 26)).norm() < 1e-9);
        QCOMPARE(tool(index).forceLimit, 1000.0);
        key(Qt::Key_0);
        key(Qt::Key_F);
        waitForView();
        const Vec3 along = Vec3::UnitY();
        QTRY_VERIFY((tool(index).pose.rotation * Vec3::UnitX() - along).norm() < 1e-9);
    }

    void answerName(const QString& name)
    {
        QTRY_VERIFY(find<QInputDialog>("materialNameDialog") != nullptr);
        auto* edit = find<QInputDialog>("materialNameDialog")->findChild<QLineEdit*>();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, name);
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_VERIFY(find<QInputDialog>("materialNameDialog") == nullptr);
        comeBack();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    WatchedApplication application(argc, argv);
    WindowStoriesTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_stories_test.moc"
