#include "ui/actions.h"

#include "ui/document/tool_kinds.h"
#include "ui/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Actions", text);
}

struct Look {
    const char* name;
    const char* text;
    const char* icon = nullptr;
    QList<QKeySequence> keys = {};
    const char* tip = nullptr;
    bool checkable = false;
    bool checked = false;
};

QAction* make(QWidget* window, const Look& look)
{
    auto* action = new QAction(tr(look.text), window);
    action->setObjectName(look.name);
    if (look.icon != nullptr)
        action->setIcon(icon(look.icon));
    action->setShortcuts(look.keys);
    action->setCheckable(look.checkable);
    action->setChecked(look.checked);
    const QString tip = look.tip != nullptr ? tr(look.tip) : action->toolTip();
    const QString keys = QKeySequence::listToString(look.keys, QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
    window->addAction(action);
    return action;
}

/// "addBlock", "addBall" ...; parts come from files.
QList<QAction*> makeToolActions(QWidget* window)
{
    QList<QAction*> actions;
    for (const ToolKindLook& look : toolKindLooks()) {
        if (look.kind == ToolKind::part)
            continue;
        const QByteArray name = QByteArray("add") + look.name;
        const char* tip = "Put one above the part to push it with";
        const QList<QKeySequence> keys =
            look.kind == ToolKind::box ? QList<QKeySequence>{Qt::Key_B} : QList<QKeySequence>{};
        QAction* action = make(window, {name, look.name, look.icon, keys, tip});
        action->setData(static_cast<int>(look.kind));
        actions.append(action);
    }
    return actions;
}

} // namespace

