#include "core/skin/surface_fit.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int corrections = 4;

} // namespace

std::size_t mostRefilledTriangles(const Aggregate& aggregate)
{
    return std::clamp<std::size_t>(200 * aggregate.size(), 20'000, 400'000);
}

void fitToSurface(const Skin& skin, std::span<const Vec3> wanted, std::vector<Vec3>& displacements)
{
    std::vector<Vec3> places(skin.size());
    std::vector<Vec3> change(displacements.size());
    std::vector<double> weight(displacements.size());
    for (int n = 0; n < corrections; ++n) {
        skin.evaluate(displacements, places);
        std::ranges::fill(change, Vec3::Zero());
        std::ranges::fill(weight, 0.0);
        for (std::size_t p = 0; p < skin.size(); ++p) {
            const Vec3 lack = wanted[p] - places[p];
            double sum = 0;
            for (const Skin::Influence& influence : skin.influences(p))
                sum += std::abs(static_cast<double>(influence.weight));
            for (const Skin::Influence& influence : skin.influences(p)) {
                const auto share = static_cast<double>(influence.weight);
                change[influence.object] += share / sum * lack;
                weight[influence.object] += std::abs(share);
            }
        }
        for (std::size_t i = 0; i < change.size(); ++i)
            if (weight[i] > 0)
                displacements[i] += change[i] / weight[i];
    }
}

void append(TriangleMesh& all, const TriangleMesh& mesh)
{
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles)
        all.triangles.push_back({first + a, first + b, first + c});
    all.faceOfTriangle.insert(all.faceOfTriangle.end(), mesh.faceOfTriangle.begin(), mesh.faceOfTriangle.end());
}

} // namespace knead
