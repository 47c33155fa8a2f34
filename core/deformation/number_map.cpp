#include "core/deformation/number_map.h"

#include "core/message/message.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double unitSlack = 1e-9;
constexpr double mostRadians = 62.9;   // ten times around [rad]
constexpr double steepestEase = 1.875; // of the quintic, in its middle

/// 0 before 0, 1 behind 1, and between either a straight line or 6 t^5 - 15 t^4 + 10 t^3.
double profile(double t, bool eases)
{
    if (!eases)
        return t;
    const double c = std::clamp(t, 0.0, 1.0);
    return c * c * c * (c * (6 * c - 15) + 10);
}

/// Its integral from 0.
double profileIntegral(double t, bool eases)
{
    if (!eases)
        return t * t / 2;
    if (t <= 0)
        return 0;
    const double c = std::min(t, 1.0);
    return c * c * c * c * (c * (c - 3) + 2.5) + (t - c);
}

/// Of a line that bends: where it is, along and toward the side, and its angle.
struct LinePlace {
    double along = 0;
    double side = 0;
    double angle = 0;
};

/// The line that keeps its length, at a share of the zone.
LinePlace arcAt(double share, double length, double angle)
{
    const double turned = angle * share;
    if (std::abs(turned) < 1e-4) { // series: sin(a)/a, (1 - cos(a))/a
        const double s = share * length;
        return {s * (1 - turned * turned / 6), s * turned / 2 * (1 - turned * turned / 12), turned};
    }
    const double radius = length / angle;
    return {radius * std::sin(turned), radius * (1 - std::cos(turned)), turned};
}

/// The same where the angle follows the quintic: by Gauss's formula of ten points on each of four pieces.
LinePlace easedArcAt(double share, double length, double angle)
{
    static constexpr std::array<double, 5> nodes{0.14887433898163122, 0.43339539412924721, 0.67940956829902444,
                                                 0.86506336668898451, 0.97390652851717172};
    static constexpr std::array<double, 5> weights{0.29552422471475287, 0.26926671930999635, 0.21908636251598204,
                                                   0.14945134915058059, 0.06667134430868814};
    constexpr int pieces = 4;
    LinePlace at{0, 0, angle * profile(share, true)};
    const double half = share / (2 * pieces);
    for (int piece = 0; piece < pieces; ++piece)
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (const double sign : {-1.0, 1.0}) {
                const double turned = angle * profile(half * (2 * piece + 1 + sign * nodes[i]), true);
                at.along += weights[i] * std::cos(turned) * half * length;
                at.side += weights[i] * std::sin(turned) * half * length;
            }
    return at;
}

/// @param share of the zone: 0 at the first plane, 1 at the second one
LinePlace lineAt(double share, const NumberDeformation& d)
{
    if (!d.eases)
        return arcAt(share, d.length(), d.angle);
    const double within = std::clamp(share, 0.0, 1.0);
    LinePlace at = easedArcAt(within, d.length(), d.angle);
    const double beyond = (share - within) * d.length();
    at.along += beyond * std::cos(at.angle);
    at.side += beyond * std::sin(at.angle);
    return at;
}

void check(const NumberDeformation& d)
{
    const auto refuse = [](const Message& sentence) { throw Problem(sentence); };
    const auto isFinite = [](const Vec3& v) { return v.allFinite(); };
    if (!isFinite(d.origin) || !isFinite(d.axis) || !isFinite(d.side))
        refuse(Message("Deformation", "The axis of a deformation has a coordinate that is no number."));
    for (const double number : {d.from, d.to, d.angle, d.factor, d.shift, d.neutral, d.stays})
        if (!std::isfinite(number))
            refuse(Message("Deformation", "A deformation by number has a value that is no number."));
    if (!(d.to > d.from))
        refuse(
            Message("Deformation", "The second plane of a deformation must lie behind the first one, along its axis."));
    if (std::abs(d.axis.norm() - 1) > unitSlack || std::abs(d.side.norm() - 1) > unitSlack ||
        std::abs(d.axis.dot(d.side)) > unitSlack)
        refuse(Message("Deformation", "The side of a deformation must point across its axis."));
    if (std::abs(d.angle) > mostRadians)
        refuse(Message("Deformation",
                       "A bend or a twist goes around ten times at most: take a smaller angle, or a larger radius."));
    if (d.stays < 0 || d.stays > 1)
        refuse(Message(
            "Deformation",
            "What stays of a deformation lies between its planes: from 0 at the first one to 1 at the second one."));
    if (!(d.factor > 0))
        refuse(Message("Deformation", "The factor of a deformation must be larger than 0."));
    if (d.kind == NumberKind::stretch && d.eases && 1 + steepestEase * (d.factor - 1) <= 0)
        refuse(Message(
            "Deformation",
            "A gentle stretch cannot shorten to less than 0.47: the middle would fold. Take a larger factor, or do not "
            "ease it."));
}

