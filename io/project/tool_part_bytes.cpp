#include "io/project/tool_part_bytes.h"

#include "core/message/message.h"
#include "io/worker/model_file.h"

#include <algorithm>

namespace knead {

std::string toolPartMeshToBytes(const ToolPart& part)
{
    Model model;
    Part& only = model.parts.emplace_back();
    only.mesh = part.mesh();
    std::uint32_t faces = 0;
    for (const std::uint32_t face : only.mesh.faceOfTriangle)
        faces = std::max(faces, face + 1);
    only.faces.resize(faces);
    return modelToBytes(model);
}

std::shared_ptr<const ToolPart> toolPartFromBytes(std::string_view mesh, const ToolPartPlace& place)
{
    Model model = modelFromBytes(mesh);
    if (model.parts.size() != 1 || model.parts.front().mesh.empty())
        throw Problem(Message::verbatim("tool part: it has no surface"));
    return std::make_shared<const ToolPart>(std::move(model.parts.front().mesh), place.center, place.size);
}

} // namespace knead
