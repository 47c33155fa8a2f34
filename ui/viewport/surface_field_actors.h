#pragma once

#include "core/session/surface_fields.h"
#include "ui/viewport/scene_view.h"

#include <memory>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws what is seen besides the skin as it is now: the original shape, connections, where they broke, and what a section
/// plane and the divider between before and after cut off. Window thread, like all actors.
class SurfaceFieldActors {
public:
    explicit SurfaceFieldActors(vtkRenderer* renderer);
    ~SurfaceFieldActors();
    SurfaceFieldActors(const SurfaceFieldActors&) = delete;
    SurfaceFieldActors& operator=(const SurfaceFieldActors&) = delete;

    void setModel(const FilledModel& content);
    void setBodies(const FilledBodies& bodies); ///< the same with other fillings
    void showFrame(const FramePointer& frame);
    void setStyle(const SceneStyle& style);
    void setAppearance(const PartAppearance& looks);
    void setOptions(const SceneOptions& options);
    /// Where no more than the section plane or the divider has moved: cheap.
    void setCut(const SceneOptions& options);
    void setSurfaceFields(const SurfaceFieldsPointer& fields);
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
    FilledBodies m_bodies;
    Box m_box; ///< at rest [m]
    FramePointer m_frame;
    SurfaceFieldsPointer m_fields;
    SceneOptions m_options;
    SceneStyle m_style;
    PartAppearance m_appearance;
};

} // namespace knead
