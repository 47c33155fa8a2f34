#pragma once

#include "ui/document/document.h"
#include "ui/document/export_request.h"
#include "ui/recording/recording.h"
#include "ui/services.h"
#include "ui/shell/preferences_dialog.h"
#include "ui/tasks/task_runner.h"
#include "ui/theme.h"

#include <QMainWindow>

#include <functional>
#include <memory>
#include <utility>

class QAction;
class QLabel;
class QMenu;
class QStackedWidget;

namespace knead {

struct Actions;
struct Comparison;
struct ComparisonReport;
struct OverlayMark;
class Banner;
class Display;
class ExportPanel;
class Hands;
class HomePage;
class ImportPanel;
class LogPanel;
class Measuring;
class PerformancePanel;
class ProbeSet;
class ProjectKeeper;
class MaterialPanel;
class MaterialStore;
class ModelTree;
class Modes;
struct SelectionActions;
class SelectionPanel;
class SimulationPanel;
class StatusReadings;
class TaskReading;
class TimelinePanel;
class ViewGrid;
class ViewportWidget;

/// The program's window: tree, properties, view, log and status bar around one document.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(Services services, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens files in the background, several as one assembly, or a project, or a recipe. A failure is shown in a
    /// sentence and leaves everything as it was; what is not saved is not asked about.
    void open(const QStringList& paths);
    void open(const ImportChoices& request);
    /// Looks into the files first and asks what is wanted of them.
    void openWithChoices(const QStringList& paths);
    /// Writes the deformed parts in the background; the ending decides the format.
    void exportTo(const QString& path, const ExportRequest& request = {});
    /// Writes the session as a recipe in the background.
    void exportRecipe(const QString& path);
    /// Writes the forces over time as a table in the background.
    void exportForces(const QString& path);
    /// Fills the bodies anew in the background. @param spacing [m]
    void refill(double spacing);

    /// Offers work that windows which are gone did not save.
    void offerRecoveries();
    /// Shows the tour of the window to who has not seen it.
    void offerTour();
    void setTheme(Theme theme);
    /// Keeps them, and does as they say at once.
    void setPreferences(const Preferences& now);

    /// Makes a video or pictures of what was simulated, in the background.
    /// @param path of the file, or of the folder of the pictures
    void record(const QString& path, const Recording& recording);

    /// Writes what was measured as a table in the background.
    void writeMeasurements(const QString& path);
    /// Writes what probes read over time as a table in the background.
    void writeProbes(const QString& path);
    /// Writes a report as PDF or HTML in the background; the ending decides.
    void writeComparison(const QString& path, const Comparison& comparison);

    Document& document() { return m_document; }
    TaskRunner& tasks() { return m_tasks; }
    ProjectKeeper& projects() { return *m_projects; }
    ViewportWidget& viewport() { return *m_viewport; } ///< the active view
    ViewGrid& views() { return *m_views; }
    Measuring& measuring() { return *m_measuring; }
    ProbeSet& probes() { return *m_probes; }
    Banner& banner() { return *m_banner; }
    Hands& hands() { return *m_hands; }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    static constexpr int layoutVersion = 2; ///< of the docks; layouts of another version are not restored

    void makeCenter();
    void makeDocks();
    void makeDisplay();
    void makeMaterials();
    void makeSimulation();
    void makeMeasuring();
    void makeProbes();
    std::vector<OverlayMark> probeMarks() const;
    void makeHands();
    void connectHands();
    void askForForces();
    void makeMenus();
    void makeToolBar();
    void makeStatusBar();
    void sizeDocks();
    void connectFileActions();
    void connectSimulationActions();
    void connectViewActions();
    void connectViews();
    void showViews();
    void connectTasks();
    void restoreSettings();

    // Selecting, and the lines of the model tree (main_window_selection.cpp)
    void makeSelection();
    void makeSelectionMenus();
    void makeSelectionBar();
    void connectSelection();
    void connectTree();
    void fillTreeMenu(QMenu& menu, int type) const;
    void showLevel();
    void showSelected();
    void showLock();
    void selectAll();
    void selectWithin(double distance);

    void makeProjects();
    void showTitle();
    void listRecent();
    void openRecent(const QString& path);
    void openInstead(const QStringList& paths);
    bool openedAsProject(const QStringList& paths);
    bool openedAsRecipe(const QStringList& paths);
    void openRecipe(const QString& path);
    void askForRecipe();
    void writeRecipe(const QString& path);
    void openPrepared(PreparedContent prepared);

