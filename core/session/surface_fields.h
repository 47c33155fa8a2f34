#pragma once

#include "core/geometry/plane_section.h"
#include "core/session/frame.h"
#include "core/skin/surface_values.h"

#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// What of the material a person wants to see beyond its shape, and what takes time to find out.
struct SurfaceFieldsRequest {
    std::optional<SurfaceQuantity> quantity; ///< on the skin
    std::optional<CutPlane> section;         ///< that gets caps
    bool capsOriginal = false;               ///< those of the original shape too

    bool isEmpty() const { return !quantity && !section; }
    friend bool operator==(const SurfaceFieldsRequest&, const SurfaceFieldsRequest&) = default;
};

/// What was found out for one frame. Immutable, shared by pointer.
struct SurfaceFields {
    FramePointer frame;
    SurfaceFieldsRequest request;
    bool isKnown = true; ///< false: the frame does not tell the quantity
    /// Per body: at the vertices of FilledBody::mesh, in SI; empty without a quantity, or when it is not known.
    std::vector<std::vector<float>> values;
    double errorShare = 0; ///< of stress, about how wrong it may be by the resolution where it is largest; 0: not known
    std::vector<PlaneSection> caps;         ///< per body; empty without a section
    std::vector<PlaneSection> originalCaps; ///< per body
};
using SurfaceFieldsPointer = std::shared_ptr<const SurfaceFields>;

/// Finds out what is wished. Remembers what is the same from frame to frame. One thread at a time; uses several.
class SurfaceFieldsMaker {
public:
    explicit SurfaceFieldsMaker(FilledBodies bodies);
    ~SurfaceFieldsMaker();
    SurfaceFieldsMaker(const SurfaceFieldsMaker&) = delete;
    SurfaceFieldsMaker& operator=(const SurfaceFieldsMaker&) = delete;

    /// @pre the frame is one of these bodies
    SurfaceFieldsPointer make(const FramePointer& frame, const SurfaceFieldsRequest& request);

private:
    void findValues(SurfaceFields& fields);
    void prepareFor(SurfaceQuantity quantity, std::size_t body);
    void findCaps(SurfaceFields& fields);

    FilledBodies m_bodies;
    std::vector<std::unique_ptr<SurfaceDistance>> m_originals; ///< made when first wanted
    std::vector<std::unique_ptr<SkinStress>> m_stresses;       ///< likewise
    SurfaceFieldsPointer m_last;
};

} // namespace knead
