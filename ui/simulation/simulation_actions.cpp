#include "ui/simulation/simulation_actions.h"

#include "ui/commands/make_action.h"
#include "ui/theme.h"

#include <QAction>
#include <QCoreApplication>

namespace knead {

SimulationActions::SimulationActions(QWidget& window)
    : undo(makeAction(window, {"undo", QT_TRANSLATE_NOOP("Actions", "Undo"), "undo", "Ctrl+Z"}))
    , redo(makeAction(window, {"redo", QT_TRANSLATE_NOOP("Actions", "Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y"}))
    , play(makeAction(window, {"play", QT_TRANSLATE_NOOP("Actions", "Play"), "play", "Space",
                               QT_TRANSLATE_NOOP("Actions", "Run or pause the simulation")}))
    , step(makeAction(window, {"step", QT_TRANSLATE_NOOP("Actions", "Step"), "step", ".",
                               QT_TRANSLATE_NOOP("Actions", "One time step")}))
    , findBalance(makeAction(
          window,
          {"findBalance", QT_TRANSLATE_NOOP("Actions", "Find balance"), "balance", "Ctrl+B",
           QT_TRANSLATE_NOOP("Actions", "Put the part where forces balance now, without waiting until it is at rest")}))
    , pressIt(makeAction(
          window,
          {"pressIt", QT_TRANSLATE_NOOP("Actions", "Press it"), "press-it", "",
           QT_TRANSLATE_NOOP("Actions", "Hold one end of the new part and let a block press it, to see what it does")}))
    , reset(makeAction(window, {"reset", QT_TRANSLATE_NOOP("Actions", "Reset"), "reset", "Backspace; Ctrl+R",
                                QT_TRANSLATE_NOOP("Actions", "Back to the start")}))
    , gravity(makeSwitch(window, {"gravity", QT_TRANSLATE_NOOP("Actions", "Gravity"), "gravity", "G",
                                  QT_TRANSLATE_NOOP("Actions", "Let everything weigh something")}))
    , floor(makeSwitch(window,
                       {"floor", QT_TRANSLATE_NOOP("Actions", "Floor"), "floor", "",
                        QT_TRANSLATE_NOOP("Actions", "Put a floor under the part")},
                       true))
    , keepUp(makeSwitch(
          window,
          {"keepUp", QT_TRANSLATE_NOOP("Actions", "Keep up with real time"), nullptr, "",
           QT_TRANSLATE_NOOP(
               "Actions", "Where implicit steps are slower than real time, solve them more roughly (forces within 3 % "
                          "of the largest), then take one per 1/30 s. Without this, time runs slower")},
          true))
    , renormalize(makeAction(
          window, {"renormalize", QT_TRANSLATE_NOOP("Actions", "Re-normalize"), "renormalize", "N",
                   QT_TRANSLATE_NOOP("Actions", "The selected body, or every one, takes its present shape for "
                                                "its own: stress is gone, the shape stays")}))
    , refillNow(makeAction(
          window,
          {"refillNow", QT_TRANSLATE_NOOP("Actions", "Refill as it is"), "refill", "",
           QT_TRANSLATE_NOOP(
               "Actions",
               "The selected body, or every one that yields, gets new objects in the shape that it has, and goes on "
               "with its stress and motion. Where its lattice is no good any more this happens by itself")}))
    , cutHere(
          makeAction(window, {"cutHere", QT_TRANSLATE_NOOP("Actions", "Cut at section plane"), "cut", "",
                              QT_TRANSLATE_NOOP("Actions", "The selected body, or every one that deforms, is cut in "
                                                           "two where the section plane is now, without force")}))
{
}

QStringList SimulationActions::textsOfPlay()
{
    return {QCoreApplication::translate("Actions", "Play"), QCoreApplication::translate("Actions", "Pause")};
}

void SimulationActions::setPlaying(bool playing) const
{
    const QString text = textsOfPlay()[playing ? 1 : 0];
    if (play->text() == text)
        return;
    play->setText(text);
    play->setIcon(icon(playing ? "pause" : "play"));
}

} // namespace knead
