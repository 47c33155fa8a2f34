#pragma once

#include "core/aggregate/pieces.h"
#include "core/integration/anderson_mixing.h"
#include "core/integration/conjugate_gradients.h"
#include "core/integration/minimal_residuals.h"
#include "core/integration/solver_settings.h"
#include "core/integration/tool_hand.h"
#include "core/mechanics/contacts.h"
#include "core/mechanics/rigid_motion.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace knead {

/// Implicit Euler: velocities v and places x + h v at the end of a step such that the forces there give the velocities,
///     M (v - v0) = h f(x + h v, v).
/// Newton's method on this: one linear system (ImplicitSystem) per iteration, whose solution is good enough at once unless the
/// step turns material far or contacts open and close. How far it is followed is searched along its line. Stable for any stiffness and step; motion faster than about 2 pi h
/// is damped out, and what that takes is reported.
///
/// Held objects go on with their velocities. Contacts, friction and joints are inside, at the places of the end of the step, so
/// that what closes within it is met; rigid bodies that move are six unknowns each, since a contact of theirs is stiffer than
/// their mass is heavy by far at such steps. So are tools whose hands push no harder than they may (ToolHand), with their centers.
///
/// Several threads; same bits for any number.
class ImplicitEuler {
public:
    struct BodyView {
        ObjectState* state;
        StructuralConnections* connections;
        RigidMotion* rigid = nullptr; ///< of a rigid body that moves; null for others
        bool deforms = true;
        const Pieces* pieces = nullptr; ///< connected ones, may be others before each step; null: it is one
    };

    /// Bodies, held objects, materials and masses stay what they are as long as it lives.
    /// @param mostHands that a step may have
    explicit ImplicitEuler(std::vector<BodyView> bodies, std::size_t mostHands = 0);

    std::size_t mostHands() const { return m_handRow.size(); }

    /// Share of what acts in a step that it may lack in the end, 1e-4 .. 0.3.
    void setTolerance(double tolerance) { m_tolerance = tolerance; }

    /// What adds the forces of loads to state.force, at the places and velocities tried, and tells their power [W].
    void setLoads(std::function<double()> add) { m_addLoads = std::move(add); }

    struct Report {
        bool converged = true;    ///< else places and velocities are the best found, and a shorter step would do better
        bool isWhole = true;      ///< no piece lacks more as a whole than it may, see NewtonSettings::wholeTolerance
        int newtonIterations = 0; ///< linear systems solved
        int iterations = 0;       ///< of conjugate gradients, in all of them
        double largestSpeed = 0;  ///< [m/s]; not finite when any velocity is not
        double dampingWork = 0;   ///< of state.damping on the objects [J]
        double plastic = 0;       ///< energy that flowed off [J]; what flowed is kept by acceptFlow() only
        double numerical = 0;     ///< energy that the scheme itself took out [J]
        Contacts::Report contacts; ///< at the end
    };

    /// One step. `state.force` and `state.damping` are then those at the end, and contacts have been looked at only: whoever
    /// accepts the step lets them take place.
    /// @param surfaces where they are at the end of the step, with their mean velocities in it; those that hands guide: where they
    /// are likely to be
    /// @param contactEnergy stored in contacts and joints before it [J]
    Report step(Contacts& contacts, std::vector<RigidSurface> surfaces, std::vector<ToolHand> hands,
                const Vec3& gravity, double h, double contactEnergy);

    /// The last step again, from where it has come to: connections have broken at its end.
    /// @param released with them [J]
    Report goOn(Contacts& contacts, const Vec3& gravity, double h, double released);

    /// Lets contacts take place as they are at the end of the last step: joints are made and end, skins heal.
    /// @return what they store, and what went out with that
    Contacts::Report settle(Contacts& contacts, double h);

    /// Where they are at the end of the last step.
    const std::vector<RigidSurface>& surfaces() const { return m_surfaces; }

