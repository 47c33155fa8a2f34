#include "core/session/ground_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr int gridSide = 80;        // values along each axis
constexpr int gridRim = 7;          // of them outside of all that casts
constexpr double hazeHeight = 0.08; // at which half of the darkness is left, in sizes of what casts
constexpr int blurs = 3;            // averages over three neighbors along either axis
constexpr float noHeight = std::numeric_limits<float>::max();

/// Heights of what is lowest, at each value.
class Heights {
public:
    Heights(const Box& box, double ground)
        : m_ground(ground)
        , m_heights(static_cast<std::size_t>(gridSide) * gridSide, noHeight)
    {
        const Eigen::Vector2d size = box.sizes().head<2>();
        m_step = std::max(size.maxCoeff() / (gridSide - 1 - 2 * gridRim), 1e-9);
        m_low = box.center().head<2>() - Eigen::Vector2d::Constant(0.5 * m_step * (gridSide - 1));
    }

    void lower(int x, int y, double height)
    {
        if (x < 0 || y < 0 || x >= gridSide || y >= gridSide)
            return;
        float& known = m_heights[static_cast<std::size_t>(y) * gridSide + static_cast<std::size_t>(x)];
        known = std::min(known, static_cast<float>(std::max(0.0, height - m_ground)));
    }

    void lower(int x, int y, const Vec3& place)
    {
        if (m_cut == nullptr || m_cut->distance(place) <= 0)
            lower(x, y, place.z());
    }

    /// What is cut off of the triangles that are added.
    void cut(const CutPlane* plane) { m_cut = plane; }

    /// All values that the triangle covers, and the one nearest to its first corner.
    void add(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        const Eigen::Vector2d p = at(a);
        const Eigen::Vector2d q = at(b);
        const Eigen::Vector2d r = at(c);
        lower(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())), a);
        const Eigen::Vector2d u = q - p;
        const Eigen::Vector2d v = r - p;
        const double area = u.x() * v.y() - u.y() * v.x();
        if (area == 0)
            return;
        const Eigen::Vector2d low = p.cwiseMin(q).cwiseMin(r);
        const Eigen::Vector2d high = p.cwiseMax(q).cwiseMax(r);
        for (int y = std::max(0, static_cast<int>(std::ceil(low.y()))); y <= std::min(gridSide - 1.0, high.y()); ++y)
            for (int x = std::max(0, static_cast<int>(std::ceil(low.x()))); x <= std::min(gridSide - 1.0, high.x());
                 ++x) {
                const Eigen::Vector2d d(x - p.x(), y - p.y());
                const double second = (d.x() * v.y() - d.y() * v.x()) / area;
                const double third = (u.x() * d.y() - u.y() * d.x()) / area;
                if (second >= 0 && third >= 0 && second + third <= 1)
                    lower(x, y, a + second * (b - a) + third * (c - a));
            }
    }

    void add(const ShadowProbe& probe)
    {
        const Eigen::Vector2d low = at(probe.box.min());
        const Eigen::Vector2d high = at(probe.box.max());
        for (int y = std::max(0, static_cast<int>(std::floor(low.y()))); y <= std::min(gridSide - 1.0, high.y()); ++y)
            for (int x = std::max(0, static_cast<int>(std::floor(low.x()))); x <= std::min(gridSide - 1.0, high.x());
                 ++x) {
                const Vec3 place(m_low.x() + m_step * x, m_low.y() + m_step * y, m_ground);
                if (const double above = probe.heightAbove(place); above >= 0)
                    lower(x, y, m_ground + above);
            }
    }

    GroundShadow shadow(double haze) const
    {
        GroundShadow shadow{.low = m_low, .step = m_step, .side = gridSide, .darkness = {}};
        shadow.darkness.resize(m_heights.size());
        std::ranges::transform(m_heights, shadow.darkness.begin(), [haze](float height) {
            const float share = height / static_cast<float>(haze);
            return height == noHeight ? 0.0F : 1 / (1 + share * share);
        });
        for (int n = 0; n < blurs; ++n)
            for (const int stride : {1, gridSide})
                blur(shadow.darkness, stride);
        return shadow;
    }

private:
    Eigen::Vector2d at(const Vec3& place) const { return (place.head<2>() - m_low) / m_step; }

    static void blur(std::vector<float>& values, int stride)
    {
        const std::vector<float> before = values;
        for (int y = 1; y + 1 < gridSide; ++y)
            for (int x = 1; x + 1 < gridSide; ++x) {
                const int i = y * gridSide + x;
                const auto of = [&](int index) { return before[static_cast<std::size_t>(index)]; };
                values[static_cast<std::size_t>(i)] = 0.25F * (of(i - stride) + 2 * of(i) + of(i + stride));
            }
    }

    const CutPlane* m_cut = nullptr; ///< null: nothing is
    double m_ground;
    double m_step = 0;
    Eigen::Vector2d m_low = Eigen::Vector2d::Zero();
    std::vector<float> m_heights; ///< above the ground [m]
};

} // namespace

GroundShadow groundShadow(std::span<const ShadowCaster> casters, std::span<const ShadowProbe> probes, double height,
                          const std::optional<CutPlane>& cut)
{
    const auto point = [](const ShadowCaster& caster, std::uint32_t vertex) -> Vec3 {
        return Eigen::Map<const Eigen::Vector3f>(caster.points.data() + std::size_t{3} * vertex).cast<double>();
    };
    Box box;
    for (const ShadowCaster& caster : casters)
        for (std::uint32_t vertex = 0; vertex < caster.points.size() / 3; ++vertex)
            box.extend(point(caster, vertex));
    for (const ShadowProbe& probe : probes)
        box.extend(probe.box);
    if (box.isEmpty())
        return {};
    Heights heights(box, height);
    heights.cut(cut ? &*cut : nullptr);
    for (const ShadowCaster& caster : casters)
        for (const auto& [a, b, c] : caster.triangles)
            heights.add(point(caster, a), point(caster, b), point(caster, c));
    for (const ShadowProbe& probe : probes)
        heights.add(probe);
    return heights.shadow(std::max(hazeHeight * box.diagonal().norm(), 1e-9));
}

} // namespace knead
