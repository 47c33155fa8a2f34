#pragma once

#include "ui/viewport/camera.h"
#include "ui/viewport/scene_style.h"

#include <memory>
#include <optional>

class vtkRenderWindow;

namespace knead {

/// The cube in the upper right that shows how the view is turned. A click on a side, an edge or a corner looks from
/// there.
class ViewCube {
public:
    explicit ViewCube(vtkRenderWindow* window);
    ~ViewCube();
    ViewCube(const ViewCube&) = delete;
    ViewCube& operator=(const ViewCube&) = delete;

    void setStyle(const SceneStyle& style);
    void setCamera(const Camera& camera);
    void setWindow(const WindowSize& window); ///< [logical pixels]
    void setDrawn(bool on);                   ///< pictures of the part alone are without it

    /// The direction to look from when this pixel is clicked; empty outside the cube.
    std::optional<Vec3> directionAt(const Pixel& pixel) const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
    Camera m_camera;
    WindowSize m_window;
};

} // namespace knead
