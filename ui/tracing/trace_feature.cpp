#include "ui/tracing/trace_feature.h"

#include "ui/commands/make_action.h"
#include "ui/frame/docks.h"
#include "ui/frame/text_files.h"
#include "ui/project/project_keeper.h"
#include "ui/tracing/saved_path.h"
#include "ui/tracing/trace_follower.h"
#include "ui/tracing/trace_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace knead {

namespace {

constexpr int readableHeight = 220; // [pixels]

} // namespace

TraceFeature::TraceFeature(const Workbench& bench, ProjectKeeper& projects)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_projects(projects)
    , m_panel(new TracePanel)
    , m_action(makeAction(bench.window,
                          {"pythonTrace", QT_TRANSLATE_NOOP("Actions", "&Python trace"), nullptr, "",
                           QT_TRANSLATE_NOOP("Actions", "Show what you do as a script for Python, as you do it")}))
{
    const QDockWidget& dock = bench.docks.add("traceDock", tr("Python trace"), m_panel);
    connect(m_action, &QAction::triggered, this, [this] { m_bench.docks.showAtLeast("traceDock", readableHeight); });
    auto* follower = new TraceFollower(bench.document, bench.services.traces, projects, this);
    connect(&dock, &QDockWidget::visibilityChanged, follower, &TraceFollower::follow); // one behind others is unseen
    connect(follower, &TraceFollower::changed, m_panel, &TracePanel::edit);
    connect(m_panel, &TracePanel::saveWanted, this, [this] {
        const QString ending = '.' + QString::fromStdString(m_bench.services.traces.ending);
        askForTextFile(m_bench, tr("Save the Python trace"), ending, {tr("Python scripts (*%1)").arg(ending)},
                       [this](const QString& path) { saveTo(path); });
    });
}

void TraceFeature::saveTo(const QString& path)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.document.whenSettled([this, path] {
        writeTextFile(m_bench, path,
                      [script = m_bench.services.traces.script, project = m_bench.document.project(),
                       saved = savedPath(m_projects)] { return QByteArray::fromStdString(script(project, saved)); });
    });
}

} // namespace knead
