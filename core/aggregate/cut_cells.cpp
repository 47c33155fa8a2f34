#include "core/aggregate/cut_cells.h"

#include "core/aggregate/cell_polygon.h"
#include "core/aggregate/cell_scraps.h"
#include "core/aggregate/row_repair.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr double sliver = 1e-9;   // of a cell: what rounding may add or take
constexpr double fullCell = 0.95; // thinner than so much of a cell, half of it might hold too little to be kept

/// Numbers of things sorted into the cells of an axis; a thing may be in several.
class Bins {
public:
    Bins(const std::vector<CellRange>& ranges, std::int32_t first, std::int32_t last)
        : m_firstCell(first)
        , m_begin(static_cast<std::size_t>(last - first) + 2, 0)
    {
        for (const CellRange& range : ranges)
            for (std::int32_t cell = range.first; cell <= range.last; ++cell)
                ++m_begin[place(cell) + 1];
        std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
        m_things.resize(m_begin.back());
        std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
        for (std::uint32_t i = 0; i < ranges.size(); ++i)
            for (std::int32_t cell = ranges[i].first; cell <= ranges[i].last; ++cell)
                m_things[next[place(cell)]++] = i;
    }

    std::span<const std::uint32_t> operator[](std::int32_t cell) const
    {
        return {m_things.data() + m_begin[place(cell)], m_begin[place(cell) + 1] - m_begin[place(cell)]};
    }

private:
    std::size_t place(std::int32_t cell) const { return static_cast<std::size_t>(cell - m_firstCell); }

    std::int32_t m_firstCell;
    std::vector<std::size_t> m_begin;
    std::vector<std::uint32_t> m_things;
};

/// Polygons of one slab, one after the other.
class PolygonList {
public:
    void add(PolygonView polygon)
    {
        m_corners.insert(m_corners.end(), polygon.begin(), polygon.end());
        m_begin.push_back(m_corners.size());
    }

    std::size_t size() const { return m_begin.size() - 1; }
    PolygonView operator[](std::size_t i) const { return {m_corners.data() + m_begin[i], m_begin[i + 1] - m_begin[i]}; }

private:
    std::vector<Vec3> m_corners;
    std::vector<std::size_t> m_begin{0};
};

/// What the pieces of the surface add to the cells of one row.
class RowIntegral {
public:
    /// @param repair as in cutCells()
    RowIntegral(std::int32_t cells, const RowRepair* repair)
        : m_moments(static_cast<std::size_t>(cells))
        , m_inCell(static_cast<std::size_t>(cells), 0)
        , m_area(static_cast<std::size_t>(cells), 0)
        , m_isTouched(repair == nullptr ? 0 : static_cast<std::size_t>(cells), 0)
        , m_repair(repair)
        , m_cells(cells)
    {
        forget();
    }

    /// Adds a polygon that lies within the row. Walls along w have no projection and need not be cut at all.
    /// @param row (u, v) of the row
    void add(PolygonView polygon, const Vec3& row)
    {
        CellRange range = cellRange(polygon, 2, m_cells);
        if (m_repair != nullptr)
            std::fill(m_isTouched.begin() + range.first, m_isTouched.begin() + range.last + 1, std::uint8_t{1});
        if (range.first < range.last && isWall(polygon))
            return;
        m_touched = {std::min(m_touched.first, range.first), std::max(m_touched.last, range.last)};
        CellPolygon rest;
        for (; range.first < range.last; ++range.first) {
            addPiece(halfBelow(polygon, 2, range.first + 1).span(), row, range.first);
            rest = halfAbove(polygon, 2, range.first + 1);
            polygon = rest.span();
        }
        addPiece(polygon, row, range.last);
    }

    /// Appends the kept cells of row (u, v) to the slab and clears the row.
    void finish(std::int32_t u, std::int32_t v, CutCells::Slab& slab, double orientation, double minimumFraction)
    {
        if (m_repair != nullptr && needsRepair(u, v))
            takeDecided(m_repair->decide(u, v, pieces()), v, slab, minimumFraction);
        else
            takeExact(v, slab, orientation, minimumFraction);
        if (m_repair != nullptr)
            std::ranges::fill(m_isTouched, std::uint8_t{0});
        forget();
    }

private:
    RowRepair::Pieces pieces() const { return {m_inCell, m_area, m_isTouched}; }

    bool needsRepair(std::int32_t u, std::int32_t v) const
    {
        return m_repair->isSuspect(u, v) || !m_repair->isSound(pieces());
    }

