#include "core/session/moved_regions.h"

#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

/// A place with an object that is farther than this has none [spacings].
constexpr double farthestObject = 1;

Vec3 middleOfPlaces(const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    return places.empty() ? sum : Vec3(sum / static_cast<double>(places.size()));
}

/// By area.
Vec3 centerOfFaces(const TriangleMesh& mesh, const std::vector<std::uint32_t>& faces)
{
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::ranges::find(faces, mesh.faceOfTriangle[t]) == faces.end())
            continue;
        const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
        const double weight = crossOf(corners).norm();
        sum += weight / 3 * (corners[0] + corners[1] + corners[2]);
        area += weight;
    }
    return area > 0 ? Vec3(sum / area) : sum;
}

std::vector<Vec3> positionsOf(const Aggregate& aggregate, const std::vector<ObjectIndex>& objects)
{
    std::vector<Vec3> places;
    for (const ObjectIndex object : objects)
        if (object < aggregate.size())
            places.push_back(aggregate.lattice.position(object));
    return places;
}

/// As far beyond what it holds as before, on each side.
Box boxAround(const Box& inside, const Box& box, const Box& held, const CarriedVectors& vectors)
{
    Box around = inside;
    const Vec3 low = held.min() - box.min();
    const Vec3 high = box.max() - held.max();
    const Mat3 share = vectors.turn();
    for (int to = 0; to < 3; ++to) {
        double below = 0;
        double above = 0;
        for (int from = 0; from < 3; ++from) {
            const double part = vectors.scale() * share(to, from);
            below += part > 0 ? part * low[from] : -part * high[from];
            above += part > 0 ? part * high[from] : -part * low[from];
        }
        around.min()[to] -= below;
        around.max()[to] += above;
    }
    return around;
}

} // namespace

CarriedVectors::CarriedVectors(const Mat3& linear)
    : m_scale(std::cbrt(std::abs(linear.determinant())))
    , m_hand(linear.determinant() < 0 ? -1 : 1)
{
    constexpr double rounding = 1e-12;
    if (std::abs(m_scale - 1) < rounding)
        m_scale = 1;
    m_turn = linear / m_scale;
}

void CarriedVectors::carry(LoadAmount& amount) const
{
    amount.force = m_scale * carried(amount.force);
    amount.moment = std::pow(m_scale, 3) * spun(amount.moment);
}

MovedRegions::MovedRegions(const TransferGround& ground, TransferReport& report)
    : m_ground(ground)
    , m_vectors(ground.base.linear)
    , m_report(report)
{
}

const BodyMap* MovedRegions::mapOf(BodyId before) const
{
    const auto found = std::ranges::find(m_ground.bodies, before, &BodyMap::before);
    return found == m_ground.bodies.end() ? nullptr : &*found;
}

std::vector<const BodyMap*> MovedRegions::mapsOf(const std::string& name) const
{
    std::vector<const BodyMap*> maps;
    for (const BodyId body : bodiesNamed(name, m_ground.before.parts(), Message("Transfer", "The recipe")))
        if (const BodyMap* map = mapOf(body))
            maps.push_back(map);
    return maps;
}

/// Whatever means this body alone.
std::string MovedRegions::nameAfter(BodyId after) const
{
    const std::vector<Part>& parts = m_ground.after.parts();
    for (const std::string& name : {parts[after].name, parts[after].path})
        if (!name.empty() && bodiesNamed(name, parts, {}) == std::vector{after})
            return name;
    return '#' + std::to_string(after);
}

bool MovedRegions::leaveOut(const Message& what, const Message& why)
{
    m_report.leftOut.push_back(Message("Transfer", "Left out: %1. %2").with(what, why));
    return false;
}

bool MovedRegions::moveBody(std::string& name)
{
    if (name.empty())
        return true;
    const std::vector<const BodyMap*> bodies = mapsOf(name);
    if (bodies.empty())
        return leaveOut(Message("Transfer", "what is said of the body \"%1\"").with(name),
                        Message("Transfer", "The other part has no such body."));
    name = nameAfter(bodies.front()->after);
    return true;
}

