#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

/// A place of a recipe that takes one value after another in a sweep.
struct Variation {
    std::string path;                ///< as RecipeOverride::path
    std::vector<std::string> values; ///< as RecipeOverride::value; at least one
};

/// How several variations make points.
enum class Combination {
    grid,     ///< every value of one with every value of the others; the last one changes fastest
    together, ///< the first values of all, the second values of all ...
};

/// What the points of a sweep set, a value per variation.
using SweepPoints = std::vector<std::vector<std::string>>;

constexpr std::size_t mostPoints = 100'000; ///< more is a mistyped range

/// Reads "PATH=A:B:lin:N" or "PATH=A:B:log:N", N values from A to B with equal steps or equal ratios, or a list
/// "PATH=V,W,...". Commas within JSON do not part values.
/// @throws std::runtime_error, in a sentence
Variation parseVariation(const std::string& text);

/// @throws std::runtime_error, in a sentence, for two variations of one path, for too many points, and for variations of
///         different length that are to go together
SweepPoints combine(const std::vector<Variation>& variations, Combination combination);

} // namespace knead
