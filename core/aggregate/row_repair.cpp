#include "core/aggregate/row_repair.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr double rounding = 1e-6;   // of a cell
constexpr double doubtBelow = 0.25; // of the winding number: between these it says neither in nor out
constexpr double doubtAbove = 0.75;
constexpr double nearRim = 0.25; // cells
constexpr int pointsTried = 32;  // in a cell

bool isPart(double value)
{
    return value >= -rounding && value <= 1 + rounding;
}

bool isEmptyOrFull(double value)
{
    return std::abs(value) <= rounding || std::abs(value - 1) <= rounding;
}

} // namespace

RowRepair::RowRepair(const TriangleMesh& mesh, const HalfEdges& halfEdges, const CellGrid& grid, double orientation)
    : m_mesh(mesh)
    , m_grid(grid)
    , m_orientation(orientation)
    , m_holes(static_cast<std::size_t>(grid.count[0]))
{
    suspectHoles(halfEdges);
}

/// The surface that would close a hole lies in the box around its rim, or close to it.
void RowRepair::suspectHoles(const HalfEdges& halfEdges)
{
    DisjointSets holes(m_mesh.vertices.size());
    std::vector<std::uint32_t> rim;
    for (std::uint32_t h = 0; h < halfEdges.twin.size(); ++h) {
        if (halfEdges.twin[h] != HalfEdges::none)
            continue;
        const TriangleMesh::Triangle& t = m_mesh.triangles[h / 3];
        holes.joinToLowest(t[h % 3], t[(h + 1) % 3]);
        rim.insert(rim.end(), {t[h % 3], t[(h + 1) % 3]});
    }
    std::ranges::sort(rim);
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    std::vector<Box> boxes(m_mesh.vertices.size() * (rim.empty() ? 0 : 1));
    for (const std::uint32_t v : rim)
        boxes[holes.find(v)].extend(m_grid.frame.coordinates(m_mesh.vertices[v]));
    for (const Box& box : boxes) {
        if (box.isEmpty())
            continue;
        const auto cells = [&](int axis) {
            const double last = m_grid.count[static_cast<std::size_t>(axis)] - 1;
            return CellRange{static_cast<std::int32_t>(std::clamp(std::floor(box.min()[axis] - nearRim), 0.0, last)),
                             static_cast<std::int32_t>(std::clamp(std::floor(box.max()[axis] + nearRim), 0.0, last))};
        };
        const CellRange slabs = cells(0);
        for (std::int32_t u = slabs.first; u <= slabs.last; ++u)
            m_holes[static_cast<std::size_t>(u)].push_back({cells(1), cells(2)});
    }
}

CellRange RowRepair::suspectRows(std::int32_t u) const
{
    CellRange rows{m_grid.count[1], -1};
    for (const Hole& hole : m_holes[static_cast<std::size_t>(u)])
        rows = {std::min(rows.first, hole.v.first), std::max(rows.last, hole.v.last)};
    return rows;
}

bool RowRepair::isSuspect(std::int32_t u, std::int32_t v) const
{
    const std::vector<Hole>& holes = m_holes[static_cast<std::size_t>(u)];
    return std::ranges::any_of(holes, [&](const Hole& hole) { return v >= hole.v.first && v <= hole.v.last; });
}

std::vector<std::uint8_t> RowRepair::suspectCells(std::int32_t u, std::int32_t v) const
{
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(m_grid.count[2]), 0);
    for (const Hole& hole : m_holes[static_cast<std::size_t>(u)])
        if (v >= hole.v.first && v <= hole.v.last)
            std::fill(marks.begin() + hole.w.first, marks.begin() + hole.w.last + 1, std::uint8_t{1});
    return marks;
}

bool RowRepair::isSound(const Pieces& pieces) const
{
    double below = 0;
    for (std::size_t w = 0; w < pieces.inCell.size(); ++w) {
        const double fraction = m_orientation * (pieces.inCell[w] + below);
        if (!isPart(fraction) || (pieces.isTouched[w] == 0 && !isEmptyOrFull(fraction)))
            return false;
        below += pieces.area[w];
        if (!isPart(m_orientation * below))
            return false;
    }
    return std::abs(below) <= rounding;
}

const WindingNumber& RowRepair::windingNumber() const
{
    std::call_once(m_once, [this] { m_winding = std::make_unique<const WindingNumber>(m_mesh); });
    return *m_winding;
}

