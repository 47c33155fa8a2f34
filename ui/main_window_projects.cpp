// Projects in the main window: title, recent files, saving, and what is asked before work would be lost.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/panels/banner.h"
#include "ui/panels/home_page.h"
#include "ui/panels/log_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/project/recent_files.h"

#include <QAction>
#include <QCloseEvent>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>

namespace knead {

namespace {

constexpr int shownTime = 4000; // of a sentence in the status bar [ms]

} // namespace

void MainWindow::makeProjects()
{
    m_projects =
        std::make_unique<ProjectKeeper>(m_services.projects, m_services.packing,
                                        ProjectKeeper::Window{this, m_document, m_tasks, *m_viewport, *m_tree});
    const ProjectKeeper* keeper = m_projects.get();
    connect(keeper, &ProjectKeeper::changed, this, &MainWindow::showTitle);
    connect(keeper, &ProjectKeeper::problem, this, &MainWindow::showProblem);
    connect(keeper, &ProjectKeeper::opening, m_banner, &QWidget::hide);
    connect(keeper, &ProjectKeeper::told, this, [this](const QString& sentence) {
        m_log->add(sentence);
        statusBar()->showMessage(sentence, shownTime);
    });
    connect(keeper, &ProjectKeeper::recentChanged, this, &MainWindow::listRecent);
    connect(keeper, &ProjectKeeper::perspectiveRestored, m_actions->perspective, &QAction::setChecked);
    connect(m_actions->save, &QAction::triggered, this, [this] { m_projects->save(); });
    connect(m_actions->saveAs, &QAction::triggered, this, [this] { m_projects->saveAs(); });
    connect(m_actions->recover, &QAction::triggered, this, [this] { m_projects->offerRecoveries(true); });
    listRecent();
}

void MainWindow::showTitle()
{
    const QString name = m_projects->name();
    setWindowTitle(name.isEmpty() ? tr("Knead") : tr("%1[*] - Knead").arg(name));
    setWindowModified(m_projects->isModified());
}

void MainWindow::offerRecoveries()
{
    m_projects->offerRecoveries(false);
}

/// What was clicked is gone with the list, so clicks are answered later.
void MainWindow::listRecent()
{
    m_recent->clear();
    const QStringList paths = recent_files::list();
    for (const QString& path : paths) {
        QAction* action = m_recent->addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        connect(
            action, &QAction::triggered, this, [this, path] { openRecent(path); }, Qt::QueuedConnection);
    }
    m_recent->addSeparator();
    const auto forget = [this] {
        recent_files::clear();
        listRecent();
    };
    connect(m_recent->addAction(tr("Clear the list")), &QAction::triggered, this, forget, Qt::QueuedConnection);
    m_recent->setEnabled(!paths.isEmpty());
    m_home->showRecent(paths);
}

void MainWindow::openRecent(const QString& path)
{
    if (QFileInfo::exists(path)) {
        openInstead({path});
        return;
    }
    recent_files::remove(path);
    listRecent();
    showProblem(tr("%1 is not there any more. It may have been moved: look for it with Ctrl+O.").arg(path));
}

void MainWindow::openInstead(const QStringList& paths)
{
    m_projects->letGo([this, paths] { open(paths); });
}

/// @return whether they were a matter of projects
bool MainWindow::openedAsProject(const QStringList& paths)
{
    const auto isProject = [this](const QString& path) { return m_projects->isProject(path); };
    if (std::none_of(paths.begin(), paths.end(), isProject))
        return false;
    if (paths.size() == 1)
        m_projects->open({.path = QFile::encodeName(paths.front()).toStdString()});
    else
        showProblem(tr("A project is opened alone: choose one file, or only parts."));
    return true;
}

/// A part with nothing saved yet.
void MainWindow::openPrepared(PreparedContent prepared)
{
    m_projects->open(std::move(prepared));
    for (const std::string& path : m_document.content().request.paths) {
        recent_files::add(QFile::decodeName(path.c_str()));
        keepPicture(QFileInfo(QFile::decodeName(path.c_str())).absoluteFilePath());
    }
    listRecent();
}

/// First what is not saved is asked about, and then the window closes by itself.
void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_projects->mayGo() && !m_mayClose) {
        event->ignore();
        m_projects->letGo([this] {
            m_mayClose = true;
            close();
        });
        return;
    }
    m_tasks.cancel();
    m_projects->close();
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    settings.setValue("docks", saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

} // namespace knead
