#pragma once

#include "support/file_dialog_on_test.h"
#include "support/projects_on_test.h"
#include "support/window_watchdog.h"
#include "ui/interaction/gizmo_hand.h"
#include "ui/interaction/hands.h"
#include "ui/panels/quantity_field.h"

#include <QComboBox>
#include <QProcess>
#include <QScrollArea>

#include <cmath>
#include <limits>

namespace knead {

/// A person at the window from the first click to the last file: with mouse and keys only. Pictures are taken at each stage.
class StoryOnTest : public ProjectsOnTest {
protected:
    static constexpr double millimeter = 1e-3; // [m]
    static Vec3 at(double x, double y, double z) { return millimeter * Vec3(x, y, z); }

    ViewportWidget& view() { return m_window->viewport(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }

    /// Until the view has turned to where it was told to, and shows it.
    void waitForView() { rest(); }

    /// There may be no window manager that makes the window active again when a dialog is gone.
    void comeBack()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        view().setFocus();
    }

    // ---- Files ----

    /// Made ready before the dialog is asked for.
    void answerFileDialog(const QString& path) { new FileDialogAnswer(path, m_window.get()); }

    void openByHand(const QString& path)
    {
        answerFileDialog(path);
        key(Qt::Key_O, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty() && isIdle(), patience);
        waitForView();
        comeBack();
    }

