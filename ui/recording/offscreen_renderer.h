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

    /// @param at written into the picture with the forces on tools [s]; none: neither
    /// @throws std::runtime_error with a sentence, when the graphics card gives no picture of this size
    QImage draw(const FramePointer& frame, std::optional<double> at);

private:
    struct Room;
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
