#pragma once

#include "core/model/file_preview.h"
#include "core/session/added_start.h"
#include "core/session/filled_model.h"
#include "ui/frame/workbench.h"
#include "ui/panels/place_rows.h"

#include <QObject>

#include <functional>
#include <map>
#include <string>
#include <vector>

class QAction;
class QWidget;

namespace knead {

class ImportPanel;
class ProjectsFeature;
class RecipesFeature;

/// How files come into the window: opened with and without choices, taken in another unit or healed, filled anew; and the report on
/// them. Window thread only.
class ImportFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QAction* open;
        QAction* openWithChoices;
        QAction* addPart;
    };

    ImportFeature(const Workbench& bench, ProjectsFeature& projects, RecipesFeature& recipes);

    const Actions& actions() const { return m_actions; }

    /// Opens files in the background, several as one assembly, or a project, or a recipe. A failure is shown in a
    /// sentence and leaves everything as it was; what is not saved is not asked about.
    void open(const QStringList& paths);
    void open(const ImportChoices& request);
    /// Opens a file with its parts of another material than usual, once what is not saved may go.
    /// @param preset of the services' materials; one that is not there: the usual one
    /// @param then called when it is open
    void openOf(const std::string& preset, const QString& path, std::function<void()> then);
    /// Looks into the files first and asks what is wanted of them.
    void openWithChoices(const QStringList& paths);
    /// Once what is not saved may go.
    void openInstead(const QStringList& paths);
    void askForFile(bool withChoices);
    /// Puts the parts of files beside those that are open, in the background: the next entry of the history.
    void addParts(const QStringList& paths);
    /// Fills the bodies anew in the background. @param spacing [m]
    void refill(double spacing);

    void tellOfModel(); ///< in the log
    /// The report, and what matters most of it in the banner: once, not with work that was done in spite of it.
    void showImport();
    void showNothing(); ///< the part was closed

signals:
    void placeWanted(const knead::ReportPlace& place); ///< of a row of the report
    /// Parts that were kneaded were made parts of the shape that they have, for others to come beside them.
    void shapesTaken(const knead::ExportReport& report);

private:
    ImportChoices usualChoices(const QStringList& paths) const;
    void open(const ImportChoices& request, const Material& material, std::function<void()> then);
    void askForParts();
    void askForChoices(std::vector<FilePreview> previews);
    void startAdding(const QStringList& paths);
    void showAdded(PreparedAddition addition, const QStringList& paths);
    void tellOfSurfaces(std::size_t first, const std::map<std::size_t, Message>& before,
                        const std::vector<std::size_t>& origin);
    void startRefill(double spacing);
    void refillOnceMore(double spacing);
    void showRefilled(PreparedModel prepared);
    void openAgain(const QString& title, std::function<Model(const Model&)> change, const ImportChoices& request);
    void takeIn(const QString& unit);
    void takeHealed(bool heal);
    void fillOpenParts();

    Workbench m_bench;
    Actions m_actions;
    ProjectsFeature& m_projects;
    RecipesFeature& m_recipes;
    ImportPanel* m_panel;
};

} // namespace knead
