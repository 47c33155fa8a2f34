#pragma once

#include "io/morph/trimmed_face.h"

#include <vector>

namespace knead {

/// Which parts of a face's box of parameters are in the face or close to it: within a cell of its border, half as large as the
/// reach and no larger than a sixtieth of the box, or within reach. Cells must not be wider than slots are: what carries the two
/// sides of a slot along may jump in its middle.
class TrimMask {
public:
    /// @param reach along u and v, in parameters; no more than a twelfth of the box is taken
    TrimMask(const TrimmedFace& face, const Vec2& reach);

    bool isNear(const Vec2& parameters) const { return m_near[cellAt(parameters)]; }
    bool isInReach(const Vec2& parameters) const { return m_inReach[cellAt(parameters)]; }

private:
    using Marks = std::vector<bool>;

    int cellOf(double parameter, Eigen::Index axis) const;
    std::size_t cellAt(const Vec2& parameters) const;
    Marks widened(const Marks& marks, int by, Eigen::Index axis) const;
    void markBorder(const TrimmedFace& face);
    void fillInside(const TrimmedFace& face);

    Vec2 m_low;
    Vec2 m_high;
    int m_side;   ///< cells per direction
    Marks m_near; ///< per cell, those of a u beside each other
    Marks m_inReach;
};

} // namespace knead
