#include "bench/bar_pile.h"

#include "core/aggregate/published_fill.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace knead {

namespace {

/// Random numbers that are the same everywhere: the standard fixes the generator's bits, but not its distributions.
class Random {
public:
    explicit Random(std::uint64_t seed)
        : m_bits(seed)
    {
    }

    double between(double low, double high)
    {
        return low + (high - low) * static_cast<double>(m_bits() >> 11U) * 0x1p-53;
    }

    Vec3 vector(double largest)
    {
        const double x = between(-largest, largest);
        const double y = between(-largest, largest);
        return {x, y, between(-largest, largest)};
    }

    /// Any rotation is as likely as any other: a point of a four-dimensional ball.
    Quaternion rotation()
    {
        for (;;) {
            const Vec3 v = vector(1);
            const Quaternion rotation(between(-1, 1), v.x(), v.y(), v.z());
            if (rotation.squaredNorm() <= 1 && rotation.squaredNorm() > 0.01)
                return rotation.normalized();
        }
    }

private:
    std::mt19937_64 m_bits;
};

constexpr double a = BarPile::spacing;

/// Half the lengths of a box through the outermost spheres of a bar at rest. Its edges lie on their surfaces, its faces within
/// them: most bars meet edge on.
const Vec3 halfSize = a * Vec3(2.35, 2.35, 8.35);

/// Half of what a bar covers of a direction.
double halfWidth(const Mat3& rotation, const Vec3& direction)
{
    return halfSize.dot((rotation.transpose() * direction).cwiseAbs());
}

/// Whether the boxes of two bars are apart: some face or pair of edges gives a direction in which they do not overlap.
bool areApart(const Pose& one, const Pose& other)
{
    const Mat3 first = one.rotation.toRotationMatrix();
    const Mat3 second = other.rotation.toRotationMatrix();
    const Vec3 between = other.position - one.position;
    const auto parts = [&](const Vec3& direction) {
        return std::abs(direction.dot(between)) > halfWidth(first, direction) + halfWidth(second, direction);
    };
    for (int i = 0; i < 3; ++i)
        if (parts(first.col(i)) || parts(second.col(i)))
            return true;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (parts(first.col(i).cross(second.col(j))))
                return true;
    return false;
}

/// Lowers a bar from above until it touches one of those that lie there, or the floor at height 0.
void drop(Pose& bar, const std::vector<Pose>& lying)
{
    const double floor = halfWidth(bar.rotation.toRotationMatrix(), Vec3::UnitZ());
    const double diameter = 2 * halfSize.norm();
    double height = floor;
    std::vector<Pose> below;
    for (const Pose& other : lying)
        if ((other.position - bar.position).head<2>().norm() < diameter) {
            below.push_back(other);
            height = std::max(height, other.position.z() + diameter);
        }
    const auto fitsAt = [&](double z) {
        const Pose lowered{{bar.position.x(), bar.position.y(), z}, bar.rotation};
        return std::all_of(below.begin(), below.end(), [&](const Pose& other) { return areApart(lowered, other); });
    };
    for (const double step : {a, a / 16}) // bars are 5 a thick: no long step falls through one
        while (height > floor && fitsAt(std::max(floor, height - step)))
            height = std::max(floor, height - step);
    bar.position.z() = height;
}

std::vector<Pose> pile(std::size_t bars, Random& random)
{
    constexpr int attempts = 4; // of which the lowest place is taken, or towers would grow
    const double side = 11.5 * a * std::cbrt(static_cast<double>(bars));
    std::vector<Pose> lying;
    for (std::size_t i = 0; i < bars; ++i) {
        Pose lowest;
        lowest.position.z() = std::numeric_limits<double>::infinity();
        for (int attempt = 0; attempt < attempts; ++attempt) {
            const double x = random.between(0, side);
            Pose bar{{x, random.between(0, side), 0}, random.rotation()};
            drop(bar, lying);
            if (bar.position.z() < lowest.position.z())
                lowest = bar;
        }
        lying.push_back(lowest);
    }
    return lying;
}

Pose moved(const Pose& pose, const Vec3& velocity, const Vec3& spin, double dt)
{
    Pose result{pose.position + dt * velocity, pose.rotation};
    result.rotation.coeffs() += 0.5 * dt * (Quaternion(0, spin.x(), spin.y(), spin.z()) * pose.rotation).coeffs();
    result.rotation.normalize();
    return result;
}

} // namespace

BarPile::BarPile(std::size_t bars, std::uint64_t seed)
    : m_aggregate(std::make_shared<const Aggregate>(fillAsPublished(shapes::box(a * Vec3(5, 5, 17)), a)))
    , m_materials(Material{}, m_aggregate->size())
{
    Random random(seed);
    for (const Pose& pose : pile(bars, random)) {
        const Vec3 velocity = random.vector(1);
        Bar bar{pose, velocity, random.vector(1 / halfSize.z()), objectsAtRest(*m_aggregate),
                std::make_unique<StructuralConnections>(m_aggregate, m_materials)};
        place(bar);
        m_bars.push_back(std::move(bar));
    }
}

void BarPile::place(Bar& bar) const
{
    const Mat3 rotation = bar.pose.rotation.toRotationMatrix();
    for (std::size_t i = 0; i < m_aggregate->size(); ++i) {
        const Vec3 arm = rotation * m_aggregate->lattice.position(static_cast<ObjectIndex>(i));
        bar.state.position.set(i, bar.pose.position + arm);
        bar.state.velocity.set(i, bar.velocity + bar.spin.cross(arm));
    }
}

void BarPile::move(double dt)
{
    for (Bar& bar : m_bars) {
        bar.pose = moved(bar.pose, bar.velocity, bar.spin, dt);
        place(bar);
    }
}

void BarPile::computeForces()
{
    for (Bar& bar : m_bars)
        bar.connections->computeForces(bar.state);
}

std::span<const VicinitySphere> BarPile::spheres()
{
    m_spheres.clear();
    for (const Bar& bar : m_bars)
        for (std::size_t i = 0; i < bar.state.size(); ++i)
            m_spheres.push_back({.center = bar.state.position.at(i),
                                 .radius = spacing / 2,
                                 .group = static_cast<std::uint32_t>(m_spheres.size())});
    return m_spheres;
}

} // namespace knead
