#include "ui/viewport/view_actions.h"

#include "ui/commands/make_action.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

ViewActions::ViewActions(QWidget& window)
    : fit(makeAction(window, {"fit", QT_TRANSLATE_NOOP("Actions", "Fit"), "fit", "F",
                              QT_TRANSLATE_NOOP("Actions", "Show everything")}))
    , front(makeAction(window, {"viewFront", QT_TRANSLATE_NOOP("Actions", "Front"), nullptr, "8; Num+1"}))
    , back(makeAction(window, {"viewBack", QT_TRANSLATE_NOOP("Actions", "Back"), nullptr, "Ctrl+8; Ctrl+1"}))
    , right(makeAction(window, {"viewRight", QT_TRANSLATE_NOOP("Actions", "Right"), nullptr, "9; Num+3"}))
    , left(makeAction(window, {"viewLeft", QT_TRANSLATE_NOOP("Actions", "Left"), nullptr, "Ctrl+9; Ctrl+3"}))
    , top(makeAction(window, {"viewTop", QT_TRANSLATE_NOOP("Actions", "Top"), nullptr, "7"}))
    , bottom(makeAction(window, {"viewBottom", QT_TRANSLATE_NOOP("Actions", "Bottom"), nullptr, "Ctrl+7"}))
    , isometric(makeAction(window, {"viewIsometric", QT_TRANSLATE_NOOP("Actions", "Isometric"), nullptr, "0"}))
    , perspective(makeSwitch(window, {"perspective", QT_TRANSLATE_NOOP("Actions", "Perspective"), nullptr, "5"}, true))
    , oneView(makeSwitch(window,
                         {"oneView", QT_TRANSLATE_NOOP("Actions", "One view"), nullptr, "Shift+F1",
                          QT_TRANSLATE_NOOP("Actions", "One view of the part")},
                         true))
    , twoViews(makeSwitch(window, {"twoViews", QT_TRANSLATE_NOOP("Actions", "Two views"), nullptr, "Shift+F2",
                                   QT_TRANSLATE_NOOP("Actions", "Two views of the part, side by side")}))
    , fourViews(makeSwitch(window, {"fourViews", QT_TRANSLATE_NOOP("Actions", "Four views"), nullptr, "Shift+F4",
                                    QT_TRANSLATE_NOOP("Actions", "Front, top, right and the free view of the part")}))
    , viewAlone(makeSwitch(window, {"viewAlone", QT_TRANSLATE_NOOP("Actions", "Active view alone"), nullptr, "V",
                                    QT_TRANSLATE_NOOP("Actions", "Show the active view alone, and all of them again")}))
    , nextView(makeAction(window, {"nextView", QT_TRANSLATE_NOOP("Actions", "Next view"), nullptr, "Ctrl+Tab",
                                   QT_TRANSLATE_NOOP("Actions", "Make the next of several views the active one")}))
    , linkedViews(
          makeSwitch(window, {"linkedViews", QT_TRANSLATE_NOOP("Actions", "Linked cameras"), nullptr, "Shift+F5",
                              QT_TRANSLATE_NOOP("Actions", "What is panned or zoomed in one view is in all of them")}))
{
    auto* arrangements = new QActionGroup(&window);
    for (QAction* arrangement : {oneView, twoViews, fourViews})
        arrangements->addAction(arrangement);
}

} // namespace knead
