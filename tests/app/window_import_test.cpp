#include "support/window_on_test.h"
#include "support/window_watchdog.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/panels/model_tree_delegate.h"
#include "ui/run_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

using namespace knead;

namespace {

/// A text STL of triangles, in millimetres.
QByteArray stl(const std::vector<std::array<Vec3, 3>>& triangles)
{
    QByteArray text = "solid test\n";
    for (const auto& triangle : triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const Vec3& v : triangle)
            text += QStringLiteral("vertex %1 %2 %3\n").arg(v.x()).arg(v.y()).arg(v.z()).toLatin1();
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid test\n";
}

/// The sides of a box; without its lid when open.
std::vector<std::array<Vec3, 3>> box(double side, bool isOpen)
{
    std::vector<std::array<Vec3, 3>> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            if (isOpen && axis == 2 && upper)
                continue;
            Vec3 corner = Vec3::Zero();
            corner[axis] = upper ? side : 0;
            Vec3 u = Vec3::Zero();
            Vec3 v = Vec3::Zero();
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = side;
            if (!upper)
                std::swap(u, v);
            triangles.push_back({corner, corner + u, corner + u + v});
            triangles.push_back({corner, corner + u + v, corner + v});
        }
    return triangles;
}

} // namespace

/// Opening files as a person does: dialog, report, banner, drops, and what goes wrong.
class WindowImportTest : public QObject, WindowOnTest {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString write(const char* name, const QByteArray& content)
    {
        const QString path = m_folder.filePath(name);
        QFile file(path);
        if (file.open(QFile::WriteOnly))
            file.write(content);
        return path;
    }

    void openAndWait(const QStringList& paths)
    {
        m_window->open(paths);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
    }

    ImportDialog* dialogFor(const QString& path)
    {
        m_window->features().imports->openWithChoices({path});
        const auto hasDialog = [this] { return find<ImportDialog>("importDialog") != nullptr; };
        if (!QTest::qWaitFor(hasDialog, patience))
            return nullptr;
        drawn();
        return find<ImportDialog>("importDialog");
    }

