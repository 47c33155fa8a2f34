#include "ui/tracing/trace_follower.h"

#include "ui/project/project_keeper.h"
#include "ui/tracing/saved_path.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr int lookingTime = 300; // [ms]

} // namespace

TraceFollower::TraceFollower(Document& document, TraceServices services, ProjectKeeper& projects, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_services(std::move(services))
    , m_projects(projects)
    , m_timer(new QTimer(this))
    , m_text(std::make_shared<TraceText>())
{
    connect(m_timer, &QTimer::timeout, this, &TraceFollower::lookOn);
    connect(&document.history(), &DocumentHistory::appended, this, &TraceFollower::keepUp);
    connect(&projects, &ProjectKeeper::changed, this, &TraceFollower::keepUp);
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            keepUp();
        if (what == Document::Change::Moment)
            goBack();
    });
}

TraceFollower::~TraceFollower() = default;

void TraceFollower::follow(bool on)
{
    m_isFollowing = on && m_services.begin;
    m_isFollowing ? m_timer->start(lookingTime) : m_timer->stop();
    keepUp();
}

/// Writes the entries that lead to the present one, from where they differ from those that are written.
void TraceFollower::keepUp()
{
    if (!m_isFollowing)
        return;
    const DocumentHistory& history = m_document.history();
    if (history.isEmpty() || m_document.isEmpty()) {
        ++m_texts;
        if (!std::exchange(m_isEmpty, true))
            emit changed({});
        return;
    }
    const History& tree = history.tree();
    const Source source{history.documentNumber(), tree.record(tree.current()).start, m_projects.path()};
    const bool mayBeTold = m_isStuck && !m_projects.isModified(); // it was saved, perhaps with what was missing
    if (m_isEmpty || source != m_source || mayBeTold) {
        m_source = source;
        beginAnew();
    }
    const std::vector<History::Entry> path = tree.pathFromStart(tree.current());
    if (path == m_path)
        return;
    const auto kept = static_cast<std::size_t>(std::ranges::mismatch(m_path, path).in1 - m_path.begin());
    m_path = path;
    writeEntries(kept);
}

/// Another moment is shown: what was under way has become an entry, or was taken back.
void TraceFollower::goBack()
{
    keepUp();
    if (m_isFollowing && !m_isEmpty && m_known != RecordingMark{})
        writeEntries(m_path.size());
}

/// Those of the path after the first ones.
void TraceFollower::writeEntries(std::size_t kept)
{
    const History& tree = m_document.history().tree();
    std::vector<HistoryRecord> added;
    for (std::size_t i = kept; i < m_path.size(); ++i) {
        added.push_back(tree.record(m_path[i]));
        added.back().moment = nullptr;
    }
    m_known = {};
    write([kept, added = std::move(added)](TraceText& text) { return text.follow(kept, added); });
}

void TraceFollower::beginAnew()
{
    ++m_texts;
    m_isEmpty = m_isStuck = false;
    m_isBehind = m_projects.isModified();
    m_path.clear();
    m_known = {};
    write([begin = m_services.begin, project = m_document.project(), start = m_source.start,
           saved = savedPath(m_projects)](TraceText& text) {
        return text.begin([&] { return begin(project, start, saved); });
    });
}

void TraceFollower::lookOn()
{
    if (m_isEmpty || m_isStuck || m_document.isGoing() || !m_document.isAnythingUnderWay())
        return;
    m_document.followGesture(m_known, [this](const RecordingNews& news) { hear(news); });
}

/// What came late is asked for again with what comes next.
void TraceFollower::hear(const RecordingNews& news)
{
    const bool isWhole = news.after.commands == 0;
    if (!m_isFollowing || (!isWhole && news.after != m_known))
        return;
    const RecordingMark now{news.after.recording, news.after.commands + news.commands.size()};
    if (now == m_known && news.step == m_step)
        return;
    m_known = now;
    m_step = news.step;
    write([news](TraceText& text) { return text.goOn(news); });
}

void TraceFollower::write(std::function<std::optional<TextEdit>(TraceText&)> work)
{
    m_worker.run([this, number = m_texts, text = m_text, work = std::move(work)] {
        const auto tell = [this, number, edit = work(*text)] {
            if (edit && number == m_texts)
                arrive(*edit);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

void TraceFollower::arrive(const TextEdit& edit)
{
    m_isStuck = m_isStuck || !edit.problem.empty();
    emit changed(edit);
    if (m_isStuck && m_isBehind && !m_projects.isModified())
        keepUp(); // it was saved meanwhile
}

} // namespace knead
