#pragma once

#include "core/vicinity/vicinity.h"

namespace knead {

/// Every sphere against every other: the oracle of the other back-ends. Theta(n^2).
class BruteForce final : public Vicinity {
public:
    const PairBlocks& findPairs(std::span<const VicinitySphere> spheres, double margin) override;
};

} // namespace knead
