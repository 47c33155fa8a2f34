#include "core/skin/new_filling.h"

#include "core/aggregate/pieces.h"
#include "core/message/message.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/opened_pieces.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

// Between pieces in their lattice [spacings]: farther than a skin looks for objects.
constexpr std::int32_t gapOfPieces = 8;

std::vector<Vec3> placesOf(const std::vector<SkinPoint>& points)
{
    std::vector<Vec3> places;
    places.reserve(points.size());
    for (const SkinPoint& point : points)
        places.push_back(point.place);
    return places;
}

VectorArray placesNow(const BodyToFill& body)
{
    VectorArray places = nodesOf(*body.aggregate);
    for (ObjectIndex i = 0; i < places.size(); ++i)
        places.add(i, body.displacements[i]);
    return places;
}

/// Objects of one of the pieces of a body, with the cracks within it.
struct OldPiece {
    std::vector<ObjectIndex> objects; ///< ascending
    Aggregate aggregate;              ///< of these
    VectorArray places;               ///< [m]
    std::vector<BrokenConnection> broken;
    std::vector<GrownTogether> healed;

    OldPiece(const BodyToFill& body, const VectorArray& now, const std::vector<std::uint32_t>& pieceOf,
             std::uint32_t piece)
    {
        std::vector<ObjectIndex> numbers(pieceOf.size(), 0);
        std::vector<Vec3> there;
        for (ObjectIndex i = 0; i < pieceOf.size(); ++i)
            if (pieceOf[i] == piece) {
                numbers[i] = static_cast<ObjectIndex>(objects.size());
                objects.push_back(i);
                there.push_back(now.at(i));
            }
        places = VectorArray(there);
        aggregate = wholePiece(*body.aggregate, objects);
        for (BrokenConnection one : body.broken)
            if (pieceOf[one.lower] == piece && pieceOf[upperEnd(body.aggregate->lattice, one)] == piece) {
                one.lower = numbers[one.lower];
                broken.push_back(one);
            }
        for (const auto& [first, second] : body.healed)
            if (pieceOf[first] == piece && pieceOf[second] == piece)
                healed.emplace_back(numbers[first], numbers[second]);
    }
};

/// Puts fillings of pieces beside each other in one lattice.
class FillingOfPieces {
public:
    FillingOfPieces(const BodyToFill& body, const OpenedPieces& apart)
        : m_body(body)
        , m_apart(apart)
        , m_now(placesNow(body))
        , m_first(body.aggregate->former ? body.aggregate->former->carriers() : body.aggregate)
        , m_moved(m_first->size(), Vec3::Zero())
    {
        m_filling.pieces = static_cast<std::uint32_t>(apart.pieces.size());
        m_filling.pieceOfOld = apart.ofPresent;
        m_filling.newOfOld.resize(body.aggregate->size());
    }

    void add(const std::shared_ptr<const Aggregate>& filled)
    {
        const Vec3 shift = layOut(filled->lattice);
        addObjects(*filled, shift);
        addLinks(*filled);
        addMoved(*filled->former, shift);
        ++m_piece;
    }

    NewFilling result()
    {
        m_filling.places = VectorArray(m_places);
        findSegments(m_all.lattice);
        const double sum = m_all.filledVolume;
        m_all.repair.doubtfulShare = sum > 0 ? m_all.repair.doubtfulShare / sum : 0;
        m_all.former = std::make_shared<const FormerShape>(m_first, std::move(m_moved), m_apart.parting);
        m_filling.aggregate = std::make_shared<const Aggregate>(std::move(m_all));
        return std::move(m_filling);
    }

private:
    /// The nodes of a piece come behind those that are there. @return what it was moved by [m]
    Vec3 layOut(const Lattice& lattice)
    {
        Lattice::Node least = lattice.nodes.front();
        for (const Lattice::Node& node : lattice.nodes)
            for (std::size_t axis = 0; axis < 3; ++axis)
                least[axis] = std::min(least[axis], node[axis]);
        Lattice& all = m_all.lattice;
        Lattice::Node start{0, 0, 0};
        if (all.nodes.empty()) {
            all.origin = lattice.position(least);
            all.spacing = lattice.spacing;
            all.axes = lattice.axes;
        } else {
            start[0] = all.nodes.back()[0] + gapOfPieces;
        }
        for (const Lattice::Node& node : lattice.nodes)
            all.nodes.push_back({node[0] - least[0] + start[0], node[1] - least[1], node[2] - least[2]});
        return all.position(start) - lattice.position(least);
    }

