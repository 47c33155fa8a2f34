#pragma once

#include <filesystem>

namespace knead::book {

/// Where inputs, logs and results go; those of the last run stay.
std::filesystem::path& calculixFolder();

} // namespace knead::book
