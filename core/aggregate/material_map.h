#pragma once

#include "core/aggregate/lattice.h"
#include "core/aggregate/material.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// Objects of a body that are made of something else than the rest.
struct MaterialRegion {
    std::string name;
    std::vector<ObjectIndex> objects; ///< within the body
    Material material;
};

/// What each object of a body is made of: the body's own material, or that of a region.
class MaterialMap {
public:
    using Index = std::uint8_t;

    MaterialMap(const Material& own, std::size_t objects);

    /// As it was: what materials() and indices() gave.
    /// @pre there is a material, and every index is one of it
    MaterialMap(std::vector<Material> materials, std::vector<Index> indices);

    /// The body's own material is the first; the others are those of regions, each once.
    const std::vector<Material>& materials() const { return m_materials; }
    bool isUniform() const { return m_materials.size() == 1; }
    const std::vector<Index>& indices() const { return m_index; } ///< per object
    Index indexOf(ObjectIndex object) const { return isUniform() ? Index{0} : m_index[object]; }
    const Material& of(ObjectIndex object) const { return m_materials[indexOf(object)]; }

    /// Changes the body's own material; regions keep theirs.
    void setOwn(const Material& material) { m_materials.front() = material; }

    /// Changes the material of some objects; to the body's own one, and they no longer differ.
    /// @throws Problem for an object that does not exist, or for more than 255 different materials
    void set(const std::vector<ObjectIndex>& objects, const Material& material);

    friend bool operator==(const MaterialMap&, const MaterialMap&) = default;

    /// Largest of a property over all materials in use.
    template <typename Property>
    double largest(Property&& property) const
    {
        double most = property(m_materials.front());
        for (const Material& material : m_materials)
            most = property(material) > most ? property(material) : most;
        return most;
    }

private:
    Index place(const Material& material);
    void dropUnused();

    std::vector<Material> m_materials;
    std::vector<Index> m_index; ///< per object
};

} // namespace knead
