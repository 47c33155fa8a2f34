#include "ui/interaction/space_hand.h"

#include "ui/viewport/viewport_widget.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace knead {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double panSpeed = 0.8;    // at full deflection [view heights/s]
constexpr double zoomSpeed = 1.2;   // [1/s]; in a second the distance changes by e^1.2
constexpr double turnSpeed = 2.0;   // [rad/s]
constexpr double longestLook = 0.1; // what came after a pause goes on for this at most [s]

/// From the axes of the screen to those of the world.
Vec3 inWorld(const Camera& camera, const Vec3& v)
{
    return v.x() * camera.right() + v.y() * camera.up() + v.z() * camera.towardsEye();
}

} // namespace

Camera movedBy(const Camera& camera, const SpaceMotion& motion, double rate)
{
    const double dt = rate * std::min(motion.seconds, longestLook);
    Camera moved = camera;
    const double pan = panSpeed * dt * camera.viewHeight();
    moved.target -= pan * (motion.push.x() * camera.right() + motion.push.y() * camera.up());
    moved.distance = std::clamp(camera.distance * std::exp(-zoomSpeed * dt * motion.push.z()), 1e-6, 1e6);
    moved.yaw = std::remainder(camera.yaw - turnSpeed * dt * motion.turn.y(), 2 * pi);
    moved.pitch = std::clamp(camera.pitch + turnSpeed * dt * motion.turn.x(), -pi / 2, pi / 2);
    return moved;
}

DriveAt toolMotion(const ToolState& tool, const Camera& camera, const SpaceMotion& motion, double rate)
{
    const double speed = std::min(rate, 1.0) * tool.speedLimit;
    const auto limited = [](const Vec3& v) { return v.norm() > 1 ? v.normalized().eval() : v; };
    // Its corners go no faster than its speed limit either.
    return {speed * inWorld(camera, limited(motion.push)),
            speed / (0.5 * tool.size.norm()) * inWorld(camera, limited(motion.turn))};
}

SpaceHand::SpaceHand(Document& document, ViewportWidget& view, HandSettings& settings)
    : QObject(&view)
    , m_document(document)
    , m_view(view)
    , m_settings(settings)
{
    connect(&document, &Document::stopping, this, &SpaceHand::stop);
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            m_driven.reset();
    });
}

SpaceHand::~SpaceHand()
{
    m_listening.reset(); // nothing is told any more
}

void SpaceHand::listen(const ListenToSpaceMouse& listen)
{
    if (listen)
        m_listening = listen([this](const SpaceEvent& event) {
            QMetaObject::invokeMethod(
                this, [this, event] { take(event); }, Qt::QueuedConnection);
        });
}

void SpaceHand::take(const SpaceEvent& event)
{
    switch (event.kind) {
    case SpaceEvent::Kind::motion:
        move(event.motion);
        break;
    case SpaceEvent::Kind::buttonPressed:
        press(event.button);
        break;
    case SpaceEvent::Kind::connected:
    case SpaceEvent::Kind::disconnected:
        m_isConnected = event.kind == SpaceEvent::Kind::connected;
        stop();
        emit connectionChanged(m_isConnected);
        break;
    }
}

const ToolState* SpaceHand::selectedTool() const
{
    const Selection& selection = m_document.selection();
    return selection.kind == Selection::Kind::Tool ? m_document.tool(selection.id) : nullptr;
}

void SpaceHand::move(const SpaceMotion& motion)
{
    if (m_document.isEmpty())
        return;
    const ToolState* tool = m_settings.choices().spaceMouseDrivesTool ? selectedTool() : nullptr;
    if (m_driven && (tool == nullptr || tool->id != *m_driven || motion.isRest()))
        stop();
    if (motion.isRest())
        return;
    if (tool == nullptr)
        m_view.jumpTo(movedBy(m_view.camera(), motion, m_settings.choices().spaceMouseRate));
    else if (!m_view.isLookingBack())
        moveTool(*tool, motion);
}

void SpaceHand::moveTool(const ToolState& tool, const SpaceMotion& motion)
{
    const DriveAt drive = toolMotion(tool, m_view.camera(), motion, m_settings.choices().spaceMouseRate);
    if (!m_document.isPlaying()) {
        Manipulator moved{.size = tool.size, .speedLimit = tool.speedLimit, .motion = drive};
        m_document.moveTool(tool.id,
                            [moved, seconds = std::min(motion.seconds, longestLook)](const Pose& from) mutable {
                                moved.pose = from;
                                return advance(moved, 0, seconds);
                            });
        return;
    }
    if (!m_driven)
        m_document.beginGesture(QStringLiteral("3D mouse %1").arg(tool.id));
    m_driven = tool.id;
    m_document.post(SetManipulatorMotion{tool.id, drive});
}

void SpaceHand::press(int button)
{
    if (button == 0) {
        if (!m_document.isEmpty())
            m_view.fit();
    } else if (button == 1) {
        HandChoices choices = m_settings.choices();
        choices.spaceMouseDrivesTool = !choices.spaceMouseDrivesTool;
        m_settings.set(choices);
    }
}

void SpaceHand::stop()
{
    if (const std::optional<ToolId> tool = std::exchange(m_driven, {})) {
        m_document.post(SetManipulatorMotion{*tool, HoldStill{}});
        m_document.endGesture(Document::Ends::soon);
    }
}

} // namespace knead
