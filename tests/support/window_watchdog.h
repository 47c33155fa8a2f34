#pragma once

#include "deep.h"

#include <QApplication>
#include <QEvent>
#include <QThread>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <map>
#include <random>
#include <vector>

namespace knead {

/// Processor time of this thread [s]: how long the window was busy, whatever else the machine does.
inline double ownTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How many times as long as on the machine of the bounds this thread takes now for work that is always the same, 1 at least. A slower
/// processor is no fault of the window's.
inline double slowness()
{
    constexpr double there = 5e-3; // [s] as measured on two shared cores while little else ran
    double best = 1;               // [s]; the first time memory is new
    for (int trial = 0; trial < 3; ++trial) {
        std::mt19937 random(1);
        std::map<std::uint_fast32_t, int> numbers; // new memory and branches, as where a window is laid out
        const double start = ownTime();
        for (int i = 0; i < 30'000; ++i)
            numbers[random()] = i;
        best = std::min(best, ownTime() - start);
    }
    return std::max(1.0, best / there);
}

/// What an event may take of the window's thread [s]. Longer is a hitch: it is printed as a warning.
inline constexpr double answerTime = 0.05;

/// Where an event is no hitch any more but holds the window up, and the test fails [s]. Times vary too much where other tests run beside it to
/// hold each change to answerTime itself, as `./dev check deep tests` does.
inline double longestAnswer()
{
    return (isDeep() ? 1 : 5) * answerTime;
}

/// An application that watches how long each event keeps the window's thread from the next one. Drawing the view, and putting its
/// picture together with those of the widgets, is told apart: on a machine without a graphics card the processor does it. Loops
/// of dialogs are not the event that opened them.
class WatchedApplication final : public QApplication {
public:
    using QApplication::QApplication;

    /// The event that took longest since clear().
    struct Longest {
        double time = 0; ///< [s] without drawing; where it took long, on the machine of the bounds: over slowness()
        QString what;    ///< receiver and type of the event
    };

    void clear()
    {
        m_longest = {};
        m_longestDrawing = 0;
    }
    const Longest& longest() const { return m_longest; }
    double longestDrawing() const { return m_longestDrawing; } ///< of one picture [s]

    /// Prints the longest event since clear(), as a warning where it is a hitch. @param until what was done meanwhile
    void say(const QString& until) const
    {
        const QString sentence = QStringLiteral("Until %1: busy for %2 ms at most (%3), and drawing for %4 ms.")
                                     .arg(until)
                                     .arg(1000 * m_longest.time, 0, 'f', 1)
                                     .arg(m_longest.what)
                                     .arg(1000 * m_longestDrawing, 0, 'f', 1);
        if (m_longest.time > answerTime)
            qWarning("%s", qPrintable(sentence));
        else
            qInfo("%s", qPrintable(sentence));
    }

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (QThread::currentThread() != thread())
            return QApplication::notify(receiver, event);
        if (isDrawing(*receiver, *event))
            return draw(receiver, event);
        const int level = thread()->loopLevel();
        if (!m_running.empty() && m_running.back().level == level)
            return part(receiver, event);
        const QString name = nameOf(receiver);
        const QEvent::Type type = event->type();
        const double start = ownTime();
        m_running.push_back({level});
        const bool result = QApplication::notify(receiver, event);
        const Running ran = m_running.back();
        m_running.pop_back();
        const double total = ownTime() - start;
        if (!m_running.empty())
            m_running.back().elsewhere += total;
        double busy = total - ran.elsewhere;
        if (type ==
            QEvent::
                UpdateRequest) { // what is not painting is putting the pictures of the widgets and the view together
            m_longestDrawing = std::max(m_longestDrawing, busy - ran.painting);
            busy = ran.painting;
        }
        if (busy > m_longest.time)
            keep(busy, QStringLiteral("event %1 of %2").arg(int(type)).arg(name));
        return result;
    }

private:
    struct Running {
        int level = 0;           ///< of the event loop
        double elsewhere = 0;    ///< in drawing and in events of loops within [s]
        double painting = 0;     ///< widgets but for the view [s]
        bool isPainting = false; ///< a widget, now
    };

    /// Takes the event that took longest so far. How fast the machine is just now is asked where it matters: that takes time, too.
    void keep(double busy, const QString& what)
    {
        const double start = ownTime();
        const double time = busy > answerTime / 2 ? busy / slowness() : busy;
        if (!m_running.empty())
            m_running.back().elsewhere += ownTime() - start;
        if (time > m_longest.time)
            m_longest = {time, what};
    }

    /// An event that another one sends.
    bool part(QObject* receiver, QEvent* event)
    {
        if (event->type() != QEvent::Paint || m_running.back().isPainting)
            return QApplication::notify(receiver, event);
        const std::size_t running = m_running.size() - 1;
        const double start = ownTime() - m_running[running].elsewhere;
        m_running[running].isPainting = true;
        const bool result = QApplication::notify(receiver, event);
        m_running[running].isPainting = false;
        m_running[running].painting += ownTime() - m_running[running].elsewhere - start;
        return result;
    }

    static bool isDrawing(const QObject& receiver, const QEvent& event)
    {
        return event.type() == QEvent::Paint && receiver.objectName() == "viewport";
    }

    bool draw(QObject* receiver, QEvent* event)
    {
        const double start = ownTime();
        const bool result = QApplication::notify(receiver, event);
        const double time = ownTime() - start;
        if (!m_running.empty())
            m_running.back().elsewhere += time;
        m_longestDrawing = std::max(m_longestDrawing, time);
        return result;
    }

    static QString nameOf(const QObject* object)
    {
        const QString name = object->objectName();
        return name.isEmpty() ? QString(object->metaObject()->className()) : name;
    }

    std::vector<Running> m_running;
    Longest m_longest;
    double m_longestDrawing = 0;
};

} // namespace knead
