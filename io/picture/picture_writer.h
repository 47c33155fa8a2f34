#pragma once

#include "io/formats/mesh_writer.h"

#include <string>
#include <vector>

namespace knead {

struct PictureOptions {
    int width = 1280;
    int height = 800;
    Vec3 viewDirection = Vec3(-1, 1.4, -0.8); ///< from the eye to the part, any length
    Vec3 up = Vec3::UnitZ();
};

/// Draws bodies, with the colors of their faces, to a PNG without a display or a graphics card: z-buffer, smooth shading with sharp CAD edges, parallel
/// projection fitted to the bodies, anti-aliased, light background, soft ground shadow when it helps.
/// @throws Problem.
/// @param glass what is drawn as if of glass, so that one sees what it does to the bodies
void writePicture(const std::string& path, const std::vector<MeshBody>& bodies, const PictureOptions& options = {},
                  const std::vector<MeshBody>& glass = {});

} // namespace knead
