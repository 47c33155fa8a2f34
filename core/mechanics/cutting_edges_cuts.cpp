// What edges go through. Part of CuttingEdges.
#include "core/mechanics/cutting_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace knead {

namespace {

// What an edge has gone through begins so much behind where it was, so that nothing slips between two steps [spacings].
constexpr double overlap = 0.15;
// An object so near to the plane of the cut keeps to the side that it was left on when it lost its first connections [spacings].
constexpr double sureSide = 0.5;
// Those that lie in the plane, but for rounding, are all above it [spacings].
constexpr double inPlane = 1e-3;
// A wire that does not push with this share of its limit cuts when it goes further than this in a step [spacings].
constexpr double clearWay = 1e-2;
constexpr double slippingShare = 0.8;
constexpr double wakeOfWire = 1.5; // behind it [spacings]
constexpr double furtherOn = 0.1;  // of a connection, see crossingOf()
// Cuts are no nearer than this to an end of a connection, by its length.
constexpr double nearestEnd = 1e-6;

/// Where a line between two places goes through a triangle, as a share of the way; none: nowhere. Its borders are part of it, and the line
/// goes on a little, since the sides of objects that lie in a cut are told by the plane of all of the edge.
std::optional<double> crossingOf(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 way = to - from;
    const Vec3 normal = (b - a).cross(c - a);
    const double slope = way.dot(normal);
    if (slope == 0)
        return {};
    const double share = (a - from).dot(normal) / slope;
    if (share < -furtherOn || share > 1 + furtherOn)
        return {};
    const Vec3 place = from + share * way;
    constexpr double slack = -1e-9;
    const double most = slack * normal.squaredNorm();
    const bool isInside = (b - a).cross(place - a).dot(normal) >= most &&
                          (c - b).cross(place - b).dot(normal) >= most && (a - c).cross(place - c).dot(normal) >= most;
    return isInside ? std::optional(share) : std::nullopt;
}

/// What an edge has gone through: a strip between where it was in the material and where it is.
class Strip {
public:
    Strip(const std::vector<Vec3>& before, const std::vector<Vec3>& now)
        : m_before(before)
        , m_now(now)
    {
        for (const std::vector<Vec3>* line : {&before, &now})
            for (const Vec3& place : *line)
                m_box.extend(place);
    }

    /// As crossingOf().
    std::optional<double> crossing(const Vec3& from, const Vec3& to) const
    {
        const Vec3 beyond = furtherOn * (to - from);
        if (!m_box.intersects(Box((from - beyond).cwiseMin(to + beyond), (from - beyond).cwiseMax(to + beyond))))
            return {};
        for (std::size_t p = 0; p + 1 < m_now.size(); ++p) {
            if (const auto share = crossingOf(from, to, m_before[p], m_before[p + 1], m_now[p + 1]))
                return share;
            if (const auto share = crossingOf(from, to, m_before[p], m_now[p + 1], m_now[p]))
                return share;
        }
        return {};
    }

private:
    const std::vector<Vec3>& m_before;
    const std::vector<Vec3>& m_now;
    Box m_box;
};

/// On which side of a cut objects are. Those that lie in it, and have lost connections, are opposite to what these led to.
class Sides {
public:
    Sides(const CuttingFrame& frame, const ContactBody& body)
        : m_frame(frame)
        , m_body(body)
    {
    }

    void noteBroken(ObjectIndex first, ObjectIndex second)
    {
        m_lost[first] += heightOf(second);
        m_lost[second] += heightOf(first);
    }

    bool isAbove(ObjectIndex object) const
    {
        const double height = heightOf(object);
        if (std::abs(height) < sureSide)
            if (const auto found = m_lost.find(object); found != m_lost.end() && std::abs(found->second) > sureSide)
                return found->second < 0;
        return height >= -inPlane;
    }

    /// Whether it has lost connections.
    bool isLoose(ObjectIndex object) const { return m_lost.contains(object); }

private:
    double heightOf(ObjectIndex object) const
    {
        return m_frame.height(m_body.state->position.at(object)) / m_body.spacing();
    }

    const CuttingFrame& m_frame;
    const ContactBody& m_body;
    std::unordered_map<ObjectIndex, double> m_lost; ///< sum of the heights of neighbors that loose ones had [spacings]
};

} // namespace

/// Where the points of an edge were in the material when the step began, with everything where it is now, and a little behind that.
/// @param forwards per point: the way that it goes, unit; 0: just there
std::vector<Vec3> CuttingEdges::trailOf(const Edge& edge, const std::vector<Vec3>& forwards,
                                        std::span<const ContactBody> bodies)
{
    std::vector<Vec3> trail;
    for (std::size_t p = 0; p < edge.points.size(); ++p) {
        const Point& point = edge.points[p];
        if (point.spread.count == 0) {
            trail.push_back(point.before);
            continue;
        }
        const ContactBody& body = bodies[point.body];
        const Vec3 place = point.spread.at(body.state->position);
        trail.push_back(place - overlap * body.spacing() * forwards[p]);
    }
    return trail;
}

