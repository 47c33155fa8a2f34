#include "core/skin/opened_state.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin.h"
#include "core/vicinity/point_grid.h"

namespace knead {

namespace {

// The skin of the carriers smooths what it is given; doing it again with what is missing takes much of that back.
constexpr int corrections = 1;

std::vector<Vec3> restOf(const Aggregate& aggregate)
{
    std::vector<Vec3> places(aggregate.size());
    for (ObjectIndex i = 0; i < places.size(); ++i)
        places[i] = aggregate.lattice.position(i);
    return places;
}

VectorArray arrayOf(std::span<const Vec3> places)
{
    VectorArray array(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        array.set(i, places[i]);
    return array;
}

std::vector<Vec3> picked(std::span<const Vec3> values, const std::vector<ObjectIndex>& numbers)
{
    std::vector<Vec3> some;
    for (const ObjectIndex number : numbers)
        some.push_back(values[number]);
    return some;
}

std::vector<Vec3> skinned(const Skin& skin, std::span<const Vec3> displacements)
{
    std::vector<Vec3> places(skin.size());
    skin.evaluate(displacements, places);
    return places;
}

} // namespace

std::vector<BrokenConnection> brokenInFormer(const Aggregate& present, std::span<const BrokenConnection> broken)
{
    if (!present.former || broken.empty())
        return {};
    const Aggregate& carriers = *present.former->carriers();
    const VectorArray nodes = nodesOf(present);
    return carriedCracks({present, nodes, broken}, carriers, arrayOf(placesWhenFilled(present, restOf(carriers))));
}

std::optional<OpenedState> openedState(const Aggregate& present, std::span<const Vec3> displacements,
                                       std::span<const BrokenConnection> broken)
{
    if (!present.former)
        return {};
    const FormerShape& former = *present.former;
    OpenedState opened{former.carriers(), former.displacements(), brokenInFormer(present, broken)};
    const Aggregate& carriers = *opened.aggregate;
    const Pieces pieces = findPieces(carriers, opened.broken);
    const std::vector<Vec3> then = placesWhenFilled(present, restOf(carriers));
    const std::vector<ObjectIndex> nearest = nearestPoints(arrayOf(then), nodesOf(present), present.lattice.spacing);
    const std::vector<std::uint16_t> isBroken = brokenDirections(present, broken);
    const std::vector<std::uint16_t> wasBroken = brokenDirections(carriers, opened.broken);
    for (std::uint32_t piece = 0; piece < pieces.count; ++piece) {
        std::vector<ObjectIndex> own;
        std::vector<ObjectIndex> now;
        for (ObjectIndex i = 0; i < carriers.size(); ++i)
            if (pieces.ofObject[i] == piece)
                own.push_back(i);
        for (ObjectIndex i = 0; i < nearest.size(); ++i)
            if (pieces.ofObject[nearest[i]] == piece)
                now.push_back(i);
        if (now.empty())
            return {};
        const std::vector<Vec3> wanted = skinned(
            Skin::ofPlacesWhenFilled(extract(present, now, isBroken), picked(then, own)), picked(displacements, now));
        const Aggregate part = extract(carriers, own, wasBroken);
        const Skin skin(part, restOf(part));
        std::vector<Vec3> moved = picked(opened.displacements, own);
        for (int n = 0; n <= corrections; ++n) {
            const std::vector<Vec3> places = skinned(skin, moved);
            for (std::size_t i = 0; i < own.size(); ++i)
                moved[i] += wanted[i] - places[i];
        }
        for (std::size_t i = 0; i < own.size(); ++i)
            opened.displacements[own[i]] = moved[i];
    }
    return opened;
}

} // namespace knead
