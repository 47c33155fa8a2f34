#include "core/model/face_names.h"

#include <algorithm>

namespace knead {

bool haveTellingNames(const std::vector<PartFace>& faces)
{
    if (faces.size() == 1)
        return !faces.front().name.empty();
    return std::ranges::any_of(faces, [&](const PartFace& face) { return face.name != faces.front().name; });
}

std::string tellingName(const std::vector<PartFace>& faces, std::uint32_t face)
{
    return face < faces.size() && haveTellingNames(faces) ? faces[face].name : std::string();
}

} // namespace knead
