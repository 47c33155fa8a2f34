#include "core/skin/fragments.h"

#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/pieces.h"
#include "core/geometry/disjoint_sets.h"
#include "core/geometry/mass_properties.h"
#include "core/skin/crack_lips.h"
#include "core/skin/crossings.h"
#include "core/skin/labeled_nodes.h"
#include "core/skin/skin.h"
#include "core/skin/surface_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr std::uint32_t none = 0xffffffffU;
constexpr int attempts = 4;
constexpr double leastMaterial = 0.25; // of a piece with a shape [cells]

// Cracks are shifted by this against the lattice, on whose planes surfaces like to lie [cells].
const Vec3 shift(0.0123, 0.0171, 0.0097);

/// Which piece each piece is part of: itself, or the one that it is the dust of.
std::vector<std::uint32_t> joinDust(const Aggregate& aggregate, const Pieces& pieces,
                                    std::span<const BrokenConnection> broken, const std::vector<std::uint8_t>& isDust)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> connections; // between dust and any other
    for (const ConnectionId& connection : broken) {
        const ObjectIndex upper = upperEnd(aggregate.lattice, connection);
        const std::uint32_t a = pieces.ofObject[connection.lower];
        const std::uint32_t b = pieces.ofObject[upper];
        if (a == b)
            continue;
        if (isDust[a] != 0)
            ++connections[{a, b}];
        if (isDust[b] != 0)
            ++connections[{b, a}];
    }
    std::vector<std::uint32_t> host(pieces.count, none);
    for (std::uint32_t piece = 0; piece < pieces.count; ++piece)
        if (isDust[piece] == 0)
            host[piece] = piece;
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        std::vector<std::uint32_t> next = host;
        std::vector<std::size_t> most(pieces.count, 0);
        for (const auto& [ends, count] : connections)
            if (host[ends.first] == none && host[ends.second] != none && count > most[ends.first]) {
                most[ends.first] = count;
                next[ends.first] = host[ends.second];
                isChanged = true;
            }
        host = std::move(next);
    }
    return host;
}

/// A part of the body before it broke, with the shells of the surface around it. Mostly its objects were connected; walls
/// thinner than a cell can leave several groups of objects in one shell.
struct Solid {
    std::vector<std::uint32_t> pieces; // ascending
    TriangleMesh skin;
};

/// Which shells belong together and to which solid.
class ShellOwners {
public:
    ShellOwners(const Aggregate& aggregate, const Pieces& solids, const TriangleMesh& skin)
        : m_shells(skin.vertices.size())
        , m_ownerOfSolid(solids.count, none)
    {
        for (const TriangleMesh::Triangle& t : skin.triangles) {
            m_shells.join(t[0], t[1]);
            m_shells.join(t[1], t[2]);
        }
        const LatticeRows objects(aggregate.lattice);
        std::map<std::size_t, std::map<std::uint32_t, std::size_t>> votes; // by shell and solid
        for (const TriangleMesh::Triangle& t : skin.triangles) {
            const ObjectIndex object = objects.nearest(aggregate.lattice.coordinates(skin.vertices[t[0]]));
            ++votes[m_shells.find(t[0])][solids.ofObject[object]];
        }
        // A shell is of the solid that most of its corners are near; a solid without a shell is part of the one whose
        // shell is around it.
        for (const auto& [shell, count] : votes) {
            const auto most =
                std::ranges::max_element(count, [](const auto& a, const auto& b) { return a.second < b.second; });
            m_solidOfShell[shell] = most->first;
            m_ownerOfSolid[most->first] = most->first;
        }
        std::vector<std::size_t> most(solids.count, 0);
        for (const auto& [shell, count] : votes)
            for (const auto& [solid, corners] : count)
                if (m_ownerOfSolid[solid] != solid && corners > most[solid]) {
                    most[solid] = corners;
                    m_ownerOfSolid[solid] = m_solidOfShell[shell];
                }
        for (std::uint32_t& owner : m_ownerOfSolid)
            if (owner == none)
                owner = m_solidOfShell.begin()->second;
    }

    std::uint32_t ofTriangle(const TriangleMesh::Triangle& t) { return m_solidOfShell[m_shells.find(t[0])]; }
    std::uint32_t ofSolid(std::uint32_t solid) const { return m_ownerOfSolid[solid]; }

private:
    DisjointSets m_shells; // of vertices
    std::map<std::size_t, std::uint32_t> m_solidOfShell;
    std::vector<std::uint32_t> m_ownerOfSolid;
};

