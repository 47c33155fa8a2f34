#include "ui/interaction/press_hand.h"

#include "ui/language/said.h"
#include "ui/round_number.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double thumbShare = 0.2;      // diameter of a new thumb, in sizes of the part
constexpr double thumbSpacings = 3;     // at least
constexpr double thumbCrossingTime = 3; // a thumb would cross the part in this time [s]
constexpr double thumbFriction = 0.3;
constexpr double normalShare = 0.35; // the surface's normal is its mean within this share of the tool's size
constexpr double gapShare = 0.25;    // between tool and surface before it is pressed and after, in spacings
constexpr double arrived = 1e-3;     // a lifted tool has, so near, of its way
constexpr double patience = 0.5;     // with a tool that something holds, beyond what its way takes [s]
constexpr double atLimit = 0.97;     // of its limit, which holds a tool up
const std::string thumbName = "Thumb ";

/// To two digits.
double rounded(double value)
{
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::round(value / digit) * digit;
}

} // namespace

PressHand::PressHand(Document& document, ViewportWidget& view)
    : ViewHand(document, view)
    , m_overlay(new ViewOverlay(view, *this, "pressNote"))
{
    connect(&document, &Document::changed, this, &PressHand::documentChanged);
    connect(&document, &Document::stopping, this, &PressHand::letGo);
}

void PressHand::setOn(bool on)
{
    if (!on && isPressing())
        lift();
    m_isOn = on;
    m_view.setMode(on ? std::optional(Qt::PointingHandCursor) : std::nullopt);
}

void PressHand::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Model:
    case Document::Change::Moment:
        m_press.reset();
        m_overlay->refresh();
        break;
    case Document::Change::Frame:
        if (m_press)
            follow();
        break;
    default:
        break;
    }
}

/// Presses on tools and on the cube go on to the view.
bool PressHand::mousePressed(QMouseEvent& event)
{
    if (m_press && !m_press->isTold)
        return event.button() == Qt::LeftButton;
    if (const QString reason = m_isOn ? whyNotNow(event) : QString(); !reason.isEmpty()) {
        emit refused(reason);
        return true;
    }
    const std::optional<PickHit> hit = m_isOn ? pressedBody(event) : std::nullopt;
    if (!hit)
        return false;
    if (const QString reason = whyNotPressed(hit->id); !reason.isEmpty()) {
        emit refused(reason);
        return true;
    }
    const bool makesTimeRun = m_press ? m_press->makesTimeRun : !m_document.isPlaying();
    letGo(); // of one that still goes up
    m_cursor = event.position();
    begin(*hit, makesTimeRun);
    return true;
}

QString PressHand::whyNotPressed(BodyId body) const
{
    if (m_document.frame()->snapshot->bodies[body].kind != BodyKind::deformable)
        return said(Message("PressHand", "%1 does not deform: make it deformable in the properties to press into it.")
                        .with(m_document.nameOfBody(body).toStdString()));
    const ToolState* tool = toolToTake();
    if (tool != nullptr && m_document.isLocked({Selection::Kind::Tool, tool->id}))
        return said(
            Message("PressHand", "%1 is locked: unlock it in the model tree to press with it.").with(tool->name));
    return {};
}

/// The one that is selected, else the last thumb; null: there is none yet.
const ToolState* PressHand::toolToTake() const
{
    const Selection& selection = m_document.selection();
    if (selection.kind == Selection::Kind::Tool)
        return m_document.tool(selection.id);
    const std::vector<ToolState>& tools = m_document.frame()->snapshot->tools;
    const auto thumb = std::ranges::find(tools, m_thumb, &ToolState::name);
    return thumb == tools.end() ? nullptr : &*thumb;
}

const ToolState* PressHand::toolNow() const
{
    const std::vector<ToolState>& tools = m_document.frame()->snapshot->tools;
    const auto found = std::ranges::find(tools, m_press->tool, &ToolState::name);
    return found == tools.end() ? nullptr : &*found;
}

