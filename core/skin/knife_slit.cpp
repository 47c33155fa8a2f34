#include "core/skin/knife_slit.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/crack_lips.h"
#include "core/skin/skin_map.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double flat = 0.1;      // by which a cut may be off its plane [spacings]
constexpr double beyond = 2;      // it goes on so far behind the last connections, which end below the skin [spacings]
constexpr double slack = 1;       // by which connections that hold may lie on the wrong side of the tip [spacings]
constexpr int directions = 180;   // that a tip is looked for in
constexpr double nearPlane = 2.5; // what is nearer is carried by its own side alone [spacings]
constexpr double farPlane = 3.5;  // and what is farther by the whole

/// Places where connections cross a plane, in its two axes.
struct Crossings {
    std::vector<Vec2> open;
    std::vector<Vec2> closed;
};

double smoothStep(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * t * (t * (6 * t - 15) + 10);
}

/// What all other places are on one side of, as far as can be.
struct Tip {
    double angle = 0;
    double place = 0; ///< along the direction of the angle
    double gap = -std::numeric_limits<double>::infinity();
};

Tip tipBetween(const Crossings& crossings)
{
    Tip best;
    for (int i = 0; i < 2 * directions; ++i) {
        const double angle = i * std::numbers::pi / directions;
        const Vec2 direction(std::cos(angle), std::sin(angle));
        double open = std::numeric_limits<double>::infinity();
        double closed = -open;
        for (const Vec2& place : crossings.open)
            open = std::min(open, direction.dot(place));
        for (const Vec2& place : crossings.closed)
            closed = std::max(closed, direction.dot(place));
        if (open - closed > best.gap)
            best = {angle, (open + closed) / 2, open - closed};
    }
    return best;
}

} // namespace

std::optional<KnifeSlit> findKnifeSlit(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
{
    const Lattice& lattice = aggregate.lattice;
    const double spacing = lattice.spacing;
    if (aggregate.former || broken.empty() ||
        !std::ranges::all_of(broken, [](const BrokenConnection& one) { return one.isCut(); }))
        return {};
    const Pieces pieces = findPieces(aggregate, broken);
    if (pieces.count != findPieces(aggregate).count)
        return {};
    const CrackLips lips(aggregate, pieces, broken);
    if (lips.isEmpty())
        return {};

    std::vector<Vec3> places;
    for (const BrokenConnection& one : broken)
        places.push_back(lattice.position(one.lower) + one.cutAt * lattice.direction(static_cast<int>(one.direction)));
    const Vec3 middle = std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero())) / double(places.size());
    Mat3 moments = Mat3::Zero();
    for (const Vec3& place : places)
        moments += (place - middle) * (place - middle).transpose();
    const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(moments).eigenvectors();
    const Vec3 normal = axes.col(0);
    if (!std::ranges::all_of(places,
                             [&](const Vec3& place) { return std::abs(normal.dot(place - middle)) < flat * spacing; }))
        return {};

    const auto inPlane = [&](const Vec3& place) {
        return Vec2(axes.col(2).dot(place - middle), axes.col(1).dot(place - middle));
    };
    Crossings crossings;
    Eigen::AlignedBox2d box;
    for (const Vec3& place : places) {
        crossings.open.push_back(inPlane(place));
        box.extend(crossings.open.back());
    }
    box.min().array() -= beyond * spacing;
    box.max().array() += beyond * spacing;
    std::vector<Vec2> holding; // wherever the plane goes
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    double lipAbove = 0; // votes for lip 1 of CrackLips
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex object, ObjectIndex other) {
        const Vec3 from = lattice.position(object);
        const Vec3 to = lattice.position(other);
        const double here = normal.dot(from - middle);
        const double there = normal.dot(to - middle);
        if (here * there >= 0)
            return;
        if ((isBroken[object] >> d & 1U) != 0) {
            lipAbove += (here > 0) == (lips.ofObject()[object] == 1) ? 1 : -1;
            return;
        }
        holding.push_back(inPlane(from + here / (here - there) * (to - from)));
        if (box.contains(holding.back()))
            crossings.closed.push_back(holding.back());
    });
    const bool hasTip = !crossings.closed.empty();
    Tip tip;
    if (hasTip)
        tip = tipBetween(crossings);
    if (hasTip && tip.gap < -slack * spacing)
        return {};
    const Vec2 opening(std::cos(tip.angle), std::sin(tip.angle));
    const Vec2 along(-opening.y(), opening.x());
    double first = std::numeric_limits<double>::infinity(); // along the opening, and to its sides
    double last = -first;
    double left = first;
    double right = last;
    for (const Vec2& place : crossings.open) {
        first = std::min(first, opening.dot(place) - beyond * spacing);
        last = std::max(last, opening.dot(place) + beyond * spacing);
        left = std::min(left, along.dot(place) - beyond * spacing);
        right = std::max(right, along.dot(place) + beyond * spacing);
    }
    if (hasTip)
        first = tip.place;
    if (std::ranges::any_of(holding, [&](const Vec2& place) {
            const double way = opening.dot(place);
            const double side = along.dot(place);
            return way > first + (hasTip ? slack * spacing : 0) && way < last && side > left && side < right;
        }))
        return {};
    const auto inSpace = [&](const Vec2& place) { return Vec3(axes.col(2) * place.x() + axes.col(1) * place.y()); };
    KnifeSlit slit{.origin = middle + inSpace(first * opening + (left + right) / 2 * along),
                   .opening = inSpace(opening),
                   .along = inSpace(along),
                   .length = last - first,
                   .halfTip = (right - left) / 2,
                   .hasTip = hasTip,
                   .spacing = spacing,
                   .lipOfObject = {}};
    const bool isTurned = slit.normal().dot(normal) < 0;
    const std::uint8_t above = (lipAbove > 0) != isTurned ? 1 : 0;
    for (const std::uint8_t lip : lips.ofObject())
        slit.lipOfObject.push_back(lip == above ? 2 : 1);
    return slit;
}

