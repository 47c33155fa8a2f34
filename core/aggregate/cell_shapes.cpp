#include "core/aggregate/cell_shapes.h"

#include "core/aggregate/lattice_rows.h"
#include "core/task/block_sums.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t cellsPerBlock = 2048;
constexpr std::size_t along[3] = {4, 2, 1}; // what u, v, w add to the number of a corner

CellQuality qualityOf(const std::array<Vec3, 8>& corners, double spacing, double handedness)
{
    CellQuality quality;
    double edge = 0; // the longest ones, squared
    double diagonal = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        std::array<Vec3, 3> edges;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            edges[axis] = (corners[corner | along[axis]] - corners[corner & ~along[axis]]) / spacing;
            edge = std::max(edge, edges[axis].squaredNorm());
        }
        quality.leastCorner = std::min(quality.leastCorner, handedness * edges[0].dot(edges[1].cross(edges[2])));
    }
    for (std::size_t corner = 0; corner < 4; ++corner)
        diagonal = std::max(diagonal, (corners[7 - corner] - corners[corner]).squaredNorm());
    quality.largestStretch = std::max(std::sqrt(edge), std::sqrt(diagonal) / (std::sqrt(3.0) * spacing));
    quality.inverted = quality.leastCorner <= 0 ? 1 : 0;
    return quality;
}

void join(CellQuality& all, const CellQuality& one)
{
    all.leastCorner = std::min(all.leastCorner, one.leastCorner);
    all.largestStretch = std::max(all.largestStretch, one.largestStretch);
    all.inverted += one.inverted;
}

} // namespace

CellShapes::CellShapes(const Aggregate& aggregate)
    : m_spacing(aggregate.lattice.spacing)
    , m_handedness(aggregate.lattice.axes.determinant() < 0 ? -1 : 1)
{
    const Lattice& lattice = aggregate.lattice;
    const LatticeRows rows(lattice);
    const std::size_t none = lattice.size();
    for (const Lattice::Node& low : lattice.nodes) {
        Corners corners{};
        bool isCell = true;
        for (std::size_t corner = 0; isCell && corner < 8; ++corner) {
            corners[corner] = rows.find(Lattice::sum(low, Lattice::cellCorners[corner]));
            isCell = corners[corner] < none;
        }
        for (std::size_t axis = 0; isCell && axis < 3; ++axis) // the first three directions
            for (std::size_t corner = 0; isCell && corner < 8; ++corner)
                isCell = (corner & along[axis]) != 0 || aggregate.weight[axis][corners[corner]] > 0;
        if (isCell)
            m_cells.push_back(corners);
    }
}

CellQuality CellShapes::quality(const std::function<Vec3(ObjectIndex)>& place) const
{
    const auto blocks =
        ofEachBlock<CellQuality>(m_cells.size(), cellsPerBlock, [&](std::size_t begin, std::size_t end) {
            CellQuality worst;
            std::array<Vec3, 8> places;
            for (std::size_t cell = begin; cell < end; ++cell) {
                for (std::size_t corner = 0; corner < 8; ++corner)
                    places[corner] = place(m_cells[cell][corner]);
                join(worst, qualityOf(places, m_spacing, m_handedness));
            }
            return worst;
        });
    CellQuality all;
    for (const CellQuality& block : blocks)
        join(all, block);
    return all;
}

} // namespace knead
