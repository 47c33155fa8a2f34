#pragma once

#include "core/deformation/field_deformation.h"
#include "core/deformation/number_deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/task/task_control.h"

#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace knead {

/// What a person does to a part without forces. A plain value: it goes into recipes, projects and other processes.
using Deformation = std::variant<NumberDeformation, FieldDeformation>;

/// The map of a deformation. Any thread.
/// @throws Problem where it is none: planes in one place, a field without nodes. @throws Cancelled
std::shared_ptr<const SmoothMap> mapOf(const Deformation& deformation, TaskControl& control = TaskControl::none());

/// Maps one after the other, the first one first. What a face is carried by (SmoothMap::ofFace) follows through all of them.
class ChainedMap final : public SmoothMap {
public:
    /// @pre at least one, none null
    explicit ChainedMap(std::vector<std::shared_ptr<const SmoothMap>> maps);

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;
    double featureSize() const override { return m_featureSize; } ///< the smallest of them
    const SmoothMap& ofFace(std::span<const Vec3> places) const override;

    /// In their order.
    std::span<const std::shared_ptr<const SmoothMap>> maps() const { return m_maps; }

private:
    class OfFaces;

    std::vector<std::shared_ptr<const SmoothMap>> m_maps;
    double m_featureSize = 0;
    std::shared_ptr<OfFaces> m_ofFaces; ///< chains for faces, made when asked for
};

/// All of them one after the other. @pre at least one @throws as mapOf()
std::shared_ptr<const SmoothMap> mapOf(std::span<const Deformation> deformations,
                                       TaskControl& control = TaskControl::none());

} // namespace knead
