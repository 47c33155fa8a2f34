#pragma once

#include "core/session/frame.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/color_scale.h"
#include "ui/viewport/scene_style.h"
#include "ui/viewport/skin_shading.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws the surface of one body: faces in their colors and thin feature edges. Window thread, like all actors.
class SkinActor {
public:
    SkinActor(std::shared_ptr<const FilledBody> body, vtkRenderer* renderer);
    ~SkinActor();
    SkinActor(const SkinActor&) = delete;
    SkinActor& operator=(const SkinActor&) = delete;

    void show(const BodyFrame& frame);
    /// Of tools beside it, see Frame::contactShades; null: none is near. After show().
    void setContactShades(std::shared_ptr<const std::vector<float>> shades);
    /// Leaves out edges that lie behind the material. For closed bodies, before each drawing.
    void hideEdgesBehind(const Camera& camera);
    void setVisible(bool faces, bool edges);
    void setEdges(const Color& color, float width);
    /// Colors the surface face by face.
    void setColors(const std::function<Color(std::uint32_t face)>& colorOf);
    /// Colors the surface by numbers at the vertices of FilledBody::mesh.
    void setValues(std::span<const float> values, const ColorScale& scale);
    /// Mixes the colors of some faces with another, on top of either. @param share of that, 0 .. 1
    void tint(double share, const std::function<std::optional<Color>(std::uint32_t face)>& colorOf);
    /// Before setColors(), whose colors curvature mixes with its own.
    void setShading(Shading shading, MaterialLook look);
    void setOpacity(double opacity);              ///< 0 .. 1; below 1 only what faces the eye is drawn
    void setClipping(vtkPlaneCollection* planes); ///< keeps what is on the positive sides; the list may change later

private:
    void leaveOut(const std::vector<std::uint32_t>& triangles);
    void showColors();
    void drawEdges(const std::vector<bool>& isSeen);
    void layEdges();

    struct Parts;
    std::shared_ptr<const FilledBody> m_body;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