/// The solids that a body was before it broke, some of them without pieces: those that are part of another.
std::vector<Solid> findSolids(const Aggregate& aggregate, const Pieces& pieces, const TriangleMesh& skin)
{
    const Pieces before = findPieces(aggregate);
    if (before.count == 1) {
        Solid all{.pieces = std::vector<std::uint32_t>(pieces.count), .skin = skin};
        std::iota(all.pieces.begin(), all.pieces.end(), 0U);
        return {std::move(all)};
    }
    ShellOwners owners(aggregate, before, skin);
    std::vector<Solid> solids(before.count);
    std::vector<std::uint8_t> isKnown(pieces.count, 0);
    for (std::size_t object = 0; object < aggregate.size(); ++object) {
        const std::uint32_t piece = pieces.ofObject[object];
        if (isKnown[piece] == 0)
            solids[owners.ofSolid(before.ofObject[object])].pieces.push_back(piece);
        isKnown[piece] = 1;
    }
    std::vector<std::uint32_t> number(skin.vertices.size(), none);
    for (std::size_t i = 0; i < skin.triangles.size(); ++i) {
        TriangleMesh& mesh = solids[owners.ofTriangle(skin.triangles[i])].skin;
        TriangleMesh::Triangle triangle = skin.triangles[i];
        for (std::uint32_t& vertex : triangle) {
            if (number[vertex] == none) {
                number[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(skin.vertices[vertex]);
            }
            vertex = number[vertex];
        }
        mesh.triangles.push_back(triangle);
        if (!skin.faceOfTriangle.empty())
            mesh.faceOfTriangle.push_back(skin.faceOfTriangle[i]);
    }
    return solids;
}

class Breaker {
public:
    Breaker(const Aggregate& aggregate, const TriangleMesh& skin, std::span<const BrokenConnection> broken,
            Pieces pieces, const CrackLips& lips, const FragmentOptions& options)
        : m_aggregate(aggregate)
        , m_broken(broken)
        , m_pieces(std::move(pieces))
        , m_lips(lips)
        , m_solids(findSolids(aggregate, m_pieces, skin))
        , m_sizes(m_pieces.count, 0)
        , m_isDust(m_pieces.count, 0)
        , m_mesh(m_pieces.count)
        , m_isUncut(m_pieces.count, 0)
        , m_lipOfVertex(m_pieces.count)
    {
        for (const std::uint32_t piece : m_pieces.ofObject)
            ++m_sizes[piece];
        for (const Solid& solid : m_solids)
            for (const std::uint32_t piece : solid.pieces)
                m_isDust[piece] = piece != largest(solid) && m_sizes[piece] < options.leastObjects ? 1 : 0;
    }

    std::vector<Fragment> fragments(TaskControl& control)
    {
        joinAllDust();
        for (std::size_t i = 0; i < m_solids.size(); ++i) {
            TaskPortion portion = TaskPortion::ofItem(control, i, m_solids.size());
            cut(m_solids[i], portion);
        }
        std::vector<Fragment> result;
        std::vector<std::uint32_t> place(m_pieces.count, none);
        for (std::uint32_t piece = 0; piece < m_pieces.count; ++piece)
            if (m_isDust[piece] == 0) {
                place[piece] = static_cast<std::uint32_t>(result.size());
                Fragment fragment{.mesh = std::move(m_mesh[piece]), .objects = {}, .dust = {}};
                fragment.volume = massProperties(fragment.mesh).volume;
                fragment.isUncut = m_isUncut[piece] != 0;
                fragment.lipOfVertex = std::move(m_lipOfVertex[piece]);
                result.push_back(std::move(fragment));
            }
        for (ObjectIndex object = 0; object < m_aggregate.size(); ++object) {
            const std::uint32_t piece = m_pieces.ofObject[object];
            Fragment& fragment = result[place[m_host[piece]]];
            (m_isDust[piece] == 0 ? fragment.objects : fragment.dust).push_back(object);
            if (m_isDust[piece] == 0 && !fragment.lipOfVertex.empty())
                fragment.lipOfObject.push_back(static_cast<std::uint8_t>(1 + m_lips.ofObject()[object]));
        }
        return result;
    }

private:
    /// Dust that never was connected to anything joins the largest piece in its shell.
    void joinAllDust()
    {
        m_host = joinDust(m_aggregate, m_pieces, m_broken, m_isDust);
        for (const Solid& solid : m_solids)
            for (const std::uint32_t piece : solid.pieces)
                if (m_host[piece] == none)
                    m_host[piece] = largest(solid);
    }

    /// The piece of most objects, of those that are not dust.
    std::uint32_t largest(const Solid& solid) const
    {
        const auto rank = [&](std::uint32_t piece) { return std::pair(m_isDust[piece] == 0, m_sizes[piece]); };
        return *std::ranges::max_element(solid.pieces,
                                         [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
    }

    std::size_t shapes(const Solid& solid) const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(solid.pieces, [&](std::uint32_t piece) { return m_isDust[piece] == 0; }));
    }

    /// Pieces that hardly any material is found for, all of whose objects are outside of the surface, become dust.
    void cut(const Solid& solid, TaskControl& control)
    {
        bool opensLips = hasLips(solid);
        while (shapes(solid) > 1 || opensLips) {
            std::vector<SewnMesh> meshes = tryToCut(solid, opensLips, control);
            if (meshes.empty() && std::exchange(opensLips, false))
                continue;
            if (meshes.empty())
                break;
            const double least = leastMaterial * std::pow(m_aggregate.lattice.spacing, 3);
            bool isComplete = true;
            for (const std::uint32_t piece : solid.pieces) {
                const bool isThere = std::ranges::any_of(meshes, [&](const SewnMesh& mesh) {
                    return mesh.piece == piece && massProperties(mesh.mesh).volume > least;
                });
                if (m_isDust[piece] == 0 && !isThere) {
                    m_isDust[piece] = 1;
                    isComplete = false;
                }
            }
            if (isComplete) {
                for (SewnMesh& mesh : meshes)
                    take(mesh, opensLips);
                return;
            }
            if (shapes(solid) == 0)
                break;
            joinAllDust();
        }
        keepWhole(solid);
    }

    /// A crack ends in one of the pieces of a solid.
    bool hasLips(const Solid& solid) const
    {
        if (m_lips.isEmpty())
            return false;
        std::vector<unsigned> seen(m_pieces.count, 0); // bits of both lips
        for (std::size_t object = 0; object < m_aggregate.size(); ++object)
            seen[m_pieces.ofObject[object]] |= 1U << m_lips.ofObject()[object];
        return std::ranges::any_of(solid.pieces, [&](std::uint32_t piece) { return seen[piece] == 3; });
    }

    void take(SewnMesh& sewn, bool opensLips)
    {
        const bool isOfBoth =
            opensLips && std::ranges::any_of(sewn.labelOfVertex, [&](std::uint32_t label) {
                return label != SewnMesh::manyLabels && lipOf(label) != lipOf(sewn.labelOfVertex.front());
            });
        std::vector<std::uint8_t>& lips = m_lipOfVertex[sewn.piece];
        if (isOfBoth) {
            lips.resize(sewn.mesh.vertices.size());
            for (std::size_t v = 0; v < lips.size(); ++v)
                if (const std::uint32_t label = sewn.labelOfVertex[v];
                    label != SewnMesh::manyLabels && m_lips.isBeside(sewn.mesh.vertices[v]))
                    lips[v] = static_cast<std::uint8_t>(1 + lipOf(label));
        }
        m_mesh[sewn.piece] = std::move(sewn.mesh);
    }

    // A label is a piece and a lip.
    static std::uint32_t lipOf(std::uint32_t label) { return label % 2; }

    /// By piece; empty where no attempt came to anything.
    std::vector<SewnMesh> tryToCut(const Solid& solid, bool opensLips, TaskControl& control) const
    {
        std::vector<std::uint8_t> isOfSolid(m_pieces.count, 0);
        for (const std::uint32_t piece : solid.pieces)
            isOfSolid[piece] = 1;
        std::vector<std::uint32_t> labels(m_aggregate.size(), LabeledNodes::noLabel);
        for (std::size_t object = 0; object < m_aggregate.size(); ++object)
            if (isOfSolid[m_pieces.ofObject[object]] != 0)
                labels[object] = 2 * m_host[m_pieces.ofObject[object]] + (opensLips ? m_lips.ofObject()[object] : 0U);
        for (const BrokenConnection& connection : m_broken) { // dust is of the lip beside it
            const ObjectIndex upper = upperEnd(m_aggregate.lattice, connection);
            for (const auto& [dust, other] : {std::pair(connection.lower, upper), std::pair(upper, connection.lower)})
                if (m_isDust[m_pieces.ofObject[dust]] != 0 && m_isDust[m_pieces.ofObject[other]] == 0 &&
                    labels[dust] / 2 == labels[other] / 2)
                    labels[dust] = labels[other];
        }
        const CutBorders cuts(m_aggregate, m_broken, labels);
        const LabelSeams seams{.pieceOf = [](std::uint32_t label) { return label / 2; },
                               .isOpen = [&](const Vec3& place) { return m_lips.isOpen(place); }};
        for (int attempt = 0; attempt < attempts; ++attempt)
            try {
                const LabeledNodes nodes(m_aggregate, labels, cuts, solid.skin, (1 + 0.3 * attempt) * shift, control);
                return cutByLabels(solid.skin, nodes, seams, static_cast<std::uint64_t>(attempt), control);
            } catch (const DegenerateCut&) { // another one may do
            }
        return {};
    }

    /// One piece with all the surface, and the others as its dust.
    void keepWhole(const Solid& solid)
    {
        if (solid.pieces.empty())
            return;
        const std::uint32_t kept = largest(solid);
        m_isUncut[kept] = shapes(solid) > 1 ? 1 : 0;
        m_mesh[kept] = solid.skin;
        for (const std::uint32_t piece : solid.pieces) {
            m_isDust[piece] = piece == kept ? 0 : 1;
            m_host[piece] = kept;
        }
    }

    const Aggregate& m_aggregate;
    std::span<const BrokenConnection> m_broken;
    Pieces m_pieces;
    const CrackLips& m_lips; ///< of cracks that end within a piece
    std::vector<Solid> m_solids;
    std::vector<std::size_t> m_sizes;                     // objects per piece
    std::vector<std::uint8_t> m_isDust;                   // per piece
    std::vector<std::uint32_t> m_host;                    // per piece: itself, or what it is the dust of
    std::vector<TriangleMesh> m_mesh;                     // per piece
    std::vector<std::uint8_t> m_isUncut;                  // per piece
    std::vector<std::vector<std::uint8_t>> m_lipOfVertex; // per piece; see Fragment
};

} // namespace

