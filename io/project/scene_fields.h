#pragma once

#include "core/mechanics/manipulator.h"
#include "core/simulation/scene.h"
#include "io/project/json_fields.h"
#include "io/scene_words.h"

namespace knead {

// The fields of what scenes consist of, see json_fields.h. Keys say the unit, as in recipes, but of SI.

template <class Fields>
void describe(Fields& fields, Field<Fields, Material> material)
{
    for (const MaterialField& field : materialFields())
        fields(field.key, material.*field.value);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Pose> pose)
{
    fields("position_m", pose.position);
    fields("rotation_wxyz", pose.rotation);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, KeyFrame> frame)
{
    fields("time_s", frame.time);
    fields.object("pose", frame.pose);
}

template <>
inline constexpr const char* wordOf<HoldStill> = "hold-still";
template <>
inline constexpr const char* wordOf<DriveAt> = "drive-at";
template <>
inline constexpr const char* wordOf<GoTo> = "go-to";
template <>
inline constexpr const char* wordOf<FollowKeyFrames> = "follow-key-frames";

template <class Fields>
void describe(Fields& fields, Field<Fields, DriveAt> drive)
{
    fields("velocity_m_s", drive.velocity);
    fields("angular_velocity_rad_s", drive.angularVelocity);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, GoTo> goTo)
{
    fields.object("target", goTo.target);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, FollowKeyFrames> follow)
{
    fields.list("frames", follow.frames);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Manipulator> tool)
{
    fields("name", tool.name);
    fields.choice("kind", tool.kind, toolKindWords());
    fields("size_m", tool.size);
    fields("tool_part", tool.part);
    fields.object("pose", tool.pose);
    fields("friction", tool.friction);
    fields("speed_limit_m_s", tool.speedLimit);
    fields("force_limit_n", tool.forceLimit);
    describeVariant(fields, "motion", tool.motion);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Fixture> fixture)
{
    fields("name", fixture.name);
    fields("body", fixture.body);
    fields("objects", fixture.objects);
    fields("velocity_m_s", fixture.velocity);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, MaterialRegion> region)
{
    fields("name", region.name);
    fields("objects", region.objects);
    fields.object("material", region.material);
}

/// Without aggregate, name and material, for which a project has columns.
template <class Fields>
void describe(Fields& fields, Field<Fields, Body> body)
{
    fields.choice("kind", body.kind, bodyKindWords());
    fields("velocity_m_s", body.velocity);
    fields("angular_velocity_rad_s", body.angularVelocity);
    fields("structural_friction", body.structuralFriction);
    fields.list("regions", body.regions);
}

/// Without bodies.
template <class Fields>
void describe(Fields& fields, Field<Fields, Scene> scene)
{
    fields("gravity_m_s2", scene.gravity);
    fields("floor_m", scene.floorHeight);
    fields("floor_friction", scene.floorFriction);
    fields.choice("touching", scene.touching, touchingWords());
    fields.choice("integrator", scene.integrator, integratorWords());
    fields.choice("vicinity", scene.vicinity, vicinityWords());
    fields("time_step_s", scene.timeStep);
    fields("mass_scaling_time_step_s", scene.massScalingTimeStep);
    fields.list("fixtures", scene.fixtures);
    fields.list("manipulators", scene.manipulators);
}

} // namespace knead
