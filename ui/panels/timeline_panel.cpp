#include "ui/panels/timeline_panel.h"

#include "ui/commands/availability.h"
#include "ui/commands/strip_keys.h"
#include "ui/document/entry_names.h"
#include "ui/language/said.h"
#include "ui/panels/choice_menu.h"
#include "ui/panels/form.h"
#include "ui/panels/timeline_axis.h"
#include "ui/theme.h"

#include <QAction>
#include <QComboBox>
#include <QElapsedTimer>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr int drawingTime = 40; // [ms]
constexpr int pictureTime = 33; // between pictures while the film is played [ms]
constexpr std::array<double, 7> rates{0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr int usualRate = 3;    // index
constexpr double onTick = 1e-9; // what the axis says is on a tick, is exactly there [s]

QString whyNoFilm(bool wasSimulated = false)
{
    return wasSimulated
               ? TimelinePanel::tr("Projects keep entries and no film: go to one with a double click, or simulate on.")
               : TimelinePanel::tr("Simulate something first, and look back at it.");
}

} // namespace

TimelinePanel::TimelinePanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_axis(new TimelineAxis(
          [&document](History::Entry entry) { return said(document.history().tree().record(entry).label()); }, this))
    , m_soon(new QTimer(this))
    , m_player(new QTimer(this))
    , m_clock(std::make_unique<QElapsedTimer>())
{
    setObjectName("timelinePanel");
    makeButtons();
    m_soon->setSingleShot(true);
    m_soon->setInterval(drawingTime);
    m_player->setInterval(pictureTime);
    connect(m_soon, &QTimer::timeout, this, &TimelinePanel::bringUpToDate);
    connect(m_player, &QTimer::timeout, this, &TimelinePanel::playOn);
    connect(m_axis, &TimelineAxis::grabbed, m_player, &QTimer::stop);
    connect(m_axis, &TimelineAxis::dragged, this, &TimelinePanel::lookAt);
    connect(m_axis, &TimelineAxis::released, this, &TimelinePanel::release);
    connect(m_axis, &TimelineAxis::doubleClicked, this, &TimelinePanel::goThere);
    connect(&document, &Document::changed, this, &TimelinePanel::documentChanged);
    showState();
}

TimelinePanel::~TimelinePanel() = default;

void TimelinePanel::makeButtons()
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 3, 8, 3);
    row->setSpacing(3);
    m_toStart = makeButton("filmStart", "to-start", tr("Look at the start"), tr("Look at the start"));
    m_back = makeButton("filmBack", "back-one", tr("One picture back"), tr("One picture back"));
    m_play = makeButton("filmPlay", "film", tr("Play the film"), tr("Play what was simulated, from where you look"));
    m_on = makeButton("filmOn", "on-one", tr("One picture on"), tr("One picture on"));
    m_toEnd = makeButton("filmEnd", "to-end", tr("Look at the end"), tr("Look at the end"));
    m_rate = makeChoice("filmRate", this);
    for (const double rate : rates)
        m_rate->addItem(said(Message("TimelinePanel", "%1x").with(numberMessage(rate))));
    m_rate->setCurrentIndex(usualRate);
    m_rate->setToolTip(tr("How fast it is played, in simulated per real time"));
    m_rate->setFocusPolicy(Qt::ClickFocus);
    m_state = new QLabel(this);
    m_state->setObjectName("filmState");
    m_branch = makeButton("filmBranch", "branch", tr("Branch here"),
                          tr("Go on from what you see: a new branch of the history"));
    m_return = makeButton("filmReturn", "close", tr("Return"), tr("Back to the present (Esc)"));
    m_branch->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (QToolButton* button : {m_branch, m_return}) { // their room is kept: the axis must not move under the mouse
        QSizePolicy policy = button->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        button->setSizePolicy(policy);
    }
    m_state->setFixedWidth(stateWidth());
    m_state->setAlignment(Qt::AlignCenter);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_toStart, m_back, m_play, m_on, m_toEnd, m_rate, m_axis,
                                                           m_state, m_branch, m_return})
        row->addWidget(widget, widget == m_axis ? 1 : 0);
    new StripKeys(*this);
    connect(m_axis, &TimelineAxis::stepped, this, &TimelinePanel::stepBy);
    connect(m_toStart->defaultAction(), &QAction::triggered, this, [this] { lookAt(0); });
    connect(m_toEnd->defaultAction(), &QAction::triggered, this, [this] { lookAt(m_axis->timeline().end); });
    connect(m_back->defaultAction(), &QAction::triggered, this, [this] { stepBy(-1); });
    connect(m_on->defaultAction(), &QAction::triggered, this, [this] { stepBy(1); });
    connect(m_play->defaultAction(), &QAction::triggered, this, &TimelinePanel::togglePlay);
    connect(m_branch->defaultAction(), &QAction::triggered, this, &TimelinePanel::branchHere);
    connect(m_return->defaultAction(), &QAction::triggered, this, &TimelinePanel::stopLooking);
}

