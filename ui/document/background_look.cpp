#include "ui/document/background_look.h"

#include <QTimer>

#include <sys/resource.h>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr int lowPriority = 15;    // of the thread that looks, as nice has it
constexpr int stillness = 300;     // after the last frame, when time stands still [ms]
constexpr int betweenLooks = 1000; // between looks while time runs, at least [ms]
constexpr qint64 rarity = 20;      // and as many times what a look took

} // namespace

class BackgroundLook::Stop final : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return m_isCancelled; }
    void cancel() { m_isCancelled = true; }

private:
    std::atomic<bool> m_isCancelled = false;
};

BackgroundLook::BackgroundLook(Document& document, Look look, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_look(std::move(look))
    , m_timer(new QTimer(this))
{
    m_timer->setSingleShot(true);
    m_clock.start();
    // On Linux of the calling thread alone: whatever a person waits for goes first.
    m_worker.run([] { setpriority(PRIO_PROCESS, 0, lowPriority); });
    connect(m_timer, &QTimer::timeout, this, &BackgroundLook::look);
    connect(&document, &Document::changed, this, &BackgroundLook::documentChanged);
}

BackgroundLook::~BackgroundLook()
{
    if (m_stop)
        m_stop->cancel();
}

void BackgroundLook::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model) {
        m_seen = nullptr;
        if (m_stop)
            m_stop->cancel();
        emit forgotten();
    }
    if (what != Document::Change::Frame && what != Document::Change::Moment)
        return;
    if (m_stop && m_seen && !m_document.isPlaying() && m_document.frame()->bodies != m_seen->bodies)
        m_stop->cancel();
    const qint64 wait =
        m_document.isPlaying() ? std::max<qint64>(betweenLooks, rarity * m_lookTime) - m_clock.elapsed() : stillness;
    if (!m_document.isPlaying() || !m_timer->isActive())
        m_timer->start(static_cast<int>(std::max<qint64>(wait, 0)));
}

void BackgroundLook::look()
{
    const FramePointer frame = m_document.frame();
    if (m_stop || m_document.isEmpty() || !frame || (m_seen && frame->bodies == m_seen->bodies))
        return;
    m_stop = std::make_shared<Stop>();
    m_seen = frame;
    m_worker.run([this, frame, stop = m_stop] {
        QElapsedTimer clock;
        clock.start();
        Finish finish;
        try {
            finish = m_look(frame, *stop);
        } catch (const Cancelled&) { // what it would have found is of no use any more
            finish = nullptr;
        }
        QMetaObject::invokeMethod(
            this, [this, frame, time = clock.elapsed(), finish = std::move(finish)] { end(frame, time, finish); });
    });
}

void BackgroundLook::end(const FramePointer& frame, qint64 time, const Finish& finish)
{
    m_stop = nullptr;
    m_lookTime = time;
    m_clock.restart();
    if (m_document.frame() != frame && !m_document.isPlaying()) // it went on meanwhile
        m_timer->start(stillness);
    if (m_seen != frame) // another content by now
        return;
    if (finish)
        finish();
    else
        m_seen = nullptr; // it was not looked at
}

} // namespace knead
