#pragma once

#include "ui/frame/workbench.h"

#include <QObject>

class QAction;

namespace knead {

class ProjectsFeature;

/// Recipes: opened, to be played; and written, of what was done. Window thread only.
class RecipesFeature final : public QObject {
    Q_OBJECT
public:
    RecipesFeature(const Workbench& bench, ProjectsFeature& projects);

    QAction* exportAction() const { return m_export; }

    /// @return whether they were a matter of recipes
    bool opened(const QStringList& paths);
    /// Writes the session as a recipe in the background.
    void exportTo(const QString& path);

private:
    void open(const QString& path);
    void askForRecipe();
    void write(const QString& path);

    Workbench m_bench;
    ProjectsFeature& m_projects;
    QAction* m_export;
};

} // namespace knead
