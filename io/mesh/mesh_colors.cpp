#include "io/mesh/mesh_colors.h"

#include <algorithm>

namespace knead {

void paintTriangles(Part& part, const std::vector<std::optional<Color>>& colors)
{
    constexpr std::size_t mostFaces = 256; // more is a painting, not a part with colored faces
    std::vector<std::optional<Color>> palette;
    std::vector<std::uint32_t> faces;
    faces.reserve(colors.size());
    for (const std::optional<Color>& color : colors) {
        auto entry = std::find(palette.begin(), palette.end(), color);
        if (entry == palette.end()) {
            if (palette.size() == mostFaces)
                return;
            entry = palette.insert(palette.end(), color);
        }
        faces.push_back(static_cast<std::uint32_t>(entry - palette.begin()));
    }
    if (palette.empty())
        return;
    part.color = palette.front();
    if (palette.size() == 1)
        return;
    for (const std::optional<Color>& color : palette)
        part.faces.push_back({color == part.color ? std::nullopt : color});
    part.mesh.faceOfTriangle = std::move(faces);
}

} // namespace knead
