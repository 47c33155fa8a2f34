#pragma once

#include "core/task/task_control.h"
#include "io/brep/cad_body.h"

#include <optional>

namespace knead {

/// Closes a surface whose every opening lies in a plane with plane faces: the bottom that a file left out. Only at a person's
/// wish, since a guess it is.
/// @return nothing when an opening is not flat, or the surface is not closed by it
/// @throws Cancelled
std::optional<CadBody> capped(const CadBody& surface, TaskControl& control);

} // namespace knead
