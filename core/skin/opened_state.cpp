#include "core/skin/opened_state.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/disjoint_sets.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin.h"
#include "core/vicinity/point_grid.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace knead {

namespace {

// The skin of the carriers smooths what it is given; doing it again with what is missing takes much of that back.
constexpr int corrections = 1;
// A cut is a plane through so many known places of it.
constexpr std::size_t cutsAround = 8;
constexpr double nearestEnd = 1e-6; // of a cut, by the length of a connection

std::vector<Vec3> skinned(const Skin& skin, std::span<const Vec3> displacements)
{
    std::vector<Vec3> places(skin.size());
    skin.evaluate(displacements, places);
    return places;
}

/// Where knives went through connections of a filling.
std::vector<Vec3> placesOfCuts(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
{
    std::vector<Vec3> places;
    for (const BrokenConnection& one : broken)
        if (one.isCut())
            places.push_back(aggregate.lattice.position(one.lower) +
                             one.cutAt * aggregate.lattice.direction(static_cast<int>(one.direction)));
    return places;
}

/// What a former shape takes to some places, by Newton's method from the carrier that is nearest to each.
std::vector<Vec3> opened(const FormerShape& former, const std::vector<Vec3>& places, std::span<const Vec3> rest,
                         std::span<const Vec3> then)
{
    constexpr int steps = 6;
    const double spacing = former.carriers()->lattice.spacing;
    const double small = 1e-3 * spacing;
    std::vector<Vec3> found;
    for (const ObjectIndex nearest : nearestPoints(VectorArray(then), VectorArray(places), spacing))
        found.push_back(rest[nearest]);
    std::vector<Vec3> here(found.size());
    std::array<std::vector<Vec3>, 3> beside;
    for (int n = 0; n < steps; ++n) {
        former.evaluate(found, here);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            std::vector<Vec3>& moved = beside[static_cast<std::size_t>(axis)];
            moved = found;
            for (Vec3& place : moved)
                place[axis] += small;
            former.evaluate(std::vector<Vec3>(moved), moved);
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            Mat3 gradient;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                gradient.col(axis) = (beside[static_cast<std::size_t>(axis)][i] - here[i]) / small;
            const Vec3 step = gradient.partialPivLu().solve(places[i] - here[i]);
            if (step.allFinite())
                found[i] += std::min(1.0, spacing / (step.norm() + 1e-300)) * step;
        }
    }
    return found;
}

/// Has connections cut where the plane through the nearest of some places crosses them.
void cutExactly(const Aggregate& aggregate, const std::vector<Vec3>& cuts, std::vector<BrokenConnection>& broken)
{
    const Lattice& lattice = aggregate.lattice;
    const VectorArray points(cuts);
    const PointGrid grid(points, lattice.spacing);
    std::vector<PointGrid::Found> found;
    for (BrokenConnection& one : broken) {
        if (!one.isCut())
            continue;
        const Vec3 lower = lattice.position(one.lower);
        const Vec3 way = lattice.direction(static_cast<int>(one.direction));
        grid.nearest(lower + one.cutAt * way, cutsAround, found);
        Vec3 middle = Vec3::Zero();
        for (const PointGrid::Found& each : found)
            middle += cuts[each.point] / static_cast<double>(found.size());
        Mat3 spread = Mat3::Zero();
        for (const PointGrid::Found& each : found)
            spread += (cuts[each.point] - middle) * (cuts[each.point] - middle).transpose();
        const Vec3 normal = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
        const double along = way.dot(normal);
        if (std::abs(along) > 0.05 * way.norm())
            one.cutAt = std::clamp((middle - lower).dot(normal) / along, nearestEnd, 1 - nearestEnd);
    }
}

/// What parted the pieces that a body was filled from, but for those that have grown together.
std::vector<BrokenConnection> stillParted(const Aggregate& present, const std::vector<Vec3>& then,
                                          std::span<const BrokenConnection> broken,
                                          std::span<const GrownTogether> healed)
{
    const std::vector<BrokenConnection>& parted = present.former->broken();
    if (parted.empty() || healed.empty())
        return parted;
    const Pieces pieces = findPieces(present, broken);
    DisjointSets one(pieces.count);
    for (const auto& [first, second] : healed)
        one.join(pieces.ofObject[first], pieces.ofObject[second]);
    const Lattice& lattice = present.former->carriers()->lattice;
    const std::vector<ObjectIndex> nearest =
        nearestPoints(nodesOf(present), VectorArray(then), present.lattice.spacing);
    const auto pieceOf = [&](ObjectIndex carrier) { return one.find(pieces.ofObject[nearest[carrier]]); };
    std::vector<BrokenConnection> left;
    std::copy_if(parted.begin(), parted.end(), std::back_inserter(left),
                 [&](const BrokenConnection& each) { return pieceOf(each.lower) != pieceOf(upperEnd(lattice, each)); });
    return left;
}

} // namespace

std::vector<BrokenConnection> brokenInFirst(const Aggregate& present, std::span<const BrokenConnection> broken,
                                            std::span<const GrownTogether> healed)
{
    const VectorArray nodes = nodesOf(present);
    if (!present.former) {
        if (healed.empty()) {
            std::vector<BrokenConnection> all(broken.begin(), broken.end());
            std::ranges::sort(all);
            return all;
        }
        return carriedCracks({present, nodes, broken, healed}, present, nodes);
    }
    const Aggregate& carriers = *present.former->carriers();
    if (carriers.former || (broken.empty() && !present.former->isInPieces()))
        return {};
    const std::vector<Vec3> then = firstFillingWhenFilled(present);
    std::vector<BrokenConnection> all = stillParted(present, then, broken, healed);
    if (broken.empty())
        return all;
    std::vector<BrokenConnection> carried =
        carriedCracks({present, nodes, broken, healed}, carriers, VectorArray(then));
    const std::vector<Vec3> cut = placesOfCuts(present, broken);
    if (cut.size() >= cutsAround)
        cutExactly(carriers, opened(*present.former, cut, carriers.lattice.positions(), then), carried);
    // What leads from one of the former pieces to another is no concern of the present cracks.
    const Pieces parted = findPieces(carriers, present.former->broken());
    std::copy_if(carried.begin(), carried.end(), std::back_inserter(all), [&](const BrokenConnection& one) {
        return parted.ofObject[one.lower] == parted.ofObject[upperEnd(carriers.lattice, one)];
    });
    std::ranges::sort(all);
    return all;
}

std::optional<OpenedState> openedState(const Aggregate& present, std::span<const Vec3> displacements,
                                       std::span<const BrokenConnection> broken)
{
    if (!present.former || present.former->carriers()->former)
        return {};
    const FormerShape& former = *present.former;
    OpenedState opened{former.carriers(), former.displacements(), brokenInFirst(present, broken)};
    const Aggregate& carriers = *opened.aggregate;
    const Pieces pieces = findPieces(carriers, opened.broken);
    const std::vector<Vec3> then = firstFillingWhenFilled(present);
    const std::vector<ObjectIndex> nearest =
        nearestPoints(VectorArray(then), nodesOf(present), present.lattice.spacing);
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
        const std::vector<Vec3> wanted =
            skinned(Skin::ofPlacesWhenFilled(extract(present, now, isBroken), pickedOf(then, own)),
                    pickedOf(displacements, now));
        const Aggregate part = extract(carriers, own, wasBroken);
        const Skin skin(part, part.lattice.positions());
        std::vector<Vec3> moved = pickedOf(opened.displacements, own);
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
