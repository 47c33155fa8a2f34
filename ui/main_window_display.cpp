// What the main window does about what is seen of the material: menus, buttons and the panel for it.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/display.h"
#include "ui/panels/display_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/theme.h"

#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>

namespace knead {

void MainWindow::makeDisplay()
{
    m_display = new Display(m_document, *m_viewport, *m_actions, this);
    auto* dock = new QDockWidget(tr("Display"), this);
    dock->setObjectName("displayDock");
    dock->setWidget(scrolled(new DisplayPanel(*m_display)));
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    if (auto* properties = findChild<QDockWidget*>("propertiesDock")) {
        tabifyDockWidget(properties, dock);
        properties->raise();
    }
}

} // namespace knead
