#pragma once

#include <Standard_Handle.hxx>
#include <Standard_Transient.hxx>

#include <vector>

class STEPControl_Reader;

namespace knead {

/// The entities whose points, directions or curves are missing, or of the wrong kind, where the reader would follow them
/// blindly and crash while it makes shapes.
std::vector<Handle(Standard_Transient)> hollowEntities(const STEPControl_Reader& reader);

} // namespace knead
