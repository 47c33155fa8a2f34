#include "core/skin/torn_parts.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/message/number_text.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/former_shape.h"
#include "core/skin/fragments.h"
#include "core/skin/gaping_part.h"
#include "core/skin/opened_pieces.h"
#include "core/skin/skin_map.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace knead {

namespace {

/// What a person should know about a part that is cracked and in one piece: where and how far its skin is stretched.
Message crackRemark(const PartToExport& part)
{
    const Lattice& lattice = part.aggregate->lattice;
    double most = 0;
    Vec3 where = Vec3::Zero();
    for (const ConnectionId& connection : *part.broken) {
        const ObjectIndex upper = upperEnd(lattice, connection);
        const Vec3 rest = lattice.direction(static_cast<int>(connection.direction));
        const Vec3 opened = part.displacements[upper] - part.displacements[connection.lower];
        if (const double stretch = (rest + opened).norm() / rest.norm(); stretch > most) {
            most = stretch;
            where = 1e3 *
                    (lattice.position(connection.lower) + part.displacements[connection.lower] + 0.5 * (rest + opened));
        }
    }
    const std::size_t count = part.broken->size();
    const std::string stretch = inDigits(most, 3);
    const Message place = Message::verbatim("(%1, %2, %3) mm")
                              .with(inDigits(where.x(), 3), inDigits(where.y(), 3), inDigits(where.z(), 3));
    return count == 1
               ? Message("Export", "\"%1\" is cracked but in one piece: 1 of its connections is broken, and its skin "
                                   "spans the crack, stretched to %2 times its length there near %3.")
                     .with(part.part.name, stretch, place)
               : Message("Export", "\"%1\" is cracked but in one piece: %2 of its connections are broken, and its skin "
                                   "spans the crack, stretched to %3 times its length there near %4.")
                     .with(part.part.name, count, stretch, place);
}

/// Of pieces without a shape of their own, so that nobody looks for them in vain.
void remarkOnDust(std::size_t objects, bool isUncut, std::vector<Message>& remarks)
{
    if (isUncut)
        remarks.push_back(Message("Export", "its cracks could not be made into surfaces: other pieces of it are "
                                            "written as one with it; objects in them: %1.")
                              .with(objects));
    else if (objects > 0)
        remarks.push_back(
            Message("Export",
                    "pieces too small for a shape of their own are written as part of it; objects in them: %1.")
                .with(objects));
}

/// Of cracks that end in a piece: how many of its connections are broken, where that is more than a few.
void remarkOnCracks(const PartToExport& whole, const std::vector<std::uint32_t>& fragmentOf, std::uint32_t fragment,
                    std::vector<Message>& remarks)
{
    constexpr std::ptrdiff_t few = 12;
    const auto within = std::ranges::count_if(*whole.broken, [&](const BrokenConnection& one) {
        return fragmentOf[one.lower] == fragment && fragmentOf[upperEnd(whole.aggregate->lattice, one)] == fragment;
    });
    if (within >= few)
        remarks.push_back(
            Message("Export", "cracks end in it, and its skin spans them; connections broken there: %1.").with(within));
}

/// What knives went through, a sheet for each two fragments that it parted; none where anything tore.
std::vector<std::vector<Vec3>> sheetsOf(const Lattice& lattice, std::span<const BrokenConnection> broken,
                                        const std::vector<std::uint32_t>& fragmentOf)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Vec3>> sheets;
    for (const BrokenConnection& connection : broken) {
        const std::uint32_t lower = fragmentOf[connection.lower];
        const std::uint32_t upper = fragmentOf[upperEnd(lattice, connection)];
        const std::pair ends(std::min(lower, upper), std::max(lower, upper));
        if (ends.first == ends.second)
            continue;
        if (!connection.isCut())
            return {};
        sheets[ends].push_back(lattice.position(connection.lower) +
                               connection.cutAt * lattice.direction(static_cast<int>(connection.direction)));
    }
    std::vector<std::vector<Vec3>> all;
    all.reserve(sheets.size());
    for (auto& [ends, points] : sheets)
        all.push_back(std::move(points));
    return all;
}

/// Objects of each fragment that are far from where it was cut and from the skin.
std::vector<Vec3> placesWithin(const Aggregate& aggregate, const std::vector<ObjectIndex>& objects,
                               const std::vector<std::vector<Vec3>>& sheets)
{
    constexpr std::size_t wanted = 12;
    std::vector<std::pair<double, ObjectIndex>> rank;
    for (const ObjectIndex object : objects) {
        double clear = aggregate.depth[object];
        for (const std::vector<Vec3>& sheet : sheets)
            for (const Vec3& point : sheet)
                clear = std::min(clear, (aggregate.lattice.position(object) - point).norm());
        rank.emplace_back(-clear, object);
    }
    std::ranges::sort(rank);
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < std::min(wanted, rank.size()); ++i)
        places.push_back(aggregate.lattice.position(rank[i].second));
    return places;
}

