#pragma once

#include "core/geometry/vec3.h"

#include <limits>

namespace knead {

/// What a contact connection is made of. Its spring stiffens with the overlap d,
///     f = k d (1 + (d / d0)^4)   up to d = d1, from where on the slope stays,
/// so that a light touch is soft enough for long steps and a heavy one hardly sinks in.
struct ContactParameters {
    double stiffness = 0;                                        ///< k [N/m]
    double damping = 0;                                          ///< b, along the normal and of what sticks [N s/m]
    double friction = 0;                                         ///< u, Coulomb
    double stiffening = std::numeric_limits<double>::infinity(); ///< d0 [m]; infinite: the spring is linear
    double steepest = std::numeric_limits<double>::infinity();   ///< d1 [m]
    double frictionDelay = 0;                                    ///< t, by which friction follows the pressure [s]
    /// That the contact acts on [kg]: an explicit scheme pushes no harder than what turns it back within the step, so that a fast
    /// blow on a spring that has stiffened since the time step was chosen does not shoot it away. 0: no such limit.
    double mass = 0;
    /// Tension that ends bear which have touched, F_A, by the spring without its stiffening [N]: it stays what it is until they part.
    /// 0: they push only.
    double adhesion = 0;
    double adhesionReach = 0; ///< gap at which they part, if not that at which the spring bears F_A is larger [m]
    /// Beyond it the spring force stays what it is there, so that bodies placed inside each other do not shoot apart [m].
    double largestOverlap = std::numeric_limits<double>::infinity();
};

/// The spring of a contact at an overlap.
struct ContactSpring {
    double force = 0;  ///< f [N]
    double slope = 0;  ///< df/dd [N/m]
    double energy = 0; ///< integral of f [J]
};
/// @param sticks whether its ends have touched and hold on to each other: apart they pull, up to the adhesion
ContactSpring contactSpring(double overlap, const ContactParameters& parameters, bool sticks = false);

/// What friction remembers from step to step.
struct FrictionMemory {
    Vec3 hold = Vec3::Zero(); ///< what its spring held against at the end of the last step [N]
    double pressure = 0;      ///< F_P, the normal force that it goes by [N]
    bool sticks = false;      ///< the ends touched, and have not been torn apart since: see ContactParameters::adhesion

    bool isEmpty() const { return pressure == 0 && hold.isZero(0) && !sticks; }
};

/// How the two ends of a contact lie and move.
struct ContactState {
    double overlap = 0;                   ///< l - distance, > 0 when they touch [m]
    Vec3 normal = Vec3::UnitZ();          ///< unit, from the opposite object p (or the tool) to o
    Vec3 relativeVelocity = Vec3::Zero(); ///< v_o - v_p [m/s]
    FrictionMemory memory;                ///< of the last step
};

/// The step that contact forces are for.
struct ContactStep {
    double duration = 0; ///< dt [s]
    /// Slides of joints slower than this are braked in proportion to their speed [m/s], as an implicit scheme can; 0 for explicit
    /// ones.
    double stickSpeed = 0;
    /// Only to see what would be: makes and ends no joints, moves no anchor of friction, and reports how the forces answer to
    /// motion.
    bool isTrial = false;
    /// Springs keep the slope that they have at so many d0, where theirs would be steeper: Newton's method on the fifth power takes
    /// a fifth of what is too deep at a time, and on this goes straight to where it is bearable.
    double steepest = std::numeric_limits<double>::infinity();
    /// A trial without time: what was placed inside is pushed out at once.
    bool isStatic = false;
    bool isBalance = false; ///< of such a trial: it is the one that friction remembers

    /// A trial in which ends that touched at the end of the last step hold on to each other, as where a tool is lifted off most of
    /// them go along with it: the first guess of what else would seem to come free.
    bool clings = false;

    bool remembers() const { return !isTrial || isBalance; }
    bool isImplicit() const { return stickSpeed > 0; }
};

/// What a contact does to object o; the opposite end gets the opposite.
struct ContactResult {
    Vec3 spring = Vec3::Zero();   ///< conservative part of the force [N]
    Vec3 damping = Vec3::Zero();  ///< of damper and friction [N]; what it does on the relative motion is lost
    Vec3 friction = Vec3::Zero(); ///< the part of damping that is friction [N]
    double energy = 0;            ///< stored in the spring [J]
    double released = 0;          ///< and what was, of ends that stuck and have parted [J]
    double slope = 0;             ///< of the spring [N/m]
    double steepness = 0;         ///< d / d0, of no more than d1

    FrictionMemory memory; ///< for the next step
    /// Of a trial: how the force at the end of the step answers to the relative velocity, the pressure that friction goes by as it is;
    /// symmetric, not negative [N s/m].
    Mat3 resistance = Mat3::Zero();
    /// And what that leaves out of what slips, as it is not symmetric: friction grows with the pressure. The force answers by
    /// drag normal^T as well [N s/m].
    Vec3 drag = Vec3::Zero();

    Vec3 force() const { return spring + damping; }
};

/// Force of a contact connection, eqs (2), (5) and (7) with signs repaired, per connection.
/// Contacts push only: the sum of spring and damper is clamped at 0. Where there is adhesion they pull as well, up to it, once they
/// have touched; and friction goes by the pressure and the adhesion together, u (F_P + F_A).
///
/// Friction remembers (Cundall and Strack 1979): a spring as stiff as the contact is, f / d, holds against the slide since the
/// ends met, and gives way where that exceeds u F_P. So what sticks does not creep, at rest as well as in the limit of
/// eq (7). The same law serves explicit and implicit schemes.
///
/// In explicit steps the limit follows the normal force late, dF_P/dt = (F_N - F_P) / t (Prakash and Clifton 1993): with Coulomb's
/// own law an elastic body that slides over a hard one flutters without end (Adams 1995), and creeps down a slope on which it would
/// stay. Implicit steps are long and damp that away: there F_P = F_N.
ContactResult contactForce(const ContactState& state, const ContactParameters& parameters, const ContactStep& step);

/// Share of the pressure before in the one that friction goes by after a step, exp(-dt / t); 0 in implicit steps and without delay.
/// The second is that of ends that are apart, see parted().
double pressureKept(const ContactParameters& parameters, const ContactStep& step);
double pressureKeptApart(const ContactParameters& parameters, const ContactStep& step);

/// What friction remembers of ends that are apart: the pressure, nearly as it was. An elastic body that slides rattles; as F_P stands
/// still while it is in the air, the friction of many short touches is u times their mean normal force. With a pressure that begins at
/// 0 in each touch it would be less, by a fifth for a block of soft rubber.
FrictionMemory parted(const FrictionMemory& memory, const ContactParameters& parameters, const ContactStep& step);

/// Parameters of a contact between two objects, so that two alike give their own: springs and dampers in series (harmonic
/// mean), the geometric mean of the frictions, the lesser overlap cap.
ContactParameters combine(const ContactParameters& a, const ContactParameters& b);

} // namespace knead
