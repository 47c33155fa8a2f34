#include "core/session/crack_gaps.h"

#include "core/aggregate/pieces.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <cstddef>

namespace knead {

namespace {

constexpr double leastLengthening = 0.5; // of an edge that spans a gap [spacings]
constexpr double gapReach = 2;           // of a triangle from a crack that it spans [spacings]
constexpr float gapingStretch = 1.5F;    // of a broken connection whose ends have parted
constexpr float beyondMaterial = 1.3F;   // stretch of an edge over that of the connections around it

/// How connections are stretched.
struct Stretches {
    std::vector<float> held;  ///< per object, of those that hold the most; 0: there are none
    std::vector<Vec3> gaping; ///< middles of broken ones whose ends have parted, when the body was filled [m]

    Stretches(const Aggregate& aggregate, const Snapshot::BodyState& state)
        : held(aggregate.size(), 0)
    {
        const Lattice& lattice = aggregate.lattice;
        const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, *state.broken);
        aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
            const double rest = lattice.direction(static_cast<int>(d)).norm();
            const auto stretch = static_cast<float>((state.positions[upper] - state.positions[lower]).norm() / rest);
            if ((isBroken[lower] >> d & 1U) == 0) {
                held[lower] = std::max(held[lower], stretch);
                held[upper] = std::max(held[upper], stretch);
            } else if (stretch > gapingStretch) {
                gaping.push_back((lattice.position(lower) + lattice.position(upper)) / 2);
            }
        });
    }
};

/// The objects that carry a triangle.
std::vector<ObjectIndex> carriersOfTriangle(const Skin& skin, const TriangleMesh::Triangle& triangle)
{
    std::vector<ObjectIndex> carriers;
    for (const std::uint32_t corner : triangle)
        for (const Skin::Influence& influence : skin.influences(corner))
            carriers.push_back(influence.object);
    std::ranges::sort(carriers);
    const auto twice = std::ranges::unique(carriers);
    carriers.erase(twice.begin(), twice.end());
    return carriers;
}

} // namespace

std::vector<std::uint32_t> trianglesAcrossCracks(const FilledBody& body, const Snapshot::BodyState& state,
                                                 std::span<const Vec3> places)
{
    std::vector<std::uint32_t> across;
    if (!state.broken || state.broken->empty())
        return across;
    const std::span<const Vec3> filled = body.skin->points();
    const double spacing = body.aggregate->lattice.spacing;
    std::vector<float> stretches;
    for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) {
        const TriangleMesh::Triangle& corners = body.mesh.triangles[t];
        float most = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i];
            const std::uint32_t to = corners[(i + 1) % 3];
            const double now = (places[to] - places[from]).norm();
            const double before = (filled[to] - filled[from]).norm();
            if (now > before + leastLengthening * spacing)
                most = std::max(most, static_cast<float>(now / before));
        }
        if (most > beyondMaterial) {
            across.push_back(t);
            stretches.push_back(most);
        }
    }
    if (across.empty())
        return across;
    const Stretches now(*body.aggregate, state);
    if (now.gaping.empty())
        return {};
    const VectorArray gaping(now.gaping);
    const PointGrid grid(gaping, spacing);
    std::vector<PointGrid::Found> near;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < across.size(); ++i) {
        const TriangleMesh::Triangle& corners = body.mesh.triangles[across[i]];
        grid.nearest((filled[corners[0]] + filled[corners[1]] + filled[corners[2]]) / 3, 1, near, gapReach * spacing);
        std::vector<float> held = pickedOf(now.held, carriersOfTriangle(*body.skin, corners));
        const auto middle = held.begin() + static_cast<std::ptrdiff_t>(held.size() / 2);
        std::ranges::nth_element(held, middle); // the median: a crack may hang by some threads that are drawn out far
        if (!near.empty() && stretches[i] > beyondMaterial * std::max(1.0F, *middle))
            across[kept++] = across[i];
    }
    across.resize(kept);
    return across;
}

} // namespace knead
