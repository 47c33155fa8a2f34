#pragma once

#include "app/morph_file.h"

#include <nlohmann/json_fwd.hpp>

namespace knead {

/// What `knead morph` says at its end, in lines for a person, to the output.
void printMorph(const MorphReport& report);

/// What `knead morph --json` prints.
nlohmann::ordered_json jsonOf(const MorphReport& report);

} // namespace knead
