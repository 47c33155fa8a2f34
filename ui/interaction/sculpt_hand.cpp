#include "ui/interaction/sculpt_hand.h"

#include "ui/interaction/spring_line.h"
#include "ui/language/said.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace knead {

namespace {

constexpr double usualShare = 0.06;    // radius of a brush, in sizes of the part
constexpr double fewestSpacings = 1.6; // at least, so that some objects are in it
constexpr double largestShare = 0.5;   // of the part
constexpr double strokeCrossing = 2;   // a finger or a patch would cross the part in this time [s]
constexpr double keyFactor = 1.15;     // of radius and strength with one key or notch of the wheel
constexpr double moreForce = 1.5;      // with one key, at the limit
constexpr double weakest = 0.1;        // of the strength that suits the material
constexpr double strongest = 20;
constexpr int ringCorners = 48;
constexpr int ringMargin = 4;       // [pixels]
constexpr double behindShare = 0.5; // of its radius; a finger farther from where it shall go hangs on a spring
constexpr int toldFor = 1200;       // radius and strength, after they changed [ms]

} // namespace

SculptHand::SculptHand(Document& document, ViewportWidget& view, HandSettings& settings)
    : ViewHand(document, view)
    , m_settings(settings)
    , m_overlay(new ViewOverlay(view, *this, "sculptOverlay"))
    , m_still(document)
{
    view.setMouseTracking(true);
    connect(&document, &Document::changed, this, &SculptHand::documentChanged);
    connect(&document, &Document::stopping, this, &SculptHand::letGo);
    connect(&settings, &HandSettings::changed, m_overlay, &ViewOverlay::refresh);
}

void SculptHand::setBrush(std::optional<SculptBrush> brush)
{
    if (isStroking())
        end();
    m_brush = brush;
    m_view.setMode(brush ? std::optional(usesFingers(*brush) ? Qt::CrossCursor : Qt::PointingHandCursor)
                         : std::nullopt);
    if (!brush)
        m_hover.reset();
    m_overlay->refresh();
}

void SculptHand::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Model:
        m_still.forget();
        m_hover.reset();
        if (HandChoices choices = m_settings.choices(); choices.sculptRadius != 0) {
            choices.sculptRadius = 0; // that of another part
            m_settings.set(choices);
        }
        m_stroke.reset();
        m_startFrame.reset();
        m_request = 0;
        m_view.setCursor(m_view.usualCursor());
        m_overlay->refresh();
        break;
    case Document::Change::Frame:
        if (m_stroke)
            follow();
        break;
    default:
        break;
    }
}

double SculptHand::radius() const
{
    if (m_settings.choices().sculptRadius > 0)
        return m_settings.choices().sculptRadius;
    double spacing = 0;
    for (const auto& body : m_document.content().bodies)
        spacing = std::max(spacing, body->aggregate->lattice.spacing);
    return std::max(usualShare * m_document.size(), fewestSpacings * spacing);
}

void SculptHand::changeRadius(double factor)
{
    if (isStroking()) // its fingers stay as they are
        return;
    HandChoices choices = m_settings.choices();
    choices.sculptRadius = std::clamp(factor * radius(), 1e-3 * m_document.size(), largestShare * m_document.size());
    m_changed.start();
    m_settings.set(choices);
    QTimer::singleShot(toldFor + 20, m_overlay, &ViewOverlay::refresh);
}

void SculptHand::changeStrength(double factor)
{
    HandChoices choices = m_settings.choices();
    const double before = choices.sculptStrength;
    choices.sculptStrength = std::clamp(factor * before, weakest, strongest);
    if (std::abs(choices.sculptStrength - 1) < 0.02)
        choices.sculptStrength = 1;
    m_changed.start();
    if (isStroking())
        m_stroke->strengthen(choices.sculptStrength / before);
    m_settings.set(choices);
    QTimer::singleShot(toldFor + 20, m_overlay, &ViewOverlay::refresh);
}

/// Planes of symmetry go through the middle of the part as it was opened.
Vec3 SculptHand::middle() const
{
    return m_document.content().box.center();
}

