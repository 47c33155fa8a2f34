#pragma once

#include "app/cad_process.h"
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
#include <QPainter>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QVariantAnimation>
#include <QtTest>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
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

/// Reads each file of a folder once, as it comes, which takes half a second in a process of its own. What is chosen otherwise is read
/// anew.
inline ImportFiles readingOnce(ImportFiles import, const std::string& folder)
{
    static std::mutex mutex;
    static std::map<std::string, Model> known;
    return [import = std::move(import), folder](const std::vector<std::string>& paths, const ImportOptions& options,
                                                TaskControl& control) {
        if (paths.size() != 1 || !paths.front().starts_with(folder) || options != ImportOptions{})
            return import(paths, options, control);
        const std::lock_guard lock(mutex);
        const auto found = known.find(paths.front());
        if (found != known.end())
            return found->second;
        return known.emplace(paths.front(), import(paths, options, control)).first->second;
    };
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

    void show(const Services& services)
    {
        m_window = std::make_unique<MainWindow>(services);
        m_window->resize(windowSize());
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
        m_window->activateWindow(); // there may be no window manager that does it
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
    }

    /// Waits until no view turns any more and pictures show where they came to, which takes as long as the machine needs for them.
    void rest()
    {
        const auto turns = [&] {
            return std::ranges::any_of(m_window->findChildren<QVariantAnimation*>(), [](const auto* animation) {
                return animation->state() == QAbstractAnimation::Running;
            });
        };
        QVERIFY2(comesTrue([&] { return !turns(); }), "a view turns on and on");
        drawn();
    }

    /// Waits until the window is laid out and its views show all that was asked for, in full where time stands still.
    void drawn()
    {
        QCoreApplication::processEvents(); // what was posted may ask for more
        if (!document().isEmpty())
            seen();
        ViewportWidget& view = m_window->viewport();
        if (!view.isVisible())
            return;
        const QSignalSpy pictures(&view, &QOpenGLWidget::frameSwapped);
        view.update();
        const auto isBehind = [&] {
            const auto sides = m_window->findChildren<SideView*>();
            return view.isSketch() || std::ranges::any_of(sides, [](const SideView* side) {
                       return side->isVisible() && (side->isStale() || side->isSketch());
                   });
        };
        QVERIFY2(comesTrue([&] { return !pictures.isEmpty() && (document().isPlaying() || !isBehind()); }),
                 "the view is not drawn");
    }

    /// Waits until a frame shows what came of everything that was asked for.
    void seen()
    {
        const std::uint64_t asked = document().requests();
        QVERIFY2(comesTrue([&] { return document().hasSeen(asked); }), "no frame shows it");
    }

    void waitForTasks()
    {
        QVERIFY2(comesTrue([this] { return !m_window->tasks().isRunning(); }), "a task goes on and on");
    }

    /// Opens an example, filled coarsely so that it runs briskly on any machine.
    void openExample(const char* name, double cells = 16)
    {
        ImportChoices request;
        request.paths = {QFile::encodeName(example(name)).toStdString()};
        request.spacing = SpacingChoice{SpacingChoice::Kind::CellsAlong, cells};
        m_window->open(request);
        waitForTasks();
        QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
        lookWhereItTurns();
    }

    /// As a person does who finds the filling too fine: a second entry of the history.
    void openAndRefill(const char* name, double cells)
    {
        m_window->open(QStringList(example(name)));
        waitForTasks();
        QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
        m_window->features().imports->refill(document().size() / cells);
        waitForTasks();
        lookWhereItTurns();
    }

    /// The view need not turn to fit before a person's eyes.
    void lookWhereItTurns()
    {
        m_window->viewport().jumpTo(m_window->viewport().cameraAfterTurning());
        drawn();
    }

    /// What went wrong, as the banner says it; empty when nothing did. That numbers are rough is no problem but a warning.
    QString problem()
    {
        const QString said = m_window->banner().sentence();
        const auto* log = m_window->findChild<LogPanel*>();
        return log->toPlainText().contains("Warning: " + said) ? QString() : said;
    }

    /// Left-clicks the view where a place is seen.
    void click(const Vec3& place)
    {
        const std::optional<QPointF> position = m_window->viewport().widgetPosition(place);
        QVERIFY(position.has_value());
        QTest::mouseMove(&m_window->viewport(), position->toPoint());
        QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, position->toPoint());
    }

    /// A picture for people, when they ask for it.
    void picture(const char* name)
    {
        const QString folder = qEnvironmentVariable("KNEAD_PICTURES");
        if (folder.isEmpty())
            return;
        drawn(); // panels lie where they will
        QPixmap image = m_window->grab();
        QPainter painter(&image);
        for (QWidget* dialog : m_window->findChildren<QDialog*>()) // in front of it, wherever it lies
            if (dialog->isVisible())
                painter.drawPixmap((m_window->width() - dialog->width()) / 2,
                                   (m_window->height() - dialog->height()) / 2, dialog->grab());
        painter.end();
        image.save(QDir(folder).filePath(QString(name) + ".png"));
    }

    /// For pictures of other sizes: KNEAD_PICTURES_SIZE=1920x1080.
    static QSize windowSize()
    {
        const QStringList size = qEnvironmentVariable("KNEAD_PICTURES_SIZE", "1280x800").split('x');
        return {size.value(0).toInt(), size.value(1).toInt()};
    }

    static bool hasDisplay() { return QGuiApplication::platformName() != "offscreen"; }

    /// Who looks at the pictures that the view draws.
    enum class Eyes { none, open };

    /// Settings and recoveries of its own, so that those of a person stay as they are. Where nobody looks, edges are not smoothed,
    /// which takes a quarter of the time of a test on a machine without a graphics card.
    void prepare(Eyes eyes = Eyes::none)
    {
        QStandardPaths::setTestModeEnabled(true);
        static const QTemporaryDir state;
        qputenv("XDG_STATE_HOME", state.path().toUtf8());
        qputenv("XDG_CONFIG_HOME", state.path().toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, state.path());
        QApplication::setOrganizationName("knead-test");
        QApplication::setApplicationName("window-test");
        setCadProgram(KNEAD_PROGRAM);
        choosePreferences(eyes);
        m_services = fileServices();
        m_services.import = readingOnce(std::move(m_services.import), m_services.examplesFolder);
    }

    static void choosePreferences(Eyes eyes = Eyes::none)
    {
        QSettings().setValue("language", "en");
        QSettings().setValue("theme", "light");
        if (eyes == Eyes::none && qEnvironmentVariableIsEmpty("KNEAD_PICTURES"))
            QSettings().setValue("view/smoothing", 1);
    }
};

} // namespace knead
