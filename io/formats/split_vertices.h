#pragma once

#include "io/formats/threemf/color_groups.h"
#include "io/mesh/corner_normals.h"
#include "io/mesh/mesh_body.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace knead {

/// The vertices that one color of a body uses, each as often as it has different normals there: glTF draws smooth what shares a
/// vertex. Primitives that shared those of the whole body would have all of them copied for each color by most readers.
///
/// Normals take more memory than the surface itself, so they are made a run of vertices at a time, and again when they are
/// written. What is kept is eight bytes a vertex, and some more at edges.
class SplitVertices {
public:
    explicit SplitVertices(const MeshBody& body);

    const std::vector<ColorGroups::Group>& groups() const { return m_colors.groups; }

    void choose(const ColorGroups::Group& group);

    /// How many the chosen group has.
    std::size_t size() const { return m_used.size() + (m_extras.empty() ? 0 : m_extras.back().second); }

    /// @param visit gets the places of the vertices of the chosen group, each once
    template <typename Visit>
    void forEachPlace(Visit&& visit) const
    {
        for (const std::uint32_t vertex : m_used)
            visit(m_body.mesh.vertices[vertex]);
    }

    /// @param visit gets the place and the unit normal of each, as often as there are normals
    template <typename Visit>
    void forEachVertex(Visit&& visit) const
    {
        for (std::size_t begin = 0; begin < m_used.size(); begin += m_runLength) {
            const Run run = runFrom(begin);
            for (std::size_t i = 0; i + 1 < run.first.size(); ++i)
                for (std::size_t c = run.first[i], next = 0; c < run.first[i + 1]; ++c)
                    if (run.kind[c] == next) {
                        visit(m_body.mesh.vertices[m_used[begin + i]], run.normal[c]);
                        ++next;
                    }
        }
    }

    /// @param visit gets three numbers a triangle of the chosen group, among what forEachVertex() visits
    template <typename Visit>
    void forEachIndex(Visit&& visit) const
    {
        auto offset = m_offsets.begin();
        std::uint64_t sequence = 0;
        forEachCorner([&](std::uint32_t triangle, std::uint32_t corner) {
            std::uint32_t index = numberOf(m_places[m_body.mesh.triangles[triangle][corner]]);
            if (offset != m_offsets.end() && offset->first == sequence)
                index += (offset++)->second;
            ++sequence;
            visit(index);
        });
    }

private:
    using Normal = Eigen::Vector3f;

    /// Corners of the whole body at a run of the chosen vertices. Of those with the same normal the first one stands for all;
    /// kinds are counted from 0 in the order of their first corners.
    struct Run {
        std::vector<std::size_t> first; ///< per vertex, and the end
        std::vector<MeshCorner> corners;
        std::vector<Normal> normal;
        std::vector<std::uint32_t> kind; ///< none for corners of other colors
    };

    static constexpr std::uint32_t none = 0xffffffffU;

    template <typename Visit>
    void forEachCorner(Visit&& visit) const
    {
        for (std::size_t i = m_group.begin; i < m_group.end; ++i)
            for (std::uint32_t corner = 0; corner < 3; ++corner)
                visit(m_colors.triangle(i), corner);
    }

    Run runFrom(std::size_t begin) const;
    void tellKindsApart(Run& run, std::size_t vertex) const;
    bool isOfGroup(std::uint32_t triangle) const;
    void takeExtras(const Run& run, std::size_t begin);
    void takeOffsets(const Run& run, std::size_t begin);

    /// The number of the first of the vertices made of the one at a place in m_used.
    std::uint32_t numberOf(std::uint32_t place) const
    {
        const auto behind = std::lower_bound(m_extras.begin(), m_extras.end(), place,
                                             [](const auto& extra, std::uint32_t p) { return extra.first < p; });
        return place + (behind == m_extras.begin() ? 0 : std::prev(behind)->second);
    }

    const MeshBody& m_body;
    ColorGroups m_colors;
    ColorGroups::Group m_group{};
    std::size_t m_runLength;
    std::vector<std::uint32_t> m_places; ///< of vertices in m_used
    std::vector<std::uint32_t> m_used;
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        m_extras; ///< place of a vertex with several normals, and how many
                  ///< more than one all up to it have together
    std::vector<std::pair<std::uint64_t, std::uint32_t>>
        m_offsets; ///< corner of the group, and its kind above 0; ascending
};

} // namespace knead
