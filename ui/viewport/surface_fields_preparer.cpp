#include "ui/viewport/surface_fields_preparer.h"

namespace knead {

void SurfaceFieldsPreparer::begin(FilledBodies bodies)
{
    m_maker = std::make_shared<SurfaceFieldsMaker>(std::move(bodies));
    forget();
    ++m_generation;
}

void SurfaceFieldsPreparer::ask(const FramePointer& frame, const SurfaceFieldsRequest& request)
{
    m_asked = {frame, request};
    work();
}

void SurfaceFieldsPreparer::work()
{
    if (m_isBusy || m_asked == m_begun || !m_asked.first)
        return; // take() goes on with it
    m_isBusy = true;
    m_begun = m_asked;
    m_worker.run([this, maker = m_maker, request = m_begun, generation = m_generation] {
        const SurfaceFieldsPointer fields = maker->make(request.first, request.second);
        QMetaObject::invokeMethod(
            this, [this, fields, generation] { take(fields, generation); }, Qt::QueuedConnection);
    });
}

void SurfaceFieldsPreparer::take(const SurfaceFieldsPointer& fields, std::uint64_t generation)
{
    m_isBusy = false;
    if (generation == m_generation)
        emit made(fields);
    work();
}

} // namespace knead
