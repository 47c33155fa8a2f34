#include "core/mechanics/contact_listing.h"

#include "core/geometry/rigid_fit.h"

#include <algorithm>

namespace knead {

namespace {

// Candidates are listed this far ahead, in spacings: more means fewer lists, but longer ones.
constexpr double marginShare = 0.5;
// The same for points near surfaces where one that does not touch takes little: at least, and at most.
constexpr double leastSurfaceMarginShare = 0.25;
constexpr double surfaceMarginShare = 1.5;
// Those are listed for about so many explicit steps, and again after as many where by then half of the margin would do.
constexpr std::size_t stepsBetween = 128;
// So much further for steps of the implicit scheme.
constexpr double aheadShare = 1;
// A closer look at what has moved may find that so much of the margin is used up at most; else it would soon be due
// again.
constexpr double usedShare = 0.5;

} // namespace

ContactListing::ContactListing(std::span<const ContactBody> bodies)
{
    for (const ContactBody& body : bodies)
        m_margin = std::max(m_margin, marginShare * body.spacing());
}

void ContactListing::setScheme(std::span<const ContactBody> bodies, bool isImplicit)
{
    m_ahead = 0;
    for (const ContactBody& body : bodies)
        if (isImplicit)
            m_ahead = std::max(m_ahead, aheadShare * body.spacing());
    m_isImplicit = isImplicit;
    m_valid = false;
}

void ContactListing::lookAhead(bool takesLittle)
{
    m_mostSurfaceMargin = takesLittle && !m_isImplicit ? surfaceMarginShare / marginShare * m_margin : m_margin;
    m_surfaceMargin = wantedSurfaceMargin();
}

/// For as many steps as are wanted between lists, if things go on as they have gone since the last one. Knives are where they were when
/// points were listed: for them all stays as it is.
double ContactListing::wantedSurfaceMargin() const
{
    const bool takesLittle = m_mostSurfaceMargin > m_margin;
    if (!takesLittle || !m_valid || m_stepsToSurfaces == 0)
        return m_mostSurfaceMargin;
    const double perStep = m_travelToSurfaces / static_cast<double>(m_stepsToSurfaces);
    return std::clamp(static_cast<double>(stepsBetween) * perStep, leastSurfaceMarginShare / marginShare * m_margin,
                      m_mostSurfaceMargin);
}

void ContactListing::move(double travel, double surfaceTravel)
{
    m_travel += travel;
    m_travelToSurfaces += travel + surfaceTravel;
    ++m_stepsToSurfaces;
}

bool ContactListing::arePairsDue(const ContactObjects& objects, KeptLengths& kept)
{
    bool tooFar = 2 * m_travel > m_margin;
    if (m_valid && tooFar) {
        // A body that has flown off and back within one listing meets the others anew.
        const bool forgot = kept.forgetThoseApart(objects);
        m_travel = std::min(m_travel, travelTowardsOthers(objects));
        tooFar = forgot || 2 * m_travel > usedShare * m_margin;
    }
    return !m_valid || tooFar;
}

void ContactListing::listedPairs(const ContactObjects& objects)
{
    m_listedAt.clear();
    for (const ContactObject& object : objects)
        m_listedAt.push_back(objects.placeOf(object));
    m_travel = 0;
    ++m_count;
}

bool ContactListing::areSurfacesDue(std::size_t surfaces) const
{
    const bool isTooFar = m_travelToSurfaces > m_surfaceMargin;
    const bool isTooWide = m_stepsToSurfaces >= stepsBetween && 2 * wantedSurfaceMargin() < m_surfaceMargin;
    return !m_valid || isTooFar || isTooWide || surfaces != m_surfaceCount;
}

void ContactListing::listedSurfaces(std::size_t surfaces)
{
    m_surfaceCount = surfaces;
    m_travelToSurfaces = 0;
    m_stepsToSurfaces = 0;
}

/// How far objects may have moved towards each other since pairs were listed: where a body is alone, only what is no
/// rigid motion of all of it.
double ContactListing::travelTowardsOthers(const ContactObjects& objects) const
{
    struct Moved {
        std::vector<Vec3> before;
        std::vector<Vec3> after;
        Box reach;
        double farthest = 0;
    };
    std::vector<Moved> bodies(objects.bodies().size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const ContactObject& object = objects[i];
        if (object.radius == 0)
            continue;
        Moved& body = bodies[object.ref.body];
        body.before.push_back(m_listedAt[i]);
        body.after.push_back(objects.placeOf(object));
        const Vec3 around = Vec3::Constant(object.radius + m_margin + m_ahead);
        body.reach.extend(body.after.back() - around);
        body.reach.extend(body.after.back() + around);
        body.farthest = std::max(body.farthest, (body.after.back() - m_listedAt[i]).norm());
    }
    double travel = 0;
    for (const Moved& body : bodies) {
        const bool alone = std::none_of(bodies.begin(), bodies.end(), [&](const Moved& other) {
            return &other != &body && other.reach.intersects(body.reach);
        });
        travel = std::max(travel, alone ? deviationFromRigidMotion(body.before, body.after) : body.farthest);
    }
    return travel;
}

} // namespace knead
