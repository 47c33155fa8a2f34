#include "core/aggregate/wall_measure.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double step = 0.5;      // [cells]
constexpr double unclear = 2.25;  // cells more on one side of a cell than on the other, of the nine there
constexpr double emptySkin = 1.5; // [cells]: cells at the skin may hold too little to be kept

// Where one passes over to the other.
struct Passage {
    double from;
    double to;

    /// 0 up to `from`, 1 beyond `to`, smooth.
    double at(double x) const
    {
        const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
        return s * s * (3 - 2 * s);
    }
};

constexpr Passage toThick{thickestThinWall - 1, thickestThinWall + 1}; // [cells]
constexpr Passage toLumps{2.5, 3.5};                                   // [cells]
constexpr Passage toWalls{1.45, 1.95};                                 // how far it goes on, by its thickness

} // namespace

double WallMeasure::share(const Lattice::Node& cell) const
{
    Vec3 inwards = Vec3::Zero();
    for (std::int32_t u = -1; u <= 1; ++u)
        for (std::int32_t v = -1; v <= 1; ++v) {
            const CutCells::Row row = m_finder.row(cell[0] + u, cell[1] + v);
            for (std::int32_t w = -1; w <= 1; ++w)
                inwards += CellFinder::fraction(row, cell[2] + w) * Vec3(u, v, w);
        }
    return inwards.cwiseAbs().maxCoeff() < unclear ? 1 : share(cell, inwards);
}

double WallMeasure::share(const Lattice::Node& cell, const Vec3& inwards) const
{
    const Vec3 direction = inwards.normalized();
    const Chord chord = across(Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5), direction);
    const double thin = 1 - toThick.at(chord.length);
    const double lump = toLumps.at(chord.length);
    if (thin == 0 || lump == 0)
        return thin;
    const double most = toWalls.to * chord.length;
    return thin * (1 - lump * (1 - toWalls.at(goesOn(chord.middle, direction, most) / chord.length)));
}

/// Through what there is behind the skin, up to where it matters no more.
WallMeasure::Chord WallMeasure::across(const Vec3& place, const Vec3& inwards) const
{
    Chord chord{.length = 0, .middle = Vec3::Zero()};
    const auto add = [&](double at) {
        const double part = step * fractionAt(place + at * inwards);
        chord.length += part;
        chord.middle += part * (place + at * inwards);
        return part > 0;
    };
    double at = 0;
    while (!add(at) && at < emptySkin)
        at += step;
    while (chord.length < toThick.to && add(at += step)) {}
    for (at = -step; at >= -emptySkin && add(at); at -= step) {}
    if (chord.length > 0)
        chord.middle /= chord.length;
    return chord;
}

/// How far material goes on one way.
double WallMeasure::along(const Vec3& place, const Vec3& direction, double most) const
{
    double length = 0;
    for (double at = step / 2; length < most; at += step) {
        const double part = step * fractionAt(place + at * direction);
        if (part == 0)
            break;
        length += part;
    }
    return length;
}

/// How far it goes on both ways together, along itself, where it does so most.
double WallMeasure::goesOn(const Vec3& place, const Vec3& across, double most) const
{
    Eigen::Index least = 0;
    across.cwiseAbs().minCoeff(&least);
    const Vec3 first = across.cross(Vec3::Unit(least)).normalized();
    const Vec3 second = across.cross(first);
    double longest = 0;
    for (const Vec3& direction :
         {first, second, Vec3((first + second) / std::sqrt(2)), Vec3((first - second) / std::sqrt(2))}) {
        const double oneWay = along(place, direction, most);
        longest = std::max(longest, oneWay + along(place, -direction, most - oneWay));
        if (longest >= most)
            break;
    }
    return longest;
}

double WallMeasure::fractionAt(const Vec3& place) const
{
    return m_finder.fraction({static_cast<std::int32_t>(std::floor(place[0])),
                              static_cast<std::int32_t>(std::floor(place[1])),
                              static_cast<std::int32_t>(std::floor(place[2]))});
}

} // namespace knead
