#include "app/python/tool_words.h"

#include "core/message/message.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cmath>

namespace py = pybind11;

namespace knead::python {

RotationWords wordsOf(const Quaternion& rotation)
{
    return {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
}

Pose poseOf(const Vec3& position, const std::optional<RotationWords>& rotation, const Quaternion& otherwise)
{
    if (!rotation)
        return {position, otherwise};
    const Quaternion turned((*rotation)[0], (*rotation)[1], (*rotation)[2], (*rotation)[3]);
    if (!(std::abs(turned.norm() - 1) < 1e-6))
        throw Problem(Message(
            "Python", "A rotation is a quaternion (w, x, y, z) of length 1; knead.rotation(axis, angle) makes one."));
    return {position, turned};
}

std::vector<KeyFrame> framesOf(const std::vector<py::tuple>& frames, const Pose& before)
{
    std::vector<KeyFrame> read;
    for (const py::tuple& frame : frames) {
        if (frame.size() != 2 && frame.size() != 3)
            throw Problem(Message("Python", "A key frame is (time, position) or (time, position, rotation)."));
        std::optional<RotationWords> rotation;
        if (frame.size() == 3)
            rotation = frame[2].cast<RotationWords>();
        const Quaternion& last = read.empty() ? before.rotation : read.back().pose.rotation;
        read.push_back({frame[0].cast<double>(), poseOf(frame[1].cast<Vec3>(), rotation, last)});
    }
    return read;
}

ToolKind toolKindCalled(const std::string& name)
{
    for (const ToolKind kind : toolKinds)
        if (kind != ToolKind::part && nameOf(kind) == name)
            return kind;
    throw Problem(
        Message("Python", "There is no tool \"%1\"; there are box, ball, cylinder, wedge and plate.").with(name));
}

Vec3 sizeOf(ToolKind kind, const SizeWords& size)
{
    const auto* one = std::get_if<double>(&size);
    const std::vector<double> measures = one ? std::vector{*one} : std::get<std::vector<double>>(size);
    if (kind == ToolKind::ball && measures.size() == 1)
        return Vec3::Constant(measures[0]);
    if (kind == ToolKind::cylinder && measures.size() == 2)
        return {measures[0], measures[0], measures[1]};
    if (kind != ToolKind::ball && kind != ToolKind::cylinder && measures.size() == 3)
        return {measures[0], measures[1], measures[2]};
    throw Problem(Message("Python",
                          "The size of a tool is the diameter of a ball, (diameter, length) of a cylinder, and "
                          "three lengths of all others, in metres."));
}

} // namespace knead::python
