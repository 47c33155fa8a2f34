#pragma once

#include "core/task/task_control.h"
#include "ui/viewport/scene_view.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <memory>
#include <optional>

namespace knead {

/// Draws frames into pictures of any size, unseen, with a graphics context of its own. Lives in the window's thread.
class Studio final : public QObject {
    Q_OBJECT
public:
    /// To be held by other threads too: it goes in the window's thread all the same.
    /// @throws std::runtime_error with a sentence, without OpenGL
    static std::shared_ptr<Studio> make(SceneLook look, const QSize& size);
    ~Studio() override;

    /// @param sight what was found out about the frame, when the look asks for it; null: nothing
    QImage draw(const FramePointer& frame, const SightPointer& sight = nullptr);
    /// From a task thread, which waits for the window's.
    /// @param at written into the picture with the forces on tools [s]; none: neither
    /// @throws as draw(); Cancelled
    static QImage drawFor(const std::shared_ptr<Studio>& studio, const FramePointer& frame, std::optional<double> at,
                          TaskControl& control);

private:
    struct Room;
    Studio(SceneLook look, const QSize& size);
    void writeReadings(QImage& picture, double at) const;
    void drawLegend(QImage& picture) const;

    SceneLook m_look;
    QSize m_size;
    SightMaker m_sights; ///< of the one task thread that asks for pictures
    std::unique_ptr<Room> m_room;
    std::unique_ptr<SceneView> m_scene;
};

} // namespace knead
