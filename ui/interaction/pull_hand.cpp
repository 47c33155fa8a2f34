#include "ui/interaction/pull_hand.h"

#include "ui/interaction/spring_line.h"
#include "ui/language/said.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double patchShare = 0.06;    // radius of the patch, in sizes of the part
constexpr double fewestSpacings = 1.6; // at least, so that some objects are in it
constexpr double largestRate = 3;      // the patch crosses the part so often in a second at most
constexpr double smoothing = 0.5;      // share of the newest force: waves pass through
constexpr double worthTelling = 0.02;  // of the largest speed

} // namespace

PullHand::PullHand(Document& document, ViewportWidget& view, const HandSettings& settings)
    : ViewHand(document, view)
    , m_settings(settings)
    , m_overlay(new ViewOverlay(view, *this, "pullSpring"))
{
    connect(&document, &Document::changed, this, &PullHand::documentChanged);
    connect(&document, &Document::stopping, this, &PullHand::letGo);
}

void PullHand::setOn(bool on)
{
    if (!on && m_pull)
        end();
    m_isOn = on;
    m_view.setMode(on ? std::optional(Qt::PointingHandCursor) : std::nullopt);
}

void PullHand::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Model:
    case Document::Change::Moment:
        m_pull.reset();
        m_overlay->refresh();
        break;
    case Document::Change::Frame:
        if (m_pull)
            follow();
        break;
    default:
        break;
    }
}

/// Presses on tools and on the cube go on to the view.
bool PullHand::mousePressed(QMouseEvent& event)
{
    if (m_pull)
        return event.button() == Qt::LeftButton;
    const std::optional<PickHit> hit = m_isOn ? pressedBody(event) : std::nullopt;
    if (!hit)
        return false;
    m_cursor = event.position();
    begin(*hit);
    return true;
}

void PullHand::begin(const PickHit& hit)
{
    const Snapshot& now = *m_document.frame()->snapshot;
    const QString name = m_document.nameOfBody(hit.id);
    if (now.bodies[hit.id].kind != BodyKind::deformable) {
        emit refused(said(
            Message("PullHand", "%1 does not deform: make it deformable in the properties, or push it with a tool.")
                .with(name.toStdString())));
        return;
    }
    const double spacing = m_document.content().bodies[hit.id]->aggregate->lattice.spacing;
    const double radius = std::max(patchShare * m_document.size(), fewestSpacings * spacing);
    Pull pull;
    pull.body = hit.id;
    pull.objects = patchAround(hit.id, hit.place, radius);
    if (pull.objects.empty()) {
        emit refused(
            said(Message("PullHand", "%1 is held at this place: free it with Fix faces, or pull at another place.")
                     .with(name.toStdString())));
        return;
    }
    pull.grip = freeName();
    pull.place = pull.hand = hit.place;
    const HandChoices& choices = m_settings.choices();
    pull.spring = springFor(now.materials[hit.id], radius, {choices.pullStiffness, choices.pullLimit});
    pull.makesTimeRun = !m_document.isPlaying();
    m_pull = std::move(pull);
    m_pull->patch = patchNow();
    m_view.setFocus(Qt::MouseFocusReason);
    m_view.setCursor(Qt::ClosedHandCursor);
    m_document.beginGesture();
    m_document.post(AddFixture{{m_pull->grip, hit.id, m_pull->objects}},
                    Message("PullHand", "Pull %1").with(name.toStdString()));
    if (m_pull->makesTimeRun)
        m_document.play();
    m_overlay->refresh();
}

/// Objects near a place, as they lie now; those that others hold stay where they are.
std::vector<ObjectIndex> PullHand::patchAround(BodyId body, const Vec3& place, double radius) const
{
    const Snapshot& now = *m_document.frame()->snapshot;
    const std::vector<Vec3>& positions = now.bodies[body].positions;
    std::vector<std::uint8_t> isHeld(positions.size());
    for (const Fixture& fixture : now.fixtures)
        if (fixture.body == body)
            for (const ObjectIndex object : fixture.objects)
                if (object < isHeld.size())
                    isHeld[object] = 1;
    std::vector<ObjectIndex> objects;
    for (ObjectIndex object = 0; object < positions.size(); ++object)
        if (isHeld[object] == 0 && (positions[object] - place).norm() <= radius)
            objects.push_back(object);
    return objects;
}

std::string PullHand::freeName()
{
    const auto isTaken = [&](const std::string& name) {
        const std::vector<Fixture>& fixtures = m_document.frame()->snapshot->fixtures;
        return std::any_of(fixtures.begin(), fixtures.end(), [&](const Fixture& f) { return f.name == name; });
    };
    std::string name;
    do
        name = "Pull " + std::to_string(++m_count);
    while (isTaken(name));
    return name;
}

