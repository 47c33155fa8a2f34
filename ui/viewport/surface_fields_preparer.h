#pragma once

#include "core/session/surface_fields.h"
#include "core/task/ordered_worker.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <utility>

namespace knead {

/// Makes surface fields on a thread of its own, always of what was asked for last, so that the window never waits for them. Window
/// thread.
class SurfaceFieldsPreparer final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Other bodies: what was asked for before is dropped.
    void begin(FilledBodies bodies);
    void ask(const FramePointer& frame, const SurfaceFieldsRequest& request);
    /// Nothing is wished any more: the same asked for again is made again.
    void forget() { m_asked = m_begun = {}; }

signals:
    void made(knead::SurfaceFieldsPointer fields);

private:
    using Request = std::pair<FramePointer, SurfaceFieldsRequest>;

    void work();
    void take(const SurfaceFieldsPointer& fields, std::uint64_t generation);

    std::shared_ptr<SurfaceFieldsMaker> m_maker; ///< used by the worker alone
    Request m_asked;
    Request m_begun; ///< asked for last of what the worker has or had
    std::uint64_t m_generation = 0;
    bool m_isBusy = false;
    OrderedWorker m_worker; // last: it ends first
};

} // namespace knead
