#pragma once

#include <QList>

class QAction;
class QActionGroup;
class QObject;
class QWidget;

namespace knead {

/// Everything a person can ask for by menu, button or key. Names of the actions are their object names.
struct Actions {
    /// Makes them all; they work wherever the keyboard is in `window`.
    explicit Actions(QWidget* window);

    QAction* newWindow;
    QAction* open;
    QAction* openWithChoices;
    QAction* addPart;
    QAction* firstPage;
    QAction* save;
    QAction* saveAs;
    QAction* recover;
    QAction* exportMeshes;
    QAction* exportRecipe;
    QAction* quit;

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
    QAction* recordVideo;
    QAction* recordPictures;

    QList<QAction*> addTool; ///< one per form, in the order of toolKindLooks()
    QAction* renormalize;
    QAction* refillNow;
    QAction* cutHere;
    QAction* fixFaces;
    QAction* remove;
    QAction* cancel;

    QAction* fit;
    QAction* front;
    QAction* back;
    QAction* right;
    QAction* left;
    QAction* top;
    QAction* bottom;
    QAction* isometric;
    QAction* perspective;
    QAction* oneView; ///< exclusive with the next two
    QAction* twoViews;
    QAction* fourViews;
    QAction* viewAlone;
    QAction* nextView;
    QAction* linkedViews;
    QAction* objects;
    QAction* allObjects;
    QAction* edges;
    QAction* openEdges;
    QAction* grid;
    QAction* hide;
    QAction* lightTheme;
    QAction* darkTheme;
    QAction* systemTheme;

    QAction* palette;
    QAction* preferences;
    QAction* shortcuts;
    QAction* resetLayout;
    QAction* fullScreen;
    QAction* tour;
    QAction* handbook;
    QAction* controls;
    QAction* about;

    /// Turns on or off what only makes sense with an open part.
    /// @param isSimulated whether it has bodies, and not only surfaces to look at
    void setDocumentOpen(bool isOpen, bool isSimulated);
    /// The first button says what a click will do.
    void setPlaying(bool playing);
    static QStringList textsOfPlay(); ///< what it says by turns
};

} // namespace knead
