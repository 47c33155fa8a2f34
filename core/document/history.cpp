#include "core/document/history.h"

#include "core/message/message.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

std::size_t memoryOf(const std::shared_ptr<const Bytes>& moment)
{
    return moment ? moment->size() : 0;
}

/// Commands are small beside moments; selections in them are not counted.
std::size_t memoryOf(const HistoryRecord& record)
{
    return memoryOf(record.moment) + record.commands.size() * sizeof(RecordedCommand);
}

void requireTree(const std::vector<HistoryRecord>& records, History::Entry current)
{
    if (records.empty())
        throw Problem(Message("History", "The history has no entries."));
    for (std::size_t i = 0; i < records.size(); ++i)
        if (records[i].parent >= std::max<std::size_t>(i, 1))
            throw Problem(
                Message("History", "The history is damaged: its entry %1 follows one that comes later.").with(i));
    if (current >= records.size())
        throw Problem(Message("History", "The history is damaged: it is at an entry that it does not have."));
}

} // namespace

HistoryRecord recordOf(Gesture gesture, std::string name, const Packing& packing)
{
    return {.name = std::move(name),
            .commands = std::move(gesture.commands),
            .step = gesture.moment->steps.count,
            .time = gesture.moment->steps.time,
            .hash = gesture.hash,
            .moment = std::make_shared<const Bytes>(momentToBytes(*gesture.moment, packing))};
}

HistoryRecord recordOf(Gesture gesture, Message words, const Packing& packing)
{
    HistoryRecord record = recordOf(std::move(gesture), words.english(), packing);
    record.words = std::move(words);
    return record;
}

MomentPointer beginOf(const Way& way, const Scene& scene, const Packing& packing)
{
    if (!way.from)
        return nullptr;
    ToolParts parts = toolPartsOf(scene, way.commands);
    parts.insert(parts.end(), way.parts.begin(), way.parts.end());
    return std::make_shared<const Moment>(momentFromBytes(*way.from, scene.bodies, parts, packing));
}

MomentPointer follow(const Way& way, const Scene& scene, const Packing& packing, TaskControl& control)
{
    MomentPointer begin = beginOf(way, scene, packing);
    if (begin && way.commands.empty())
        return begin;
    Simulation simulation(scene);
    if (begin)
        simulation.goTo(std::move(begin));
    simulation = replay(std::move(simulation), way.commands, way.step, control);
    if (simulation.stateHash() != way.hash)
        throw Problem(Message("History",
                              "Repeating what was done came to another state than it did then, as it does with "
                              "another version of Knead. Go to an entry that is kept."));
    return simulation.keepMoment();
}

History::History(HistoryRecord first, std::size_t memory)
    : m_most(memory)
{
    first.parent = 0;
    add(std::move(first));
}

History::History(std::vector<HistoryRecord> records, Entry current, std::size_t memory)
    : m_most(memory)
{
    requireTree(records, current);
    for (HistoryRecord& record : records)
        add(std::move(record));
    goTo(current);
}

/// Without going there, but redo would.
History::Entry History::add(HistoryRecord record)
{
    const auto entry = static_cast<Entry>(m_records.size());
    m_used += memoryOf(record);
    m_ofMoments += memoryOf(record.moment);
    m_visited.push_back(entry);
    m_visited[record.parent] = entry;
    m_records.push_back(std::move(record));
    return entry;
}

History::Entry History::append(HistoryRecord record)
{
    return appendStart(std::move(record), m_records[m_current].start);
}

History::Entry History::appendStart(HistoryRecord record, std::uint32_t start)
{
    record.parent = m_current;
    record.start = start;
    const Entry entry = add(std::move(record));
    goTo(entry);
    return entry;
}

void History::goTo(Entry entry)
{
    m_current = entry;
    for (; entry != 0; entry = m_records[entry].parent)
        m_visited[m_records[entry].parent] = entry;
    thin();
}

