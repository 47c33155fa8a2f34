#pragma once

#include <QStringList>

class QAction;
class QWidget;

namespace knead {

/// What a person can ask of time and of the simulation.
struct SimulationActions {
    explicit SimulationActions(QWidget& window);

    QAction* undo;
    QAction* redo;
    QAction* play;
    QAction* step;
    QAction* findBalance;
    QAction* pressIt;
    QAction* reset;
    QAction* gravity;
    QAction* floor;
    QAction* keepUp;
    QAction* renormalize;
    QAction* refillNow;
    QAction* cutHere;

    /// The first button says what a click will do.
    void setPlaying(bool playing) const;
    static QStringList textsOfPlay(); ///< what it says by turns
};

} // namespace knead
