#pragma once

#include <string>

namespace knead {

/// A text as a field of a table, quoted where a comma or quote would end it (RFC 4180).
std::string csvField(const std::string& text);

/// Nine digits; empty for what is not a number.
std::string csvNumber(double value);

} // namespace knead