SculptChoice SculptHand::choice() const
{
    const HandChoices& choices = m_settings.choices();
    return {.brush = *m_brush,
            .radius = radius(),
            .strength = choices.sculptStrength,
            .pull = {.stiffness = choices.pullStiffness, .limit = choices.pullLimit},
            .mirrored = {choices.mirrorX, choices.mirrorY, choices.mirrorZ},
            .middle = middle(),
            .holdsRest = choices.holdsRest,
            .speed = m_document.size() / strokeCrossing};
}

SurfaceSpot SculptHand::spotAt(const PickHit& hit, const Frame& frame) const
{
    return surfaceSpot(frame.filled[hit.id]->render.triangles, frame.bodies[hit.id]->points, hit.triangle, hit.place,
                       radius());
}

/// Presses on tools and on the cube go on to the view.
bool SculptHand::mousePressed(QMouseEvent& event)
{
    if (isStroking())
        return event.button() == Qt::LeftButton;
    if (const QString reason = m_brush ? whyNotNow(event) : QString(); !reason.isEmpty()) {
        emit refused(reason);
        return true;
    }
    const std::optional<PickHit> hit = m_brush ? pressedBody(event) : std::nullopt;
    if (!hit)
        return false;
    if (!m_document.hasSeen(m_request) ||
        m_stroke) // fingers that go up, or what the stroke before left, are on their way
        return true;
    m_cursor = event.position();
    if (const QString reason = whyNot(hit->id); !reason.isEmpty())
        emit refused(reason);
    else
        begin(*hit);
    return true;
}

QString SculptHand::whyNot(BodyId body) const
{
    if (m_document.frame()->snapshot->bodies[body].kind != BodyKind::deformable)
        return said(Message("SculptHand", "%1 does not deform: make it deformable in the properties, or push it with a "
                                          "tool.")
                        .with(m_document.nameOfBody(body).toStdString()));
    return {};
}

void SculptHand::begin(const PickHit& hit)
{
    const bool wasRunning = m_stroke ? !m_makesTimeRun : m_document.isPlaying();
    const std::string going = m_stroke ? m_stroke->nameOfHold() : std::string();
    letGo(); // of fingers that still go up
    const FramePointer frame = m_document.frame();
    m_still.hide(m_view.options().hiddenParts);
    m_still.cut(m_view.options().section.plane);
    m_still.follow();
    SculptStroke stroke(choice(), hit.id, *frame->snapshot, spotAt(hit, *frame), m_view.camera().right(), going);
    const std::string name = m_document.nameOfBody(hit.id).toStdString();
    if (stroke.isEmpty()) {
        if (!wasRunning && m_document.isPlaying())
            m_document.pause();
        emit refused(
            said(Message("SculptHand", "%1 is held at this place: free it with Fix faces, or take another place.")
                     .with(name)));
        return;
    }
    m_stroke = std::move(stroke);
    m_startFrame = frame;
    m_body = hit.id;
    m_start = hit.place;
    m_hover.reset();
    m_makesTimeRun = !wasRunning;
    m_view.setFocus(Qt::MouseFocusReason);
    m_view.setCursor(usesFingers(*m_brush) ? Qt::CrossCursor : Qt::ClosedHandCursor);
    m_document.beginGesture();
    post(m_stroke->begin(), strokeName(*m_brush, name));
    m_request = m_document.requests();
    if (!m_document.isPlaying())
        m_document.play();
    m_overlay->refresh();
}

void SculptHand::post(const std::vector<Command>& commands, const Message& name)
{
    for (const Command& command : commands)
        m_document.post(command, name);
}

bool SculptHand::mouseMoved(QMouseEvent& event)
{
    m_cursor = event.position();
    if (!isStroking()) {
        if (m_brush && event.buttons() == Qt::NoButton)
            hover();
        return false;
    }
    if (m_view.navigatesWith(event.buttons()))
        return false;
    m_stroke->moveTo(m_view.rayAt(m_cursor).onPlane(m_start, m_view.camera().towardsEye()));
    m_overlay->refresh();
    return true;
}

