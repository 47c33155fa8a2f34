#include "core/session/ambient_shade.h"

#include "core/aggregate/aggregate.h"
#include "core/session/vertex_shades.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double mostCells = 4e6;
constexpr int widest = 8;                                    // cells of the coarsest grid, in finest ones
constexpr std::array<float, 4> keptOff{1, 0.8F, 0.6F, 0.4F}; // by what a cell is full of: what is near keeps off more
constexpr int aroundCount = 6;                               // directions aslant, besides the normal
constexpr float slantCosine = 0.574F;                        // of 55 degrees
constexpr float uprightShare = 0.25F;                        // of the light that comes along the normal

struct Extent {
    Box box;
    double spacing = 0; ///< the widest one [m]
};

Extent extentOf(std::span<const Snapshot::BodyState> bodies)
{
    Extent extent;
    for (const Snapshot::BodyState& body : bodies) {
        for (const Vec3& position : body.positions)
            extent.box.extend(position);
        if (!body.positions.empty())
            extent.spacing = std::max(extent.spacing, body.aggregate->lattice.spacing);
    }
    return extent;
}

} // namespace

std::size_t MaterialAround::Grid::indexOf(const Eigen::Array3i& cell) const
{
    return static_cast<std::size_t>((cell.z() * count.y() + cell.y()) * count.x() + cell.x());
}

MaterialAround::MaterialAround(std::span<const Snapshot::BodyState> bodies)
{
    const Extent extent = extentOf(bodies);
    if (!(extent.spacing > 0) || !extent.box.sizes().allFinite())
        return;
    layOut(extent.box, extent.spacing);
    for (const Snapshot::BodyState& body : bodies)
        fillIn(body);
    for (float& share : m_grids[0].share)
        share = std::min(share, 1.0F);
    for (std::size_t g = 1; g < gridCount; ++g)
        m_grids[g].takeMeans(m_grids[g - 1]);
}

void MaterialAround::layOut(const Box& box, double spacing)
{
    m_width = spacing;
    const auto cells = [&] { return ((box.sizes() / m_width).array() + 4.0 * widest).prod(); };
    while (cells() > mostCells)
        m_width *= 1.25;
    // At whole cells of the coarsest grid, so that shades do not flicker while the box of the bodies changes; one more all around.
    const double step = widest * m_width;
    const Eigen::Array3d low = (box.min().array() / step - 0.25).floor() - 1;
    const Eigen::Array3d high = (box.max().array() / step + 0.25).ceil() + 1;
    m_origin = step * low.matrix();
    for (std::size_t g = 0; g < gridCount; ++g) {
        m_grids[g].count = (high - low).cast<int>() * (widest >> g);
        m_grids[g].last = (m_grids[g].count - 1).cast<float>();
        m_grids[g].share.assign(static_cast<std::size_t>(m_grids[g].count.cast<double>().prod()), 0.0F);
    }
}

/// Each object is shared out to the eight cells around it.
void MaterialAround::fillIn(const Snapshot::BodyState& body)
{
    const double cellVolume = m_width * m_width * m_width;
    Grid& finest = m_grids[0];
    for (std::size_t i = 0; i < body.positions.size(); ++i) {
        const Eigen::Array3d place = (body.positions[i] - m_origin).array() / m_width - 0.5;
        const Eigen::Array3i cell = place.floor().cast<int>();
        const Eigen::Array3d way = place - cell.cast<double>();
        const double share = body.aggregate->volume[i] / cellVolume;
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Array3i side(corner & 1, corner >> 1 & 1, corner >> 2);
            const double weight = (side == 1).select(way, 1 - way).prod();
            const Eigen::Array3i there = (cell + side).max(0).min(finest.count - 1);
            finest.share[finest.indexOf(there)] += static_cast<float>(weight * share);
        }
    }
}

void MaterialAround::Grid::takeMeans(const Grid& finer)
{
    for (int z = 0; z < finer.count.z(); ++z)
        for (int y = 0; y < finer.count.y(); ++y)
            for (int x = 0; x < finer.count.x(); ++x)
                share[indexOf(Eigen::Array3i(x, y, z) / 2)] += finer.share[finer.indexOf({x, y, z})] / 8;
}

float MaterialAround::material(std::size_t grid, const Eigen::Array3f& place) const
{
    const Grid& cells = m_grids[grid];
    const Eigen::Array3f local = place / static_cast<float>(1U << grid) - 0.5F;
    if (!((local >= 0).all() && (local < cells.last).all()))
        return 0; // all around the bodies there are empty cells
    const Eigen::Array3i cell = local.cast<int>();
    const Eigen::Array3f way = local - cell.cast<float>();
    const auto row = static_cast<std::ptrdiff_t>(cells.count.x());
    const std::ptrdiff_t layer = row * cells.count.y();
    const float* first = cells.share.data() + cell.z() * layer + cell.y() * row + cell.x();
    const auto alongX = [&](const float* at) { return at[0] + way.x() * (at[1] - at[0]); };
    const auto alongY = [&](const float* at) {
        const float near = alongX(at);
        return near + way.y() * (alongX(at + row) - near);
    };
    const float lower = alongY(first);
    return lower + way.z() * (alongY(first + layer) - lower);
}

float MaterialAround::lightFrom(const Eigen::Array3f& place, const Eigen::Array3f& direction, float cosine) const
{
    float light = 1;
    for (std::size_t g = 0; g < gridCount; ++g) {
        const float height = 1.5F * static_cast<float>(1U << g) + 1;
        light *= 1 - keptOff[g] * std::min(1.0F, material(g, place + height / cosine * direction));
    }
    return light;
}

double MaterialAround::shade(const Vec3& place, const Vec3& normal) const
{
    if (m_width == 0)
        return 1;
    struct Way {
        float right, up;
    };
    static const auto around = [] {
        std::array<Way, aroundCount> ways{};
        for (int i = 0; i < aroundCount; ++i) {
            const double angle = 2 * std::numbers::pi * i / aroundCount;
            const double sine = std::sqrt(1 - slantCosine * slantCosine);
            ways[i] = {static_cast<float>(sine * std::cos(angle)), static_cast<float>(sine * std::sin(angle))};
        }
        return ways;
    }();
    const Eigen::Array3f here = ((place - m_origin) / m_width).cast<float>();
    const Vec3 sideways = normal.unitOrthogonal();
    const Eigen::Array3f n = normal.cast<float>();
    const Eigen::Array3f right = sideways.cast<float>();
    const Eigen::Array3f up = normal.cross(sideways).cast<float>();
    float slanting = 0;
    for (const Way& way : around)
        slanting += lightFrom(here, slantCosine * n + way.right * right + way.up * up, slantCosine) / aroundCount;
    const float light = uprightShare * lightFrom(here, n, 1) + (1 - uprightShare) * slanting;
    return 1 - ambientDarkest * static_cast<double>(1 - light);
}

std::vector<float> ambientShades(std::span<const float> points, std::span<const float> normals,
                                 const MaterialAround& material)
{
    return vertexShades(points, normals,
                        [&](const Vec3& place, const Vec3& normal) { return material.shade(place, normal); });
}

} // namespace knead
