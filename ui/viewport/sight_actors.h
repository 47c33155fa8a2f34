#pragma once

#include "ui/viewport/scene_view.h"
#include "ui/viewport/sight.h"

#include <memory>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws what is seen besides the skin as it is now: the original shape, connections, where they broke, and what a section
/// plane and the divider between before and after cut off. Window thread, like all actors.
class SightActors {
public:
    explicit SightActors(vtkRenderer* renderer);
    ~SightActors();
    SightActors(const SightActors&) = delete;
    SightActors& operator=(const SightActors&) = delete;

    void setContent(const Content& content);
    void setBodies(const ContentBodies& bodies); ///< the same with other fillings
    void showFrame(const FramePointer& frame);
    void setStyle(const SceneStyle& style);
    void setLooks(const PartLooks& looks);
    void setOptions(const SceneOptions& options);
    void setSight(const SightPointer& sight);
    /// @param aspect of the view, width by height
    void setCamera(const Camera& camera, double aspect);

    /// What keeps the part of the deformed material that is to be seen; for its actors.
    vtkPlaneCollection* clipping() const;
    vtkPlaneCollection* clippingOfStill() const; ///< for what looks alike before and after

private:
    struct Parts;

    bool isShown(std::size_t body) const;
    void showOriginals();
    void showConnections();
    void showBreaks();
    void showCaps();
    void clip();

    std::unique_ptr<Parts> m_parts;
    std::shared_ptr<const Model> m_model;
    ContentBodies m_bodies;
    Box m_box; ///< at rest [m]
    FramePointer m_frame;
    SightPointer m_sight;
    SceneOptions m_options;
    SceneStyle m_style;
    PartLooks m_looks;
};

} // namespace knead
