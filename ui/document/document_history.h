#pragma once

#include "core/document/history.h"
#include "core/document/project.h"
#include "core/session/history_start.h"
#include "core/task/ordered_worker.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// The history of the open document as the window keeps it: the tree of entries, the starts that their steps count from, and a
/// thread that packs moments. Window thread only. Document says when a gesture ends and goes where the tree says it is.
///
/// Entries come in the order in which they were expected, whatever threads their gestures come from, and some ms later than the
/// gesture ended; isSettled() says whether all are there.
///
/// Saving takes records(), tree().current(), starts() and what Document::project() adds; revision() says whether anything is new.
class DocumentHistory final : public QObject {
    Q_OBJECT
public:
    using Entry = History::Entry;

    using Start = HistoryStart;

    explicit DocumentHistory(QObject* parent = nullptr);
    ~DocumentHistory() override;

    void setPacking(Packing packing) { m_packing = std::move(packing); }
    const Packing& packing() const { return m_packing; }

    /// A new document, shown; `first` becomes entry 0. What was there before is forgotten.
    void begin(Start start, Gesture first, const Message& words);
    /// One that was saved. @throws Problem when entries do not form a tree; nothing has changed
    void begin(std::vector<Start> starts, std::vector<HistoryRecord> entries, Entry current);

    /// Nothing is open any more.
    void end();

    bool isEmpty() const { return !m_tree; }
    std::uint64_t documentNumber() const
    {
        return m_document;
    }                                               ///< entries of another document have nothing to do with these
    const History& tree() const { return *m_tree; } ///< @pre not empty
    const std::vector<Start>& starts() const { return m_starts; }
    /// What is shown from now on. It is kept, and what was shown before it; the others have to be made anew.
    void setModel(std::uint32_t start, std::shared_ptr<const FilledModel> content);

    /// An entry is to come after all that were expected before. One in which nothing happened is left out.
    /// @param words none: after how long was simulated
    /// @return takes its gesture, once, on any thread
    std::function<void(Gesture)> expect(const Message& words);
    /// The same for one that begins with another start.
    void expectStart(Start start, Gesture first, const Message& words);
    bool isSettled() const { return m_nextTicket == m_nextEntry; }

    void goTo(Entry entry);
    void rename(Entry entry, const QString& name);
    void setKey(Entry entry, bool isKey);
    void keep(Entry entry, std::shared_ptr<const Bytes> moment);

    static constexpr std::size_t leastMemory = std::size_t{16} << 20U; // [bytes]
    void setMemory(std::size_t most); ///< what moments and commands may take [bytes], also in documents to come
    std::size_t memoryLimit() const { return m_memory; }

    /// Something was noted that belongs to the document and is no entry: it is unsaved.
    void noteEdit();

    /// Goes up with every entry, name, mark, note and going: equal to that at the last saving when nothing is unsaved.
    std::uint64_t revision() const { return m_revision; }

    /// Does work on the thread that packs, after all that it was given before. @param work must not throw
    void inBackground(std::function<void()> work) { m_worker.run(std::move(work)); }

signals:
    void changed(); ///< anything
    void appended(std::uint32_t entry);
    void edited(std::uint32_t entry); ///< its name, mark or moment
    void settled();                   ///< all that was expected is there

private:
    /// The place of an entry that is to come.
    struct Ticket {
        std::uint64_t document;
        std::uint64_t number;
        Message words;
        std::optional<std::uint32_t> start; ///< that begins with it
        Packing packing;
    };

    void addStart(Start start);
    Ticket nextTicket(const Message& words);
    void pack(const Ticket& ticket, Gesture gesture);
    void arrive(const Ticket& ticket, HistoryRecord record);
    void append(HistoryRecord record, std::optional<std::uint32_t> start);
    void forget();
    void tellEdit(Entry entry);

    Packing m_packing;
    std::size_t m_memory = History::defaultMemory;
    std::optional<History> m_tree;
    std::vector<Start> m_starts;
    std::vector<std::uint32_t> m_withContent; ///< starts, the one shown last at the end
    std::uint64_t m_revision = 0;
    std::uint64_t m_document = 0; ///< counts them; what comes late for an earlier one is dropped
    std::uint64_t m_nextTicket = 0;
    std::uint64_t m_nextEntry = 0; ///< the ticket whose turn it is
    std::map<std::uint64_t, std::pair<HistoryRecord, std::optional<std::uint32_t>>> m_waiting; ///< by ticket
    OrderedWorker m_worker;                                                                    // last: it ends first
};

} // namespace knead
