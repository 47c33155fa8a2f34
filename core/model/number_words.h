#pragma once

#include <string>

namespace knead {

/// A length [m] with three digits in the unit that a person would take: "0.37 mm", "41.4 m", "0.02 um".
std::string lengthWords(double length);

/// A share of 1 with two digits: "0.13 %".
std::string percentWords(double share);

} // namespace knead
