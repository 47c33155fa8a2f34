#pragma once

#include "io/document/cad_document.h"

#include <string>

class STEPControl_Reader;

namespace knead {

/// A loop on a ball bounds two faces: what is within and all the rest. OpenCASCADE 7.6 takes the smaller one where the loop crosses
/// the seam, silently, of balls, splines and turned surfaces that end in two poles; a ball on a neck lost six sevenths of its volume so.
/// Puts the faces there that the file means, by the directions of its loops.
/// Warns of those where the file does not say it.
/// @pre shapes were made of the file, and `document` has them
void mendFaceSides(const STEPControl_Reader& reader, const std::string& path, CadDocument& document);

} // namespace knead
