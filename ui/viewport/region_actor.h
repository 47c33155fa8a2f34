#pragma once

#include "core/session/frame.h"
#include "core/session/region.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace knead {

/// Draws edges, objects and connections of a region, and the outlines of its faces, each in a way that stands out. Parts and faces
/// are colored on their skins besides.
class RegionActor {
public:
    explicit RegionActor(vtkRenderer* renderer);
    ~RegionActor();
    RegionActor(const RegionActor&) = delete;
    RegionActor& operator=(const RegionActor&) = delete;

    void setColor(const Color& color);
    void setClipping(vtkPlaneCollection* planes); ///< as SkinActor
    /// @param scale of objects, in their usual radii
    void show(const Region& region, const FilledBodies& bodies, const Frame& frame, double scale);
    void hide();
    bool isShown() const;

private:
    struct Parts;
    void addLines(const Region& region, const FilledBodies& bodies, const Frame& frame);
    const std::vector<std::array<std::uint32_t, 2>>& outlineOf(BodyId id, const std::shared_ptr<const FilledBody>& body,
                                                               const Region::Items& faces);
    void addObjects(const Region& region, const FilledBodies& bodies, const Frame& frame, double scale);

    /// Found once, as long as body and faces stay the same.
    struct Outline {
        std::weak_ptr<const FilledBody> body; ///< does not keep a part that is gone
        Region::Items faces;
        std::vector<std::array<std::uint32_t, 2>> lines; ///< of vertices of the mesh
    };

    std::unique_ptr<Parts> m_parts;
    std::map<BodyId, Outline> m_outlines;
    std::vector<float> m_ends; ///< of lines, x y z of each; kept for its memory
};

} // namespace knead