    void documentChanged(Document::Change what);
    void contentChanged();
    void showSurroundings();
    void showHint();
    void showSteppable(bool isPlaying);
    void frameChanged();
    void selectionChanged();
    void historyChanged();
    void showHealth(const Health& health);
    void showNotice(const std::string& notice);
    void showRemark(const QString& sentence);
    void showWalls(const SpacingAssessment& fineness);
    void showBalance(const QString& sentence);
    /// @param remedy what a click on the banner's button does
    void showProblem(const QString& sentence, const QString& remedyText = {}, std::function<void()> remedy = {});
    /// The same with a second button, which goes back to the start.
    void showTrouble(const QString& sentence, const QString& remedyText, std::function<void()> remedy);
    void showImport();
    void optionsChanged();
    void setGravity(bool on);
    void setFloor(bool on);
    void connectRecording();
    void askForRecording(Recording::Kind kind);
    void askForPlace(const Recording& recording);
    void askForFile(bool withChoices);
    void askForChoices(std::vector<FilePreview> previews);
    void takeIn(const QString& unit);
    void takeHealed(bool heal);
    void startRefill(double spacing);
    void refillOnceMore(double spacing);
    void showRefilled(PreparedContent prepared);
    void fillOpenParts();
    void openAgain(const QString& title, std::function<Model(const Model&)> change, const ImportChoices& request);
    void askForExport();
    void askForPlace(const ExportRequest& request, const Services::Format& format);
    struct PlannedFile {
        std::string path;
        ExportJob job;
    };
    std::vector<PlannedFile> planFiles(const QString& path, const ExportRequest& request) const;
    std::vector<bool> partsFor(ExportRequest::Which which) const;
    void showExport(const std::vector<ExportReport>& reports);
    void askForTextFile(const QString& title, const QString& ending, const QStringList& filters,
                        std::function<void(const QString& path)> then);
    void writeFile(const QString& path, std::function<QByteArray()> bytes);
    void askForMeasurementFile();
    void compareWithOriginal();
    ComparisonReport newReport() const;
    void showComparison(const ComparisonReport& report);
    void writeReport(const QString& path, const ComparisonReport& report);
    void cancel();
    void showControls();
    bool isBusy();

    struct Shell;
    using ShellPointer = std::unique_ptr<Shell, void (*)(Shell*)>;
    ShellPointer newShell();
    void makeShell();
    void listPanels();
    void listSelectionBar(QMenu& panels);
    void showSelectionBar(bool isView);
    void resetLayout();
    void keepHintClear();
    void showPreferences(PreferencesDialog::Page page);
    void applyPreferences();
    void chooseLook(Preferences::Look look);
    void chooseThreads(int threads);
    void applyLook();
    void sayAllAnew();
    QString whyDisabled(const QAction& action) const;
    void keepPicture(const QString& path);
    void showTour();
    void showAbout();

    Services m_services;
    Preferences m_preferences = readPreferences();
    ShellPointer m_shell = newShell();
    std::unique_ptr<ProjectKeeper> m_projects; // goes after the document
    bool m_mayClose = false;                   ///< what is not saved is not wanted
    TaskRunner m_tasks;
    Document m_document;
    std::unique_ptr<Actions> m_actions;
    Modes* m_modes; ///< of the left mouse button
    std::unique_ptr<SelectionActions> m_selection;
    SelectionPanel* m_selectionPanel = nullptr;
    QLabel* m_selectionReading = nullptr;
    Banner* m_banner = nullptr;
    QStackedWidget* m_pages = nullptr;
    HomePage* m_home = nullptr;
    ViewGrid* m_views = nullptr;
    ViewportWidget* m_viewport = nullptr; ///< the active one of them
    Display* m_display = nullptr;
    Hands* m_hands = nullptr;
    ModelTree* m_tree = nullptr;
    QStackedWidget* m_properties = nullptr;
    MaterialStore* m_materials = nullptr;
    MaterialPanel* m_material = nullptr;
    LogPanel* m_log = nullptr;
    ImportPanel* m_import = nullptr;
    ExportPanel* m_export = nullptr;
    PerformancePanel* m_performance = nullptr;
    TimelinePanel* m_timeline = nullptr;
    SimulationPanel* m_simulation = nullptr;
    Measuring* m_measuring = nullptr;
    ProbeSet* m_probes = nullptr;
    QMenu* m_addTool = nullptr;
    QMenu* m_recent = nullptr;
    QLabel* m_hint = nullptr;
    StatusReadings* m_readings = nullptr;
    TaskReading* m_taskReading = nullptr;
    std::pair<bool, bool> m_surroundings; ///< gravity and floor, as last seen
    std::string m_shownHealth;            ///< message last put into the banner
    QString m_shownImbalance;             ///< why no balance was found last
    QString m_shownWalls;                 ///< sentence of the present filling; empty: its walls are well
    std::string m_shownNotice;            ///< last put into the log
    std::function<void()> m_remedy;
};

} // namespace knead
