#pragma once

#include "core/aggregate/material.h"
#include "core/mechanics/manipulator.h"
#include "core/simulation/scene.h"
#include "verify/book.h"
#include "verify/mapped_block.h"

#include <functional>
#include <numbers>
#include <vector>

namespace knead::book {

/// Material that is held and moved, the same way in both programs.
struct Grip {
    /// How far a point is in front of the held zone [m]: at most half a spacing of Knead, 0 of CalculiX.
    std::function<double(const Vec3& place)> zone;
    /// Displacement of a held point at a share of the load [m].
    std::function<Vec3(const Vec3& place, double share)> path;
    /// Points that become one fixture of Knead, of which only the sum of forces is known.
    enum class Together {
        none,  ///< each point by itself
        alike, ///< those with the same path: in bending, whose moment is the same wherever they are across
        all,   ///< all move alike
    } together = Together::none;
    Vec3 axes = Vec3::Ones(); ///< that are held, in CalculiX; Knead holds all three
    enum class Program { both, knead, calculix } program = Program::both;
};

/// A tool of Knead that moves along with the load.
struct Tool {
    Manipulator manipulator; ///< where it begins
    Vec3 way = Vec3::Zero(); ///< from share 0 to 1 [m]
};

/// To a share of the load, then grips or tools are let go, then it comes to rest.
struct Stage {
    double share = 1;
    std::vector<std::size_t> released = {}; ///< grips
    bool withoutTools = false;              ///< tools go out of the way
};

/// What CalculiX is told beside the part. Elements are C3D20R: quadratic, reduced integration.
struct CalculixLaw {
    bool isRubber = false;       ///< neo-Hooke with the moduli of the material; else Hooke, with its plasticity
    double firstIncrement = 1;   ///< share of a stage; of material that yields and rubber at most a tenth
    double largestIncrement = 1; ///< of these at most a quarter
};

/// A body with its supports and loads, slow enough to be at rest: what a case of statics consists of.
struct Part {
    MappedBlock block;
    Material material; ///< its density and damping are chosen so that it comes to rest soon
    std::vector<Grip> grips;
    std::vector<Tool> tools = {};
    std::vector<Stage> stages = {{}};
    Vec3 gravity = Vec3::Zero(); ///< [m/s^2]; scaled so that weight is that of a density of weighs
    double weighs = 1000;        ///< [kg/m^3] with gravity
    Pose pose = {};              ///< of the part against the lattice

    /// Lowest angular frequency of its motion over the speed of sound sqrt(E / rho) [1/m].
    double slowest = 1;
    double loadPeriods = 3; ///< that a stage takes, of the slowest motion
    int segments = 12;      ///< that the way of a stage is made of
    double restPeriods = 3; ///< that it may take at most to come to rest
    CalculixLaw law = {};
};

struct PointForce {
    Vec3 place; ///< at rest [m]
    Vec3 now;   ///< [m]
    Vec3 force; ///< of the part on what holds it [N]
};

/// What either program found at the end of a stage, in the frame of the part.
struct Finding {
    std::vector<Vec3> rest;                            ///< of objects or nodes [m]
    std::vector<Vec3> displacement;                    ///< [m]
    std::vector<std::vector<PointForce>> reactions;    ///< per grip; empty for one that was let go
    std::vector<Vec3> toolForces;                      ///< of the part on them [N]
    std::function<double(const Vec3& place)> vonMises; ///< at a point of the surface at rest [Pa]
    double elasticEnergy = 0;                          ///< [J]; Knead only
    double spacing = 0;                                ///< [m]; 0 for CalculiX
};

using Measure = std::function<std::vector<double>(const std::vector<Finding>& stages)>;

// ----- readings of a finding

Vec3 forceOn(const Finding& finding, std::size_t grip);                     ///< [N]
Vec3 momentOn(const Finding& finding, std::size_t grip, const Vec3& about); ///< [N m], about a point of now

/// How the points of a slab move as one: least squares.
struct SectionMotion {
    Vec3 displacement; ///< of their middle [m]
    Vec3 rotation;     ///< small [rad]
};
/// @param half of the thickness of the slab across `axis`, at least that of a spacing
SectionMotion sectionMotion(const Finding& finding, int axis, double at, double half = 0);

/// Mean displacement of the points in a box, grown by half a spacing.
Vec3 meanDisplacement(const Finding& finding, const Box& box);

/// Mean slope of displacement `of` along `along` within a box: a normal or half a shear strain.
double slope(const Finding& finding, const Box& box, int of, int along);

// ----- programs

/// @param spacing [m]
Outcome runKnead(const Part& part, double spacing, const Measure& measure);
/// @throws std::runtime_error when CalculiX is missing or fails
Outcome runCalculix(const Part& part, const Measure& measure);

/// A case of a part in both programs. Give the rest of the fields by name, then this.
Case partCase(Case base, std::function<Part()> part, double acrossLength, Measure measure, bool withCalculix = true);

// ----- grips that many cases use

inline std::function<double(const Vec3&)> beyond(int axis, double sign, double at)
{
    return [=](const Vec3& p) { return at - sign * p[axis]; };
}
inline Grip held(std::function<double(const Vec3&)> zone)
{
    return {std::move(zone), [](const Vec3&, double) { return Vec3(Vec3::Zero()); }, Grip::Together::all};
}
inline Grip moved(std::function<double(const Vec3&)> zone, const Vec3& by)
{
    return {std::move(zone), [by](const Vec3&, double share) { return Vec3(share * by); }, Grip::Together::all};
}
/// By an angle [rad] about an axis through a point.
inline Grip turned(std::function<double(const Vec3&)> zone, const Vec3& point, const Vec3& axis, double angle)
{
    return {std::move(zone), [=](const Vec3& p, double share) {
                const Eigen::AngleAxisd turn(share * angle, axis);
                return Vec3(turn * (p - point) - (p - point));
            }};
}

/// A cylinder along y that comes from above onto a point of the top and goes down, without friction; in CalculiX a line of
/// the surface that goes down.
void pressByRoller(Part& part, const Vec3& point, double radius, double length, double down);

inline constexpr double pi = std::numbers::pi;

} // namespace knead::book
