#pragma once

#include "core/document/history_record.h"
#include "core/document/moment_bytes.h"
#include "core/simulation/gesture.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// An entry for what was done, ready to be appended. Packs the moment; any thread.
HistoryRecord recordOf(Gesture gesture, std::string name, const Packing& packing = {});
HistoryRecord recordOf(Gesture gesture, Message words, const Packing& packing = {});

/// How to come to an entry: a plain value, for another thread than that of the history.
struct Way {
    std::uint32_t start = 0;               ///< of the document's list of starts
    std::shared_ptr<const Bytes> from;     ///< the nearest moment before that is kept; null: the beginning of the start
    std::vector<RecordedCommand> commands; ///< from there on; none where the entry's own moment is kept
    std::uint64_t step = 0;                ///< at the entry
    std::uint64_t hash = 0;                ///< of the state at the entry
    ToolParts parts;                       ///< of tools that came after the start
};

/// The moment that a way begins with; null: the beginning of its start.
/// @param scene the start that the way names
/// @throws Problem when it cannot be read
MomentPointer beginOf(const Way& way, const Scene& scene, const Packing& packing);

/// Goes a way: unpacks the moment it begins with and repeats the commands, if there are any. Takes as long as they took.
/// @param scene the start that the way names
/// @throws Problem when the moment cannot be read or the way ends elsewhere than it did; Cancelled
MomentPointer follow(const Way& way, const Scene& scene, const Packing& packing = {},
                     TaskControl& control = TaskControl::none());

/// What a person did to a document: a tree of entries, each one gesture with the moment at its end. Going back and doing
/// something else begins a branch; nothing is ever lost but memory: moments are dropped when they take more than is allowed,
/// and can be found again by repeating what leads to them.
///
/// Entries are numbered in the order in which they were made, and keep their numbers. Plain data; one thread at a time.
class History {
public:
    using Entry = std::uint32_t;
    static constexpr std::size_t defaultMemory = std::size_t{512} << 20U; // [bytes]

    /// @param first what the document was like before anything was done; it becomes entry 0
    /// @param memory what moments and commands may take [bytes]
    explicit History(HistoryRecord first, std::size_t memory = defaultMemory);

    /// As it was: what records() and current() gave.
    /// @throws Problem when entries do not form a tree
    History(std::vector<HistoryRecord> records, Entry current, std::size_t memory = defaultMemory);

    /// Appends an entry to the present one and goes to it. What `record` says of its parent and start does not matter.
    Entry append(HistoryRecord record);

    /// The same, where it begins with another start state: after an import, or another filling.
    /// @param start of the document's list
    Entry appendStart(HistoryRecord record, std::uint32_t start);

    /// Goes to an entry; redo comes this way from now on. @pre it exists
    void goTo(Entry entry);

    Entry current() const { return m_current; }
    std::optional<Entry> undoTarget() const; ///< the entry before; none at the first one
    std::optional<Entry> redoTarget() const; ///< of those that follow the one visited last; none at an end

    const std::vector<HistoryRecord>& records() const { return m_records; }
    const HistoryRecord& record(Entry entry) const { return m_records[entry]; }
    std::vector<Entry> childrenOf(Entry entry) const;    ///< in the order in which they were made
    std::vector<Entry> pathTo(Entry entry) const;        ///< from the first entry on, both included
    std::vector<Entry> pathFromStart(Entry entry) const; ///< the same from where its start begins
    std::vector<Entry> wayOn() const;                    ///< where redo would go, one after the other
    Way wayTo(Entry entry) const;
    bool beginsStart(Entry entry) const; ///< its start is another one than that of the entry before

    void rename(Entry entry, std::string name);
    void setKey(Entry entry, bool isKey); ///< key moments are dropped after all others

    /// Puts a moment that was found again back. @pre it is that of the entry
    void keep(Entry entry, std::shared_ptr<const Bytes> moment);

    /// Drops the oldest moments while they and commands take more than this [bytes], and moments alone more than half of it:
    /// first common ones, then key moments, then those at which a start begins; never that of the present entry.
    void setMemory(std::size_t most);
    std::size_t memory() const { return m_used; } ///< in use [bytes]

private:
    Entry add(HistoryRecord record);
    void thin();

    std::vector<HistoryRecord> m_records;
    std::vector<Entry> m_visited; ///< per entry: of those that follow it the one visited last; itself where none does
    Entry m_current = 0;
    std::size_t m_most = defaultMemory;
    std::size_t m_used = 0;      ///< by moments and commands
    std::size_t m_ofMoments = 0; ///< of that
};

} // namespace knead
