#pragma once

#include <string>

namespace knead {

/// The shortest text that is read as the same bits; "\"infinity\"", "\"-infinity\"" and "\"nan\"" in quotes, since JSON has no
/// numbers for them.
std::string exactText(double value);

/// The same of a thousand times the value, with the point moved in the digits: of meters in millimeters, which recipes are
/// written in. JsonNode::thousandth() reads it as the bits of `value`. @pre value is finite
std::string exactThousandfold(double value);

} // namespace knead
