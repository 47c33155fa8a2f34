// The fillings that a body has had: what is drawn and measured of each is made once.
#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/session/filled_model.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/former_shape.h"
#include "core/skin/fragments.h"
#include "core/skin/torn_surface.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace knead {

/// The last ones asked for. Any thread. It keeps bodies, which know of it and do not keep it: else none of them would ever go.
class Fillings {
public:
    std::shared_ptr<const FilledBody> find(const std::shared_ptr<const Aggregate>& aggregate)
    {
        const std::lock_guard lock(m_mutex);
        const auto found =
            std::ranges::find_if(m_bodies, [&](const auto& body) { return body->aggregate == aggregate; });
        if (found == m_bodies.end())
            return nullptr;
        std::rotate(m_bodies.begin(), found, found + 1);
        return m_bodies.front();
    }

    void add(std::shared_ptr<const FilledBody> body)
    {
        const std::lock_guard lock(m_mutex);
        m_bodies.insert(m_bodies.begin(), std::move(body));
        if (m_bodies.size() > most)
            m_bodies.pop_back();
    }

    /// A body that came apart or is cut into, by what was broken; or the whole one where there is nothing to be seen.
    struct Torn {
        std::shared_ptr<const Aggregate> aggregate;
        std::shared_ptr<const std::vector<BrokenConnection>> broken;
        std::vector<std::uint32_t> pieceOfObject;
        std::vector<BrokenConnection> within; ///< broken ones that do not lead from piece to piece
        std::shared_ptr<const FilledBody> body;
        std::chrono::steady_clock::time_point end{};    ///< of making it
        std::chrono::steady_clock::duration duration{}; ///< of making it
    };

    /// The last one of those that something is true of.
    template <typename Is>
    std::optional<Torn> findTorn(Is is)
    {
        const std::lock_guard lock(m_mutex);
        const auto found = std::ranges::find_if(m_torn, is);
        return found != m_torn.end() ? std::optional(*found) : std::nullopt;
    }

    void add(Torn torn)
    {
        const std::lock_guard lock(m_mutex);
        m_torn.insert(m_torn.begin(), std::move(torn));
        if (m_torn.size() > most)
            m_torn.pop_back();
    }

private:
    static constexpr std::size_t most = 4;

    std::mutex m_mutex;
    std::vector<std::shared_ptr<const FilledBody>> m_bodies; ///< the last one first
    std::vector<Torn> m_torn;                                ///< the same
};

namespace {

/// What is handed out: the body, and its fillings for as long.
using BodyWithFillings = std::pair<std::shared_ptr<const FilledBody>, std::shared_ptr<Fillings>>;

/// Those of a body that somebody has alone are gone: nothing is kept then.
std::shared_ptr<Fillings> fillingsOf(const FilledBody& body)
{
    std::shared_ptr<Fillings> fillings = body.fillings.lock();
    return fillings ? fillings : std::make_shared<Fillings>();
}

std::shared_ptr<const FilledBody> withFillings(const std::shared_ptr<const FilledBody>& body)
{
    const auto kept = std::make_shared<const BodyWithFillings>(body->shared_from_this(), body->fillings.lock());
    return {kept, kept->first.get()};
}

std::vector<BrokenConnection> brokenWithin(const Aggregate& aggregate, const Pieces& pieces,
                                           std::span<const BrokenConnection> broken)
{
    std::vector<BrokenConnection> within;
    std::ranges::copy_if(broken, std::back_inserter(within), [&](const BrokenConnection& one) {
        return pieces.ofObject[one.lower] == pieces.ofObject[upperEnd(aggregate.lattice, one)];
    });
    return within;
}

/// A body whose cracks could not be made surfaces: its skin is carried along connections that hold, so that what spans a crack is one
/// row of triangles (trianglesAcrossCracks()).
std::shared_ptr<const FilledBody> alongWhatHolds(const std::shared_ptr<const FilledBody>& whole,
                                                 std::span<const BrokenConnection> broken)
{
    const Aggregate& aggregate = *whole->aggregate;
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    std::vector<ObjectIndex> all(aggregate.size());
    std::iota(all.begin(), all.end(), 0U);
    const std::vector<ObjectIndex> carriers[] = {firmOf(aggregate, all, isBroken)};
    const std::span<const Vec3> places = whole->skin->points();
    const Skin skins[] = {
        Skin::ofPlacesWhenFilled(extract(aggregate, carriers[0], isBroken), {places.begin(), places.end()})};
    auto body = std::make_shared<FilledBody>(*whole);
    body->skin.emplace(Skin::joined(skins, carriers));
    body->whole = whole->shared_from_this();
    return body;
}

} // namespace

std::vector<ObjectIndex> surfaceObjects(const Aggregate& aggregate)
{
    constexpr double surfaceDepth = 0.9; // objects less deep than this many spacings are drawn
    std::vector<ObjectIndex> objects;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (aggregate.depth[i] < surfaceDepth * aggregate.lattice.spacing)
            objects.push_back(i);
    return objects;
}

