#include "io/morph/rigid_piece.h"

#include "core/geometry/rigid_fit.h"

#include <vector>

namespace knead {

std::optional<gp_Trsf> rigidMotionOf(const SmoothMap& map, std::span<const Vec3> points, double tolerance)
{
    std::vector<Vec3> places(points.size());
    map.evaluate(points, places);
    double farthest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        farthest = std::max(farthest, (places[i] - points[i]).norm());
    gp_Trsf motion;
    if (farthest <= tolerance)
        return motion;
    const RigidFit fit = fitRigidMotion(points, places);
    if (!(fit.deviation <= tolerance))
        return std::nullopt;
    const Mat3& r = fit.turn;
    const Vec3 t = fit.to - r * fit.from;
    motion.SetValues(r(0, 0), r(0, 1), r(0, 2), t[0], r(1, 0), r(1, 1), r(1, 2), t[1], r(2, 0), r(2, 1), r(2, 2), t[2]);
    return motion;
}

} // namespace knead
