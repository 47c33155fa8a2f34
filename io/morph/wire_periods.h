#pragma once

#include "io/morph/trimmed_face.h"

#include <span>

namespace knead {

/// Shifts edges of a wire by whole periods of the surface, so that it runs on where its edges share a vertex. Faces that were
/// divided may share a surface, and with it the curves of the edges between them, which then lie a period away for one of them.
/// A wire with a seam is left as it is: its edges share vertices on both sides of that.
/// @param period of the surface along u and v; 0: it has none there
void bringIntoOnePeriod(std::span<FaceEdge> wire, const Vec2& period);

} // namespace knead
