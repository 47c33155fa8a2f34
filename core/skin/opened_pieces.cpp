#include "core/skin/opened_pieces.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/fragments.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <utility>

namespace knead {

OpenedPieces openedPieces(const Aggregate& present, const TriangleMesh& opened,
                          std::span<const BrokenConnection> broken, std::span<const GrownTogether> healed,
                          TaskControl& control, const FragmentOptions& options)
{
    OpenedPieces all;
    if (present.former && present.former->carriers()->former)
        return all; // its cracks are not followed back so far
    const Aggregate& first = firstFillingOf(present);
    all.parting = brokenInFirst(present, broken, healed);
    std::vector<Fragment> fragments = fragmentsOf(first, opened, all.parting, options, control);
    all.isUnknown = std::ranges::any_of(fragments, &Fragment::isUncut);
    if (fragments.size() < 2 && fragments.front().lipOfVertex.empty())
        return all;
    std::vector<std::uint8_t> lipOfFirst(first.size(), 0);
    all.ofFirst = fragmentOfObjects(first, fragments);
    const std::vector<std::uint16_t> isBroken = brokenDirections(first, all.parting);
    for (Fragment& fragment : fragments) {
        std::vector<ObjectIndex> carriers = carriersOf(first, fragment, isBroken);
        all.pieces.push_back({.mesh = std::move(fragment.mesh),
                              .carriers = std::move(carriers),
                              .present = {},
                              .dust = fragment.dust.size(),
                              .lipOfVertex = std::move(fragment.lipOfVertex)});
        if (fragment.lipOfObject.empty())
            continue;
        for (std::size_t i = 0; i < fragment.objects.size(); ++i)
            lipOfFirst[fragment.objects[i]] = fragment.lipOfObject[i];
        all.pieces.back().lipOfCarrier = pickedOf(lipOfFirst, all.pieces.back().carriers);
    }
    std::erase_if(all.parting, [&](const BrokenConnection& one) {
        return all.ofFirst[one.lower] == all.ofFirst[upperEnd(first.lattice, one)];
    });
    if (!present.former) {
        all.ofPresent = all.ofFirst;
        for (OpenedPiece& piece : all.pieces) {
            piece.present = piece.carriers;
            piece.lipOfPresent = piece.lipOfCarrier;
        }
        return all;
    }
    const std::vector<Vec3> then = firstFillingWhenFilled(present);
    const std::vector<ObjectIndex> nearest =
        nearestPoints(VectorArray(then), nodesOf(present), present.lattice.spacing);
    all.ofPresent = pickedOf(all.ofFirst, nearest);
    for (ObjectIndex i = 0; i < all.ofPresent.size(); ++i) {
        OpenedPiece& piece = all.pieces[all.ofPresent[i]];
        piece.present.push_back(i);
        if (!piece.lipOfVertex.empty())
            piece.lipOfPresent.push_back(lipOfFirst[nearest[i]]);
    }
    const auto isLost = [](const OpenedPiece& piece) { return piece.present.empty(); };
    if (std::ranges::any_of(all.pieces, isLost)) {
        all.pieces.clear();
        all.isUnknown = true;
    }
    return all;
}

OpenedPieces piecesToShow(const Aggregate& present, const TriangleMesh& opened,
                          std::span<const BrokenConnection> broken, TaskControl& control,
                          const FragmentOptions& options)
{
    OpenedPieces all = openedPieces(present, opened, broken, {}, control, options);
    if (all.pieces.empty() && present.former && present.former->isInPieces())
        all = openedPieces(present, opened, {}, {}, control, options);
    return all;
}

Aggregate wholePiece(const Aggregate& aggregate, std::span<const ObjectIndex> objects)
{
    return extract(aggregate, objects, std::vector<std::uint16_t>(aggregate.size(), 0));
}

} // namespace knead
