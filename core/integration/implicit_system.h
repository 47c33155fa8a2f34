#pragma once

#include "core/mechanics/point_spread.h"
#include "core/mechanics/tangent_operator.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace knead {

/// One end of a link: an object, a point of a rigid body, or something that does not give way.
struct LinkEnd {
    static constexpr std::uint32_t immovable = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t row = immovable; ///< of the object, or the first one of the rigid body
    bool isRigid = false;
    Vec3 arm = Vec3::Zero();             ///< of a point of a rigid body, from its center, in units of the body's size
    const PointSpread* spread = nullptr; ///< of a point between objects; null: none such
    std::uint32_t firstRow = 0;          ///< of the objects of its body

    /// Calls visit(row, weight) for the rows of objects that it is a weighed sum of. @pre not immovable, not rigid
    template <typename Visit>
    void forEachRow(Visit&& visit) const
    {
        if (spread == nullptr)
            return visit(row, 1.0);
        for (std::uint32_t n = 0; n < spread->count; ++n)
            visit(firstRow + spread->objects[n], spread->weights[n]);
    }
};

/// Adds a momentum at an end to the rows of its object or body.
void push(const LinkEnd& end, const Vec3& momentum, VectorArray& rows);

/// How a contact or a joint couples two ends: a matrix times their relative velocity.
struct Link {
    LinkEnd first;
    LinkEnd second;
    Mat3 matrix;                ///< symmetric, not negative [kg]
    Vec3 drag = Vec3::Zero();   ///< of what slips along a surface: drag normal^T comes to it [kg]
    Vec3 normal = Vec3::Zero(); ///< unit

    Vec3 momentumOf(const Vec3& between) const { return matrix * between + normal.dot(between) * drag; }
};

/// The linear system of an implicit step, A dv = r with A = M + h C + h^2 K, for all bodies at once. Never assembled; symmetric and
/// positive definite, but for what slips: its friction grows with the pressure, and no pressure with its friction.
///
/// It has one row of three numbers per object of the deformable bodies, body after body, and then two per rigid body that
/// moves: its velocity, and its angular velocity times its size. The linear solver has them in single precision by slots
/// instead (RunSlots), in the same order. What it gives for held objects means nothing.
class ImplicitSystem {
public:
    struct DeformableBody {
        TangentOperator tangent;
        const ObjectState* state;
        std::size_t first; ///< row of its first object
        std::size_t slot;  ///< where its slots begin
    };
    struct RigidBody {
        double mass;       ///< [kg]
        Mat3 inertia;      ///< in the world, by size squared [kg]
        std::size_t first; ///< row of its velocity
        std::size_t slot;  ///< of its velocity
    };

    /// Adds a body; the state and the connections must outlive the system. @return its first row
    std::size_t addDeformable(const StructuralConnections& connections, const ObjectState& state);
    std::size_t addRigid();

    /// Finds A for the present places of the objects. Rigid bodies and links are set apart. @param step h [s]
    void update(double step);
    void setRigid(std::size_t index, double mass, const Mat3& inertia);
    void setLinks(std::vector<Link> links);
    bool isSymmetric() const { return m_isSymmetric; }

    /// By slots. @return u A u [J]
    double multiply(const FloatArray& u, FloatArray& product);

    /// Rows by slots, times a factor; and the other way round, added.
    void gather(const VectorArray& rows, double factor, FloatArray& bySlots) const;
    void addTo(VectorArray& rows, double factor, const FloatArray& bySlots) const;

    void clearHeld(VectorArray& u) const; ///< sets the rows of held objects to 0

    std::size_t rows() const { return m_rows; }
    std::size_t slotCount() const { return m_slots; } ///< with those that stand for nothing; a multiple of eight
    std::uint32_t slotOf(std::size_t row) const { return m_slot[row]; }
    const std::vector<std::uint32_t>& heldRows() const { return m_held; }
    double massOf(std::size_t row) const { return m_mass[row]; } ///< [kg]; of rigid bodies 0
    bool isHeld(std::size_t row) const { return m_isHeld[row] != 0; }
    const std::vector<DeformableBody>& deformables() const { return m_deformables; }
    const std::vector<RigidBody>& rigids() const { return m_rigids; }
    const std::vector<Link>& links() const { return m_links; }

private:
    std::vector<DeformableBody> m_deformables;
    std::vector<RigidBody> m_rigids;
    std::vector<Link> m_links;
    bool m_isSymmetric = true;
    std::vector<double> m_mass;
    std::vector<std::uint8_t> m_isHeld;
    std::vector<std::uint32_t> m_held;
    std::vector<std::uint32_t> m_slot; ///< per row
    std::size_t m_rows = 0;
    std::size_t m_slots = 0;
};

} // namespace knead