    /// As STEP, with what is offered.
    void exportByHand(const QString& path)
    {
        answerFileDialog(path);
        key(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(find<QDialog>("exportDialog") != nullptr && find<QDialog>("exportDialog")->isVisible());
        drawn();
        picture((m_story + "-export-dialog").toUtf8());
        choose("exportFormat", "STEP", "STEP (.step)");
        QTest::keyClick(find<QDialog>("exportDialog"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path) && isIdle(), patience);
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
        comeBack();
    }

    /// What `knead info` says of a file.
    static QString info(const QString& path)
    {
        QProcess process;
        process.start(KNEAD_PROGRAM, {"info", path});
        process.waitForFinished(patience);
        return QString::fromUtf8(process.readAllStandardOutput() + process.readAllStandardError());
    }

    // ---- Numbers and commands ----

    /// Clicks a field of a panel, scrolled there, and types over what it shows.
    void type(const char* field, const QString& text)
    {
        auto* edit = find<QuantityField>(field);
        bring(edit, field);
        if (QTest::currentTestFailed())
            return;
        QTest::mouseClick(edit, Qt::LeftButton);
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

    /// Chooses from a list by its first letters.
    void choose(const char* list, const char* letters, const QString& whole)
    {
        auto* box = find<QComboBox>(list);
        bring(box, list);
        if (QTest::currentTestFailed())
            return;
        box->setFocus(Qt::TabFocusReason);
        QTest::qWait(2 * QApplication::keyboardInputInterval()); // what was typed before is forgotten
        QTest::keyClicks(box, letters);
        QTRY_COMPARE(box->currentText(), whole);
    }

    /// By its name, as one finds what has no key.
    void command(const char* letters)
    {
        comeBack();
        key(Qt::Key_K, Qt::ControlModifier);
        auto* field = find<QLineEdit>("paletteField");
        QTRY_VERIFY(field != nullptr && field->isVisible());
        QTest::keyClicks(field, letters);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(!field->isVisible());
    }

    /// Scrolls the panel to a field.
    void bring(QWidget* widget, const char* name)
    {
        QVERIFY2(widget != nullptr && widget->isVisible(), name);
        for (QWidget* around = widget->parentWidget(); around != nullptr; around = around->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(around))
                area->ensureWidgetVisible(widget);
    }

    // ---- Tools ----

    /// Added by its name, and selected.
    void addTool(const char* name)
    {
        const std::size_t before = snapshot().tools.size();
        command(name);
        QTRY_COMPARE(snapshot().tools.size(), before + 1);
        QTRY_COMPARE(document().selection(), (Selection{Selection::Kind::Tool, snapshot().tools.back().id}));
    }

    /// Where a ring of the selected tool can be taken: where no other handle is near.
    std::optional<QPoint> placeOf(GizmoPart ring)
    {
        std::optional<QPoint> place;
        const Gizmo handles = *m_window->hands().gizmo().gizmo();
        for (const Pixel& point : handles.ringLine(axisOf(ring)))
            if (const QPoint pixel(qRound(point.x), qRound(point.y));
                view().rect().contains(pixel) && handles.partAt({1.0 * pixel.x(), 1.0 * pixel.y()}) == ring)
                place = pixel;
        return place;
    }

    /// Turns the selected tool by its ring, by degrees that are typed.
    void turn(GizmoPart ring, const char* degrees)
    {
        const GizmoHand& hand = m_window->hands().gizmo();
        QVERIFY(hand.gizmo().has_value());
        std::optional<QPoint> place;
        QTRY_VERIFY2((QTest::mouseMove(&view(), placeOf(ring).value_or(QPoint())), QTest::qWait(50),
                      std::exchange(place, placeOf(ring)) == place && place),
                     "the ring cannot be taken");
        QTest::mouseMove(&view(), *place);
        QTest::mousePress(&view(), Qt::LeftButton, {}, *place);
        QVERIFY(hand.isDragging());
        QTest::keyClicks(&view(), degrees);
        QTest::keyClick(&view(), Qt::Key_Return);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, *place);
        QVERIFY(!hand.isDragging());
    }

    ToolState tool(std::size_t index)
    {
        return index < snapshot().tools.size() ? snapshot().tools[index] : ToolState();
    }

    void placeTool(std::size_t index, const Vec3& place)
    {
        constexpr const char* fields[] = {"toolPositionX", "toolPositionY", "toolPositionZ"};
        for (int axis = 0; axis < 3; ++axis)
            type(fields[axis], QString::number(place[axis] / millimeter) + " mm");
        QTRY_VERIFY((tool(index).pose.position - place).norm() < 1e-9);
    }

    /// Until something is so, or the simulation had to stop.
    template <class Condition>
    void waitUntil(Condition isSo)
    {
        QTRY_VERIFY_WITH_TIMEOUT(isSo() || !snapshot().health.ok, patience);
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
    }

    /// Holds a key until something is so.
    template <class Condition>
    void hold(Qt::Key held, Condition until)
    {
        QTest::keyPress(&view(), held);
        waitUntil(until);
        QTest::keyRelease(&view(), held);
    }

    void play()
    {
        view().setFocus(); // in a field the bar is a letter
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
    }
    void pause()
    {
        view().setFocus();
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        waitForGesture();
    }

    // ---- Places of the material ----

    /// The vertex of the first body that lies nearest to a place at rest.
    std::size_t vertexAt(const Vec3& place)
    {
        const std::vector<Vec3>& vertices = document().content().bodies[0]->mesh.vertices;
        std::size_t nearest = 0;
        for (std::size_t v = 1; v < vertices.size(); ++v)
            if ((vertices[v] - place).norm() < (vertices[nearest] - place).norm())
                nearest = v;
        return nearest;
    }
    Vec3 placeOf(std::size_t vertex) { return document().frame()->bodies[0]->places[vertex]; }
    Vec3 moveOf(std::size_t vertex) { return placeOf(vertex) - document().content().bodies[0]->mesh.vertices[vertex]; }

    // ---- The story ----

    void prepareStories()
    {
        prepare();
        if (const QString theme = qEnvironmentVariable("KNEAD_PICTURES_THEME"); !theme.isEmpty())
            QSettings().setValue("theme", theme);
        begin(); // graphics, fonts and code are loaded once, for which it may take twice as long
        watched().clear();
        openByHand(example("bar.step"));
        watched().say("the first part is open");
        QVERIFY2(watched().longest().time < 2 * longestAnswer(), qPrintable(watched().longest().what));
        m_window.reset();
    }

    void beginStory(const char* name)
    {
        m_story = name;
        m_stage = 0;
        m_busiest = {};
        begin();
        watched().clear();
        stage("empty");
    }

    /// Something has been done: a picture of it, and a look at how long the window was busy.
    void stage(const char* what)
    {
        const QString name = QStringLiteral("%1-%2-%3").arg(m_story).arg(m_stage++).arg(what);
        look(name);
        picture(name.toUtf8());
        watched().clear(); // the picture is the test's
    }

    void endStory()
    {
        look("the end");
        QVERIFY2(m_busiest.time < longestAnswer(),
                 qPrintable(QStringLiteral("%1 ms: %2").arg(1000 * m_busiest.time, 0, 'f', 1).arg(m_busiest.what)));
    }

private:
    static WatchedApplication& watched() { return *static_cast<WatchedApplication*>(qApp); }

    void look(const QString& until)
    {
        const WatchedApplication::Longest& longest = watched().longest();
        watched().say(until);
        if (longest.time > m_busiest.time)
            m_busiest = {longest.time, "until " + until + ": " + longest.what};
    }

    WatchedApplication::Longest m_busiest;
    QString m_story;
    int m_stage = 0;
};

} // namespace knead
