#include "io/mesh/mesh_body.h"

#include <algorithm>

namespace knead {

std::vector<std::optional<Color>> faceColorsOf(const Part& part)
{
    if (std::none_of(part.faces.begin(), part.faces.end(), [](const PartFace& face) { return face.color; }))
        return {};
    std::vector<std::optional<Color>> colors;
    for (const PartFace& face : part.faces)
        colors.push_back(face.color);
    return colors;
}

} // namespace knead
