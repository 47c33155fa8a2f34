#include "ui/document/run_remarks.h"

#include "ui/language/said.h"
#include "ui/units.h"

#include <QTimer>

namespace knead {

namespace {

constexpr int lookInterval = 1000; // [ms]

} // namespace

RunRemarks::RunRemarks(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_timer(new QTimer(this))
{
    m_clock.start();
    m_timer->start(lookInterval);
    connect(m_timer, &QTimer::timeout, this, &RunRemarks::lookAtPace);
    connect(&document, &Document::changed, this, &RunRemarks::documentChanged);
}

void RunRemarks::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model) {
        m_quality.begin();
        m_stall = {};
    }
    if (what == Document::Change::Frame)
        tell(m_quality.see(*m_document.frame()->snapshot));
}

void RunRemarks::tell(const QualityWatch::News& news)
{
    for (const Message& sentence : news.passed)
        emit passed(knead::said(sentence));
    for (const Remark& remark : news.said)
        if (remark.isMinor)
            emit noted(knead::said(remark.sentence));
        else
            emit said(knead::said(remark.sentence));
}

void RunRemarks::lookAtPace()
{
    if (!m_document.isPlaying()) {
        m_stall.stop();
        return;
    }
    const Snapshot& now = *m_document.frame()->snapshot;
    if (!m_stall.look({.wall = 1e-3 * static_cast<double>(m_clock.elapsed()), .simulated = now.time},
                      m_document.speed()))
        return;
    const StallWatch::Stall stall = m_stall.stall();
    emit said(knead::said(
        Message(
            "RunRemarks",
            "Time hardly goes on: %1 were simulated in %2, in steps of %3. A larger spacing, a softer material, slower "
            "tools or ones that begin outside the material make it faster.")
            .with(formatReading(stall.simulated, Quantity::Time).toStdString(),
                  formatReading(stall.wall, Quantity::Time).toStdString(),
                  formatReading(now.timeStep, Quantity::Time).toStdString())));
}

} // namespace knead
