#pragma once

#include "app/sweep/sweep_folder.h"

#include <cstddef>
#include <map>
#include <string>

namespace knead {

/// Why points have no result: a sentence each.
using LostPoints = std::map<std::size_t, std::string>;

/// What a sweep gave, as comma-separated values (RFC 4180): a row per point with its number, what it varied, exit status,
/// message, and all numbers of the report under their dotted names, for example `tools.press.force_n.z`. It depends on the
/// plan and the results only, not on when, where and in which order they came.
std::string tableOf(const SweepFolder& folder, const SweepPlan& plan, const LostPoints& lost);

/// How long each point took, which is another number every time.
std::string timingOf(const SweepFolder& folder, const SweepPlan& plan);

} // namespace knead
