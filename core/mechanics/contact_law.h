#pragma once

#include "core/geometry/vec3.h"

namespace knead {

/// What a contact connection is made of.
struct ContactParameters {
    double stiffness = 0;   ///< k [N/m]
    double damping = 0;     ///< b [N s/m]
    double friction = 0;    ///< u, Coulomb
    double reducedMass = 0; ///< of the two objects; an object's own mass against a tool [kg]
    double onset = 0;       ///< overlap over which the stiffness rises from 0 to k: flat faces that meet all at once
    ///< within a step would jolt an explicit scheme [m]. In the implicit one, whose iterations a
    ///< straight line suits better, it is k beyond half of this; that is the same beyond all of it
    double largestOverlap =
        0; ///< beyond it the spring force stays what it is there, so that a tool placed inside a body
           ///< pushes it out instead of shooting it away [m]
};

/// How the two ends of a contact lie and move.
struct ContactState {
    double overlap = 0;                   ///< l - distance, > 0 when they touch [m]
    Vec3 normal = Vec3::UnitZ();          ///< unit, from the opposite object p (or the tool) to o
    Vec3 relativeVelocity = Vec3::Zero(); ///< v_o - v_p [m/s]
    double slip = 0;                      ///< friction by slide, of the trial before, if it is to be kept [N s/m]
};

/// The step that contact forces are for.
struct ContactStep {
    double duration = 0; ///< dt [s]
    /// Slides slower than this are braked in proportion to their speed [m/s], as an implicit scheme can. 0, for explicit ones:
    /// friction is at most half of what would stop the slide within the step.
    double stickSpeed = 0;
    /// Only to see what would be: makes and ends no joints, and reports how the forces answer to motion.
    bool isTrial = false;
    /// Friction goes on as it did in the trial before: in proportion to the slide.
    bool keepsSlip = false;
    bool limitsSlip = false; ///< what is kept is no more than Coulomb's friction

    bool isImplicit() const { return stickSpeed > 0; }
};

/// What a contact does to object o; the opposite end gets the opposite.
struct ContactResult {
    Vec3 spring = Vec3::Zero();   ///< conservative part of the force [N]
    Vec3 damping = Vec3::Zero();  ///< of damper and friction [N]; what it does on the relative motion is lost
    Vec3 friction = Vec3::Zero(); ///< the part of damping that is friction [N]
    double energy = 0;            ///< stored in the spring [J]

    double slip = 0;          ///< in an implicit scheme: friction by slide [N s/m]
    double frictionLimit = 0; ///< u |F_N| [N]
    /// Of a trial: how the force at the end of the step answers to the relative velocity, friction in
    /// proportion to the slide; symmetric, not negative [N s/m].
    Mat3 resistance = Mat3::Zero();

    Vec3 force() const { return spring + damping; }
};

/// Force of a contact connection, eqs (2), (5) and (7) with signs repaired, per connection.
/// Contacts push only: the sum of spring and damper is clamped at 0. The friction force is u |F_N| against the slide. Eq (7)
/// has no value at rest; what regularizes it depends on the scheme.
ContactResult contactForce(const ContactState& state, const ContactParameters& parameters, const ContactStep& step);

/// Parameters of a contact between two objects, so that two alike give their own: springs and dampers in series (harmonic
/// mean), the geometric mean of the frictions, the lesser overlap cap.
ContactParameters combine(const ContactParameters& a, const ContactParameters& b);

} // namespace knead
