#pragma once

#include "core/integration/anderson_mixing.h"
#include "core/integration/conjugate_gradients.h"
#include "core/mechanics/contacts.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace knead {

/// Places of the objects at which no free object feels a force, without inertia and without dampers: f(x) = 0.
///
/// Newton's method on the operator of the implicit scheme (ImplicitSystem) for a step so long that masses do not count; they
/// are in the operator only, never in the forces, so that what is found does not depend on them. That operator is positive
/// definite where the true one is not (connections under compression), which makes it a safe direction but a slow one; steps are
/// mixed with the ones before (Anderson) to be quick again, kept short enough for the material to turn with them, and searched
/// along a line until the force along it is small.
///
/// Friction is that of the way from the start of the load step to its end, as of one slide.
/// Several threads; same bits for any number.
class StaticEquilibrium {
public:
    struct BodyView {
        ObjectState* state;
        StructuralConnections* connections;
        bool deforms = true; ///< else it is held: a rigid body that is free to move has no place here
    };

    /// Bodies, held objects, materials and masses stay what they are as long as it lives.
    explicit StaticEquilibrium(std::vector<BodyView> bodies);

    struct Settings {
        double tolerance = 1e-7;  ///< of forces that are left, by those that act (2-norms over all objects)
        int mostIterations = 150; ///< linear systems
        TaskControl* control = &TaskControl::none();
    };
    /// What acts, besides the material.
    struct Loads {
        Contacts* contacts = nullptr;
        std::span<const RigidSurface>
            surfaces; ///< where they are at the end; their velocities are ways by waySeconds()
        Vec3 gravity = Vec3::Zero();
        std::function<double()> add; ///< adds forces to state.force at present places [N]; may be none
        /// Told how far any object may have gone since it was told last, before forces are looked at [m]; may be none.
        std::function<void(double travel)> moved;
        double flowTime =
            0; ///< in which material flows, from where it was on [s]; StructuralConnections keeps that on asking only
        double farthestStep = std::numeric_limits<double>::infinity(); ///< of any object at a time [m]
    };
    struct Report {
        bool converged = false;
        bool isFree = false; ///< some piece of material is held by nothing
        double residual = 0; ///< forces left, by those that act
        int newtonIterations = 0;
        int iterations = 0;  ///< of conjugate gradients, in all of them
        double farthest = 0; ///< that any object went [m]
        Contacts::Report contacts;
    };

    /// Free objects go to where there is balance; held ones have been put where they are to be. `start` is where all were
    /// before, which friction needs. Afterwards velocities are ways by waySeconds(), and forces those of the balance.
    /// When it fails places are the last tried. @throws Cancelled, then too
    Report solve(const Loads& loads, const std::vector<VectorArray>& start, const Settings& settings);

    /// The long step that ways are divided by to be velocities [s].
    double waySeconds() const { return m_step; }

private:
    /// @param isBalance friction remembers these
    Contacts::Report findForces(const Loads& loads, const std::vector<VectorArray>& start, bool isBalance = false);
    void findResidual(const Vec3& gravity, const std::vector<ContactTangent>& tangents);
    void move(const VectorArray& way, double share);
    std::vector<Link> linksOf(const std::vector<ContactTangent>& tangents) const;
    bool isFree(const std::vector<ContactTangent>& tangents) const;
    VectorArray newtonStep(const std::vector<ContactTangent>& tangents, Report& report, const TaskControl& control);
    VectorArray mixed(const VectorArray& place, const VectorArray& step);
    double largestStrain(const VectorArray& way) const;
    static double longest(const VectorArray& way);
    LinkEnd endOf(const ObjectRef& object, const PointSpread* spread = nullptr) const;

    std::vector<BodyView> m_bodies;
    std::vector<std::size_t> m_first; ///< row of each body's first object
    ImplicitSystem m_system;
    RigidModePreconditioner m_preconditioner;
    ConjugateGradients m_solver;
    double m_step = 0;                                          ///< [s]
    double m_spacing = std::numeric_limits<double>::infinity(); ///< the smallest [m]
    VectorArray m_residual;                                     ///< rows: forces on free objects [N]
    double m_acting = 0;                                        ///< 2-norm of what acts now [N]
    double m_mostActing = 0;                                    ///< the largest so far [N]
    AndersonMixing m_mixing;
    int m_freshIterations = 0; ///< of the first system with the factor in use; 0: none
};

} // namespace knead
