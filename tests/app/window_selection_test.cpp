#include "core/session/region_contents.h"
#include "support/window_on_test.h"
#include "ui/panels/quantity_field.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>

using namespace knead;

/// Faces, edges, objects and connections as a person selects them, and what is done to them.
class WindowSelectionTest : public QObject, WindowOnTest {
    Q_OBJECT

    SelectionModel& selected() { return document().selected(); }
    ViewportWidget& view() { return m_window->viewport(); }
    QString reading() { return find<QLabel>("selectionReading")->text(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }
    QPoint at(const Vec3& place) { return view().widgetPosition(place)->toPoint(); }
    Vec3 topOf(const Box& box) { return {box.center().x(), box.center().y(), box.max().z()}; }

    void drag(const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseMove(&view(), way.front());
        QTest::mousePress(&view(), Qt::LeftButton, modifiers, way.front());
        for (std::size_t i = 1; i < way.size(); ++i)
            QTest::mouseMove(&view(), way[i]);
        QTest::mouseRelease(&view(), Qt::LeftButton, modifiers, way.back());
    }

    /// From above, so that places on the screen are those of the plan.
    void lookDown()
    {
        key(Qt::Key_7);
        if (view().camera().perspective)
            key(Qt::Key_5);
        key(Qt::Key_F);
        rest();
    }

    QRect screenBox(const Box& box)
    {
        QRect rect(at(box.min()), at(box.max()));
        return rect.normalized();
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(Eyes::open);
    }

    void init() { show(m_services); }

    void cleanup() { m_window.reset(); }

    void aFaceLightsUpUnderTheCursorAndIsSelectedByAClick()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        QVERIFY(action("selectFaces")->isChecked());
        const Vec3 top = topOf(document().content().box);
        QTest::mouseMove(&view(), at(top));
        QTRY_COMPARE(view().regions().hovered().count(), std::size_t{1});
        QCOMPARE(view().regions().hovered().level, Level::Face);
        picture("selection-hover");
        click(top);
        QCOMPARE(selected().region().count(), std::size_t{1});
        QCOMPARE(document().selection().kind, Selection::Kind::Region);
        QVERIFY2(reading().startsWith("1 face, "), qPrintable(reading()));
        QVERIFY(find<QWidget>("selectionPanel")->isVisible());
        const Vec3 size = document().content().box.sizes();
        const double area = sizeOf(selected().region(), document().content(), *document().frame()).area;
        QVERIFY(std::abs(area - size.x() * size.y()) < 1e-3 * area);
        picture("selection-face");
        key(Qt::Key_Escape);
        QVERIFY(selected().region().isEmpty());
        QCOMPARE(document().selection().kind, Selection::Kind::None);
        QVERIFY(!find<QLabel>("selectionReading")->isVisible());
    }

    void noKeyDoesTwoThings()
    {
        std::map<QKeySequence, QString> taken;
        for (const QAction* one : m_window->findChildren<QAction*>())
            for (const QKeySequence& keys : one->shortcuts()) {
                const auto [other, isFree] = taken.try_emplace(keys, one->objectName());
                QVERIFY2(isFree, qPrintable(keys.toString() + ": " + other->second + " and " + one->objectName()));
            }
        for (const QAction* menu : m_window->menuBar()->actions()) // Alt and a letter open them
            QVERIFY2(!taken.contains(QKeySequence::mnemonic(menu->text())), qPrintable(menu->text()));
    }

    void menusHaveWhatBelongsToThem()
    {
        const auto menuOf = [&](const char* name) {
            for (QAction* menu : m_window->menuBar()->actions())
                if (menu->menu()->actions().contains(action(name)))
                    return menu->text().remove('&');
            return QString();
        };
        QCOMPARE(menuOf("isolate"), QString("View"));
        QCOMPARE(menuOf("showAll"), QString("View"));
        QCOMPARE(menuOf("rename"), QString("Edit"));
    }

