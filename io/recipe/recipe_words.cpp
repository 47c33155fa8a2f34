// What recipes say of materials, tools and fixtures of a session.
#include "core/message/message.h"
#include "io/recipe/recipe_events_text.h"

#include "io/json/exact_number.h"
#include "io/recipe/recipe_places.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

bool isTurned(const Quaternion& rotation)
{
    return rotation.w() != 1 || rotation.vec() != Vec3::Zero();
}

std::string sizeText(const Manipulator& form)
{
    const Vec3& size = form.size;
    if (form.kind == ToolKind::ball)
        return exactThousandfold(size.x());
    std::string text = '[' + exactThousandfold(size.x());
    if (form.kind != ToolKind::cylinder)
        text += ", " + exactThousandfold(size.y());
    return text + ", " + exactThousandfold(size.z()) + ']';
}

void putKeyFrames(ObjectText& text, const std::vector<KeyFrame>& frames)
{
    text.put("keyframes", listText(frames, [](const KeyFrame& frame) {
                 return ObjectText()
                     .number("time_s", frame.time)
                     .millimeters("position_mm", frame.pose.position)
                     .numbers("rotation_wxyz", frame.pose.rotation)
                     .take();
             }));
}

struct MotionText {
    ObjectText& text;

    void operator()(const HoldStill&) const { text.put("hold", "true"); }
    void operator()(const DriveAt& drive) const
    {
        text.millimeters("velocity_mm_s", drive.velocity);
        if (drive.angularVelocity != Vec3::Zero())
            text.numbers("angular_velocity_rad_s", drive.angularVelocity);
    }
    void operator()(const GoTo& goTo) const
    {
        ObjectText target;
        putPose(target, goTo.target);
        text.put("go_to", target.take());
    }
    void operator()(const FollowKeyFrames& follow) const { putKeyFrames(text, follow.frames); }
};

} // namespace

void putPose(ObjectText& text, const Pose& pose)
{
    text.millimeters("position_mm", pose.position);
    if (isTurned(pose.rotation))
        text.numbers("rotation_wxyz", pose.rotation);
}

void putMotion(ObjectText& text, const Motion& motion)
{
    std::visit(MotionText{text}, motion);
}

std::string RecipeWords::material(const Material& material, const Material& base) const
{
    const auto isIt = [&](const MaterialPreset& preset) { return preset.material == material; };
    const auto preset = std::find_if(presets.begin(), presets.end(), isIt);
    if (preset != presets.end())
        return quoted(preset->id);
    ObjectText numbers;
    for (const MaterialField& field : materialFields())
        if (material.*field.value != base.*field.value)
            numbers.number(field.key, material.*field.value);
    return numbers.take();
}

ObjectText RecipeWords::reshaping(const Manipulator& form, const std::string& name) const
{
    ObjectText text;
    text.text("name", name).text("kind", std::string(nameOf(form.kind)));
    if (form.kind != ToolKind::part) {
        text.put("size_mm", sizeText(form));
    } else {
        const auto part = std::find(toolParts.begin(), toolParts.end(), form.part);
        if (toolPartFile.empty() || part == toolParts.end())
            throw Problem(
                Message("Recipe", "the tool \"%1\" is an imported part, which only a saved project keeps.").with(name));
        text.text("part_file", toolPartFile).put("part_number", std::to_string(part - toolParts.begin()));
    }
    text.number("friction", form.friction).millimeters("speed_limit_mm_s", form.speedLimit);
    if (std::isfinite(form.forceLimit))
        text.number("force_limit_n", form.forceLimit);
    if (form.adhesion > 0)
        text.number("adhesion_pa", form.adhesion);
    if (form.rolls())
        text.put("rolls_freely", "true");
    return text;
}

std::string RecipeWords::manipulator(const Manipulator& manipulator) const
{
    ObjectText text = reshaping(manipulator, names.addTool(manipulator.name));
    putPose(text, manipulator.pose);
    if (!std::holds_alternative<HoldStill>(manipulator.motion)) {
        ObjectText motion;
        putMotion(motion, manipulator.motion);
        text.put("motion", motion.take());
    }
    return text.take();
}

std::string RecipeWords::fixture(const Fixture& fixture, std::uint32_t objectsInBody) const
{
    ObjectText text;
    text.text("name", names.addFixture(fixture.name));
    if (names.hasManyBodies())
        text.text("body", names.body(fixture.body));
    if (objectsInBody > 0)
        putLaterObjects(text, objectsInBody, fixture.objects);
    else
        putObjects(text, aggregateOf(fixture.body), meshOf(fixture.body), fixture.objects);
    if (fixture.velocity != Vec3::Zero())
        text.millimeters("velocity_mm_s", fixture.velocity);
    putTurn(text, fixture.turn);
    return text.take();
}

} // namespace knead
