#pragma once

#include "core/model/part.h"

#include <memory>
#include <span>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws objects as spheres: one point each, the graphics card makes the ball.
class ObjectActor {
public:
    ObjectActor(vtkRenderer* renderer, const Color& color, double radius);
    ~ObjectActor();
    ObjectActor(const ObjectActor&) = delete;
    ObjectActor& operator=(const ObjectActor&) = delete;

    /// @param chosen which of the positions are drawn; all when empty
    void show(std::span<const Vec3> positions, std::span<const std::uint32_t> chosen);
    void setClipping(vtkPlaneCollection* planes); ///< keeps what is on the positive sides; the list may change later

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
