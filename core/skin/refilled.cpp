#include "core/skin/refilled.h"

#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/geometry/refine.h"
#include "core/mechanics/point_spread.h"
#include "core/skin/opened_pieces.h"
#include "core/skin/skin.h"
#include "core/task/parallel.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace knead {

namespace {

// A fit of moving least squares smooths what it is given; doing it again with what is missing takes much of that back, and what is
// rough in it too.
constexpr int corrections = 1;
constexpr std::size_t pointsPerBlock = 512;

/// Fits the map of the skin of some carriers to where their body has come.
class ShapeFit {
public:
    ShapeFit(const TriangleMesh& surface, const std::shared_ptr<const Aggregate>& present,
             std::span<const Vec3> displacements, const RefillManner& manner, std::shared_ptr<const ShapeFitting> known)
        : m_present(*present)
        , m_displacements(displacements)
        , m_former(goesOn(*present, manner) ? present->former : nullptr)
        , m_carriers(m_former ? m_former->carriers() : present)
        , m_known(m_former ? std::move(known) : nullptr)
    {
        splitSurface(surface, refilledEdge * manner.spacing);
    }

    std::shared_ptr<const FormerShape> shape(const MovePlaces& move, TriangleMesh& now)
    {
        fitCarriers();
        if (move)
            move(m_places);
        fitToSurface(m_fit->surface, m_places, m_fitted);
        now = m_fit->mesh;
        m_fit->surface.evaluate(m_fitted, now.vertices);
        return std::make_shared<const FormerShape>(m_carriers, std::move(m_fitted));
    }

    const std::shared_ptr<const ShapeFitting>& fitting() const { return m_fit; }

private:
    /// Whether the carriers of its former shape can carry what it has come to as well; else its own objects have to.
    static bool goesOn(const Aggregate& present, const RefillManner& manner)
    {
        return present.former &&
               (manner.keepsCarriers || present.former->stretchOfCarriers() <= FormerShape::mostStretch ||
                present.former->stages() == FormerShape::mostStages);
    }

    /// Where carriers and former shape have points of the opened part: the first ones are likely those that were asked for last time.
    void addFormerPlaces(const std::vector<Vec3>& vertices)
    {
        const std::size_t begin = m_formerPlaces.size();
        m_formerPlaces.resize(vertices.size());
        m_carrierPlaces.resize(vertices.size());
        std::vector<Vec3> unknown;
        std::vector<std::size_t> unknownAt;
        for (std::size_t i = begin; i < vertices.size(); ++i) {
            if (i < m_knownPlaces.size() && m_known->mesh.vertices[i] == vertices[i]) {
                m_carrierPlaces[i] = m_known->surface.points()[i];
                m_formerPlaces[i] = m_knownPlaces[i];
            } else {
                unknown.push_back(vertices[i]);
                unknownAt.push_back(i);
            }
        }
        const std::vector<Vec3> carried = placesWhenFilled(*m_carriers, unknown);
        std::vector<Vec3> found = carried;
        if (m_former) // to the bits of those that are known
            Skin::ofPlacesWhenFilled(*m_carriers, carried).evaluate(m_former->displacements(), found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            m_carrierPlaces[unknownAt[i]] = carried[i];
            m_formerPlaces[unknownAt[i]] = found[i];
        }
    }

    /// Trilinearly between the objects around it; none where no cell around has all of its objects.
    std::optional<Vec3> touchingPlace(const Vec3& place) const
    {
        const auto spread = spreadOf(m_present.lattice, place);
        if (!spread)
            return {};
        Vec3 now = place;
        for (std::uint32_t n = 0; n < spread->count; ++n)
            now += spread->weights[n] * m_displacements[spread->objects[n]];
        return now;
    }

    /// Of former places from a first one on. Where nothing touches, as their skin has it.
    void findTouchingPlaces(std::size_t begin)
    {
        std::vector<std::uint8_t> isKnown(m_places.size() - begin, 0);
        forEachBlock(isKnown.size(), pointsPerBlock, [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i)
                if (const auto place = touchingPlace(m_formerPlaces[begin + i])) {
                    m_places[begin + i] = *place;
                    isKnown[i] = 1;
                }
        });
        std::vector<Vec3> others;
        for (std::size_t i = 0; i < isKnown.size(); ++i)
            if (isKnown[i] == 0)
                others.push_back(m_formerPlaces[begin + i]);
        if (others.empty())
            return;
        const Skin skin = Skin::ofPlacesWhenFilled(m_present, others);
        skin.evaluate(m_displacements, others);
        auto other = others.begin();
        for (std::size_t i = 0; i < isKnown.size(); ++i)
            if (isKnown[i] == 0)
                m_places[begin + i] = *other++;
    }