std::vector<Fragment> fragmentsOf(const Aggregate& aggregate, const TriangleMesh& skin,
                                  std::span<const BrokenConnection> broken, const FragmentOptions& options,
                                  TaskControl& control)
{
    if (aggregate.size() == 0)
        throw std::invalid_argument("fragmentsOf: the aggregate has no objects");
    if (!isWatertight(skin))
        throw std::invalid_argument("fragmentsOf: the surface is not closed");
    Pieces pieces = findPieces(aggregate, broken);
    const std::size_t before = findPieces(aggregate).count;
    // What was never connected is no piece: where nothing has come apart only a body in one piece is looked at.
    const bool mayHaveLips = options.opensCracks && (before == 1 || pieces.count > before);
    const CrackLips lips(aggregate, pieces, mayHaveLips ? broken : std::span<const BrokenConnection>());
    if (pieces.count == before && lips.isEmpty()) {
        std::vector<ObjectIndex> all(aggregate.size());
        std::iota(all.begin(), all.end(), 0U);
        Fragment whole{.mesh = skin, .objects = std::move(all), .dust = {}};
        whole.volume = massProperties(skin).volume;
        return {std::move(whole)};
    }
    return Breaker(aggregate, skin, broken, std::move(pieces), lips, options).fragments(control);
}

std::vector<std::uint32_t> fragmentOfObjects(const Aggregate& aggregate, const std::vector<Fragment>& fragments)
{
    std::vector<std::uint32_t> of(aggregate.size(), 0);
    for (std::uint32_t f = 0; f < fragments.size(); ++f)
        for (const std::vector<ObjectIndex>* objects : {&fragments[f].objects, &fragments[f].dust})
            for (const ObjectIndex object : *objects)
                of[object] = f;
    return of;
}

} // namespace knead