    /// Takes the last step back.
    void undo();

private:
    Report findEnd(Contacts& contacts, const Vec3& gravity, double h);
    struct Lack;
    bool isBalancedAlready(const Contacts::Report& contacts, double h, double floor);
    void measure(Lack& lack, const std::vector<ContactTangent>& tangents, double h, bool isFirst);
    double goalOf(const Lack& lack, bool flows) const;
    void account(Report& report, double h) const;
    double stickSpeed(double h) const { return solverSettings.newton.stickShare * m_spacing / h; }
    void searchLine(const VectorArray& start, const std::function<void()>& look);
    void noteTouched(const std::vector<ContactTangent>& tangents);
    void guess(std::size_t body, double h);
    Vec3 likelyVelocity(const ToolHand& hand) const;
    void notePresses(const std::vector<ContactTangent>& tangents, double h);
    void rememberStart(double h);
    void weighPieces();
    double massAround(const ObjectRef& object) const;
    Vec3 dragOf(const ContactTangent& tangent, double h) const;
    template <typename Change>
    void forEachNumber(Change&& change) const;
    void takeOverVelocities();
    void tryVelocities(double h);
    Contacts::Report findForces(Contacts& contacts, const ContactStep& step);
    void findResidual(const Contacts::Report& contacts, const Vec3& gravity, double h);
    LinkEnd firstEnd(const ContactTangent& tangent) const { return endOf(tangent.first, tangent.spread); }
    LinkEnd secondEnd(const ContactTangent& tangent) const;
    LinkEnd endOf(const ObjectRef& object, const PointSpread* spread = nullptr) const;
    const Pieces& piecesOf(std::size_t body) const
    {
        return m_bodies[body].pieces != nullptr ? *m_bodies[body].pieces : m_whole[body];
    }
    enum class Renewal : std::uint8_t {
        contacts, ///< and what hands do
        springs,  ///< and these
        all,      ///< and what the preconditioner has of single objects
    };
    void updateSystem(const std::vector<ContactTangent>& tangents, double h, Renewal renewal);
    double goneSinceLinearized(double h) const;
    int solve(double goal);
    double flowedEnergy() const;
    double sizeOf(const VectorArray& momenta);
    double sizeWithoutContacts(const std::vector<ContactTangent>& tangents, double h);
    double sizeOfLoads(const std::vector<ContactTangent>& tangents, double h);
    void addContacts(const std::vector<ContactTangent>& tangents, double duration);
    struct Whole;
    std::vector<std::vector<Whole>> wholesOf(const std::vector<ContactTangent>& tangents, double h) const;
    double lackOfWholes(const std::vector<ContactTangent>& tangents, double h, double leastShare = 0) const;
    double elasticEnergy() const;
    void keepMomenta(const Vec3& gravity, double h);
    void keepMomenta(std::size_t body, const std::vector<std::uint8_t>& touches, const Vec3& gravity, double h);
    double numericalLoss(const Contacts::Report& contacts, double energyChange, double h) const;

    std::vector<BodyView> m_bodies;
    std::function<double()> m_addLoads;
    double m_tolerance = 0.02;
    double m_loadPower = 0;           ///< of the last trial [W]
    std::vector<std::size_t> m_first; ///< row of each body's first object; of a rigid body, of its velocity
    std::vector<std::size_t> m_rigidIndex;
    std::vector<std::size_t> m_handRow; ///< per hand: that of its tool's velocity
    std::vector<std::size_t> m_handIndex;
    std::vector<RigidSurface> m_surfaces; ///< of the last trial
    std::vector<ToolHand> m_hands;        ///< of the step
    /// What the tool of a hand pressed on at the end of a step.
    struct Press {
        std::uint32_t tool = 0; ///< its id
        ObjectRef object;       ///< pushed hardest
        double hardest = 0;     ///< by so much [N]
        double stiffness = 0;   ///< of all its contacts along their normals [N/m]
    };
    std::vector<Press> m_presses;                               ///< of the last step
    std::vector<Press> m_pressesThen;                           ///< of the one before
    Vec3 m_gravity = Vec3::Zero();                              ///< of the step [m/s^2]
    double m_mass = 0;                                          ///< of all bodies [kg]
    double m_spacing = std::numeric_limits<double>::infinity(); ///< the smallest [m]
    ImplicitSystem m_system;
    RigidModePreconditioner m_preconditioner;
    ConjugateGradients m_conjugateGradients;
    MinimalResiduals m_minimalResiduals;      ///< where something slips
    AndersonMixing m_mixing;                  ///< of iterations in which material flows
    std::vector<VectorArray> m_startPosition; ///< per body
    std::vector<VectorArray> m_startVelocity;
    std::vector<std::optional<RigidMotion>> m_startMotion; ///< of rigid bodies that move
    std::vector<Pieces> m_whole;                           ///< of bodies that tell of no pieces
    std::vector<std::vector<double>> m_pieceMass;          ///< per body and piece; infinite where it is held [kg]
    std::vector<std::vector<Vec3>> m_pieceGain;            ///< the same: of velocity, that is likely in the step [m/s]
    double m_startEnergy = 0;                              ///< stored at the start, less what broke since [J]
    VectorArray m_velocity;                                ///< rows: velocities at the end, as far as known
    VectorArray m_residual;
    VectorArray m_linearized; ///< velocities that the springs of the system were linearized at
    VectorArray m_scratch;
    VectorArray m_momenta;            ///< that sizes are found of
    VectorArray m_way;                ///< of the line that is searched
    std::vector<ObjectRef> m_touched; ///< in any trial of this step
    double m_steepness = 0;           ///< of contacts at the end of the last step
    double m_lastStep = 0;            ///< [s]
    bool m_wasBalanced = false;       ///< the last step needed no solution
    double m_factoredStep = 0;        ///< h of the factor in use [s]; 0: none
    double m_freshRate = 0;           ///< iterations per decade when the factor was new; 0: not known
    double m_presentRate = 0;
};

} // namespace knead
