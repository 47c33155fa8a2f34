#include "ui/interaction/key_hand.h"

#include "ui/interaction/key_cards.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double slowShare = 0.2; // of the speed while Shift is held
constexpr int cardMargin = 10;    // from the corner of the view [pixels]

} // namespace

KeyHand::KeyHand(Document& document, ViewportWidget& view, const HandSettings& settings)
    : ViewHand(document, view)
    , m_settings(settings)
    , m_overlay(new ViewOverlay(view, *this, "keyCards"))
{
    connect(&document, &Document::stopping, this, &KeyHand::letGo);
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model) {
            m_pressed.clear();
            m_driven = {};
        }
        if (m_isOn && what != Document::Change::History)
            m_overlay->refresh();
    });
}

void KeyHand::setOn(bool on)
{
    letGo();
    m_isOn = on;
    m_view.keepFree(this, {.bottom = on ? keyCardsSize().height() + cardMargin : 0.0});
    m_overlay->refresh();
}

const ToolState* KeyHand::tool(std::size_t place) const
{
    if (!m_document.frame())
        return nullptr;
    const std::vector<ToolState>& tools = m_document.frame()->snapshot->tools;
    return place < tools.size() ? &tools[place] : nullptr;
}

bool KeyHand::wantsKey(const QKeyEvent& event) const
{
    const bool isPlain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    return m_isOn && isPlain && !m_view.isLookingBack() && boundKey(event.key()).has_value();
}

double KeyHand::slowness() const
{
    return m_isSlow ? slowShare : 1;
}

bool KeyHand::keyPressed(QKeyEvent& event)
{
    if (!wantsKey(event))
        return false;
    m_isSlow = event.modifiers() & Qt::ShiftModifier;
    const BoundKey key = *boundKey(event.key());
    if (!event.isAutoRepeat())
        m_pressed.insert(event.key());
    if (!m_document.isPlaying())
        step(key);
    else if (!event.isAutoRepeat())
        drive(key.tool);
    m_overlay->refresh();
    return true;
}

bool KeyHand::keyReleased(QKeyEvent& event)
{
    if (event.isAutoRepeat())
        return m_pressed.contains(event.key());
    if (m_pressed.erase(event.key()) == 0)
        return false;
    drive(boundKey(event.key())->tool);
    m_overlay->refresh();
    return true;
}

void KeyHand::keyboardLost()
{
    letGo();
}

/// All tools stop.
void KeyHand::letGo()
{
    m_pressed.clear();
    for (std::size_t place = 0; place < drivenTools; ++place)
        drive(place);
    m_overlay->refresh();
}

/// Tells a tool where the keys that are held want it to go; to stop when none is.
void KeyHand::drive(std::size_t place)
{
    Vec3 direction = Vec3::Zero();
    for (const int key : m_pressed)
        if (const BoundKey bound = *boundKey(key); bound.tool == place)
            direction += keyDirection(bound.arrow, m_view.camera());
    const ToolState* driven = tool(place);
    if (direction.isZero(1e-9)) {
        if (const std::optional<ToolId> stopped = std::exchange(m_driven[place], {})) {
            m_document.post(SetManipulatorMotion{*stopped, HoldStill{}});
            m_document.endGesture(Document::Ends::soon);
        }
        return;
    }
    if (driven == nullptr || !m_document.isPlaying())
        return;
    if (!m_driven[place])
        m_document.beginGesture(QStringLiteral("keys"));
    const double speed = m_settings.choices().keySpeed() * slowness();
    m_document.post(SetManipulatorMotion{driven->id, DriveAt{speed * direction.normalized(), Vec3::Zero()}});
    m_driven[place] = driven->id;
}

/// While time stands still.
void KeyHand::step(const BoundKey& key)
{
    const ToolState* moved = tool(key.tool);
    if (moved == nullptr)
        return;
    const Vec3 step = m_settings.choices().keyStep * slowness() * keyDirection(key.arrow, m_view.camera());
    m_document.moveTool(moved->id, [step](const Pose& from) { return Pose{from.position + step, from.rotation}; });
}

QRect KeyHand::overlayArea() const
{
    if (!m_isOn || m_document.isEmpty() || m_view.isLookingBack())
        return {};
    QRect area(QPoint(), keyCardsSize());
    area.moveBottomLeft({cardMargin, m_view.height() - cardMargin});
    return area;
}

void KeyHand::drawOverlay(QPainter& painter) const
{
    std::array<QString, drivenTools> names;
    for (std::size_t place = 0; place < drivenTools; ++place)
        if (const ToolState* driven = tool(place))
            names[place] = QString::fromStdString(driven->name);
    const HandChoices& choices = m_settings.choices();
    const QString speed = tr("%1 per step, %2 steps per second, Shift: slower")
                              .arg(formatQuantity(choices.keyStep, Quantity::Length),
                                   formatQuantity(choices.stepsPerSecond, Quantity::Number));
    drawKeyCards(painter, overlayArea(), names, m_pressed, speed, m_overlay->palette());
}

} // namespace knead
