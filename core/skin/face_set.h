#pragma once

#include "core/geometry/disjoint_sets.h"
#include "core/skin/crossings.h"
#include "core/skin/divided_triangle.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace knead {

/// The faces that triangles have been divided into, and which of them hang together over edges that are not cut. A triangle
/// that is not divided is a face of its own number; faces of divided ones follow behind all triangles.
class FaceSet {
public:
    struct Divided {
        std::uint32_t triangle;
        TriangleFace face;
    };

    /// @param stretches of all edges, into which points divide them
    FaceSet(std::size_t triangles, std::vector<Divided> divided, std::size_t stretches)
        : m_triangles(triangles)
        , m_isDivided(triangles, 0)
        , m_divided(std::move(divided))
        , m_sets(triangles + m_divided.size())
        , m_faceAt(stretches, none)
    {
        for (const Divided& face : m_divided)
            m_isDivided[face.triangle] = 1;
    }

    bool isDivided(std::size_t triangle) const { return m_isDivided[triangle] != 0; }
    const std::vector<Divided>& divided() const { return m_divided; }
    std::uint32_t numberOf(std::size_t divided) const { return static_cast<std::uint32_t>(m_triangles + divided); }
    std::size_t find(std::size_t face) { return m_sets.find(face); }
    std::size_t size() const { return m_triangles + m_divided.size(); }

    /// A face has a stretch of an edge: it hangs together with all others that have it.
    void touch(std::uint32_t face, std::size_t stretch)
    {
        if (m_faceAt[stretch] == none)
            m_faceAt[stretch] = face;
        else
            m_sets.join(face, m_faceAt[stretch]);
    }

    /// The tags of lines, by set of faces. @throws DegenerateCut when those of a set differ
    std::vector<std::uint32_t> tags()
    {
        std::vector<std::uint32_t> result(size(), none);
        for (std::size_t i = 0; i < m_divided.size(); ++i) {
            if (m_divided[i].face.tag == none)
                continue;
            std::uint32_t& tag = result[m_sets.find(numberOf(i))];
            if (tag != none && tag != m_divided[i].face.tag)
                throw DegenerateCut();
            tag = m_divided[i].face.tag;
        }
        return result;
    }

private:
    static constexpr std::uint32_t none = DividedTriangle::noTag;

    std::size_t m_triangles;
    std::vector<std::uint8_t> m_isDivided;
    std::vector<Divided> m_divided;
    DisjointSets m_sets;
    std::vector<std::uint32_t> m_faceAt; // the first one, per stretch
};

} // namespace knead
