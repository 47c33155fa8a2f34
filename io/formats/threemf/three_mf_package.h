#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knead {

inline constexpr std::size_t mostThreeMfTriangles = 200'000'000; ///< of an object, and of all instances of a file

/// The name of a file in the archive as it is compared: names have no "/" at their beginning there, and programs do not agree on large
/// letters.
std::string threeMfFile(std::string_view name);

/// An object of a 3MF: the file of its archive that it is in, by threeMfFile(), and its number there.
using ThreeMfId = std::pair<std::string, std::uint32_t>;

/// An object at a place, of the build or of another object. Lengths are in the unit of the file.
struct ThreeMfPlaced {
    ThreeMfId object;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
};

/// A mesh, or other objects put together.
struct ThreeMfObject {
    std::string name;  ///< as it is written; empty: none
    std::string layer; ///< of what helps to make parts and is none: "support" or "other"; else empty
    bool isMesh = true;
    TriangleMesh mesh;                        ///< vertices in the unit of the file
    std::vector<std::optional<Color>> colors; ///< per triangle
    std::vector<ThreeMfPlaced> components;    ///< of what is no mesh
};

/// What a 3MF holds (3MF Core Specification 1.3; of its extensions the colors of materials and the files of production).
struct ThreeMfPackage {
    std::string unit = "mm"; ///< as LengthUnit::name
    std::map<ThreeMfId, ThreeMfObject> objects;
    std::vector<ThreeMfPlaced> build;
    std::set<std::string> unknownExtensions; ///< addresses of those that it requires and nothing here reads
    std::size_t flaws = 0;                   ///< places that do not keep to the format, and were passed over

    /// @throws DamagedThreeMf, when there is none
    const ThreeMfObject& object(const ThreeMfId& id) const;
};

struct DamagedThreeMf {};

/// Reads an archive; indices of triangles are of vertices that are there, and all numbers finite.
/// @param control is told of the whole of this
/// @throws DamagedThreeMf. @throws Cancelled
ThreeMfPackage readThreeMfPackage(const std::string& path, TaskControl& control);

} // namespace knead
