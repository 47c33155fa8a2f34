#pragma once

#include "core/session/measurement.h"

#include <string>

namespace knead {

/// A way of measuring and what it takes: "distance 0,0,0 100,0,0", "face-radius lid:12". A place is the point of the skin at rest that
/// lies nearest to three coordinates [mm]; a face is its number in the part, after the name of its body, in quotes where that has
/// blanks, or "#" and the number of that from 0, where there are several.
/// @throws Problem: what is not understood, or not there
Measurement measurementOf(const std::string& text, const FilledModel& content);

/// "distance"
std::string wordFor(MeasureKind kind);

} // namespace knead
