#include "core/geometry/turn.h"

namespace knead {

Quaternion turnOnto(const Vec3& from, const Vec3& onto)
{
    return Quaternion::FromTwoVectors(from, onto);
}

} // namespace knead
