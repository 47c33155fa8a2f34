#include "ui/viewport/manipulation.h"

#include <utility>

namespace knead {

namespace {

constexpr double slowness = 0.2;   // share of the speed while Shift is held
constexpr double nudgeTime = 0.05; // a key press while paused moves a block as far as it would go in this time [s]

} // namespace

Vec3 keyDirection(int key, const Camera& camera)
{
    const Vec3 right = nearestAxis(camera.right(), true);
    const Vec3 away = Vec3::UnitZ().cross(right);
    switch (key) {
    case Qt::Key_Right:
        return right;
    case Qt::Key_Left:
        return -right;
    case Qt::Key_Up:
        return away;
    case Qt::Key_Down:
        return -away;
    case Qt::Key_PageUp:
        return Vec3::UnitZ();
    case Qt::Key_PageDown:
        return -Vec3::UnitZ();
    default:
        return Vec3::Zero();
    }
}

Manipulation::Manipulation(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_picker(document)
{
    connect(&document, &Document::stopping, this, &Manipulation::releaseKeys);
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what != Document::Change::Model)
            return;
        m_picker.forget();
        m_drag.reset();
        m_driven.reset();
        m_keys.clear();
        setHovered({});
    });
}

void Manipulation::setFixing(bool on)
{
    m_isFixing = on;
    setHovered({});
}

Qt::CursorShape Manipulation::cursor() const
{
    if (m_drag)
        return Qt::ClosedHandCursor;
    if (m_isFixing)
        return m_hovered.kind == PickHit::Kind::Body ? Qt::PointingHandCursor : Qt::CrossCursor;
    return m_hovered.kind == PickHit::Kind::Tool ? Qt::OpenHandCursor : Qt::ArrowCursor;
}

void Manipulation::hover(const Ray& ray)
{
    setHovered(m_picker.pick(ray, m_isFixing));
}

void Manipulation::leave()
{
    if (!m_drag)
        setHovered({});
}

void Manipulation::setHovered(const PickHit& hit)
{
    const bool isSame = hit.kind == m_hovered.kind && hit.id == m_hovered.id && hit.face == m_hovered.face;
    m_hovered = hit;
    if (isSame)
        return;
    m_isJustToggled = false;
    emit hoverChanged();
}

void Manipulation::press(const Ray& ray)
{
    const PickHit hit = m_picker.pick(ray, m_isFixing);
    setHovered(hit);
    if (hit.kind == PickHit::Kind::Tool) {
        m_document.select({Selection::Kind::Tool, hit.id});
        if (m_document.isGoing())
            return; // what would be held may be gone on arrival
        const Pose pose = m_document.poseToMoveFrom(hit.id);
        m_drag = Drag{hit.id, hit.place, pose, pose, pose, {}};
        m_document.beginGesture();
    } else if (hit.kind == PickHit::Kind::Body) {
        if (m_isFixing) {
            m_isJustToggled = true; // no highlight covers the new color
            m_document.toggleFace(hit.id, hit.face);
            emit hoverChanged();
        } else
            m_document.select({Selection::Kind::Body, hit.id});
    } else if (!m_isFixing) {
        m_document.select({});
    }
}

void Manipulation::drag(const Ray& ray, const Camera& camera)
{
    if (!m_drag)
        return;
    if (!m_document.isInGesture()) { // undone under the hand
        m_drag.reset();
        return;
    }
    if (std::exchange(m_drag->camera, camera).value_or(camera) !=
        camera) { // it goes on from where it is, as it is seen now
        const Vec3 reached = m_drag->grabbed + m_drag->target.position - m_drag->start.position;
        m_drag->grabbed = ray.onPlane(reached, camera.towardsEye());
        m_drag->start = m_drag->target;
    }
    Pose target = m_drag->start;
    target.position += ray.onPlane(m_drag->grabbed, camera.towardsEye()) - m_drag->grabbed;
    m_drag->target = target;
    m_document.bringTool(m_drag->tool, target);
}

void Manipulation::release()
{
    if (m_drag)
        m_document.endGesture();
    m_drag.reset();
    emit hoverChanged();
}

/// While time runs the block goes back as it came.
bool Manipulation::cancel()
{
    if (!m_drag)
        return false;
    const Drag drag = *std::exchange(m_drag, {});
    if (m_document.isPlaying())
        m_document.post(SetManipulatorMotion{drag.tool, GoTo{drag.home}});
    m_document.takeBackGesture();
    emit hoverChanged();
    return true;
}

const ToolState* Manipulation::selectedTool() const
{
    const Selection& selection = m_document.selection();
    return selection.kind == Selection::Kind::Tool ? m_document.tool(selection.id) : nullptr;
}

bool Manipulation::keyPressed(int key, bool isSlow, const Camera& camera)
{
    if (keyDirection(key, camera).isZero() || selectedTool() == nullptr)
        return false;
    m_camera = camera;
    m_isSlow = isSlow;
    if (!m_document.isPlaying()) {
        nudge(key, isSlow);
        return true;
    }
    m_keys.insert(key);
    drive();
    return true;
}

bool Manipulation::keyReleased(int key)
{
    if (m_keys.erase(key) == 0)
        return false;
    drive();
    return true;
}

void Manipulation::releaseKeys()
{
    m_keys.clear();
    drive();
}

void Manipulation::drive()
{
    const ToolState* tool = selectedTool();
    if (m_driven && (tool == nullptr || tool->id != *m_driven || m_keys.empty())) {
        m_document.post(SetManipulatorMotion{*m_driven, HoldStill{}});
        m_document.endGesture(Document::Ends::soon);
        m_driven.reset();
    }
    if (tool == nullptr || m_keys.empty())
        return;
    Vec3 direction = Vec3::Zero();
    for (const int key : m_keys)
        direction += keyDirection(key, m_camera);
    if (!m_driven)
        m_document.beginGesture(QStringLiteral("drive %1").arg(tool->id));
    const double speed = tool->speedLimit * (m_isSlow ? slowness : 1);
    m_document.post(SetManipulatorMotion{tool->id, DriveAt{speed * direction.normalized(), Vec3::Zero()}});
    m_driven = tool->id;
}

void Manipulation::nudge(int key, bool isSlow)
{
    const ToolState* tool = selectedTool();
    const Vec3 step = tool->speedLimit * nudgeTime * (isSlow ? slowness : 1) * keyDirection(key, m_camera);
    m_document.moveTool(tool->id, [step](const Pose& from) { return Pose{from.position + step, from.rotation}; });
}

} // namespace knead
