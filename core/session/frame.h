#pragma once

#include "core/session/filled_model.h"
#include "core/simulation/snapshot.h"

#include <functional>
#include <memory>
#include <vector>

namespace knead {

using FilledBodies = std::vector<std::shared_ptr<const FilledBody>>;

/// All that is drawn at one moment: a snapshot and the surfaces that belong to it. Immutable, shared by pointer.
struct Frame {
    SnapshotPointer snapshot;
    std::vector<std::shared_ptr<const BodyFrame>> bodies;
    FilledBodies filled; ///< the bodies as they are filled in the snapshot
    /// Per body and render vertex: what tools, see contactShades(), hollows and other bodies, see MaterialAround, leave of the light.
    /// Null or empty: all of it.
    std::vector<std::shared_ptr<const std::vector<float>>> contactShades;
    bool lags = false; ///< a crack is drawn as it was a moment ago
};

using FramePointer = std::shared_ptr<const Frame>;

/// Carries the surfaces along with a snapshot. Surfaces of `previous` are used again when no time has passed.
/// @param bodies of the document, whatever their filling
/// @param mayLag cracks that grow need not be followed every time
FramePointer prepareFrame(const FilledBodies& bodies, SnapshotPointer snapshot, const FramePointer& previous,
                          bool mayLag = false);

/// Prepares frames on a thread of its own, always the newest snapshot, so that the window never waits for a skin. One that lags is
/// prepared once more when nothing else is to be done.
class FramePreparer {
public:
    /// @param deliver called on the preparer's thread
    FramePreparer(FilledBodies bodies, std::function<void(FramePointer)> deliver);
    ~FramePreparer();
    FramePreparer(const FramePreparer&) = delete;
    FramePreparer& operator=(const FramePreparer&) = delete;

    /// Replaces a snapshot that is still waiting.
    void prepare(SnapshotPointer snapshot);

private:
    struct Worker;
    std::unique_ptr<Worker> m_worker;
};

} // namespace knead
