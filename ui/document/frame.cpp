#include "ui/document/frame.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace knead {

namespace {

std::shared_ptr<const BodyFrame> bodyFrame(const ContentBody& body, const Snapshot::BodyState& state)
{
    auto frame = std::make_shared<BodyFrame>();
    frame->places.resize(body.mesh.vertices.size());
    body.skin->evaluate(state.displacements(), frame->places);
    frame->points = renderPoints(body.render, frame->places);
    frame->normals = renderNormals(body.render, frame->points);
    return frame;
}

} // namespace

FramePointer prepareFrame(const ContentBodies& bodies, SnapshotPointer snapshot, const FramePointer& previous)
{
    auto frame = std::make_shared<Frame>();
    const bool isUnmoved = previous &&
                           previous->snapshot->arrivals == snapshot->arrivals && // branches meet at equal steps
                           (previous->snapshot->step == snapshot->step ||
                            (snapshot->rest > 0 && previous->snapshot->rest == snapshot->rest));
    for (std::size_t b = 0; b < bodies.size(); ++b)
        frame->filled.push_back(tornAs(filledAs(bodies[b], snapshot->bodies[b].aggregate), snapshot->bodies[b].broken));
    if (isUnmoved && previous->filled == frame->filled)
        frame->bodies = previous->bodies;
    else
        for (std::size_t b = 0; b < bodies.size(); ++b)
            frame->bodies.push_back(bodyFrame(*frame->filled[b], snapshot->bodies[b]));
    frame->snapshot = std::move(snapshot);
    return frame;
}

struct FramePreparer::Worker {
    ContentBodies bodies;
    std::function<void(FramePointer)> deliver;
    std::mutex mutex;
    std::condition_variable_any wake;
    SnapshotPointer waiting;
    std::jthread thread; // last: stops and joins first

    void run(const std::stop_token& stop)
    {
        FramePointer previous;
        for (;;) {
            std::unique_lock lock(mutex);
            if (!wake.wait(lock, stop, [this] { return waiting != nullptr; }))
                return;
            SnapshotPointer snapshot = std::exchange(waiting, nullptr);
            lock.unlock();
            previous = prepareFrame(bodies, std::move(snapshot), previous);
            deliver(previous);
        }
    }
};

FramePreparer::FramePreparer(ContentBodies bodies, std::function<void(FramePointer)> deliver)
    : m_worker(std::make_unique<Worker>())
{
    m_worker->bodies = std::move(bodies);
    m_worker->deliver = std::move(deliver);
    m_worker->thread = std::jthread([worker = m_worker.get()](const std::stop_token& stop) { worker->run(stop); });
}

FramePreparer::~FramePreparer() = default;

void FramePreparer::prepare(SnapshotPointer snapshot)
{
    {
        const std::lock_guard lock(m_worker->mutex);
        m_worker->waiting = std::move(snapshot);
    }
    m_worker->wake.notify_one();
}

} // namespace knead
