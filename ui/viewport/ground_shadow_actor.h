#pragma once

#include "core/session/ground_shadow.h"

#include <memory>

class vtkRenderer;

namespace knead {

/// The shadow of part and tools on the ground, so that one sees what touches it and what hangs above.
class GroundShadowActor {
public:
    explicit GroundShadowActor(vtkRenderer* renderer);
    ~GroundShadowActor();
    GroundShadowActor(const GroundShadowActor&) = delete;
    GroundShadowActor& operator=(const GroundShadowActor&) = delete;

    /// @param height of the ground [m]
    void lay(const GroundShadow& shadow, double height);
    void setVisible(bool visible);
    /// Before each drawing, see GridActor.
    /// @param isInFront seen from below: glass is behind it, too, and drawn before
    void comeLast(bool isInFront);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
