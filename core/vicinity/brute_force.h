#pragma once

#include "core/vicinity/vicinity.h"

#include <vector>

namespace knead {

/// Every sphere against every other: the oracle of the other back-ends. Theta(n^2).
class BruteForce final : public Vicinity {
public:
    void build(std::span<const VicinitySphere> spheres, double margin) override;
    const std::vector<VicinityPair>& pairs() override;

private:
    std::vector<VicinitySphere> m_spheres;
    double m_margin = 0;
};

} // namespace knead
