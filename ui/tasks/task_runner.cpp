#include "ui/tasks/task_runner.h"

#include "core/message/message.h"
#include "ui/language/said.h"

#include <QCoreApplication>
#include <QTimer>

#include <atomic>
#include <mutex>
#include <thread>

namespace knead {

/// A task and its thread, which ends before the task does.
struct TaskRunner::Task final : TaskControl {
    ~Task() override
    {
        stopping = true;
        if (thread.joinable())
            thread.join();
    }

    QString title;
    std::function<void(TaskControl&)> work;
    std::function<void()> finish;

    std::atomic<bool> stopping = false;
    std::atomic<bool> done = false;
    std::mutex mutex; // guards the rest
    double fraction = 0;
    std::string stage;
    bool wasCancelled = false;
    Message failure;
    std::thread thread;

    void report(double newFraction, std::string_view newStage) override
    {
        const std::lock_guard lock(mutex);
        fraction = newFraction;
        stage = newStage;
    }

    bool isCancelled() const override { return stopping; }

    void run()
    {
        try {
            work(*this);
        } catch (const Cancelled&) {
            const std::lock_guard lock(mutex);
            wasCancelled = true;
        } catch (const std::bad_alloc&) {
            fail(Message("TaskRunner",
                         "%1: there is not enough memory. Close other programs, or choose a larger spacing.")
                     .with(title.toStdString()));
        } catch (const std::exception& error) {
            fail(messageOf(error));
        }
        work = nullptr;
        done = true;
    }

    void fail(const Message& sentence)
    {
        const std::lock_guard lock(mutex);
        failure = sentence;
    }
};

namespace {

constexpr int pollInterval = 30; // [ms]

} // namespace

TaskRunner::TaskRunner(QObject* parent)
    : QObject(parent)
    , m_timer(new QTimer(this))
{
    m_timer->setInterval(pollInterval);
    connect(m_timer, &QTimer::timeout, this, &TaskRunner::poll);
}

TaskRunner::~TaskRunner()
{
    stop();
}

void TaskRunner::stop()
{
    m_timer->stop();
    if (m_task)
        m_abandoned.push_back(std::move(m_task));
    for (const auto& task : m_abandoned) // all at once, before the first is waited for
        task->stopping = true;
    m_abandoned.clear();
}

QString TaskRunner::title() const
{
    return m_task ? m_task->title : QString();
}

bool TaskRunner::start(const QString& title, std::function<void(TaskControl&)> work, std::function<void()> finish)
{
    if (m_task)
        return false;
    forgetEnded();
    m_task = std::make_shared<Task>();
    m_task->title = title;
    m_task->work = std::move(work);
    m_task->finish = std::move(finish);
    m_task->thread = std::thread([task = m_task.get()] { task->run(); });
    m_timer->start();
    emit started(title);
    return true;
}

void TaskRunner::cancel()
{
    if (!m_task)
        return;
    m_task->stopping = true;
    const QString title = m_task->title;
    m_task->finish = nullptr; // with the result
    forgetEnded();
    m_abandoned.push_back(m_task);
    end();
    emit cancelled(title);
    emit finished();
}

void TaskRunner::forgetEnded()
{
    std::erase_if(m_abandoned, [](const auto& task) { return task->done.load(); });
}

void TaskRunner::poll()
{
    const std::shared_ptr<Task> task = m_task;
    if (!task->done) {
        std::unique_lock lock(task->mutex);
        const double fraction = task->fraction;
        const std::string stage = task->stage;
        lock.unlock();
        emit progressed(fraction, stage.empty() ? QString() : QCoreApplication::translate("Stage", stage.c_str()));
        return;
    }
    end();
    if (task->wasCancelled)
        emit cancelled(task->title);
    else if (!task->failure.empty())
        emit failed(task->title, said(task->failure));
    else
        task->finish();
    emit finished();
}

void TaskRunner::end()
{
    m_timer->stop();
    m_task.reset();
}

} // namespace knead
