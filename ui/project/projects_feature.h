#pragma once

#include "core/document/moment_bytes.h"
#include "ui/frame/workbench.h"

#include <QObject>

#include <functional>
#include <memory>

class QMenu;

namespace knead {

struct Actions;
struct PreparedModel;
class HomePage;
class ModelTree;
class ProjectKeeper;

/// Projects: title of the window, recent files, saving, and what is asked before work would be lost. Window thread only.
class ProjectsFeature final : public QObject {
    Q_OBJECT
public:
    /// @param recent lists the files that were open lately, as the first page does
    ProjectsFeature(const Workbench& bench, const Actions& actions, ModelTree& tree, HomePage& home, QMenu& recent);
    ~ProjectsFeature() override;

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
    void openRecent(const QString& path);
    void keepPicture(const QString& path);

    Workbench m_bench;
    HomePage& m_home;
    QMenu& m_recent;
    std::unique_ptr<ProjectKeeper> m_keeper;
    bool m_mayClose = false; ///< what is not saved is not wanted
};

} // namespace knead
