#pragma once

#include <optional>
#include <string>

class STEPControl_Reader;

namespace knead {

/// The number of the first entity ("#37") whose points, directions or curves are missing, or of the wrong kind, where the
/// reader would follow them blindly and crash while it makes shapes.
std::optional<std::string> hollowEntity(const STEPControl_Reader& reader);

} // namespace knead
