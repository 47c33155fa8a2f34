#pragma once

#include "core/deformation/field_deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// Where on parts something is, and how much.
struct PlaceOnParts {
    double value = 0;          ///< what it is there
    Vec3 place = Vec3::Zero(); ///< [m]
    std::size_t part = 0;
    std::optional<std::uint32_t> face; ///< of the part; none for a plain mesh
};

/// How well a field goes with the parts that it is to deform.
struct FieldFit {
    Box nodes; ///< [m]
    Box parts; ///< [m]

    double spacing = 0; ///< between nodes: half of them are nearer to each other [m]
    /// Share of the surface whose nearest node is farther than two spacings of the nodes there; than ten where nodes lie on all sides,
    /// as with elements that are longer than thick.
    double uncovered = 0;
    PlaceOnParts farthest;     ///< of the surface from its nearest node [m]
    PlaceOnParts displacement; ///< the largest one [m]
    PlaceOnParts determinant;  ///< the smallest one of the map's gradient: 1 in a rigid body, 0 or less where it folds
    double roughness = 0;      ///< share of nodes that the smooth map misses by more than 2 % of what the field moves
    PlaceOnParts roughest;     ///< the node that it misses most, by how much [m]; part and face say nothing

    std::optional<Message> mismatch; ///< why it is not for these parts, and what to do; none when it is
    std::vector<Message> remarks;    ///< what should be known before

    bool folds() const { return determinant.value <= 0; }
};

/// Looks at points evenly over the surfaces, and at nodes. Any thread.
/// @param map of the deformation, as fieldMap() makes it
/// @param parts their surfaces, none empty @pre at least one
/// @param unit in which the file of the field was read, as LengthUnit::name; empty: unknown
/// @throws Cancelled
FieldFit fitOfField(const FieldDeformation& deformation, const SmoothMap& map, std::span<const TriangleMesh> parts,
                    const std::string& unit = {}, TaskControl& control = TaskControl::none());

} // namespace knead
