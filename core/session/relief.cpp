#include "core/session/relief.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr float seenRadius = 0.06F; // of curvature, in sizes of the part: a hollow of that is half as dark as can be
constexpr float darkest = 0.5F;     // that a hollow loses
constexpr float lightest = 0.12F;   // that a ridge gains
constexpr int averages = 2;         // over neighbors

Eigen::Map<const Eigen::Vector3f> at(std::span<const float> values, std::uint32_t vertex)
{
    return Eigen::Map<const Eigen::Vector3f>(values.data() + std::size_t{3} * vertex);
}

} // namespace

std::vector<float> reliefShades(const RenderMesh& mesh, std::span<const float> points, std::span<const float> normals)
{
    // Render vertices are split along edges of the part: what they are split from is one.
    std::uint32_t count = 0;
    for (const std::uint32_t vertex : mesh.source)
        count = std::max(count, vertex + 1);
    std::vector<Eigen::Vector3f> umbrella(count, Eigen::Vector3f::Zero());
    std::vector<Eigen::Vector3f> normal(count, Eigen::Vector3f::Zero());
    std::vector<float> length(count, 0.0F);
    std::vector<float> neighbors(count, 0.0F);
    for (std::uint32_t vertex = 0; vertex < mesh.source.size(); ++vertex)
        normal[mesh.source[vertex]] += at(normals, vertex);
    const auto forEachSide = [&mesh](auto&& visit) {
        for (const auto& corners : mesh.triangles)
            for (int side = 0; side < 3; ++side)
                visit(corners[static_cast<std::size_t>(side)], corners[static_cast<std::size_t>((side + 1) % 3)]);
    };
    forEachSide([&](std::uint32_t from, std::uint32_t to) { // each edge comes twice, once from either side
        const Eigen::Vector3f way = at(points, to) - at(points, from);
        const float distance = way.norm();
        if (distance == 0)
            return;
        const std::uint32_t a = mesh.source[from];
        const std::uint32_t b = mesh.source[to];
        umbrella[a] += way / distance;
        umbrella[b] -= way / distance;
        for (const std::uint32_t end : {a, b}) {
            length[end] += distance;
            neighbors[end] += 1;
        }
    });
    Eigen::AlignedBox3f box;
    for (std::uint32_t vertex = 0; vertex < mesh.source.size(); ++vertex)
        box.extend(Eigen::Vector3f(at(points, vertex)));
    const float reach = box.isEmpty() ? 0 : seenRadius * box.diagonal().norm();
    std::vector<float> bend(count, 0.0F);
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
        if (length[vertex] == 0)
            continue;
        const float curvature = 2 * normal[vertex].stableNormalized().dot(umbrella[vertex]) / length[vertex];
        const float edge = length[vertex] / neighbors[vertex];
        bend[vertex] = curvature * reach * std::min(1.0F, reach / edge);
    }
    for (int n = 0; n < averages; ++n) {
        std::vector<float> sum = bend;
        std::vector<float> share(count, 1.0F);
        forEachSide([&](std::uint32_t from, std::uint32_t to) {
            const std::uint32_t a = mesh.source[from];
            const std::uint32_t b = mesh.source[to];
            sum[a] += 0.5F * bend[b];
            sum[b] += 0.5F * bend[a];
            share[a] += 0.5F;
            share[b] += 0.5F;
        });
        for (std::uint32_t vertex = 0; vertex < count; ++vertex)
            bend[vertex] = sum[vertex] / share[vertex];
    }
    std::vector<float> shades(mesh.source.size());
    for (std::size_t vertex = 0; vertex < shades.size(); ++vertex) {
        const float x = bend[mesh.source[vertex]];
        shades[vertex] = 1 - (x > 0 ? darkest : lightest) * x / (1 + std::abs(x));
    }
    return shades;
}

float bendOfShade(float shade)
{
    return std::clamp((1 - shade) / (shade < 1 ? darkest : lightest), -1.0F, 1.0F);
}

} // namespace knead
