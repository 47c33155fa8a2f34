// The fillings that a body has had: what is drawn and measured of each is made once.
#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/skin/former_shape.h"
#include "core/skin/torn_surface.h"
#include "ui/document/content.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>

namespace knead {

/// The last ones asked for. Any thread.
class Fillings {
public:
    std::shared_ptr<const ContentBody> find(const std::shared_ptr<const Aggregate>& aggregate)
    {
        const std::lock_guard lock(m_mutex);
        const auto found = std::find_if(m_bodies.begin(), m_bodies.end(),
                                        [&](const auto& body) { return body->aggregate == aggregate; });
        if (found == m_bodies.end())
            return nullptr;
        std::rotate(m_bodies.begin(), found, found + 1);
        return m_bodies.front();
    }

    void add(std::shared_ptr<const ContentBody> body)
    {
        const std::lock_guard lock(m_mutex);
        m_bodies.insert(m_bodies.begin(), std::move(body));
        if (m_bodies.size() > most)
            m_bodies.pop_back();
    }

    /// A body that came apart, by what was broken; or the whole one where it hangs together.
    struct Torn {
        std::shared_ptr<const Aggregate> aggregate;
        std::shared_ptr<const std::vector<BrokenConnection>> broken;
        std::vector<std::uint32_t> pieceOfObject;
        std::shared_ptr<const ContentBody> body;
    };

    template <typename Is>
    std::shared_ptr<const ContentBody> findTorn(Is is)
    {
        const std::lock_guard lock(m_mutex);
        const auto found = std::find_if(m_torn.begin(), m_torn.end(), is);
        return found != m_torn.end() ? found->body : nullptr;
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
    std::vector<std::shared_ptr<const ContentBody>> m_bodies; ///< the last one first
    std::vector<Torn> m_torn;                                 ///< the same
};

std::vector<ObjectIndex> surfaceObjects(const Aggregate& aggregate)
{
    constexpr double surfaceDepth = 0.9; // objects less deep than this many spacings are drawn
    std::vector<ObjectIndex> objects;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (aggregate.depth[i] < surfaceDepth * aggregate.lattice.spacing)
            objects.push_back(i);
    return objects;
}

std::shared_ptr<Fillings> newFillings()
{
    return std::make_shared<Fillings>();
}

std::shared_ptr<const ContentBody> filledAs(const std::shared_ptr<const ContentBody>& body,
                                            const std::shared_ptr<const Aggregate>& aggregate)
{
    if (body->whole)
        return filledAs(body->whole, aggregate);
    if (body->aggregate == aggregate)
        return body;
    if (auto known = body->fillings->find(aggregate))
        return known;
    auto filled = std::make_shared<ContentBody>(*body);
    filled->aggregate = aggregate;
    filled->skin.emplace(*aggregate, filled->mesh.vertices);
    filled->surfaceObjects = surfaceObjects(*aggregate);
    body->fillings->add(filled);
    return filled;
}

std::shared_ptr<const ContentBody> tornAs(const std::shared_ptr<const ContentBody>& filled,
                                          const std::shared_ptr<const std::vector<BrokenConnection>>& broken)
{
    const std::shared_ptr<const ContentBody>& whole = filled->whole ? filled->whole : filled;
    const std::shared_ptr<const Aggregate>& aggregate = whole->aggregate;
    const bool wasInPieces = aggregate->former && aggregate->former->isInPieces();
    if ((!broken || broken->empty()) && !wasInPieces)
        return whole;
    const std::span<const BrokenConnection> cracks = broken ? *broken : std::span<const BrokenConnection>();
    if (auto known = whole->fillings->findTorn(
            [&](const auto& torn) { return torn.aggregate == aggregate && torn.broken == broken; }))
        return known;
    Pieces pieces = findPieces(*aggregate, cracks);
    auto body = whole->fillings->findTorn(
        [&](const auto& torn) { return torn.aggregate == aggregate && torn.pieceOfObject == pieces.ofObject; });
    if (!body) {
        body = whole;
        if (auto surface = isWatertight(whole->mesh) ? tornSurface(*aggregate, whole->mesh, cracks) : std::nullopt) {
            auto torn = std::make_shared<ContentBody>(*whole);
            torn->mesh = std::move(surface->mesh);
            torn->render = renderMesh(torn->mesh);
            torn->skin.emplace(std::move(surface->skin));
            torn->whole = whole;
            body = std::move(torn);
        }
    }
    whole->fillings->add(Fillings::Torn{aggregate, broken, std::move(pieces.ofObject), body});
    return body;
}

} // namespace knead
