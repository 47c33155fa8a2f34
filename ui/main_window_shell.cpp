// What the main window offers around the work: preferences, language and theme, keys, the command palette, panels, tour, about.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/language/language.h"
#include "ui/panels/home_page.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/simulation_panel.h"
#include "ui/panels/status_readings.h"
#include "ui/project/project_keeper.h"
#include "ui/selection_actions.h"
#include "ui/shell/about_dialog.h"
#include "ui/shell/command_palette.h"
#include "ui/shell/preferences_dialog.h"
#include "ui/shell/shortcuts.h"
#include "ui/shell/system_theme.h"
#include "ui/shell/thumbnails.h"
#include "ui/shell/tour.h"
#include "ui/viewport/view_grid.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

namespace knead {

namespace {

constexpr const char* tourSeen = "tour/seen";
constexpr const char* selectionBarShown = "selectionBar/shown";
constexpr int pictureDelay = 1500; // until a part that was opened is in view [ms]

} // namespace

/// What the window's other parts need not know.
struct MainWindow::Shell {
    SystemTheme* system = nullptr;
    Shortcuts* shortcuts = nullptr;
    CommandPalette* palette = nullptr;
    QPointer<PreferencesDialog> dialog;
    QPointer<Tour> tour;
    QByteArray layout; ///< of panels, as it came
};

MainWindow::ShellPointer MainWindow::newShell()
{
    ShellPointer shell(new Shell, [](Shell* gone) {
        delete gone->dialog; // it asks for the window's actions to the end
        delete gone->tour;
        delete gone;
    });
    shell->system = new SystemTheme(this);      // before any theme is applied
    speak(languageFor(m_preferences.language)); // before anything is said
    setLengthUnit(m_preferences.lengthUnit);
    return shell;
}

/// After all panels, menus and actions are there.
void MainWindow::makeShell()
{
    listPanels();
    for (const char* dock : {"measureDock", "probeDock", "forcesDock"}) // come with what one does for the first time
        findChild<QDockWidget*>(dock)->hide();
    m_shell->layout = saveState();
    m_shell->shortcuts = new Shortcuts(*this);
    m_shell->palette = new CommandPalette(*this, [this](const QAction& action) { return whyDisabled(action); });
    const Actions& a = *m_actions;
    const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
    on(a.palette, [this] { m_shell->palette->open(); });
    on(a.preferences, [this] { showPreferences(PreferencesDialog::Page::General); });
    on(a.shortcuts, [this] { showPreferences(PreferencesDialog::Page::Keys); });
    on(a.resetLayout, &MainWindow::resetLayout);
    on(a.fullScreen, [this](bool isFull) { isFull ? showFullScreen() : showNormal(); });
    on(a.tour, &MainWindow::showTour);
    on(a.lightTheme, [this] { chooseLook(Preferences::Look::Light); });
    on(a.darkTheme, [this] { chooseLook(Preferences::Look::Dark); });
    on(a.systemTheme, [this] { chooseLook(Preferences::Look::System); });
    connect(m_shell->system, &SystemTheme::changed, this, &MainWindow::applyLook);
    connect(m_home, &HomePage::recoverClicked, this, [this] { m_projects->offerRecoveries(true); });
    connect(m_projects.get(), &ProjectKeeper::recoveriesWaiting, m_home, &HomePage::showWaiting);
    connect(m_projects.get(), &ProjectKeeper::shown, this, [this] { keepPicture(m_projects->path()); });
    connect(findChild<QSpinBox*>("historyMemoryAllowed"), &QSpinBox::valueChanged, this, [this] {
        if (m_shell->dialog != nullptr)
            m_shell->dialog->setPreferences(readPreferences());
    });
    keepHintClear();
}

// --- panels ---------------------------------------------------------------------------------------------------------------

/// Every dock and bar can be closed and comes back from here.
void MainWindow::listPanels()
{
    auto* panels = findChild<QMenu*>("panelsMenu");
    panels->clear();
    for (QDockWidget* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        QAction* toggle = dock->toggleViewAction();
        toggle->setObjectName("show_" + dock->objectName());
        panels->addAction(toggle);
    }
    panels->addSeparator();
    for (const QToolBar* bar : findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        QAction* toggle = bar->toggleViewAction();
        toggle->setObjectName("show_" + bar->objectName());
        panels->addAction(toggle);
    }
    listSelectionBar(*panels);
    panels->addSeparator();
    panels->addAction(m_actions->resetLayout);
}

/// The bar beside the view comes and goes with the view, unless a person does not want it.
void MainWindow::listSelectionBar(QMenu& panels)
{
    auto* bar = findChild<QToolBar*>("selectionBar");
    QAction* toggle = bar->toggleViewAction();
    toggle->setObjectName("show_selectionBar");
    panels.addAction(toggle);
    connect(toggle, &QAction::triggered, this, [](bool on) { QSettings().setValue(selectionBarShown, on); });
    const auto follow = [this] { showSelectionBar(m_pages->currentWidget() == m_views); };
    connect(m_pages, &QStackedWidget::currentChanged, this, follow);
    follow();
}

void MainWindow::showSelectionBar(bool isView)
{
    auto* bar = findChild<QToolBar*>("selectionBar");
    bar->toggleViewAction()->setEnabled(isView);
    bar->setVisible(isView && QSettings().value(selectionBarShown, true).toBool());
}

void MainWindow::resetLayout()
{
    restoreState(m_shell->layout);
    sizeDocks();
}

/// A message in the status bar and the hint share a place: one at a time.
void MainWindow::keepHintClear()
{
    const auto showHintWhenFree = [this] {
        m_hint->setVisible(!m_tasks.isRunning() && statusBar()->currentMessage().isEmpty());
    };
    connect(&m_tasks, &TaskRunner::started, statusBar(), &QStatusBar::clearMessage);
    connect(&m_tasks, &TaskRunner::started, m_hint, &QWidget::hide);
    connect(&m_tasks, &TaskRunner::finished, this, showHintWhenFree);
    connect(statusBar(), &QStatusBar::messageChanged, this, showHintWhenFree);
}

// --- preferences ----------------------------------------------------------------------------------------------------------

void MainWindow::showPreferences(PreferencesDialog::Page page)
{
    if (m_shell->dialog == nullptr) {
        m_shell->dialog = new PreferencesDialog(readPreferences(), *m_shell->shortcuts, *this);
        m_shell->dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_shell->dialog, &PreferencesDialog::changed, this, &MainWindow::setPreferences);
    }
    m_shell->dialog->show(page);
}