Actions::Actions(QWidget* window)
    : open(make(window, {"open", "&Open...", "open", {QKeySequence("Ctrl+O")}, "Open a part, a project or a recipe"}))
    , openWithChoices(make(window, {"openWithChoices",
                                    "Open with &choices...",
                                    nullptr,
                                    {QKeySequence("Ctrl+Shift+O")},
                                    "Look into files and choose parts, detail and units before they are opened"}))
    , save(make(window,
                {"save", "&Save", "save", {QKeySequence("Ctrl+S")}, "Keep part, history and view in a project file"}))
    , saveAs(make(window, {"saveAs",
                           "Save &as...",
                           nullptr,
                           {QKeySequence("Ctrl+Shift+S")},
                           "Keep the project in another file and go on with that"}))
    , recover(make(
          window,
          {"recover", "Recover &unsaved work...", nullptr, {}, "Look for work that was not saved when Knead ended"}))
    , exportMeshes(make(
          window, {"export", "&Export...", "export", {QKeySequence("Ctrl+E")}, "Write the deformed part to a file"}))
    , exportRecipe(make(window, {"exportRecipe",
                                 "Export as &recipe...",
                                 nullptr,
                                 {},
                                 "Write what was done as a recipe, to be read, changed and carried out again"}))
    , quit(make(window, {"quit", "&Quit", nullptr, {QKeySequence("Ctrl+Q")}}))
    , undo(make(window, {"undo", "Undo", "undo", {QKeySequence("Ctrl+Z")}}))
    , redo(make(window, {"redo", "Redo", "redo", {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}}))
    , play(make(window, {"play", "Play", "play", {Qt::Key_Space}, "Run or pause the simulation"}))
    , step(make(window, {"step", "Step", "step", {Qt::Key_Period}, "One time step"}))
    , reset(make(window, {"reset", "Reset", "reset", {Qt::Key_Backspace, QKeySequence("Ctrl+R")}, "Back to the start"}))
    , gravity(make(window, {"gravity", "Gravity", "gravity", {Qt::Key_G}, "Let everything weigh something", true}))
    , floor(make(window, {"floor", "Floor", "floor", {}, "Put a floor under the part", true, true}))
    , recordVideo(make(window, {"recordVideo",
                                "Record &video...",
                                "record",
                                {},
                                "Make a video of what was simulated, as the view shows it"}))
    , recordPictures(make(
          window,
          {"recordPictures", "Record p&ictures...", nullptr, {}, "Write what was simulated as a sequence of pictures"}))
    , addTool(makeToolActions(window))
    , renormalize(
          make(window, {"renormalize",
                        "Re-normalize",
                        "renormalize",
                        {Qt::Key_N},
                        "The selected body, or every one, takes its present shape for its own: stress is gone, the "
                        "shape stays"}))
    , fixFaces(make(
          window, {"fixFaces", "Fix faces", "fix", {Qt::Key_X}, "Click faces of the part to hold them in place", true}))
    , remove(make(window, {"remove", "Remove", "delete", {Qt::Key_Delete}, "Remove the selected tool or fixture"}))
    , cancel(make(window, {"cancel", "Cancel", "close", {Qt::Key_Escape}, "Stop what is being done"}))
    , fit(make(window, {"fit", "Fit", "fit", {Qt::Key_F}, "Show everything"}))
    , front(make(window, {"viewFront", "Front", nullptr, {QKeySequence("Num+1")}}))
    , back(make(window, {"viewBack", "Back", nullptr, {QKeySequence("Ctrl+1")}}))
    , right(make(window, {"viewRight", "Right", nullptr, {QKeySequence("Num+3")}}))
    , left(make(window, {"viewLeft", "Left", nullptr, {QKeySequence("Ctrl+3")}}))
    , top(make(window, {"viewTop", "Top", nullptr, {Qt::Key_7}}))
    , bottom(make(window, {"viewBottom", "Bottom", nullptr, {QKeySequence("Ctrl+7")}}))
    , isometric(make(window, {"viewIsometric", "Isometric", nullptr, {Qt::Key_0}}))
    , perspective(make(window, {"perspective", "Perspective", nullptr, {Qt::Key_5}, nullptr, true, true}))
    , objects(make(window,
                   {"objects", "Objects", "objects", {Qt::Key_O}, "Show the objects the material is made of", true}))
    , allObjects(make(window, {"allObjects", "Inner objects too", nullptr, {QKeySequence("Shift+O")}, nullptr, true}))
    , edges(make(window, {"edges", "Edges", nullptr, {Qt::Key_E}, nullptr, true, true}))
    , openEdges(make(
          window, {"openEdges", "Open edges", nullptr, {}, "Show where surfaces that are not closed end", true, true}))
    , grid(make(window, {"grid", "Grid", nullptr, {}, nullptr, true, true}))
    , hide(make(window, {"hide", "Hide or show body", nullptr, {Qt::Key_H}}))
    , lightTheme(make(window, {"lightTheme", "Light", nullptr, {}, nullptr, true}))
    , darkTheme(make(window, {"darkTheme", "Dark", nullptr, {}, nullptr, true}))
    , systemTheme(make(window, {"systemTheme", "As the system", nullptr, {}, nullptr, true}))
    , palette(make(window, {"palette",
                            "Find a command...",
                            nullptr,
                            {QKeySequence("Ctrl+K")},
                            "Find any command by a few of its letters and do it"}))
    , preferences(make(window, {"preferences",
                                "&Preferences...",
                                nullptr,
                                {QKeySequence("Ctrl+,")},
                                "Theme, language, units, memory, files, view"}))
    , shortcuts(make(window, {"shortcuts", "&Keyboard shortcuts...", nullptr, {}, "Give commands other keys"}))
    , resetLayout(make(window, {"resetLayout", "Reset layout", nullptr, {}, "Put all panels back where they came"}))
    , fullScreen(make(window, {"fullScreen", "Full screen", nullptr, {Qt::Key_F11}, nullptr, true}))
    , tour(make(window, {"tour", "&Tour of the window", nullptr, {}, "What is where, in a minute"}))
    , controls(make(window, {"controls", "Mouse and keys", nullptr, {Qt::Key_F1}}))
    , about(make(window, {"about", "About Knead"}))
{
    auto* themes = new QActionGroup(window);
    for (QAction* theme : {lightTheme, darkTheme, systemTheme})
        themes->addAction(theme);
    undo->setEnabled(false);
    redo->setEnabled(false);
    setDocumentOpen(false, false);
}

void Actions::setDocumentOpen(bool isOpen, bool isSimulated)
{
    for (QAction* action :
         {save, saveAs, fit, front, back, right, left, top, bottom, isometric, perspective, edges, openEdges, grid})
        action->setEnabled(isOpen);
    for (QAction* action : {exportMeshes, exportRecipe, play, step, reset, gravity, floor, recordVideo, recordPictures,
                            renormalize, fixFaces, remove, objects, allObjects, hide})
        action->setEnabled(isSimulated);
    for (QAction* action : addTool)
        action->setEnabled(isSimulated);
}

void Actions::setPlaying(bool playing)
{
    const QString text = playing ? tr("Pause") : tr("Play");
    if (play->text() == text)
        return;
    play->setText(text);
    play->setIcon(icon(playing ? "pause" : "play"));
}

} // namespace knead