/// With an action of the panel, for menus and keys.
QToolButton* TimelinePanel::makeButton(const char* name, const char* picture, const QString& text, const QString& tip)
{
    auto* action = new QAction(icon(picture), text, this);
    action->setObjectName(name);
    action->setToolTip(tip);
    Availability::setWhyNot(*action, whyNoFilm());
    addAction(action);
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    return button;
}

void TimelinePanel::addButton(QAction* action)
{
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    layout()->addWidget(button);
}

void TimelinePanel::documentChanged(Document::Change what)
{
    const bool isElsewhere = what == Document::Change::Model || what == Document::Change::Moment;
    if (what == Document::Change::Model) // what is on the axis fits it no longer
        m_axis->show({});
    if (isElsewhere || m_document.isPlaying())
        stopLooking();
    if (what == Document::Change::Model)
        showState();
    // Hidden too: its actions are in a menu and on keys as well.
    if (what != Document::Change::Selection && what != Document::Change::Fixtures && !m_soon->isActive())
        m_soon->start();
}

void TimelinePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && m_state != nullptr)
        m_state->setFixedWidth(stateWidth());
}

/// So that it keeps its width while the time goes on.
int TimelinePanel::stateWidth() const
{
    return fontMetrics().horizontalAdvance(QStringLiteral("000.0 ms / 000.0 ms"));
}

void TimelinePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_soon->start();
}

void TimelinePanel::bringUpToDate()
{
    m_axis->show(m_document.timeline());
    showState();
}

void TimelinePanel::lookAt(double at)
{
    if (m_document.isUnderWay())
        m_document.pause();
    m_looking = at;
    m_axis->lookAt(at);
    if (const PlaybackFramePointer frame = frameFor(at); frame && frame != m_seen) {
        m_seen = frame;
        draw();
    }
    showState();
}

