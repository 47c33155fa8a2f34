#pragma once

#include "io/document/cad_document.h"

#include <string>

class IGESCAFControl_Reader;

namespace knead {

/// The names of solids, which IGES keeps as properties (406 form 15). OpenCASCADE writes these, and reads them for what is not
/// within a group only.
ShapeNotes<std::string> namesOfIgesSolids(const IGESCAFControl_Reader& reader);

} // namespace knead
