#pragma once

#include <QList>

class QMainWindow;
class QMenu;
class QToolBar;

namespace knead {

struct Actions;
struct Features;
class Display;
class TimelinePanel;

/// What menus and tool bar are made of.
struct MenuSources {
    const Actions& actions;
    const Features& features;
    const Display& display;
    const TimelinePanel& timeline;
    QMenu& recent; ///< files
    QMenu& examples;
    QMenu& addTool; ///< gets its actions
};

/// @return the menu of the panels, still empty
QMenu* fillMenuBar(QMainWindow& window, const MenuSources& sources);

QToolBar& makeToolBar(QMainWindow& window, const MenuSources& sources);

/// Every dock and bar can be closed and comes back from here.
/// @param besides another bar, in the middle of the window
void listPanels(QMainWindow& window, QMenu& panels, const QToolBar& besides, const Actions& actions);

} // namespace knead
