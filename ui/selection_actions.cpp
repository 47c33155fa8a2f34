#include "ui/selection_actions.h"

#include "ui/commands/make_action.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

namespace {

constexpr const char* selectionContext = "SelectionActions";

QAction* makeFor(QWidget& window, const ActionLook& look)
{
    return makeAction(window, look, selectionContext);
}

/// One of them is chosen.
QList<QAction*> makeChoice(QWidget& window, std::initializer_list<ActionLook> looks)
{
    QList<QAction*> actions;
    auto* group = new QActionGroup(&window);
    for (const ActionLook& look : looks) {
        QAction* action = makeFor(window, look);
        action->setCheckable(true);
        action->setData(static_cast<int>(actions.size()));
        group->addAction(action);
        actions.append(action);
    }
    actions.front()->setChecked(true);
    return actions;
}

} // namespace

SelectionActions::SelectionActions(QWidget& window)
    : levels(makeChoice(window,
                        {{"selectParts", QT_TR_NOOP("Parts"), "select-part", "1", QT_TR_NOOP("Clicks select parts")},
                         {"selectFaces", QT_TR_NOOP("Faces"), "select-face", "2", QT_TR_NOOP("Clicks select faces")},
                         {"selectEdges", QT_TR_NOOP("Edges"), "select-edge", "3", QT_TR_NOOP("Clicks select edges")},
                         {"selectObjects", QT_TR_NOOP("Objects"), "objects", "4",
                          QT_TR_NOOP("Clicks select the objects the material is made of")},
                         {"selectConnections", QT_TR_NOOP("Connections"), "select-connection", "Ctrl+4",
                          QT_TR_NOOP("Clicks select connections between objects")}}))
    , shapes(makeChoice(
          window,
          {{"selectBox", QT_TR_NOOP("Box"), "select-box", "Alt+1",
            QT_TR_NOOP("Drag a box: to the right for what lies in it, to the left also for what it touches")},
           {"selectLasso", QT_TR_NOOP("Lasso"), "select-lasso", "Alt+2",
            QT_TR_NOOP("Draw a line around what is wanted")},
           {"selectBrush", QT_TR_NOOP("Brush"), "select-brush", "Alt+3", QT_TR_NOOP("Paint over what is wanted")}}))
    , through(makeSwitch(window,
                         {"selectThrough", QT_TR_NOOP("Through the part"), nullptr, "Alt+X",
                          QT_TR_NOOP("Boxes, lassos and brushes select what is hidden behind the skin too")},
                         false, selectionContext))
    , smallerBrush(
          makeFor(window, {"smallerBrush", QT_TR_NOOP("Smaller brush"), nullptr, "[", QT_TR_NOOP("A smaller brush")}))
    , largerBrush(
          makeFor(window, {"largerBrush", QT_TR_NOOP("Larger brush"), nullptr, "]", QT_TR_NOOP("A larger brush")}))
    , all(makeFor(window, {"selectAll", QT_TR_NOOP("Select all"), nullptr, "Ctrl+A",
                           QT_TR_NOOP("Everything of the kind that clicks select")}))
    , none(makeFor(window, {"selectNone", QT_TR_NOOP("Select nothing"), nullptr, "Ctrl+Shift+A",
                            QT_TR_NOOP("Clear the selection")}))
    , within(makeFor(window, {"selectWithin", QT_TR_NOOP("All within a distance..."), nullptr, "Ctrl+D",
                              QT_TR_NOOP("The objects that lie no farther from the selection than a distance")}))
    , keep(makeFor(window, {"keepSelection", QT_TR_NOOP("Save selection..."), "selection", "Ctrl+Shift+D",
                            QT_TR_NOOP("Keep the selection under a name in the model tree")}))
    , fix(makeFor(window, {"fixSelection", QT_TR_NOOP("Fix selection"), "fix", "Shift+F",
                           QT_TR_NOOP("Hold the selected faces or objects in place")}))
    , renormalize(makeFor(window, {"renormalizeSelection", QT_TR_NOOP("Re-normalize selection"), "renormalize",
                                   "Shift+N", QT_TR_NOOP("The selection takes its present shape for its own")}))
    , glue(makeFor(window, {"glueSelection", QT_TR_NOOP("Make it glue"), nullptr, "",
                            QT_TR_NOOP("The selected parts keep shape and place and hold what touches them")}))
    , rename(makeFor(window, {"rename", QT_TR_NOOP("Rename"), "rename", "F2",
                              QT_TR_NOOP("Another name for the selected part, group or selection")}))
    , color(makeFor(window, {"partColor", QT_TR_NOOP("Color..."), "material", "",
                             QT_TR_NOOP("Another color for the selected parts")}))
    , uncolor(makeFor(window, {"fileColor", QT_TR_NOOP("Color of the file"), nullptr, "",
                               QT_TR_NOOP("The color that the part has in its file")}))
    , lock(makeFor(window, {"lock", QT_TR_NOOP("Lock or unlock"), "lock", "L",
                            QT_TR_NOOP("Keep what is selected from being changed")}))
    , group(makeFor(
          window, {"group", QT_TR_NOOP("Group"), "group", "Ctrl+G", QT_TR_NOOP("Put the selected parts into a group")}))
    , ungroup(
          makeFor(window, {"ungroup", QT_TR_NOOP("Ungroup"), nullptr, "Ctrl+Shift+G",
                           QT_TR_NOOP("Take the selected parts out of their group, or all out of the selected one")}))
    , isolate(makeFor(window, {"isolate", QT_TR_NOOP("Isolate"), "isolate", "Shift+H",
                               QT_TR_NOOP("Show nothing but the selected parts; again: what was shown before")}))
    , showAll(makeFor(window, {"showAll", QT_TR_NOOP("Show all"), "eye", "Ctrl+H", QT_TR_NOOP("Hide no part")}))
    , search(makeFor(window, {"searchModel", QT_TR_NOOP("Search the model"), "search", "Ctrl+F",
                              QT_TR_NOOP("Look for parts, tools, fixtures and selections by their names")}))
    , hide(makeAction(window, {"hide", QT_TRANSLATE_NOOP("Actions", "Hide or show body"), nullptr, "H"}))
{
    // Other panels have names to change as well.
    rename->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    window.removeAction(rename);
}

} // namespace knead
