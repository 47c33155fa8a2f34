#include "core/skin/regrown.h"

#include "core/aggregate/pieces.h"
#include "core/skin/former_shape.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <map>
#include <utility>

namespace knead {

namespace {

// Neighbors of before that were parted are together again within so many spacings.
constexpr double farthestMeeting = 2.5;
// Of what was parted along the axes of the lattice so much has to meet, and so many pairs for each connection have to have grown together.
constexpr double leastMeeting = 2.0 / 3;
constexpr double leastPairs = 0.2;

/// Where two pieces were one.
struct Seam {
    std::size_t connections = 0; ///< that were parted
    std::size_t straight = 0;    ///< of them, along an axis of the lattice
    std::size_t meeting = 0;     ///< of these, whose ends are together now
    std::size_t pairs = 0;       ///< that have grown together

    bool isWhole() const
    {
        return static_cast<double>(meeting) > leastMeeting * static_cast<double>(straight) &&
               static_cast<double>(pairs) > leastPairs * static_cast<double>(connections);
    }
};

class Seams {
public:
    Seams(const Aggregate& present, std::span<const Vec3> displacements, std::span<const BrokenConnection> broken,
          std::span<const GrownTogether> pairs)
        : m_spacing(present.lattice.spacing)
        , m_pieces(findPieces(present, broken))
    {
        const auto now = [&](ObjectIndex object) -> Vec3 {
            return present.lattice.position(object) + displacements[object];
        };
        for (const BrokenConnection& one : broken) {
            const ObjectIndex upper = upperEnd(present.lattice, one);
            add(one, one.lower, upper, now(one.lower), now(upper));
        }
        if (present.former && present.former->isInPieces())
            addFormer(present, displacements);
        for (const auto& [first, second] : pairs)
            ++of(first, second).pairs;
    }

    bool isOne(const GrownTogether& pair)
    {
        return m_pieces.ofObject[pair.first] == m_pieces.ofObject[pair.second] || of(pair.first, pair.second).isWhole();
    }

private:
    Seam& of(ObjectIndex one, ObjectIndex other)
    {
        return m_seams[std::minmax({m_pieces.ofObject[one], m_pieces.ofObject[other]})];
    }

    /// @param lower, upper objects of the present filling, and where the ends of the connection are now
    void add(const ConnectionId& connection, ObjectIndex lower, ObjectIndex upper, const Vec3& lowerNow,
             const Vec3& upperNow)
    {
        constexpr std::uint32_t axes = 3; // the first directions
        Seam& seam = of(lower, upper);
        ++seam.connections;
        if (connection.direction >= axes)
            return;
        ++seam.straight;
        if ((upperNow - lowerNow).norm() < farthestMeeting * m_spacing)
            ++seam.meeting;
    }

    /// What parted the pieces that the present filling was made of.
    void addFormer(const Aggregate& present, std::span<const Vec3> displacements)
    {
        const Aggregate& first = *present.former->carriers();
        const std::vector<Vec3> then = firstFillingWhenFilled(present);
        const std::vector<ObjectIndex> nearest = nearestPoints(nodesOf(present), VectorArray(then), m_spacing);
        for (const BrokenConnection& one : present.former->broken()) {
            const ObjectIndex upper = upperEnd(first.lattice, one);
            add(one, nearest[one.lower], nearest[upper], then[one.lower] + displacements[nearest[one.lower]],
                then[upper] + displacements[nearest[upper]]);
        }
    }

    double m_spacing;
    Pieces m_pieces;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Seam> m_seams;
};

} // namespace

std::vector<GrownTogether> regrown(const Aggregate& present, std::span<const Vec3> displacements,
                                   std::span<const BrokenConnection> broken, std::span<const GrownTogether> pairs)
{
    if (pairs.empty())
        return {};
    Seams seams(present, displacements, broken, pairs);
    std::vector<GrownTogether> one;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(one),
                 [&](const GrownTogether& pair) { return seams.isOne(pair); });
    return one;
}

} // namespace knead