    void takeExact(std::int32_t v, CutCells::Slab& slab, double orientation, double minimumFraction)
    {
        double below = 0;
        ColumnMoments momentsBelow;
        for (std::int32_t w = m_touched.first; w <= m_touched.last; ++w) {
            const auto cell = static_cast<std::size_t>(w);
            const double fraction = orientation * (m_inCell[cell] + below);
            below += m_area[cell];
            m_inCell[cell] = m_area[cell] = 0;
            if (isCut(fraction))
                slab.cut.push_back({v, w, m_moments[cell].inCell(momentsBelow, orientation)});
            m_moments[cell].addTo(momentsBelow);
            m_moments[cell] = {};
            keep(w, fraction, slab, minimumFraction);
        }
    }

    void takeDecided(const RowRepair::Outcome& outcome, std::int32_t v, CutCells::Slab& slab, double minimumFraction)
    {
        for (std::size_t w = 0; w < outcome.fraction.size(); ++w) {
            const double fraction = outcome.fraction[w];
            if (isCut(fraction))
                slab.cut.push_back({v, static_cast<std::int32_t>(w), CellMoments::even(fraction)});
            keep(static_cast<std::int32_t>(w), fraction, slab, minimumFraction);
        }
        slab.decided += outcome.decided;
        slab.doubtful += outcome.doubtful;
        std::ranges::fill(m_inCell, 0.0);
        std::ranges::fill(m_area, 0.0);
        std::ranges::fill(m_moments, ColumnMoments{});
    }

    static bool isCut(double fraction) { return fraction > sliver && fraction < 1 - sliver; }

    static void keep(std::int32_t w, double fraction, CutCells::Slab& slab, double minimumFraction)
    {
        slab.volume += fraction;
        if (fraction < std::max(minimumFraction - sliver, sliver))
            return;
        slab.w.push_back(w);
        slab.fraction.push_back(std::min(fraction, 1.0));
    }

    static bool isWall(PolygonView polygon)
    {
        const PolygonProjection projection = project(polygon, 0);
        return projection.area == 0 && projection.areaTimesHeight == 0;
    }

    /// Material lies above a piece that faces -w, so its (negative) area enters with a minus.
    void addPiece(PolygonView piece, const Vec3& row, std::int32_t cell)
    {
        const PolygonProjection projection = project(piece, cell + 1.0);
        m_inCell[static_cast<std::size_t>(cell)] += projection.areaTimesHeight;
        m_area[static_cast<std::size_t>(cell)] -= projection.area;
        m_moments[static_cast<std::size_t>(cell)].add(piece, row + cell * Vec3::UnitZ());
    }

    void forget() { m_touched = {std::numeric_limits<std::int32_t>::max(), -1}; }

    std::vector<ColumnMoments> m_moments;
    std::vector<double> m_inCell;          // volume between pieces and the top of their cell
    std::vector<double> m_area;            // projected area of the pieces, for the cells above
    std::vector<std::uint8_t> m_isTouched; // by a piece; only for repairs
    const RowRepair* m_repair;
    std::int32_t m_cells;
    CellRange m_touched;
};

/// One triangle mesh in lattice coordinates, its triangles sorted into slabs.
class Cutter {
public:
    Cutter(const TriangleMesh& mesh, const CellGrid& grid, double orientation, double minimumFraction,
           const RowRepair* repair)
        : m_mesh(mesh)
        , m_count(grid.count)
        , m_orientation(orientation)
        , m_minimumFraction(minimumFraction)
        , m_repair(repair)
        , m_vertices(mesh.vertices.size())
        , m_ranges(mesh.triangles.size())
    {
        forEachBlock(m_vertices.size(), 8192, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                m_vertices[v] = grid.frame.coordinates(mesh.vertices[v]);
        });
        forEachBlock(m_ranges.size(), 8192, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t)
                m_ranges[t] = cellRange(cornersOf(m_vertices, mesh.triangles[t]), 0, m_count[0]);
        });
    }

    CutCells cut(TaskControl& control) const
    {
        CutCells cells;
        cells.slabs.resize(static_cast<std::size_t>(m_count[0]));
        const Bins slabs(m_ranges, 0, m_count[0] - 1);
        forEachBlock(cells.slabs.size(), 1, control, "cutting cells", [&](std::size_t u, std::size_t) {
            const auto slab = static_cast<std::int32_t>(u);
            cells.slabs[u] = cutRows(slab, polygonsOfSlab(slab, slabs[slab]));
        });
        return cells;
    }

