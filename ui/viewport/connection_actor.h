#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/model/part.h"

#include <memory>
#include <span>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

struct StrokesOfPoints;

/// Draws the live structural connections of a body as lines between its objects. Window thread, like all actors.
class ConnectionActor {
public:
    ConnectionActor(vtkRenderer* renderer, const Color& color);
    ~ConnectionActor();
    ConnectionActor(const ConnectionActor&) = delete;
    ConnectionActor& operator=(const ConnectionActor&) = delete;

    /// Which connections there are: to be called again when some broke.
    /// @param chosen ascending; only connections between these; all when empty
    void setConnections(const Aggregate& aggregate, std::span<const BrokenConnection> broken,
                        std::span<const ObjectIndex> chosen);
    void show(std::span<const Vec3> positions);
    void setClipping(vtkPlaneCollection* planes); ///< keeps what is on the positive sides

private:
    std::unique_ptr<StrokesOfPoints> m_parts;
};

/// Marks where connections broke: a dot at each end that is left, where the crack faces it. Drawn over everything, as cracks lie
/// inside.
class BreakActor {
public:
    explicit BreakActor(vtkRenderer* renderer);
    ~BreakActor();
    BreakActor(const BreakActor&) = delete;
    BreakActor& operator=(const BreakActor&) = delete;

    void show(const std::vector<Vec3>& marks);
    void setColor(const Color& color);
    void setClipping(vtkPlaneCollection* planes);

private:
    std::unique_ptr<StrokesOfPoints> m_parts;
};

/// The places of such marks: for each broken connection half a rest length from its ends, towards each other [m].
std::vector<Vec3> breakMarks(const Aggregate& aggregate, std::span<const Vec3> positions,
                             std::span<const BrokenConnection> broken);

} // namespace knead
