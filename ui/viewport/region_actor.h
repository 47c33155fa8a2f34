#pragma once

#include "ui/document/frame.h"
#include "ui/selection/region.h"

#include <memory>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws edges, objects and connections of a region, each in a way that stands out. Parts and faces are colored on their skins
/// instead.
class RegionActor {
public:
    explicit RegionActor(vtkRenderer* renderer);
    ~RegionActor();
    RegionActor(const RegionActor&) = delete;
    RegionActor& operator=(const RegionActor&) = delete;

    void setColor(const Color& color);
    void setClipping(vtkPlaneCollection* planes); ///< as SkinActor
    /// @param scale of objects, in their usual radii
    void show(const Region& region, const ContentBodies& bodies, const Frame& frame, double scale);
    void hide();
    bool isShown() const;

private:
    struct Parts;
    void addLines(const Region& region, const ContentBodies& bodies, const Frame& frame);
    void addObjects(const Region& region, const ContentBodies& bodies, const Frame& frame, double scale);

    std::unique_ptr<Parts> m_parts;
};

} // namespace knead
