#pragma once

#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/gui.h"
#include "support/skip.h"
#include "ui/frame/features.h"
#include "ui/frame/main_window.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"
#include "ui/viewport/side_view.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLineF>
#include <QPainter>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QVariantAnimation>
#include <QtTest>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knead {

constexpr int patience = 60'000; // [ms], for machines that do much else

/// Looks every few milliseconds whether something is so, and lets the window do its work in between. @return whether it came to be so.
/// Rounds are counted, not time: each takes as long as what is to be done in it.
template <class Condition>
bool comesTrue(const Condition& isSo)
{
    constexpr int round = 10; // [ms]
    for (int rounds = patience / round; rounds > 0 && !isSo(); --rounds)
        QTest::qWait(round);
    return isSo();
}

/// A window with helpers for tests that use it as a person does.
class WindowOnTest {
protected:
    Services m_services;
    std::unique_ptr<MainWindow> m_window;

    Document& document() { return m_window->document(); }
    const Snapshot& snapshot() { return *document().frame()->snapshot; }
    QAction* action(const char* name) { return m_window->findChild<QAction*>(name); }
    template <class Widget>
    Widget* find(const char* name)
    {
        return m_window->findChild<Widget*>(name);
    }

    QString example(const char* name) { return QDir(QString::fromStdString(m_services.examplesFolder)).filePath(name); }

    void show(const Services& services);

    /// Waits until no view turns any more and pictures show where they came to, which takes as long as the machine needs for them.
    void rest();

    /// Waits until the window is laid out and its views show all that was asked for, in full where time stands still.
    void drawn();

    /// Waits until a frame shows what came of everything that was asked for.
    void seen();

    void waitForTasks();

    /// Opens an example, filled coarsely so that it runs briskly on any machine.
    void openExample(const char* name, double cells = 16);

    /// As a person does who finds the filling too fine: a second entry of the history.
    void openAndRefill(const char* name, double cells);

    /// The view need not turn to fit before a person's eyes.
    void lookWhereItTurns();

    /// As a person does who has read it, where it lies over what is to be seen or clicked.
    void closeBanner();

    /// What went wrong, as the banner says it; empty when nothing did. That numbers are rough is no problem but a warning.
    QString problem();

    /// Left-clicks the view where a place is seen.
    void click(const Vec3& place);

    /// Whether a place is in the middle of what is free of the view, once that has come to rest.
    bool looksAt(const Vec3& place)
    {
        rest();
        const ViewportWidget& view = m_window->viewport();
        const std::optional<QPointF> seen = view.widgetPosition(place);
        const Insets taken = view.taken();
        const QPointF middle((view.width() + taken.left - taken.right) / 2,
                             (view.height() + taken.top - taken.bottom) / 2);
        return seen && QLineF(*seen, middle).length() < 0.1 * view.height();
    }

    /// Where "Show me" is in a row of a report; it is its last column.
    static QPoint showMeOf(const QTreeWidget& tree, QTreeWidgetItem& row)
    {
        return tree.visualRect(tree.model()->index(tree.indexOfTopLevelItem(&row), tree.columnCount() - 1)).center();
    }

    /// A picture for people, when they ask for it.
    void picture(const char* name);

    /// For pictures of other sizes: KNEAD_PICTURES_SIZE=1920x1080.
    static QSize windowSize();

    static bool hasDisplay() { return QGuiApplication::platformName() != "offscreen"; }

    /// Who looks at the pictures that the view draws.
    enum class Eyes { none, open };

    /// Settings and recoveries of its own, so that those of a person stay as they are. Where nobody looks, edges are not smoothed,
    /// which takes a quarter of the time of a test on a machine without a graphics card.
    void prepare(Eyes eyes = Eyes::none);

    static void choosePreferences(Eyes eyes = Eyes::none);
};

} // namespace knead
