#include "ui/frame/window_menus.h"

#include "ui/commands/make_action.h"
#include "ui/display.h"
#include "ui/frame/features.h"
#include "ui/interaction/hands.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/fitting_tool_bar.h"
#include "ui/panels/timeline_panel.h"
#include "ui/theme.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace knead {

namespace {

struct WindowMenus {
    Q_DECLARE_TR_FUNCTIONS(WindowMenus)
};

} // namespace

WindowActions::WindowActions(QWidget& window)
    : newWindow(makeAction(window, {"newWindow", QT_TRANSLATE_NOOP("Actions", "&New window"), nullptr, "Ctrl+N",
                                    QT_TRANSLATE_NOOP("Actions", "Begin something else; what is open here stays")}))
    , firstPage(makeSwitch(window, {"firstPage", QT_TRANSLATE_NOOP("Actions", "First pa&ge"), nullptr, "",
                                    QT_TRANSLATE_NOOP("Actions", "Examples and files of late; the part that is open "
                                                                 "stays, and Esc comes back")}))
    , quit(makeAction(window, {"quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), nullptr, "Ctrl+Q"}))
    , cancel(makeAction(window, {"cancel", QT_TRANSLATE_NOOP("Actions", "Cancel"), "close", "Esc",
                                 QT_TRANSLATE_NOOP("Actions", "Stop what is being done")}))
    , palette(makeAction(window, {"palette", QT_TRANSLATE_NOOP("Actions", "Find a command..."), nullptr, "Ctrl+K",
                                  QT_TRANSLATE_NOOP("Actions", "Find any command by a few of its letters and do it")}))
    , resetLayout(makeAction(window, {"resetLayout", QT_TRANSLATE_NOOP("Actions", "Reset layout"), nullptr, "",
                                      QT_TRANSLATE_NOOP("Actions", "Put all panels back where they came")}))
    , fullScreen(makeSwitch(window, {"fullScreen", QT_TRANSLATE_NOOP("Actions", "Full screen"), nullptr, "F11"}))
{
}

QMenu* fillMenuBar(QMainWindow& window, const MenuSources& sources)
{
    const WindowActions& a = sources.actions;
    const Features& f = sources.features;
    const SelectionActions& s = f.selection->actions();
    QMenuBar* bar = window.menuBar();
    QMenu* file = bar->addMenu(WindowMenus::tr("&File"));
    file->setObjectName("fileMenu");
    const ImportFeature::Actions& in = f.imports->actions();
    file->addActions({a.newWindow, in.open, in.openWithChoices});
    file->addMenu(&f.projects->recentMenu());
    file->addMenu(&f.projects->examplesMenu());
    file->addActions({in.addPart, a.firstPage, f.projects->actions().close});
    file->addSeparator();
    file->addActions({f.projects->actions().save, f.projects->actions().saveAs, f.exports->action(),
                      f.pictures->action(), f.recipes->exportAction(), f.otherPart->action()});
    file->addSeparator();
    file->addAction(f.deforming->actions().byField);
    file->addSeparator();
    file->addAction(f.projects->actions().recover);
    file->addSeparator();
    file->addAction(a.quit);

    const PreferencesFeature::Actions& p = f.preferences->actions();
    QMenu* edit = bar->addMenu(WindowMenus::tr("&Edit"));
    const SimulationActions& time = f.simulation->actions();
    edit->addActions({time.undo, time.redo, a.cancel});
    edit->addSeparator();
    edit->addActions({a.palette, p.shortcuts, p.preferences});
    edit->addSeparator();
    edit->addActions({s.rename, s.color, s.uncolor, s.lock, s.group, s.ungroup});
    edit->addSeparator();
    edit->addMenu(f.deforming->newMenu());
    edit->addSeparator();
    edit->addAction(s.search);

    QMenu* simulation = bar->addMenu(WindowMenus::tr("&Simulation"));
    simulation->addActions({time.play, time.step, time.findBalance, time.reset, time.pressIt});
    simulation->addSeparator();
    simulation->addActions({time.gravity, time.floor, time.renormalize, time.refillNow, time.cutHere});
    simulation->addSeparator();
    for (QMenu* choice : f.simulation->newMenus())
        simulation->addMenu(choice);
    simulation->addAction(time.keepUp);
    simulation->addSeparator();
    QMenu* film = simulation->addMenu(WindowMenus::tr("Timeline"));
    film->addActions(sources.timeline.actions());
    film->addMenu(sources.timeline.newRateMenu(&window));
    simulation->addActions({f.recording->actions().video, f.recording->actions().pictures});

    QMenu* tools = bar->addMenu(WindowMenus::tr("&Tools"));
    tools->addMenu(&f.hands->addToolMenu());
    tools->addActions({f.hands->actions().fixFaces, f.hands->actions().remove});
    f.hands->hands().addTo(tools);
    tools->addSeparator();
    tools->addAction(f.trace->action());

    QMenu* measure = f.measuring->menu();
    f.measuring->measuring().fillMenu(measure); // with what others pick
    measure->addSeparator();
    measure->addAction(f.comparison->action());
    bar->addMenu(measure);
    bar->addMenu(f.selection->newMenu());

    QMenu* view = bar->addMenu(WindowMenus::tr("&View"));
    const ViewActions& v = f.views->actions();
    view->addActions({v.fit, v.isometric, v.front, v.back, v.right, v.left, v.top, v.bottom});
    view->addSeparator();
    QMenu* views = view->addMenu(WindowMenus::tr("Viewports"));
    views->setObjectName("viewportsMenu");
    views->setToolTipsVisible(true);
    views->addActions({v.oneView, v.twoViews, v.fourViews});
    views->addSeparator();
    views->addActions({v.viewAlone, v.nextView, v.linkedViews});
    view->addMenu(sources.display.menu());
    view->addAction(v.perspective);
    view->addActions(sources.display.edgesAndObjects());
    view->addActions({s.isolate, s.showAll, s.hide});
    view->addSeparator();
    view->addMenu(WindowMenus::tr("Theme"))->addActions({p.lightTheme, p.darkTheme, p.systemTheme});
    QMenu* panels = view->addMenu(WindowMenus::tr("Panels"));
    panels->setObjectName("panelsMenu");
    view->addAction(a.fullScreen);

    QMenu* help = bar->addMenu(WindowMenus::tr("&Help"));
    const HelpFeature::Actions& h = f.help->actions();
    help->addActions({h.handbook, h.tour, h.controls, h.about});
    return panels;
}

QToolBar& makeToolBar(QMainWindow& window, const MenuSources& sources)
{
    auto* bar = new FittingToolBar(WindowMenus::tr("Tool bar"), &window);
    window.addToolBar(bar);
    bar->setObjectName("toolBar");
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    const Features& f = sources.features;
    const SimulationActions& time = f.simulation->actions();
    QAction* const open = f.imports->actions().open;
    QAction* const save = f.projects->actions().save;
    QAction* const addTool = f.hands->addToolMenu().menuAction();
    QAction* const fixFaces = f.hands->actions().fixFaces;
    QAction* const display = sources.display.menu()->menuAction();
    bar->addActions({open, save, f.exports->action()});
    bar->addSeparator();
    bar->addActions({time.undo, time.redo});
    bar->addSeparator();
    bar->addActions({time.play, time.step, time.reset});
    bar->addSeparator();
    bar->addActions({addTool, fixFaces});
    bar->addSeparator();
    bar->addActions({time.gravity, time.floor, time.renormalize});
    bar->addSeparator();
    bar->addActions({display, f.views->actions().fit});
    for (QAction* menu : {addTool, display})
        qobject_cast<QToolButton*>(bar->widgetForAction(menu))->setPopupMode(QToolButton::InstantPopup);
    auto* measure = new QToolButton(bar);
    measure->setObjectName("measureButton");
    measure->setIcon(icon("measure"));
    measure->setToolTip(WindowMenus::tr("Measure the part"));
    measure->setAccessibleName(measure->toolTip());
    measure->setPopupMode(QToolButton::InstantPopup);
    measure->setMenu(f.measuring->menu());
    bar->addWidget(measure);
    bar->setTexts({time.play, addTool, fixFaces, f.exports->action(), display, open, time.reset, time.renormalize,
                   time.gravity, time.floor, time.step, save});
    bar->setTurns(time.play, &SimulationActions::textsOfPlay);
    return *bar;
}

void listPanels(QMainWindow& window, QMenu& panels, const QList<QToolBar*>& besides, const WindowActions& actions)
{
    const auto add = [&panels](QAction* toggle, const QString& name) {
        toggle->setObjectName("show_" + name);
        panels.addAction(toggle);
    };
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        add(dock->toggleViewAction(), dock->objectName());
    panels.addSeparator();
    for (const QToolBar* bar : window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        add(bar->toggleViewAction(), bar->objectName());
    for (const QToolBar* bar : besides)
        add(bar->toggleViewAction(), bar->objectName());
    panels.addSeparator();
    panels.addAction(actions.resetLayout);
}

} // namespace knead
