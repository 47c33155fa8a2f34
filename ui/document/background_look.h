#pragma once

#include "core/task/ordered_worker.h"
#include "core/task/task_control.h"
#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QObject>

#include <atomic>
#include <functional>
#include <memory>

class QTimer;

namespace knead {

/// Looks at what a document shows while a person works, on a thread of low priority: once a second or more seldom while time runs,
/// and once when it stands still. A look is given up when another part is opened, and when time stands still and the shape
/// becomes another one. Window thread.
class BackgroundLook final : public QObject {
    Q_OBJECT
public:
    using Finish = std::function<void()>; ///< in the window's thread: what was found is taken
    /// On the looking thread. @throws Cancelled
    using Look = std::function<Finish(const FramePointer& frame, TaskControl& control)>;

    BackgroundLook(Document& document, Look look, QObject* parent);
    ~BackgroundLook() override;

    /// That was looked at last, or is; null: none of this content yet.
    const FramePointer& seen() const { return m_seen; }

signals:
    void forgotten(); ///< there is another content

private:
    class Stop;

    void documentChanged(Document::Change what);
    void look();
    void end(const FramePointer& frame, qint64 time, const Finish& finish);

    Document& m_document;
    Look m_look;
    QTimer* m_timer;
    QElapsedTimer m_clock;
    FramePointer m_seen;
    std::shared_ptr<Stop> m_stop; ///< of the look that is under way; null: none is
    qint64 m_lookTime = 0;        ///< that the last look took [ms]
    OrderedWorker m_worker;       // last: ends first
};

} // namespace knead
