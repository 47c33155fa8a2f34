#pragma once

#include "core/geometry/surface_distance.h"
#include "core/session/face_matching.h"

#include <memory>
#include <span>
#include <vector>

namespace knead {

/// Where a place in or near a part is on another one whose faces were matched with its own.
///   y(x) = B(x) + u(x),  sum_f w_f P_f (u - d_f) + e (u - m) = 0,  w_f = 1 / (r_f^2 + s^2)^2
/// B is the rough map, r_f the distance from x to the face f, d_f how far its center goes beyond B, and P_f its mean of n n^T: a plane
/// says nothing of motions along itself, a cylinder nothing of those along its axis. What grew in radius goes outward by that. m is the
/// median of all d_f, and s, e are small. On a face x stays on the face, and keeps its distance from the face that bounds it nearest.
/// Any thread.
class PlaceMap {
public:
    /// @pre looks are those of the parts, matches are of them
    /// On all threads. @throws Cancelled
    PlaceMap(const Part& before, std::span<const FaceLook> looksBefore, std::span<const FaceLook> looksAfter,
             std::span<const FaceMatch> matches, const AffineMap& base,
             const TaskControl& control = TaskControl::none());
    PlaceMap(PlaceMap&&) noexcept = default;
    PlaceMap& operator=(PlaceMap&&) noexcept = default;
    ~PlaceMap();

    Vec3 at(const Vec3& place) const { return m_base.at(place) + beyond(place); }
    Vec3 beyond(const Vec3& place) const; ///< u [m]

    /// The same of many, on all threads. @throws Cancelled
    std::vector<Vec3> at(std::span<const Vec3> places, const TaskControl& control = TaskControl::none()) const;

private:
    struct Face;

    AffineMap m_base;
    std::vector<std::unique_ptr<const Face>> m_faces;
    Vec3 m_median = Vec3::Zero();
    double m_nearest = 0; ///< s [m]
    double m_pull = 0;    ///< e [1/m^4]
};

} // namespace knead
