#include "core/skin/gaping_part.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/message/number_text.h"
#include "core/skin/fragments.h"
#include "core/skin/torn_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace knead {

namespace {

/// How far the two sides of cracks gape [m], at most: what is between vertices that were one, along the outward normal there. 0 where
/// they touch or have gone into each other.
double gapeOf(const TriangleMesh& rest, const TriangleMesh& now)
{
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> together; // vertices by their place at rest
    for (std::size_t t = 0; t < rest.triangles.size(); ++t)
        if (rest.faceOfTriangle[t] == Fragment::crackFace)
            for (const std::uint32_t v : rest.triangles[t])
                if (auto& same = together[{rest.vertices[v].x(), rest.vertices[v].y(), rest.vertices[v].z()}];
                    std::ranges::find(same, v) == same.end())
                    same.push_back(v);
    double most = 0;
    for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
        if (rest.faceOfTriangle[t] != Fragment::crackFace)
            continue;
        const Vec3 normal = crossOf(now.vertices, now.triangles[t]).stableNormalized();
        for (const std::uint32_t v : now.triangles[t])
            for (const std::uint32_t other :
                 together[{rest.vertices[v].x(), rest.vertices[v].y(), rest.vertices[v].z()}])
                most = std::max(most, (now.vertices[other] - now.vertices[v]).dot(normal));
    }
    return most;
}

/// A surface whose vertices on a slit are a hair off its plane, each on the side that it is of.
TriangleMesh besideSlit(TriangleMesh mesh, const std::vector<std::uint8_t>& lips, const KnifeSlit& slit)
{
    constexpr double hair = 1e-3;     // [spacings]
    constexpr double nearPlane = 0.3; // what is nearer to it may be on the wrong side [spacings]
    const Vec3 normal = slit.normal();
    const auto heightOf = [&](std::size_t v) { return normal.dot(mesh.vertices[v] - slit.origin) / slit.spacing; };
    double secondIsAbove = 0;
    for (std::size_t v = 0; v < lips.size(); ++v)
        if (lips[v] != 0)
            secondIsAbove += lips[v] == 2 ? heightOf(v) : -heightOf(v);
    for (std::size_t v = 0; v < lips.size(); ++v) {
        const double side = (lips[v] == 2) == (secondIsAbove > 0) ? 1 : -1;
        if (const double height = heightOf(v); lips[v] != 0 && std::abs(height) < nearPlane && side * height < hair)
            mesh.vertices[v] += (side * hair - height) * slit.spacing * normal;
    }
    return mesh;
}

} // namespace

Part pieceOf(const Part& whole, TriangleMesh mesh, std::size_t number)
{
    Part piece;
    piece.name = whole.name + ", piece " + std::to_string(number);
    piece.path = whole.path + "/" + piece.name;
    piece.color = whole.color;
    piece.layer = whole.layer;
    piece.visible = whole.visible;
    piece.faces = whole.faces;
    piece.faces.emplace_back();
    const auto crack = static_cast<std::uint32_t>(piece.faces.size() - 1);
    for (std::uint32_t& face : mesh.faceOfTriangle)
        face = face < crack ? face : crack;
    const MassProperties properties = massProperties(mesh);
    piece.volume = properties.volume;
    piece.area = properties.area;
    piece.box = properties.box;
    piece.solids = piece.shells = 1;
    piece.watertight = piece.valid = true;
    piece.mesh = std::move(mesh);
    return piece;
}

std::optional<PartToExport> gaping(const PartToExport& whole, std::size_t mostTriangles, bool keepsFaces,
                                   TaskControl& control)
{
    constexpr double leastGape = 0.1; // [spacings]; what is less is seen by nobody
    const Aggregate& aggregate = *whole.aggregate;
    const double spacing = aggregate.lattice.spacing;
    auto torn = tornSurface(aggregate, refine(whole.part.mesh, spacing, mostTriangles), *whole.broken, control);
    if (!torn)
        return {};
    TriangleMesh now = torn->mesh;
    torn->skin.evaluate(whole.displacements, now.vertices);
    const double gape = gapeOf(torn->mesh, now);
    if (gape < leastGape * spacing)
        return {};
    const auto named = [&](TriangleMesh mesh) {
        PartToExport part{.part = pieceOf(whole.part, std::move(mesh), 1)};
        part.part.name = whole.part.name;
        part.part.path = whole.part.path;
        part.part.solids = whole.part.solids;
        part.part.shells = whole.part.shells;
        part.part.edges = whole.part.edges;
        part.before = {whole.part.volume, static_cast<int>(whole.part.faces.size()), whole.part.edges};
        part.density = whole.density;
        part.deformations = whole.deformations;
        part.remarks = whole.remarks;
        part.remarks.push_back(Message("Export", "\"%1\" is cut into or cracked, but in one piece: it gapes by %2 mm.")
                                   .with(whole.part.name, inDigits(1e3 * gape, 3)));
        return part;
    };
    if (auto slit = keepsFaces && whole.part.exact ? findKnifeSlit(aggregate, *whole.broken) : std::nullopt) {
        PartToExport part = named(besideSlit(std::move(torn->mesh), torn->lipOfVertex, *slit));
        part.part.exact = whole.part.exact;
        part.aggregate = whole.aggregate;
        part.displacements = whole.displacements;
        part.slit = std::make_shared<const KnifeSlit>(std::move(*slit));
        return part;
    }
    PartToExport part = named(std::move(now));
    part.reason = Message("Export", "a cut or crack ends in it, whose sides are no faces of the part.");
    if (whole.relaxed && aggregate.former) {
        part.remarks.push_back(Message("Export", "it was filled anew before: its fields are left out."));
    } else if (whole.relaxed) {
        std::vector<ObjectIndex> all(aggregate.size());
        std::iota(all.begin(), all.end(), 0U);
        const ObjectStrains body(aggregate, whole.displacements, *whole.relaxed, *whole.broken);
        const Aggregate parted = extract(aggregate, all, brokenDirections(aggregate, *whole.broken));
        const SkinStress stress(parted, torn->mesh, all, control);
        part.fields =
            std::make_shared<const SkinFields>(skinFields(torn->skin, stress, whole.displacements, body, whole.loaded));
    }
    return part;
}

} // namespace knead
