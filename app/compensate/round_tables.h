#pragma once

#include "core/session/compensation.h"

#include <string>
#include <vector>

namespace knead {

/// Rounds as comma-separated values: number, factor, largest and mean deviation, and where it is largest, in mm.
std::string tableOf(const TargetPoints& points, const std::vector<CompensationRound>& rounds);

/// The same as lines for a person to read.
std::vector<std::string> linesOf(const TargetPoints& points, const std::vector<CompensationRound>& rounds);

/// Largest and mean deviations of rounds over a logarithmic axis, with the tolerance, as SVG. @pre at least one round
std::string plotOf(const std::vector<CompensationRound>& rounds, double tolerance);

/// Where the target's points are, how the round takes them elsewhere, and how far what came out is from them, as .csv or .vtu.
/// @throws Problem when the disk refuses
void writeDeviations(const std::string& path, const TargetPoints& points, const CompensationRound& round);

} // namespace knead
