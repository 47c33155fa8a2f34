#pragma once

#include <QList>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;
class QWidget;

namespace knead {

struct Features;
class Display;
class TimelinePanel;

/// What a person can ask of the window itself.
struct WindowActions {
    explicit WindowActions(QWidget& window);

    QAction* newWindow;
    QAction* firstPage; ///< on: it is shown in place of what is open
    QAction* quit;
    QAction* cancel;
    QAction* palette;
    QAction* resetLayout;
    QAction* fullScreen;
};

/// What menus and tool bar are made of.
struct MenuSources {
    const WindowActions& actions;
    const Features& features;
    const Display& display;
    const TimelinePanel& timeline;
};

/// @return the menu of the panels, still empty
QMenu* fillMenuBar(QMainWindow& window, const MenuSources& sources);

QToolBar& makeToolBar(QMainWindow& window, const MenuSources& sources);

/// Every dock and bar can be closed and comes back from here.
/// @param besides other bars, in the middle of the window
void listPanels(QMainWindow& window, QMenu& panels, const QList<QToolBar*>& besides, const WindowActions& actions);

} // namespace knead