    void ctrlAddsAndTakesAway()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        const Box box = document().content().box;
        const Vec3 top = topOf(box);
        const Vec3 side(box.center().x(), box.min().y(), box.center().z());
        click(top);
        const auto ctrlClick = [&](const Vec3& place) {
            QTest::mouseMove(&view(), at(place));
            QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, at(place));
        };
        ctrlClick(side);
        QCOMPARE(selected().region().count(), std::size_t{2});
        QVERIFY(reading().startsWith("2 faces, "));
        ctrlClick(top);
        QCOMPARE(selected().region().count(), std::size_t{1});
        click(top);
        QCOMPARE(selected().region().count(), std::size_t{1});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(12, view().height() - 12)); // nothing is there
        QVERIFY(selected().region().isEmpty());
    }

    void edgesAreSelectedWhereTheyAreSeen()
    {
        openExample("bar.step");
        key(Qt::Key_3);
        const Box box = document().content().box;
        const Vec3 edge(box.center().x(), box.min().y(), box.max().z());
        click(edge);
        QCOMPARE(selected().region().level, Level::Edge);
        QCOMPARE(selected().region().count(), std::size_t{1});
        const double length = sizeOf(selected().region(), document().content(), *document().frame()).length;
        QVERIFY(std::abs(length - box.sizes().x()) < 1e-3 * length);
        QTest::mouseMove(&view(), QPoint(8, 8));
        QTRY_VERIFY(view().regions().hovered().isEmpty());
        drawn(); // until it is drawn
        const QImage seen = view().grabFramebuffer();
        for (const int aside : {-1, 0, 1}) { // it is wide
            const QColor color = seen.pixelColor(at(edge) + QPoint(0, aside));
            QVERIFY2(color.blue() > 2 * color.red(), qPrintable(color.name()));
        }
        picture("selection-edge");
        click(topOf(box)); // far from any edge
        QVERIFY(selected().region().isEmpty());
    }

    void aBoxToTheRightTakesWhatLiesInItAndOneToTheLeftWhatItTouches()
    {
        openExample("bracket.step");
        lookDown();
        key(Qt::Key_2);
        const QRect all = screenBox(document().content().box).marginsAdded({20, 20, 20, 20});
        drag({all.topLeft(), all.center(), all.bottomRight()});
        const std::size_t inside = selected().region().count();
        QVERIFY(inside > 2);
        picture("selection-box-faces");
        const QPoint middle = all.center();
        drag({all.topLeft(), middle - QPoint(40, 40), middle});
        const Region half = selected().region();
        drag({middle, middle - QPoint(40, 40), all.topLeft()});
        const Region touched = selected().region();
        QVERIFY(touched.count() > half.count());
        QCOMPARE(united(touched, half), touched);
        // What is hidden comes along only when it is asked for.
        action("selectThrough")->trigger();
        drag({all.topLeft(), all.center(), all.bottomRight()});
        QVERIFY(selected().region().count() > inside);
    }

    void aBoxSelectsTheObjectsOfHalfTheBar()
    {
        openExample("bar.step");
        lookDown();
        key(Qt::Key_4);
        QVERIFY2(action("objects")->isChecked(), "one sees what is selected");
        const QRect all = screenBox(document().content().box).marginsAdded({20, 20, 20, 20});
        const QPoint middle(all.center().x(), all.bottom());
        QTest::mouseMove(&view(), all.topLeft());
        QTest::mousePress(&view(), Qt::LeftButton, {}, all.topLeft());
        QTest::mouseMove(&view(), all.center());
        QTest::mouseMove(&view(), middle);
        drawn();
        QVERIFY(find<QWidget>("regionOverlay")->isVisible());
        picture("selection-box");
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle);
        QVERIFY(!find<QWidget>("regionOverlay")->isVisible());
        const Region& region = selected().region();
        const Box box = document().content().box;
        const std::vector<Vec3>& places = snapshot().bodies[0].positions;
        const double spacing = document().content().spacing;
        for (ObjectIndex object = 0; object < places.size(); ++object)
            if (std::abs(places[object].x() - box.center().x()) > 0.2 * spacing)
                QCOMPARE(region.contains(0, object), places[object].x() < box.center().x());
        drawn();
        picture("selection-objects");
        key(Qt::Key_1);
        QVERIFY(!action("objects")->isChecked());
    }

    void aLassoAndABrushSelectToo()
    {
        openExample("bar.step");
        lookDown();
        key(Qt::Key_4);
        key(Qt::Key_2, Qt::AltModifier);
        QCOMPARE(view().regions().shape(), RegionShape::Lasso);
        const QRect all = screenBox(document().content().box);
        const QPoint center = all.center();
        const int reach = all.height();
        std::vector<QPoint> round;
        for (int i = 0; i <= 24; ++i)
            round.push_back(center + QPoint(static_cast<int>(reach * std::cos(i * 0.2618)),
                                            static_cast<int>(reach * std::sin(i * 0.2618))));
        drag(round);
        const std::size_t inLasso = selected().region().count();
        QVERIFY(inLasso > 0 && inLasso < snapshot().bodies[0].positions.size());
        for (const Region::Item object : selected().region().items.at(0))
            QVERIFY((at(snapshot().bodies[0].positions[object]) - center).manhattanLength() < 1.5 * reach);
        drawn();
        picture("selection-lasso");

        key(Qt::Key_3, Qt::AltModifier);
        QCOMPARE(view().regions().shape(), RegionShape::Brush);
        const QPoint left(all.left() + 10, all.center().y());
        const QPoint right(all.right() - 10, all.center().y());
        drag({left, right}); // fast, and yet without gaps
        const Region& painted = selected().region();
        std::set<int> columns;
        for (const Region::Item object : painted.items.at(0))
            columns.insert(static_cast<int>(
                std::lround(snapshot().bodies[0].positions[object].x() / document().content().spacing)));
        QVERIFY(static_cast<int>(columns.size()) >= *columns.rbegin() - *columns.begin());
        QVERIFY(columns.size() > 10);
        drawn();
        picture("selection-brush");
        const std::size_t before = painted.count();
        drag({left, left + QPoint(30, 0)}, Qt::ShiftModifier);
        QVERIFY(selected().region().count() < before);
    }

    void aSelectedFaceIsSeenOverColorsOfNumbers()
    {
        openExample("bar.step");
        SceneOptions options = view().options();
        options.colors.quantity = SurfaceQuantity::displacement;
        view().setOptions(options);
        QTRY_VERIFY(view().scale().has_value());
        key(Qt::Key_2);
        const QPoint place = at(topOf(document().content().box)) + QPoint(6, 4);
        const auto colorThere = [&] {
            drawn(); // until it is drawn
            return view().grabFramebuffer().pixelColor(place);
        };
        const QColor before = colorThere();
        click(topOf(document().content().box));
        QTest::mouseMove(&view(), QPoint(8, 8));
        QTRY_VERIFY(view().regions().hovered().isEmpty());
        QVERIFY(colorThere() != before);
        picture("selection-over-numbers");
        key(Qt::Key_Escape);
        QCOMPARE(colorThere(), before);
    }

    void anotherShapeGivesUpTheStrokeOfABrush()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        click(topOf(document().content().box));
        const Region before = selected().region();
        key(Qt::Key_3, Qt::AltModifier);
        QTest::mousePress(&view(), Qt::LeftButton, {}, QPoint(20, 200));
        QVERIFY(selected().region().isEmpty());
        key(Qt::Key_2, Qt::AltModifier);
        QTest::mouseMove(&view(), QPoint(200, 300));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, QPoint(200, 300));
        QCOMPARE(selected().region(), before);
    }

    void whatASectionTakesAwayIsNotSelected()
    {
        openExample("bar.step");
        lookDown();
        key(Qt::Key_2);
        const Box box = document().content().box;
        click(topOf(box));
        const Region top = selected().region();
        SceneOptions options = view().options();
        options.section.plane = CutPlane{Vec3::UnitZ(), box.center().z()};
        view().setOptions(options);
        click(topOf(box)); // where the top was, on the cut, which is no face
        QVERIFY(selected().region().isEmpty());
        action("selectThrough")->trigger();
        const QRect all = screenBox(box).marginsAdded({20, 20, 20, 20});
        drag({all.topLeft(), all.center(), all.bottomRight()});
        QCOMPARE(selected().region().count(), std::size_t{5}); // all but the top
        QVERIFY(!selected().region().contains(0, top.items.at(0).front()));
        view().lookFrom(Vec3(0, 0, -1));
        rest();
        click(Vec3(box.center().x(), box.center().y(), box.min().z())); // what is left has its face
        QCOMPARE(selected().region().count(), std::size_t{1});
        QVERIFY(selected().region() != top);
    }

    void objectsThatAreShownToSelectThemAreNotRemembered()
    {
        openExample("bar.step");
        key(Qt::Key_4);
        QVERIFY(action("objects")->isChecked() && !action("skin")->isChecked());
        m_window.reset();
        show(m_services);
        QVERIFY(!action("objects")->isChecked() && action("skin")->isChecked());
    }

    void selectingLeavesOtherModesOfTheMouse()
    {
        openExample("bar.step");
        for (const char* mode : {"fixFaces", "pull", "placeProbe"}) {
            action(mode)->trigger();
            QVERIFY(action(mode)->isChecked());
            key(Qt::Key_2);
            QVERIFY2(!action(mode)->isChecked(), mode);
        }
        click(topOf(document().content().box));
        QCOMPARE(selected().region().level, Level::Face);
    }

    void escGivesUpABoxThatIsBeingDrawn()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        click(topOf(document().content().box));
        const Region before = selected().region();
        QTest::mousePress(&view(), Qt::LeftButton, {}, QPoint(20, 200));
        QTest::mouseMove(&view(), QPoint(200, 300));
        QTest::mouseMove(&view(), QPoint(300, 400));
        QVERIFY(view().regions().isDrawing());
        key(Qt::Key_Escape);
        QVERIFY(!view().regions().isDrawing());
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, QPoint(300, 400));
        QCOMPARE(selected().region(), before);
    }

    void aConnectionIsSelectedByAClick()
    {
        openExample("bar.step");
        key(Qt::Key_4, Qt::ControlModifier);
        QCOMPARE(selected().level(), Level::Connection);
        const std::vector<ConnectionId> seen = surfaceConnections(*document().content().bodies[0]);
        const std::vector<Vec3>& places = snapshot().bodies[0].positions;
        const Vec3 towards = view().camera().towardsEye();
        const auto nearest = std::max_element(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) {
            return a.dot(towards) < b.dot(towards);
        });
        const auto found = std::find_if(seen.begin(), seen.end(), [&](const ConnectionId& connection) {
            const auto [lower, upper] = endsOf(*document().content().bodies[0]->aggregate, connection);
            return lower == nearest - places.begin() || upper == nearest - places.begin();
        });
        QVERIFY(found != seen.end());
        const auto [lower, upper] = endsOf(*document().content().bodies[0]->aggregate, *found);
        click((places[lower] + places[upper]) / 2);
        QCOMPARE(selected().region().level, Level::Connection);
        QCOMPARE(selected().region().count(), std::size_t{1});
        QVERIFY(reading().startsWith("1 connection, "));
        drawn();
        picture("selection-connection");
    }

    void partsAreAddedAndAllIsSelected()
    {
        openExample("bracket.step");
        QCOMPARE(snapshot().bodies.size(), std::size_t{2});
        key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selected().region().count(), std::size_t{2});
        QVERIFY(reading().startsWith("2 parts, "));
        auto* tree = find<QTreeWidget>("modelTree");
        QCOMPARE(tree->selectedItems().size(), 2);
        drawn();
        picture("selection-parts");
        key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(selected().region().isEmpty());
        QVERIFY(tree->selectedItems().isEmpty());
        key(Qt::Key_2);
        key(Qt::Key_A, Qt::ControlModifier);
        std::size_t faces = 0;
        for (const Part& part : document().content().model->parts)
            faces += part.faces.size();
        QCOMPARE(selected().region().count(), faces);
    }

    void treeAndViewSelectTogether()
    {
        openExample("bracket.step");
        auto* tree = find<QTreeWidget>("modelTree");
        std::vector<QTreeWidgetItem*> parts;
        for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it)
            if (((*it)->flags() & Qt::ItemIsDragEnabled) != 0)
                parts.push_back(*it);
        QCOMPARE(parts.size(), std::size_t{2});
        const auto clickLine = [&](QTreeWidgetItem* item, Qt::KeyboardModifiers modifiers = {}) {
            QTest::mouseClick(tree->viewport(), Qt::LeftButton, modifiers,
                              tree->visualItemRect(item).topLeft() + QPoint(30, 8));
        };
        clickLine(parts[1]);
        QCOMPARE(document().selection(), (Selection{Selection::Kind::Body, 1}));
        QVERIFY(selected().region().contains(1, 0) && selected().region().count() == 1);
        clickLine(parts[0], Qt::ControlModifier);
        QCOMPARE(selected().region().count(), std::size_t{2});
        key(Qt::Key_Escape);
        QVERIFY(tree->selectedItems().isEmpty());
        // And the other way.
        const BodyFrame& frame = *document().frame()->bodies[0];
        const Vec3 towards = view().camera().towardsEye();
        const Vec3 nearest =
            *std::max_element(frame.places.begin(), frame.places.end(),
                              [&](const Vec3& a, const Vec3& b) { return a.dot(towards) < b.dot(towards); });
        Box box;
        for (const Vec3& place : frame.places)
            box.extend(place);
        click(nearest + 0.02 * (box.center() - nearest));
        QCOMPARE(document().selection(), (Selection{Selection::Kind::Body, 0}));
        QCOMPARE(tree->selectedItems(), QList{parts[0]});
    }

    void aSelectedFaceIsFixed()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        click(topOf(document().content().box));
        QTest::mouseClick(find<QPushButton>("fixRegion"), Qt::LeftButton);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY(!snapshot().fixtures[0].objects.empty());
        QCOMPARE(document().selection().kind, Selection::Kind::Fixture);
        QCOMPARE(document().fixtures().list().front().faces.size(), std::size_t{1});
        QTRY_COMPARE(document().undoName().value_or(QString()), QString("Fix selection"));
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(snapshot().fixtures.empty());
    }

    void objectsAreHeldWithoutFaces()
    {
        openExample("bar.step");
        lookDown();
        key(Qt::Key_4);
        const QRect all = screenBox(document().content().box).marginsAdded({20, 20, 20, 20});
        drag({all.topLeft(), all.center(), QPoint(all.left() + all.width() / 3, all.bottom())});
        const std::size_t count = selected().region().count();
        QVERIFY(count > 0);
        key(Qt::Key_F, Qt::ShiftModifier);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        QCOMPARE(snapshot().fixtures[0].objects.size(), count);
    }

    void aRegionOfAnotherMaterialBendsOtherwise()
    {
        // Two bars that hang out of a clamp at the same end; one has a stiff root.
        double sag[2] = {};
        for (const bool isStiff : {false, true}) {
            openExample("bar.step", 20);
            document().post(SetMaterial{0, {.density = 1000, .youngsModulus = 2e5, .dampingRatio = 0.5}});
            action("floor")->trigger();
            lookDown();
            key(Qt::Key_4);
            const QRect all = screenBox(document().content().box).marginsAdded({20, 20, 20, 20});
            const auto selectLeft = [&](double share) {
                const int end = all.left() + static_cast<int>(share * all.width());
                drag({all.topLeft(), all.center(), QPoint(end, all.bottom())});
                QVERIFY(!selected().region().isEmpty());
            };
            if (isStiff) {
                selectLeft(0.6);
                auto* field = find<QuantityField>("region_youngs_modulus_pa");
                QVERIFY(field->isVisible());
                field->setFocus();
                field->selectAll();
                QTest::keyClicks(field, "20 MPa");
                QTest::keyClick(field, Qt::Key_Return);
                QTRY_COMPARE(document().undoName().value_or(QString()), QString("Material of selection"));
                QCOMPARE(snapshot().materials[0].youngsModulus, 2e5); // the rest is what it was
                picture("selection-material");
                view().setFocus();
            }
            selectLeft(0.2);
            key(Qt::Key_F, Qt::ShiftModifier);
            QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
            key(Qt::Key_1);
            key(Qt::Key_1, Qt::KeypadModifier); // from the front, where one sees it bend
            key(Qt::Key_G);
            const double start = document().content().box.min().z();
            key(Qt::Key_Space);
            QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.4, patience);
            key(Qt::Key_Space);
            QTRY_VERIFY(!snapshot().playing);
            double lowest = start;
            for (const Vec3& place : document().frame()->bodies[0]->places)
                lowest = std::min(lowest, place.z());
            sag[isStiff ? 1 : 0] = start - lowest;
            picture(isStiff ? "selection-stiff" : "selection-soft");
        }
        QVERIFY2(sag[0] > 0 && sag[1] < 0.7 * sag[0], qPrintable(QString("%1 %2").arg(sag[0]).arg(sag[1])));
    }

    void allWithinADistanceOfAFaceIsALayerUnderIt()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        const Box box = document().content().box;
        click(topOf(box));
        key(Qt::Key_D, Qt::ControlModifier);
        auto* field = find<QuantityField>("withinDistance");
        QTRY_VERIFY(field->hasFocus());
        const double spacing = document().content().spacing;
        QTest::keyClicks(field, QString("%1 mm").arg(1000 * 1.2 * spacing));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(selected().region().level, Level::Object);
        const Region& layer = selected().region();
        QVERIFY(layer.count() > 0);
        const std::vector<Vec3>& places = snapshot().bodies[0].positions;
        for (ObjectIndex object = 0; object < places.size(); ++object) {
            const double depth = box.max().z() - places[object].z();
            if (depth < 0.9 * spacing)
                QVERIFY(layer.contains(0, object));
            if (depth > 2.5 * spacing)
                QVERIFY(!layer.contains(0, object));
        }
        picture("selection-within");
    }

    void aSelectionIsKeptRecalledRenamedAndDeleted()
    {
        openExample("bracket.step");
        key(Qt::Key_2);
        action("selectAll")->trigger();
        const Region faces = selected().region();
        key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
        auto* name = find<QLineEdit>("setName");
        QTRY_VERIFY(name->hasFocus());
        QTest::keyClicks(name, "all of it");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(document().notes().sets().size(), std::size_t{1});
        auto* tree = find<QTreeWidget>("modelTree");
        const auto line = [&](const QString& text) -> QTreeWidgetItem* {
            const auto found = tree->findItems(text, Qt::MatchExactly | Qt::MatchRecursive);
            return found.isEmpty() ? nullptr : found.front();
        };
        QVERIFY(line("all of it") != nullptr);
        view().setFocus();
        key(Qt::Key_Escape);
        QVERIFY(selected().region().isEmpty());
        tree->scrollToItem(line("all of it"));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(line("all of it")).center());
        QCOMPARE(selected().region(), faces);
        picture("selection-set");
        // F2, another name.
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_F2);
        QTRY_VERIFY(tree->viewport()->findChild<QLineEdit*>() != nullptr);
        auto* editor = tree->viewport()->findChild<QLineEdit*>();
        editor->selectAll();
        QTest::keyClicks(editor, "skin");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(line("skin") != nullptr);
        QVERIFY(document().notes().set("skin") != nullptr);
        document().notes().removeSet("skin");
        QVERIFY(line("skin") == nullptr);
    }

    void objectsOfASetAreFoundInAnotherFilling()
    {
        openExample("bar.step", 16);
        lookDown();
        key(Qt::Key_4);
        const QRect all = screenBox(document().content().box).marginsAdded({20, 20, 20, 20});
        drag({all.topLeft(), all.center(), QPoint(all.center().x(), all.bottom())});
        QVERIFY(document().keepSet("half", selected().region()));
        m_window->features().imports->refill(document().size() / 24);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(selected().region().level == Level::Part); // what was selected is gone
        const Region half = document().regionOf(*document().notes().set("half"));
        const Box box = document().content().box;
        const std::vector<Vec3>& places = snapshot().bodies[0].positions;
        for (ObjectIndex object = 0; object < places.size(); ++object)
            if (std::abs(places[object].x() - box.center().x()) > document().size() / 16)
                QCOMPARE(half.contains(0, object), places[object].x() < box.center().x());
    }

    void enterTakesTheDistanceThatIsProposed()
    {
        openExample("bar.step");
        key(Qt::Key_2);
        click(topOf(document().content().box));
        key(Qt::Key_D, Qt::ControlModifier);
        auto* field = find<QuantityField>("withinDistance");
        QTRY_VERIFY(field->hasFocus());
        const double distance = field->value();
        QVERIFY(distance > 0);
        const Region expected = objectsWithin(selected().region(), distance, document().content(), *document().frame());
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(selected().region(), expected);
        QTRY_VERIFY(reading().contains("objects, "));
    }

    void whatWasSelectedInAnotherFillingIsNotSelectedAnyMore()
    {
        openExample("bar.step", 16);
        const double spacing = document().content().spacing;
        m_window->features().imports->refill(document().size() / 24);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        key(Qt::Key_4);
        key(Qt::Key_A, Qt::ControlModifier);
        const Region all = selected().region();
        QCOMPARE(all.level, Level::Object);
        QTRY_VERIFY(document().isSettled());
        document().undo();
        QVERIFY(document().isGoing());
        document().fixRegion(all); // of objects that are not there any more when it can be done
        document().setMaterialOf(all, {}, {});
        QTRY_COMPARE(document().content().spacing, spacing);
        QTRY_VERIFY(!document().isGoing());
        QCOMPARE(document().selection(), (Selection{Selection::Kind::Body, 0}));
        QCOMPARE(selected().region(), regionOf(Level::Part, 0, {0}));
        seen();
        QVERIFY(snapshot().fixtures.empty());
    }

    void aMeshHasNoFacesToTellApart()
    {
        openExample("bar.step");
        QVERIFY(hasFaces(document().content(), 0));
        document().selected().setLevel(Level::Face);
        document().fixRegion({});
        QVERIFY(snapshot().fixtures.empty());
    }

    void selectionLooksGoodInTheDark()
    {
        m_window->features().preferences->setTheme(Theme::Dark);
        m_window->resize(1600, 1000);
        openExample("bracket.step");
        key(Qt::Key_2);
        const Box box = document().content().box;
        action("selectAll")->trigger();
        document().keepSet("skin", selected().region());
        key(Qt::Key_Escape);
        click(topOf(box));
        drawn();
        picture("selection-dark");
        m_window->features().preferences->setTheme(Theme::Light);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowSelectionTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_selection_test.moc"
