#pragma once

#include "ui/frame/workbench.h"
#include "ui/project/recipe_services.h"

#include <QObject>
#include <QString>

class QAction;

namespace knead {

class ProjectsFeature;

/// Does to another part what was done here: its next revision, say. Window thread only.
class OtherPartFeature final : public QObject {
    Q_OBJECT
public:
    OtherPartFeature(const Workbench& bench, ProjectsFeature& projects);

    QAction* action() const { return m_action; }

    /// Finds the faces of the open part again on that of a file, shows what was found and offers to open it.
    void applyTo(const QString& path, const TransferOptions& options = {});
    /// Asks how that part follows from the open one first.
    void askAbout(const QString& path);

private:
    struct Found;

    void ask();
    void find(const QString& path, const TransferOptions& options);
    void show(const Found& found);
    void open(const Found& found);

    Workbench m_bench;
    ProjectsFeature& m_projects;
    QAction* m_action;
};

} // namespace knead
