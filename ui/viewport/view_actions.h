#pragma once

class QAction;
class QWidget;

namespace knead {

/// What a person can ask of the views: from where, and how many.
struct ViewActions {
    explicit ViewActions(QWidget& window);

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
};

} // namespace knead
