#include "ui/interaction/hands_feature.h"

#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/document/fold_watch.h"
#include "ui/document/force_record.h"
#include "ui/document/tool_kinds.h"
#include "ui/document/warning_watch.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/frame/text_files.h"
#include "ui/interaction/hand_panel.h"
#include "ui/interaction/hands.h"
#include "ui/measuring/fold_marks.h"
#include "ui/measuring/warning_marks.h"
#include "ui/modes.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/theme.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include <string_view>

namespace knead {

namespace {

constexpr int plotHeight = 230; // when it is asked for [pixels]

/// "addBlock", "addBall" ...; their data is their place in toolsToAdd().
QList<QAction*> makeToolActions(QWidget& window)
{
    QList<QAction*> actions;
    for (const ToolKindLook& look : toolsToAdd()) {
        const QByteArray name = QByteArray("add") + look.name;
        const char* tip = QT_TRANSLATE_NOOP("Actions", "Put one above the part to push it with");
        if (look.name == std::string_view("Knife") || look.name == std::string_view("Wire"))
            tip =
                QT_TRANSLATE_NOOP("Actions", "Put one above the part to cut it with: the force is the toughness of its "
                                             "material times the width of the cut");
        if (look.rollsFreely)
            tip = QT_TRANSLATE_NOOP("Actions", "Put one above the part to roll it out with: it turns as it is moved");
        const char* keys = look.kind == ToolKind::box ? "B" : "";
        QAction* action = makeAction(window, {name, look.name, look.icon, keys, tip});
        action->setData(static_cast<int>(actions.size()));
        actions.append(action);
    }
    return actions;
}

} // namespace

HandsFeature::Actions::Actions(QWidget& window)
    : addTool(makeToolActions(window))
    , fixFaces(makeSwitch(window, {"fixFaces", QT_TRANSLATE_NOOP("Actions", "Fix faces"), "fix", "X",
                                   QT_TRANSLATE_NOOP("Actions", "Click faces of the part to hold them in place")}))
    , remove(makeAction(window, {"remove", QT_TRANSLATE_NOOP("Actions", "Remove"), "delete", "Del",
                                 QT_TRANSLATE_NOOP("Actions", "Remove the selected tool or fixture")}))
{
}

HandsFeature::HandsFeature(const Workbench& bench, Modes& modes)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_addTool(*new QMenu(tr("Add tool"), &bench.window))
    , m_hands(new Hands(bench))
{
    m_addTool.setObjectName("addTool");
    m_addTool.setIcon(icon("add-block"));
    m_addTool.menuAction()->setToolTip(tr("Put a tool above the part to push it with"));
    m_addTool.addActions(m_actions.addTool);
    auto* folds = new FoldWatch(bench.document, this);
    new FoldMarks(*folds, bench.viewport);
    new WarningMarks(*new WarningWatch(bench.document, *folds, this), bench.views);
    connect(folds, &FoldWatch::said, &bench.notices, &Notices::remark);
    connect(folds, &FoldWatch::passed, &bench.notices, &Notices::withdraw);
    bench.docks.add("handsDock", tr("Hands"), scrolled(m_hands->makePanel()));
    bench.docks.add("forcesDock", tr("Forces"),
                    new ForcePanel(bench.document, m_hands->forceTableAction(), m_hands->forcesOfStrokesAction()));
    connect(m_hands->forcePlotAction(), &QAction::triggered, this,
            [this] { m_bench.docks.showAtLeast("forcesDock", plotHeight); });
    connect(m_hands->forceTableAction(), &QAction::triggered, this, &HandsFeature::askForForces);
    connect(m_hands, &Hands::problem, this, [this](const QString& sentence) { m_bench.notices.problem(sentence); });
    connectActions(modes);
    for (QAction* mode : m_hands->modes())
        modes.add(mode);
    m_hands->listen(bench.services.spaceMouse);
}

void HandsFeature::connectActions(Modes& modes)
{
    for (QAction* action : m_actions.addTool)
        connect(action, &QAction::triggered, this, [this, action] { addTool(action->data().toInt()); });
    connect(&m_bench.document, &Document::changed, this, &HandsFeature::showNewTool);
    connect(m_actions.fixFaces, &QAction::toggled, &m_bench.viewport, &ViewportWidget::setFixing);
    connect(m_actions.remove, &QAction::triggered, &m_bench.document, &Document::removeSelected);
    modes.add(m_actions.fixFaces);
    m_bench.availability.needBodies(m_actions.addTool + QList{m_addTool.menuAction(), m_actions.fixFaces});
    m_bench.availability.needBodies({m_actions.remove}, [this]() -> std::optional<QString> {
        const Selection::Kind kind = m_bench.document.selection().kind;
        if (kind == Selection::Kind::Tool || kind == Selection::Kind::Fixture)
            return {};
        return tr("Select a tool or a fixture first.");
    });
}

/// @param index in toolsToAdd()
void HandsFeature::addTool(int index)
{
    if (m_bench.viewport.showsAll())
        m_toolsBefore = m_bench.document.frame()->snapshot->tools.size();
    m_bench.document.addTool(toolsToAdd()[static_cast<std::size_t>(index)]);
    m_bench.docks.bringForward("propertiesDock"); // it has the numbers of the tool
    m_bench.viewport.setFocus();                  // the arrow keys shall drive it
}

/// Who sees the whole part sees a tool that was added to it, too.
void HandsFeature::showNewTool(Document::Change what)
{
    if (what == Document::Change::Model)
        m_toolsBefore.reset();
    if (what != Document::Change::Frame || !m_toolsBefore ||
        m_bench.document.frame()->snapshot->tools.size() <= *m_toolsBefore)
        return;
    m_toolsBefore.reset();
    if (!m_bench.viewport.showsAll())
        m_bench.viewport.fit();
}

bool HandsFeature::changeBrush(double factor) const
{
    return m_hands->changeBrush(factor);
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
    writeTextFile(m_bench, path, [line, strokes = m_hands->forcesOfStrokesAction()->isChecked()] {
        return csvOf(forceRecordOf(line, strokes)).toUtf8();
    });
}

} // namespace knead
