#pragma once

#include "core/aggregate/aggregate.h"
#include "core/task/task_control.h"

#include <span>
#include <vector>

namespace knead {

/// The gradient of the map that carries the skin (see skin.h) at points of the surface:
///   F(X) = I + sum_i u_i grad phi_i(X)^T,
/// grad phi being the linear terms of the moving-least-squares fit at X: exact where displacements are quadratic, as in bending,
/// where the fit of an object's own connections is one for a place up to a spacing below the skin.
///
/// 20 bytes per object that influences a point, of which there are about 30: 60 MB for 100,000 points.
/// Immutable after construction; its members may be called from any thread.
class SkinGradients {
public:
    /// @param numbers of the aggregate's objects in the body that they are a piece of; empty: their own
    /// @throws std::invalid_argument for an aggregate without objects. @throws Cancelled
    SkinGradients(const Aggregate& aggregate, std::span<const Vec3> points, std::span<const ObjectIndex> numbers = {},
                  TaskControl& control = TaskControl::none());

    std::size_t size() const { return m_trust.size(); }

    struct Influence {
        std::uint32_t carrier; ///< place of the object in carriers()
        float value;           ///< phi; those of a point sum to 1
        Eigen::Vector3f slope; ///< grad phi [1/m]
    };
    std::span<const Influence> influences(std::size_t point) const
    {
        return {m_influences.data() + m_first[point], m_count[point]};
    }

    /// All points, such that those near each other come one after the other: they are told fastest in this order.
    const std::vector<std::uint32_t>& order() const { return m_order; }

    /// Objects that influence any point, ascending.
    const std::vector<ObjectIndex>& carriers() const { return m_carriers; }

    /// 0 .. 1: how far the objects around a point say a gradient there; less than 1 where they lie in a plane or on a line.
    double trust(std::size_t point) const { return static_cast<double>(m_trust[point]); }

    /// sum_i u_i grad phi_i^T = F - I. @param displacements one per carrier [m]
    Mat3 sumOfProducts(std::size_t point, std::span<const Vec3> displacements) const;

private:
    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_first; ///< per point, as the next
    std::vector<std::uint32_t> m_count;
    std::vector<Influence> m_influences; ///< in that order of points
    std::vector<float> m_trust;
    std::vector<ObjectIndex> m_carriers;
};

} // namespace knead
