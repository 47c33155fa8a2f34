#include "peers/peer_bar.h"

#include "core/aggregate/fill.h"
#include "support/shapes.h"

namespace knead {

PeerBar makePeerBar(const std::array<int, 3>& objects)
{
    const Vec3 cells(objects[0] - 1, objects[1] - 1, objects[2] - 1);
    constexpr double spacing = 1e-3;
    PeerBar bar;
    bar.aggregate = std::make_shared<const Aggregate>(fill(shapes::box(spacing * cells), {.spacing = spacing}));
    const Lattice& lattice = bar.aggregate->lattice;
    for (const Lattice::Node& node : lattice.nodes) {
        bar.places.emplace_back(node[0], node[1], node[2]);
        bar.velocities.emplace_back(PeerBar::speed * Vec3(3, 2, 1).normalized() +
                                    PeerBar::spin * Vec3(1, 0, 0).cross(bar.places.back()));
    }
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        for (const Lattice::Segment& segment : lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i)
                if (bar.aggregate->weight[d][i] > 0)
                    bar.connections.push_back({i, i + static_cast<ObjectIndex>(segment.offset), d >= 3});
    return bar;
}

} // namespace knead
