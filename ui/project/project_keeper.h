#pragma once

#include "core/message/message.h"
#include "ui/project/autosave.h"
#include "ui/project/read_project.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>

class QMessageBox;
class QTimer;

namespace knead {

class ModelTree;
class TaskRunner;
class ViewportWidget;

/// The project that the window works on: its file and its lock, what of it is not saved, and the recovery of that. Files are
/// read and written by the task runner, the recovery has a thread of its own. Window thread.
class ProjectKeeper final : public QObject {
    Q_OBJECT
public:
    /// What it works with. The simulation of the document may tell it something until that is gone, so it outlives the document,
    /// and touches none of them when it goes.
    struct Window {
        QWidget* widget; ///< parent of its dialogs
        Document& document;
        TaskRunner& tasks;
        ViewportWidget& viewport;
        ModelTree& tree;
    };

    ProjectKeeper(ProjectServices services, Packing packing, const Window& window);
    ~ProjectKeeper() override;

    QString path() const { return m_path; } ///< of the file; empty: none yet
    QString name() const;                   ///< "bracket.knead", or the name of the part while there is no file
    bool isModified() const;
    bool mayGo() const { return !isModified() && !m_saving; } ///< nothing is lost, now, when the window goes
    bool isProject(const QString& file) const;                ///< by its ending
    QString filter() const;                                   ///< "Knead projects (*.knead)"

    /// What a panel keeps in projects: its text, empty when there is nothing to keep, and what reads that again.
    struct PanelMemory {
        std::function<std::string()> memory;
        std::function<void(const std::string& memory)> remember;
    };
    void keepPanel(const std::string& name, PanelMemory panel);
    void panelChanged(); ///< its text is another one

    /// Shows parts that were opened: a new project without a file begins.
    void open(PreparedModel parts);

    /// Reads a project in the background. A failure leaves everything as it was; remedies are offered with the sentence.
    void open(const ProjectRequest& request);

    /// Writes the project in the background, where it was or where the person says.
    /// @param then called after it was saved
    void save(std::function<void()> then = {});
    void saveAs(std::function<void()> then = {});
    void saveTo(const QString& path, std::function<void()> then = {});

    /// Asks whether to save what would be lost, if anything would; waits for a saving that goes on.
    /// @param then called unless the person cancels
    void letGo(std::function<void()> then);

    /// Nothing is open any more, and nothing of it is to be recovered: see letGo().
    void closeProject();

    /// The window closes, and nothing is to be recovered.
    void close();

    /// Looks for work that windows which are gone did not save, and offers it.
    /// @param saysNone when there is none
    void offerRecoveries(bool saysNone);

    /// How often a gesture under way is kept. With what that takes, two seconds more of work can be lost.
    void setKeepingInterval(std::chrono::seconds interval) { m_keepingInterval = interval; }

signals:
    void changed();                               ///< name(), or isModified()
    void perspectiveRestored(bool isPerspective); ///< with the camera of a project
    /// @param remedy what a click on the button with its text does
    void problem(const QString& sentence, const QString& remedyText, const std::function<void()>& remedy);
    void opening(); ///< what was said of an earlier attempt is of no interest any more
    void told(const QString& sentence);
    void recentChanged();
    void shown();                                     ///< a project, opened from its file
    void recoveriesWaiting(const QStringList& names); ///< that were put off; none any more: empty

private:
    bool isOwnFile(const std::string& path) const;
    void offerRemedy(const ProjectRequest& request, const ReadProject& read);
    void show(ReadProject read);
    bool showModel(ReadProject& read);
    void showView(const ProjectView& view, bool isRecovered);
    void listMissing(const std::vector<Message>& missing);

    /// A saving from when it is asked for until it ends.
    struct Saving {
        enum class Stage {
            settling, ///< what is under way becomes part of the history
            waiting,  ///< for a task that began meanwhile
            running
        };
        QString path;
        std::function<void()> then;
        Stage stage = Stage::settling;
    };
    struct SavedFile;
    void saveUnder(const QString& path, const std::function<void()>& then);
    void saveAll(const std::function<void()>& then);
    void afterSaving(const std::function<void()>& then);
    void startSaving();
    void goOnSaving();
    void finishSaving(SavedFile file);
    Project collect() const;
    std::map<std::string, std::string> panels() const;
    ProjectView view() const;
    WorkState state() const;

    void tellOfWaiting();
    void showRecoveries(std::vector<Recovery> found, bool saysNone);
    void recover(const Recovery& recovery);

    void documentChanged(Document::Change what);
    void historyChanged();
    void noteModified();
    void watch();
    void lookAfterGesture();
    /// Where a gesture goes on from: the document, its current entry, and how many there are.
    using Place = std::tuple<std::uint64_t, History::Entry, std::size_t>;
    Place place() const;
    void keepingFailed(const QString& sentence);

    using Clock = std::chrono::steady_clock;

    ProjectServices m_services;
    Packing m_packing;
    Window m_window;
    Autosave m_autosave;
    QTimer* m_watch;

    QString m_path;
    std::shared_ptr<void> m_lock; ///< of the file
    std::vector<ProjectMark> m_marks;
    std::map<std::string, std::string> m_panels;  ///< of the file that was opened
    std::map<std::string, PanelMemory> m_kept;    ///< panels of this window
    bool m_isChanging = false;                    ///< the document is about to be another one
    bool m_isNew = false;                         ///< opened, but its first moment is not there yet
    std::optional<std::uint64_t> m_savedRevision; ///< of what would not be lost; none: recovered work would be
    bool m_wasModified = false;
    std::uint64_t m_documents = 0; ///< that were opened
    std::optional<Saving> m_saving;
    std::map<QString, std::shared_ptr<std::mutex>> m_turns; ///< of savings, by their files
    QPointer<QMessageBox> m_question;

    std::chrono::seconds m_keepingInterval = Autosave::gestureInterval;
    Clock::time_point m_gestureKept;
    Clock::time_point m_viewKept;
    bool m_isRefused = false; ///< the disk does not take the recovery
    Clock::time_point m_lastTry;
};

} // namespace knead
