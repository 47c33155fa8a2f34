#include "core/aggregate/thin_blocks.h"

#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

bool goesAlong(std::size_t direction, std::size_t axis)
{
    return Lattice::directions[direction][axis] != 0;
}

/// 0 in plates and lumps, 1 along a thin bar.
double alongBar(std::size_t direction, const LocalShape& shape)
{
    const Lattice::Node& ahead = Lattice::directions[direction];
    const double part = std::clamp((shape.along(Vec3(ahead[0], ahead[1], ahead[2])) - 0.5) / 0.48, 0.0, 1.0);
    return part * part;
}

/// Second moment [a^2] along an axis that the material gets beside its own, per family.
///
/// A bar of few cells is bent too softly by what lies between the surfaces of its lattice, and twisted too stiffly, as few
/// objects across cannot warp: with two across not at all, which takes a sixth of a square's stiffness. What runs along the bar bears
/// bending and no torsion, and gets more; what leads from one of its sides to the other bears torsion and gets less, the thinner it is.
/// The numbers serve square bars and plates of one to six cells at twelve tilts best.
double stiffening(std::size_t direction, std::size_t axis, const LocalShape& shape)
{
    const double along = 0.11 * alongBar(direction, shape);
    if (direction < 3)
        return along - 0.032;
    return along + (goesAlong(direction, axis) ? 0.04 : -0.016 * std::max(0.0, 3.8 - shape.thickness()));
}

/// The same beside sides of full cells that are skin. Walls bend alike with 0.06 to 0.09 along axes; with less, rubber bends by more than
/// 6 % too far.
constexpr double stiffeningOfBareSides(std::size_t direction)
{
    return direction < 3 ? 0.082 : -0.0145;
}

/// Second moment along `axis` of a unit of weight that joinCells() gives the connections of a cell.
double evenlyJoined(std::size_t direction, std::size_t axis)
{
    return goesAlong(direction, axis) ? 0 : 0.25;
}

/// Which cells of an axis go together: pairs from both ends, so that a symmetric body is fitted symmetrically. Where their
/// number is odd, the one in the middle and up to one beside it on each side are alone.
class CellPairs {
public:
    /// @param cells from first to first + cells - 1
    CellPairs(std::int32_t first, std::int32_t cells)
        : m_first(first)
        , m_cells(cells)
    {
    }

    /// Ascending with the cells.
    std::int32_t numberOf(std::int32_t cell) const
    {
        const std::int32_t at = cell - m_first;
        const std::int32_t middle = m_cells / 2;
        if (m_cells % 2 == 0 || at < middle)
            return at / 2;
        const std::int32_t below = (middle + 1) / 2;
        return at == middle ? below : 2 * below - (m_cells - 1 - at) / 2;
    }

    /// The first one of its pair.
    std::int32_t firstOf(std::int32_t cell) const
    {
        return cell > m_first && numberOf(cell - 1) == numberOf(cell) ? cell - 1 : cell;
    }

    std::int32_t count() const { return m_cells <= 0 ? 0 : numberOf(m_first + m_cells - 1) + 1; }

private:
    std::int32_t m_first;
    std::int32_t m_cells;
};

using Pairing = std::array<CellPairs, 3>;

ThinBlock::Place placeOf(const Lattice::Node& cell, const Pairing& pairing)
{
    return {pairing[0].numberOf(cell[0]), pairing[1].numberOf(cell[1]), pairing[2].numberOf(cell[2])};
}

/// The first node inside the block of a cell.
Lattice::Node nodeOf(const Lattice::Node& cell, const Pairing& pairing)
{
    return {pairing[0].firstOf(cell[0]) + 1, pairing[1].firstOf(cell[1]) + 1, pairing[2].firstOf(cell[2]) + 1};
}

/// Pairs of the cells that there are.
Pairing pairsOf(const std::vector<std::vector<ThinCell>>& slabs)
{
    Eigen::AlignedBox3i bounds;
    for (const std::vector<ThinCell>& slab : slabs)
        for (const ThinCell& cell : slab)
            bounds.extend(Eigen::Map<const Eigen::Vector3i>(cell.cell.data()));
    const auto along = [&](Eigen::Index axis) {
        return CellPairs(bounds.min()[axis], bounds.max()[axis] - bounds.min()[axis] + 1);
    };
    return {along(0), along(1), along(2)};
}

void addTo(QuadraticMoments& sum, const QuadraticMoments& one, double factor)
{
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] += factor * one[k];
}

/// @param outward of full cells, as side seen from the cell
void addSide(QuadraticMoments& sum, std::size_t axis, int side, int outward, const Vec3& step, double share)
{
    QuadraticMoments slope{};
    slope[1 + axis] = -0.5 * outward;
    slope[4 + axis] = -0.5 * outward * side; // 2 x at x = side / 2
    addTo(sum, moved(slope, step), share);
}