    void addObjects(const Aggregate& filled, const Vec3& shift)
    {
        const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            append(m_all.weight[d], filled.weight[d]);
        append(m_all.volume, filled.volume);
        append(m_all.depth, filled.depth);
        append(m_all.face, filled.face);
        for (SkinPoint point : filled.skin) {
            m_filling.skin.push_back(point.place);
            point.place += shift;
            m_all.skin.push_back(point);
        }
        append(m_places, filled.lattice.positions());
        m_all.meshVolume += filled.meshVolume;
        m_all.filledVolume += filled.filledVolume;
        m_all.cells += filled.cells;
        m_all.repair.removedTriangles += filled.repair.removedTriangles;
        m_all.repair.flippedTriangles += filled.repair.flippedTriangles;
        m_all.repair.decidedCells += filled.repair.decidedCells;
        m_all.repair.doubtfulShare += filled.repair.doubtfulShare * filled.filledVolume; // by result() made a share
        m_filling.pieceOfNew.resize(m_all.volume.size(), m_piece);
    }

    /// What of it belongs to what of before, and the cracks in it.
    void addLinks(const Aggregate& filled)
    {
        const OldPiece old(m_body, m_now, m_apart.ofPresent, m_piece);
        const auto begin = static_cast<ObjectIndex>(m_all.size() - filled.size());
        const double spacing = filled.lattice.spacing;
        const VectorArray nodes = nodesOf(filled);
        for (const ObjectIndex nearest : nearestPoints(old.places, nodes, spacing))
            m_filling.oldOfNew.push_back(old.objects[nearest]);
        const std::vector<ObjectIndex> newOfOld = nearestPoints(nodes, old.places, spacing);
        for (std::size_t i = 0; i < newOfOld.size(); ++i)
            m_filling.newOfOld[old.objects[i]] = begin + newOfOld[i];
        for (BrokenConnection crack :
             carriedCracks({old.aggregate, old.places, old.broken, old.healed}, filled, nodes)) {
            crack.lower += begin;
            m_filling.cracks.push_back(crack);
        }
        std::ranges::sort(m_filling.cracks);
    }

    /// Where the objects of the first filling go that are of this piece: its carriers as they were fitted, others with its skin.
    void addMoved(const FormerShape& former, const Vec3& shift)
    {
        const std::vector<ObjectIndex>& carriers = m_apart.pieces[m_piece].carriers;
        std::vector<ObjectIndex> others;
        std::vector<Vec3> rest;
        for (ObjectIndex i = 0; i < m_first->size(); ++i)
            if (m_apart.ofFirst[i] == m_piece && !std::ranges::binary_search(carriers, i)) {
                others.push_back(i);
                rest.push_back(m_first->lattice.position(i));
            }
        std::vector<Vec3> there(rest.size());
        former.evaluate(rest, there);
        for (std::size_t i = 0; i < others.size(); ++i)
            m_moved[others[i]] = there[i] - rest[i] + shift;
        for (std::size_t i = 0; i < carriers.size(); ++i)
            m_moved[carriers[i]] = former.displacements()[i] + shift;
    }

    const BodyToFill& m_body;
    const OpenedPieces& m_apart;
    VectorArray m_now;
    std::shared_ptr<const Aggregate> m_first;
    std::vector<Vec3> m_moved; ///< objects of the first filling, to where they lie in the lattice [m]
    std::vector<Vec3> m_places;
    Aggregate m_all;
    NewFilling m_filling;
    std::uint32_t m_piece = 0; ///< the next one
};

