#include "core/aggregate/skin_areas.h"

#include "core/aggregate/cell_finder.h"
#include "core/aggregate/lattice_rows.h"
#include "core/task/parallel.h"

#include <array>
#include <bit>
#include <utility>

namespace knead {

namespace {

/// Integral of grad N over the material of a cell, N being 1 at one of its corners.
Vec3 gradientIntegral(const CellMoments& cell, const Lattice::Node& corner)
{
    // N = (1/2 + s_u u) (1/2 + s_v v) (1/2 + s_w w), about the middle of the cell.
    const std::array<double, CellMoments::count>& m = cell.value;
    const Vec3 s = 2 * Vec3(corner[0], corner[1], corner[2]) - Vec3::Ones();
    return {s.x() * (0.25 * m[0] + 0.5 * (s.y() * m[2] + s.z() * m[3]) + s.y() * s.z() * m[9]),
            s.y() * (0.25 * m[0] + 0.5 * (s.x() * m[1] + s.z() * m[3]) + s.x() * s.z() * m[8]),
            s.z() * (0.25 * m[0] + 0.5 * (s.x() * m[1] + s.y() * m[2]) + s.x() * s.y() * m[7])};
}

class SkinAreas {
public:
    SkinAreas(const CutCells& cells, const Aggregate& aggregate)
        : m_cells(cells)
        , m_finder(cells)
        , m_nodes(aggregate.lattice.nodes)
        , m_rows(aggregate.lattice)
    {
    }

    Vec3 ofObject(ObjectIndex object) const
    {
        Vec3 sum = Vec3::Zero();
        for (const Lattice::Node& corner : Lattice::cellCorners) {
            const Lattice::Node cell = Lattice::difference(m_nodes[object], corner);
            if (m_finder.isFull(cell))
                sum += gradientIntegral(CellMoments::even(1), corner);
            else
                for (const CutCells::Cut& cut : m_finder.cutInRow(cell[0], cell[1], cell[2], cell[2]))
                    sum += gradientIntegral(cut.moments, corner);
        }
        return sum;
    }

    struct Share {
        ObjectIndex object;
        Vec3 area;
    };

    /// Of corners without an object.
    std::vector<Share> beyondObjects(std::size_t slab) const
    {
        std::vector<Share> shares;
        for (const CutCells::Cut& cut : m_cells.slabs[slab].cut) {
            const Lattice::Node cell{static_cast<std::int32_t>(slab), cut.v, cut.w};
            for (const Lattice::Node& corner : Lattice::cellCorners)
                if (const Lattice::Node node = Lattice::sum(cell, corner); !isObject(m_rows.find(node)))
                    share(node, corner, gradientIntegral(cut.moments, corner), shares);
        }
        return shares;
    }

private:
    bool isObject(ObjectIndex found) const { return found < m_nodes.size(); }

    /// By the shortest steps through its cell that lead to two objects one behind the other, in equal parts.
    void share(const Lattice::Node& node, const Lattice::Node& corner, const Vec3& area,
               std::vector<Share>& shares) const
    {
        for (int axes = 1; axes <= 3; ++axes) {
            std::array<std::pair<ObjectIndex, ObjectIndex>, 3> inwards;
            std::size_t found = 0;
            for (std::size_t step = 1; step < Lattice::cellCorners.size(); ++step) {
                if (std::popcount(step) != axes)
                    continue;
                const Lattice::Node& along = Lattice::cellCorners[step];
                Lattice::Node first = node;
                Lattice::Node second = node;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::int32_t way = along[axis] * (1 - 2 * corner[axis]);
                    first[axis] += way;
                    second[axis] += 2 * way;
                }
                inwards[found] = {m_rows.find(first), m_rows.find(second)};
                if (isObject(inwards[found].first) && isObject(inwards[found].second))
                    ++found;
            }
            if (found == 0)
                continue;
            const Vec3 part = area / static_cast<double>(found);
            for (std::size_t i = 0; i < found; ++i) {
                shares.push_back({inwards[i].first, 2 * part});
                shares.push_back({inwards[i].second, -part});
            }
            return;
        }
    }

    const CutCells& m_cells;
    CellFinder m_finder;
    const std::vector<Lattice::Node>& m_nodes;
    LatticeRows m_rows;
};

} // namespace

std::vector<Vec3> skinAreas(const CutCells& cells, const Aggregate& aggregate,
                            const std::vector<std::uint8_t>& isSurface)
{
    const SkinAreas skin(cells, aggregate);
    std::vector<Vec3> areas(aggregate.size(), Vec3::Zero());
    forEachBlock(areas.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (isSurface[i] != 0)
                areas[i] = skin.ofObject(static_cast<ObjectIndex>(i));
    });
    std::vector<std::vector<SkinAreas::Share>> beyond(cells.slabs.size());
    forEachBlock(beyond.size(), 1, [&](std::size_t slab, std::size_t) { beyond[slab] = skin.beyondObjects(slab); });
    for (const std::vector<SkinAreas::Share>& shares : beyond)
        for (const SkinAreas::Share& share : shares)
            areas[share.object] += share.area;
    return areas;
}

} // namespace knead
