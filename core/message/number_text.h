#pragma once

#include <string>

namespace knead {

/// As sentences show a number: "0.00123", "1e+12".
/// @param digits at most
std::string inDigits(double number, int digits = 6);

} // namespace knead
