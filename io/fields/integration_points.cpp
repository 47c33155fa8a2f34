#include "io/fields/integration_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace knead {

namespace {

/// A kind of solid cell, and at how many points CalculiX integrates it where a file does not say.
struct SolidCell {
    std::uint8_t vtkType = 0;
    std::uint8_t points = 0;
    std::uint8_t corners = 0; ///< its first nodes
};
constexpr std::array<SolidCell, 6> solidCells{
    {{10, 1, 4}, {12, 8, 8}, {13, 2, 6}, {24, 4, 4}, {25, 27, 8}, {26, 9, 6}}};

const SolidCell* solidCellOf(const NodalMesh& mesh, std::size_t cell)
{
    const auto found = std::ranges::find(solidCells, mesh.cells.types[cell], &SolidCell::vtkType);
    return found == solidCells.end() ? nullptr : &*found;
}

std::vector<Vec3> nodesOf(const NodalMesh& mesh, std::size_t cell)
{
    std::vector<Vec3> nodes;
    for (auto n = mesh.cells.offsets[cell]; n < mesh.cells.offsets[cell + 1]; ++n)
        nodes.push_back(mesh.nodes[static_cast<std::size_t>(mesh.cells.connectivity[static_cast<std::size_t>(n)])]);
    return nodes;
}

/// Of the eight corners of a brick, trilinear. @param at -1 .. 1
Vec3 inBrick(std::span<const Vec3> corners, const Vec3& at)
{
    constexpr std::array<std::array<int, 3>, 8> signs{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const auto& [x, y, z] = signs[i];
        sum += 0.125 * (1 + x * at.x()) * (1 + y * at.y()) * (1 + z * at.z()) * corners[i];
    }
    return sum;
}

std::vector<Vec3> gaussOfBrick(std::span<const Vec3> corners, std::span<const double> alongAxis)
{
    std::vector<Vec3> places;
    for (const double z : alongAxis)
        for (const double y : alongAxis)
            for (const double x : alongAxis)
                places.push_back(inBrick(corners, {x, y, z}));
    return places;
}

std::vector<Vec3> gaussOfTetrahedron(std::span<const Vec3> corners)
{
    const double far = (5 + 3 * std::sqrt(5)) / 20;
    const double near = (5 - std::sqrt(5)) / 20;
    std::vector<Vec3> places;
    for (std::size_t point = 0; point < 4; ++point) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < 4; ++i)
            sum += (i == point ? far : near) * corners[i];
        places.push_back(sum);
    }
    return places;
}

} // namespace

std::vector<Vec3> integrationPlaces(const NodalMesh& mesh, std::size_t cell)
{
    const SolidCell* kind = solidCellOf(mesh, cell);
    if (kind == nullptr)
        return {};
    const std::uint8_t told = mesh.cells.points.empty() ? 0 : mesh.cells.points[cell];
    const std::size_t count = told > 0 ? told : kind->points;
    const std::vector<Vec3> nodes = nodesOf(mesh, cell);
    if (kind->corners == 8 && count == 8)
        return gaussOfBrick(nodes, std::array{-1 / std::sqrt(3), 1 / std::sqrt(3)});
    if (kind->corners == 8 && count == 27)
        return gaussOfBrick(nodes, std::array{-std::sqrt(0.6), 0.0, std::sqrt(0.6)});
    if (kind->corners == 4 && count == 4)
        return gaussOfTetrahedron(nodes);
    return std::vector<Vec3>(count, centerOf(mesh, cell));
}

Vec3 centerOf(const NodalMesh& mesh, std::size_t cell)
{
    const std::vector<Vec3> nodes = nodesOf(mesh, cell);
    Vec3 sum = Vec3::Zero();
    for (const Vec3& node : nodes)
        sum += node;
    return sum / static_cast<double>(nodes.size());
}

bool isSolidCell(const NodalMesh& mesh, std::size_t cell)
{
    return solidCellOf(mesh, cell) != nullptr;
}

} // namespace knead
