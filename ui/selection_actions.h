#pragma once

#include <QList>

class QAction;
class QWidget;

namespace knead {

/// What a person can ask for about selecting, and about the lines of the model tree. Names of the actions are their object names.
struct SelectionActions {
    /// Makes them all; they work wherever the keyboard is in `window`, but rename: in the widgets that it is added to.
    explicit SelectionActions(QWidget& window);

    QList<QAction*> levels; ///< one per Level, exclusive
    QList<QAction*> shapes; ///< one per RegionShape, exclusive
    QAction* through;
    QAction* smallerBrush;
    QAction* largerBrush;

    QAction* all;
    QAction* none;
    QAction* within; ///< all within a distance
    QAction* keep;   ///< as a selection set
    QAction* fix;
    QAction* renormalize;
    QAction* glue;

    QAction* rename;
    QAction* color;
    QAction* uncolor;
    QAction* lock;
    QAction* group;
    QAction* ungroup;
    QAction* isolate;
    QAction* showAll;
    QAction* search;
    QAction* hide; ///< or show, one body
};

} // namespace knead