/// @param filled of the whole body
NewFilling wholeFilling(const BodyToFill& body, std::shared_ptr<const Aggregate> filled)
{
    NewFilling filling{.aggregate = std::move(filled)};
    const VectorArray now = placesNow(body);
    const double spacing = filling.aggregate->lattice.spacing;
    filling.places = nodesOf(*filling.aggregate);
    filling.skin = placesOf(filling.aggregate->skin);
    filling.cracks =
        carriedCracks({*body.aggregate, now, body.broken, body.healed}, *filling.aggregate, filling.places);
    filling.oldOfNew = nearestPoints(now, filling.places, spacing);
    filling.newOfOld = nearestPoints(filling.places, now, spacing);
    filling.pieceOfNew.assign(filling.aggregate->size(), 0);
    filling.pieceOfOld.assign(body.aggregate->size(), 0);
    return filling;
}

NewFilling fillingOfPieces(const BodyToFill& body, const OpenedPieces& apart, double spacing, KnownFittings& fittings,
                           const MovePlaces& move, TaskControl& control)
{
    fittings.whole = nullptr;
    fittings.pieces.resize(apart.pieces.size());
    const Aggregate& old = *body.aggregate;
    const Aggregate& first = firstFillingOf(old);
    RefillManner manner{.spacing = spacing, .rowAxis = {}, .keepsCarriers = true};
    Eigen::Index rows = 0;
    old.lattice.axes.col(2).maxCoeff(&rows);
    manner.rowAxis = rows;
    FillingOfPieces all(body, apart);
    for (std::size_t f = 0; f < apart.pieces.size(); ++f) {
        const OpenedPiece& piece = apart.pieces[f];
        Aggregate present = wholePiece(old, piece.present);
        if (old.former)
            present.former = std::make_shared<const FormerShape>(
                std::make_shared<const Aggregate>(wholePiece(first, piece.carriers)),
                pickedOf(old.former->displacements(), piece.carriers));
        KnownFittings::OfPiece& known = fittings.pieces[f];
        if (known.carriers != piece.carriers)
            known = {piece.carriers, nullptr};
        all.add(refilled(piece.mesh, std::make_shared<const Aggregate>(std::move(present)),
                         pickedOf(body.displacements, piece.present), manner, known.fitting, move, control));
    }
    return all.result();
}

/// Pieces that are one again have the map that the first filling of the body has where they are now.
std::shared_ptr<const Aggregate> filledAsOne(const BodyToFill& body, const RefillManner& manner, const MovePlaces& move,
                                             TaskControl& control)
{
    const auto opened = openedState(*body.aggregate, body.displacements, body.broken);
    if (!opened)
        throw Problem(
            Message("Filling", "what of it has grown together could not be followed back to what was opened."));
    std::shared_ptr<const ShapeFitting> fitting;
    return refilled(body.surface, opened->aggregate, opened->displacements, manner, fitting, move, control);
}

} // namespace

NewFilling newFilling(const BodyToFill& body, double spacing, KnownFittings& fittings, const MovePlaces& move,
                      TaskControl& control)
{
    const Aggregate& old = *body.aggregate;
    const bool wasApart = old.former && old.former->isInPieces();
    if (wasApart || findPieces(old, body.broken).count > findPieces(old).count) {
        const OpenedPieces apart = openedPieces(old, body.surface, body.broken, body.healed, control);
        if (apart.isUnknown)
            throw Problem(Message("Filling", "its cracks could not be made surfaces."));
        if (!apart.pieces.empty())
            return fillingOfPieces(body, apart, spacing, fittings, move, control);
    }
    if (wasApart) {
        fittings = {};
        return wholeFilling(body, filledAsOne(body, {.spacing = spacing}, move, control));
    }
    return wholeFilling(body, refilled(body.surface, body.aggregate, body.displacements, {.spacing = spacing},
                                       fittings.whole, move, control));
}

} // namespace knead
