#include "core/session/sculpting.h"

#include "core/aggregate/aggregate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double gapShare = 0.1;       // between a finger and the surface before and after, in radii
constexpr double pinchedPatch = 0.35;  // radius of each of the four patches, in those of the brush
constexpr double pinchedWay = 0.4;     // that they go towards the middle, of their distance from it
constexpr double levelingRadius = 3;   // of the ball that smooths, in those of the brush
constexpr double fewestSpacings = 1.2; // a patch reaches at least so far
constexpr double patchStrength = 3;    // of a patch that is to flow, in limits of a spring that pulls it visibly
constexpr double otherHandFrom = 0.6;  // what is farther than this share of the farthest is held by the other hand ...
constexpr double otherHandRadii = 3;   // ... and farther than so many radii
constexpr double smoothing = 0.5;      // share of the newest force: waves pass through
constexpr double worthTelling = 0.02;  // of the largest speed
constexpr double arrived = 0.02;       // a lifted finger has, so near, in its radii
constexpr double lingering = 0.5;      // with a finger that something holds, beyond what its way takes [s]
constexpr double stalled = 0.97;       // of its limit, which holds a finger

Vec3 across(const Vec3& direction, const Vec3& normal)
{
    const Vec3 part = direction - direction.dot(normal) * normal;
    return part.norm() > 1e-3 * direction.norm() ? Vec3(part.normalized()) : normal.unitOrthogonal();
}

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

/// Of the body, what fixtures hold.
/// @param going that one no more
std::vector<std::uint8_t> heldObjects(const Snapshot& now, BodyId body, const std::string& going)
{
    std::vector<std::uint8_t> isHeld(now.bodies[body].positions.size());
    for (const Fixture& fixture : now.fixtures)
        if (fixture.body == body && fixture.name != going)
            for (const ObjectIndex object : fixture.objects)
                if (object < isHeld.size())
                    isHeld[object] = 1;
    return isHeld;
}

/// A name with a number that no tool and no fixture has, nor one of `taken`.
std::string freeName(const Snapshot& now, const std::string& stem, std::vector<std::string>& taken)
{
    for (int number = 1;; ++number) {
        std::string name = stem + " " + std::to_string(number);
        if (std::ranges::find(now.tools, name, &ToolState::name) == now.tools.end() &&
            std::ranges::find(now.fixtures, name, &Fixture::name) == now.fixtures.end() &&
            std::ranges::find(taken, name) == taken.end())
            return taken.emplace_back(std::move(name));
    }
}

ReshapeManipulator withLimit(const ToolState& tool, double limit)
{
    return {.tool = tool.id,
            .size = tool.size,
            .friction = tool.friction,
            .speedLimit = tool.speedLimit,
            .forceLimit = limit,
            .kind = tool.kind,
            .part = tool.part,
            .adhesion = tool.adhesion,
            .rollsFreely = tool.rollsFreely};
}

} // namespace

bool usesFingers(SculptBrush brush)
{
    return brush == SculptBrush::thumb || brush == SculptBrush::smooth || brush == SculptBrush::flatten ||
           brush == SculptBrush::smear;
}

bool turnsPatch(SculptBrush brush)
{
    return brush == SculptBrush::bend || brush == SculptBrush::twist;
}

SculptStroke::SculptStroke(const SculptChoice& choice, BodyId body, const Snapshot& now, const SurfaceSpot& spot,
                           const Vec3& right, const std::string& going)
    : m_choice(choice)
    , m_body(body)
    , m_material(now.materials[body])
    , m_start(spot)
    , m_right(right)
    , m_spot(spot)
    , m_hand(spot.place)
    , m_going(going)
    , m_time(now.time)
{
    addTouches(now);
    if (choice.holdsRest && !m_touches.empty())
        addHold(now);
}