/// Where the pieces of a part were cut; none where anything tore.
/// @param objects of each of them in `first`, the filling of the opened part
std::vector<std::shared_ptr<const PieceCut>> cutsOf(const Aggregate& first,
                                                    const std::vector<std::vector<Vec3>>& sheets,
                                                    const std::vector<std::vector<ObjectIndex>>& objects)
{
    std::vector<std::shared_ptr<const PieceCut>> cuts(objects.size());
    if (sheets.empty())
        return cuts;
    std::vector<std::vector<Vec3>> within;
    within.reserve(objects.size());
    for (const std::vector<ObjectIndex>& each : objects)
        within.push_back(placesWithin(first, each, sheets));
    for (std::size_t i = 0; i < objects.size(); ++i) {
        PieceCut cut{.sheets = sheets, .inside = within[i], .outside = {}, .spacing = first.lattice.spacing};
        for (std::size_t other = 0; other < objects.size(); ++other)
            if (other != i)
                cut.outside.insert(cut.outside.end(), within[other].begin(), within[other].end());
        cuts[i] = std::make_shared<const PieceCut>(std::move(cut));
    }
    return cuts;
}

Message tornReason(std::size_t pieces)
{
    return Message("Export", "the part is torn; this is one of %1 pieces.").with(pieces);
}

/// Of a body that was filled anew, each cut out of the opened part and carried by the former shape and the present objects. Fields,
/// which the whole has, are left out. None where it hangs together, or where its cracks cannot be followed back.
std::vector<PartToExport> piecesOfRefilled(const PartToExport& whole, std::size_t mostTriangles, bool keepsFaces,
                                           TaskControl& control)
{
    const Aggregate& present = *whole.aggregate;
    const double spacing = present.lattice.spacing;
    OpenedPieces apart = piecesToShow(present, refine(whole.part.mesh, spacing, mostTriangles), *whole.broken, control);
    if (apart.pieces.empty())
        return {};
    const Aggregate& first = firstFillingOf(present);
    std::vector<std::vector<ObjectIndex>> objects;
    objects.reserve(apart.pieces.size());
    for (const OpenedPiece& piece : apart.pieces)
        objects.push_back(piece.carriers);
    std::vector<std::vector<Vec3>> sheets;
    if (keepsFaces && whole.part.exact)
        sheets = sheetsOf(first.lattice, apart.parting, apart.ofFirst);
    const auto cuts = cutsOf(first, sheets, objects);
    std::vector<PartToExport> pieces;
    for (std::size_t i = 0; i < apart.pieces.size(); ++i) {
        OpenedPiece& from = apart.pieces[i];
        Aggregate own = wholePiece(present, from.present);
        own.former =
            std::make_shared<const FormerShape>(std::make_shared<const Aggregate>(wholePiece(first, from.carriers)),
                                                pickedOf(present.former->displacements(), from.carriers));
        const auto aggregate = std::make_shared<const Aggregate>(std::move(own));
        std::vector<Vec3> displacements = pickedOf(whole.displacements, from.present);
        PartToExport& piece = pieces.emplace_back();
        if (!cuts[i]) {
            const SkinMap map(*aggregate, std::move(displacements));
            piece.part = pieceOf(whole.part, carriedMesh(from.mesh, map, spacing, mostTriangles), i + 1);
            piece.reason = tornReason(apart.pieces.size());
        } else {
            piece.part = pieceOf(whole.part, std::move(from.mesh), i + 1);
            piece.part.exact = whole.part.exact;
            piece.aggregate = aggregate;
            piece.displacements = std::move(displacements);
            piece.cut = cuts[i];
        }
        piece.density = whole.density;
        piece.deformations = whole.deformations;
        remarkOnDust(from.dust, false, piece.remarks);
        if (whole.relaxed)
            piece.remarks.push_back(Message("Export", "it was filled anew before: its fields are left out."));
    }
    return pieces;
}

/// A piece with the faces of its part, for whoever cuts these: its surface and its objects at rest.
PartToExport smoothPiece(const PartToExport& whole, const Fragment& fragment, std::size_t number,
                         std::span<const std::uint16_t> isBroken)
{
    const std::vector<ObjectIndex> carriers = carriersOf(*whole.aggregate, fragment, isBroken);
    PartToExport piece{.part = pieceOf(whole.part, fragment.mesh, number)};
    piece.part.exact = whole.part.exact;
    piece.aggregate = std::make_shared<const Aggregate>(extract(*whole.aggregate, carriers, isBroken));
    piece.displacements = pickedOf(whole.displacements, carriers);
    return piece;
}

