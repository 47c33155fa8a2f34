#include "ui/project/projects_feature.h"

#include "core/session/filled_model.h"
#include "ui/commands/availability.h"
#include "ui/commands/listed_actions.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/recent_files.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/panels/home_page.h"
#include "ui/panels/model_tree.h"
#include "ui/project/project_keeper.h"
#include "ui/project/thumbnails.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>
#include <ranges>
#include <utility>

namespace knead {

namespace {

constexpr int shownTime = 4000;    // of a sentence in the status bar [ms]
constexpr int pictureDelay = 1500; // until a part that was opened is in view [ms]

} // namespace

ProjectsFeature::Actions::Actions(QWidget& window)
    : save(makeAction(window, {"save", QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S",
                               QT_TRANSLATE_NOOP("Actions", "Keep part, history and view in a project file")}))
    , saveAs(makeAction(window, {"saveAs", QT_TRANSLATE_NOOP("Actions", "Save &as..."), nullptr, "Ctrl+Shift+S",
                                 QT_TRANSLATE_NOOP("Actions", "Keep the project in another file and go on with that")}))
    , recover(makeAction(window, {"recover", QT_TRANSLATE_NOOP("Actions", "Recover &unsaved work..."), nullptr, "",
                                  QT_TRANSLATE_NOOP("Actions", "Look for work that was not saved when Knead ended")}))
    , close(makeAction(window, {"closePart", QT_TRANSLATE_NOOP("Actions", "C&lose"), nullptr, "Ctrl+W",
                                QT_TRANSLATE_NOOP("Actions", "Back to the first page with nothing open; what is not "
                                                             "saved is asked about")}))
{
}

ProjectsFeature::ProjectsFeature(const Workbench& bench, ModelTree& tree, HomePage& home, QAction& perspective)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_home(home)
    , m_recent(*new QMenu(tr("Open &recent"), &bench.window))
    , m_examples(*new QMenu(tr("E&xamples"), &bench.window))
    , m_keeper(std::make_unique<ProjectKeeper>(
          bench.services.projects, bench.services.packing,
          ProjectKeeper::Window{&bench.window, bench.document, bench.tasks, bench.viewport, tree}))
{
    m_recent.setObjectName("recentMenu");
    m_recent.setToolTipsVisible(true);
    m_examples.setObjectName("examplesMenu");
    home.fillExamples(m_examples);
    const ProjectKeeper* keeper = m_keeper.get();
    connect(keeper, &ProjectKeeper::changed, this, &ProjectsFeature::showTitle);
    connect(keeper, &ProjectKeeper::problem, &bench.notices, &Notices::problem);
    connect(keeper, &ProjectKeeper::opening, &bench.notices, &Notices::hide);
    connect(keeper, &ProjectKeeper::told, this, [this](const QString& sentence) {
        m_bench.notices.note(sentence);
        m_bench.window.statusBar()->showMessage(sentence, shownTime);
    });
    connect(keeper, &ProjectKeeper::recentChanged, this, &ProjectsFeature::listRecent);
    connect(keeper, &ProjectKeeper::perspectiveRestored, &perspective, &QAction::setChecked);
    connect(keeper, &ProjectKeeper::recoveriesWaiting, &home, &HomePage::showWaiting);
    connect(keeper, &ProjectKeeper::shown, this, [this] { keepPicture(m_keeper->path()); });
    connect(m_actions.save, &QAction::triggered, this, [this] { m_keeper->save(); });
    connect(m_actions.saveAs, &QAction::triggered, this, [this] { m_keeper->saveAs(); });
    connect(m_actions.recover, &QAction::triggered, this, [this] { m_keeper->offerRecoveries(true); });
    connect(&home, &HomePage::recoverClicked, this, [this] { m_keeper->offerRecoveries(true); });
    connect(&home, &HomePage::fileChosen, this, &ProjectsFeature::openRecent);
    connect(m_actions.close, &QAction::triggered, this, [this] {
        if (!m_bench.isBusy())
            m_keeper->letGo([this] {
                if (!m_bench.isBusy()) // neither after the question
                    closePart();
            });
    });
    bench.availability.needPart({m_actions.save, m_actions.saveAs, m_actions.close});
    listRecent();
}

ProjectsFeature::~ProjectsFeature() = default;

void ProjectsFeature::closePart()
{
    const QString name = m_keeper->name();
    m_bench.notices.hide();
    m_keeper->closeProject();
    m_bench.notices.note(tr("Closed %1.").arg(name));
}

void ProjectsFeature::addRecent(const QString& path)
{
    recent_files::add(path);
    listRecent();
}

bool ProjectsFeature::mayClose(std::function<void()> close)
{
    if (m_keeper->mayGo() || m_mayClose)
        return true;
    m_keeper->letGo([this, close = std::move(close)] {
        m_mayClose = true;
        close();
    });
    return false;
}

void ProjectsFeature::showTitle()
{
    const QString name = m_keeper->name();
    m_bench.window.setWindowTitle(name.isEmpty() ? tr("Knead") : tr("%1[*] - Knead").arg(name));
    m_bench.window.setWindowModified(m_keeper->isModified());
}

/// What was clicked is gone with the list, so clicks are answered later.
void ProjectsFeature::listRecent()
{
    m_recent.clear();
    const QStringList paths = recent_files::list();
    for (const QString& path : paths) {
        QAction* action = m_recent.addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setProperty(opensFile, true);
        connect(
            action, &QAction::triggered, this, [this, path] { openRecent(path); }, Qt::QueuedConnection);
    }
    m_recent.addSeparator();
    const auto forget = [this] {
        recent_files::clear();
        listRecent();
    };
    connect(m_recent.addAction(tr("Clear the list")), &QAction::triggered, this, forget, Qt::QueuedConnection);
    m_recent.setEnabled(!paths.isEmpty());
    m_home.showRecent(paths);
}

void ProjectsFeature::openRecent(const QString& path)
{
    if (QFileInfo::exists(path)) {
        emit fileChosen(path);
        return;
    }
    recent_files::remove(path);
    listRecent();
    m_bench.notices.problem(
        said(Message("ProjectsFeature", "%1 is not there any more. It may have been moved: look for it with Ctrl+O.")
                 .with(path.toStdString())));
}

bool ProjectsFeature::opened(const QStringList& paths)
{
    const auto isProject = [this](const QString& path) { return m_keeper->isProject(path); };
    if (std::none_of(paths.begin(), paths.end(), isProject))
        return false;
    if (paths.size() == 1)
        m_keeper->open({.path = QFile::encodeName(paths.front()).toStdString()});
    else
        m_bench.notices.problem(tr("A project is opened alone: choose one file, or only parts."));
    return true;
}

void ProjectsFeature::open(PreparedModel prepared)
{
    m_keeper->open(std::move(prepared));
    const std::vector<std::string>& paths = m_bench.document.content().request.paths;
    for (const std::string& path : std::views::reverse(paths)) { // the first one is the first of the list
        recent_files::add(QFile::decodeName(path.c_str()));
        keepPicture(QFileInfo(QFile::decodeName(path.c_str())).absoluteFilePath());
    }
    listRecent();
}

/// For the first page, once the view has turned to it. It is a full picture, for which who turns the view does not wait.
void ProjectsFeature::keepPicture(const QString& path)
{
    QTimer::singleShot(pictureDelay, this, [this, path, document = m_bench.document.history().documentNumber()] {
        if (m_bench.document.isEmpty() || !m_bench.viewport.isVisible() ||
            m_bench.document.history().documentNumber() != document)
            return;
        if (m_bench.viewport.isInMotion())
            keepPicture(path);
        else
            thumbnails::keep(path, m_bench.viewport.portrait());
    });
}

} // namespace knead
