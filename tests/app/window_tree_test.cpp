#include "io/importer.h"
#include "support/projects_on_test.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/model_tree_delegate.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"

#include <QColorDialog>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <QtTest>

#include <algorithm>

using namespace knead;

/// Lets a test drop something.
struct Droppable : QTreeWidget {
    using QTreeWidget::dropEvent;
};

/// The model tree as a person uses it.
class WindowTreeTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    ModelTree* tree() { return m_window->findChild<ModelTree*>(); }
    QTreeWidgetItem* line(const QString& text)
    {
        const auto found = tree()->findItems(text, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    QTreeWidgetItem* partLine(std::size_t part)
    {
        for (QTreeWidgetItemIterator it(tree()); *it != nullptr; ++it)
            if ((*it)->data(0, tree_roles::part).isValid() && (*it)->data(0, tree_roles::part).toULongLong() == part)
                return *it;
        return nullptr;
    }
    QString nameOf(std::size_t part) { return QString::fromStdString(document().content().model->parts[part].name); }
    void clickLine(QTreeWidgetItem* item, Qt::KeyboardModifiers modifiers = {})
    {
        tree()->scrollToItem(item);
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, modifiers,
                          tree()->visualItemRect(item).topLeft() + QPoint(30, 8));
    }
    void clickEye(QTreeWidgetItem* item)
    {
        tree()->scrollToItem(item);
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {},
                          ModelTreeDelegate::eyeRect(tree()->visualItemRect(item)).center());
    }
    void clickLock(QTreeWidgetItem* item)
    {
        tree()->scrollToItem(item);
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {},
                          ModelTreeDelegate::lockRect(tree()->visualItemRect(item)).center());
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }

    /// F2, the name, Enter.
    void rename(QTreeWidgetItem* item, const QString& name)
    {
        clickLine(item);
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_F2);
        QTRY_VERIFY(tree()->viewport()->findChild<QLineEdit*>() != nullptr);
        auto* editor = tree()->viewport()->findChild<QLineEdit*>();
        QCOMPARE(editor->text(), item->data(0, tree_roles::name).toString());
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(tree()->viewport()->findChild<QLineEdit*>() == nullptr);
    }
    const std::set<std::size_t>& hidden() { return m_window->viewport().options().hiddenParts; }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { begin(); }

    void cleanup() { m_window.reset(); }

    void aNameIsUndoneSavedAndOpened()
    {
        openExample("bracket.step", 10);
        const QString before = nameOf(0);
        rename(partLine(0), "Console 7");
        QTRY_COMPARE(partLine(0)->text(0), QString("Console 7"));
        QCOMPARE(document().nameOfBody(0), QString("Console 7"));
        wait();
        QTRY_COMPARE(document().undoName().value_or(QString()), QString("Rename to Console 7"));
        picture("tree-renamed");
        m_window->viewport().setFocus();
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(partLine(0)->text(0), before);
        wait();
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(partLine(0)->text(0), QString("Console 7"));
        wait();
        saveTo(file("named.knead"));
        newWindow(m_services);
        openProject(file("named.knead"));
        QCOMPARE(partLine(0)->text(0), QString("Console 7"));
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(partLine(0)->text(0), before);
    }

    void namesAndColorsGoIntoFiles()
    {
        openExample("bracket.step", 10);
        document().renamePart(0, "Shelf");
        document().colorPart(0, Color{1.0F, 0.5F, 0.0F});
        waitForGesture();
        const QString path = file("out.step");
        m_window->features().exports->exportTo(path);
        wait();
        QVERIFY2(QFileInfo::exists(path), qPrintable(m_window->banner().sentence()));
        const Model written = importFile(bytesOf(path));
        const auto shelf = std::find_if(written.parts.begin(), written.parts.end(),
                                        [](const Part& part) { return part.name == "Shelf"; });
        QVERIFY(shelf != written.parts.end());
        const Color color = faceColor(*shelf, 0);
        QVERIFY(std::abs(color.r - 1.0F) < 0.01F && std::abs(color.g - 0.5F) < 0.01F && color.b < 0.01F);
        QTRY_VERIFY(line("out.step") != nullptr); // among the exports
        picture("tree-exports");
    }

    void aColorIsChosenInADialogAndUndone()
    {
        openExample("bracket.step", 10);
        clickLine(partLine(1));
        action("partColor")->trigger();
        auto* dialog = find<QColorDialog>("partColorDialog");
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(QColor(10, 200, 30));
        picture("tree-color");
        dialog->accept();
        QTRY_VERIFY(document().appearance().chosenColor(1).has_value());
        QCOMPARE(textOf(*document().appearance().chosenColor(1)), std::string("#0ac81e"));
        wait();
        drawn();
        picture("tree-colored");
        m_window->activateWindow();
        action("fileColor")->trigger();
        QTRY_VERIFY(!document().appearance().chosenColor(1).has_value());
        waitForGesture();
        action("undo")->trigger();
        QTRY_VERIFY(document().appearance().chosenColor(1).has_value());
        wait();
        action("undo")->trigger();
        QTRY_VERIFY(!document().appearance().chosenColor(1).has_value());
    }

    void toolsAndFixturesGetOtherNames()
    {
        openExample("bracket.step", 10);
        document().toggleFace(0, 0);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        rename(tree()->findItems("Fixture 1", Qt::MatchStartsWith | Qt::MatchRecursive).front(), "Foot");
        QTRY_COMPARE(snapshot().fixtures[0].name, std::string("Foot"));
        key(Qt::Key_B);
        QTRY_VERIFY(line("Block 1") != nullptr);
        waitForGesture();
        rename(line("Block 1"), "Left jaw");
        QTRY_COMPARE(snapshot().tools[0].name, std::string("Left jaw"));
        QTRY_VERIFY(line("Left jaw") != nullptr);
        waitForGesture();
        QCOMPARE(document().fixtures().list().front().faces.size(), std::size_t{1});
        action("undo")->trigger();
        QTRY_VERIFY(line("Block 1") != nullptr);
        wait();
        QCOMPARE(document().fixtures().list().front().faces.size(), std::size_t{1});
        document().renameTool(snapshot().tools[0].id, "");
        seen();
        QCOMPARE(snapshot().tools[0].name, std::string("Block 1"));
    }

    void theEyeHidesWithoutSelecting()
    {
        openExample("bracket.step", 10);
        clickLine(partLine(0));
        clickEye(partLine(1));
        QCOMPARE(hidden(), std::set<std::size_t>{1});
        QCOMPARE(document().selection(), (Selection{Selection::Kind::Body, 0}));
        picture("tree-hidden");
        clickEye(partLine(1));
        QVERIFY(hidden().empty());
    }

    void hiddenPartsAreNotPicked()
    {
        openExample("bracket.step", 10);
        key(Qt::Key_A, Qt::ControlModifier);
        key(Qt::Key_H);
        QCOMPARE(hidden().size(), std::size_t{2});
        key(Qt::Key_Escape);
        click(document().content().box.center());
        QVERIFY(document().selected().region().isEmpty());
    }

    void isolatingShowsOnePartAndThenAllAgain()
    {
        openExample("bracket.step", 10);
        clickLine(partLine(1));
        key(Qt::Key_H, Qt::ShiftModifier);
        QCOMPARE(hidden(), std::set<std::size_t>{0});
        picture("tree-isolated");
        key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(hidden().empty());
        key(Qt::Key_H, Qt::ShiftModifier);
        saveTo(file("isolated.knead"));
        newWindow(m_services);
        openProject(file("isolated.knead"));
        QCOMPARE(hidden(), std::set<std::size_t>{0});
        key(Qt::Key_H, Qt::ControlModifier);
        QVERIFY(hidden().empty());
    }

    void aToolThatIsClickedInTheTreeIsDrivenByKeysAtOnce()
    {
        openExample("bar.step", 10);
        key(Qt::Key_B);
        QTRY_VERIFY(line("Block 1") != nullptr);
        clickLine(partLine(0));
        QVERIFY(tree()->hasFocus()); // arrows go through the lines
        clickLine(line("Block 1"));
        QCOMPARE(QApplication::focusWidget(), &m_window->viewport());
        const double z = snapshot().tools[0].pose.position.z();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageDown);
        QTRY_VERIFY(snapshot().tools[0].pose.position.z() < z);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F2);
        QTRY_VERIFY(tree()->findChild<QLineEdit*>() != nullptr);
        QTest::keyClick(tree()->findChild<QLineEdit*>(), Qt::Key_Escape);
        QTRY_VERIFY(tree()->findChild<QLineEdit*>() == nullptr);
        clickLine(line("Block 1"));
        QCOMPARE(QApplication::focusWidget(), &m_window->viewport());
        const QRect part = tree()->visualItemRect(line("bar.step")); // its arrow folds it: the tool stays selected
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, QPoint(part.left() - 10, part.center().y()));
        QCOMPARE(document().selection().kind, Selection::Kind::Tool);
        QVERIFY(QApplication::focusWidget() != &m_window->viewport());
        const QPoint place = tree()->visualItemRect(line("Block 1")).center();
        QTest::mouseDClick(tree()->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseRelease(tree()->viewport(), Qt::LeftButton, {}, place);
        QTRY_VERIFY(tree()->findChild<QLineEdit*>() != nullptr && tree()->findChild<QLineEdit*>()->hasFocus());
    }

    void whatIsLockedCanBeReadToItsEnd()
    {
        openExample("bracket.step", 10);
        clickLine(partLine(0));
        auto* page = qobject_cast<QScrollArea*>(find<QStackedWidget>("properties")->currentWidget());
        QScrollBar* bar = page->verticalScrollBar();
        QTRY_VERIFY(bar->maximum() > 0);
        clickLock(partLine(0));
        QTRY_VERIFY(!page->widget()->isEnabled());
        auto* last = find<QWidget>("refill");
        QVERIFY(last->visibleRegion().isEmpty() && !last->isEnabled());
        for (int notch = 0; notch < 60 && bar->value() < bar->maximum(); ++notch) {
            const QPoint middle = page->viewport()->rect().center();
            QWidget* under = page->viewport()->childAt(middle);
            while (!under->isEnabled()) // that is where a wheel that nobody takes goes on to
                under = under->parentWidget();
            QWheelEvent wheel(under->mapFrom(page->viewport(), middle), page->viewport()->mapToGlobal(middle), {},
                              {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(under, &wheel);
        }
        QCOMPARE(bar->value(), bar->maximum());
        QVERIFY(!last->visibleRegion().isEmpty());
        picture("tree-locked-end");
        bar->setValue(0);
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->rect().center() + QPoint(0, bar->height() / 3));
        QVERIFY2(bar->value() > 0, "the bar itself can be clicked");
    }

    void whatIsLockedStaysAsItIs()
    {
        openExample("bracket.step", 10);
        clickLock(partLine(0));
        QVERIFY(document().isLocked({Selection::Kind::Body, 0}));
        clickLine(partLine(0));
        auto* page = qobject_cast<QScrollArea*>(find<QStackedWidget>("properties")->currentWidget());
        QVERIFY(!page->widget()->isEnabled());
        const Material before = snapshot().materials[0];
        document().post(SetMaterial{0, {.youngsModulus = 7e7}});
        QTRY_VERIFY(m_window->banner().sentence().contains("is locked"));
        picture("tree-locked");
        document().renamePart(0, "Other");
        document().toggleFace(0, 0);
        document().fixRegion(document().selected().region());
        seen();
        QVERIFY(snapshot().materials[0] == before && snapshot().fixtures.empty());
        QVERIFY(document().appearance().chosenName(0).empty());
        saveTo(file("locked.knead"));
        newWindow(m_services);
        openProject(file("locked.knead"));
        QVERIFY(document().isLocked({Selection::Kind::Body, 0}));
        clickLine(partLine(0));
        key(Qt::Key_L);
        QVERIFY(!document().isLocked({Selection::Kind::Body, 0}));
        document().post(SetMaterial{0, {.youngsModulus = 7e7}});
        QTRY_COMPARE(snapshot().materials[0].youngsModulus, 7e7);
    }

    void aLockedToolIsNotDragged()
    {
        openExample("bar.step", 10);
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        key(Qt::Key_F);
        rest();
        document().setLocked({Selection::Kind::Tool, 0}, true);
        ViewportWidget& view = m_window->viewport();
        const Vec3 start = snapshot().tools[0].pose.position;
        const QPoint from = view.widgetPosition(start)->toPoint();
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        QTest::mouseMove(&view, from + QPoint(60, 0));
        QTest::mouseMove(&view, from + QPoint(90, 0));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(90, 0));
        key(Qt::Key_Delete);
        seen();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().tools[0].pose.position, start);
        QVERIFY(m_window->banner().sentence().contains("Block 1"));
    }

    void partsAreDraggedIntoGroupsWhichAreKept()
    {
        openExample("bracket.step", 10);
        clickLine(partLine(1));
        key(Qt::Key_G, Qt::ControlModifier);
        QTRY_VERIFY(tree()->viewport()->findChild<QLineEdit*>() != nullptr); // its name is asked for
        auto* editor = tree()->viewport()->findChild<QLineEdit*>();
        editor->selectAll();
        QTest::keyClicks(editor, "Fasteners");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(line("Fasteners") != nullptr);
        QCOMPARE(partLine(1)->parent(), line("Fasteners"));
        // The other one by dragging.
        clickLine(partLine(0));
        const std::unique_ptr<QMimeData> data(tree()->model()->mimeData(tree()->selectionModel()->selectedIndexes()));
        tree()->scrollToItem(line("Fasteners"));
        const QPoint place = tree()->visualItemRect(line("Fasteners")).center();
        QDropEvent drop(place, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        (tree()->*(&Droppable::dropEvent))(&drop); // as an event it needs a drag that the system knows of
        QTRY_COMPARE(partLine(0)->parent(), line("Fasteners"));
        QCOMPARE(line("Fasteners")->childCount(), 2);
        picture("tree-groups");
        clickEye(line("Fasteners")); // hides both
        QCOMPARE(hidden().size(), std::size_t{2});
        clickEye(line("Fasteners"));
        QVERIFY(hidden().empty());
        QVERIFY2(m_window->isWindowModified(), "groups are worth saving");
        saveTo(file("grouped.knead"));
        newWindow(m_services);
        openProject(file("grouped.knead"));
        QVERIFY(line("Fasteners") != nullptr);
        QCOMPARE(line("Fasteners")->childCount(), 2);
        clickLine(line("Fasteners"));
        key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(line("Fasteners") == nullptr);
        QVERIFY(partLine(0) != nullptr && partLine(1) != nullptr);
    }

    void aSearchShowsWhatItFinds()
    {
        openExample("bracket.step", 10);
        key(Qt::Key_B);
        QTRY_VERIFY(line("Block 1") != nullptr);
        key(Qt::Key_F, Qt::ControlModifier);
        auto* search = find<QLineEdit>("modelSearch");
        QTRY_VERIFY(search->hasFocus());
        QTest::keyClicks(search, nameOf(1).left(4).toLower());
        QVERIFY(!partLine(1)->isHidden());
        QVERIFY(partLine(0)->isHidden());
        QVERIFY(line("Tools")->isHidden());
        picture("tree-search");
        QTest::keyClick(search, Qt::Key_Escape);
        QVERIFY(search->text().isEmpty());
        QVERIFY(!partLine(0)->isHidden() && !line("Block 1")->isHidden());
    }

    void aSetTakesWhatWasSelectedBeforeItsMenuCame()
    {
        openExample("bracket.step", 10);
        const Region both = united(regionOf(Level::Part, 0, {0}), regionOf(Level::Part, 1, {0}));
        document().keepSet("mine", regionOf(Level::Part, 0, {0}));
        document().selected().select(both);
        QTreeWidgetItem* item = line("mine");
        tree()->scrollToItem(item);
        const QPoint place = tree()->visualItemRect(item).center();
        QTest::mouseClick(tree()->viewport(), Qt::RightButton, {}, place);
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, tree()->viewport()->mapToGlobal(place));
        QApplication::sendEvent(tree()->viewport(), &event);
        QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        for (QAction* one : menu->actions())
            if (one->text() == "Keep the present selection here")
                one->trigger();
        menu->close();
        QCOMPARE(document().notes().set("mine")->items.size(), std::size_t{2});
        QCOMPARE(document().selected().region(), both);
    }

    void aSetIsNotShownAsSelectedWhenItIsNot()
    {
        openExample("bracket.step", 10);
        document().keepSet("faces", regionOf(Level::Face, 0, {0, 1}));
        clickLine(line("faces"));
        QCOMPARE(document().selected().region(), regionOf(Level::Face, 0, {0, 1}));
        QVERIFY(line("faces")->isSelected());
        document().selected().select(regionOf(Level::Face, 1, {0}));
        QVERIFY(!line("faces")->isSelected());
        QVERIFY(partLine(1)->isSelected());
    }

    void whatIsHiddenStaysSoInAnotherFilling()
    {
        openExample("bracket.step", 10);
        clickEye(partLine(1));
        m_window->features().imports->refill(document().size() / 14);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(hidden(), std::set<std::size_t>{1});
        QCOMPARE(partLine(1)->checkState(0), Qt::Unchecked);
        openExample("bracket.step", 10);
        QVERIFY(hidden().empty());
        QCOMPARE(partLine(1)->checkState(0), Qt::Checked);
    }

    void everyLineHasAMenu()
    {
        openExample("bracket.step", 10);
        document().keepSet("all", document().selected().region());
        tree()->scrollToItem(partLine(0));
        const auto menuOf = [&](QTreeWidgetItem* item) {
            QContextMenuEvent event(QContextMenuEvent::Mouse, tree()->visualItemRect(item).center(),
                                    tree()->viewport()->mapToGlobal(tree()->visualItemRect(item).center()));
            QApplication::sendEvent(tree()->viewport(), &event);
            return qobject_cast<QMenu*>(QApplication::activePopupWidget());
        };
        for (QTreeWidgetItem* item : {partLine(0), line("all")}) {
            QMenu* menu = menuOf(item);
            QVERIFY(menu != nullptr);
            QVERIFY(menu->actions().size() > 5);
            menu->close();
            QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
        }
    }

    void treeLooksGoodInTheDark()
    {
        m_window->features().preferences->setTheme(Theme::Dark);
        openExample("bracket.step", 10);
        document().notes().addGroup("Fasteners", {1});
        document().setLocked({Selection::Kind::Body, 0}, true);
        document().keepSet("Whole bracket", document().selected().region());
        document().notes().noteExport("/tmp/bracket-deformed.step", 1.79e9);
        document().toggleFace(1, 0);
        key(Qt::Key_B);
        QTRY_VERIFY(line("Block 1") != nullptr);
        m_window->resize(1280, 1000);
        rest();
        picture("tree-dark");
        m_window->features().preferences->setTheme(Theme::Light);
        drawn();
        picture("tree-light");
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowTreeTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_tree_test.moc"
