#pragma once

#include "core/simulation/snapshot.h"
#include "ui/viewport/scene_style.h"

#include <memory>

class vtkRenderer;

namespace knead {

/// Draws a tool and the force of the material on it.
class ToolActor {
public:
    explicit ToolActor(vtkRenderer* renderer);
    ~ToolActor();
    ToolActor(const ToolActor&) = delete;
    ToolActor& operator=(const ToolActor&) = delete;

    /// @param longestArrow length of the arrow of the largest force so far [m]; 0: none is drawn
    void show(const ToolState& tool, double longestArrow);
    void setStyle(const SceneStyle& style, bool selected, bool hovered);

    /// Tip of the arrow, where its number belongs; the top of the tool without a force [m].
    Vec3 labelPlace() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