/// One for each combination of mirrors, where there is material and no other touch.
void SculptStroke::addTouches(const Snapshot& now)
{
    const double spacing = now.bodies[m_body].aggregate->lattice.spacing;
    const double reach = m_choice.radius + spacing;
    const std::vector<Vec3>& positions = now.bodies[m_body].positions;
    std::vector<std::uint8_t> isTaken = heldObjects(now, m_body, m_going);
    std::vector<Vec3> places;
    for (int mirrors = 0; mirrors < 8; ++mirrors) {
        Vec3 mirror = Vec3::Ones();
        bool isWanted = true;
        for (int axis = 0; axis < 3; ++axis)
            if ((mirrors >> axis & 1) != 0) {
                mirror[axis] = -1;
                isWanted = isWanted && m_choice.mirrored[static_cast<std::size_t>(axis)];
            }
        const Vec3 place = mirrored(m_start.place, mirror);
        const auto isNear = [&](const Vec3& other) { return (other - place).norm() < m_choice.radius; };
        const auto isInReach = [&](const Vec3& object) { return (object - place).norm() < reach; };
        if (!isWanted || std::ranges::any_of(places, isNear) || std::ranges::none_of(positions, isInReach))
            continue;
        places.push_back(place);
        if (usesFingers(m_choice.brush)) {
            m_touches.push_back({.mirror = mirror, .place = place});
        } else if (m_choice.brush == SculptBrush::pinch) {
            const Vec3 first = across(m_right, m_start.normal);
            const double radius = std::max(pinchedPatch * m_choice.radius, fewestSpacings * spacing);
            for (const Vec3& direction : {first, Vec3(m_start.normal.cross(first))})
                for (const double side : {-1.0, 1.0})
                    addGrip(now, mirror, place, side * m_choice.radius * mirror.cwiseProduct(direction), radius,
                            isTaken);
        } else {
            addGrip(now, mirror, place, Vec3::Zero(), std::max(m_choice.radius, fewestSpacings * spacing), isTaken);
        }
    }
    std::vector<std::string> taken;
    for (Touch& touch : m_touches)
        touch.name = freeName(now, usesFingers(m_choice.brush) ? "Finger" : "Grip", taken);
}

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

/// As a sculptor's other hand does: what is far from all touches, where nothing else holds the body.
void SculptStroke::addHold(const Snapshot& now)
{
    const std::vector<std::uint8_t> isHeld = heldObjects(now, m_body, m_going);
    if (std::ranges::find(isHeld, 1) != isHeld.end())
        return;
    const std::vector<Vec3>& positions = now.bodies[m_body].positions;
    const auto distance = [&](const Vec3& position) {
        double nearest = std::numeric_limits<double>::max();
        for (const Touch& touch : m_touches)
            nearest = std::min(nearest, (position - touch.place).norm());
        return nearest;
    };
    double farthest = 0;
    for (const Vec3& position : positions)
        farthest = std::max(farthest, distance(position));
    const double from = std::max(otherHandFrom * farthest, otherHandRadii * m_choice.radius);
    Fixture hold{.body = m_body};
    for (ObjectIndex object = 0; object < positions.size(); ++object)
        if (distance(positions[object]) > from)
            hold.objects.push_back(object);
    if (hold.objects.empty())
        return;
    std::vector<std::string> taken;
    hold.name = freeName(now, "Other hand", taken);
    m_hold = std::move(hold);
}

Vec3 SculptStroke::mirrored(const Vec3& place, const Vec3& mirror) const
{
    return m_choice.middle + mirror.cwiseProduct(place - m_choice.middle);
}

/// What a finger is, without its name and its place.
Manipulator SculptStroke::finger() const
{
    const double radius = m_choice.radius;
    Manipulator finger{.friction = 0.3, .speedLimit = m_choice.speed, .kind = ToolKind::ball};
    finger.size = Vec3::Constant(2 * radius);
    finger.forceLimit = thumbForce(m_material, radius);
    switch (m_choice.brush) {
    case SculptBrush::smooth:
        finger.size *= levelingRadius;
        finger.friction = 0.1;
        finger.rollsFreely = true;
        finger.forceLimit = thumbForce(m_material, levelingRadius * radius) / levelingRadius;
        break;
    case SculptBrush::flatten:
        finger.kind = ToolKind::cylinder;
        finger.size.z() = radius;
        finger.friction = 0.1;
        break;
    case SculptBrush::smear:
        finger.friction = 1.5;
        finger.forceLimit *= 3;
        break;
    default:
        break;
    }
    finger.forceLimit *= m_choice.strength;
    return finger;
}

