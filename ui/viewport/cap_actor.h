#pragma once

#include "core/geometry/plane_section.h"
#include "core/model/part.h"

#include <array>
#include <memory>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws the faces that a section plane cuts out of a body: closed, in the color of the part, hatched as on drawings or plain,
/// with a line around. Window thread, like all actors.
class CapActor {
public:
    explicit CapActor(vtkRenderer* renderer);
    ~CapActor();
    CapActor(const CapActor&) = delete;
    CapActor& operator=(const CapActor&) = delete;

    /// @param hatching distance between lines [m]
    void show(const PlaneSection& section, const CutPlane& plane, double hatching);
    void setLook(const Color& face, const Color& edge, bool isHatched);
    void setVisible(bool visible);
    void setClipping(vtkPlaneCollection* planes);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

/// A rectangle that shows where a section plane lies around a box.
class PlaneFrameActor {
public:
    explicit PlaneFrameActor(vtkRenderer* renderer);
    ~PlaneFrameActor();
    PlaneFrameActor(const PlaneFrameActor&) = delete;
    PlaneFrameActor& operator=(const PlaneFrameActor&) = delete;

    void show(const CutPlane& plane, const Box& box);
    void setColor(const Color& color);
    void setVisible(bool visible);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

/// The corners of that rectangle, a little larger than what the box takes of the plane [m].
std::array<Vec3, 4> frameCorners(const CutPlane& plane, const Box& box);

} // namespace knead
