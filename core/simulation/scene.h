#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/material_map.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mechanics/contacts.h"
#include "core/mechanics/load.h"
#include "core/mechanics/manipulator.h"
#include "core/message/message.h"
#include "core/vicinity/vicinity.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

using BodyId = std::uint32_t; ///< index into Scene::bodies; bodies are never renumbered
using FixtureId = std::uint32_t;

/// A body of the scene: an aggregate made of a material.
struct Body {
    std::string name;
    std::shared_ptr<const Aggregate> aggregate;
    Material material;
    Vec3 velocity = Vec3::Zero();        ///< at the start [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< at the start, about the center of mass [rad/s]
    BodyKind kind = BodyKind::deformable;
    std::vector<MaterialRegion> regions; ///< of other materials; a later one wins where they overlap
    double structuralFriction = 0;       ///< u of eq 7 within the body, 0 .. 2: only to repeat published scenes
    /// What the aggregate was filled from; null: the body cannot be filled anew.
    std::shared_ptr<const TriangleMesh> surface = nullptr;
};

/// How velocities and positions are advanced. Moments keep the numbers.
enum class Integrator : std::uint8_t {
    semiImplicitEuler = 0, ///< keeps energy; needs no damping
    forwardEuler = 1,      ///< as published: gains energy unless damped
    implicitEuler = 2,     ///< a step per frame for any stiffness; damps out what swings faster than that
    automatic = 3,         ///< semi-implicit where that is predicted to keep up with real time, implicit where not
};

/// How a grip turns: about an axis through a point, until an angle is reached. The objects go along circles to the last bits of
/// rounding, whatever the step. Turning begins and ends at once; what that would take of the mass of held objects is in no
/// force.
struct GripTurn {
    Vec3 center = Vec3::Zero();                             ///< when it begins; goes along with the grip's velocity [m]
    Vec3 angularVelocity = Vec3::Zero();                    ///< up to 1e4 rad/s
    double angle = std::numeric_limits<double>::infinity(); ///< after which it stands still again, > 0 [rad]

    bool turns() const { return !angularVelocity.isZero(0); }
};

/// Objects of a body that are held: in place, or by a grip that moves.
struct Fixture {
    std::string name;
    BodyId body = 0;
    std::vector<ObjectIndex> objects; ///< within the body, ascending
    Vec3 velocity = Vec3::Zero();     ///< a grip that moves pulls the material along [m/s]
    GripTurn turn = {};               ///< and turns it

    /// Objects of the first filling, where the body has another one since: what Reset goes back to. Else empty.
    std::vector<ObjectIndex> whenOpened = {};
};

/// What becomes of bodies whose skins touch at the start.
enum class Touching : std::uint8_t {
    separate, ///< they push each other, and nothing holds them together but what their materials do
    glued,    ///< they are one, as strong at the seam as the weaker of the two
};

/// A sentence on why a grip cannot move so; empty when it can.
Message gripProblem(const Fixture& fixture);

/// Everything a simulation starts from.
struct Scene {
    std::vector<Body> bodies;
    std::vector<Fixture> fixtures;         ///< their ids are their places here
    std::vector<Manipulator> manipulators; ///< their ids are their places here
    Vec3 gravity = Vec3::Zero();           ///< [m/s^2]
    std::optional<double> floorHeight;     ///< z of a fixed floor [m]
    double floorFriction = 0.4;
    double floorAdhesion = 0; ///< tension that what touched it bears [Pa], 0 .. 1e9; 0: nothing sticks to it
    Touching touching = Touching::separate;

    Integrator integrator = Integrator::semiImplicitEuler;
    VicinityMethod vicinity = VicinityMethod::uniformGrid;

    /// A step of one's own choosing instead of the largest stable one [s]. An explicit run with a longer step than is stable
    /// stops. The implicit scheme takes no longer ones than this, and shorter ones where things move fast.
    std::optional<double> timeStep;
    /// Mass scaling: objects that would need a shorter step than this get as much mass as makes it stable [s]. What was
    /// added is in Snapshot::addedMass.
    std::optional<double> massScalingTimeStep;

    std::vector<Load> loads; ///< their ids are their places here

    /// Whether bodies that yield and have a surface are filled anew, in the shape they have, where the cells between their objects
    /// are no good any more. Runs of before are repeated without.
    bool refilling = true;
};

/// Objects held when CAD faces are fixed: those within half a spacing of the faces, and those beyond them outside.
/// @param faces indices into Part::faces
std::vector<ObjectIndex> objectsAtFaces(const Aggregate& aggregate, const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& faces);

/// Objects inside a box, borders included.
std::vector<ObjectIndex> objectsInBox(const Aggregate& aggregate, const Box& box);

} // namespace knead
