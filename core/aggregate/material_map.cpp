#include "core/aggregate/material_map.h"

#include "core/message/message.h"

#include <algorithm>
#include <limits>

namespace knead {

MaterialMap::MaterialMap(const Material& own, std::size_t objects)
    : m_materials{own}
    , m_index(objects, 0)
{
}

MaterialMap::MaterialMap(std::vector<Material> materials, std::vector<Index> indices)
    : m_materials(std::move(materials))
    , m_index(std::move(indices))
{
}

void MaterialMap::set(const std::vector<ObjectIndex>& objects, const Material& material)
{
    for (const ObjectIndex object : objects)
        if (object >= m_index.size())
            throw Problem(
                Message("Material", "The region names the object %1; the body has %2.").with(object, m_index.size()));
    const Index index = place(material);
    for (const ObjectIndex object : objects)
        m_index[object] = index;
    dropUnused();
}

MaterialMap::Index MaterialMap::place(const Material& material)
{
    const auto found = std::ranges::find(m_materials, material);
    if (found != m_materials.end())
        return static_cast<Index>(found - m_materials.begin());
    if (m_materials.size() == std::numeric_limits<Index>::max())
        throw Problem(Message("Material", "A body can be made of at most 255 different materials."));
    m_materials.push_back(material);
    return static_cast<Index>(m_materials.size() - 1);
}

void MaterialMap::dropUnused()
{
    std::vector<Index> renamed(m_materials.size(), 0);
    for (const Index index : m_index)
        renamed[index] = 1;
    renamed[0] = 1;
    std::vector<Material> used;
    for (std::size_t i = 0; i < renamed.size(); ++i)
        if (renamed[i] != 0) {
            renamed[i] = static_cast<Index>(used.size());
            used.push_back(m_materials[i]);
        }
    if (used.size() == m_materials.size())
        return;
    m_materials = std::move(used);
    for (Index& index : m_index)
        index = renamed[index];
}

} // namespace knead
