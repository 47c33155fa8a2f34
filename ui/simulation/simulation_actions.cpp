#include "ui/simulation/simulation_actions.h"

#include "ui/commands/make_action.h"
#include "ui/theme.h"

#include <QAction>
#include <QCoreApplication>

namespace knead {

SimulationActions::SimulationActions(QWidget& window)
    : undo(makeAction(window,
                      {.name = "undo", .text = QT_TRANSLATE_NOOP("Actions", "Undo"), .icon = "undo", .keys = "Ctrl+Z"}))
    , redo(makeAction(window, {.name = "redo",
                               .text = QT_TRANSLATE_NOOP("Actions", "Redo"),
                               .icon = "redo",
                               .keys = "Ctrl+Shift+Z; Ctrl+Y"}))
    , play(makeAction(window, {.name = "play",
                               .text = QT_TRANSLATE_NOOP("Actions", "Play"),
                               .icon = "play",
                               .keys = "Space",
                               .tip = QT_TRANSLATE_NOOP("Actions", "Run or pause the simulation")}))
    , step(makeAction(window, {.name = "step",
                               .text = QT_TRANSLATE_NOOP("Actions", "Step"),
                               .icon = "step",
                               .keys = ".",
                               .tip = QT_TRANSLATE_NOOP("Actions", "One time step")}))
    , findBalance(makeAction(
          window, {.name = "findBalance",
                   .text = QT_TRANSLATE_NOOP("Actions", "Find balance"),
                   .icon = "balance",
                   .keys = "Ctrl+B",
                   .tip = QT_TRANSLATE_NOOP(
                       "Actions", "Put the part where forces balance now, without waiting until it is at rest")}))
    , pressIt(makeAction(
          window, {.name = "pressIt",
                   .text = QT_TRANSLATE_NOOP("Actions", "Press it"),
                   .icon = "press-it",
                   .tip = QT_TRANSLATE_NOOP(
                       "Actions", "Hold one end of the new part and let a block press it, to see what it does")}))
    , reset(makeAction(window, {.name = "reset",
                                .text = QT_TRANSLATE_NOOP("Actions", "Reset"),
                                .icon = "reset",
                                .keys = "Backspace; Ctrl+R",
                                .tip = QT_TRANSLATE_NOOP("Actions", "Back to the start")}))
    , gravity(makeSwitch(window, {.name = "gravity",
                                  .text = QT_TRANSLATE_NOOP("Actions", "Gravity"),
                                  .icon = "gravity",
                                  .keys = "G",
                                  .tip = QT_TRANSLATE_NOOP("Actions", "Let everything weigh something")}))
    , floor(makeSwitch(window,
                       {.name = "floor",
                        .text = QT_TRANSLATE_NOOP("Actions", "Floor"),
                        .icon = "floor",
                        .tip = QT_TRANSLATE_NOOP("Actions", "Put a floor under the part")},
                       true))
    , keepUp(makeSwitch(
          window,
          {.name = "keepUp",
           .text = QT_TRANSLATE_NOOP("Actions", "Keep up with real time"),
           .tip = QT_TRANSLATE_NOOP(
               "Actions", "Where implicit steps are slower than real time, solve them more roughly (forces within 3 % "
                          "of the largest), then take one per 1/30 s. Without this, time runs slower")},
          true))
    , renormalize(makeAction(
          window, {.name = "renormalize",
                   .text = QT_TRANSLATE_NOOP("Actions", "Re-normalize"),
                   .icon = "renormalize",
                   .keys = "N",
                   .tip = QT_TRANSLATE_NOOP("Actions", "The selected body, or every one, takes its present shape for "
                                                       "its own: stress is gone, the shape stays")}))
    , refillNow(makeAction(
          window,
          {.name = "refillNow",
           .text = QT_TRANSLATE_NOOP("Actions", "Refill as it is"),
           .icon = "refill",
           .tip = QT_TRANSLATE_NOOP(
               "Actions",
               "The selected body, or every one that yields, gets new objects in the shape that it has, and goes on "
               "with its stress and motion. Where its lattice is no good any more this happens by itself")}))
    , cutHere(makeAction(window,
                         {.name = "cutHere",
                          .text = QT_TRANSLATE_NOOP("Actions", "Cut at section plane"),
                          .icon = "cut",
                          .tip = QT_TRANSLATE_NOOP("Actions", "The selected body, or every one that deforms, is cut in "
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
