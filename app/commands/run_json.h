#pragma once

#include "core/session/recipe_runner.h"

#include <nlohmann/json_fwd.hpp>

namespace knead {

/// What `knead run --json` prints of a run, be it done or failed: then with `failure`.
nlohmann::ordered_json jsonOf(const RunReport& report);

} // namespace knead
