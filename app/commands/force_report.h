#pragma once

#include "core/session/recipe_runner.h"

#include <nlohmann/json_fwd.hpp>

namespace knead {

/// What `knead run --json` says of forces and balances: `fixtures`, `loads`, more of `tools`, `forces_csv`, `static`.
void addForces(nlohmann::ordered_json& json, const RunReport& report);

/// The same for people, on stdout.
void printForces(const RunReport& report);

} // namespace knead
