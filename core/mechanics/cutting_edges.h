#pragma once

#include "core/mechanics/blade.h"
#include "core/mechanics/contact_body.h"
#include "core/mechanics/contact_crowd.h"
#include "core/mechanics/contact_report.h"
#include "core/mechanics/cutting_frame.h"
#include "core/mechanics/point_spread.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Edges of knives and wires in material that they cut (Material::toughness).
///
/// An edge is points half a spacing apart. Each holds on to the material around it by a spring, which gives way at toughness times
/// the length that the point stands for: the edge then goes on, and connections that it goes through are no more. So a cut takes
/// R w ds of work, with R the toughness and w the width that is cut (Atkins, The Science and Engineering of Cutting, 2009, without
/// friction and flow, which contact and material add by themselves), and a tool below that force stands still. What has been cut
/// already, and what is outside of the material, does not hold.
class CuttingEdges {
public:
    /// What a point of an edge held with at the end of a step.
    struct Hold {
        std::uint32_t surface = 0; ///< RigidSurface::id
        std::uint32_t point = 0;   ///< of the edge
        Vec3 force = Vec3::Zero(); ///< on the material, in the frame of the tool [N]
    };
    std::vector<Hold> memory() const;
    void restore(std::vector<Hold> holds) { m_remembered = std::move(holds); }

    /// Finds what edges may meet before anything has gone further than the margin [m].
    void list(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double margin);

    /// Before the forces of a step: where the edges are in the material. @param surfaces as they are at the end of the step
    void begin(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double duration);

    /// Adds forces to the states of the bodies, and what they do to the report. @pre begin()
    void computeForces(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                       const ContactStep& step, ContactCrowd& crowd, ContactReport& report);

    /// The connections that edges went through since begin(), with everything where it is after the step. Per body
    std::vector<std::vector<BrokenConnection>> cuts(std::span<const ContactBody> bodies,
                                                    std::span<const RigidSurface> surfaces) const;

private:
    struct Connection {
        ConnectionId id;
        ObjectIndex upper = 0;
    };
    struct Nearby {
        std::uint32_t body = 0;
        std::vector<ObjectIndex> objects;    ///< around the edge and what is behind it
        std::vector<Connection> connections; ///< made of these, broken ones among them
    };
    struct Point {
        Vec3 place = Vec3::Zero();  ///< in the frame of the tool [m]
        double length = 0;          ///< of the edge that it stands for [m]
        Vec3 hold = Vec3::Zero();   ///< see Hold [N]
        Vec3 before = Vec3::Zero(); ///< where it was when the step began [m]
        std::uint32_t body = 0;
        PointSpread spread = {}; ///< of that place in the material of then; of nothing: it is outside
        double limit = 0;        ///< at which it goes on [N]
        double stiffness = 0;    ///< of its spring [N/m]
    };
    struct Edge {
        std::uint32_t id = 0;      ///< RigidSurface::id
        std::uint32_t surface = 0; ///< index of the surface
        Blade blade;
        std::vector<Nearby> nearby;
        std::vector<Point> points;
    };

    void addNearby(Edge& edge, const ContactBody& body, std::uint32_t index, const RigidSurface& surface,
                   double margin) const;
    void findMaterial(const Edge& edge, Point& point, std::span<const ContactBody> bodies) const;
    void findUncut(Edge& edge, const CuttingFrame& frame, std::span<const ContactBody> bodies) const;
    static std::vector<Vec3> trailOf(const Edge& edge, const std::vector<Vec3>& forwards,
                                     std::span<const ContactBody> bodies);
    static void addCuts(const Edge& edge, const Nearby& nearby, const CuttingFrame& frame,
                        const std::vector<Vec3>& trail, const std::vector<Vec3>& now, const ContactBody& body,
                        std::vector<BrokenConnection>& cuts);

    std::vector<Edge> m_edges;
    std::vector<Hold> m_remembered; ///< of a moment, for the next list
};

} // namespace knead
