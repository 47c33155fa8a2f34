#pragma once

#include "core/geometry/vec3.h"

#include <string>

namespace knead {

/// A place in the words of a report: "(12.3, -4, 0.5) mm". @param place [m]
std::string placeWords(const Vec3& place);

} // namespace knead
