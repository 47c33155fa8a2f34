#include "support/window_on_test.h"
#include "ui/panels/quantity_field.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>

using namespace knead;

/// Tools and materials as a person changes them in the window.
class WindowPanelsTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }

    void cleanup() { m_window.reset(); }

    /// Literature is for who asks; the numbers come first.
    void whereNumbersComeFromIsToldToWhoAsks()
    {
        openExample("bar.step");
        auto* button = find<QToolButton>("materialWhence");
        QVERIFY(button->isVisible() && !find<QLabel>("materialSource")->isVisible());
        button->click();
        QVERIFY(find<QLabel>("materialSource")->isVisible());
        QVERIFY(find<QLabel>("materialSource")->text().contains("rubber", Qt::CaseInsensitive) ||
                find<QLabel>("materialSource")->text().contains("sponge", Qt::CaseInsensitive));
        button->click();
        QVERIFY(!find<QLabel>("materialSource")->isVisible());
    }

    /// A knife lies across the part, is seen whole, and its numbers come forward; the status line says what makes it cut.
    void aNewKnifeIsReadyToCut()
    {
        openExample("bar.step"); // along x
        find<QDockWidget>("displayDock")->raise();
        action("addKnife")->trigger();
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        const ToolState knife = snapshot().tools[0];
        const Vec3 edge = knife.pose.rotation * Vec3::UnitX();
        QVERIFY2(std::abs(edge.y()) > 1 - 1e-9, "it does not lie across the bar");
        QVERIFY(knife.size.x() > document().content().box.sizes().y());
        QTRY_VERIFY(find<QuantityField>("toolSizeX")->isVisible());
        QVERIFY(m_window->viewport().showsAll());
        QTRY_VERIFY(find<QLabel>("navigationHint")->text().contains("Space: play"));
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(find<QLabel>("navigationHint")->text().contains("PgDn: drive"));
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
    }

    void everyFormOfToolsCanBeAddedAndStaysWhatItIs()
    {
        openExample("bracket.step");
        const std::pair<const char*, ToolKind> forms[] = {{"addBlock", ToolKind::box},
                                                          {"addBall", ToolKind::ball},
                                                          {"addCylinder", ToolKind::cylinder},
                                                          {"addWedge", ToolKind::wedge},
                                                          {"addPlate", ToolKind::plate}};
        std::size_t count = 0;
        for (const auto& [name, kind] : forms) {
            action(name)->trigger();
            ++count;
            QTRY_COMPARE(snapshot().tools.size(), count);
            QCOMPARE(snapshot().tools.back().kind, kind);
            const Vec3 away(0.05 * static_cast<double>(count) - 0.15, 0, 0);
            const ToolState tool = snapshot().tools.back();
            document().post(PlaceManipulator{tool.id, {tool.pose.position + away, tool.pose.rotation}});
            QTRY_COMPARE(document().selection().id, tool.id);
            // A field that is typed into changes nothing but its number.
            auto* field = find<QuantityField>("toolFriction");
            QTRY_VERIFY(field->isVisible());
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, "0.7");
            QTest::keyClick(field, Qt::Key_Return);
            QTRY_COMPARE(snapshot().tools.back().friction, 0.7);
            QCOMPARE(snapshot().tools.back().kind, kind);
            QCOMPARE(snapshot().tools.back().size, tool.size);
        }
        m_window->viewport().setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_F);
        rest();
        picture("tools");
    }

    /// Or what the mouse works on would go away under it.
    void aMessageLeavesTheViewWhereItIs()
    {
        openExample("bar.step");
        m_window->banner().hide();
        QTest::qWait(100);
        auto& view = m_window->viewport();
        const QPoint middle = view.rect().center();
        const QPoint before = view.mapTo(m_window.get(), QPoint(0, 0));
        const QSize size = view.size();
        QTest::mousePress(&view, Qt::MiddleButton, {}, middle);
        m_window->banner().show("Something happened that takes a longer sentence, and the view stays where it is.",
                                "Do it");
        QTest::qWait(100); // panels are laid out later
        QCOMPARE(view.mapTo(m_window.get(), QPoint(0, 0)), before);
        QCOMPARE(view.size(), size);
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, middle);
        const QWidget& banner = m_window->banner();
        const QRect place(banner.mapTo(m_window.get(), QPoint(0, 0)), banner.size());
        QVERIFY(QRect(before, size).contains(place));
        for (const char* name : {"bannerText", "bannerRemedy", "bannerClose"}) {
            const auto* part = banner.findChild<QWidget*>(name);
            QVERIFY2(banner.rect().contains(part->geometry()), name);
            QCOMPARE(m_window->childAt(part->mapTo(m_window.get(), part->rect().center())), part);
        }
        m_window->resize(m_window->width() - 60, m_window->height());
        QTRY_VERIFY(view.width() < size.width());
        const int left = view.mapTo(m_window.get(), QPoint(0, 0)).x();
        QTRY_VERIFY(banner.mapTo(m_window.get(), QPoint(0, 0)).x() + banner.width() <= left + view.width());
        QTest::mouseClick(banner.findChild<QWidget*>("bannerClose"), Qt::LeftButton);
        QVERIFY(!banner.isVisible());
    }

    /// Typed numbers and clicks beside the part do not take the tool out of the hand.
    void theViewHasTheKeysAfterTyping()
    {
        openExample("bar.step");
        action("addBlock")->trigger();
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        auto& view = m_window->viewport();
        auto* hint = find<QLabel>("navigationHint");
        for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Escape}) {
            auto* field = find<QuantityField>("toolSpeed");
            field->setFocus();
            QVERIFY(field->hasFocus());
            QVERIFY2(hint->text().contains("Click into the view"), qPrintable(hint->text()));
            field->selectAll();
            QTest::keyClicks(field, "30 mm/s");
            QTest::keyClick(field, end);
            QVERIFY(view.hasFocus());
            QVERIFY2(hint->text().startsWith("Arrows"), qPrintable(hint->text()));
        }
        auto* field = find<QuantityField>("toolSpeed");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "fast");
        QTest::keyClick(field, Qt::Key_Return); // there is something to mend
        QVERIFY(field->hasProblem() && field->hasFocus());
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(view.hasFocus());

        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(30, view.height() - 30));
        QTest::qWait(50);
        QCOMPARE(document().selection().kind, Selection::Kind::Tool);
        const double before = snapshot().tools[0].pose.position.x();
        QTest::keyPress(&view, Qt::Key_Right);
        QTRY_VERIFY(snapshot().tools[0].pose.position.x() != before);
        QTest::keyRelease(&view, Qt::Key_Right);
        QTest::keyClick(m_window.get(), Qt::Key_Escape); // this gives it up
        QTRY_COMPARE(document().selection().kind, Selection::Kind::None);
    }

    void newToolsHaveNumbersThatAPersonWouldType()
    {
        const auto significant = [](const QString& shown) {
            QString number = shown.section(' ', 0, 0).remove('-');
            if (number.contains('e'))
                return 99;
            const bool isWhole = !number.contains('.');
            number.remove('.');
            while (number.startsWith('0'))
                number.remove(0, 1);
            while (isWhole && number.endsWith('0'))
                number.chop(1);
            return static_cast<int>(number.size());
        };
        for (const char* part : {"bracket.step", "handle.step"}) {
            openExample(part);
            std::size_t count = snapshot().tools.size();
            for (const char* name : {"addBlock", "addPlate", "addKnife", "addRoller"}) {
                action(name)->trigger();
                ++count;
                QTRY_COMPARE(snapshot().tools.size(), count);
                QTRY_COMPARE(document().selection().id, snapshot().tools.back().id);
                for (const char* field : {"toolSizeX", "toolSizeY", "toolSizeZ", "toolSpeed", "toolForceLimit"})
                    QVERIFY2(significant(find<QuantityField>(field)->text()) <= 2,
                             qPrintable(field + (": " + find<QuantityField>(field)->text())));
                for (const char* field : {"toolPositionX", "toolPositionY", "toolPositionZ"})
                    QVERIFY2(significant(find<QuantityField>(field)->text()) <= 4,
                             qPrintable(field + (": " + find<QuantityField>(field)->text())));
            }
        }
        const ToolState tool = snapshot().tools.back();
        document().post(PlaceManipulator{tool.id, {Vec3(7.5535e-9, 0.01, 0.1), tool.pose.rotation}});
        QTRY_COMPARE(find<QuantityField>("toolPositionY")->text(), QString("10 mm"));
        QCOMPARE(find<QuantityField>("toolPositionX")->text(), QString("0 mm"));
    }

    void aToolTakesAnotherForm()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        auto* choice = find<QComboBox>("toolKind");
        QCOMPARE(choice->currentText(), QString("Block"));
        QVERIFY(find<QWidget>("toolSizeZ")->isVisible());
        choice->setCurrentText("Ball");
        emit choice->activated(choice->currentIndex());
        QTRY_COMPARE(snapshot().tools[0].kind, ToolKind::ball);
        QTRY_VERIFY(!find<QWidget>("toolSizeZ")->isVisible());
        QVERIFY(find<QWidget>("toolSizeX")->isVisible());
        auto* diameter = find<QuantityField>("toolSizeX");
        diameter->setFocus();
        diameter->selectAll();
        QTest::keyClicks(diameter, "30 mm");
        QTest::keyClick(diameter, Qt::Key_Return);
        QTRY_COMPARE(snapshot().tools[0].size, Vec3(0.03, 0.03, 0.03));
        QCOMPARE(snapshot().tools[0].kind, ToolKind::ball);
        picture("ball");
    }

    /// A frame from before comes between any two of them.
    void numbersTypedFasterThanFramesComeAllHold()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        const auto typeOver = [&](const char* name, const QString& text) {
            auto* field = find<QuantityField>(name);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
            emit document().changed(Document::Change::Frame);
            QCOMPARE(field->text(), text);
        };
        const char* places[] = {"toolPositionX", "toolPositionY", "toolPositionZ"};
        const char* sizes[] = {"toolSizeX", "toolSizeY", "toolSizeZ"};
        for (int axis = 0; axis < 3; ++axis) {
            typeOver(places[axis], QString("%1 mm").arg(100 + axis));
            typeOver(sizes[axis], QString("%1 mm").arg(20 + axis));
        }
        typeOver("toolFriction", "0.25");
        QTRY_COMPARE(snapshot().tools[0].friction, 0.25);
        QVERIFY((snapshot().tools[0].pose.position - Vec3(0.1, 0.101, 0.102)).norm() < 1e-12);
        QVERIFY((snapshot().tools[0].size - Vec3(0.02, 0.021, 0.022)).norm() < 1e-12);
        typeOver("gravityX", "1 m/s²");
        typeOver("gravityY", "2 m/s²");
        QTRY_COMPARE(snapshot().gravity, Vec3(1, 2, 0));
        typeOver("allDampingRatio", "0.11");
        typeOver("allShapeDamping", "7 1/s");
        QTRY_COMPARE(snapshot().materials[0].shapeDamping, 7.0);
        QCOMPARE(snapshot().materials[0].dampingRatio, 0.11);
    }

    /// A tool that is on its way in one direction goes on in it when another is typed; and from Play on it never jumps.
    void aToolGoesToAllThatWasTypedWhileTimeRuns()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        const auto typeOver = [&](const char* name, const QString& text) {
            auto* field = find<QuantityField>(name);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
        };
        const Vec3 start = snapshot().tools[0].pose.position;
        const double limit = snapshot().tools[0].speedLimit;
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        typeOver("toolPositionX", "180 mm");
        QTRY_VERIFY(snapshot().playing && (snapshot().tools[0].pose.position - start).norm() > 0);
        QVERIFY((snapshot().tools[0].pose.position - start).norm() < limit * snapshot().time + 1e-9);
        seen(); // on its way
        typeOver("toolPositionY", "60 mm");
        const Vec3 goal(0.18, 0.06, start.z());
        QTRY_VERIFY_WITH_TIMEOUT((snapshot().tools[0].pose.position - goal).norm() < 1e-9, patience);
    }

    void aMaterialSaysHowItFlowsAndBreaks()
    {
        openExample("bar.step");
        auto* preset = find<QComboBox>("materialPreset");
        const auto choose = [&](const QString& name) {
            preset->setCurrentText(name);
            emit preset->activated(preset->currentIndex());
        };
        choose("Steel");
        QTRY_COMPARE(find<QuantityField>("yield_stress_pa")->text(), QString("250 MPa"));
        QCOMPARE(find<QuantityField>("healing_time_s")->text(), QString());
        QCOMPARE(find<QuantityField>("healing_time_s")->placeholderText(), QString("does not heal"));
        choose("Modeling clay");
        QTRY_COMPARE(find<QuantityField>("healing_time_s")->text(), QString("300 ms"));
        QCOMPARE(snapshot().materials[0].yieldStress, 1e4);
        auto* last = find<QWidget>("refill");
        auto* area = qobject_cast<QScrollArea*>(find<QStackedWidget>("properties")->currentWidget());
        const auto isSeenAfterScrolling = [&] {
            area->ensureWidgetVisible(last);
            return !last->visibleRegion().isEmpty();
        };
        QTRY_VERIFY2(isSeenAfterScrolling(),
                     "the panel scrolls to its end"); // the panel grows with what it says of clay
        picture("material");
    }

    void scrollingThePanelChangesNoMaterial()
    {
        openExample("bar.step");
        auto* preset = find<QComboBox>("materialPreset");
        const QPointF middle = QRectF(preset->rect()).center();
        QWheelEvent wheel(middle, preset->mapToGlobal(middle), {}, {0, -240}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        const int chosen = preset->currentIndex();
        QApplication::sendEvent(preset, &wheel);
        QVERIFY(chosen >= 0);
        QCOMPARE(preset->currentIndex(), chosen);
    }

    void renormalizedMaterialHasNoStress()
    {
        openExample("bar.step");
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        QVERIFY(snapshot().energy.elastic > 0);
        const double stored = snapshot().energy.elastic;
        QTest::keyClick(m_window.get(), Qt::Key_N);
        QTest::keyClick(m_window.get(), Qt::Key_Period);
        QTRY_VERIFY(snapshot().energy.elastic < 0.01 * stored);
    }

    void aBodyBecomesRigidAndStaysSoWhenFilledAnew()
    {
        openExample("bar.step");
        auto* kind = find<QComboBox>("bodyKind");
        QCOMPARE(kind->currentText(), QString("Deformable"));
        kind->setCurrentText("Rigid");
        emit kind->activated(kind->currentIndex());
        QTRY_COMPARE(snapshot().bodies[0].kind, BodyKind::rigid);
        QCOMPARE(kind->currentText(), QString("Rigid"));
        m_window->features().imports->refill(document().size() / 12);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(snapshot().bodies[0].kind, BodyKind::rigid);
    }

    void stiffMaterialGetsImplicitStepsUnlessOneChoosesOtherwise()
    {
        openExample("bar.step");
        auto* choice = find<QComboBox>("integrator");
        QCOMPARE(choice->currentText(), QString("Automatic"));
        document().post(SetMaterial{0, {.density = 7850, .youngsModulus = 2e11}});
        QTRY_COMPARE(find<QLabel>("integratorInUse")->text(), QString("Implicit"));
        QVERIFY(find<QLabel>("integratorInUse")->toolTip().contains("steps per second"));
        QVERIFY(find<QLabel>("integratorReason")->text().contains("steps per second"));
        choice->setCurrentText("Semi-implicit Euler");
        emit choice->activated(choice->currentIndex());
        QTRY_COMPARE(find<QLabel>("integratorInUse")->text(), QString("Explicit"));
        QTRY_COMPARE(choice->currentText(), QString("Semi-implicit Euler"));
        m_window->features().imports->refill(document().size() / 12);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(snapshot().wantedIntegrator, Integrator::semiImplicitEuler);
    }

    void statusSaysWhenMaterialIsBroken()
    {
        openExample("bar.step");
        QVERIFY(!find<QLabel>("brokenCount")->isVisible());
        QVERIFY(!find<QLabel>("pieceCount")->isVisible());
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        document().post(SetMaterial{0, {.youngsModulus = 1e4, .tensileStrength = 1}});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("brokenCount")->isVisible(), patience);
        QVERIFY(find<QLabel>("brokenCount")->text().contains("broken"));
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("pieceCount")->text().contains("pieces"), patience);
        picture("broken");
    }

    void typedStiffnessReachesTheSimulation()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        auto* field = find<QuantityField>("youngs_modulus_pa");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "0,25 MPa");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(snapshot().materials[0].youngsModulus, 2.5e5);
        QCOMPARE(field->text(), QString("250 kPa"));
        QTRY_COMPARE(find<QComboBox>("materialPreset")->currentIndex(), -1);
    }

    void aBlockIsDraggedWithTheMouse()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        QTest::keyClick(m_window.get(), Qt::Key_F);
        rest();
        const Vec3 start = snapshot().tools[0].pose.position;
        ViewportWidget& view = m_window->viewport();
        const QPoint from = view.widgetPosition(start)->toPoint();
        QTest::mouseMove(&view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        QTest::mouseMove(&view, from + QPoint(40, 0));
        QTest::mouseMove(&view, from + QPoint(80, 0));
        QTRY_VERIFY((snapshot().tools[0].pose.position - start).dot(view.camera().right()) > 0.05 * document().size());
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(80, 0));
        // In the plane of the camera: neither nearer nor further.
        QVERIFY(std::abs((snapshot().tools[0].pose.position - start).dot(view.camera().towardsEye())) < 1e-9);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowPanelsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_panels_test.moc"
