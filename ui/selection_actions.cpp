#include "ui/selection_actions.h"

#include "ui/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("SelectionActions", text);
}

struct Look {
    const char* name;
    const char* text;
    const char* icon;
    QKeySequence keys;
    const char* tip;
    bool checkable = false;
};

QAction* make(QWidget* window, const Look& look)
{
    auto* action = new QAction(tr(look.text), window);
    action->setObjectName(look.name);
    if (look.icon != nullptr)
        action->setIcon(icon(look.icon));
    action->setShortcut(look.keys);
    action->setCheckable(look.checkable);
    action->setToolTip(look.keys.isEmpty()
                           ? tr(look.tip)
                           : QStringLiteral("%1 (%2)").arg(tr(look.tip), look.keys.toString(QKeySequence::NativeText)));
    window->addAction(action);
    return action;
}

/// One of them is chosen.
QList<QAction*> makeChoice(QWidget* window, std::initializer_list<Look> looks)
{
    QList<QAction*> actions;
    auto* group = new QActionGroup(window);
    for (const Look& look : looks) {
        QAction* action = make(window, look);
        action->setCheckable(true);
        action->setData(static_cast<int>(actions.size()));
        group->addAction(action);
        actions.append(action);
    }
    actions.front()->setChecked(true);
    return actions;
}

} // namespace

SelectionActions::SelectionActions(QWidget* window)
    : levels(makeChoice(window, {{"selectParts", "Parts", "select-part", Qt::Key_1, "Clicks select parts"},
                                 {"selectFaces", "Faces", "select-face", Qt::Key_2, "Clicks select faces"},
                                 {"selectEdges", "Edges", "select-edge", Qt::Key_3, "Clicks select edges"},
                                 {"selectObjects", "Objects", "objects", Qt::Key_4,
                                  "Clicks select the objects the material is made of"},
                                 {"selectConnections", "Connections", "select-connection", QKeySequence("Ctrl+4"),
                                  "Clicks select connections between objects"}}))
    , shapes(makeChoice(
          window, {{"selectBox", "Box", "select-box", QKeySequence("Alt+1"),
                    "Drag a box: to the right for what lies in it, to the left also for what it touches"},
                   {"selectLasso", "Lasso", "select-lasso", QKeySequence("Alt+2"), "Draw a line around what is wanted"},
                   {"selectBrush", "Brush", "select-brush", QKeySequence("Alt+3"), "Paint over what is wanted"}}))
    , through(make(window, {"selectThrough", "Through the part", nullptr, QKeySequence("Alt+X"),
                            "Boxes, lassos and brushes select what is hidden behind the skin too", true}))
    , smallerBrush(make(window, {"smallerBrush", "Smaller brush", nullptr, QKeySequence("["), "A smaller brush"}))
    , largerBrush(make(window, {"largerBrush", "Larger brush", nullptr, QKeySequence("]"), "A larger brush"}))
    , all(make(window, {"selectAll", "Select all", nullptr, QKeySequence("Ctrl+A"),
                        "Everything of the kind that clicks select"}))
    , none(make(window, {"selectNone", "Select nothing", nullptr, QKeySequence("Ctrl+Shift+A"), "Clear the selection"}))
    , within(make(window, {"selectWithin", "All within a distance...", nullptr, QKeySequence("Ctrl+D"),
                           "The objects that lie no farther from the selection than a distance"}))
    , keep(make(window, {"keepSelection", "Save selection...", "selection", QKeySequence("Ctrl+Shift+D"),
                         "Keep the selection under a name in the model tree"}))
    , fix(make(window, {"fixSelection", "Fix selection", "fix", QKeySequence("Shift+F"),
                        "Hold the selected faces or objects in place"}))
    , renormalize(make(window, {"renormalizeSelection", "Re-normalize selection", "renormalize",
                                QKeySequence("Shift+N"), "The selection takes its present shape for its own"}))
    , glue(make(window, {"glueSelection",
                         "Make it glue",
                         nullptr,
                         {},
                         "The selected parts keep shape and place and hold what touches them"}))
    , rename(make(window,
                  {"rename", "Rename", "rename", Qt::Key_F2, "Another name for the selected part, group or selection"}))
    , color(make(window, {"partColor", "Color...", "material", {}, "Another color for the selected parts"}))
    , uncolor(make(window, {"fileColor", "Color of the file", nullptr, {}, "The color that the part has in its file"}))
    , lock(make(window, {"lock", "Lock or unlock", "lock", Qt::Key_L, "Keep what is selected from being changed"}))
    , group(make(window, {"group", "Group", "group", QKeySequence("Ctrl+G"), "Put the selected parts into a group"}))
    , ungroup(make(window, {"ungroup", "Ungroup", nullptr, QKeySequence("Ctrl+Shift+G"),
                            "Take the selected parts out of their group, or all out of the selected one"}))
    , isolate(make(window, {"isolate", "Isolate", "isolate", QKeySequence("Shift+H"),
                            "Show nothing but the selected parts; again: what was shown before"}))
    , showAll(make(window, {"showAll", "Show all", "eye", QKeySequence("Ctrl+H"), "Hide no part"}))
    , search(make(window, {"searchModel", "Search the model", "search", QKeySequence("Ctrl+F"),
                           "Look for parts, tools, fixtures and selections by their names"}))
{
    // Other panels have names to change as well.
    rename->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    window->removeAction(rename);
    setDocumentOpen(false, false);
}

void SelectionActions::setDocumentOpen(bool isOpen, bool isSimulated)
{
    for (QAction* action : {rename, color, uncolor, group, ungroup, isolate, showAll, search})
        action->setEnabled(isOpen);
    for (QAction* action : levels + shapes + QList{through, smallerBrush, largerBrush, all, none, lock})
        action->setEnabled(isSimulated);
    setSelected(false);
}

void SelectionActions::setSelected(bool isAnything)
{
    for (QAction* action : {within, keep, fix, renormalize, glue})
        action->setEnabled(isAnything);
}

} // namespace knead
