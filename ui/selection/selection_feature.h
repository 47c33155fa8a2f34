#pragma once

#include "ui/frame/workbench.h"
#include "ui/selection_actions.h"

#include <QObject>

class QLabel;
class QMenu;
class QStackedWidget;
class QToolBar;

namespace knead {

class Display;
class HandsFeature;
class MaterialStore;
class ModelTree;
class Modes;
class SelectionPanel;
class SimulationFeature;

/// Selecting, and what is done with what is selected and with lines of the model tree. Window thread only.
class SelectionFeature final : public QObject {
    Q_OBJECT
public:
    /// What the window has beside the workbench that this has to do with.
    struct Parts {
        const SimulationFeature& simulation;
        const HandsFeature& hands;
        Modes& modes;
        ModelTree& tree;
        QStackedWidget& properties; ///< gets a page, in the order of Selection::Kind
        MaterialStore& materials;
        Display& display;
    };
    SelectionFeature(const Workbench& bench, const Parts& parts);

    const SelectionActions& actions() const { return m_actions; }
    QMenu* newMenu();                  ///< of the menu bar
    QToolBar* newBar(QWidget* parent); ///< for beside the view, where the hand is

private:
    void connectSelection();
    void connectTree();
    void sayWhyNot();
    void fillTreeMenu(QMenu& menu, int type) const;
    void showLevel();
    void showSelected();
    void showLock();
    void selectAll();
    void selectWithin(double distance);

    Workbench m_bench;
    const SimulationFeature& m_simulation;
    const HandsFeature& m_hands;
    Modes& m_modes;
    ModelTree& m_tree;
    QStackedWidget& m_properties;
    Display& m_display;
    SelectionActions m_actions;
    SelectionPanel* m_panel;
    QLabel* m_reading; ///< how much is selected, in the status bar
};

} // namespace knead
