#include "core/deformation/deformation.h"

#include "core/deformation/field_map.h"
#include "core/deformation/number_map.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <mutex>

namespace knead {

/// What carries faces, by which part of each map carries them.
class ChainedMap::OfFaces {
public:
    using Key = std::vector<const SmoothMap*>;

    /// @param maps those that the key names, which own nothing
    const SmoothMap& chain(const Key& key)
    {
        const std::lock_guard lock(m_mutex);
        std::unique_ptr<const ChainedMap>& chain = m_chains[key];
        if (chain == nullptr) {
            std::vector<std::shared_ptr<const SmoothMap>> maps;
            for (const SmoothMap* map : key)
                maps.emplace_back(std::shared_ptr<const SmoothMap>(), map);
            chain = std::make_unique<const ChainedMap>(std::move(maps));
        }
        return *chain;
    }

private:
    std::mutex m_mutex;
    std::map<Key, std::unique_ptr<const ChainedMap>> m_chains;
};

ChainedMap::ChainedMap(std::vector<std::shared_ptr<const SmoothMap>> maps)
    : m_maps(std::move(maps))
    , m_ofFaces(std::make_shared<OfFaces>())
{
    assert(!m_maps.empty());
    m_featureSize = m_maps.front()->featureSize();
    for (const auto& map : m_maps)
        m_featureSize = std::min(m_featureSize, map->featureSize());
}

void ChainedMap::evaluate(std::span<const Vec3> points, std::span<Vec3> places) const
{
    m_maps.front()->evaluate(points, places);
    if (m_maps.size() == 1)
        return;
    std::vector<Vec3> before(places.size());
    for (std::size_t i = 1; i < m_maps.size(); ++i) {
        std::copy(places.begin(), places.end(), before.begin());
        m_maps[i]->evaluate(before, places);
    }
}

const SmoothMap& ChainedMap::ofFace(std::span<const Vec3> places) const
{
    OfFaces::Key key;
    bool isSame = true;
    std::vector<Vec3> now(places.begin(), places.end());
    std::vector<Vec3> next(now.size());
    for (const auto& map : m_maps) {
        key.push_back(&map->ofFace(now));
        isSame = isSame && key.back() == map.get();
        key.back()->evaluate(now, next);
        now.swap(next);
    }
    return isSame ? static_cast<const SmoothMap&>(*this) : m_ofFaces->chain(key);
}

std::shared_ptr<const SmoothMap> mapOf(const Deformation& deformation, TaskControl& control)
{
    if (const auto* number = std::get_if<NumberDeformation>(&deformation))
        return numberMap(*number);
    return fieldMap(std::get<FieldDeformation>(deformation), control);
}

std::shared_ptr<const SmoothMap> mapOf(std::span<const Deformation> deformations, TaskControl& control)
{
    assert(!deformations.empty());
    std::vector<std::shared_ptr<const SmoothMap>> maps;
    for (std::size_t i = 0; i < deformations.size(); ++i) {
        const auto count = static_cast<double>(deformations.size());
        TaskPortion portion(control, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        maps.push_back(mapOf(deformations[i], portion));
    }
    return maps.size() == 1 ? maps.front() : std::make_shared<const ChainedMap>(std::move(maps));
}

} // namespace knead
