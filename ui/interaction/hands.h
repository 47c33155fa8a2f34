#pragma once

#include "ui/frame/workbench.h"
#include "ui/interaction/hand_settings.h"
#include "ui/interaction/space_motion.h"

#include <QList>
#include <QObject>

#include <memory>
#include <vector>

class QAction;
class QMenu;
class QToolBar;

namespace knead {

class GizmoHand;
class HandPanel;
class KeyHand;
class PressHand;
class SculptHand;
class SpaceHand;

/// All ways in which a person's hands move tools and material in a view, with their actions and their panel.
class Hands final : public QObject {
    Q_OBJECT
public:
    explicit Hands(const Workbench& bench);

    HandPanel* makePanel();
    void addTo(QMenu* menu) const;
    void listen(const ListenToSpaceMouse& listen);

    /// Gives the keys back to the window. @return whether they drove tools
    bool leaveKeys();
    bool changeBrush(double factor) const; ///< see HandsFeature
    QString hint() const;                  ///< on what the mouse does now; empty: as always
    /// What the left button does to the material instead of selecting: pressing with a tool, and the brushes.
    QList<QAction*> modes() const;
    QToolBar* newSculptBar(QWidget* parent) const;
    QAction* forceTableAction() const { return m_forceTable; }
    QAction* forcesOfStrokesAction() const { return m_forcesOfStrokes; } ///< in plot and table
    QAction* forcePlotAction() const { return m_forcePlot; }

    const GizmoHand& gizmo() const { return *m_gizmoHand; }
    const KeyHand& keys() const { return *m_keyHand; }
    const SculptHand& sculpting() const { return *m_sculptHand; }
    const PressHand& pressing() const { return *m_pressHand; }
    HandSettings& settings() { return m_settings; }

signals:
    void modeChanged();
    void problem(const QString& sentence);

private:
    QAction* make(const char* name, const QString& text, const char* picture, const QKeySequence& key,
                  const QString& tip, bool isCheckable = true);
    void makeActions();
    void makeBrushes();
    void connectActions();
    void keep(QAction* action, bool HandChoices::*choice);

    Workbench m_bench;
    HandSettings m_settings;
    KeyHand* m_keyHand; // owned by the view, as the others
    PressHand* m_pressHand;
    SculptHand* m_sculptHand;
    GizmoHand* m_gizmoHand; // asked first: numbers are typed into it while keys drive other tools
    SpaceHand* m_spaceHand;
    QAction* m_gizmo = nullptr;
    QAction* m_ownAxes = nullptr;
    QAction* m_keys = nullptr;
    QAction* m_press = nullptr;
    std::vector<QAction*> m_brushes; ///< by SculptBrush
    QAction* m_holdsRest = nullptr;
    std::vector<QAction*> m_mirrors;      ///< x, y, z
    std::vector<QAction*> m_brushChanges; ///< of its strength
    QAction* m_spaceMouse = nullptr;
    QAction* m_forces = nullptr;
    QAction* m_forcePlot = nullptr;
    QAction* m_forceTable = nullptr;
    QAction* m_forcesOfStrokes = nullptr;
};

} // namespace knead
