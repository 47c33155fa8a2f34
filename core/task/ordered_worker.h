#pragma once

#include <functional>
#include <memory>

namespace knead {

/// A thread that does one piece of work after the other, in the order in which they were asked for.
class OrderedWorker {
public:
    OrderedWorker();
    /// Ends after the present piece of work; the others are dropped.
    ~OrderedWorker();
    OrderedWorker(const OrderedWorker&) = delete;
    OrderedWorker& operator=(const OrderedWorker&) = delete;

    /// Returns at once; from any thread. @param work must not throw
    void run(std::function<void()> work);

private:
    struct Queue;
    std::unique_ptr<Queue> m_queue;
};

} // namespace knead
