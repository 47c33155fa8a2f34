#pragma once

#include "ui/viewport/camera.h"

namespace knead {

/// As Camera::project(), for very many places.
class Projector {
public:
    Projector(const Camera& camera, const WindowSize& window)
        : m_target(camera.target)
        , m_right(camera.right())
        , m_up(camera.up())
        , m_towardsEye(camera.towardsEye())
        , m_distance(camera.distance)
        , m_scale(window.height / camera.viewHeight())
        , m_perspective(camera.perspective)
        , m_window(window)
    {
    }

    std::optional<Pixel> operator()(const Vec3& place) const
    {
        const Vec3 offset = place - m_target;
        const double depth = m_perspective ? (m_distance - offset.dot(m_towardsEye)) / m_distance : 1;
        if (depth <= 1e-6)
            return std::nullopt;
        return Pixel{m_window.width / 2 + m_scale / depth * offset.dot(m_right),
                     m_window.height / 2 - m_scale / depth * offset.dot(m_up)};
    }

private:
    Vec3 m_target, m_right, m_up, m_towardsEye;
    double m_distance;
    double m_scale; ///< [pixels/m] at the target
    bool m_perspective;
    WindowSize m_window;
};

} // namespace knead
