#include "core/aggregate/local_shape.h"

#include "core/aggregate/moment_spread.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double whole = 3;       // [cells]: a cell counts
constexpr double none = 4;        // and no more; 3.5 on the mean
constexpr std::int32_t reach = 4; // cells to each side whose middles may be within

/// How much of a cell counts.
double partAt(double squaredDistance)
{
    if (squaredDistance <= whole * whole)
        return 1;
    return std::max(0.0, (none - std::sqrt(squaredDistance)) / (none - whole));
}

/// The middle of what there is and the second moments about it, of cells at steps from a place.
class Sums {
public:
    void addFull(const Vec3& step)
    {
        const double part = partAt(step.squaredNorm());
        m_volume += part;
        m_first += part * step;
        m_second += part * step * step.transpose();
        m_second.diagonal().array() += part / 12;
    }

    void addCut(const CellMoments& cell, const Vec3& step)
    {
        const double part = partAt(step.squaredNorm());
        if (part == 0)
            return;
        const QuadraticMoments m = moved(cell.value, step);
        m_volume += part * m[0];
        m_first += part * Vec3(m[1], m[2], m[3]);
        Mat3 second;
        second << m[4], m[7], m[8], m[7], m[5], m[9], m[8], m[9], m[6];
        m_second += part * second;
    }

    LocalShape shape() const
    {
        if (!(m_volume > 0))
            return {}; // rows that were repaired may hold next to nothing
        const Vec3 middle = m_first / m_volume;
        const Mat3 spread = m_second / m_volume - middle * middle.transpose();
        return spread.trace() > 0 ? LocalShape(spread) : LocalShape();
    }

private:
    double m_volume = 0;
    Vec3 m_first = Vec3::Zero();
    Mat3 m_second = Mat3::Zero();
};

} // namespace

LocalShape::LocalShape(const Mat3& spread)
    : m_spread(spread)
{
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(spread, Eigen::EigenvaluesOnly);
    m_thickness = std::sqrt(12 * std::max(solver.eigenvalues()[0], 0.0));
}

LocalShape localShapeAt(const CellFinder& finder, const Vec3& place)
{
    Sums sums;
    const auto lowest = [&](Eigen::Index axis) { return static_cast<std::int32_t>(std::floor(place[axis])) - reach; };
    const std::int32_t first = lowest(2);
    const std::int32_t last = first + 2 * reach;
    for (std::int32_t u = lowest(0); u <= lowest(0) + 2 * reach; ++u)
        for (std::int32_t v = lowest(1); v <= lowest(1) + 2 * reach; ++v) {
            const double du = u + 0.5 - place[0];
            const double dv = v + 0.5 - place[1];
            if (du * du + dv * dv >= none * none)
                continue;
            for (const CutCells::Cut& cut : finder.cutInRow(u, v, first, last))
                sums.addCut(cut.moments, {du, dv, cut.w + 0.5 - place[2]});
            const CutCells::Row row = finder.row(u, v);
            for (auto i = static_cast<std::size_t>(std::ranges::lower_bound(row.w, first) - row.w.begin());
                 i < row.w.size() && row.w[i] <= last; ++i)
                if (row.fraction[i] >= CellFinder::full)
                    sums.addFull({du, dv, row.w[i] + 0.5 - place[2]});
        }
    return sums.shape();
}

} // namespace knead
