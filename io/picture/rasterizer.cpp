#include "io/picture/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knead {

namespace {

class BandFiller {
public:
    BandFiller(const ScreenMesh& mesh, const Projection& projection, SampleBand& band)
        : m_mesh(mesh)
        , m_forward(projection.forward)
        , m_band(band)
    {
    }

    void run()
    {
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
            fill(t);
    }

private:
    void fill(std::size_t t)
    {
        const TriangleMesh::Triangle& triangle = m_mesh.triangles[t];
        const Vec3& a = m_mesh.places[triangle[0]];
        const Vec3& b = m_mesh.places[triangle[1]];
        const Vec3& c = m_mesh.places[triangle[2]];
        const double area = cross(a, b, c);
        const auto [lowY, highY] = std::minmax({a.y(), b.y(), c.y()});
        const auto [lowX, highX] = std::minmax({a.x(), b.x(), c.x()});
        // Samples lie at the middle of their squares.
        const int firstRow = std::max(m_band.firstRow, static_cast<int>(std::ceil(lowY - 0.5)));
        const int lastRow = std::min(m_band.firstRow + m_band.rows - 1, static_cast<int>(std::floor(highY - 0.5)));
        const int firstColumn = std::max(0, static_cast<int>(std::ceil(lowX - 0.5)));
        const int lastColumn = std::min(m_band.width - 1, static_cast<int>(std::floor(highX - 0.5)));
        if (area == 0 || firstRow > lastRow || firstColumn > lastColumn)
            return;
        const double side = facesEye(t) ? 1 : -1;
        for (int row = firstRow; row <= lastRow; ++row) {
            // Long thin triangles cover little of their box.
            const auto [from, to] = spanAt(row + 0.5, {a, b, c});
            if (from > to)
                continue;
            const int begin = std::max(firstColumn, static_cast<int>(std::floor(from - 0.5)) - 1);
            const int end = std::min(lastColumn, static_cast<int>(std::ceil(to - 0.5)) + 1);
            for (int column = begin; column <= end; ++column) {
                const Vec3 place(column + 0.5, row + 0.5, 0);
                const Vec3 weights = Vec3(cross(place, b, c), cross(a, place, c), cross(a, b, place)) / area;
                if (weights.minCoeff() >= 0)
                    put(t, column, row, weights, weights.dot(Vec3(a.z(), b.z(), c.z())), side);
            }
        }
    }

    /// Where a row crosses a triangle, from left to right; the other way round where it does not.
    static std::array<double, 2> spanAt(double y, const std::array<Vec3, 3>& corners)
    {
        std::array<double, 2> span{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& from = corners[i];
            const Vec3& to = corners[(i + 1) % 3];
            const double height = to.y() - from.y();
            if (height == 0 || std::min(from.y(), to.y()) > y || std::max(from.y(), to.y()) < y)
                continue; // the ends of a level side are ends of the others, too
            const double x = from.x() + (y - from.y()) / height * (to.x() - from.x());
            span = {std::min(span[0], x), std::max(span[1], x)};
        }
        return span;
    }

    void put(std::size_t t, int column, int row, const Vec3& weights, double depth, double side)
    {
        Sample& sample =
            m_band.samples[static_cast<std::size_t>(row - m_band.firstRow) * static_cast<std::size_t>(m_band.width) +
                           static_cast<std::size_t>(column)];
        if (sample.surface != Sample::nothing && depth >= static_cast<double>(sample.depth))
            return;
        const auto& normals = m_mesh.normals[t];
        const Vec3 normal = side * (weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2]);
        sample.depth = static_cast<float>(depth);
        sample.normal = normal.normalized().cast<float>();
        sample.surface = m_mesh.surfaceOfTriangle[t];
    }

    bool facesEye(std::size_t t) const
    {
        const auto& normals = m_mesh.normals[t];
        return m_forward.dot(normals[0] + normals[1] + normals[2]) <= 0;
    }

    /// Twice the signed area of a triangle on the screen.
    static double cross(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }

    const ScreenMesh& m_mesh;
    Vec3 m_forward;
    SampleBand& m_band;
};

} // namespace

SampleBand rasterize(const ScreenMesh& mesh, const Projection& projection, int width, int firstRow, int rows)
{
    SampleBand band{width, firstRow, rows, {}};
    band.samples.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
    BandFiller(mesh, projection, band).run();
    return band;
}

} // namespace knead
