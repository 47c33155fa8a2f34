#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace knead::corpus {

/// A table of all files, one line each with tabs between: what the program says, and what the check says.
std::string tableOf(const std::vector<nlohmann::ordered_json>& files);

/// The same as a page with pictures before and after.
std::string pageOf(const std::vector<nlohmann::ordered_json>& files);

} // namespace knead::corpus
