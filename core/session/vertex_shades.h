#pragma once

#include "core/geometry/vec3.h"
#include "core/task/parallel.h"

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

namespace knead {

/// How light each render vertex is drawn. On all threads.
/// @param points, normals x y z per render vertex, as they are drawn
/// @param shadeAt(place, normal): 1 for all light; called from several threads
/// @return per render vertex; empty where all keep all light
template <class ShadeAt>
std::vector<float> vertexShades(std::span<const float> points, std::span<const float> normals, const ShadeAt& shadeAt)
{
    constexpr std::size_t verticesAtOnce = 2048; // per thread
    const auto at = [](std::span<const float> values, std::size_t vertex) -> Vec3 {
        return Eigen::Map<const Eigen::Vector3f>(values.data() + 3 * vertex).cast<double>();
    };
    std::vector<float> shades(points.size() / 3);
    std::atomic<bool> isAny = false;
    forEachBlock(shades.size(), verticesAtOnce, [&](std::size_t begin, std::size_t end) {
        bool isHere = false;
        for (std::size_t vertex = begin; vertex < end; ++vertex) {
            const double shade = shadeAt(at(points, vertex), at(normals, vertex));
            shades[vertex] = static_cast<float>(shade);
            isHere = isHere || shade < 1;
        }
        if (isHere)
            isAny = true;
    });
    return isAny ? shades : std::vector<float>();
}

} // namespace knead