/// Whatever is chosen holds at once.
void MainWindow::setPreferences(const Preferences& now)
{
    const Preferences before = std::exchange(m_preferences, now);
    writePreferences(now);
    applyPreferences();
    if (now.look != before.look)
        applyLook();
    if (now.language != before.language)
        speak(languageFor(now.language));
    if (now.language != before.language || now.lengthUnit != before.lengthUnit)
        sayAllAnew();
}

void MainWindow::applyPreferences()
{
    const auto bytes = [](int megabytes) { return static_cast<std::size_t>(megabytes) << 20U; };
    setLengthUnit(m_preferences.lengthUnit);
    findChild<QLabel*>("units")->setText(m_preferences.lengthUnit + ", N, MPa");
    findChild<QSpinBox*>("historyMemoryAllowed")->setValue(m_preferences.historyMegabytes);
    m_document.setFilmMemory(bytes(m_preferences.filmMegabytes));
    m_projects->setKeepingInterval(m_preferences.keepingInterval);
    if (m_services.limitThreads)
        m_services.limitThreads(static_cast<unsigned>(m_preferences.threads));
    m_simulation->showThreads(m_preferences.threads);
    m_views->setSamples(m_preferences.smoothing);
    m_viewport->setTurningSmoothly(m_preferences.turnsSmoothly);
}

