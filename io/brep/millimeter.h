#pragma once

namespace knead {

constexpr double millimeter = 1e-3; ///< [m]; the unit of OpenCASCADE's shapes

} // namespace knead
