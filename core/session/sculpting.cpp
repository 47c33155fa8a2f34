#include "core/session/sculpting.h"

#include "core/aggregate/aggregate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double pinchedPatch = 0.35;  // radius of each of the four patches, in those of the brush
constexpr double fewestSpacings = 1.2; // a patch reaches at least so far
constexpr double otherHandFrom = 0.6;  // what is farther than this share of the farthest is held by the other hand ...
constexpr double otherHandRadii = 3;   // ... and farther than so many radii
constexpr double stalled = 0.97;       // of its limit, which holds a finger

Vec3 across(const Vec3& direction, const Vec3& normal)
{
    const Vec3 part = direction - direction.dot(normal) * normal;
    return part.norm() > 1e-3 * direction.norm() ? Vec3(part.normalized()) : normal.unitOrthogonal();
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

// What strokes call their tools and fixtures, before a number.
constexpr const char* fingerStem = "Finger";
constexpr const char* gripStem = "Grip";
constexpr const char* holdStem = "Other hand";

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

} // namespace

bool usesFingers(SculptBrush brush)
{
    return brush == SculptBrush::thumb || brush == SculptBrush::smooth || brush == SculptBrush::flatten ||
           brush == SculptBrush::smear;
}

bool isNameOfStroke(const std::string& name)
{
    const std::size_t gap = name.rfind(' ');
    if (gap == std::string::npos || gap + 1 == name.size() ||
        name.find_first_not_of("0123456789", gap + 1) != std::string::npos)
        return false;
    const std::string stem = name.substr(0, gap);
    return stem == fingerStem || stem == gripStem || stem == holdStem;
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
        touch.name = freeName(now, usesFingers(m_choice.brush) ? fingerStem : gripStem, taken);
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
    hold.name = freeName(now, holdStem, taken);
    m_hold = std::move(hold);
}

Vec3 SculptStroke::mirrored(const Vec3& place, const Vec3& mirror) const
{
    return m_choice.middle + mirror.cwiseProduct(place - m_choice.middle);
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
            touch.limit = touch.toldLimit = tool.forceLimit;
            touch.told = tool.pose.position;
            commands.emplace_back(AddManipulator{std::move(tool)});
        } else {
            commands.emplace_back(AddFixture{{touch.name, m_body, touch.objects}});
        }
    }
    return commands;
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

void SculptStroke::strengthen(double factor)
{
    for (Touch& touch : m_touches) {
        touch.limit *= factor;
        touch.spring.limit *= factor;
    }
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

} // namespace knead