void MainWindow::chooseLook(Preferences::Look look)
{
    Preferences chosen = readPreferences();
    chosen.look = look;
    setPreferences(chosen);
    if (m_shell->dialog != nullptr)
        m_shell->dialog->setPreferences(chosen);
}

void MainWindow::chooseThreads(int threads)
{
    Preferences chosen = readPreferences();
    chosen.threads = threads;
    setPreferences(chosen);
    if (m_shell->dialog != nullptr)
        m_shell->dialog->setPreferences(chosen);
}

void MainWindow::setTheme(Theme theme)
{
    chooseLook(theme == Theme::Dark ? Preferences::Look::Dark : Preferences::Look::Light);
}

void MainWindow::applyLook()
{
    const Preferences::Look look = m_preferences.look;
    const bool isDark =
        look == Preferences::Look::Dark || (look == Preferences::Look::System && m_shell->system->isDark());
    applyTheme(*qApp, isDark ? Theme::Dark : Theme::Light);
    m_viewport->setStyle(isDark ? darkScene() : lightScene());
    QAction* const actions[] = {m_actions->lightTheme, m_actions->darkTheme, m_actions->systemTheme};
    actions[static_cast<std::size_t>(look)]->setChecked(true);
}

/// After another language or unit: what was put together of texts and numbers, and what is drawn.
void MainWindow::sayAllAnew()
{
    applyLook();
    showTitle();
    showHint();
    listRecent();
    for (QuantityField* field : findChildren<QuantityField*>())
        field->setValue(field->value());
    QEvent anew(QEvent::LanguageChange); // for those who put words and numbers together; a language sends another one
    QApplication::sendEvent(this, &anew);
    if (m_document.isEmpty())
        return;
    for (const Document::Change what :
         {Document::Change::Frame, Document::Change::Selection, Document::Change::Fixtures, Document::Change::Moment})
        emit m_document.changed(what);
}

/// Why an action cannot be done now. Whoever makes an action can say it in its property "whyDisabled".
QString MainWindow::whyDisabled(const QAction& action) const
{
    const Actions& a = *m_actions;
    const QString own = action.property("whyDisabled").toString();
    if (!own.isEmpty())
        return own;
    if (&action == a.undo)
        return tr("There is nothing to undo.");
    if (&action == a.redo)
        return tr("There is nothing to redo.");
    if (m_document.isEmpty())
        return tr("Open a part first.");
    if (m_document.content().bodies.empty())
        return tr("Nothing in this part is closed, so nothing can be simulated.");
    if (&action == a.step)
        return tr("Pause first.");
    if (&action == a.pressIt)
        return tr("Only a part to which nothing was done yet is pressed like this.");
    if (&action == a.remove)
        return tr("Select a tool or a fixture first.");
    const SelectionActions& s = *m_selection;
    if (QList<const QAction*>{s.within, s.keep, s.fix, s.renormalize, s.glue}.contains(&action))
        return tr("Select something first.");
    return tr("Not possible now.");
}

// --- pictures, tour, about ------------------------------------------------------------------------------------------------

/// For the first page, once the view has turned to it. It is a full picture, for which who turns the view does not wait.
void MainWindow::keepPicture(const QString& path)
{
    QTimer::singleShot(pictureDelay, this, [this, path, document = m_document.history().documentNumber()] {
        if (m_document.isEmpty() || !m_viewport->isVisible() || m_document.history().documentNumber() != document)
            return;
        if (m_viewport->isInMotion())
            keepPicture(path);
        else
            thumbnails::keep(path, m_viewport->portrait());
    });
}

/// At the first start.
void MainWindow::offerTour()
{
    if (QSettings().value(tourSeen).toBool())
        return;
    QTimer::singleShot(0, this, &MainWindow::showTour);
}

void MainWindow::showTour()
{
    QSettings().setValue(tourSeen, true);
    if (m_shell->tour == nullptr)
        m_shell->tour = new Tour(*this, windowTour(*this));
    m_shell->tour->begin();
}

void MainWindow::showAbout()
{
    auto* about = new AboutDialog(m_services.libraries, this);
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->open();
}

} // namespace knead
