#pragma once

#include "core/aggregate/aggregate.h"
#include "core/task/task_control.h"

#include <span>
#include <vector>

namespace knead {

/// Carries points of the imported surface along with the objects: x(X) = X + sum_i phi_i(X) u_i, where u_i is the
/// displacement of object i and phi are quadratic moving-least-squares shape functions with C2 weights whose
/// support is about 3 spacings below a flat face. The map reproduces affine (and quadratic) displacement fields, and is C2 in X.
///
/// Objects that influence a point are gathered along connections (at most three steps from the cell that owns the
/// point), so material across a gap does not pull. Where few objects are near, at sharp corners and on fins too thin to
/// hold any, the support is wider; where the objects do not determine a quadratic function, a linear one takes over by and by,
/// then a constant one, so that the map is continuous wherever the connections are.
///
/// Points are of the opened part; where the body was filled anew from a former shape, they are taken there first.
///
/// Immutable after construction; evaluate() may run on any number of threads and uses several itself.
class Skin {
public:
    /// @throws std::invalid_argument for an aggregate without objects. @throws Cancelled
    Skin(const Aggregate& aggregate, std::span<const Vec3> points, TaskControl& control = TaskControl::none());

    /// Of points that are where the body was filled already.
    static Skin ofPlacesWhenFilled(const Aggregate& aggregate, std::vector<Vec3> places,
                                   TaskControl& control = TaskControl::none());

    /// One of the points of all of them, each attached to some objects of a body.
    /// @param numbers per part: its objects in the body
    static Skin joined(std::span<const Skin> parts, std::span<const std::vector<ObjectIndex>> numbers);

    std::size_t size() const { return m_points.size(); }
    std::span<const Vec3> points() const
    {
        return m_points;
    } ///< when the body was filled: at rest, or in its former shape

    /// Current places of the points.
    /// @param displacement one per object of the aggregate [m]
    /// @param places size() entries, written [m]
    void evaluate(std::span<const Vec3> displacement, std::span<Vec3> places) const;

    /// Objects and weights of one point, for tests and for picking.
    struct Influence {
        ObjectIndex object;
        float weight;
    };
    std::span<const Influence> influences(std::size_t point) const
    {
        return {m_influences.data() + m_first[point], m_first[point + 1] - m_first[point]};
    }

private:
    Skin() = default;
    void attach(const Aggregate& aggregate, TaskControl& control);

    std::vector<Vec3> m_points;
    std::vector<std::uint32_t> m_first; ///< size() + 1
    std::vector<Influence> m_influences;
};

} // namespace knead