struct SlitMap::Part {
    Part(Aggregate own, std::vector<Vec3> displacements)
        : aggregate(std::move(own))
        , map(aggregate, std::move(displacements))
    {
    }
    Aggregate aggregate;
    SkinMap map;
};

class SlitMap::Side final : public SmoothMap {
public:
    Side(const SlitMap& map, std::size_t lip)
        : m_map(map)
        , m_lip(lip)
    {
    }
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        m_map.evaluate(points, places, m_lip);
    }
    double featureSize() const override { return m_map.featureSize(); }

private:
    const SlitMap& m_map;
    std::size_t m_lip;
};

SlitMap::SlitMap(const Aggregate& all, const KnifeSlit& slit, const std::vector<Vec3>& displacements)
    : m_slit(slit)
{
    Aggregate aggregate = all; // jobs leave out what can be found
    findSegments(aggregate.lattice);
    const Vec3 normal = slit.normal();
    std::array<std::vector<ObjectIndex>, 3> objects;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        objects[0].push_back(i);
        objects[slit.lipOfObject[i]].push_back(i);
    }
    // Connections from one side of the slit to the other are no more.
    std::vector<std::uint16_t> isBroken(aggregate.size(), 0);
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex object, ObjectIndex other) {
        const Vec3 from = aggregate.lattice.position(object) - slit.origin;
        const Vec3 to = aggregate.lattice.position(other) - slit.origin;
        const double here = normal.dot(from);
        const double there = normal.dot(to);
        if (here * there >= 0)
            return;
        const Vec3 place = from + here / (here - there) * (to - from);
        const double way = slit.opening.dot(place);
        if (way > 0 && way < slit.length && std::abs(slit.along.dot(place)) < slit.halfTip)
            isBroken[object] = static_cast<std::uint16_t>(isBroken[object] | 1U << d);
    });
    for (std::size_t part = 0; part < objects.size(); ++part) {
        objects[part] = firmOf(aggregate, objects[part], isBroken);
        m_parts[part] = std::make_unique<const Part>(extract(aggregate, objects[part], isBroken),
                                                     pickedOf(displacements, objects[part]));
        m_sides[part] = std::make_unique<const Side>(*this, part);
    }
}

SlitMap::~SlitMap() = default;

double SlitMap::shareOfLip(const Vec3& place, std::size_t lip) const
{
    const Vec3 from = place - m_slit.origin;
    const double way = m_slit.opening.dot(from);
    if (way <= 0 || way >= m_slit.length || std::abs(m_slit.along.dot(from)) >= m_slit.halfTip)
        return 0;
    const double height = (lip == 1 ? -1 : 1) * heightOf(place) / m_slit.spacing; // on the other side: less than 0
    const double near = 1 - smoothStep((height - nearPlane) / (farPlane - nearPlane));
    return near * (m_slit.hasTip ? smoothStep(way / m_slit.spacing) : 1);
}

void SlitMap::evaluate(std::span<const Vec3> points, std::span<Vec3> places) const
{
    evaluate(points, places, 0);
}

const SmoothMap& SlitMap::ofFace(std::span<const Vec3> places) const
{
    constexpr double rounding = 1e-10; // [m]
    if (std::ranges::all_of(places, [&](const Vec3& place) { return heightOf(place) < rounding; }))
        return *m_sides[1];
    if (std::ranges::all_of(places, [&](const Vec3& place) { return heightOf(place) > -rounding; }))
        return *m_sides[2];
    return *this;
}

void SlitMap::evaluate(std::span<const Vec3> points, std::span<Vec3> places, std::size_t lip) const
{
    std::vector<double> shares(points.size());
    std::array<std::vector<std::uint32_t>, 3> of; // points that each part has a share in
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::size_t own = lip != 0 ? lip : heightOf(points[i]) < 0 ? 1 : 2;
        shares[i] = shareOfLip(points[i], own);
        if (shares[i] < 1)
            of[0].push_back(i);
        if (shares[i] > 0)
            of[own].push_back(i);
    }
    std::vector<Vec3> sums(points.size(), Vec3::Zero()); // the places may be the points
    std::vector<Vec3> some;
    std::vector<Vec3> carried;
    for (std::size_t part = 0; part < of.size(); ++part) {
        some.clear();
        for (const std::uint32_t i : of[part])
            some.push_back(points[i]);
        carried.resize(some.size());
        if (!some.empty())
            m_parts[part]->map.evaluate(some, carried);
        for (std::size_t k = 0; k < some.size(); ++k) {
            const double share = shares[of[part][k]];
            sums[of[part][k]] += (part == 0 ? 1 - share : share) * carried[k];
        }
    }
    std::ranges::copy(sums, places.begin());
}

} // namespace knead
