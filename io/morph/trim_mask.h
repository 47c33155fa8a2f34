#pragma once

#include "io/morph/trimmed_face.h"

#include <vector>

namespace knead {

/// Which parts of a face's box of parameters are in the face or close to it: within a sixtieth of the box.
class TrimMask {
public:
    explicit TrimMask(const TrimmedFace& face);

    bool isNear(const Vec2& parameters) const;

private:
    static constexpr int side = 64; ///< cells per direction

    int cellOf(double parameter, Eigen::Index axis) const;
    void markBorder(const TrimmedFace& face);
    void fillInside(const TrimmedFace& face);

    Vec2 m_low;
    Vec2 m_high;
    std::vector<bool> m_near; ///< per cell
};

} // namespace knead
