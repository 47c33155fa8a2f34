#pragma once

#include "ui/commands/availability.h"
#include "ui/document/document.h"
#include "ui/frame/docks.h"
#include "ui/frame/workbench.h"
#include "ui/preferences/preferences.h"
#include "ui/services.h"
#include "ui/tasks/task_runner.h"

#include <QMainWindow>

#include <memory>

class QToolBar;

namespace knead {

struct Features;
struct WindowActions;
class Banner;
class Center;
class CommandPalette;
class Display;
class Hands;
class HistoryPanel;
class MaterialStore;
class Measuring;
class ModelTree;
class Modes;
class ProbeSet;
class ProjectKeeper;
class PropertyPages;
class StatusLine;
class TimelinePanel;
class ViewGrid;
class ViewportWidget;

/// The program's window: tree, properties, view, log and status bar around one document. It is a frame: what can be done is in its
/// Features, which it makes, gives a place, and tells of the document.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(Services services, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// At the first start, so that the window fits a screen together with its frame. @param available of the screen
    /// [pixels]
    static QSize firstSize(const QSize& available);

    const Features& features() const { return *m_features; }
    void open(const QStringList& paths); ///< see ImportFeature::open()
    void open(const ImportChoices& request);

    Document& document() { return m_document; }
    TaskRunner& tasks() { return m_tasks; }
    ProjectKeeper& projects();
    ViewportWidget& viewport() { return *m_viewport; } ///< the active view
    ViewGrid& views() { return *m_views; }
    Measuring& measuring();
    ProbeSet& probes();
    Hands& hands();
    Banner& banner();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void makePanels();
    void makeFeatures();
    void showPlacesOfReports();
    void makeMenus();
    void makeCommands();
    void connectActions();
    void connectTasks();
    void restoreSettings();

    void documentChanged(Document::Change what);
    void modelChanged();
    void showNothing();
    void selectionChanged();
    QString hint() const;
    void openAnother();
    void showFirstPage(bool on);
    void showHint();
    void resetLayout();
    void followPreferences(const Preferences& now);
    void sayAllAnew();
    void cancel();

    const Preferences m_atStart; ///< first of all: what is made next is in their language
    Services m_services;
    TaskRunner m_tasks;
    Document m_document;
    Availability m_availability;
    std::unique_ptr<WindowActions> m_actions;
    Modes* m_modes; ///< of the left mouse button
    Center* m_center = nullptr;
    ViewGrid* m_views = nullptr;
    ViewportWidget* m_viewport = nullptr; ///< the active one of them
    Docks m_docks;
    Notices* m_notices = nullptr;
    std::unique_ptr<Workbench> m_bench;
    std::unique_ptr<Features> m_features;
    MaterialStore* m_materials = nullptr;
    ModelTree* m_tree = nullptr;
    HistoryPanel* m_history = nullptr;
    PropertyPages* m_properties = nullptr;
    TimelinePanel* m_timeline = nullptr;
    Display* m_display = nullptr;
    StatusLine* m_status = nullptr;
    QToolBar* m_selectionBar = nullptr;
    QToolBar* m_sculptBar = nullptr;
    CommandPalette* m_palette = nullptr;
    QByteArray m_layout; ///< of panels, as it came
};

} // namespace knead