void SculptHand::hover()
{
    m_hover.reset();
    if (!m_view.isLookingBack() && !m_document.isEmpty() && !m_document.isGoing()) {
        const PickHit hit = m_view.hitAt(m_cursor);
        if (hit.kind == PickHit::Kind::Body)
            m_hover = Hover{hit.id, spotAt(hit, *m_document.frame())};
    }
    m_overlay->refresh();
}

void SculptHand::mouseLeft()
{
    m_hover.reset();
    m_overlay->refresh();
}

/// With every picture: fingers go over the surface as it was when the stroke began, grips to where the hand is.
void SculptHand::follow()
{
    if (!m_document.isPlaying()) // it ran into trouble
        return letGo();
    if (isStroking() && m_startFrame) {
        const PickHit hit = m_still.pickNow(m_view.rayAt(m_cursor), true);
        if (hit.kind == PickHit::Kind::Body && hit.id == m_body)
            m_stroke->moveTo(spotAt(hit, *m_startFrame));
    }
    post(m_stroke->follow(*m_document.frame()->snapshot, m_document.hasSeen(m_request)));
    if (m_stroke->isOver())
        finish();
    m_overlay->refresh();
}

bool SculptHand::mouseReleased(QMouseEvent& event)
{
    if (!isStroking() || event.button() != Qt::LeftButton)
        return false;
    end();
    return true;
}

bool SculptHand::wheelTurned(QWheelEvent& event)
{
    if (!m_brush || !(event.modifiers() & Qt::ShiftModifier))
        return false;
    const QPoint turned = event.angleDelta(); // with Shift some systems turn it aside
    changeStrength(std::pow(keyFactor, (turned.y() != 0 ? turned.y() : turned.x()) / 120.0));
    return true;
}

bool SculptHand::wantsKey(const QKeyEvent& event) const
{
    return isStroking() &&
           (event.key() == Qt::Key_Escape || event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus);
}

bool SculptHand::keyPressed(QKeyEvent& event)
{
    if (!wantsKey(event))
        return false;
    if (event.key() == Qt::Key_Escape)
        end();
    else
        changeStrength(event.key() == Qt::Key_Plus ? moreForce : 1 / moreForce);
    return true;
}

/// The hand opens; fingers are lifted while time goes on.
void SculptHand::end()
{
    post(m_stroke->release(*m_document.frame()->snapshot, m_document.hasSeen(m_request)));
    m_request = m_document.requests();
    m_view.setCursor(m_view.usualCursor());
    if (m_stroke->isOver())
        finish();
    m_overlay->refresh();
}

/// Time stands still again if the hand made it run, and no other hand works.
void SculptHand::finish()
{
    m_stroke.reset();
    m_startFrame.reset();
    m_document.endGesture(Document::Ends::soon);
    m_view.setCursor(m_view.usualCursor());
    if (m_makesTimeRun && m_document.isPlaying() && !m_document.isInGesture())
        m_document.pause();
}

/// At once: time is stopped, or another stroke begins.
void SculptHand::letGo()
{
    if (!m_stroke)
        return;
    post(m_stroke->abandon(*m_document.frame()->snapshot, m_document.hasSeen(m_request)));
    m_request = m_document.requests();
    m_makesTimeRun = false;
    finish();
    m_overlay->refresh();
}

double SculptHand::force() const
{
    return isStroking() ? m_stroke->force(*m_document.frame()->snapshot) : 0;
}

QString SculptHand::note() const
{
    if (m_changed.isValid() && m_changed.elapsed() < toldFor)
        return tr("%1, force %2 %")
            .arg(formatReading(radius(), Quantity::Length))
            .arg(qRound(100 * m_settings.choices().sculptStrength));
    if (!isStroking())
        return {};
    const QString number = formatReading(force(), Quantity::Force);
    return m_stroke->isAtLimit(*m_document.frame()->snapshot) ? tr("%1 (limit; + for more)").arg(number) : number;
}

