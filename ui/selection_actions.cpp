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
    action->setToolTip(tr(look.tip));
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
    : levels(makeChoice(
          window, {{"selectParts", QT_TR_NOOP("Parts"), "select-part", Qt::Key_1, QT_TR_NOOP("Clicks select parts")},
                   {"selectFaces", QT_TR_NOOP("Faces"), "select-face", Qt::Key_2, QT_TR_NOOP("Clicks select faces")},
                   {"selectEdges", QT_TR_NOOP("Edges"), "select-edge", Qt::Key_3, QT_TR_NOOP("Clicks select edges")},
                   {"selectObjects", QT_TR_NOOP("Objects"), "objects", Qt::Key_4,
                    QT_TR_NOOP("Clicks select the objects the material is made of")},
                   {"selectConnections", QT_TR_NOOP("Connections"), "select-connection", QKeySequence("Ctrl+4"),
                    QT_TR_NOOP("Clicks select connections between objects")}}))
    , shapes(makeChoice(
          window, {{"selectBox", QT_TR_NOOP("Box"), "select-box", QKeySequence("Alt+1"),
                    QT_TR_NOOP("Drag a box: to the right for what lies in it, to the left also for what it touches")},
                   {"selectLasso", QT_TR_NOOP("Lasso"), "select-lasso", QKeySequence("Alt+2"),
                    QT_TR_NOOP("Draw a line around what is wanted")},
                   {"selectBrush", QT_TR_NOOP("Brush"), "select-brush", QKeySequence("Alt+3"),
                    QT_TR_NOOP("Paint over what is wanted")}}))
    , through(make(window, {"selectThrough", QT_TR_NOOP("Through the part"), nullptr, QKeySequence("Alt+X"),
                            QT_TR_NOOP("Boxes, lassos and brushes select what is hidden behind the skin too"), true}))
    , smallerBrush(make(window, {"smallerBrush", QT_TR_NOOP("Smaller brush"), nullptr, QKeySequence("["),
                                 QT_TR_NOOP("A smaller brush")}))
    , largerBrush(make(window, {"largerBrush", QT_TR_NOOP("Larger brush"), nullptr, QKeySequence("]"),
                                QT_TR_NOOP("A larger brush")}))
    , all(make(window, {"selectAll", QT_TR_NOOP("Select all"), nullptr, QKeySequence("Ctrl+A"),
                        QT_TR_NOOP("Everything of the kind that clicks select")}))
    , none(make(window, {"selectNone", QT_TR_NOOP("Select nothing"), nullptr, QKeySequence("Ctrl+Shift+A"),
                         QT_TR_NOOP("Clear the selection")}))
    , within(make(window, {"selectWithin", QT_TR_NOOP("All within a distance..."), nullptr, QKeySequence("Ctrl+D"),
                           QT_TR_NOOP("The objects that lie no farther from the selection than a distance")}))
    , keep(make(window, {"keepSelection", QT_TR_NOOP("Save selection..."), "selection", QKeySequence("Ctrl+Shift+D"),
                         QT_TR_NOOP("Keep the selection under a name in the model tree")}))
    , fix(make(window, {"fixSelection", QT_TR_NOOP("Fix selection"), "fix", QKeySequence("Shift+F"),
                        QT_TR_NOOP("Hold the selected faces or objects in place")}))
    , renormalize(
          make(window, {"renormalizeSelection", QT_TR_NOOP("Re-normalize selection"), "renormalize",
                        QKeySequence("Shift+N"), QT_TR_NOOP("The selection takes its present shape for its own")}))
    , glue(make(window, {"glueSelection",
                         QT_TR_NOOP("Make it glue"),
                         nullptr,
                         {},
                         QT_TR_NOOP("The selected parts keep shape and place and hold what touches them")}))
    , rename(make(window, {"rename", QT_TR_NOOP("Rename"), "rename", Qt::Key_F2,
                           QT_TR_NOOP("Another name for the selected part, group or selection")}))
    , color(make(
          window,
          {"partColor", QT_TR_NOOP("Color..."), "material", {}, QT_TR_NOOP("Another color for the selected parts")}))
    , uncolor(make(window, {"fileColor",
                            QT_TR_NOOP("Color of the file"),
                            nullptr,
                            {},
                            QT_TR_NOOP("The color that the part has in its file")}))
    , lock(make(window, {"lock", QT_TR_NOOP("Lock or unlock"), "lock", Qt::Key_L,
                         QT_TR_NOOP("Keep what is selected from being changed")}))
    , group(make(window, {"group", QT_TR_NOOP("Group"), "group", QKeySequence("Ctrl+G"),
                          QT_TR_NOOP("Put the selected parts into a group")}))
    , ungroup(make(window, {"ungroup", QT_TR_NOOP("Ungroup"), nullptr, QKeySequence("Ctrl+Shift+G"),
                            QT_TR_NOOP("Take the selected parts out of their group, or all out of the selected one")}))
    , isolate(make(window, {"isolate", QT_TR_NOOP("Isolate"), "isolate", QKeySequence("Shift+H"),
                            QT_TR_NOOP("Show nothing but the selected parts; again: what was shown before")}))
    , showAll(
          make(window, {"showAll", QT_TR_NOOP("Show all"), "eye", QKeySequence("Ctrl+H"), QT_TR_NOOP("Hide no part")}))
    , search(make(window, {"searchModel", QT_TR_NOOP("Search the model"), "search", QKeySequence("Ctrl+F"),
                           QT_TR_NOOP("Look for parts, tools, fixtures and selections by their names")}))
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