/// Where a finger is to be, above the surface as it was. It flattens to the plane around the first place, and levels what stands out;
/// away it is above what stands out, too.
Pose SculptStroke::poseOf(const Touch& touch, bool isAway) const
{
    const bool isFlat = m_choice.brush == SculptBrush::flatten;
    const bool isLevel = isFlat || m_choice.brush == SculptBrush::smooth;
    const Vec3 normal = isFlat ? m_start.normal : m_spot.normal;
    Vec3 place = m_spot.place;
    if (isLevel) {
        const double depth = ((isFlat ? m_start.level : m_spot.level) - place).dot(normal);
        place += (isAway ? std::max(0.0, depth) : depth) * normal;
    }
    const double above = isAway ? gapShare * m_choice.radius : height();
    const double reach =
        isFlat ? 0.5 * m_choice.radius : (m_choice.brush == SculptBrush::smooth ? levelingRadius : 1) * m_choice.radius;
    const Vec3 outward = touch.mirror.cwiseProduct(normal);
    Pose pose;
    pose.position = mirrored(place, touch.mirror) + (reach + above) * outward;
    if (isFlat)
        pose.rotation = Quaternion::FromTwoVectors(Vec3::UnitZ(), outward);
    return pose;
}

/// Above the surface as it was when the stroke began [m].
double SculptStroke::height() const
{
    switch (m_choice.brush) {
    case SculptBrush::thumb:
        return -m_choice.radius; // until its limit holds it
    case SculptBrush::smear:
        return -m_choice.radius / 3;
    default:
        return 0;
    }
}

std::vector<Command> SculptStroke::begin()
{
    std::vector<Command> commands;
    if (m_hold)
        commands.emplace_back(AddFixture{*m_hold});
    for (Touch& touch : m_touches) {
        if (usesFingers(m_choice.brush)) {
            Manipulator tool = finger();
            tool.name = touch.name;
            tool.pose = poseOf(touch, true);
            touch.limit = tool.forceLimit;
            touch.told = tool.pose.position;
            commands.emplace_back(AddManipulator{std::move(tool)});
        } else {
            commands.emplace_back(AddFixture{{touch.name, m_body, touch.objects}});
        }
    }
    return commands;
}

const ToolState* SculptStroke::toolOf(const Touch& touch, const Snapshot& now) const
{
    const auto found = std::ranges::find(now.tools, touch.name, &ToolState::name);
    return found == now.tools.end() ? nullptr : &*found;
}

std::vector<Command> SculptStroke::follow(const Snapshot& now, bool hasAll)
{
    const double dt = std::max(0.0, now.time - m_time);
    m_time = now.time;
    std::vector<Command> commands;
    for (Touch& touch : m_touches)
        if (usesFingers(m_choice.brush))
            moveFinger(touch, now, hasAll, commands);
        else
            moveGrip(touch, now, dt, commands);
    std::erase_if(m_touches, [](const Touch& touch) { return touch.isGone; });
    if (m_isReleased && m_touches.empty())
        letGo(now, hasAll, commands);
    return commands;
}

