#include "io/morph/trim_mask.h"

#include <BRepTopAdaptor_FClass2d.hxx>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int piecesPerCurve = 96;
constexpr double widestReach = 1.0 / 12; // of the box
constexpr double cellsPerReach = 2;
constexpr double leastCells = 64; // per direction
constexpr double mostCells = 320;

} // namespace

TrimMask::TrimMask(const TrimmedFace& face, const Vec2& reach)
    : m_low(face.low())
    , m_high(face.high())
    , m_side(static_cast<int>(std::clamp(std::ceil(cellsPerReach * (m_high - m_low).cwiseQuotient(reach).maxCoeff()),
                                         leastCells, mostCells)))
    , m_near(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side), face.edges().empty())
{
    if (!face.edges().empty()) {
        markBorder(face);
        fillInside(face);
    }
    m_inReach = m_near;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double share = std::min(widestReach, reach[axis] / (m_high - m_low)[axis]);
        m_inReach = widened(m_inReach, static_cast<int>(m_side * share), axis);
    }
}

int TrimMask::cellOf(double parameter, Eigen::Index axis) const
{
    const double share = (parameter - m_low[axis]) / (m_high[axis] - m_low[axis]);
    return static_cast<int>(std::clamp(std::floor(m_side * share), 0.0, m_side - 1.0));
}

std::size_t TrimMask::cellAt(const Vec2& parameters) const
{
    return static_cast<std::size_t>(cellOf(parameters[0], 0) * m_side + cellOf(parameters[1], 1));
}

/// Marks all cells that are at most so many from a marked one, along one direction.
TrimMask::Marks TrimMask::widened(const Marks& marks, int by, Eigen::Index axis) const
{
    Marks wide = marks;
    const int step = axis == 0 ? m_side : 1;
    for (int line = 0; line < m_side; ++line)
        for (int i = 0; i < m_side; ++i) {
            const int first = axis == 0 ? line : line * m_side;
            if (!marks[static_cast<std::size_t>(first + i * step)])
                continue;
            for (int k = std::max(0, i - by); k <= std::min(m_side - 1, i + by); ++k)
                wide[static_cast<std::size_t>(first + k * step)] = true;
        }
    return wide;
}

/// All cells that an edge goes through.
void TrimMask::markBorder(const TrimmedFace& face)
{
    const Vec2 cell = (m_high - m_low) / m_side;
    for (const FaceEdge& edge : face.edges())
        for (const Handle(Geom2d_Curve) & curve : edge.shifted()) {
            const auto at = [&](int i) {
                const gp_Pnt2d point = curve->Value(edge.first + (edge.last - edge.first) * i / piecesPerCurve);
                return Vec2(point.X(), point.Y());
            };
            Vec2 begin = at(0);
            for (int i = 1; i <= piecesPerCurve; ++i) {
                const Vec2 end = at(i);
                const double cells = (end - begin).cwiseQuotient(cell).cwiseAbs().maxCoeff();
                const int steps = 1 + static_cast<int>(std::min(2 * cells, 4.0 * m_side));
                for (int step = 0; step <= steps; ++step) {
                    const Vec2 place = begin + (end - begin) * step / steps;
                    m_near[cellAt(place)] = true;
                }
                begin = end;
            }
        }
}

/// Cells that no edge separates are all inside or all outside: one point of each such region tells.
void TrimMask::fillInside(const TrimmedFace& face)
{
    const BRepTopAdaptor_FClass2d classifier(face.face(), 1e-9);
    std::vector<bool> seen = m_near;
    const Vec2 cell = (m_high - m_low) / m_side;
    for (int start = 0; start < m_side * m_side; ++start) {
        if (seen[static_cast<std::size_t>(start)])
            continue;
        std::vector<int> region{start};
        seen[static_cast<std::size_t>(start)] = true;
        for (std::size_t next = 0; next < region.size(); ++next) {
            const int row = region[next] / m_side;
            const int column = region[next] % m_side;
            const auto visit = [&](int r, int c) {
                if (r < 0 || r >= m_side || c < 0 || c >= m_side || seen[static_cast<std::size_t>(r * m_side + c)])
                    return;
                seen[static_cast<std::size_t>(r * m_side + c)] = true;
                region.push_back(r * m_side + c);
            };
            visit(row - 1, column);
            visit(row + 1, column);
            visit(row, column - 1);
            visit(row, column + 1);
        }
        const int middle = region[region.size() / 2];
        const Vec2 at = m_low + cell.cwiseProduct(Vec2(middle / m_side + 0.5, middle % m_side + 0.5));
        if (classifier.Perform(gp_Pnt2d(at[0], at[1]), true) != TopAbs_OUT)
            for (const int place : region)
                m_near[static_cast<std::size_t>(place)] = true;
    }
}

} // namespace knead
