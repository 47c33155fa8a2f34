#pragma once

#include "core/model/part.h"

#include <memory>

class vtkRenderer;

namespace knead {

/// Thin lines on the ground that fade out with distance from the part.
class GridActor {
public:
    explicit GridActor(vtkRenderer* renderer);
    ~GridActor();
    GridActor(const GridActor&) = delete;
    GridActor& operator=(const GridActor&) = delete;

    /// Lays the grid under a box, at a height [m], with a round spacing.
    void lay(const Box& box, double height, const Color& color);
    void setVisible(bool visible);
    /// Before each drawing: it is blended with what was drawn before it, so it comes after all that one cannot see through.
    /// @param isInFront seen from below: glass is behind it, too, and drawn before
    void comeLast(bool isInFront);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
