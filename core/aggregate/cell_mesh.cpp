#include "core/aggregate/cell_mesh.h"

#include "core/aggregate/cell_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace knead {

namespace {

/// Corners of CellShapes in the order of CellMesh::Cell.
constexpr std::array<std::size_t, 8> around{0, 4, 6, 2, 1, 5, 7, 3};

std::vector<CellMesh::NodeSet> setsOf(const FillingToMesh& part, const std::vector<std::uint32_t>& nodeOf,
                                      std::uint32_t none)
{
    const Aggregate& filling = *part.filling;
    CellMesh::NodeSet all{part.name, {}};
    std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
    for (std::size_t i = 0; i < filling.size(); ++i) {
        if (nodeOf[i] == none)
            continue;
        all.nodes.push_back(nodeOf[i]);
        if (filling.face[i] != Aggregate::noFace && std::abs(filling.depth[i]) < 0.5 * filling.lattice.spacing)
            faces[filling.face[i]].push_back(nodeOf[i]);
    }
    std::vector<CellMesh::NodeSet> sets{std::move(all)};
    for (auto& [face, nodes] : faces)
        sets.push_back({part.name + "_FACE_" + std::to_string(face), std::move(nodes)});
    return sets;
}

/// Adds the nodes that cells have, and the cells.
void addFilling(const FillingToMesh& part, CellMesh& mesh)
{
    const Lattice& lattice = part.filling->lattice;
    const CellShapes shapes(*part.filling);
    constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> nodeOf(lattice.size(), none);
    for (const CellShapes::Corners& corners : shapes.cells())
        for (const ObjectIndex corner : corners)
            nodeOf[corner] = 0;
    for (ObjectIndex i = 0; i < lattice.size(); ++i)
        if (nodeOf[i] != none) {
            nodeOf[i] = static_cast<std::uint32_t>(mesh.nodes.size());
            mesh.nodes.push_back(lattice.position(i));
        }
    for (const CellShapes::Corners& corners : shapes.cells()) {
        CellMesh::Cell cell{};
        for (std::size_t i = 0; i < 8; ++i)
            cell[i] = nodeOf[corners[around[i]]];
        mesh.cells.push_back(cell);
    }
    for (CellMesh::NodeSet& set : setsOf(part, nodeOf, none))
        mesh.sets.push_back(std::move(set));
}

template <class Score>
std::uint32_t bestNode(const std::vector<Vec3>& nodes, const Score& score)
{
    const auto best = std::ranges::max_element(nodes, {}, score);
    return static_cast<std::uint32_t>(best - nodes.begin());
}

/// The second is far along x, the third far to the side of the line through both, seen along z: then they hold a turn about each axis.
void addRest(CellMesh& mesh)
{
    const std::uint32_t first = bestNode(mesh.nodes, [](const Vec3& node) { return -node.sum(); });
    const Vec3 from = mesh.nodes[first];
    const std::uint32_t second = bestNode(mesh.nodes, [&](const Vec3& node) {
        const Vec3 way = (node - from).cwiseAbs();
        return way.x() - way.y() - way.z();
    });
    const Vec3 along = mesh.nodes[second] - from;
    const std::uint32_t third = bestNode(mesh.nodes, [&](const Vec3& node) {
        const Vec3 way = node - from;
        return std::abs(along.x() * way.y() - along.y() * way.x());
    });
    mesh.sets.push_back({"REST_1", {first}});
    mesh.sets.push_back({"REST_2", {second}});
    mesh.sets.push_back({"REST_3", {third}});
}

} // namespace

CellMesh cellMesh(std::span<const FillingToMesh> fillings)
{
    CellMesh mesh;
    for (const FillingToMesh& filling : fillings)
        addFilling(filling, mesh);
    if (!mesh.nodes.empty())
        addRest(mesh);
    return mesh;
}

} // namespace knead