void SculptStroke::moveFinger(Touch& touch, const Snapshot& now, bool hasAll, std::vector<Command>& commands)
{
    const ToolState* tool = toolOf(touch, now);
    if (tool == nullptr) { // not there yet, or refused, or removed by somebody
        touch.isGone = hasAll;
        return;
    }
    if (!m_isReleased) {
        if (tool->forceLimit != touch.limit) // it was strengthened before it was seen
            commands.emplace_back(withLimit(*tool, touch.limit));
        const Pose pose = poseOf(touch, false);
        if ((pose.position - touch.told).norm() > worthTelling * m_choice.radius) {
            touch.told = pose.position;
            commands.emplace_back(SetManipulatorMotion{tool->id, GoTo{pose}});
        }
        return;
    }
    if (!touch.leaveBy) {
        const Pose away = poseOf(touch, true);
        touch.told = away.position;
        touch.leaveBy = now.time + 2 * (away.position - tool->pose.position).norm() / tool->speedLimit + lingering;
        commands.emplace_back(SetManipulatorMotion{tool->id, GoTo{away}});
    } else if ((tool->pose.position - touch.told).norm() < arrived * m_choice.radius || now.time > *touch.leaveBy) {
        touch.isGone = true;
        commands.emplace_back(RemoveManipulator{tool->id});
    }
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

std::vector<Command> SculptStroke::release(const Snapshot& now, bool hasAll)
{
    std::vector<Command> commands;
    m_isReleased = true;
    if (usesFingers(m_choice.brush))
        return follow(now, hasAll);
    letGo(now, hasAll, commands);
    return commands;
}

/// Grips, and the other hand. Those that the simulation does not have yet get the next numbers, in the order of adding.
void SculptStroke::letGo(const Snapshot& now, bool hasAll, std::vector<Command>& commands)
{
    FixtureId next = now.nextFixture;
    const auto remove = [&](const std::string& name) {
        if (const std::optional<std::size_t> index = fixtureOf(name, now))
            commands.emplace_back(RemoveFixture{now.fixtureIds[*index]});
        else if (!hasAll)
            commands.emplace_back(RemoveFixture{next++});
    };
    if (m_hold)
        remove(m_hold->name);
    m_hold.reset();
    if (!usesFingers(m_choice.brush)) {
        for (const Touch& touch : m_touches)
            remove(touch.name);
        m_touches.clear();
    }
}

std::vector<Command> SculptStroke::abandon(const Snapshot& now, bool hasAll)
{
    m_isReleased = true;
    std::vector<Command> commands;
    if (usesFingers(m_choice.brush)) {
        ToolId next = now.nextTool; // of those that the simulation does not have yet
        for (const Touch& touch : m_touches)
            if (const ToolState* tool = toolOf(touch, now))
                commands.emplace_back(RemoveManipulator{tool->id});
            else if (!hasAll)
                commands.emplace_back(RemoveManipulator{next++});
        m_touches.clear();
    }
    letGo(now, hasAll, commands);
    return commands;
}

std::vector<Command> SculptStroke::strengthen(const Snapshot& now, double factor)
{
    m_choice.strength *= factor;
    std::vector<Command> commands;
    for (Touch& touch : m_touches) {
        touch.limit *= factor;
        touch.spring.limit *= factor;
        if (const ToolState* tool = toolOf(touch, now))
            commands.emplace_back(withLimit(*tool, touch.limit));
    }
    return commands;
}

double SculptStroke::force(const Snapshot& now) const
{
    if (m_touches.empty())
        return 0;
    const Touch& first = m_touches.front();
    if (usesFingers(m_choice.brush)) {
        const ToolState* tool = toolOf(first, now);
        return tool == nullptr ? 0 : tool->force.norm();
    }
    if (turnsPatch(m_choice.brush))
        return first.moment.norm() / first.spring.radius;
    return springForce(first.spring, wantedStep(first, now)).norm();
}

bool SculptStroke::isAtLimit(const Snapshot& now) const
{
    if (m_touches.empty())
        return false;
    const Touch& first = m_touches.front();
    if (usesFingers(m_choice.brush))
        return force(now) >= stalled * first.limit;
    const double arm = turnsPatch(m_choice.brush) ? first.spring.radius : 1;
    return first.spring.stiffness * arm * wantedStep(first, now).norm() > first.spring.limit;
}

Vec3 SculptStroke::placeNow(const Snapshot& now) const
{
    if (m_touches.empty() || usesFingers(m_choice.brush))
        return m_spot.place;
    const Touch& first = m_touches.front();
    return first.place + first.aside + middleNow(first, now) - first.patch;
}

} // namespace knead
