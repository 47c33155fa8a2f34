#pragma once

#include "io/morph/trimmed_face.h"

#include <vector>

namespace knead {

/// Which parts of a face's box of parameters are in the face or close to it: within a sixtieth of the box, or within reach.
class TrimMask {
public:
    /// @param reach along u and v, in parameters; no more than a twelfth of the box is taken
    TrimMask(const TrimmedFace& face, const Vec2& reach);

    bool isNear(const Vec2& parameters) const { return m_near[cellAt(parameters)]; }
    bool isInReach(const Vec2& parameters) const { return m_inReach[cellAt(parameters)]; }

private:
    using Marks = std::vector<bool>;

    static constexpr int side = 64; ///< cells per direction

    int cellOf(double parameter, Eigen::Index axis) const;
    std::size_t cellAt(const Vec2& parameters) const;
    Marks widened(const Marks& marks, int by, Eigen::Index axis) const;
    void markBorder(const TrimmedFace& face);
    void fillInside(const TrimmedFace& face);

    Vec2 m_low;
    Vec2 m_high;
    Marks m_near; ///< per cell, those of a u beside each other
    Marks m_inReach;
};

} // namespace knead
