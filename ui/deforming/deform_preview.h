#pragma once

#include "core/deformation/deformation.h"
#include "core/session/deformed_frame.h"
#include "core/task/ordered_worker.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace knead {

/// What is to be looked at.
struct PreviewRequest {
    std::shared_ptr<const std::vector<Deformation>> deformations; ///< at least one
    double exaggeration = 1;                                      ///< of all ways, to see more of them
    std::vector<bool> which;                                      ///< per body; empty: all
    FramePointer from;                                            ///< what is deformed
    /// Called on the thread of the preview with a map that is new, after its frame was made; may throw Cancelled, as it is to when
    /// other deformations are asked for. May be null.
    std::function<void(const SmoothMap& map, TaskControl&)> examine = {};
};

/// Computes what deformations would make of surfaces on a thread of its own, always the newest that was asked for, so that the window
/// never waits for a large part. A field that was fitted once is not fitted again for another factor. Window thread.
class DeformPreview final : public QObject {
    Q_OBJECT
public:
    explicit DeformPreview(QObject* parent = nullptr);
    ~DeformPreview() override;

    void ask(PreviewRequest request);
    void forget();  ///< nothing is made any more
    void release(); ///< the same, and the map that was made last goes: that of a large field takes much memory

signals:
    void made(const knead::DeformedFrame& frame);
    void failed(const QString& sentence);

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared;
    OrderedWorker m_worker; // last: it uses the other
};

} // namespace knead
