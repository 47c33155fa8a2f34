#include "core/skin/torn_surface.h"

#include "core/aggregate/pieces.h"
#include "core/skin/former_shape.h"
#include "core/skin/opened_pieces.h"
#include "core/skin/surface_fit.h"

#include <utility>

namespace knead {

std::optional<TornSurface> tornSurface(const Aggregate& aggregate, const TriangleMesh& opened,
                                       std::span<const BrokenConnection> broken, TaskControl& control)
{
    TaskPortion breaking(control, 0, 0.5);
    const OpenedPieces apart = piecesToShow(aggregate, opened, broken, breaking);
    if (apart.pieces.empty())
        return {};
    const Aggregate& first = firstFillingOf(aggregate);
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    TriangleMesh mesh;
    std::vector<Skin> skins;
    std::vector<std::vector<ObjectIndex>> numbers;
    const double count = static_cast<double>(apart.pieces.size());
    for (const OpenedPiece& piece : apart.pieces) {
        const double done = static_cast<double>(skins.size());
        TaskPortion attaching(control, 0.5 + 0.5 * done / count, 0.5 + 0.5 * (done + 1) / count);
        append(mesh, piece.mesh);
        std::vector<Vec3> places = piece.mesh.vertices;
        if (aggregate.former)
            Skin(wholePiece(first, piece.carriers), piece.mesh.vertices)
                .evaluate(pickedOf(aggregate.former->displacements(), piece.carriers), places);
        numbers.push_back(piece.present);
        skins.push_back(
            Skin::ofPlacesWhenFilled(extract(aggregate, piece.present, isBroken), std::move(places), attaching));
    }
    return TornSurface{std::move(mesh), Skin::joined(skins, numbers)};
}

} // namespace knead
