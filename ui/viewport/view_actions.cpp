#include "ui/viewport/view_actions.h"

#include "ui/commands/make_action.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

ViewActions::ViewActions(QWidget& window)
    : fit(makeAction(window, {.name = "fit",
                              .text = QT_TRANSLATE_NOOP("Actions", "Fit"),
                              .icon = "fit",
                              .keys = "F",
                              .tip = QT_TRANSLATE_NOOP("Actions", "Show everything")}))
    , front(makeAction(window, {.name = "viewFront", .text = QT_TRANSLATE_NOOP("Actions", "Front"), .keys = "Num+1"}))
    , back(makeAction(window, {.name = "viewBack", .text = QT_TRANSLATE_NOOP("Actions", "Back"), .keys = "Ctrl+1"}))
    , right(makeAction(window, {.name = "viewRight", .text = QT_TRANSLATE_NOOP("Actions", "Right"), .keys = "Num+3"}))
    , left(makeAction(window, {.name = "viewLeft", .text = QT_TRANSLATE_NOOP("Actions", "Left"), .keys = "Ctrl+3"}))
    , top(makeAction(window, {.name = "viewTop", .text = QT_TRANSLATE_NOOP("Actions", "Top"), .keys = "7"}))
    , bottom(
          makeAction(window, {.name = "viewBottom", .text = QT_TRANSLATE_NOOP("Actions", "Bottom"), .keys = "Ctrl+7"}))
    , isometric(
          makeAction(window, {.name = "viewIsometric", .text = QT_TRANSLATE_NOOP("Actions", "Isometric"), .keys = "0"}))
    , perspective(makeSwitch(
          window, {.name = "perspective", .text = QT_TRANSLATE_NOOP("Actions", "Perspective"), .keys = "5"}, true))
    , oneView(makeSwitch(window,
                         {.name = "oneView",
                          .text = QT_TRANSLATE_NOOP("Actions", "One view"),
                          .keys = "Shift+F1",
                          .tip = QT_TRANSLATE_NOOP("Actions", "One view of the part")},
                         true))
    , twoViews(makeSwitch(window, {.name = "twoViews",
                                   .text = QT_TRANSLATE_NOOP("Actions", "Two views"),
                                   .keys = "Shift+F2",
                                   .tip = QT_TRANSLATE_NOOP("Actions", "Two views of the part, side by side")}))
    , fourViews(
          makeSwitch(window, {.name = "fourViews",
                              .text = QT_TRANSLATE_NOOP("Actions", "Four views"),
                              .keys = "Shift+F4",
                              .tip = QT_TRANSLATE_NOOP("Actions", "Front, top, right and the free view of the part")}))
    , viewAlone(makeSwitch(window,
                           {.name = "viewAlone",
                            .text = QT_TRANSLATE_NOOP("Actions", "Active view alone"),
                            .keys = "V",
                            .tip = QT_TRANSLATE_NOOP("Actions", "Show the active view alone, and all of them again")}))
    , nextView(
          makeAction(window, {.name = "nextView",
                              .text = QT_TRANSLATE_NOOP("Actions", "Next view"),
                              .keys = "Ctrl+Tab",
                              .tip = QT_TRANSLATE_NOOP("Actions", "Make the next of several views the active one")}))
    , linkedViews(makeSwitch(
          window, {.name = "linkedViews",
                   .text = QT_TRANSLATE_NOOP("Actions", "Linked cameras"),
                   .keys = "Shift+F5",
                   .tip = QT_TRANSLATE_NOOP("Actions", "What is panned or zoomed in one view is in all of them")}))
{
    auto* arrangements = new QActionGroup(&window);
    for (QAction* arrangement : {oneView, twoViews, fourViews})
        arrangements->addAction(arrangement);
}

} // namespace knead