/// On another thread, always what is looked at when it gets there: the window never waits for a skin.
void TimelinePanel::draw()
{
    if (std::exchange(m_isDrawing, true))
        return; // drawn() goes on with it
    const QString caption = tr("Looking back at %1   Esc: return").arg(timeText(*m_looking));
    m_drawing.run([this, frame = m_seen, caption, bodies = m_document.content().bodies, look = m_look] {
        const auto tell = [this, frame, caption, look, picture = drawable(*frame, bodies)] {
            drawn(frame, look, picture, caption);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

void TimelinePanel::drawn(const PlaybackFramePointer& frame, std::uint64_t look, const FramePointer& picture,
                          const QString& caption)
{
    m_isDrawing = false;
    if (look == m_look)
        emit looked(picture, caption);
    if (m_seen && (look != m_look || frame != m_seen))
        draw();
}

/// Between pictures while the film is played; what stands still is one at which a branch can begin.
PlaybackFramePointer TimelinePanel::frameFor(double at) const
{
    const Timeline& line = m_axis->timeline();
    const Timeline::Picture* picture = line.pictureAt(at);
    return picture == nullptr || m_player->isActive() ? line.frameAt(at) : picture->frame;
}

/// Whether the entry that one is in lies at a time.
bool TimelinePanel::isPresent(double at) const
{
    const auto present = m_document.history().tree().current();
    const auto& ticks = m_axis->timeline().ticks;
    return std::any_of(ticks.begin(), ticks.end(), [&](const Timeline::Tick& tick) {
        return tick.entry == present && std::abs(tick.at - at) < onTick;
    });
}

/// At the present, or where nothing was filmed, there is nothing to look back at.
void TimelinePanel::release(double at)
{
    if (m_seen == nullptr || isPresent(at))
        stopLooking();
}

/// To the entry at a time, if there is one.
void TimelinePanel::goThere(double at)
{
    if (const Timeline::Tick* tick = m_axis->timeline().tickNear(at, onTick); tick != nullptr && !isPresent(at))
        m_document.goToEntry(tick->entry);
}

void TimelinePanel::stepBy(int pictures)
{
    const auto& all = m_axis->timeline().pictures;
    if (all.empty())
        return;
    m_player->stop();
    const Timeline::Picture* here = m_axis->timeline().pictureAt(m_looking.value_or(m_axis->timeline().present));
    const auto index = static_cast<std::ptrdiff_t>(here - all.data()) + pictures;
    lookAt(all[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, std::ssize(all) - 1))].at);
}

void TimelinePanel::togglePlay()
{
    if (m_player->isActive()) {
        m_player->stop();
        lookAt(m_looking.value_or(m_axis->timeline().present));
    } else if (const auto& all = m_axis->timeline().pictures; !all.empty()) {
        const bool isAtEnd = m_looking.value_or(m_axis->timeline().present) >= all.back().at;
        lookAt(isAtEnd ? 0 : m_looking.value_or(m_axis->timeline().present));
        m_clock->start();
        m_player->start();
    }
    showState();
}

void TimelinePanel::playOn()
{
    constexpr double milliseconds = 1e-3;
    const double passed = milliseconds * static_cast<double>(m_clock->restart());
    const double end = m_axis->timeline().end;
    const double rate = rates[static_cast<std::size_t>(m_rate->currentIndex())];
    const double at = std::min(end, m_looking.value_or(0) + rate * passed);
    if (at >= end)
        m_player->stop();
    lookAt(at);
}

void TimelinePanel::branchHere()
{
    m_player->stop();
    // What was just seen is no entry yet, and a branch begins in one.
    m_document.whenSettled([this] {
        bringUpToDate();
        const Timeline::Picture* picture = m_looking ? m_axis->timeline().pictureAt(*m_looking) : nullptr;
        if (picture != nullptr && !picture->isUnderWay)
            m_document.branchAt(picture->entry, picture->frame->step, picture->run);
    });
}

QMenu* TimelinePanel::newRateMenu(QWidget* window) const
{
    return menuOf(m_rate, tr("Speed of the film"), window, whyNoFilm());
}

void TimelinePanel::stopLooking()
{
    m_player->stop();
    if (!m_looking)
        return;
    m_looking.reset();
    m_seen.reset();
    ++m_look;
    m_axis->lookAt({});
    emit looked(nullptr, {});
    showState();
}

void TimelinePanel::showState()
{
    const bool hasFilm = !m_axis->timeline().pictures.empty();
    for (QToolButton* button : {m_toStart, m_back, m_play, m_on, m_toEnd}) {
        button->defaultAction()->setEnabled(hasFilm);
        button->defaultAction()->setProperty("whyDisabled", whyNoFilm(m_axis->lacksFilm()));
    }
    m_rate->setProperty("whyDisabled", whyNoFilm(m_axis->lacksFilm()));
    m_rate->setEnabled(hasFilm);
    const bool isPlaying = m_player->isActive();
    m_play->defaultAction()->setIcon(icon(isPlaying ? "pause" : "film"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_branch, m_return})
        widget->setVisible(m_looking.has_value());
    m_branch->defaultAction()->setEnabled(m_looking && hasFilm && !m_document.isGoing());
    m_return->defaultAction()->setEnabled(m_looking.has_value());
    const Timeline& line = m_axis->timeline();
    m_state->setText(timeText(m_looking.value_or(line.present)) + " / " + timeText(line.end));
}

} // namespace knead