/// The pieces of one part; none when it hangs together, of which the part then says what is cracked.
std::vector<PartToExport> piecesOf(PartToExport& whole, std::size_t mostTriangles, bool keepsFaces,
                                   TaskControl& control)
{
    if (whole.aggregate == nullptr)
        return {};
    const auto& former = whole.aggregate->former;
    const bool isCracked = whole.broken != nullptr && !whole.broken->empty();
    if (!isCracked && !(former && former->isInPieces()))
        return {};
    if (!isCracked)
        whole.broken = std::make_shared<const std::vector<BrokenConnection>>();
    if (former)
        if (auto pieces = piecesOfRefilled(whole, mostTriangles, keepsFaces, control); !pieces.empty())
            return pieces;
    const double spacing = whole.aggregate->lattice.spacing;
    const TriangleMesh skin = former ? carriedMesh(whole.part.mesh, *former, spacing, mostTriangles)
                                     : refine(whole.part.mesh, spacing, mostTriangles);
    std::vector<Fragment> fragments = fragmentsOf(*whole.aggregate, skin, *whole.broken, {}, control);
    if (fragments.size() < 2) {
        if (auto opened = isCracked && !fragments.front().isUncut ? gaping(whole, mostTriangles, keepsFaces, control)
                                                                  : std::nullopt) {
            remarkOnDust(fragments.front().dust.size(), fragments.front().isUncut, opened->remarks);
            return {std::move(*opened)};
        }
        if (!fragments.front().isUncut && isCracked)
            whole.remarks.push_back(crackRemark(whole));
        remarkOnDust(fragments.front().dust.size(), fragments.front().isUncut, whole.remarks);
        return {};
    }
    std::vector<CarriedFragment> now = carried(*whole.aggregate, fragments, *whole.broken, whole.displacements,
                                               whole.relaxed.get(), whole.loaded, control);
    const std::vector<std::uint32_t> fragmentOf = fragmentOfObjects(*whole.aggregate, fragments);
    std::vector<std::vector<Vec3>> sheets;
    if (keepsFaces && whole.part.exact && !former)
        sheets = sheetsOf(whole.aggregate->lattice, *whole.broken, fragmentOf);
    std::vector<std::vector<ObjectIndex>> objects;
    objects.reserve(fragments.size());
    for (const Fragment& fragment : fragments)
        objects.push_back(fragment.objects);
    const auto cuts = cutsOf(*whole.aggregate, sheets, objects);
    const std::vector<std::uint16_t> isBroken = brokenDirections(*whole.aggregate, *whole.broken);
    std::vector<PartToExport> pieces;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        PartToExport& piece = pieces.emplace_back();
        if (cuts[i] && !now[i].isRigid) {
            piece = smoothPiece(whole, fragments[i], i + 1, isBroken);
            piece.cut = cuts[i];
        } else {
            fragments[i].mesh.vertices = std::move(now[i].places);
            piece.part = pieceOf(whole.part, std::move(fragments[i].mesh), i + 1);
            if (whole.relaxed)
                piece.fields = std::make_shared<const SkinFields>(std::move(now[i].fields));
            piece.reason = tornReason(fragments.size());
        }
        piece.density = whole.density;
        piece.deformations = whole.deformations;
        if (now[i].isRigid)
            piece.remarks.push_back(Message("Export", "too few of its objects hang together to say how it is deformed: "
                                                      "it is written in its shape at rest, moved as they have."));
        remarkOnDust(fragments[i].dust.size(), fragments[i].isUncut, piece.remarks);
        remarkOnCracks(whole, fragmentOf, static_cast<std::uint32_t>(i), piece.remarks);
    }
    return pieces;
}

/// Puts what has become of the parts into the tree.
/// @param first number of the first piece of each part, and how many there are
void renumber(PartNode& node, const std::vector<std::pair<std::size_t, std::size_t>>& pieces,
              const std::vector<PartToExport>& parts)
{
    for (PartNode& child : node.children)
        renumber(child, pieces, parts);
    if (!node.part)
        return;
    const auto [first, count] = pieces[*node.part];
    if (count == 1) {
        node.part = first;
        return;
    }
    node.part.reset();
    for (std::size_t i = first; i < first + count; ++i)
        node.children.push_back({parts[i].part.name, i, {}});
}

} // namespace

ExportJob withPieces(ExportJob job, std::size_t mostTriangles, TaskControl& control, bool keepsFaces)
{
    ExportJob result;
    result.options = job.options;
    std::vector<std::pair<std::size_t, std::size_t>> numbers;
    for (PartToExport& part : job.parts) {
        TaskPortion portion = TaskPortion::ofItem(control, numbers.size(), job.parts.size());
        std::vector<PartToExport> pieces = piecesOf(part, mostTriangles, keepsFaces, portion);
        if (pieces.empty())
            pieces.push_back(std::move(part));
        numbers.emplace_back(result.parts.size(), pieces.size());
        std::move(pieces.begin(), pieces.end(), std::back_inserter(result.parts));
    }
    result.tree = std::move(job.tree);
    renumber(result.tree, numbers, result.parts);
    return result;
}

} // namespace knead
