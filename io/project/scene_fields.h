#pragma once

#include "core/aggregate/material_history.h"
#include "core/mechanics/manipulator.h"
#include "core/simulation/scene.h"
#include "io/project/json_fields.h"
#include "io/recipe/scene_words.h"

namespace knead {

// The fields of what scenes consist of, see json_fields.h. Keys say the unit, as in recipes, but of SI.

inline bool hasField(const FieldWriter& /*fields*/, const MaterialField& /*field*/)
{
    return true;
}
inline bool hasField(const FieldReader& fields, const MaterialField& field)
{
    return !isMissingInOlderFiles(field) || fields.node().find(field.key).has_value();
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Material> material)
{
    for (const MaterialField& field : materialFields())
        if (hasField(fields, field))
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
    fields.numberIfAny("adhesion_pa", tool.adhesion);
    fields.flagIfSet("rolls_freely", tool.rollsFreely);
    describeVariant(fields, "motion", tool.motion);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, GripTurn> turn)
{
    fields("center_m", turn.center);
    fields("angular_velocity_rad_s", turn.angularVelocity);
    fields("angle_rad", turn.angle);
}

/// Left out by grips that do not turn.
inline void describeTurn(FieldWriter& fields, const GripTurn& turn)
{
    fields.object("turn", turn.turns() ? std::optional(turn) : std::nullopt);
}
inline void describeTurn(const FieldReader& fields, GripTurn& turn)
{
    std::optional<GripTurn> read;
    fields.object("turn", read);
    turn = read.value_or(GripTurn{});
}

template <class Fields>
void describe(Fields& fields, Field<Fields, LoadAmount> amount)
{
    fields("force_n", amount.force);
    fields("moment_nm", amount.moment);
    fields("pressure_pa", amount.pressure);
}

/// A corner of a box, or what an object carries of a surface.
struct NamedVector {
    Vec3 value = Vec3::Zero();
};
struct CarriedArea {
    double share = 0;
    Vec3 area = Vec3::Zero();
};
template <class Fields>
void describe(Fields& fields, Field<Fields, NamedVector> vector)
{
    fields("at", vector.value);
}
template <class Fields>
void describe(Fields& fields, Field<Fields, CarriedArea> carried)
{
    fields("share_m2", carried.share);
    fields("area_m2", carried.area);
}

inline void describePatch(FieldWriter& fields, const Load& load)
{
    std::vector<NamedVector> corners;
    if (load.box)
        corners = {{load.box->min()}, {load.box->max()}};
    std::vector<CarriedArea> carried;
    for (std::size_t i = 0; i < load.patch.objects.size(); ++i)
        carried.push_back({load.patch.share[i], load.patch.area[i]});
    fields.list("box_m", corners);
    fields("objects", load.patch.objects);
    fields.list("carried", carried);
}
inline void describePatch(const FieldReader& fields, Load& load)
{
    std::vector<NamedVector> corners;
    std::vector<CarriedArea> carried;
    fields.list("box_m", corners);
    fields("objects", load.patch.objects);
    fields.list("carried", carried);
    if (carried.size() != load.patch.objects.size())
        fields.node().at("carried").failExpecting(Message("Recipe", "must have one item for each object"));
    if (corners.size() == 2)
        load.box = Box(corners[0].value, corners[1].value);
    for (const CarriedArea& one : carried) {
        load.patch.share.push_back(one.share);
        load.patch.area.push_back(one.area);
    }
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Load> load)
{
    fields("name", load.name);
    fields("body", load.body);
    fields("faces", load.faces);
    describePatch(fields, load);
    fields.object("amount", load.amount);
    fields("ramp_s", load.ramp);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, Fixture> fixture)
{
    fields("name", fixture.name);
    fields("body", fixture.body);
    fields("objects", fixture.objects);
    fields("velocity_m_s", fixture.velocity);
    describeTurn(fields, fixture.turn);
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
    fields.numberIfAny("floor_adhesion_pa", scene.floorAdhesion);
    fields.choice("touching", scene.touching, touchingWords());
    fields.choice("integrator", scene.integrator, integratorWords());
    fields.choice("vicinity", scene.vicinity, vicinityWords());
    fields("time_step_s", scene.timeStep);
    fields("mass_scaling_time_step_s", scene.massScalingTimeStep);
    fields.flag("refilling", scene.refilling, false);
    fields.list("fixtures", scene.fixtures);
    fields.list("manipulators", scene.manipulators);
    fields.listIfAny("loads", scene.loads);
}

} // namespace knead