/// Which fixture of the snapshot is the grip; nothing before the simulation has it.
std::optional<std::size_t> PullHand::gripNow() const
{
    const std::vector<Fixture>& fixtures = m_document.frame()->snapshot->fixtures;
    const auto found =
        std::find_if(fixtures.begin(), fixtures.end(), [this](const Fixture& f) { return f.name == m_pull->grip; });
    return found == fixtures.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - fixtures.begin()));
}

Vec3 PullHand::patchNow() const
{
    const std::vector<Vec3>& positions = m_document.frame()->snapshot->bodies[m_pull->body].positions;
    Vec3 sum = Vec3::Zero();
    for (const ObjectIndex object : m_pull->objects)
        sum += positions[object];
    return sum / static_cast<double>(m_pull->objects.size());
}

/// Where the place is now that was taken.
Vec3 PullHand::placeNow() const
{
    return m_pull->place + patchNow() - m_pull->patch;
}

double PullHand::force() const
{
    return m_pull ? springForce(m_pull->spring, m_pull->hand - placeNow()).norm() : 0;
}

bool PullHand::mouseMoved(QMouseEvent& event)
{
    if (!m_pull)
        return false;
    m_cursor = event.position();
    if (event.buttons() & Qt::MiddleButton) // the view turns
        return false;
    m_pull->hand = m_view.rayAt(m_cursor).onPlane(m_pull->place, m_view.camera().towardsEye());
    m_overlay->refresh();
    return true;
}

/// With every picture: the patch is told where to go.
void PullHand::follow()
{
    if (!m_document.isPlaying()) { // it ran into trouble
        letGo();
        return;
    }
    Pull& pull = *m_pull;
    if (const std::optional<std::size_t> grip = gripNow()) {
        const Snapshot& now = *m_document.frame()->snapshot;
        pull.id = now.fixtureIds[*grip];
        pull.material += smoothing * (now.fixtureForces[*grip] - pull.material);
        const double largest = largestRate * m_document.size();
        const Vec3 wanted = pullVelocity(pull.spring, pull.hand - placeNow(), pull.material, largest);
        if ((wanted - pull.velocity).norm() > worthTelling * std::max(pull.velocity.norm(), worthTelling * largest)) {
            pull.velocity = wanted;
            m_document.post(MoveFixture{*pull.id, wanted});
        }
    }
    m_overlay->refresh();
}

bool PullHand::mouseReleased(QMouseEvent& event)
{
    if (!m_pull || event.button() != Qt::LeftButton)
        return false;
    end();
    return true;
}

bool PullHand::wantsKey(const QKeyEvent& event) const
{
    return m_pull && event.key() == Qt::Key_Escape;
}

bool PullHand::keyPressed(QKeyEvent& event)
{
    if (!wantsKey(event))
        return false;
    end();
    return true;
}

/// The hand opens; time stands still again if the hand made it run.
void PullHand::end()
{
    if (m_pull->makesTimeRun && m_document.isPlaying())
        m_document.pause(); // and so lets go
    else
        letGo();
}

void PullHand::letGo()
{
    const std::optional<Pull> pull = std::exchange(m_pull, {});
    if (!pull)
        return;
    // Before the first picture of it the grip has the number that the next fixture gets.
    const FixtureId id = pull->id.value_or(m_document.frame()->snapshot->nextFixture);
    m_document.post(RemoveFixture{id});
    m_document.endGesture(Document::Ends::soon);
    m_view.setCursor(m_view.usualCursor());
    m_overlay->refresh();
}

QString PullHand::note() const
{
    const bool isLimited = force() >= 0.999 * m_pull->spring.limit;
    const QString number = formatReading(force(), Quantity::Force);
    return isLimited ? tr("%1 (limit)").arg(number) : number;
}

QRect PullHand::overlayArea() const
{
    if (!m_pull)
        return {};
    const std::optional<QPointF> begin = m_view.widgetPosition(placeNow());
    if (!begin)
        return {};
    return springArea(*begin, m_cursor) | cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font());
}

void PullHand::drawOverlay(QPainter& painter) const
{
    const std::optional<QPointF> begin = m_pull ? m_view.widgetPosition(placeNow()) : std::nullopt;
    if (!begin)
        return;
    drawSpring(painter, *begin, m_cursor, m_overlay->palette());
    drawCursorNote(painter, note(), cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font()),
                   m_overlay->palette());
}

} // namespace knead
