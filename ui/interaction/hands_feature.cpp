#include "ui/interaction/hands_feature.h"

#include "ui/document/fold_watch.h"
#include "ui/document/force_record.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/frame/text_files.h"
#include "ui/interaction/hand_panel.h"
#include "ui/interaction/hands.h"
#include "ui/measuring/fold_marks.h"
#include "ui/modes.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QScrollArea>

namespace knead {

namespace {

constexpr int plotHeight = 230; // when it is asked for [pixels]

} // namespace

HandsFeature::HandsFeature(const Workbench& bench, Modes& modes)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_hands(new Hands(&bench.window, bench.document, bench.viewport))
{
    auto* folds = new FoldWatch(bench.document, this);
    new FoldMarks(*folds, bench.viewport);
    connect(folds, &FoldWatch::said, &bench.notices, &Notices::remark);
    bench.docks.add("handsDock", tr("Hands"), scrolled(m_hands->makePanel()));
    bench.docks.add("forcesDock", tr("Forces"), new ForcePanel(bench.document, m_hands->forceTableAction()));
    connect(m_hands->forcePlotAction(), &QAction::triggered, this,
            [this] { m_bench.docks.showAtLeast("forcesDock", plotHeight); });
    connect(m_hands->forceTableAction(), &QAction::triggered, this, &HandsFeature::askForForces);
    connect(m_hands, &Hands::problem, this, [this](const QString& sentence) { m_bench.notices.problem(sentence); });
    modes.add(m_hands->pressAction());
    modes.add(m_hands->pullAction());
    m_hands->listen(bench.services.spaceMouse);
}

void HandsFeature::askForForces()
{
    askForTextFile(m_bench, tr("Export forces over time"), "-forces.csv", {tr("Table (*.csv)")},
                   [this](const QString& path) { exportForces(path); });
}

void HandsFeature::exportForces(const QString& path)
{
    const Timeline line = m_bench.document.timeline();
    if (line.pictures.empty()) {
        m_bench.notices.problem(tr("There are no forces to write yet: press Play and let something happen first."));
        return;
    }
    writeTextFile(m_bench, path, [line] { return csvOf(forceRecordOf(line)).toUtf8(); });
}

} // namespace knead