    /// Where it touches, edges are short enough.
    void splitSurface(const TriangleMesh& surface, double edge)
    {
        if (m_known) {
            m_knownPlaces.resize(m_known->mesh.vertices.size());
            m_known->surface.evaluate(m_former->displacements(), m_knownPlaces);
        }
        const auto carry = [&](const std::vector<Vec3>& vertices) -> const std::vector<Vec3>& {
            const std::size_t begin = m_places.size();
            addFormerPlaces(vertices);
            m_places.resize(vertices.size());
            findTouchingPlaces(begin);
            return m_places;
        };
        TriangleMesh mesh = refineWhereCarried(surface, edge, mostRefilledTriangles(m_present), carry);
        carry(mesh.vertices);
        if (m_known && m_known->mesh.vertices == mesh.vertices) {
            m_fit = m_known;
            return;
        }
        Skin ofSurface = Skin::ofPlacesWhenFilled(*m_carriers, m_carrierPlaces);
        m_fit = std::make_shared<const ShapeFitting>(ShapeFitting{
            m_known ? m_known->carriers : Skin::ofPlacesWhenFilled(*m_carriers, m_carriers->lattice.positions()),
            std::move(mesh), std::move(ofSurface)});
    }

    /// From where they were: what has not moved stays as it is, to the bit.
    void fitCarriers()
    {
        m_fitted = m_former ? m_former->displacements() : std::vector<Vec3>(m_carriers->size(), Vec3::Zero());
        std::vector<Vec3> places(m_carriers->size());
        m_fit->carriers.evaluate(m_fitted, places);
        std::vector<Vec3> wanted(places.size());
        if (m_former)
            Skin::ofPlacesWhenFilled(m_present, places).evaluate(m_displacements, wanted);
        else // they are the present objects, where these were filled
            m_fit->carriers.evaluate(m_displacements, wanted);
        for (int n = 0; n <= corrections; ++n) {
            if (n > 0)
                m_fit->carriers.evaluate(m_fitted, places);
            for (std::size_t i = 0; i < places.size(); ++i)
                m_fitted[i] += wanted[i] - places[i];
        }
    }

    const Aggregate& m_present;
    std::span<const Vec3> m_displacements;
    std::shared_ptr<const FormerShape> m_former; ///< whose carriers go on; null: the present objects are the carriers
    std::shared_ptr<const Aggregate> m_carriers;
    std::shared_ptr<const ShapeFitting> m_known;
    std::shared_ptr<const ShapeFitting> m_fit;
    std::vector<Vec3> m_knownPlaces;   ///< of the vertices of m_known, in the former shape
    std::vector<Vec3> m_carrierPlaces; ///< of the vertices of m_fit, where the carriers were filled
    std::vector<Vec3> m_formerPlaces;  ///< the same in the former shape
    std::vector<Vec3> m_places;        ///< where they are now
    std::vector<Vec3> m_fitted;        ///< displacements of the carriers
};

} // namespace

std::shared_ptr<const Aggregate> refilled(const TriangleMesh& surface, const std::shared_ptr<const Aggregate>& present,
                                          std::span<const Vec3> displacements, const RefillManner& manner,
                                          std::shared_ptr<const ShapeFitting>& fitting, const MovePlaces& move,
                                          TaskControl& control)
{
    ShapeFit fit(surface, present, displacements, manner, std::move(fitting));
    fitting = fit.fitting();
    TriangleMesh now;
    std::shared_ptr<const FormerShape> shape = fit.shape(move, now);
    Aggregate aggregate = fill(
        now, {.spacing = manner.spacing, .dirty = DirtySurface::windingNumber, .rowAxis = manner.rowAxis}, control);
    aggregate.former = std::move(shape);
    return std::make_shared<const Aggregate>(std::move(aggregate));
}

std::vector<ObjectIndex> objectsInFilling(const Aggregate& aggregate, const std::vector<ObjectIndex>& first)
{
    if (!aggregate.former)
        return first;
    const std::vector<ObjectIndex> nearest =
        nearestPoints(VectorArray(firstFillingWhenFilled(aggregate)), nodesOf(aggregate), aggregate.lattice.spacing);
    std::vector<ObjectIndex> found;
    for (ObjectIndex i = 0; i < nearest.size(); ++i)
        if (std::ranges::binary_search(first, nearest[i]))
            found.push_back(i);
    return found;
}

TriangleMesh surfaceWhenFilled(const TriangleMesh& surface, const Aggregate& aggregate, double longestEdge)
{
    if (!aggregate.former)
        return surface;
    const double edge = longestEdge * aggregate.lattice.spacing;
    const std::size_t most = mostRefilledTriangles(aggregate);
    const FormerShape& former = *aggregate.former;
    if (!former.isInPieces())
        return carriedMesh(surface, former, edge, most);
    const OpenedPieces apart = openedPieces(aggregate, surface, {});
    TriangleMesh all;
    for (const OpenedPiece& piece : apart.pieces) {
        const FormerShape shape(std::make_shared<const Aggregate>(wholePiece(*former.carriers(), piece.carriers)),
                                pickedOf(former.displacements(), piece.carriers));
        append(all, carriedMesh(piece.mesh, shape, edge, most));
    }
    return all;
}

} // namespace knead
