#pragma once

#include "core/aggregate/spacing_choice.h"
#include "core/message/message.h"
#include "core/simulation/snapshot.h"
#include "ui/frame/workbench.h"
#include "ui/simulation/simulation_actions.h"

#include <QObject>

#include <optional>
#include <utility>

class QMenu;

namespace knead {

class ImportFeature;
class PerformancePanel;
class SimulationPanel;
class StatusReadings;

/// How time runs: playing, gravity and floor, what is said of the run, and what is offered when it had to stop. Window thread only.
class SimulationFeature final : public QObject {
    Q_OBJECT
public:
    /// @param imports fills bodies anew where that is offered
    SimulationFeature(const Workbench& bench, StatusReadings& readings, ImportFeature& imports);

    const SimulationActions& actions() const { return m_actions; }

    QList<QMenu*> newMenus() const; ///< of its choices
    void showThreads(int threads);  ///< that compute
    void showFrame();               ///< the document has another one
    void showSurroundings();        ///< the switches say what the simulation has
    /// Too few cells across walls, with a filling that has enough.
    void showWalls(const SpacingAssessment& fineness);

signals:
    void threadsChosen(int threads);

private:
    void connectActions();
    void sayWhyNot();
    void documentChanged(Document::Change what);
    void showSteppable(bool isPlaying);
    void showHistory();
    void showHealth(const Health& health);
    void showNotice(const Message& notice);
    void showBalance(const QString& sentence);
    void setGravity(bool on);
    void setFloor(bool on);

    Workbench m_bench;
    SimulationActions m_actions;
    StatusReadings& m_readings;
    ImportFeature& m_imports;
    SimulationPanel* m_panel;
    PerformancePanel* m_performance;
    std::pair<bool, bool> m_surroundings; ///< gravity and floor, as last seen
    bool m_isSteppable = true;            ///< time stands still
    std::optional<QString> m_undoes;      ///< name of what would be undone
    std::optional<QString> m_redoes;
    Message m_shownHealth;    ///< message last put into the banner
    QString m_shownImbalance; ///< why no balance was found last
    QString m_shownWalls;     ///< sentence of the present filling; empty: its walls are well
    Message m_shownNotice;    ///< last said
};

} // namespace knead
