// What the points of skins press and hold with. Part of SurfaceContacts.
#include "core/mechanics/surface_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Stiffness of a point by the shear modulus times its area over the spacing: six times that of a layer of cells, so that what is
// pressed lightly gives way in its material and hardly at its skin.
constexpr double stiffnessShare = 16;
// What the points around an object add up to at most, by the stiffness of a contact (StructuralConnections::contactStiffness(), 6 mu V
// / a^2): that of a flat face. Objects at edges and corners have less mass for the area that they carry.
constexpr double mostAround = stiffnessShare / 3;
// In explicit schemes also no more than this share of the stiffness of the shortest waves in its material, (11 mu + lambda) V / a^2:
// steps get shorter by a third.
constexpr double mostOfWaves = 0.7;

// Overlap at which the force is twice that of a linear spring, and beyond which the spring gets no stiffer [spacings]. A tenth of a
// spacing bears 4 k a = 64 mu. More would take more iterations of the implicit scheme.
constexpr double stiffeningShare = 0.034;
constexpr double steepestShare = 0.1;

// All points of a rigid body together are so stiff by what the deformable ones' time step allows its mass, and each of them
// gets so many times as stiff.
constexpr double rigidShare = 0.05;
constexpr double rigidStiffening = 10;

// Ends of broken connections do not stiffen and bear no more than at this overlap: what crumbled between two edges does not hold them
// apart, and is not shot away [spacings].
constexpr double mostLoose = 0.25;

// What sticks to a surface comes off at this gap: less would peel off from its edges, one point after the other [spacings].
constexpr double adhesionReach = 0.1;

// What is put into material pushes it out at this share of the speed of sound: a strain of a hundredth.
constexpr double pushShare = 0.01;

/// What the points around an object may add up to in explicit schemes, by the stiffness of a contact.
double mostInSteps(const Material& material)
{
    const double nu = material.poissonRatio;
    return mostOfWaves * (11 + 2 * nu / (1 - 2 * nu)) / 6;
}

/// With what mass scaling adds [kg/m^3].
double densityOf(const ContactBody& body, ObjectIndex object)
{
    return body.state->mass[object] / body.connections->aggregate().volume[object];
}

double massOf(const ObjectState& state)
{
    double mass = 0;
    for (std::size_t i = 0; i < state.size(); ++i)
        mass += state.mass[i];
    return mass;
}

} // namespace

/// By which friction follows the pressure: that of shear waves through the body [s].
double SurfaceContacts::crossingTime(const ContactBody& body, std::uint32_t index, const Material& material) const
{
    if (body.kind != BodyKind::deformable)
        return 0;
    return m_widths[index] * std::sqrt(material.density / material.shearModulus());
}

void SurfaceContacts::updateParameters(std::span<const ContactBody> bodies, double frequency, bool isImplicit)
{
    m_isImplicit = isImplicit;
    std::vector<double> areas(bodies.size(), 0);
    std::vector<double> masses;
    for (const Point& point : m_points)
        areas[point.body] += point.area;
    for (const ContactBody& body : bodies)
        masses.push_back(body.kind == BodyKind::rigid ? massOf(*body.state) : 0);
    const auto stiffnessOf = [&](const Point& point) {
        const ContactBody& body = bodies[point.body];
        return stiffnessShare * body.materialOf(point.spread.main()).shearModulus() * point.area / body.spacing();
    };
    std::vector<std::vector<double>> around;
    for (const ContactBody& body : bodies)
        around.emplace_back(body.state->size(), 0);
    for (const Point& point : m_points) {
        if (!point.isSkin)
            continue;
        const double stiffness = stiffnessOf(point);
        for (std::uint32_t n = 0; n < point.spread.count; ++n)
            around[point.body][point.spread.objects[n]] += std::abs(point.spread.weights[n]) * stiffness;
    }
    for (Point& point : m_points) {
        const ContactBody& body = bodies[point.body];
        const Material& material = body.materialOf(point.spread.main());
        const bool springsAlone = body.kind == BodyKind::deformable && !body.connections->hasBulk() &&
                                  !body.connections->stiffensWhenSquashed();
        const double most = isImplicit && !springsAlone ? mostAround : std::min(mostAround, mostInSteps(material));
        const double a = body.spacing();
        const double own = 0.5 * densityOf(body, point.spread.main()) * point.area * a;
        double share = 1;
        for (std::uint32_t n = 0; point.isSkin && n < point.spread.count; ++n) {
            const ObjectIndex object = point.spread.objects[n];
            share = std::min(share, most * body.connections->contactStiffness(object) / around[point.body][object]);
        }
        double stiffness = share * stiffnessOf(point);
        double steepest = steepestShare * a;
        if (body.kind == BodyKind::rigid) {
            stiffness = std::min(stiffness, rigidShare * masses[point.body] * frequency * frequency * point.area /
                                                areas[point.body]);
            steepest = std::pow((rigidStiffening - 1) / 5, 0.25) * stiffeningShare * a;
        }
        point.parameters = {.stiffness = stiffness,
                            .damping = 2 * material.dampingRatio * std::sqrt(stiffness * own),
                            .friction = material.friction,
                            .stiffening = stiffeningShare * a,
                            .steepest = steepest,
                            .frictionDelay = crossingTime(body, point.body, material),
                            .mass = body.kind == BodyKind::rigid ? 0 : own};
        if (springsAlone || point.isLoose)
            point.parameters.stiffening = std::numeric_limits<double>::infinity();
        if (point.isLoose)
            point.parameters.largestOverlap = mostLoose * a;
        point.adhesionReach = adhesionReach * a;
        point.pushSpeed = point.isLoose ? 0 : pushShare * material.soundSpeed();
    }
    forgetSorting();
}

} // namespace knead
