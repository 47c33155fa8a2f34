#include "ui/frame/window_menus.h"

#include "ui/actions.h"
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

QMenu* fillMenuBar(QMainWindow& window, const MenuSources& sources)
{
    const Actions& a = sources.actions;
    const SelectionActions& s = sources.features.selection->actions();
    QMenuBar* bar = window.menuBar();
    QMenu* file = bar->addMenu(WindowMenus::tr("&File"));
    file->setObjectName("fileMenu");
    file->addActions({a.newWindow, a.open, a.openWithChoices});
    file->addMenu(&sources.recent);
    file->addMenu(&sources.examples);
    file->addActions({a.addPart, a.firstPage});
    file->addSeparator();
    file->addActions({a.save, a.saveAs, a.exportMeshes, a.exportRecipe});
    file->addSeparator();
    file->addAction(a.recover);
    file->addSeparator();
    file->addAction(a.quit);

    QMenu* edit = bar->addMenu(WindowMenus::tr("&Edit"));
    edit->addActions({a.undo, a.redo, a.cancel});
    edit->addSeparator();
    edit->addActions({a.palette, a.shortcuts, a.preferences});
    edit->addSeparator();
    edit->addActions({s.rename, s.color, s.uncolor, s.lock, s.group, s.ungroup});
    edit->addSeparator();
    edit->addAction(s.search);

    QMenu* simulation = bar->addMenu(WindowMenus::tr("&Simulation"));
    simulation->addActions({a.play, a.step, a.findBalance, a.reset, a.pressIt});
    simulation->addSeparator();
    simulation->addActions({a.gravity, a.floor, a.renormalize, a.refillNow, a.cutHere});
    simulation->addSeparator();
    for (QMenu* choice : sources.features.simulation->newMenus())
        simulation->addMenu(choice);
    simulation->addAction(a.keepUp);
    simulation->addSeparator();
    QMenu* film = simulation->addMenu(WindowMenus::tr("Timeline"));
    film->addActions(sources.timeline.actions());
    film->addMenu(sources.timeline.newRateMenu(&window));
    simulation->addActions({a.recordVideo, a.recordPictures});

    QMenu* tools = bar->addMenu(WindowMenus::tr("&Tools"));
    tools->addMenu(&sources.addTool);
    sources.addTool.addActions(a.addTool);
    tools->addActions({a.fixFaces, a.remove});
    sources.features.hands->hands().addTo(tools);

    QMenu* measure = sources.features.measuring->menu();
    sources.features.measuring->measuring().fillMenu(measure); // with what others pick
    bar->addMenu(measure);
    bar->addMenu(sources.features.selection->newMenu());

    QMenu* view = bar->addMenu(WindowMenus::tr("&View"));
    view->addActions({a.fit, a.isometric, a.front, a.back, a.right, a.left, a.top, a.bottom});
    view->addSeparator();
    QMenu* views = view->addMenu(WindowMenus::tr("Viewports"));
    views->setObjectName("viewportsMenu");
    views->setToolTipsVisible(true);
    views->addActions({a.oneView, a.twoViews, a.fourViews});
    views->addSeparator();
    views->addActions({a.viewAlone, a.nextView, a.linkedViews});
    view->addMenu(sources.display.menu());
    view->addActions(
        {a.perspective, a.edges, a.openEdges, a.grid, a.objects, a.allObjects, s.isolate, s.showAll, a.hide});
    view->addSeparator();
    view->addMenu(WindowMenus::tr("Theme"))->addActions({a.lightTheme, a.darkTheme, a.systemTheme});
    QMenu* panels = view->addMenu(WindowMenus::tr("Panels"));
    panels->setObjectName("panelsMenu");
    view->addAction(a.fullScreen);

    QMenu* help = bar->addMenu(WindowMenus::tr("&Help"));
    help->addActions({a.handbook, a.tour, a.controls, a.about});
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
    const Actions& a = sources.actions;
    bar->addActions({a.open, a.save, a.exportMeshes});
    bar->addSeparator();
    bar->addActions({a.undo, a.redo});
    bar->addSeparator();
    bar->addActions({a.play, a.step, a.reset});
    bar->addSeparator();
    bar->addActions({sources.addTool.menuAction(), a.fixFaces});
    qobject_cast<QToolButton*>(bar->widgetForAction(sources.addTool.menuAction()))
        ->setPopupMode(QToolButton::InstantPopup);
    bar->addSeparator();
    bar->addActions({a.gravity, a.floor, a.renormalize});
    bar->addSeparator();
    bar->addActions({sources.display.menu()->menuAction(), a.fit});
    const auto buttonOf = [bar](QAction* action) { return qobject_cast<QToolButton*>(bar->widgetForAction(action)); };
    buttonOf(sources.display.menu()->menuAction())->setPopupMode(QToolButton::InstantPopup);
    auto* measure = new QToolButton(bar);
    measure->setObjectName("measureButton");
    measure->setIcon(icon("measure"));
    measure->setToolTip(WindowMenus::tr("Measure the part"));
    measure->setPopupMode(QToolButton::InstantPopup);
    measure->setMenu(sources.features.measuring->menu());
    bar->addWidget(measure);
    bar->setTexts({a.play, sources.addTool.menuAction(), a.fixFaces, a.exportMeshes,
                   sources.display.menu()->menuAction(), a.open, a.reset, a.renormalize, a.gravity, a.floor, a.step,
                   a.save});
    bar->setTurns(a.play, &Actions::textsOfPlay);
    return *bar;
}

void listPanels(QMainWindow& window, QMenu& panels, const QToolBar& besides, const Actions& actions)
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
    add(besides.toggleViewAction(), besides.objectName());
    panels.addSeparator();
    panels.addAction(actions.resetLayout);
}

} // namespace knead