std::optional<History::Entry> History::undoTarget() const
{
    return m_current == 0 ? std::nullopt : std::optional(m_records[m_current].parent);
}

std::optional<History::Entry> History::redoTarget() const
{
    return m_visited[m_current] == m_current ? std::nullopt : std::optional(m_visited[m_current]);
}

std::vector<History::Entry> History::childrenOf(Entry entry) const
{
    std::vector<Entry> children;
    for (Entry other = entry + 1; other < m_records.size(); ++other)
        if (m_records[other].parent == entry)
            children.push_back(other);
    return children;
}

std::vector<History::Entry> History::pathTo(Entry entry) const
{
    std::vector<Entry> path{entry};
    for (; entry != 0; path.push_back(entry))
        entry = m_records[entry].parent;
    std::ranges::reverse(path);
    return path;
}

std::vector<History::Entry> History::pathFromStart(Entry entry) const
{
    std::vector<Entry> path = pathTo(entry);
    const auto isBegin = [this](Entry each) { return beginsStart(each); };
    path.erase(path.begin(), std::find_if(path.rbegin(), path.rend(), isBegin).base() - 1);
    return path;
}

std::vector<History::Entry> History::wayOn() const
{
    std::vector<Entry> way;
    for (Entry entry = m_current; m_visited[entry] != entry; way.push_back(entry))
        entry = m_visited[entry];
    return way;
}

bool History::beginsStart(Entry entry) const
{
    return entry == 0 || m_records[entry].start != m_records[m_records[entry].parent].start;
}

Way History::wayTo(Entry entry) const
{
    const HistoryRecord& target = m_records[entry];
    Way way{.start = target.start, .from = {}, .commands = {}, .step = target.step, .hash = target.hash, .parts = {}};
    const std::vector<Entry> path = pathFromStart(entry);
    auto first = path.begin(); // of the entries that are repeated
    for (auto each = path.begin(); each != path.end(); ++each) {
        const HistoryRecord& record = m_records[*each];
        const ToolParts parts = toolPartsOf({}, record.commands);
        way.parts.insert(way.parts.end(), parts.begin(), parts.end());
        if (record.moment) {
            way.from = record.moment;
            first = each + 1;
        }
    }
    for (; first != path.end(); ++first) {
        const std::vector<RecordedCommand>& commands = m_records[*first].commands;
        way.commands.insert(way.commands.end(), commands.begin(), commands.end());
    }
    return way;
}

void History::rename(Entry entry, std::string name)
{
    m_records[entry].name = std::move(name);
    m_records[entry].words = {};
}

void History::setKey(Entry entry, bool isKey)
{
    m_records[entry].isKey = isKey;
}

void History::keep(Entry entry, std::shared_ptr<const Bytes> moment)
{
    HistoryRecord& record = m_records[entry];
    m_used += memoryOf(moment) - memoryOf(record.moment);
    m_ofMoments += memoryOf(moment) - memoryOf(record.moment);
    record.moment = std::move(moment);
    thin();
}

void History::setMemory(std::size_t most)
{
    m_most = most;
    thin();
}

void History::thin()
{
    enum Rank { common, key, start };
    const auto rankOf = [this](Entry entry) {
        return beginsStart(entry) ? start : m_records[entry].isKey ? key : common;
    };
    // Hours of commands must leave room for moments, or each undo would repeat all of them.
    const auto isTooMuch = [this] { return m_used > m_most && m_ofMoments > m_most / 2; };
    for (const Rank rank : {common, key, start})
        for (Entry entry = 0; entry < m_records.size() && isTooMuch(); ++entry) {
            if (entry == m_current || rankOf(entry) != rank)
                continue;
            m_used -= memoryOf(m_records[entry].moment);
            m_ofMoments -= memoryOf(m_records[entry].moment);
            m_records[entry].moment = nullptr;
        }
}

} // namespace knead
