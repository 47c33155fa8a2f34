#include "core/skin/neighborhood_cache.h"

namespace knead {

namespace {

template <typename Value>
std::size_t bytesOf(const std::vector<Value>& values)
{
    return values.capacity() * sizeof(Value);
}

std::size_t bytesOf(const Neighborhood& around)
{
    const Neighborhood::Outward& outward = around.outward;
    std::size_t bytes = sizeof around + bytesOf(around.cells) + bytesOf(around.objects) + bytesOf(around.walks) +
                        bytesOf(around.walksOf) + bytesOf(outward.order) + bytesOf(outward.within);
    for (const std::vector<float>& steps : outward.steps)
        bytes += bytesOf(steps);
    return bytes;
}

} // namespace

std::size_t NeighborhoodCache::Hash::hash(const SkinOwner& owner)
{
    std::size_t hash = static_cast<std::size_t>(owner.kind);
    for (const std::int32_t coordinate : owner.node)
        hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0x9e3779b97f4a7c15U;
    return hash ^ hash >> 32U;
}

NeighborhoodCache::NeighborhoodCache(const Aggregate& aggregate, std::size_t mostBytes)
    : m_finder(aggregate)
    , m_mostBytes(mostBytes)
{
}

std::shared_ptr<const Neighborhood> NeighborhoodCache::around(const SkinOwner& owner)
{
    decltype(m_kept)::const_accessor kept;
    if (m_kept.find(kept, owner))
        return kept->second;
    auto around = std::make_shared<const Neighborhood>(m_finder.gather(owner));
    const std::size_t bytes = bytesOf(*around);
    if (m_bytes.fetch_add(bytes) + bytes > m_mostBytes || !m_kept.insert({owner, around}))
        m_bytes -= bytes;
    return around;
}

} // namespace knead