/// Around the place and those across the planes of symmetry, on the screen.
std::vector<QPolygonF> SculptHand::rings() const
{
    std::vector<QPolygonF> rings;
    if (!m_hover && !isStroking())
        return rings;
    SurfaceSpot spot = m_hover ? m_hover->spot : m_stroke->spot();
    if (isStroking() && usesFingers(*m_brush)) // where the finger is, not where it shall go
        spot.place = m_stroke->placeNow(*m_document.frame()->snapshot);
    const HandChoices& choices = m_settings.choices();
    for (int mirrors = 0; mirrors < 8; ++mirrors) {
        const Vec3 mirror((mirrors & 1) != 0 ? -1 : 1, (mirrors & 2) != 0 ? -1 : 1, (mirrors & 4) != 0 ? -1 : 1);
        if ((mirror.x() < 0 && !choices.mirrorX) || (mirror.y() < 0 && !choices.mirrorY) ||
            (mirror.z() < 0 && !choices.mirrorZ))
            continue;
        const Vec3 place = middle() + mirror.cwiseProduct(spot.place - middle());
        const Vec3 normal = mirror.cwiseProduct(spot.normal);
        const Vec3 first = normal.unitOrthogonal();
        const Vec3 second = normal.cross(first);
        QPolygonF ring;
        for (int corner = 0; corner <= ringCorners; ++corner) {
            const double angle = 2 * std::numbers::pi * corner / ringCorners;
            const Vec3 point = place + radius() * (std::cos(angle) * first + std::sin(angle) * second);
            if (const std::optional<QPointF> seen = m_view.widgetPosition(point))
                ring << *seen;
        }
        rings.push_back(ring);
    }
    return rings;
}

/// Where the spring between material and hand begins, on the screen. A finger has one as long as it is behind.
std::optional<QPointF> SculptHand::springBegin() const
{
    if (!isStroking())
        return {};
    const Vec3 place = m_stroke->placeNow(*m_document.frame()->snapshot);
    if (usesFingers(*m_brush) && (place - m_stroke->spot().place).norm() < behindShare * radius())
        return {};
    return m_view.widgetPosition(place);
}

QRect SculptHand::overlayArea() const
{
    QRect area;
    for (const QPolygonF& ring : rings())
        area |= ring.boundingRect().toAlignedRect().adjusted(-ringMargin, -ringMargin, ringMargin, ringMargin);
    if (const std::optional<QPointF> begin = springBegin())
        area |= springArea(*begin, m_cursor);
    if (const QString text = note(); !text.isEmpty())
        area |= cursorNoteArea(text, m_cursor, m_view.rect(), m_overlay->font());
    return area;
}

void SculptHand::drawOverlay(QPainter& painter) const
{
    const QPalette palette = m_overlay->palette();
    painter.setBrush(Qt::NoBrush);
    bool isFirst = true;
    for (const QPolygonF& ring : rings()) {
        painter.setPen(QPen(QColor(255, 255, 255, 170), isFirst ? 4 : 3));
        painter.drawPolyline(ring);
        painter.setPen(
            QPen(palette.color(QPalette::Highlight), isFirst ? 2 : 1.2, isFirst ? Qt::SolidLine : Qt::DashLine));
        painter.drawPolyline(ring);
        isFirst = false;
    }
    if (const std::optional<QPointF> begin = springBegin())
        drawSpring(painter, *begin, m_cursor, palette);
    if (const QString text = note(); !text.isEmpty())
        drawCursorNote(painter, text, cursorNoteArea(text, m_cursor, m_view.rect(), m_overlay->font()), palette);
}

Message strokeName(SculptBrush brush, const std::string& body)
{
    switch (brush) {
    case SculptBrush::pull:
        return Message("SculptHand", "Pull %1").with(body);
    case SculptBrush::thumb:
        return Message("SculptHand", "Thumb on %1").with(body);
    case SculptBrush::smooth:
        return Message("SculptHand", "Smooth %1").with(body);
    case SculptBrush::flatten:
        return Message("SculptHand", "Flatten %1").with(body);
    case SculptBrush::pinch:
        return Message("SculptHand", "Pinch %1").with(body);
    case SculptBrush::smear:
        return Message("SculptHand", "Smear %1").with(body);
    case SculptBrush::bend:
        return Message("SculptHand", "Bend %1").with(body);
    case SculptBrush::twist:
        return Message("SculptHand", "Twist %1").with(body);
    }
    return {};
}

} // namespace knead
