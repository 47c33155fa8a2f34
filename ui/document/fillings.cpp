// The fillings that a body has had: what is drawn and measured of each is made once.
#include "ui/document/content.h"

#include <algorithm>
#include <mutex>
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

private:
    static constexpr std::size_t most = 4;

    std::mutex m_mutex;
    std::vector<std::shared_ptr<const ContentBody>> m_bodies; ///< the last one first
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

} // namespace knead
