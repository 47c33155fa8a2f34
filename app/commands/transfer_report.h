#pragma once

#include "core/session/transferred_recipe.h"

#include <nlohmann/json_fwd.hpp>

namespace knead {

/// Which face is which, as a table, and what was moved by how much.
void printTransfer(const TransferReport& report);

/// The same as JSON.
nlohmann::ordered_json jsonOf(const TransferReport& report);

} // namespace knead
