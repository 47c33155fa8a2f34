#pragma once

#include "core/document/moment_bytes.h"
#include "ui/frame/workbench.h"

#include <QObject>

#include <functional>
#include <memory>

class QAction;
class QMenu;
class QWidget;

namespace knead {

struct PreparedModel;
class HomePage;
class ModelTree;
class ProjectKeeper;

/// Projects: title of the window, recent files, saving, and what is asked before work would be lost. Window thread only.
class ProjectsFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QAction* save;
        QAction* saveAs;
        QAction* recover;
        QAction* close;
    };

    /// @param perspective is switched as it is in a project
    ProjectsFeature(const Workbench& bench, ModelTree& tree, HomePage& home, QAction& perspective);
    ~ProjectsFeature() override;

    const Actions& actions() const { return m_actions; }
    QMenu& recentMenu() const { return m_recent; } ///< the files that were open lately, as the first page has them
    QMenu& examplesMenu() const { return m_examples; }
    ProjectKeeper& keeper() { return *m_keeper; }

    /// @return whether they were a matter of projects
    bool opened(const QStringList& paths);
    /// A part with nothing saved yet.
    void open(PreparedModel prepared);
    void addRecent(const QString& path);

    void showTitle();
    void listRecent();

    /// First what is not saved is asked about.
    /// @param close what then closes the window
    /// @return whether it may close now
    bool mayClose(std::function<void()> close);

signals:
    /// A file of the list is wanted, in place of what is open.
    void fileChosen(const QString& path);

private:
    void closePart();
    void openRecent(const QString& path);
    void keepPicture(const QString& path);

    Workbench m_bench;
    Actions m_actions;
    HomePage& m_home;
    QMenu& m_recent;
    QMenu& m_examples;
    std::unique_ptr<ProjectKeeper> m_keeper;
    bool m_mayClose = false; ///< what is not saved is not wanted
};

} // namespace knead
