#include "io/morph/millimetre_map.h"

namespace knead {

MillimetreMap MillimetreMap::forFace(std::vector<Vec3> places) const
{
    for (Vec3& place : places)
        place *= 1e-3;
    return MillimetreMap(m_map.ofFace(places));
}

void MillimetreMap::evaluate(std::span<const Vec3> points, std::span<Vec3> places) const
{
    std::vector<Vec3> metres(points.begin(), points.end());
    for (Vec3& point : metres)
        point *= 1e-3;
    m_map.evaluate(metres, places);
    for (Vec3& place : places)
        place *= 1e3;
}

} // namespace knead
