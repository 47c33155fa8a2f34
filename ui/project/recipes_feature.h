#pragma once

#include "ui/frame/workbench.h"

#include <QObject>
#include <QStringList>

#include <memory>

class QAction;

namespace knead {

class ProjectsFeature;

/// Recipes: opened, to be played; and written, of what was done. Window thread only.
class RecipesFeature final : public QObject {
    Q_OBJECT
public:
    RecipesFeature(const Workbench& bench, ProjectsFeature& projects);

    QAction* exportAction() const { return m_export; }

    /// Files that the opened recipe names; they are offered when it has come to its end.
    const QStringList& namedExports() const { return m_exports; }

    /// @return whether they were a matter of recipes
    bool opened(const QStringList& paths);
    /// Writes the session as a recipe in the background.
    void exportTo(const QString& path);

signals:
    void exportWanted();

private:
    void offerExports();
    void open(const QString& path);
    void askForRecipe();
    void write(const QString& path);

    Workbench m_bench;
    ProjectsFeature& m_projects;
    QAction* m_export;
    QStringList m_exports;
    std::shared_ptr<const Model> m_model; ///< of the recipe
};

} // namespace knead
