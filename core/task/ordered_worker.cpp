#include "core/task/ordered_worker.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace knead {

struct OrderedWorker::Queue {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::deque<std::function<void()>> waiting;
    std::jthread thread; // last: stops and joins first

    void carryOut(const std::stop_token& stop)
    {
        for (;;) {
            std::unique_lock lock(mutex);
            if (!wake.wait(lock, stop, [this] { return !waiting.empty(); }) || stop.stop_requested())
                return;
            const std::function<void()> work = std::move(waiting.front());
            waiting.pop_front();
            lock.unlock();
            work();
        }
    }
};

OrderedWorker::OrderedWorker()
    : m_queue(std::make_unique<Queue>())
{
    m_queue->thread = std::jthread([queue = m_queue.get()](const std::stop_token& stop) { queue->carryOut(stop); });
}

OrderedWorker::~OrderedWorker() = default;

void OrderedWorker::run(std::function<void()> work)
{
    {
        const std::lock_guard lock(m_queue->mutex);
        m_queue->waiting.push_back(std::move(work));
    }
    m_queue->wake.notify_one();
}

} // namespace knead
