#include "ui/actions.h"

#include "ui/document/tool_kinds.h"
#include "ui/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

#include <string_view>

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

/// "addBlock", "addBall" ...; their data is their place in toolsToAdd().
QList<QAction*> makeToolActions(QWidget* window)
{
    QList<QAction*> actions;
    for (const ToolKindLook& look : toolsToAdd()) {
        const QByteArray name = QByteArray("add") + look.name;
        const char* tip = QT_TRANSLATE_NOOP("Actions", "Put one above the part to push it with");
        if (look.name == std::string_view("Knife") || look.name == std::string_view("Wire"))
            tip =
                QT_TRANSLATE_NOOP("Actions", "Put one above the part to cut it with: the force is the toughness of its "
                                             "material times the width of the cut");
        if (look.rollsFreely)
            tip = QT_TRANSLATE_NOOP("Actions", "Put one above the part to roll it out with: it turns as it is moved");
        const QList<QKeySequence> keys =
            look.kind == ToolKind::box ? QList<QKeySequence>{Qt::Key_B} : QList<QKeySequence>{};
        QAction* action = make(window, {name, look.name, look.icon, keys, tip});
        action->setData(static_cast<int>(actions.size()));
        actions.append(action);
    }
    return actions;
}

} // namespace

Actions::Actions(QWidget* window)
    : newWindow(make(window, {"newWindow",
                              QT_TR_NOOP("&New window"),
                              nullptr,
                              {QKeySequence("Ctrl+N")},
                              QT_TR_NOOP("Begin something else; what is open here stays")}))
    , open(make(window, {"open",
                         QT_TR_NOOP("&Open..."),
                         "open",
                         {QKeySequence("Ctrl+O")},
                         QT_TR_NOOP("Open a part, a project or a recipe")}))
    , openWithChoices(
          make(window, {"openWithChoices",
                        QT_TR_NOOP("Open with &choices..."),
                        nullptr,
                        {QKeySequence("Ctrl+Shift+O")},
                        QT_TR_NOOP("Look into files and choose parts, detail and units before they are opened")}))
    , addPart(make(window, {"addPart",
                            QT_TR_NOOP("Add &part..."),
                            nullptr,
                            {},
                            QT_TR_NOOP("Open more parts together with those that are open, as one assembly: the work "
                                       "begins anew")}))
    , firstPage(make(window, {"firstPage",
                              QT_TR_NOOP("First pa&ge"),
                              nullptr,
                              {},
                              QT_TR_NOOP("Examples and files of late; the part that is open stays, and Esc comes back"),
                              true}))
    , save(make(window, {"save",
                         QT_TR_NOOP("&Save"),
                         "save",
                         {QKeySequence("Ctrl+S")},
                         QT_TR_NOOP("Keep part, history and view in a project file")}))
    , saveAs(make(window, {"saveAs",
                           QT_TR_NOOP("Save &as..."),
                           nullptr,
                           {QKeySequence("Ctrl+Shift+S")},
                           QT_TR_NOOP("Keep the project in another file and go on with that")}))
    , recover(make(window, {"recover",
                            QT_TR_NOOP("Recover &unsaved work..."),
                            nullptr,
                            {},
                            QT_TR_NOOP("Look for work that was not saved when Knead ended")}))
    , exportMeshes(make(window, {"export",
                                 QT_TR_NOOP("&Export..."),
                                 "export",
                                 {QKeySequence("Ctrl+E")},
                                 QT_TR_NOOP("Write the deformed part to a file")}))
    , exportRecipe(
          make(window, {"exportRecipe",
                        QT_TR_NOOP("Export as &recipe..."),
                        nullptr,
                        {},
                        QT_TR_NOOP("Write what was done as a recipe, to be read, changed and carried out again")}))
    , quit(make(window, {"quit", QT_TR_NOOP("&Quit"), nullptr, {QKeySequence("Ctrl+Q")}}))
    , undo(make(window, {"undo", QT_TR_NOOP("Undo"), "undo", {QKeySequence("Ctrl+Z")}}))
    , redo(make(window, {"redo", QT_TR_NOOP("Redo"), "redo", {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}}))
    , play(make(window,
                {"play", QT_TR_NOOP("Play"), "play", {Qt::Key_Space}, QT_TR_NOOP("Run or pause the simulation")}))
    , step(make(window, {"step", QT_TR_NOOP("Step"), "step", {Qt::Key_Period}, QT_TR_NOOP("One time step")}))
    , findBalance(
          make(window, {"findBalance",
                        QT_TR_NOOP("Find balance"),
                        "balance",
                        {QKeySequence("Ctrl+B")},
                        QT_TR_NOOP("Put the part where forces balance now, without waiting until it is at rest")}))
    , pressIt(make(window, {"pressIt",
                            QT_TR_NOOP("Press it"),
                            "press-it",
                            {},
                            QT_TR_NOOP("Hold one end of the new part and let a block press it, to see what it does")}))
    , reset(make(window, {"reset",
                          QT_TR_NOOP("Reset"),
                          "reset",
                          {Qt::Key_Backspace, QKeySequence("Ctrl+R")},
                          QT_TR_NOOP("Back to the start")}))
    , gravity(make(window, {"gravity",
                            QT_TR_NOOP("Gravity"),
                            "gravity",
                            {Qt::Key_G},
                            QT_TR_NOOP("Let everything weigh something"),
                            true}))
    , floor(make(window,
                 {"floor", QT_TR_NOOP("Floor"), "floor", {}, QT_TR_NOOP("Put a floor under the part"), true, true}))
    , keepUp(make(window,
                  {"keepUp",
                   QT_TR_NOOP("Keep up with real time"),
                   nullptr,
                   {},
                   QT_TR_NOOP("Where implicit steps are slower than real time, solve them more roughly (forces "
                              "within 3 % of the largest), then take one per 1/30 s. Without this, time runs slower"),
                   true,
                   true}))
    , recordVideo(make(window, {"recordVideo",
                                QT_TR_NOOP("Record &video..."),
                                "record",
                                {},
                                QT_TR_NOOP("Make a video of what was simulated, as the view shows it")}))
    , recordPictures(make(window, {"recordPictures",
                                   QT_TR_NOOP("Record p&ictures..."),
                                   nullptr,
                                   {},
                                   QT_TR_NOOP("Write what was simulated as a sequence of pictures")}))
    , addTool(makeToolActions(window))
    , renormalize(
          make(window,
               {"renormalize",
                QT_TR_NOOP("Re-normalize"),
                "renormalize",
                {Qt::Key_N},
                QT_TR_NOOP("The selected body, or every one, takes its present shape for its own: stress is gone, the "
                           "shape stays")}))
    , refillNow(make(
          window,
          {"refillNow",
           QT_TR_NOOP("Refill as it is"),
           "refill",
           {},
           QT_TR_NOOP("The selected body, or every one that yields, gets new objects in the shape that it has, and "
                      "goes on with its stress and motion. Where its lattice is no good any more this happens by "
                      "itself")}))
    , cutHere(make(window,
                   {"cutHere",
                    QT_TR_NOOP("Cut at section plane"),
                    "cut",
                    {},
                    QT_TR_NOOP("The selected body, or every one that deforms, is cut in two where the section plane "
                               "is now, without force")}))
    , fixFaces(make(window, {"fixFaces",
                             QT_TR_NOOP("Fix faces"),
                             "fix",
                             {Qt::Key_X},
                             QT_TR_NOOP("Click faces of the part to hold them in place"),
                             true}))
    , remove(make(window, {"remove",
                           QT_TR_NOOP("Remove"),
                           "delete",
                           {Qt::Key_Delete},
                           QT_TR_NOOP("Remove the selected tool or fixture")}))
    , cancel(make(window,
                  {"cancel", QT_TR_NOOP("Cancel"), "close", {Qt::Key_Escape}, QT_TR_NOOP("Stop what is being done")}))
    , fit(make(window, {"fit", QT_TR_NOOP("Fit"), "fit", {Qt::Key_F}, QT_TR_NOOP("Show everything")}))
    , front(make(window, {"viewFront", QT_TR_NOOP("Front"), nullptr, {QKeySequence("Num+1")}}))
    , back(make(window, {"viewBack", QT_TR_NOOP("Back"), nullptr, {QKeySequence("Ctrl+1")}}))
    , right(make(window, {"viewRight", QT_TR_NOOP("Right"), nullptr, {QKeySequence("Num+3")}}))
    , left(make(window, {"viewLeft", QT_TR_NOOP("Left"), nullptr, {QKeySequence("Ctrl+3")}}))
    , top(make(window, {"viewTop", QT_TR_NOOP("Top"), nullptr, {Qt::Key_7}}))
    , bottom(make(window, {"viewBottom", QT_TR_NOOP("Bottom"), nullptr, {QKeySequence("Ctrl+7")}}))
    , isometric(make(window, {"viewIsometric", QT_TR_NOOP("Isometric"), nullptr, {Qt::Key_0}}))
    , perspective(make(window, {"perspective", QT_TR_NOOP("Perspective"), nullptr, {Qt::Key_5}, nullptr, true, true}))
    , oneView(make(window, {"oneView",
                            QT_TR_NOOP("One view"),
                            nullptr,
                            {QKeySequence("Shift+F1")},
                            QT_TR_NOOP("One view of the part"),
                            true,
                            true}))
    , twoViews(make(window, {"twoViews",
                             QT_TR_NOOP("Two views"),
                             nullptr,
                             {QKeySequence("Shift+F2")},
                             QT_TR_NOOP("Two views of the part, side by side"),
                             true}))
    , fourViews(make(window, {"fourViews",
                              QT_TR_NOOP("Four views"),
                              nullptr,
                              {QKeySequence("Shift+F4")},
                              QT_TR_NOOP("Front, top, right and the free view of the part"),
                              true}))
    , viewAlone(make(window, {"viewAlone",
                              QT_TR_NOOP("Active view alone"),
                              nullptr,
                              {Qt::Key_V},
                              QT_TR_NOOP("Show the active view alone, and all of them again"),
                              true}))
    , nextView(make(window, {"nextView",
                             QT_TR_NOOP("Next view"),
                             nullptr,
                             {QKeySequence("Ctrl+Tab")},
                             QT_TR_NOOP("Make the next of several views the active one")}))
    , linkedViews(make(window, {"linkedViews",
                                QT_TR_NOOP("Linked cameras"),
                                nullptr,
                                {QKeySequence("Shift+F5")},
                                QT_TR_NOOP("What is panned or zoomed in one view is in all of them"),
                                true}))
    , objects(make(window, {"objects",
                            QT_TR_NOOP("Objects"),
                            "objects",
                            {Qt::Key_O},
                            QT_TR_NOOP("Show the objects the material is made of"),
                            true}))
    , allObjects(make(
          window, {"allObjects", QT_TR_NOOP("Inner objects too"), nullptr, {QKeySequence("Shift+O")}, nullptr, true}))
    , edges(make(window, {"edges", QT_TR_NOOP("Edges"), nullptr, {Qt::Key_E}, nullptr, true, true}))
    , openEdges(make(window, {"openEdges",
                              QT_TR_NOOP("Open edges"),
                              nullptr,
                              {},
                              QT_TR_NOOP("Show where surfaces that are not closed end"),
                              true,
                              true}))
    , grid(make(window, {"grid", QT_TR_NOOP("Grid"), nullptr, {}, nullptr, true, true}))
    , hide(make(window, {"hide", QT_TR_NOOP("Hide or show body"), nullptr, {Qt::Key_H}}))
    , lightTheme(make(window, {"lightTheme", QT_TR_NOOP("Light"), nullptr, {}, nullptr, true}))
    , darkTheme(make(window, {"darkTheme", QT_TR_NOOP("Dark"), nullptr, {}, nullptr, true}))
    , systemTheme(make(window, {"systemTheme", QT_TR_NOOP("As the system"), nullptr, {}, nullptr, true}))
    , palette(make(window, {"palette",
                            QT_TR_NOOP("Find a command..."),
                            nullptr,
                            {QKeySequence("Ctrl+K")},
                            QT_TR_NOOP("Find any command by a few of its letters and do it")}))
    , preferences(make(window, {"preferences",
                                QT_TR_NOOP("&Preferences..."),
                                nullptr,
                                {QKeySequence("Ctrl+,")},
                                QT_TR_NOOP("Theme, language, units, memory, files, view")}))
    , shortcuts(make(
          window,
          {"shortcuts", QT_TR_NOOP("&Keyboard shortcuts..."), nullptr, {}, QT_TR_NOOP("Give commands other keys")}))
    , resetLayout(make(
          window,
          {"resetLayout", QT_TR_NOOP("Reset layout"), nullptr, {}, QT_TR_NOOP("Put all panels back where they came")}))
    , fullScreen(make(window, {"fullScreen", QT_TR_NOOP("Full screen"), nullptr, {Qt::Key_F11}, nullptr, true}))
    , tour(make(window,
                {"tour", QT_TR_NOOP("&Tour of the window"), nullptr, {}, QT_TR_NOOP("What is where, in a minute")}))
    , handbook(make(
          window,
          {"handbook", QT_TR_NOOP("&Handbook"), nullptr, {Qt::Key_F1}, QT_TR_NOOP("At the page of what one does")}))
    , controls(make(window, {"controls", QT_TR_NOOP("Mouse and keys"), nullptr, {}}))
    , about(make(window, {"about", QT_TR_NOOP("About Knead")}))
{
    auto* themes = new QActionGroup(window);
    for (QAction* theme : {lightTheme, darkTheme, systemTheme})
        themes->addAction(theme);
    auto* arrangements = new QActionGroup(window);
    for (QAction* arrangement : {oneView, twoViews, fourViews})
        arrangements->addAction(arrangement);
    undo->setEnabled(false);
    redo->setEnabled(false);
    setDocumentOpen(false, false);
}

void Actions::setDocumentOpen(bool isOpen, bool isSimulated)
{
    for (QAction* action : {addPart, firstPage, save, saveAs, fit, front, back, right, left, top, bottom, isometric,
                            perspective, oneView, twoViews, fourViews, edges, openEdges, grid})
        action->setEnabled(isOpen);
    for (QAction* action :
         {exportMeshes, exportRecipe, play, step, findBalance, reset, gravity, floor, keepUp, recordVideo,
          recordPictures, renormalize, refillNow, cutHere, fixFaces, remove, objects, allObjects, hide})
        action->setEnabled(isSimulated);
    for (QAction* action : addTool)
        action->setEnabled(isSimulated);
}

QStringList Actions::textsOfPlay()
{
    return {tr("Play"), tr("Pause")};
}

void Actions::setPlaying(bool playing)
{
    const QString text = textsOfPlay()[playing ? 1 : 0];
    if (play->text() == text)
        return;
    play->setText(text);
    play->setIcon(icon(playing ? "pause" : "play"));
}

} // namespace knead