bool MovedRegions::move(RecipeRegion& region, const Message& what)
{
    const std::vector<const BodyMap*> bodies = mapsOf(region.body);
    if (bodies.empty())
        return leaveOut(what, Message("Transfer", "The other part has no such body."));
    const BodyMap& first = *bodies.front();
    const bool isThere = region.box              ? moveBox(region, bodies, what)
                         : region.objects        ? moveObjects(region, first, what)
                         : !region.faces.empty() ? moveFaces(region, first, what)
                                                 : true;
    if (!region.body.empty() || (!region.box && m_ground.after.parts().size() > 1))
        region.body = nameAfter(first.after);
    return isThere;
}

bool MovedRegions::moveFaces(RecipeRegion& region, const BodyMap& body, const Message& what)
{
    const Vec3 before = centerOfFaces(m_ground.before.parts()[body.before].mesh, region.faces);
    std::vector<std::uint32_t> faces;
    std::size_t lost = 0;
    for (const std::uint32_t face : region.faces)
        if (const auto after = body.faceAfter(face))
            faces.push_back(*after);
        else
            ++lost;
    region.faces = std::move(faces);
    std::ranges::sort(region.faces);
    if (region.faces.empty())
        return leaveOut(what, Message("Transfer", "None of its faces was found again."));
    if (lost > 0)
        m_report.leftOut.push_back(
            Message("Transfer", "Of the faces of %1, %2 were not found again.").with(what, lost));
    note(region, body, what, before, centerOfFaces(m_ground.after.parts()[body.after].mesh, region.faces));
    return true;
}

bool MovedRegions::moveBox(RecipeRegion& region, const std::vector<const BodyMap*>& bodies, const Message& what)
{
    std::vector<Vec3> held;
    std::vector<Vec3> places;
    for (const BodyMap* body : bodies) {
        const Aggregate& aggregate = *m_ground.before.scene.bodies[body->before].aggregate;
        const std::vector<Vec3> own = positionsOf(aggregate, objectsInBox(aggregate, *region.box));
        const std::vector<Vec3> there = body->places->at(own, m_ground.control);
        held.insert(held.end(), own.begin(), own.end());
        places.insert(places.end(), there.begin(), there.end());
    }
    const Vec3 before = region.box->center();
    if (held.empty()) { // nothing but surface
        held = {before};
        places = {placeOnPart(m_ground.bodies, before)};
    }
    region.box = boxAround(boxOfPlaces(places), *region.box, boxOfPlaces(held), m_vectors);
    note(region, *bodies.front(), what, middleOfPlaces(held), middleOfPlaces(places));
    return true;
}

bool MovedRegions::moveObjects(RecipeRegion& region, const BodyMap& body, const Message& what)
{
    const RecipeObjects& objects = *region.objects;
    if (objects.isFilledAnew)
        return leaveOut(what, Message("Transfer", "It names objects of a body that had been filled anew by then, which "
                                                  "another part does not have."));
    const Aggregate& after = *m_ground.after.scene.bodies[body.after].aggregate;
    const std::vector<Vec3> held = positionsOf(*m_ground.before.scene.bodies[body.before].aggregate, objects.numbers);
    const std::vector<Vec3> wanted = body.places->at(held, m_ground.control);
    const std::vector<Vec3> nodes = after.lattice.positions();
    const std::vector<ObjectIndex> nearest =
        nearestPoints(VectorArray(nodes), VectorArray(wanted), after.lattice.spacing);
    std::vector<ObjectIndex> numbers;
    std::vector<Vec3> found;
    for (std::size_t i = 0; i < nearest.size(); ++i)
        if ((nodes[nearest[i]] - wanted[i]).norm() <= farthestObject * after.lattice.spacing) {
            numbers.push_back(nearest[i]);
            found.push_back(nodes[nearest[i]]);
        }
    if (numbers.empty())
        return leaveOut(what, Message("Transfer", "There is no material in its place."));
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    region.objects = RecipeObjects{std::move(numbers), after.size(), false};
    note(region, body, what, middleOfPlaces(held), middleOfPlaces(found));
    return true;
}

void MovedRegions::note(const RecipeRegion& region, const BodyMap& body, const Message& what, const Vec3& before,
                        const Vec3& after)
{
    m_report.moved.push_back({what, after - before});
    m_beyond[region.name] = body.places->beyond(before);
}

void MovedRegions::moveTurn(const std::string& fixture, GripTurn& turn) const
{
    const auto beyond = m_beyond.find(fixture);
    turn.center = m_ground.base.at(turn.center) + (beyond == m_beyond.end() ? Vec3(Vec3::Zero()) : beyond->second);
    turn.angularVelocity = m_vectors.spun(turn.angularVelocity);
}

} // namespace knead
