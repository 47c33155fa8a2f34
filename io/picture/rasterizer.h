#pragma once

#include "io/mesh/corner_normals.h"

#include <cstdint>
#include <vector>

namespace knead {

/// A parallel projection. Screen x runs right, y down, both in samples; depth grows away from the eye [m].
struct Projection {
    Vec3 right;   ///< unit
    Vec3 down;    ///< unit
    Vec3 forward; ///< unit, from the eye to the part
    double samplesPerMeter = 1;
    double offsetX = 0; ///< [samples]
    double offsetY = 0; ///< [samples]

    Vec3 toScreen(const Vec3& point) const
    {
        return {samplesPerMeter * right.dot(point) + offsetX, samplesPerMeter * down.dot(point) + offsetY,
                forward.dot(point)};
    }
    /// The point at depth 0 that is seen at a place of the screen.
    Vec3 fromScreen(double x, double y) const
    {
        return ((x - offsetX) * right + (y - offsetY) * down) / samplesPerMeter;
    }
};

/// Triangles ready to draw.
struct ScreenMesh {
    std::vector<Vec3> places; ///< on the screen
    std::vector<TriangleMesh::Triangle> triangles;
    CornerNormals normals;                        ///< in space
    std::vector<std::uint32_t> surfaceOfTriangle; ///< index of what is drawn, for its color
};

/// What one sample sees.
struct Sample {
    static constexpr std::uint32_t nothing = 0xffffffffU;

    float depth = 0;
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< towards the eye on both sides of a surface
    std::uint32_t surface = nothing;
};

/// Some rows of the picture, finer than its pixels.
struct SampleBand {
    int width = 0;
    int firstRow = 0;
    int rows = 0;
    std::vector<Sample> samples; ///< row by row

    const Sample& at(int x, int row) const
    {
        return samples[static_cast<std::size_t>(row - firstRow) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
    }
};

/// Draws with a z-buffer. Bands are independent of each other.
SampleBand rasterize(const ScreenMesh& mesh, const Projection& projection, int width, int firstRow, int rows);

} // namespace knead
