#pragma once

#include "core/mechanics/manipulator.h"

#include <pybind11/pybind11.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace knead::python {

using RotationWords = std::array<double, 4>; ///< a quaternion (w, x, y, z)

RotationWords wordsOf(const Quaternion& rotation);

/// @param otherwise without a rotation @throws Problem for one whose length is not 1
Pose poseOf(const Vec3& position, const std::optional<RotationWords>& rotation, const Quaternion& otherwise);

/// Of (time, position) or (time, position, rotation); a frame without a rotation has that of the one before.
std::vector<KeyFrame> framesOf(const std::vector<pybind11::tuple>& frames, const Pose& before);

/// "box", "ball", "cylinder", "wedge", "plate". @throws Problem for another one
ToolKind toolKindCalled(const std::string& name);

using SizeWords = std::variant<double, std::vector<double>>;

/// The measures a form has [m]: one for a ball, (diameter, length) for a cylinder, else three. @throws Problem for another number
Vec3 sizeOf(ToolKind kind, const SizeWords& size);

} // namespace knead::python
