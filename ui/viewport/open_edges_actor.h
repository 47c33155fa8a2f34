#pragma once

#include "core/model/part.h"

#include <functional>
#include <memory>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws the lines along which the surfaces of parts end, so that a person sees where they are open. Window thread, like all
/// actors.
class OpenEdgesActor {
public:
    explicit OpenEdgesActor(vtkRenderer* renderer);
    ~OpenEdgesActor();
    OpenEdgesActor(const OpenEdgesActor&) = delete;
    OpenEdgesActor& operator=(const OpenEdgesActor&) = delete;

    /// Those of all visible parts. @param isHidden by index into Model::parts
    void show(const Model& model, const std::function<bool(std::size_t part)>& isHidden);
    void setVisible(bool visible);
    void setColor(const Color& color);
    void setClipping(vtkPlaneCollection* planes); ///< keeps what is on the positive sides; the list may change later

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
