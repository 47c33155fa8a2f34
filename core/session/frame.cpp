#include "core/session/frame.h"

#include "core/session/ambient_shade.h"
#include "core/session/contact_shade.h"
#include "core/session/crack_gaps.h"
#include "core/session/relief.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace knead {

namespace {

std::shared_ptr<const BodyFrame> bodyFrame(const FilledBody& body, const Snapshot::BodyState& state)
{
    auto frame = std::make_shared<BodyFrame>();
    frame->places.resize(body.mesh.vertices.size());
    body.skin->evaluate(state.displacements(), frame->places);
    frame->acrossCracks = trianglesAcrossCracks(body, state, frame->places);
    frame->points = renderPoints(body.render, frame->places);
    frame->normals = renderNormals(body.render, frame->points);
    frame->shades = reliefShades(body.render, frame->points, frame->normals);
    return frame;
}

bool isWhereItWas(const ToolState& now, const ToolState& before)
{
    return now.kind == before.kind && now.part == before.part && now.size == before.size &&
           now.pose.position == before.pose.position && now.pose.rotation.coeffs() == before.pose.rotation.coeffs();
}

/// Tools move also while time stands still.
void shadeContacts(Frame& frame, const Snapshot& snapshot, const FramePointer& previous)
{
    if (previous && previous->bodies == frame.bodies && previous->contactShades.size() == frame.bodies.size() &&
        std::ranges::equal(snapshot.tools, previous->snapshot->tools, isWhereItWas)) {
        frame.contactShades = previous->contactShades;
        return;
    }
    const MaterialAround material(snapshot.bodies);
    for (const auto& body : frame.bodies) {
        std::vector<float> shades = contactShades(body->points, body->normals, snapshot.tools);
        const std::vector<float> around = ambientShades(body->points, body->normals, material);
        if (shades.empty())
            shades = around;
        else if (!around.empty())
            std::ranges::transform(shades, around, shades.begin(), std::multiplies());
        frame.contactShades.push_back(shades.empty() ? nullptr
                                                     : std::make_shared<const std::vector<float>>(std::move(shades)));
    }
}

} // namespace

FramePointer prepareFrame(const FilledBodies& bodies, SnapshotPointer snapshot, const FramePointer& previous,
                          bool mayLag)
{
    auto frame = std::make_shared<Frame>();
    const bool isUnmoved = previous &&
                           previous->snapshot->arrivals == snapshot->arrivals && // branches meet at equal steps
                           (previous->snapshot->step == snapshot->step ||
                            (snapshot->rest > 0 && previous->snapshot->rest == snapshot->rest));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Snapshot::BodyState& state = snapshot->bodies[b];
        const std::shared_ptr<const FilledBody> filled = filledAs(bodies[b], state.aggregate);
        std::shared_ptr<const FilledBody> lately = mayLag ? tornLately(filled, state.broken) : nullptr;
        frame->lags = frame->lags || lately;
        frame->filled.push_back(lately ? std::move(lately) : tornAs(filled, state.broken));
    }
    if (isUnmoved && previous->filled == frame->filled)
        frame->bodies = previous->bodies;
    else
        for (std::size_t b = 0; b < bodies.size(); ++b)
            frame->bodies.push_back(bodyFrame(*frame->filled[b], snapshot->bodies[b]));
    shadeContacts(*frame, *snapshot, previous);
    frame->snapshot = std::move(snapshot);
    return frame;
}

struct FramePreparer::Worker {
    FilledBodies bodies;
    std::function<void(FramePointer)> deliver;
    std::mutex mutex;
    std::condition_variable_any wake;
    SnapshotPointer waiting;
    std::jthread thread; // last: stops and joins first

    void run(const std::stop_token& stop)
    {
        constexpr std::chrono::milliseconds quiet(250);
        FramePointer previous;
        for (;;) {
            std::unique_lock lock(mutex);
            const auto isWaiting = [this] { return waiting != nullptr; };
            if (previous && previous->lags)
                wake.wait_for(lock, stop, quiet, isWaiting);
            else
                wake.wait(lock, stop, isWaiting);
            if (stop.stop_requested())
                return;
            const bool isNew = isWaiting();
            SnapshotPointer snapshot = isNew ? std::exchange(waiting, nullptr) : previous->snapshot;
            lock.unlock();
            previous = prepareFrame(bodies, std::move(snapshot), previous, isNew);
            deliver(previous);
        }
    }
};

FramePreparer::FramePreparer(FilledBodies bodies, std::function<void(FramePointer)> deliver)
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
