#include "core/skin/carried_piece.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/mechanics/vector_array.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/former_shape.h"
#include "core/skin/opened_pieces.h"
#include "core/task/parallel.h"
#include "core/vicinity/point_grid.h"

#include <Eigen/Dense>

#include <limits>
#include <numeric>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t mostTriangles = 400'000; // of a surface that is made to bend
constexpr std::size_t placesPerBlock = 64;

CarriedPiece newPiece(TriangleMesh mesh, std::shared_ptr<const Aggregate> aggregate, std::vector<ObjectIndex> numbers,
                      std::span<const Vec3> displacements)
{
    CarriedPiece piece{.mesh = std::move(mesh), .aggregate = std::move(aggregate), .numbers = std::move(numbers)};
    piece.map = std::make_unique<const SkinMap>(
        *piece.aggregate, piece.numbers.empty() ? std::vector<Vec3>(displacements.begin(), displacements.end())
                                                : pickedOf(displacements, piece.numbers));
    piece.filled = placesWhenFilled(*piece.aggregate, piece.mesh.vertices);
    piece.now.resize(piece.mesh.vertices.size());
    piece.map->evaluate(piece.mesh.vertices, piece.now);
    return piece;
}

/// The former shape of one piece of a body that was filled anew.
std::shared_ptr<const FormerShape> formerOf(const OpenedPiece& piece, const Aggregate& whole)
{
    if (!whole.former)
        return nullptr;
    return std::make_shared<const FormerShape>(
        std::make_shared<const Aggregate>(wholePiece(firstFillingOf(whole), piece.carriers)),
        pickedOf(whole.former->displacements(), piece.carriers));
}

/// A body in one piece whose cracks nobody can see the sides of: it is carried along connections that hold.
CarriedPiece alongConnections(TriangleMesh mesh, const Aggregate& whole, std::span<const Vec3> displacements,
                              std::span<const BrokenConnection> broken)
{
    const std::vector<std::uint16_t> isBroken = brokenDirections(whole, broken);
    std::vector<ObjectIndex> all(whole.size());
    std::iota(all.begin(), all.end(), ObjectIndex{0});
    std::vector<ObjectIndex> firm = firmOf(whole, all, isBroken);
    Aggregate own = extract(whole, firm, isBroken);
    own.former = whole.former;
    return newPiece(std::move(mesh), std::make_shared<const Aggregate>(std::move(own)), std::move(firm), displacements);
}

/// X of one place, from where an object was.
Vec3 openedPlace(const SkinMap& map, const Vec3& place, const Vec3& start)
{
    constexpr int mostSteps = 30;
    const double enough = 1e-6 * map.featureSize();
    const double longestStep = 2 * map.featureSize();
    Vec3 opened = start;
    Vec3 best = start;
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0; step < mostSteps; ++step) {
        const Vec3 missing = place - map.at(opened);
        if (missing.norm() < least) {
            least = missing.norm();
            best = opened;
        }
        if (least <= enough)
            break;
        Vec3 way = map.gradient(opened).fullPivLu().solve(missing);
        if (const double length = way.norm(); length > longestStep)
            way *= longestStep / length;
        opened += way;
    }
    return best;
}

} // namespace

std::vector<CarriedPiece> carriedPieces(const TriangleMesh& surface, const std::shared_ptr<const Aggregate>& aggregate,
                                        std::span<const Vec3> displacements, std::span<const BrokenConnection> broken,
                                        TaskControl& control)
{
    TriangleMesh mesh = bendableSurface(surface, *aggregate, mostTriangles);
    const bool wasInPieces = aggregate->former && aggregate->former->isInPieces();
    std::vector<CarriedPiece> pieces;
    if (broken.empty() && !wasInPieces) {
        pieces.push_back(newPiece(std::move(mesh), aggregate, {}, displacements));
        return pieces;
    }
    OpenedPieces apart;
    if (isWatertight(mesh))
        apart = piecesToShow(*aggregate, mesh, broken, control);
    else
        apart.isUnknown = true;
    const std::vector<std::uint16_t> isBroken = brokenDirections(*aggregate, broken);
    for (OpenedPiece& piece : apart.pieces) {
        Aggregate own = extract(*aggregate, piece.present, isBroken);
        own.former = formerOf(piece, *aggregate);
        pieces.push_back(newPiece(std::move(piece.mesh), std::make_shared<const Aggregate>(std::move(own)),
                                  std::move(piece.present), displacements));
    }
    if (pieces.empty() && broken.size() < leastSeenBroken)
        pieces.push_back(newPiece(std::move(mesh), aggregate, {}, displacements));
    if (pieces.empty())
        pieces.push_back(alongConnections(std::move(mesh), *aggregate, displacements, broken));
    for (CarriedPiece& piece : pieces)
        piece.spansCracks = apart.isUnknown;
    return pieces;
}

std::vector<Vec3> openedPlaces(const CarriedPiece& piece, std::span<const Vec3> places)
{
    const std::vector<Vec3> starts = firstFillingOf(*piece.aggregate).lattice.positions();
    std::vector<Vec3> then(starts.size());
    piece.map->evaluate(starts, then);
    const std::vector<ObjectIndex> nearest =
        nearestPoints(VectorArray(then), VectorArray(places), piece.aggregate->lattice.spacing);
    std::vector<Vec3> opened(places.size());
    forEachBlock(places.size(), placesPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            opened[i] = openedPlace(*piece.map, places[i], starts[nearest[i]]);
    });
    return opened;
}

} // namespace knead