    QString report() { return find<QTextBrowser>("importRemarks")->toPlainText(); }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(Eyes::open);
        m_services.import = importInChildren; // each time anew: reading is what is looked at
    }

    void init() { show(m_services); }

    void cleanup() { m_window.reset(); }

    void theDialogShowsWhatAFileHoldsAndOpensWhatIsChosen()
    {
        ImportDialog* dialog = dialogFor(example("bracket.step"));
        QVERIFY(dialog != nullptr);
        QVERIFY(dialog->findChild<QLabel*>("importFacts")->text().startsWith("STEP AP214, "));
        auto* parts = dialog->findChild<QTreeWidget*>("importParts");
        QVERIFY(parts != nullptr);
        QTreeWidgetItem* last = parts->topLevelItem(parts->topLevelItemCount() - 1);
        while (last->childCount() > 0)
            last = last->child(last->childCount() - 1);
        const QString name = last->text(0);
        picture("import-dialog");

        // Nothing chosen: nothing to open.
        QTest::mouseClick(dialog->findChild<QToolButton*>("importNone"), Qt::LeftButton);
        QVERIFY(!dialog->findChild<QPushButton*>("importOpen")->isEnabled());
        const QRect place = parts->visualItemRect(last);
        QTest::mouseClick(parts->viewport(), Qt::LeftButton, {}, {place.left() + 8, place.center().y()});
        QCOMPARE(last->checkState(0), Qt::Checked);
        dialog->findChild<QComboBox*>("importFineness")->setCurrentIndex(2);
        dialog->findChild<QSpinBox*>("importCells")->setValue(2);
        QTest::mouseClick(dialog->findChild<QPushButton*>("importOpen"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && !document().isEmpty(), patience);
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(document().content().bodies[0]->name), name);
        QVERIFY(std::abs(document().content().fineness.cellsAcrossWall - 2) < 0.01);
    }

    void escapeLeavesTheDialogAndTheDocument()
    {
        openExample("bar.step");
        const auto model = document().content().model;
        ImportDialog* dialog = dialogFor(example("bracket.step"));
        QVERIFY(dialog != nullptr);
        QTest::keyClick(dialog, Qt::Key_Escape);
        QTRY_VERIFY(find<ImportDialog>("importDialog") == nullptr);
        QVERIFY(!m_window->tasks().isRunning());
        QCOMPARE(document().content().model, model);
    }

    void filesDroppedTogetherAreOneAssembly()
    {
        QWidget other; // where the files come from
        other.show();
        other.activateWindow();
        QTRY_VERIFY(other.isActiveWindow());
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(example("bar.step")), QUrl::fromLocalFile(example("bracket.step")),
                      QUrl::fromLocalFile(write("no.step", "this is no part"))});
        QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &drop);
        QTRY_VERIFY(m_window->isActiveWindow());
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        QCOMPARE(document().content().model->tree.children.size(), std::size_t{2});
        // The third one is not lost without a word.
        QVERIFY(m_window->banner().sentence().startsWith("no.step: "));
        QVERIFY(report().contains("no.step: "));
        picture("several");
    }

    void aDoubtfulUnitIsCorrectedWithOneClick()
    {
        openAndWait({write("tiny.stl", stl(box(0.05, false)))});
        QVERIFY(m_window->banner().sentence().contains("0.05 mm long"));
        QVERIFY(report().contains("0.05 mm long"));
        auto* remedy = find<QToolButton>("bannerRemedy");
        QCOMPARE(remedy->text(), QString("Take as m"));
        QTest::mouseClick(remedy, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(std::abs(document().size() - 0.05) < 1e-6);
        QVERIFY(m_window->banner().sentence().isEmpty());
        QCOMPARE(find<QComboBox>("takenUnit")->currentText(), QString("m"));
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
    }

    void whatIsOpenIsShownWithTheReason()
    {
        openAndWait({write("open.stl", stl(box(50, true)))});
        QVERIFY(!document().isEmpty());
        QVERIFY(document().content().bodies.empty());
        QCOMPARE(document().content().surfaces.size(), std::size_t{1});
        QVERIFY(m_window->banner().sentence().contains("Nothing in this file is closed"));
        QVERIFY(report().contains("open edges"));
        QVERIFY(!action("play")->isEnabled() && !action("export")->isEnabled() && action("fit")->isEnabled());
        QVERIFY(!document().content().model->parts[0].openEdges.empty());
        rest();
        picture("open-surface");
        const QImage seen = m_window->viewport().grabFramebuffer();
        QVERIFY(seen.pixelColor(5, 5).lightness() > 200); // the light ground above the part
        QVERIFY(seen.pixelColor(seen.rect().center()).lightness() < 200);

        // Where it ends is shown, by the mouse and by keys.
        const Vec3 opening(0.025, 0.025, 0.05);
        auto* remarks = find<QTextBrowser>("importRemarks");
        auto* shown = find<MarksOverlay>("shownPlace");
        for (const bool byKeys : {false, true}) {
            m_window->viewport().jumpTo(Camera());
            QVERIFY(!looksAt(opening));
            QVERIFY(!shown->isVisible());
            if (byKeys) {
                remarks->setFocus();
                QTest::keyClick(remarks, Qt::Key_Tab);
                QTest::keyClick(remarks, Qt::Key_Return);
            } else {
                QTextCursor link = remarks->document()->find("Show me");
                QVERIFY(!link.isNull());
                link.setPosition(link.position() - 2); // in its midst, and nothing is selected
                remarks->setTextCursor(link);
                remarks->ensureCursorVisible();
                QTest::mouseClick(remarks->viewport(), Qt::LeftButton, {}, remarks->cursorRect(link).center());
            }
            QVERIFY2(shown->isVisible(), byKeys ? "by keys" : "by the mouse");
            QVERIFY(looksAt(opening));
            picture("shown-opening");
            QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, QPoint(20, m_window->viewport().height() / 2));
            QVERIFY(!shown->isVisible());
        }

        // Its opening is flat, so a person may have it closed.
        QVERIFY(find<QPushButton>("fillOpen")->isVisible());
        QTest::mouseClick(find<QPushButton>("fillOpen"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(document().content().bodies.size(), std::size_t{1});
        QVERIFY(std::abs(document().content().model->parts[0].volume - 1.25e-4) < 1e-9);
        QVERIFY(report().contains("Repaired: "));
        QVERIFY(action("play")->isEnabled());
    }

    void hiddenPartsStayHiddenUntilTheyAreChecked()
    {
        Services services = m_services;
        services.import = [import = m_services.import](const std::vector<std::string>& paths,
                                                       const ImportOptions& options, TaskControl& control) {
            Model model = import(paths, options, control);
            model.parts.back().visible = false;
            return model;
        };
        show(services);
        openAndWait({example("bracket.step")});
        const std::size_t hidden = document().content().model->parts.size() - 1;
        QVERIFY(m_window->viewport().options().hiddenParts.contains(hidden));
        auto* tree = find<QTreeWidget>("modelTree");
        QTreeWidgetItem* unchecked = nullptr;
        for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it)
            if (((*it)->flags() & Qt::ItemIsUserCheckable) != 0 && (*it)->checkState(0) == Qt::Unchecked)
                unchecked = *it;
        QVERIFY(unchecked != nullptr);
        tree->scrollToItem(unchecked);
        const QRect place = tree->visualItemRect(unchecked);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, ModelTreeDelegate::eyeRect(place).center());
        QVERIFY(m_window->viewport().options().hiddenParts.empty());
    }

    void aCrashOfTheReaderIsASentenceAndChangesNothing()
    {
        openExample("bar.step");
        const auto model = document().content().model;
        const QString reader = write("reader.sh", "#!/bin/sh\necho '500000 making shapes' >&3\nkill -SEGV $$\n");
        QFile::setPermissions(reader, QFile::ReadOwner | QFile::ExeOwner);
        setCadProgram(reader.toStdString());
        openAndWait({example("bracket.step")});
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        QCOMPARE(m_window->banner().sentence(),
                 QString("bracket.step: the reader crashed while making shapes (memory access). Nothing was imported; "
                         "export the file again, best as STEP."));
        QCOMPARE(document().content().model, model);
    }

    /// The window's thread is never busy for longer than a person notices, from the click to the part on the screen. Drawing
    /// does not count, it is told apart: here the processor does the work of a graphics card.
    void theWindowAnswersAllThroughAnImport()
    {
        openExample("bar.step"); // graphics and fonts are loaded
        auto& watched = *static_cast<WatchedApplication*>(qApp);
        watched.clear();
        openAndWait({example("handle.step"), example("bracket.step")});
        rest();
        QCOMPARE(document().content().model->tree.children.size(), std::size_t{2});
        watched.say("both parts are on the screen");
        QVERIFY2(watched.longest().time < longestAnswer(), qPrintable(watched.longest().what));
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    WatchedApplication application(argc, argv);
    WindowImportTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_import_test.moc"
