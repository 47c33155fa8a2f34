#pragma once

#include "ui/viewport/scene_view.h"

#include <QImage>
#include <QSize>

#include <memory>
#include <optional>

class QOffscreenSurface;

namespace knead {

/// Draws frames into pictures of any size, unseen, with a graphics context of its own. Made, used and destroyed in one thread, which
/// may be any.
class OffscreenRenderer final {
public:
    /// What a context draws on; Qt makes and destroys it in the window's thread only. Any thread may hold it.
    using Surface = std::shared_ptr<QOffscreenSurface>;
    /// Window's thread.
    /// @throws std::runtime_error with a sentence, where the driver draws in the window's thread only
    static Surface makeSurface();

    /// @param size [pixels]
    /// @throws std::runtime_error with a sentence, without OpenGL
    OffscreenRenderer(SceneLook look, const QSize& size, Surface surface);
    ~OffscreenRenderer();
    OffscreenRenderer(const OffscreenRenderer&) = delete;
    OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

    /// Lines become wider and the cube larger with the picture. @param scale its pixels per logical pixel of the view
    void setScale(double scale);
    void showCube(bool on); ///< off before; has its place by setScale()

    /// @param at written into the picture with the forces on tools [s]; none: neither
    /// @throws std::runtime_error with a sentence, when the graphics card gives no picture of this size
    QImage draw(const FramePointer& frame, std::optional<double> at);

    /// The same without the background, and without what is written into the picture but the legend.
    /// @return its colors are multiplied by its opacity
    /// @throws as draw()
    QImage drawClear(const FramePointer& frame);

private:
    struct Room;
    void show(const FramePointer& frame);
    QImage shot();
    QImage pixels() const;
    void writeReadings(QImage& picture, double at) const;
    void drawLegend(QImage& picture) const;

    SceneLook m_look;
    QSize m_size;
    SurfaceFieldsMaker m_sights;
    std::unique_ptr<Room> m_room;
    std::unique_ptr<SceneView> m_scene;
};

} // namespace knead