double RowRepair::windingAt(const Vec3& inLattice) const
{
    return m_orientation *
           windingNumber().at(m_grid.frame.origin + m_grid.frame.spacing * (m_grid.frame.axes * inLattice));
}

/// Points of the R3 sequence (Roberts 2018): unlike those of a grid they are cut evenly also by planes along the cell.
RowRepair::Tried RowRepair::tryPoints(const Lattice::Node& cell) const
{
    const Vec3 corner(cell[0], cell[1], cell[2]);
    const Vec3 step(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    Vec3 place = Vec3::Constant(0.5);
    Tried tried;
    for (int i = 0; i < pointsTried; ++i) {
        place += step;
        place -= place.array().floor().matrix();
        const double winding = windingAt(corner + place);
        tried.material += winding >= 0.5 ? 1.0 / pointsTried : 0;
        tried.doubtful += winding > doubtBelow && winding < doubtAbove ? 1.0 / pointsTried : 0;
    }
    return tried;
}

/// Of a stretch of cells with surface, between cells without.
/// @param level how often the surface winds around cells without surface; not a number where that is in doubt
/// @returns the cells that are left
std::vector<std::size_t> RowRepair::takeExactly(const Pieces& pieces, std::size_t begin, std::size_t end,
                                                const std::vector<std::uint8_t>& isSuspect,
                                                const std::vector<double>& level, std::vector<double>& fraction) const
{
    const double before = begin > 0 ? level[begin - 1] : 0;
    const double after = end < level.size() ? level[end] : 0;
    const auto take = [&](std::size_t w, double below) {
        const double part = m_orientation * pieces.inCell[w] + below;
        const bool fits = isPart(part) && isPart(below) && isPart(below + m_orientation * pieces.area[w]);
        if (fits)
            fraction[w] = std::clamp(part, 0.0, 1.0);
        return fits;
    };
    double sum = before - after;
    for (std::size_t w = begin; w < end; ++w)
        sum += m_orientation * pieces.area[w];
    const bool isClosed = std::abs(sum) <= rounding; // then holes that may be there are none
    std::size_t first = begin;
    double below = before;
    for (; isEmptyOrFull(before) && first < end && (isClosed || isSuspect[first] == 0) && take(first, below); ++first)
        below += m_orientation * pieces.area[first];
    std::size_t last = end; // one past the last that is left
    double above = after;
    for (; isEmptyOrFull(after) && last > first && isSuspect[last - 1] == 0; --last) {
        above -= m_orientation * pieces.area[last - 1];
        if (!take(last - 1, above))
            break;
    }
    std::vector<std::size_t> left(last - first);
    std::iota(left.begin(), left.end(), first);
    return left;
}

RowRepair::Outcome RowRepair::decide(std::int32_t u, std::int32_t v, const Pieces& pieces) const
{
    const std::size_t count = pieces.inCell.size();
    Outcome outcome;
    outcome.fraction.assign(count, 0);
    const auto decideByPoints = [&](std::size_t w) {
        const Tried tried = tryPoints({u, v, static_cast<std::int32_t>(w)});
        outcome.fraction[w] = tried.material;
        outcome.doubtful += tried.doubtful;
        ++outcome.decided;
    };
    std::vector<double> level(count, std::numeric_limits<double>::quiet_NaN());
    double below = 0;
    for (std::size_t w = 0; w < count; ++w) {
        const double told = m_orientation * below;
        below += pieces.area[w];
        if (pieces.isTouched[w] != 0)
            continue;
        const double winding = windingAt(Vec3(u + 0.5, v + 0.5, static_cast<double>(w) + 0.5));
        if (winding > doubtBelow && winding < doubtAbove) {
            decideByPoints(w);
            continue;
        }
        outcome.fraction[w] = winding >= 0.5 ? 1 : 0;
        if (std::abs(winding - std::round(winding)) <= doubtBelow)
            level[w] = std::round(winding);
        outcome.decided += std::abs(told - outcome.fraction[w]) > rounding ? 1 : 0;
    }
    const std::vector<std::uint8_t> isSuspect = suspectCells(u, v);
    for (std::size_t begin = 0; begin < count;) {
        std::size_t end = begin;
        while (end < count && pieces.isTouched[end] != 0)
            ++end;
        for (const std::size_t w : takeExactly(pieces, begin, end, isSuspect, level, outcome.fraction))
            decideByPoints(w);
        begin = std::max(end, begin + 1);
    }
    return outcome;
}

} // namespace knead