std::shared_ptr<const FilledBody> withNewFillings(const std::shared_ptr<FilledBody>& body)
{
    const auto fillings = std::make_shared<Fillings>();
    body->fillings = fillings;
    return withFillings(body);
}

std::shared_ptr<const FilledBody> filledAs(const std::shared_ptr<const FilledBody>& body,
                                           const std::shared_ptr<const Aggregate>& aggregate)
{
    if (body->whole)
        return filledAs(body->whole, aggregate);
    if (body->aggregate == aggregate)
        return withFillings(body);
    const std::shared_ptr<Fillings> fillings = fillingsOf(*body);
    if (const auto known = fillings->find(aggregate))
        return withFillings(known);
    auto filled = std::make_shared<FilledBody>(*body);
    filled->aggregate = aggregate;
    filled->skin.emplace(*aggregate, filled->mesh.vertices);
    filled->surfaceObjects = surfaceObjects(*aggregate);
    fillings->add(filled);
    return withFillings(filled);
}

std::shared_ptr<const FilledBody> tornAs(const std::shared_ptr<const FilledBody>& filled,
                                         const std::shared_ptr<const std::vector<BrokenConnection>>& broken)
{
    const std::shared_ptr<const FilledBody>& whole = filled->whole ? filled->whole : filled;
    const std::shared_ptr<const Aggregate>& aggregate = whole->aggregate;
    const bool wasInPieces = aggregate->former && aggregate->former->isInPieces();
    if ((!broken || broken->empty()) && !wasInPieces)
        return withFillings(whole);
    const std::shared_ptr<Fillings> fillings = fillingsOf(*whole);
    const std::span<const BrokenConnection> cracks = broken ? *broken : std::span<const BrokenConnection>();
    if (const auto known =
            fillings->findTorn([&](const auto& torn) { return torn.aggregate == aggregate && torn.broken == broken; }))
        return withFillings(known->body);
    Pieces pieces = findPieces(*aggregate, cracks);
    std::vector<BrokenConnection> within = brokenWithin(*aggregate, pieces, cracks);
    const auto begin = std::chrono::steady_clock::now();
    auto torn = fillings->findTorn([&](const auto& other) {
        return other.aggregate == aggregate && other.pieceOfObject == pieces.ofObject && other.within == within;
    });
    if (!torn) {
        torn = {.aggregate = aggregate,
                .broken = {},
                .pieceOfObject = {},
                .within = std::move(within),
                .body = whole->shared_from_this()};
        torn->pieceOfObject = std::move(pieces.ofObject);
        if (auto surface = isWatertight(whole->mesh) ? tornSurface(*aggregate, whole->mesh, cracks) : std::nullopt) {
            auto body = std::make_shared<FilledBody>(*whole);
            body->mesh = std::move(surface->mesh);
            body->render = renderMesh(body->mesh);
            body->skin.emplace(std::move(surface->skin));
            body->whole = whole->shared_from_this();
            torn->body = std::move(body);
        } else if (pieces.count > findPieces(*aggregate).count || torn->within.size() >= leastSeenBroken) {
            torn->body = alongWhatHolds(whole, cracks);
        }
        torn->end = std::chrono::steady_clock::now();
        torn->duration = torn->end - begin;
    }
    torn->broken = broken;
    fillings->add(*torn);
    return withFillings(torn->body);
}

std::shared_ptr<const FilledBody> tornLately(const std::shared_ptr<const FilledBody>& filled,
                                             const std::shared_ptr<const std::vector<BrokenConnection>>& broken)
{
    constexpr int rests = 3; // times as long as it takes, so that cutting has most of a processor
    const auto idOf = [](const BrokenConnection& one) { return ConnectionId(one); };
    const std::shared_ptr<const FilledBody>& whole = filled->whole ? filled->whole : filled;
    if (!broken || broken->empty())
        return nullptr;
    const std::shared_ptr<Fillings> fillings = fillingsOf(*whole);
    const Pieces pieces = findPieces(*whole->aggregate, *broken);
    const std::vector<BrokenConnection> within = brokenWithin(*whole->aggregate, pieces, *broken);
    const auto hasSamePieces = [&](const auto& other) {
        return other.aggregate == whole->aggregate && other.pieceOfObject == pieces.ofObject;
    };
    if (fillings->findTorn([&](const auto& other) { return hasSamePieces(other) && other.within == within; }))
        return nullptr;
    const auto torn = fillings->findTorn([&](const auto& other) {
        return hasSamePieces(other) && std::ranges::includes(within, other.within, {}, idOf, idOf);
    });
    if (!torn || std::chrono::steady_clock::now() > torn->end + rests * torn->duration)
        return nullptr;
    return withFillings(torn->body);
}

} // namespace knead