void PressHand::begin(const PickHit& hit, bool makesTimeRun)
{
    const Frame& frame = *m_document.frame();
    const Snapshot& now = *frame.snapshot;
    const QString name = m_document.nameOfBody(hit.id);
    const double spacing = frame.filled[hit.id]->aggregate->lattice.spacing;
    const auto posesOf = [&](const ToolShape& shape, const Quaternion& rotation) {
        const Vec3 normal = surfaceSpot(frame.filled[hit.id]->render.triangles, frame.bodies[hit.id]->points,
                                        hit.triangle, hit.place, normalShare * shape.size.minCoeff())
                                .normal;
        return pressPoses(shape, rotation, hit.place, normal, gapShare * spacing);
    };
    Press press;
    press.makesTimeRun = makesTimeRun;
    m_document.beginGesture();
    const Message entry = Message("PressHand", "Press on %1").with(name.toStdString());
    if (const ToolState* taken = toolToTake()) {
        const ToolState tool = m_document.toolWithEdits(taken->id).value_or(*taken);
        press.tool = tool.name;
        press.limit = tool.forceLimit;
        press.poses = posesOf({tool.kind, tool.size, tool.part}, tool.pose.rotation);
        m_document.post(PlaceManipulator{tool.id, press.poses.away}, entry);
        m_document.post(SetManipulatorMotion{tool.id, GoTo{press.poses.deep}}, entry);
    } else {
        Manipulator thumb;
        int number = 1;
        while (std::ranges::find(now.tools, thumbName + std::to_string(number), &ToolState::name) != now.tools.end())
            ++number;
        thumb.name = press.tool = m_thumb = thumbName + std::to_string(number);
        thumb.kind = ToolKind::ball;
        thumb.size = Vec3::Constant(std::max(thumbShare * m_document.size(), thumbSpacings * spacing));
        thumb.friction = thumbFriction;
        thumb.speedLimit = typedNumber(m_document.size() / thumbCrossingTime);
        thumb.forceLimit = press.limit = rounded(thumbForce(now.materials[hit.id], 0.5 * thumb.size.x()));
        press.poses = posesOf(thumb.shape(), thumb.pose.rotation);
        press.isNew = true;
        thumb.pose = press.poses.away;
        m_document.post(AddManipulator{std::move(thumb)}, entry);
    }
    press.request = m_document.requests();
    m_press = std::move(press);
    m_view.setFocus(Qt::MouseFocusReason);
    m_view.setCursor(Qt::ClosedHandCursor);
    if (!m_document.isPlaying())
        m_document.play();
    m_overlay->refresh();
}

bool PressHand::mouseMoved(QMouseEvent& event)
{
    if (!isPressing())
        return false;
    m_cursor = event.position();
    m_overlay->refresh();
    return !m_view.navigatesWith(event.buttons());
}

/// With every picture: a new thumb goes down as soon as it is there, and is selected, so that its force can be typed; one that is
/// lifted has gone when it is back where it came from.
void PressHand::follow()
{
    const ToolState* tool = toolNow();
    if (!m_document.isPlaying()) // it ran into trouble
        return letGo();
    if (tool == nullptr) { // not there yet, or refused, or removed
        if (m_document.hasSeen(m_press->request))
            finish();
        return;
    }
    if (std::exchange(m_press->isNew, false)) {
        m_document.select({Selection::Kind::Tool, tool->id});
        if (!m_press->isLeaving)
            m_document.post(SetManipulatorMotion{tool->id, GoTo{m_press->poses.deep}});
    }
    if (m_press->isLeaving && !m_press->isTold)
        goAway();
    const Vec3 way = m_press->poses.away.position - m_press->poses.deep.position;
    const bool isGone = (tool->pose.position - m_press->poses.away.position).norm() < arrived * way.norm() ||
                        m_document.frame()->snapshot->time > m_press->leaveBy;
    if (m_press->isTold && isGone)
        finish();
    else
        m_overlay->refresh();
}

bool PressHand::mouseReleased(QMouseEvent& event)
{
    if (!isPressing() || event.button() != Qt::LeftButton)
        return false;
    lift();
    return true;
}

bool PressHand::wantsKey(const QKeyEvent& event) const
{
    return isPressing() && event.key() == Qt::Key_Escape;
}

bool PressHand::keyPressed(QKeyEvent& event)
{
    if (!wantsKey(event))
        return false;
    lift();
    return true;
}

/// The tool goes back as it came.
void PressHand::lift()
{
    m_press->isLeaving = true;
    m_view.setCursor(m_view.usualCursor());
    m_overlay->refresh();
    goAway();
}

/// As soon as the simulation has the tool.
void PressHand::goAway()
{
    const ToolState* tool = toolNow();
    if (tool == nullptr)
        return;
    m_press->isTold = true;
    const double way = (m_press->poses.away.position - tool->pose.position).norm();
    m_press->leaveBy = m_document.frame()->snapshot->time + 2 * way / tool->speedLimit + patience;
    m_document.post(SetManipulatorMotion{tool->id, GoTo{m_press->poses.away}});
}

/// Time stands still again if the hand made it run, and no other hand works.
void PressHand::finish()
{
    const bool makesTimeRun = m_press->makesTimeRun;
    letGo();
    if (makesTimeRun && m_document.isPlaying() && !m_document.isInGesture())
        m_document.pause();
}

/// What still presses stays where it is.
void PressHand::letGo()
{
    if (!m_press)
        return;
    if (const ToolState* tool = toolNow(); tool != nullptr && !m_press->isTold)
        m_document.post(SetManipulatorMotion{tool->id, HoldStill{}});
    m_press.reset();
    m_document.endGesture(Document::Ends::soon);
    m_view.setCursor(m_view.usualCursor());
    m_overlay->refresh();
}

double PressHand::force() const
{
    const ToolState* tool = m_press ? toolNow() : nullptr;
    return tool == nullptr ? 0 : tool->force.norm();
}

QString PressHand::note() const
{
    const QString number = formatReading(force(), Quantity::Force);
    return force() >= atLimit * m_press->limit ? tr("%1 (limit)").arg(number) : number;
}

QRect PressHand::overlayArea() const
{
    return isPressing() ? cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font()) : QRect();
}

void PressHand::drawOverlay(QPainter& painter) const
{
    if (isPressing())
        drawCursorNote(painter, note(), overlayArea(), m_overlay->palette());
}

} // namespace knead