std::vector<std::vector<BrokenConnection>> CuttingEdges::cuts(std::span<const ContactBody> bodies,
                                                              std::span<const RigidSurface> surfaces) const
{
    std::vector<std::vector<BrokenConnection>> all(bodies.size());
    for (const Edge& edge : m_edges) {
        const Pose& pose = surfaces[edge.surface].pose;
        std::vector<Vec3> now;
        for (const Point& point : edge.points)
            now.push_back(pose.toWorld(point.place));
        const std::vector<Vec3> there = trailOf(edge, std::vector<Vec3>(now.size(), Vec3::Zero()), bodies);
        Vec3 way = Vec3::Zero();
        Vec3 held = Vec3::Zero();
        double limit = 0;
        for (std::size_t p = 0; p < now.size(); ++p) {
            way += now[p] - there[p];
            held += pose.rotation * edge.points[p].hold;
            limit += edge.points[p].limit;
        }
        // A wire goes where it pushes as hard as it can; else, of one that hardly moves, nobody knows which way it cuts.
        const bool isSlipping = limit > 0 && held.norm() >= slippingShare * limit;
        const CuttingFrame frame(edge.blade, pose, isSlipping ? held : way);
        const std::vector<Vec3> trail = trailOf(edge, std::vector<Vec3>(now.size(), frame.forward), bodies);
        for (const Nearby& nearby : edge.nearby)
            if (!edge.blade.isWire() || isSlipping ||
                way.norm() > clearWay * bodies[nearby.body].spacing() * static_cast<double>(now.size()))
                addCuts(edge, nearby, frame, trail, now, bodies[nearby.body], all[nearby.body]);
    }
    for (std::vector<BrokenConnection>& ofBody : all) { // two edges may have gone through the same
        const auto idOf = [](const BrokenConnection& cut) -> const ConnectionId& { return cut; };
        std::ranges::stable_sort(ofBody, {}, idOf);
        const auto doubles = std::ranges::unique(ofBody, {}, idOf);
        ofBody.erase(doubles.begin(), doubles.end());
    }
    return all;
}

void CuttingEdges::addCuts(const Edge& edge, const Nearby& nearby, const CuttingFrame& frame,
                           const std::vector<Vec3>& trail, const std::vector<Vec3>& now, const ContactBody& body,
                           std::vector<BrokenConnection>& cuts)
{
    if (frame.forward.isZero(0))
        return;
    const auto place = [&](ObjectIndex object) { return body.state->position.at(object); };
    const auto holds = [&](const Connection& connection) {
        return body.connections->stiffness()[connection.id.direction][connection.id.lower] > 0;
    };
    const std::vector<double>& depth = body.connections->aggregate().depth;
    const double length = edge.blade.length();
    const double wake = std::max(edge.blade.height, wakeOfWire * body.spacing());
    // What the blade is between now, or a wire was just now; and ahead of the edge what lies outside of the skin, where no edge comes
    // when it stops at what the material lies on.
    const auto isBetween = [&](const Connection& connection, double share) {
        const Vec3 middle = place(connection.id.lower) + share * (place(connection.upper) - place(connection.id.lower));
        const double along = (middle - frame.origin).dot(frame.edge);
        const double ahead = (middle - frame.origin).dot(frame.forward);
        const double below =
            depth[connection.id.lower] + share * (depth[connection.upper] - depth[connection.id.lower]);
        return along >= 0 && along <= length && ahead >= -wake &&
               (ahead <= 0 || (below <= 0 && ahead <= body.spacing()));
    };
    Sides sides(frame, body);
    for (const Connection& connection : nearby.connections)
        if (!holds(connection))
            sides.noteBroken(connection.id.lower, connection.upper);
    const Strip strip(trail, now);
    for (const Connection& connection : nearby.connections) {
        const auto [id, upper] = connection;
        const Material& material = body.materialOf(id.lower);
        if (!holds(connection) || !material.isCut() || !body.materialOf(upper).isCut() ||
            sides.isAbove(id.lower) == sides.isAbove(upper))
            continue;
        std::optional<double> share = strip.crossing(place(id.lower), place(upper));
        if (!share && (sides.isLoose(id.lower) || sides.isLoose(upper))) {
            const double from = frame.height(place(id.lower));
            const double to = frame.height(place(upper));
            const double across = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
            if (isBetween(connection, across))
                share = across;
        }
        if (share)
            cuts.push_back({id, std::clamp(*share, nearestEnd, 1 - nearestEnd)});
    }
}

} // namespace knead
