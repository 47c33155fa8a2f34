#pragma once

#include "core/mechanics/tool_shape.h"
#include "io/project/json_fields.h"

#include <memory>
#include <string>
#include <string_view>

namespace knead {

/// Where a tool part was in its file, and how large it is; not to be had from its mesh to the last bit.
struct ToolPartPlace {
    Vec3 center = Vec3::Zero(); ///< [m]
    Vec3 size = Vec3::Zero();   ///< [m]
};

template <class Fields>
void describe(Fields& fields, Field<Fields, ToolPartPlace> place)
{
    fields("center_m", place.center);
    fields("size_m", place.size);
}

inline ToolPartPlace placeOf(const ToolPart& part)
{
    return {part.center(), part.size()};
}

/// The surface as the bytes of a model with one part.
std::string toolPartMeshToBytes(const ToolPart& part);

/// @throws Problem, naming what is wrong, for the developer
std::shared_ptr<const ToolPart> toolPartFromBytes(std::string_view mesh, const ToolPartPlace& place);

} // namespace knead
