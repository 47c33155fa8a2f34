#pragma once

#include "core/document/history.h"
#include "core/message/message.h"
#include "ui/project/project_services.h"

#include <QObject>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Keeps the work of the window for recovery, on a thread of its own since that waits for the disk. Window thread; nothing here
/// waits but the destructor.
class Autosave final : public QObject {
    Q_OBJECT
public:
    explicit Autosave(ProjectServices services, QObject* parent = nullptr);
    /// Ends what was handed in, and leaves what is kept as a crash would.
    ~Autosave() override;

    /// Keeps this from now on; what was kept of an earlier document goes. Moments but the current one come when there is nothing
    /// else to keep: what is done meanwhile does not wait for them.
    void begin(Project project, WorkState state);
    /// As begin(), in place of what was kept of a window that is gone.
    void takeOver(std::shared_ptr<KeptWork> kept, Project project, WorkState state);
    /// Once more, whole, after it failed.
    void beginAgain(Project project, WorkState state);
    bool isBegun() const { return m_known.has_value(); }

    std::size_t knownStarts() const { return m_known ? m_known->starts : 0; }
    void addStart(ProjectStart start); ///< before the entries that begin with it
    /// Keeps what has changed in the history since the last call.
    void follow(const std::vector<HistoryRecord>& entries, History::Entry current);
    void followPanels(const std::map<std::string, std::string>& panels);

    /// How often a gesture is kept. With what it takes to look at it and to write, no more than 5 s of work are lost.
    static constexpr std::chrono::seconds gestureInterval{3};
    /// @param commands all since the current entry @param step that the simulation has reached
    void keepGesture(std::vector<RecordedCommand> commands, std::uint64_t step);
    void keepView(ProjectView view);

    void savingBegins();                        ///< with what was handed in until now
    void saved(const std::string& projectFile); ///< what savingBegins() was called for

    /// Looks for the work of windows that are gone. @param told called in the window's thread
    void find(std::function<void(std::vector<Recovery>)> told);
    /// Removes such work, which the person does not want.
    void drop(const Recovery& recovery);

    /// Nothing of it is wanted any more: it was saved, or the person said so.
    void discard();

signals:
    void begun(); ///< all is kept from now on
    /// The disk refused; nothing more is kept. @param sentence for the person
    void failed(const QString& sentence);
    /// find() or drop() came to nothing; what is kept is not touched by that. @param sentence for the person
    void recoveriesFailed(const QString& sentence);

private:
    struct Stop;
    struct Worker;

    /// Of an entry: what tells whether it has changed.
    struct Known {
        std::string name;
        bool isKey = false;
        std::weak_ptr<const std::vector<std::byte>> moment;
        bool hasMoment = false;
    };
    struct KnownHistory {
        std::vector<Known> entries;
        std::size_t starts = 0;
        History::Entry current = 0;
        std::map<std::string, std::string> panels;
    };

    static Known knownOf(const HistoryRecord& record);
    static bool isSame(const Known& known, const HistoryRecord& record);
    using Replacing = void (KeptWork::*)(std::uint32_t entry, const HistoryRecord& record);
    void know(const Project& project);
    void replace(History::Entry entry, const HistoryRecord& record, Replacing call);
    void tell(const Message& sentence, void (Autosave::*signal)(const QString&));
    void onRecoveries(std::function<void()> work);

    ProjectServices m_services;
    std::optional<KnownHistory> m_known; ///< what was handed to the thread
    std::shared_ptr<Stop> m_stop;        ///< of the writing of what is not discarded
    std::unique_ptr<Worker> m_worker;
};

} // namespace knead
