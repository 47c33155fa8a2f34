// The grips of a stroke: patches of material that follow the hand.
#include "core/session/sculpting.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double pinchedWay = 0.4;    // that they go towards the middle, of their distance from it
constexpr double patchStrength = 3;   // of a patch that is to flow, in limits of a spring that pulls it visibly
constexpr double smoothing = 0.5;     // share of the newest force: waves pass through
constexpr double worthTelling = 0.02; // of the largest speed

/// None where there are no such objects: they may be of another filling.
std::optional<Vec3> middleOf(const std::vector<ObjectIndex>& objects, const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (const ObjectIndex object : objects)
        if (object < places.size()) {
            sum += places[object];
            ++count;
        }
    return count == 0 ? std::nullopt : std::optional(Vec3(sum / static_cast<double>(count)));
}

} // namespace

/// Objects near a place, as they lie now; those that are held otherwise stay where they are.
void SculptStroke::addGrip(const Snapshot& now, const Vec3& mirror, const Vec3& place, const Vec3& aside, double radius,
                           std::vector<std::uint8_t>& isTaken)
{
    const std::vector<Vec3>& positions = now.bodies[m_body].positions;
    Touch touch{.mirror = mirror, .place = place, .aside = aside};
    for (ObjectIndex object = 0; object < positions.size(); ++object)
        if (isTaken[object] == 0 && (positions[object] - place - aside).norm() <= radius) {
            isTaken[object] = 1;
            touch.objects.push_back(object);
        }
    if (touch.objects.empty())
        return;
    touch.patch = touch.last = *middleOf(touch.objects, positions);
    touch.spring = springFor(m_material, radius, m_choice.brush == SculptBrush::pull ? m_choice.pull : PullChoice{});
    touch.spring.limit *= m_material.yields() ? patchStrength * m_choice.strength : m_choice.strength;
    m_touches.push_back(std::move(touch));
}

std::optional<std::size_t> SculptStroke::fixtureOf(const std::string& name, const Snapshot& now)
{
    const auto found = std::ranges::find(now.fixtures, name, &Fixture::name);
    return found == now.fixtures.end() ? std::nullopt
                                       : std::optional(static_cast<std::size_t>(found - now.fixtures.begin()));
}

/// Of the patch [m]; where it was last while the snapshot does not tell.
Vec3 SculptStroke::middleNow(const Touch& touch, const Snapshot& now) const
{
    const std::optional<std::size_t> index = fixtureOf(touch.name, now);
    if (!index || now.fixtures[*index].objects != touch.objects)
        return touch.last;
    return middleOf(touch.objects, now.bodies[m_body].positions).value_or(touch.last);
}

/// From the patch to where the hand wants it [m], or [rad].
Vec3 SculptStroke::wantedStep(const Touch& touch, const Snapshot& now) const
{
    const Vec3 way = touch.mirror.cwiseProduct(m_hand - m_start.place);
    if (!turnsPatch(m_choice.brush))
        return way - pinchedWay * touch.aside - (middleNow(touch, now) - touch.patch);
    const Vec3 drawn = m_hand - m_start.place;
    Vec3 angle = m_choice.brush == SculptBrush::bend ? Vec3(m_start.normal.cross(drawn) / m_choice.radius)
                                                     : Vec3(-drawn.dot(m_right) / m_choice.radius * m_start.normal);
    angle = touch.mirror.prod() * touch.mirror.cwiseProduct(angle); // it is a pseudovector
    return angle - touch.turned;
}

void SculptStroke::moveGrip(Touch& touch, const Snapshot& now, double dt, std::vector<Command>& commands)
{
    const std::optional<std::size_t> index = fixtureOf(touch.name, now);
    if (!index || m_isReleased)
        return;
    const Fixture& fixture = now.fixtures[*index];
    const std::optional<Vec3> there = middleOf(fixture.objects, now.bodies[m_body].positions);
    if (!there)
        return;
    if (fixture.objects != touch.objects) { // the body was filled anew
        touch.objects = fixture.objects;
        touch.patch += *there - touch.last;
    }
    const Vec3 middle = touch.last = *there;
    touch.turned += dt * touch.turning;
    const Vec3& force = now.fixtureForces[*index];
    const Vec3 moment = now.fixtureMoments[*index] + (now.fixtureCenters[*index] - middle).cross(force);
    touch.force += smoothing * (force - touch.force);
    if (!now.fixtureMoments[*index].isZero(0)) // it is not known right after a moment was gone to
        touch.moment += smoothing * (moment - touch.moment);
    const Vec3 step = wantedStep(touch, now);
    const auto goTo = m_material.yields() ? flowVelocity : pullVelocity;
    Vec3 velocity;
    Vec3 turning = Vec3::Zero();
    if (turnsPatch(m_choice.brush)) {
        velocity = pullVelocity(touch.spring, Vec3::Zero(), touch.force, m_choice.speed); // where no force is on it
        turning = turnVelocity(touch.spring, step, touch.moment, m_choice.speed / m_choice.radius, goTo);
    } else {
        velocity = goTo(touch.spring, step, touch.force, m_choice.speed);
    }
    const double change = (velocity - touch.velocity).norm() + m_choice.radius * (turning - touch.turning).norm();
    const double telling = touch.velocity.norm() + m_choice.radius * touch.turning.norm();
    if (change <= worthTelling * std::max(telling, worthTelling * m_choice.speed))
        return;
    touch.velocity = velocity;
    touch.turning = turning;
    MoveFixture move{now.fixtureIds[*index], velocity};
    if (!turning.isZero(0))
        move.turn = {.center = middle, .angularVelocity = turning};
    commands.emplace_back(move);
}

Vec3 SculptStroke::placeNow(const Snapshot& now) const
{
    if (m_touches.empty())
        return m_spot.place;
    const Touch& first = m_touches.front();
    if (usesFingers(m_choice.brush)) {
        const ToolState* tool = toolOf(first, now);
        if (tool == nullptr)
            return m_spot.place;
        const Vec3& normal = m_choice.brush == SculptBrush::flatten ? m_start.normal : m_spot.normal;
        const Vec3 lag = first.mirror.cwiseProduct(tool->pose.position - poseOf(first, false).position);
        return m_spot.place + lag - lag.dot(normal) * normal;
    }
    return first.place + first.aside + middleNow(first, now) - first.patch;
}

} // namespace knead
