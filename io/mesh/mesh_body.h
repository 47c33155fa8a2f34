#pragma once

#include "core/model/part.h"

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Numbers at the vertices of a surface, such as its displacement.
struct MeshField {
    std::string name;           ///< with its unit, as it is to be shown: "displacement [m]"
    std::size_t components = 1; ///< numbers a vertex
    std::vector<float> values;  ///< those of a vertex one after the other
};

/// A named, colored surface to write.
struct MeshBody {
    std::string name; ///< UTF-8
    Color color;
    TriangleMesh mesh; ///< [m]
    std::vector<std::optional<Color>>
        faceColors{};                ///< by mesh.faceOfTriangle, where they differ from `color`; may be empty
    std::vector<MeshField> fields{}; ///< written to VTP only
};

/// The colors of a part's faces for MeshBody::faceColors; empty when no face has its own.
std::vector<std::optional<Color>> faceColorsOf(const Part& part);

} // namespace knead
