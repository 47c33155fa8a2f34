// Tools and material by hand: handles, keys, pressing, pulling, the 3D mouse, the forces that come of it, and folds.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/document/fold_watch.h"
#include "ui/document/force_record.h"
#include "ui/hands/hand_panel.h"
#include "ui/hands/hands.h"
#include "ui/measuring/fold_marks.h"
#include "ui/modes.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>

namespace knead {

namespace {

constexpr int plotHeight = 230; // when it is asked for [pixels]

QDockWidget* makeDock(QMainWindow* window, const QString& title, const char* name, QWidget* content,
                      const char* besides)
{
    auto* dock = new QDockWidget(title, window);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    auto* neighbor = window->findChild<QDockWidget*>(besides);
    window->addDockWidget(window->dockWidgetArea(neighbor), dock);
    window->tabifyDockWidget(neighbor, dock);
    return dock;
}

} // namespace

/// Their docks stand beside those that are there; called before the menu that lists them is made.
void MainWindow::makeHands()
{
    m_hands = new Hands(this, m_document, *m_viewport);
    auto* folds = new FoldWatch(m_document, this);
    new FoldMarks(*folds, *m_viewport);
    connect(folds, &FoldWatch::said, this, &MainWindow::showRemark);
    makeDock(this, tr("Hands"), "handsDock", scrolled(m_hands->makePanel()), "propertiesDock");
    QDockWidget* forces =
        makeDock(this, tr("Forces"), "forcesDock", new ForcePanel(m_document, m_hands->forceTableAction()), "logDock");
    for (const char* first : {"propertiesDock", "logDock"})
        findChild<QDockWidget*>(first)->raise();
    connect(m_hands->forcePlotAction(), &QAction::triggered, this, [this, forces] {
        forces->show();
        forces->raise();
        if (forces->height() < plotHeight)
            resizeDocks({forces}, {plotHeight}, Qt::Vertical);
    });
}

void MainWindow::connectHands()
{
    m_hands->addTo(qobject_cast<QMenu*>(m_addTool->parentWidget()));
    connect(m_hands, &Hands::modeChanged, this, &MainWindow::showHint);
    connect(m_hands, &Hands::problem, this, [this](const QString& sentence) { showProblem(sentence); });
    connect(m_hands->forceTableAction(), &QAction::triggered, this, &MainWindow::askForForces);
    m_modes->add(m_hands->pressAction());
    m_modes->add(m_hands->pullAction());
    m_hands->listen(m_services.spaceMouse);
}

void MainWindow::askForForces()
{
    askForTextFile(tr("Export forces over time"), "-forces.csv", {tr("Table (*.csv)")},
                   [this](const QString& path) { exportForces(path); });
}

void MainWindow::exportForces(const QString& path)
{
    const Timeline line = m_document.timeline();
    if (line.pictures.empty()) {
        showProblem(tr("There are no forces to write yet: press Play and let something happen first."));
        return;
    }
    writeFile(path, [line] { return csvOf(forceRecordOf(line)).toUtf8(); });
}

} // namespace knead
