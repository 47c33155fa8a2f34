#pragma once

#include "ui/frame/workbench.h"

#include <QObject>

class QAction;

namespace knead {

class ProjectKeeper;
class TracePanel;

/// Shows what one does as Python, and writes it to files. Window thread only.
class TraceFeature final : public QObject {
    Q_OBJECT
public:
    TraceFeature(const Workbench& bench, ProjectKeeper& projects);

    QAction* action() const { return m_action; } ///< shows the panel
    TracePanel& panel() { return *m_panel; }

    /// Writes what was done until now as a script, in the background.
    void saveTo(const QString& path);

private:
    Workbench m_bench;
    ProjectKeeper& m_projects;
    TracePanel* m_panel;
    QAction* m_action;
};

} // namespace knead
