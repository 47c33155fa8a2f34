#include "ui/document/document_history.h"

#include "core/simulation/moment.h"
#include "ui/document/entry_names.h"

#include <QDateTime>

#include <algorithm>
#include <new>
#include <utility>

namespace knead {

namespace {

double now()
{
    constexpr double milliseconds = 1e-3;
    return milliseconds * static_cast<double>(QDateTime::currentMSecsSinceEpoch());
}

/// Without its moment, which then has to be found again.
HistoryRecord bareRecord(const Gesture& gesture, const Message& words)
{
    return {.name = words.english(),
            .words = words,
            .commands = gesture.commands,
            .step = gesture.moment->steps.count,
            .time = gesture.moment->steps.time,
            .hash = gesture.hash};
}

/// There may be no memory left to pack it.
HistoryRecord packedRecord(Gesture gesture, const Message& words, const Packing& packing)
{
    HistoryRecord bare = bareRecord(gesture, words);
    try {
        return recordOf(std::move(gesture), words, packing);
    } catch (const std::bad_alloc&) {
        return bare;
    }
}

bool isNothing(const HistoryRecord& record, const HistoryRecord& before)
{
    const bool onlyKeeps = std::all_of(record.commands.begin(), record.commands.end(), [](const auto& recorded) {
        return std::holds_alternative<KeepMoment>(recorded.command);
    });
    return onlyKeeps && record.step == before.step && record.time == before.time && record.hash == before.hash;
}

} // namespace

DocumentHistory::DocumentHistory(QObject* parent)
    : QObject(parent)
{
}

DocumentHistory::~DocumentHistory() = default;

void DocumentHistory::forget()
{
    ++m_document;
    m_nextTicket = m_nextEntry = 0;
    m_waiting.clear();
    m_starts.clear();
    m_withContent.clear();
}

void DocumentHistory::addStart(Start start)
{
    const std::shared_ptr<const FilledModel> content = start.content;
    m_starts.push_back(std::move(start));
    setModel(static_cast<std::uint32_t>(m_starts.size() - 1), content);
}

void DocumentHistory::setModel(std::uint32_t start, std::shared_ptr<const FilledModel> content)
{
    constexpr std::size_t most = 2; // each may be as large as all that is simulated of it
    m_starts[start].choices = content->request;
    m_starts[start].content = std::move(content);
    std::erase(m_withContent, start);
    m_withContent.push_back(start);
    if (m_withContent.size() <= most)
        return;
    m_starts[m_withContent.front()].content = nullptr;
    m_withContent.erase(m_withContent.begin());
}

void DocumentHistory::begin(Start start, Gesture first, const Message& words)
{
    forget();
    HistoryRecord record = bareRecord(first, words);
    record.wallTime = now();
    addStart(std::move(start));
    m_tree.emplace(std::move(record), m_memory);
    ++m_revision;
    m_worker.run([this, first = std::move(first), packing = m_packing, document = m_document] {
        const HistoryRecord packed = packedRecord(first, {}, packing);
        QMetaObject::invokeMethod(
            this,
            [this, moment = packed.moment, document] {
                if (document == m_document && moment)
                    keep(0, moment);
            },
            Qt::QueuedConnection);
    });
    emit appended(0);
    emit changed();
}

void DocumentHistory::begin(std::vector<Start> starts, std::vector<HistoryRecord> entries, Entry current)
{
    History tree(std::move(entries), current, m_memory);
    forget();
    m_starts = std::move(starts);
    m_tree.emplace(std::move(tree));
    ++m_revision;
    emit changed();
}

void DocumentHistory::end()
{
    forget();
    m_tree.reset();
    ++m_revision;
    emit changed();
}

DocumentHistory::Ticket DocumentHistory::nextTicket(const Message& words)
{
    return {m_document, m_nextTicket++, words, {}, m_packing};
}

std::function<void(Gesture)> DocumentHistory::expect(const Message& words)
{
    return [this, ticket = nextTicket(words)](Gesture gesture) { pack(ticket, std::move(gesture)); };
}

void DocumentHistory::expectStart(Start start, Gesture first, const Message& words)
{
    Ticket ticket = nextTicket(words);
    ticket.start = static_cast<std::uint32_t>(m_starts.size());
    addStart(std::move(start));
    pack(ticket, std::move(first));
}

/// Any thread.
void DocumentHistory::pack(const Ticket& ticket, Gesture gesture)
{
    m_worker.run([this, ticket, gesture = std::move(gesture)] {
        HistoryRecord record = packedRecord(gesture, ticket.words, ticket.packing);
        const auto handOver = [this, ticket, record = std::move(record)] { arrive(ticket, record); };
        QMetaObject::invokeMethod(this, handOver, Qt::QueuedConnection);
    });
}

void DocumentHistory::arrive(const Ticket& ticket, HistoryRecord record)
{
    if (ticket.document != m_document)
        return;
    m_waiting[ticket.number] = {std::move(record), ticket.start};
    while (m_waiting.contains(m_nextEntry)) {
        auto [next, start] = std::move(m_waiting.extract(m_nextEntry).mapped());
        ++m_nextEntry;
        append(std::move(next), start);
    }
    if (isSettled())
        emit settled();
}

void DocumentHistory::append(HistoryRecord record, std::optional<std::uint32_t> start)
{
    const HistoryRecord& before = m_tree->record(m_tree->current());
    if (!start && isNothing(record, before)) {
        emit changed(); // what is undone next is another than while it went on
        return;
    }
    record.wallTime = now();
    if (record.name.empty()) {
        record.words = simulatedName(record.time - before.time);
        record.name = record.words.english();
    }
    const Entry entry = start ? m_tree->appendStart(std::move(record), *start) : m_tree->append(std::move(record));
    ++m_revision;
    emit appended(entry);
    emit changed();
}

void DocumentHistory::goTo(Entry entry)
{
    m_tree->goTo(entry);
    ++m_revision;
    emit changed();
}

void DocumentHistory::noteEdit()
{
    if (isEmpty())
        return;
    ++m_revision;
    emit changed();
}

void DocumentHistory::tellEdit(Entry entry)
{
    emit edited(entry);
    emit changed();
}

void DocumentHistory::rename(Entry entry, const QString& name)
{
    m_tree->rename(entry, name.toStdString());
    ++m_revision;
    tellEdit(entry);
}

void DocumentHistory::setKey(Entry entry, bool isKey)
{
    m_tree->setKey(entry, isKey);
    ++m_revision;
    tellEdit(entry);
}

void DocumentHistory::keep(Entry entry, std::shared_ptr<const Bytes> moment)
{
    m_tree->keep(entry, std::move(moment));
    tellEdit(entry);
}

void DocumentHistory::setMemory(std::size_t most)
{
    m_memory = std::max(most, leastMemory);
    if (m_tree)
        m_tree->setMemory(m_memory);
    emit changed();
}

} // namespace knead
