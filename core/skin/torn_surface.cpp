#include "core/skin/torn_surface.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/former_shape.h"
#include "core/skin/opened_pieces.h"
#include "core/skin/surface_fit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace knead {

namespace {

/// Vertices in the order of their lips, and so the places where these begin.
std::array<std::size_t, 4> sortByLip(TriangleMesh& mesh, std::vector<std::uint8_t>& lips)
{
    std::array<std::size_t, 4> begins{};
    if (lips.empty()) {
        begins.fill(mesh.vertices.size());
        begins[0] = 0;
        return begins;
    }
    for (const std::uint8_t lip : lips)
        ++begins[lip + 1U];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::array<std::size_t, 4> next = begins;
    std::vector<std::uint32_t> number(lips.size());
    std::vector<Vec3> vertices(lips.size());
    for (std::size_t v = 0; v < lips.size(); ++v) {
        number[v] = static_cast<std::uint32_t>(next[lips[v]]++);
        vertices[number[v]] = mesh.vertices[v];
    }
    for (TriangleMesh::Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle)
            corner = number[corner];
    mesh.vertices = std::move(vertices);
    std::ranges::sort(lips);
    return begins;
}

/// Those of a lip; all of them for lip 0, which is none, and where it has none.
std::vector<ObjectIndex> ofLip(const std::vector<ObjectIndex>& objects, const std::vector<std::uint8_t>& lips,
                               std::uint8_t lip)
{
    std::vector<ObjectIndex> own;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (lip != 0 && lips[i] == lip)
            own.push_back(objects[i]);
    return own.empty() ? objects : own;
}

} // namespace

std::optional<TornSurface> tornSurface(const Aggregate& aggregate, const TriangleMesh& opened,
                                       std::span<const BrokenConnection> broken, TaskControl& control)
{
    TaskPortion breaking(control, 0, 0.5);
    OpenedPieces apart = piecesToShow(aggregate, opened, broken, breaking, {.opensCracks = true});
    if (apart.pieces.empty())
        return {};
    const Aggregate& first = firstFillingOf(aggregate);
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    TriangleMesh mesh;
    std::vector<std::uint8_t> lips;
    std::vector<Skin> skins;
    std::vector<std::vector<ObjectIndex>> numbers;
    const double count = static_cast<double>(apart.pieces.size());
    for (std::size_t p = 0; p < apart.pieces.size(); ++p) {
        OpenedPiece& piece = apart.pieces[p];
        const double done = static_cast<double>(p);
        TaskPortion attaching(control, 0.5 + 0.5 * done / count, 0.5 + 0.5 * (done + 1) / count);
        const std::array<std::size_t, 4> begins = sortByLip(piece.mesh, piece.lipOfVertex);
        append(mesh, piece.mesh);
        lips.insert(lips.end(), piece.lipOfVertex.begin(), piece.lipOfVertex.end());
        lips.resize(mesh.vertices.size(), 0);
        for (std::uint8_t lip = 0; lip < 3; ++lip) { // each is carried by what is on its side of the crack
            std::vector<Vec3> places(piece.mesh.vertices.begin() + static_cast<std::ptrdiff_t>(begins[lip]),
                                     piece.mesh.vertices.begin() + static_cast<std::ptrdiff_t>(begins[lip + 1U]));
            if (places.empty())
                continue;
            if (aggregate.former) {
                const std::vector<ObjectIndex> carriers = ofLip(piece.carriers, piece.lipOfCarrier, lip);
                const Skin then(wholePiece(first, carriers), places);
                then.evaluate(pickedOf(aggregate.former->displacements(), carriers), places);
            }
            numbers.push_back(ofLip(piece.present, piece.lipOfPresent, lip));
            if (lip != 0)
                numbers.back() = firmOf(aggregate, numbers.back(), isBroken);
            skins.push_back(
                Skin::ofPlacesWhenFilled(extract(aggregate, numbers.back(), isBroken), std::move(places), attaching));
        }
    }
    return TornSurface{std::move(mesh), Skin::joined(skins, numbers), std::move(lips)};
}

} // namespace knead
