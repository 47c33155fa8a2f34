// New tools, and numbers of a tool, typed one by one.
#include "ui/document/document.h"

#include "core/mechanics/blade.h"
#include "core/mechanics/tool_shape.h"
#include "ui/document/tool_kinds.h"
#include "ui/round_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace knead {

namespace {

constexpr double blockShare = 0.25; // size of a new block, in sizes of the part
constexpr double timeToCross = 1.5; // a tool crosses the part in this time [s]
// A new tool stalls at this strain of the stiffest material under its face: enough to bend and dent, not to crush.
constexpr double stallStrain = 0.25;
// And a new knife by this times what its whole edge takes in the toughest material.
constexpr double cutsInLimit = 4;
constexpr double placeShare = 1.0 / 200; // of the part: new tools stand at places no finer than this

} // namespace

void Document::addTool(ToolKind kind)
{
    addTool(lookOf(kind));
}

/// @param look of those there are, which stay
void Document::addTool(const ToolKindLook& look)
{
    if (isEmpty() || later([this, &look] { addTool(look); }))
        return;
    Manipulator tool;
    tool.name = look.name + std::string(" ") + std::to_string(numberOfNewTool(look));
    tool.kind = look.kind;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        tool.size[axis] = typedNumber(size() * blockShare * look.proportions[axis]);
    tool.rollsFreely = look.rollsFreely;
    tool.pose.rotation = rotationOfNewTool(tool);
    tool.pose.position = placeAbove(tool.pose.rotation.toRotationMatrix().cwiseAbs() * tool.size);
    tool.speedLimit = typedNumber(size() / timeToCross);
    double stiffest = 0;
    for (const Material& material : m_frame->snapshot->materials)
        stiffest = std::max(stiffest, material.youngsModulus);
    tool.forceLimit = stallStrain * stiffest * tool.size.x() * tool.size.y();
    if (const auto blade = bladeOf(tool.shape())) // which needs more than what would stall so small a block
        for (const Material& material : m_frame->snapshot->materials)
            tool.forceLimit = std::max(tool.forceLimit, cutsInLimit * material.toughness * blade->length());
    tool.forceLimit = typedNumber(tool.forceLimit);
    m_toolToSelect = tool.name;
    post(AddManipulator{std::move(tool)});
}

/// Rollers and wires lie; what cuts lies across the longer side of the bodies, and cuts them in two as it goes down.
Quaternion Document::rotationOfNewTool(const Manipulator& tool) const
{
    const auto quarter = [](const Vec3& axis) { return Quaternion(Eigen::AngleAxisd(0.5 * std::numbers::pi, axis)); };
    const bool cuts = bladeOf(tool.shape()).has_value();
    const bool lies = tool.rolls() || (tool.kind == ToolKind::cylinder && cuts);
    const Quaternion lying = lies ? quarter(Vec3::UnitY()) : Quaternion::Identity();
    const Vec3 sizes = boxOfBodies().sizes();
    return cuts && sizes.x() > sizes.y() ? quarter(Vec3::UnitZ()) * lying : lying;
}

Box Document::boxOfBodies() const
{
    Box box;
    for (const auto& body : m_frame->bodies)
        for (const Vec3& place : body->places)
            box.extend(place);
    return box;
}

/// Above those of the tools that are there and of those that were just added.
int Document::numberOfNewTool(const ToolKindLook& look)
{
    int& count = m_toolCount[look.name];
    const QString begin = QString(look.name) + ' ';
    for (const ToolState& tool : m_frame->snapshot->tools)
        if (const QString name = QString::fromStdString(tool.name); name.startsWith(begin))
            count = std::max(count, name.mid(begin.size()).toInt());
    return ++count;
}

/// Just above what lies under the middle of the bodies, other tools included.
Vec3 Document::placeAbove(const Vec3& toolSize) const
{
    const Box box = boxOfBodies();
    const Vec3 center = box.center();
    double top = std::numeric_limits<double>::lowest();
    const auto raise = [&](const Vec3& place, const Vec3& margin) {
        const Vec3 reach = toolSize / 2 + margin;
        if (std::abs(place.x() - center.x()) <= reach.x() && std::abs(place.y() - center.y()) <= reach.y())
            top = std::max(top, place.z() + margin.z());
    };
    for (const auto& body : m_frame->bodies)
        for (const Vec3& place : body->places)
            raise(place, Vec3::Zero());
    for (const ToolState& tool : m_frame->snapshot->tools)
        raise(tool.pose.position, tool.size / 2);
    if (top < box.min().z()) // nothing there, as in a ring
        top = box.max().z();
    const double grid = placeShare * size();
    const auto nearest = [](double steps) { return std::round(steps); };
    const auto above = [](double steps) { return std::ceil(steps * (1 - 1e-12)); }; // what rounding left is no step
    return {onGrid(center.x(), grid, nearest), onGrid(center.y(), grid, nearest),
            onGrid(top + m_content->spacing + toolSize.z() / 2, grid, above)};
}

void Document::selectNewTool()
{
    if (m_toolToSelect.empty())
        return;
    for (const ToolState& tool : m_frame->snapshot->tools)
        if (tool.name == m_toolToSelect) {
            m_toolToSelect.clear();
            select({Selection::Kind::Tool, tool.id});
            return;
        }
}

const ToolState* Document::tool(ToolId id) const
{
    if (!m_frame)
        return nullptr;
    const auto& tools = m_frame->snapshot->tools;
    const auto found = std::find_if(tools.begin(), tools.end(), [id](const ToolState& tool) { return tool.id == id; });
    return found == tools.end() ? nullptr : &*found;
}

std::optional<ToolState> Document::toolWithEdits(ToolId id) const
{
    const ToolState* found = tool(id);
    if (found == nullptr)
        return {};
    return m_toolRequests.isOnItsWay(id, *m_frame->snapshot) ? m_toolRequests.asked(*found) : *found;
}

Pose Document::poseToMoveFrom(ToolId id) const
{
    return m_toolRequests.placed(id, *m_frame->snapshot).value_or(tool(id)->pose);
}

void Document::moveTool(ToolId id, std::function<Pose(const Pose&)> move)
{
    if (tool(id) == nullptr || later([this, id, move] { moveTool(id, move); }))
        return;
    post(PlaceManipulator{id, move(poseToMoveFrom(id))});
}

void Document::placeTool(ToolId id, int axis, double coordinate)
{
    const ToolState* found = tool(id);
    if (found == nullptr || later([=, this] { placeTool(id, axis, coordinate); }))
        return;
    Pose pose = m_toolRequests.asked(*found).pose;
    pose.position[axis] = coordinate;
    bringTool(id, pose);
}

void Document::bringTool(ToolId id, const Pose& pose)
{
    if (m_isPlaying)
        post(SetManipulatorMotion{id, GoTo{pose}});
    else
        post(PlaceManipulator{id, pose});
}

void Document::reshapeTool(ToolId id, std::function<void(ToolState&)> change)
{
    const ToolState* found = tool(id);
    if (found == nullptr || later([this, id, change] { reshapeTool(id, change); }))
        return;
    ToolState state = m_toolRequests.asked(*found);
    change(state);
    post(ReshapeManipulator{id, fittingSize(state.kind, state.size, state.part.get()), state.friction, state.speedLimit,
                            state.forceLimit, state.kind, state.part, state.adhesion, state.rollsFreely});
}

} // namespace knead
