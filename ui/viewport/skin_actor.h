#pragma once

#include "ui/document/frame.h"
#include "ui/viewport/scene_style.h"

#include <functional>
#include <memory>

class vtkRenderer;

namespace knead {

/// Draws the surface of one body: faces in their colors and thin feature edges. Window thread, like all actors.
class SkinActor {
public:
    SkinActor(std::shared_ptr<const ContentBody> body, vtkRenderer* renderer);
    ~SkinActor();
    SkinActor(const SkinActor&) = delete;
    SkinActor& operator=(const SkinActor&) = delete;

    void show(const BodyFrame& frame);
    void setVisible(bool faces, bool edges);
    void setEdges(const Color& color, float width);
    /// Colors the surface face by face.
    void setColors(const std::function<Color(std::uint32_t face)>& colorOf);

private:
    struct Parts;
    std::shared_ptr<const ContentBody> m_body;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