/// A length over which the map is about quadratic.
double featureSizeOf(const NumberDeformation& d)
{
    constexpr double quietAngle = 0.5;
    double size = d.length();
    if (d.kind == NumberKind::bend || d.kind == NumberKind::twist)
        size = std::min(size, d.length() * quietAngle / std::max(std::abs(d.angle), quietAngle));
    return d.eases ? std::min(size, d.length() / 4) : size;
}

} // namespace

/// One zone's formula everywhere.
class NumberMap::OfZone final : public SmoothMap {
public:
    OfZone(const NumberMap& map, Zone zone)
        : m_map(map)
        , m_zone(zone)
    {
    }

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            places[i] = m_map.place(points[i], m_zone);
    }
    double featureSize() const override { return m_map.featureSize(); }

private:
    const NumberMap& m_map;
    Zone m_zone;
};

NumberMap::NumberMap(const NumberDeformation& deformation)
    : m_deformation(deformation)
{
    check(deformation);
    m_across = deformation.axis.cross(deformation.side);
    m_featureSize = featureSizeOf(deformation);
    for (const Zone zone : {Zone::before, Zone::between, Zone::behind})
        m_zones[static_cast<std::size_t>(zone)] = std::make_shared<const OfZone>(*this, zone);
}

void NumberMap::evaluate(std::span<const Vec3> points, std::span<Vec3> places) const
{
    for (std::size_t i = 0; i < points.size(); ++i)
        places[i] = place(points[i], zoneOf(along(points[i])));
}

const SmoothMap& NumberMap::ofFace(std::span<const Vec3> places) const
{
    if (m_deformation.eases || places.empty())
        return *this;
    double least = along(places.front());
    double most = least;
    for (const Vec3& place : places) {
        least = std::min(least, along(place));
        most = std::max(most, along(place));
    }
    const double slack = 1e-7 * m_deformation.length();
    if (most <= m_deformation.from + slack)
        return *m_zones[static_cast<std::size_t>(Zone::before)];
    if (least >= m_deformation.to - slack)
        return *m_zones[static_cast<std::size_t>(Zone::behind)];
    if (least >= m_deformation.from - slack && most <= m_deformation.to + slack)
        return *m_zones[static_cast<std::size_t>(Zone::between)];
    return *this;
}

NumberMap::Zone NumberMap::zoneOf(double along) const
{
    if (along <= m_deformation.from)
        return Zone::before;
    return along >= m_deformation.to ? Zone::behind : Zone::between;
}

Vec3 NumberMap::place(const Vec3& point, Zone zone) const
{
    const NumberDeformation& d = m_deformation;
    const Vec3 rest = point - d.origin;
    double along = d.axis.dot(rest) - d.from; // from the first plane
    double side = d.side.dot(rest);
    double across = m_across.dot(rest);
    const double length = d.length();
    const double share = zone == Zone::before ? 0 : zone == Zone::behind ? 1 : along / length;
    const double beyond = along - share * length; // from the place whose cross-section it moves with
    const double amount = profile(share, d.eases);
    const double stays = profile(d.stays, d.eases);
    switch (d.kind) {
    case NumberKind::bend: {
        const LinePlace now = lineAt(share, d);
        const LinePlace fixed = lineAt(d.stays, d);
        const double height = side - d.neutral;
        const double x = now.along + beyond * std::cos(now.angle) - height * std::sin(now.angle) - fixed.along;
        const double z = now.side + beyond * std::sin(now.angle) + height * std::cos(now.angle) - fixed.side;
        const double cosine = std::cos(fixed.angle);
        const double sine = std::sin(fixed.angle);
        along = d.stays * length + cosine * x + sine * z;
        side = d.neutral - sine * x + cosine * z;
        break;
    }
    case NumberKind::twist: {
        const double angle = d.angle * (amount - stays);
        const double turned = std::cos(angle) * side - std::sin(angle) * across;
        across = std::sin(angle) * side + std::cos(angle) * across;
        side = turned;
        break;
    }
    case NumberKind::taper: {
        const double factor = (1 + (d.factor - 1) * amount) / (1 + (d.factor - 1) * stays);
        side *= factor;
        across *= factor;
        break;
    }
    case NumberKind::stretch:
        along += (d.factor - 1) * length * (amount - stays);
        break;
    case NumberKind::shear:
        side += d.shift * (amount - stays);
        break;
    case NumberKind::scale: {
        const double now = 1 + (d.factor - 1) * amount;
        const double fixed = 1 + (d.factor - 1) * stays;
        const auto grown = [&](double to) { return length * (to + (d.factor - 1) * profileIntegral(to, d.eases)); };
        along = d.stays * length + (grown(share) + now * beyond - grown(d.stays)) / fixed;
        side *= now / fixed;
        across *= now / fixed;
        break;
    }
    }
    return d.origin + (d.from + along) * d.axis + side * d.side + across * m_across;
}

double profileOf(const NumberDeformation& deformation, double share)
{
    return profile(share, deformation.eases);
}

std::shared_ptr<const NumberMap> numberMap(const NumberDeformation& deformation)
{
    return std::make_shared<const NumberMap>(deformation);
}

} // namespace knead
