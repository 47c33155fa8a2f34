#include "ui/viewport/sight_preparer.h"

namespace knead {

void SightPreparer::begin(ContentBodies bodies)
{
    m_maker = std::make_shared<SightMaker>(std::move(bodies));
    forget();
    ++m_generation;
}

void SightPreparer::ask(const FramePointer& frame, const SightWish& wish)
{
    m_asked = {frame, wish};
    work();
}

void SightPreparer::work()
{
    if (m_isBusy || m_asked == m_begun || !m_asked.first)
        return; // take() goes on with it
    m_isBusy = true;
    m_begun = m_asked;
    m_worker.run([this, maker = m_maker, request = m_begun, generation = m_generation] {
        const SightPointer sight = maker->make(request.first, request.second);
        QMetaObject::invokeMethod(
            this, [this, sight, generation] { take(sight, generation); }, Qt::QueuedConnection);
    });
}

void SightPreparer::take(const SightPointer& sight, std::uint64_t generation)
{
    m_isBusy = false;
    if (generation == m_generation)
        emit made(sight);
    work();
}

} // namespace knead