private:
    PolygonList polygonsOfSlab(std::int32_t u, std::span<const std::uint32_t> triangles) const
    {
        PolygonList polygons;
        for (const std::uint32_t t : triangles)
            polygons.add(clipToCell(cornersOf(m_vertices, m_mesh.triangles[t]), 0, u, m_ranges[t]).span());
        return polygons;
    }

    CutCells::Slab cutRows(std::int32_t u, const PolygonList& polygons) const
    {
        CutCells::Slab slab;
        std::vector<CellRange> ranges(polygons.size());
        CellRange rows{m_count[1], -1};
        if (m_repair != nullptr)
            if (const CellRange suspect = m_repair->suspectRows(u); suspect.first <= suspect.last)
                rows = suspect;
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            ranges[i] = cellRange(polygons[i], 1, m_count[1]);
            rows = {std::min(rows.first, ranges[i].first), std::max(rows.last, ranges[i].last)};
        }
        if (rows.last < rows.first)
            return slab;
        const Bins bins(ranges, rows.first, rows.last);
        RowIntegral row(m_count[2], m_repair);
        slab.firstRow = rows.first;
        for (std::int32_t v = rows.first; v <= rows.last; ++v) {
            for (const std::uint32_t i : bins[v])
                row.add(clipToCell(polygons[i], 1, v, ranges[i]).span(), Vec3(u, v, 0));
            row.finish(u, v, slab, m_orientation, m_minimumFraction);
            slab.rowBegin.push_back(slab.w.size());
        }
        return slab;
    }

    const TriangleMesh& m_mesh;
    Lattice::Node m_count;
    double m_orientation;
    double m_minimumFraction;
    const RowRepair* m_repair;
    std::vector<Vec3> m_vertices;    // in lattice coordinates
    std::vector<CellRange> m_ranges; // slabs of each triangle
};

template <typename OfSlab>
auto sumOver(const std::vector<CutCells::Slab>& slabs, OfSlab ofSlab)
{
    decltype(ofSlab(slabs.front())) sum = 0;
    for (const CutCells::Slab& slab : slabs)
        sum += ofSlab(slab);
    return sum;
}

} // namespace

CellGrid gridAround(const Box& box, double spacing, std::optional<Eigen::Index> rowAxis)
{
    CellGrid grid;
    Eigen::Index longest = 0;
    const Vec3 sides = box.sizes();
    sides.maxCoeff(&longest);
    longest = rowAxis.value_or(longest);
    grid.frame.axes.setZero();
    grid.frame.spacing = spacing;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::Index world = (longest + 1 + axis) % 3;
        grid.frame.axes(world, axis) = 1;
        auto& count = grid.count[static_cast<std::size_t>(axis)];
        count = std::max(1, static_cast<std::int32_t>(std::ceil(sides[world] / spacing - sliver)));
        if (count == 1 && sides[world] > fullCell * spacing)
            count = 2;
    }
    const Vec3 cells(grid.count[0], grid.count[1], grid.count[2]);
    grid.frame.origin = box.center() - 0.5 * spacing * (grid.frame.axes * cells);
    return grid;
}

CutCells::Row CutCells::Slab::row(std::int32_t v) const
{
    if (v < firstRow || v >= rowsEnd())
        return {};
    const auto i = static_cast<std::size_t>(v - firstRow);
    const std::size_t count = rowBegin[i + 1] - rowBegin[i];
    return {{w.data() + rowBegin[i], count}, {fraction.data() + rowBegin[i], count}};
}

double CutCells::volume() const
{
    return sumOver(slabs, [](const Slab& slab) { return slab.volume; });
}

double CutCells::keptVolume() const
{
    return sumOver(slabs,
                   [](const Slab& slab) { return std::accumulate(slab.fraction.begin(), slab.fraction.end(), 0.0); });
}

std::size_t CutCells::size() const
{
    return sumOver(slabs, [](const Slab& slab) { return slab.w.size(); });
}

std::size_t CutCells::decided() const
{
    return sumOver(slabs, [](const Slab& slab) { return slab.decided; });
}

double CutCells::doubtful() const
{
    return sumOver(slabs, [](const Slab& slab) { return slab.doubtful; });
}

CutCells cutCells(const TriangleMesh& mesh, const CellGrid& grid, double orientation, double minimumFraction,
                  TaskControl& control, const RowRepair* repair)
{
    return withoutScraps(Cutter(mesh, grid, orientation, leastFraction(minimumFraction), repair).cut(control),
                         minimumFraction);
}

} // namespace knead
