// How what a person does becomes gestures, which are the entries of the history.
#include "ui/document/document.h"

#include "ui/document/entry_names.h"

#include <QTimer>

#include <cmath>

namespace knead {

namespace {

constexpr int goingOnTime = 1000;    // within which the same goes on as one gesture [ms]
constexpr double worthAnEntry = 0.1; // what is simulated before an edit gets an entry of its own from here on [s]

} // namespace

void Document::play()
{
    if (!m_simulation || later([this] { play(); }))
        return;
    if (m_ending->isActive())
        finishGesture();
    m_isPlaying = true;
    noteGesture();
    m_simulation->play();
    m_playRequest = m_simulation->requests();
}

void Document::pause()
{
    if (!m_simulation || later([this] { pause(); }))
        return;
    emit stopping();
    m_simulation->pause();
    m_isPlaying = false;
    finishGesture();
}

void Document::togglePlay()
{
    if (later([this] { togglePlay(); }))
        return;
    if (m_isPlaying)
        pause();
    else
        play();
}

void Document::stepOnce()
{
    if (!m_simulation || later([this] { stepOnce(); }))
        return;
    openGesture(QStringLiteral("step"));
    noteGesture();
    m_simulation->stepOnce();
    m_ending->start(goingOnTime);
}

void Document::reset()
{
    if (!m_simulation || later([this] { reset(); }))
        return;
    emit stopping();
    finishGesture();
    m_toolRequests.forget();
    m_simulation->reset();
    noteEdit();
    m_isPlaying = false;
    m_gesture = {.isAny = true, .name = Message("Document", "Reset")};
    finishGesture();
}

void Document::post(Command command, const Message& name)
{
    if (!m_simulation || later([this, command, name] { post(command, name); }))
        return;
    if (const std::optional<Selection> target = targetOf(command); target && refuseLocked(*target))
        return;
    const QString key = mergeKeyOf(command);
    if (!m_gesture.isHeld || !m_gesture.isEdited)
        openGesture(m_gesture.isHeld ? m_gesture.key : key);
    if (m_gesture.name.empty())
        m_gesture.name = name.empty() ? nameOf(command, *m_content, *m_frame->snapshot) : name;
    m_gesture.isEdited = true;
    noteGesture();
    const bool isOfFixture =
        std::holds_alternative<AddFixture>(command) || std::holds_alternative<RemoveFixture>(command);
    m_fixtures.posted(command);
    m_toolRequests.posted(command, m_simulation->requests() + 1);
    if (std::holds_alternative<SetPartLook>(command)) {
        m_appearance.follow(command);
        emit appearanceChanged();
    }
    m_simulation->post(std::move(command));
    noteEdit();
    if (isOfFixture)
        m_fixtureRequest = m_simulation->requests();
    if (!m_gesture.isHeld)
        m_ending->start(key.isEmpty() ? 0 : goingOnTime);
}

/// The simulation was asked for another state than it had.
void Document::noteEdit()
{
    ++m_edits;
    m_editRequest = m_simulation->requests();
}

/// There is something to undo from now on.
void Document::noteGesture()
{
    if (m_gesture.isAny)
        return;
    m_gesture.isAny = true;
    emit changed(Change::History);
}

/// Goes on with a gesture that waits for its like; else what was done before ends first.
void Document::openGesture(const QString& key)
{
    const bool isHeld = m_gesture.isHeld;
    const int hands = m_gesture.hands;
    const bool goesOn = m_ending->isActive() && m_gesture.key == key;
    const bool isWorthAnEntry = m_isPlaying && std::abs(m_frame->snapshot->time - m_gesture.begin) >= worthAnEntry;
    if (!goesOn && (m_ending->isActive() || isWorthAnEntry))
        finishGesture();
    m_ending->stop();
    m_gesture.key = key;
    m_gesture.isHeld = isHeld;
    m_gesture.hands = hands;
}

void Document::beginGesture(const QString& key)
{
    if (!m_simulation || later([this, key] { beginGesture(key); }))
        return;
    if (m_gesture.isHeld) {
        ++m_gesture.hands;
        return;
    }
    const bool goesOn = m_ending->isActive() && m_gesture.key == key && !key.isEmpty();
    if (m_ending->isActive() && !goesOn)
        finishGesture();
    m_ending->stop();
    m_gesture.isHeld = true;
    m_gesture.hands = 1;
    m_gesture.isEdited = goesOn;
    m_gesture.key = key;
}

void Document::endGesture(Ends ends)
{
    if (!m_simulation || later([this, ends] { endGesture(ends); }))
        return;
    if (m_gesture.isHeld && --m_gesture.hands > 0)
        return;
    m_gesture.isHeld = false;
    if (!m_gesture.isEdited)
        return;
    if (ends == Ends::soon)
        m_ending->start(goingOnTime);
    else
        finishGesture();
}

void Document::takeBackGesture()
{
    if (!m_simulation || later([this] { takeBackGesture(); }))
        return;
    if (m_isPlaying || !m_gesture.isHeld || m_gesture.hands > 1 || !m_gesture.isEdited) {
        endGesture();
        return;
    }
    m_gesture = {.begin = m_frame->snapshot->time};
    m_isTakenBack = true;
    request([](const History& tree) { return std::optional(tree.current()); });
    emit changed(Change::History);
}

void Document::finishGesture()
{
    m_ending->stop();
    if (m_gesture.isAny && m_simulation)
        m_simulation->endGesture(m_history.expect(m_gesture.name));
    m_gesture = {.isAny = m_isPlaying, .begin = m_frame ? m_frame->snapshot->time : 0};
}

/// Keeps what was seen while time runs, however often it is drawn.
void Document::keepFilm()
{
    const auto keep = [this, generation = m_generation](const SnapshotPointer& snapshot) {
        if (generation == m_generation && snapshot->arrivals >= m_arrivals)
            m_playback.see(snapshot);
    };
    m_simulation->watch([this, keep](const SnapshotPointer& snapshot) {
        if (snapshot->playing)
            QMetaObject::invokeMethod(
                this, [keep, snapshot] { keep(snapshot); }, Qt::QueuedConnection);
    });
}

/// The simulation stops by itself when it is in trouble, or does not begin.
void Document::noticeStop()
{
    const Snapshot& snapshot = *m_frame->snapshot;
    if (!m_isPlaying || snapshot.playing || snapshot.requests < m_playRequest)
        return;
    m_isPlaying = false;
    finishGesture();
}

bool Document::isSettled() const
{
    return m_history.isSettled() && !isGoing() && !m_isPlaying && !m_gesture.isAny &&
           (!m_simulation || m_frame->snapshot->requests == m_simulation->requests());
}

void Document::lookAtGesture(std::function<void(std::vector<RecordedCommand>, std::uint64_t)> told)
{
    if (m_simulation)
        m_simulation->lookAtGesture(std::move(told));
}

/// By way of the thread that packs gestures, so that it comes after them.
void Document::followGesture(RecordingMark known, std::function<void(const RecordingNews&)> told)
{
    if (!m_simulation)
        return;
    m_simulation->followGesture(known, [this, generation = m_generation, told = std::move(told)](RecordingNews news) {
        m_history.inBackground([this, generation, told, news = std::move(news)] {
            const auto tell = [this, generation, told, news] {
                if (generation == m_generation)
                    told(news);
            };
            QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
        });
    });
}

} // namespace knead