/// Of 1, u, v, w, uu, vv, ww, uv, uw, vw: whether one is a product of coordinates across an axis.
constexpr bool isSecondAcross(std::size_t term, std::size_t axis)
{
    return term >= 4 && (term < 7 ? term - 4 != axis : term == 9 - axis);
}

std::size_t diagonalNumber(std::size_t direction)
{
    return (direction - faceDiagonals[0]) / 2;
}

} // namespace

void ThinBlock::add(const ThinCell& cell)
{
    Vec3 step(cell.cell[0] - m_node[0], cell.cell[1] - m_node[1], cell.cell[2] - m_node[2]);
    step += Vec3::Constant(0.5);
    // A full cell gives its part of the sides that are skin, a cut one that of the full cells beside it.
    const bool isFull = cell.cut == nullptr;
    cell.forEachSide([&](std::size_t axis, int side) {
        addSide((isFull ? m_bareSides : m_sides)[axis], axis, side, isFull ? side : -side, step, cell.share);
    });
    if (cell.cut != nullptr)
        addMaterial(cell, step);
    m_centers += step;
    ++m_cells;
}

QuadraticMoments ThinBlock::moments(std::size_t direction) const
{
    QuadraticMoments sum = m_material;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double even = evenlyJoined(direction, axis);
        const double excess = even - 1.0 / 12 - stiffening(direction, axis, m_shape);
        sum[4 + axis] += stiffening(direction, axis, m_shape) * m_volume - even * m_keptVolume;
        addTo(sum, m_sides[axis], excess);
        if (!goesAlong(direction, axis))
            addTo(sum, m_bareSides[axis], even - 1.0 / 12 - stiffeningOfBareSides(direction));
    }
    sum = moved(sum, -center());
    if (direction < faceDiagonals.size())
        addTo(sum, meanResidual(direction), -1);
    return sum;
}

void ThinBlock::setResidual(std::size_t direction, const QuadraticMoments& residual)
{
    QuadraticMoments leftOut{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (goesAlong(direction, axis))
            addTo(leftOut, m_bareSides[axis], 1.0 / 12);
    QuadraticMoments& sum = m_residual[diagonalNumber(direction)];
    sum = moved(leftOut, -center());
    addTo(sum, residual, 1);
}

/// Over the diagonals that go along an axis, all but those of the face across it: second moments across it, which bend. Connections
/// bear none by where they are along themselves.
QuadraticMoments ThinBlock::meanResidual(std::size_t axis) const
{
    QuadraticMoments sum{};
    for (std::size_t number = 0; number < faceDiagonals.size(); ++number)
        if (number != faceDiagonals.size() - 1 - axis)
            addTo(sum, m_residual[number], 0.5);
    for (std::size_t k = 0; k < sum.size(); ++k)
        if (!isSecondAcross(k, axis))
            sum[k] = 0;
    return sum;
}

void ThinBlock::addMaterial(const ThinCell& cell, const Vec3& step)
{
    const QuadraticMoments& moments = cell.cut->moments.value;
    m_volume += cell.share * moments[0];
    m_centers += Vec3(moments[1], moments[2], moments[3]) / moments[0];
    QuadraticMoments lacking = moments;
    if (cell.isKept) {
        m_keptVolume += cell.share * moments[0];
        // What was given lies at the cell's middle, but for its second moments there.
        lacking[0] = 0;
    }
    addTo(m_material, moved(lacking, step), cell.share);
}

std::vector<std::vector<ThinBlock>> thinBlocksOf(const std::vector<std::vector<ThinCell>>& slabs)
{
    const Pairing pairing = pairsOf(slabs);
    std::vector<std::vector<ThinCell>> together(static_cast<std::size_t>(pairing[0].count()));
    for (const std::vector<ThinCell>& slab : slabs)
        if (!slab.empty()) {
            auto& cells = together[static_cast<std::size_t>(pairing[0].numberOf(slab.front().cell[0]))];
            cells.insert(cells.end(), slab.begin(), slab.end());
        }
    std::vector<std::vector<ThinBlock>> all(together.size());
    forEachBlock(all.size(), 1, [&](std::size_t i, std::size_t) {
        std::vector<ThinCell>& cells = together[i];
        const auto isBefore = [&](const ThinCell& one, const ThinCell& other) {
            return std::pair(placeOf(one.cell, pairing), one.cell) <
                   std::pair(placeOf(other.cell, pairing), other.cell);
        };
        std::ranges::stable_sort(cells, isBefore);
        for (const ThinCell& cell : cells) {
            if (all[i].empty() || all[i].back().place() != placeOf(cell.cell, pairing))
                all[i].emplace_back(placeOf(cell.cell, pairing), nodeOf(cell.cell, pairing));
            all[i].back().add(cell);
        }
    });
    return all;
}

} // namespace knead
