#pragma once

#include "core/task/task_control.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QTimer;

namespace knead {

/// Runs one long computation at a time beside the window. The work gets a TaskControl and runs on a thread of its own;
/// its result is
/// handed over on the window's thread. Cancelling is felt at once: the work is told to stop and its result is thrown
/// away, even if a library takes a while to notice.
class TaskRunner final : public QObject {
    Q_OBJECT
public:
    explicit TaskRunner(QObject* parent = nullptr);
    /// As stop().
    ~TaskRunner() override;

    bool isRunning() const { return m_task != nullptr; }
    QString title() const;

    /// Runs `work`; then `finish` with its result, on this thread.
    /// @param title what is being done: "Opening bracket.step"
    /// @return false, and nothing happens, while another task runs
    template <class Result>
    bool run(const QString& title, std::function<Result(TaskControl&)> work, std::function<void(Result)> finish)
    {
        auto result = std::make_shared<std::unique_ptr<Result>>();
        return start(
            title, [work, result](TaskControl& control) { *result = std::make_unique<Result>(work(control)); },
            [finish, result] { finish(std::move(**result)); });
    }

    void cancel();

    /// Tells all tasks to stop and waits for their threads: before what they use goes. Nothing is emitted.
    void stop();

signals:
    void started(const QString& title);
    void progressed(double fraction, const QString& stage);
    void finished();                                            ///< after every task, however it ended
    void failed(const QString& title, const QString& sentence); ///< nothing has changed
    void cancelled(const QString& title);                       ///< nothing has changed

private:
    struct Task;

    bool start(const QString& title, std::function<void(TaskControl&)> work, std::function<void()> finish);
    void poll();
    void forgetEnded();
    void end();

    std::shared_ptr<Task> m_task;
    std::vector<std::shared_ptr<Task>> m_abandoned; ///< cancelled, perhaps still on their way out
    QTimer* m_timer;
};

} // namespace knead
