#include "core/aggregate/cell_moments.h"

namespace knead {

namespace {

constexpr double twelfth = 1.0 / 12;

/// A point of a triangle where a polynomial is taken, by the parts of the corners, and its weight.
struct Sample {
    double a, b, c;
    double weight;
};

/// Exact to the third degree, with positive weights: corners, middles of the sides, and the middle. The integrands below
/// are of the third degree, so that the moments are exact for the triangles.
constexpr std::array<Sample, 7> samples{{{1, 0, 0, 1.0 / 20},
                                         {0, 1, 0, 1.0 / 20},
                                         {0, 0, 1, 1.0 / 20},
                                         {0.5, 0.5, 0, 2.0 / 15},
                                         {0, 0.5, 0.5, 2.0 / 15},
                                         {0.5, 0, 0.5, 2.0 / 15},
                                         {1.0 / 3, 1.0 / 3, 1.0 / 3, 9.0 / 20}}};

} // namespace

CellMoments CellMoments::even(double fraction)
{
    CellMoments moments;
    moments.value[0] = fraction;
    moments.value[4] = moments.value[5] = moments.value[6] = fraction * twelfth;
    return moments;
}

void ColumnMoments::add(PolygonView piece, const Vec3& cell)
{
    const Vec3 middle = cell + Vec3::Constant(0.5);
    const Vec3 a = piece[0] - middle;
    Vec3 b = piece[1] - middle;
    for (std::size_t i = 2; i < piece.size(); ++i) {
        const Vec3 c = piece[i] - middle;
        const double area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        if (area != 0)
            for (const Sample& sample : samples) {
                const Vec3 x = sample.a * a + sample.b * b + sample.c * c;
                const double da = -area * sample.weight; // material lies above a piece that faces -w
                const double u = x.x();
                const double v = x.y();
                const double w = x.z();
                const std::array<double, 6> plane{da, da * u, da * v, da * u * u, da * v * v, da * u * v};
                for (std::size_t k = 0; k < plane.size(); ++k)
                    m_area[k] += plane[k];
                const double height = 0.5 - w; // integrals from w to 1/2 of 1, w, ww
                const double lifted = 0.5 * (0.25 - w * w);
                const double squared = (0.125 - w * w * w) / 3;
                m_inCell[0] += height * plane[0];
                m_inCell[1] += height * plane[1];
                m_inCell[2] += height * plane[2];
                m_inCell[3] += lifted * plane[0];
                m_inCell[4] += height * plane[3];
                m_inCell[5] += height * plane[4];
                m_inCell[6] += squared * plane[0];
                m_inCell[7] += height * plane[5];
                m_inCell[8] += lifted * plane[1];
                m_inCell[9] += lifted * plane[2];
            }
        b = c;
    }
}

CellMoments ColumnMoments::inCell(const ColumnMoments& below, double orientation) const
{
    CellMoments moments;
    for (std::size_t k = 0; k < m_inCell.size(); ++k)
        moments.value[k] = m_inCell[k];
    const std::array<double, 6>& area = below.m_area;
    const std::array<double, CellMoments::count> through{area[0], area[1],           area[2], 0, area[3],
                                                         area[4], twelfth * area[0], area[5], 0, 0};
    for (std::size_t k = 0; k < through.size(); ++k)
        moments.value[k] = orientation * (moments.value[k] + through[k]);
    return moments;
}

void ColumnMoments::addTo(ColumnMoments& below) const
{
    for (std::size_t k = 0; k < m_area.size(); ++k)
        below.m_area[k] += m_area[k];
}

} // namespace knead
