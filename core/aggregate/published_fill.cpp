#include "core/aggregate/published_fill.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_distance.h"
#include "core/message/message.h"
#include "core/task/parallel.h"

#include <cmath>

namespace knead {

namespace {

constexpr double mostNodes = 2e7;

/// Spheres fill the box along each axis as far as whole ones fit, centered.
Lattice latticeIn(const Box& box, double spacing)
{
    Lattice lattice;
    lattice.spacing = spacing;
    Eigen::Index longest = 0;
    box.sizes().maxCoeff(&longest);
    for (Eigen::Index column = 0; column < 3; ++column) // w, the last one, along the longest side
        lattice.axes.col(column) = Vec3::Unit((longest + 1 + column) % 3);
    Lattice::Node count{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double length = box.sizes().dot(lattice.axes.col(static_cast<Eigen::Index>(axis)));
        count[axis] = std::max(1, static_cast<std::int32_t>(std::floor(length / spacing + 1e-6)));
    }
    const Vec3 span(count[0] - 1, count[1] - 1, count[2] - 1);
    lattice.origin = box.center() - 0.5 * spacing * (lattice.axes * span);
    for (std::int32_t u = 0; u < count[0]; ++u)
        for (std::int32_t v = 0; v < count[1]; ++v)
            for (std::int32_t w = 0; w < count[2]; ++w)
                lattice.nodes.push_back({u, v, w});
    return lattice;
}

void keepInside(Lattice& lattice, const TriangleMesh& mesh, double orientation)
{
    const SurfaceDistance surface(mesh);
    std::vector<std::uint8_t> inside(lattice.size(), 0);
    forEachBlock(lattice.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            inside[i] =
                orientation * surface.nearest(lattice.position(static_cast<ObjectIndex>(i))).signedDistance < 0 ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[i] != 0)
            lattice.nodes[kept++] = lattice.nodes[i];
    lattice.nodes.resize(kept);
}

/// Equal weights with the sum of k l^2 = 6 E V, where k = mu a w and mu = E / 2.5.
void connect(Aggregate& aggregate)
{
    Lattice& lattice = aggregate.lattice;
    findSegments(lattice, Lattice::directionCount);
    double sum = 0; // of l^2 / a^2
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& step = Lattice::directions[d];
        const double squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
        aggregate.weight[d].assign(aggregate.size(), 0);
        for (const Lattice::Segment& segment : lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i) {
                if (lattice.nodes[i + static_cast<ObjectIndex>(segment.offset)] != Lattice::sum(lattice.nodes[i], step))
                    continue;
                aggregate.weight[d][i] = 1;
                sum += squared;
            }
    }
    const double a = lattice.spacing;
    const double weight = sum > 0 ? 15 * aggregate.filledVolume / (a * a * a * sum) : 0;
    for (auto& weights : aggregate.weight)
        for (double& w : weights)
            w *= weight;
}

} // namespace

Aggregate fillAsPublished(const TriangleMesh& mesh, double spacing)
{
    if (mesh.empty() || !isWatertight(mesh))
        throw Problem(Message("Filling", "The surface is not closed. Close it and try again."));
    if (!(spacing > 0 && std::isfinite(spacing)))
        throw Problem(Message("Filling", "The spacing must be greater than 0."));
    const MassProperties properties = massProperties(mesh);
    if ((properties.box.sizes() / spacing + Vec3::Ones()).prod() > mostNodes)
        throw Problem(Message("Filling", "The spacing is too small for a part of this size. Choose a larger one."));
    Aggregate aggregate;
    aggregate.lattice = latticeIn(properties.box, spacing);
    keepInside(aggregate.lattice, mesh, properties.volume < 0 ? -1 : 1);
    if (aggregate.size() == 0)
        throw Problem(Message("Filling", "No sphere has its center inside the part. Choose a smaller spacing."));
    aggregate.meshVolume = std::abs(properties.volume);
    aggregate.filledVolume = aggregate.meshVolume;
    aggregate.cells = aggregate.size();
    aggregate.volume.assign(aggregate.size(), aggregate.filledVolume / static_cast<double>(aggregate.size()));
    aggregate.depth.assign(aggregate.size(), spacing / 2);
    aggregate.face.assign(aggregate.size(), Aggregate::noFace);
    connect(aggregate);
    return aggregate;
}

} // namespace knead
