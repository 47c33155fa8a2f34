#include "ui/panels/status_readings.h"

#include "ui/language/retranslation.h"
#include "ui/language/said.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>

namespace knead {

namespace {

constexpr double realTime = 0.95; // from here on the ratio counts as real time

} // namespace

Message ratioWords(double ratio)
{
    constexpr double leastShown = 0.001;
    const QString number = ratio > 0 && ratio < leastShown ? QLatin1Char('<') + localNumber(leastShown, 'f', 3)
                                                           : localNumber(ratio, 'f', ratio < 0.1 ? 3 : 2);
    return Message("QObject", "%1x real time").with(number.toStdString());
}

QString ratioText(double ratio)
{
    return said(ratioWords(ratio));
}

StatusReadings::StatusReadings(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("statusReadings");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 0, 8, 0);
    row->setSpacing(14);
    row->addStretch(1);
    m_ratio = add("ratio", tr("Simulated time per wall time"));
    m_updates = add("updates", tr("Frames the simulation delivers per second"));
    m_steps = add("steps", tr("Time steps per frame"));
    m_integrator = add("integratorInUse", {});
    m_objects = add("objectCount", tr("Spheres the bodies are made of"));
    m_connections = add("connectionCount", tr("Structural connections between objects"));
    m_contacts = add("contactCount", tr("Contact connections now"));
    m_broken = add("brokenCount", tr("Structural connections that broke so far"));
    m_pieces = add("pieceCount", tr("Connected pieces of material"));
    m_units = add("units", tr("Units of what is shown"));
    m_units->setText("mm, N, MPa");
}

/// Those that have something to say, in the order in which they stand.
std::vector<QLabel*> StatusReadings::spoken() const
{
    std::vector<QLabel*> labels;
    for (QLabel* label :
         {m_ratio, m_updates, m_steps, m_integrator, m_objects, m_connections, m_contacts, m_broken, m_pieces, m_units})
        if (!label->text().isEmpty())
            labels.push_back(label);
    return labels;
}

int StatusReadings::roomFor(const std::vector<QLabel*>& labels) const
{
    const QMargins margins = layout()->contentsMargins();
    int room = margins.left() + margins.right();
    for (const QLabel* label : labels)
        room += label->sizeHint().width() + layout()->spacing();
    return room;
}

QSize StatusReadings::sizeHint() const
{
    return {roomFor(spoken()), layout()->sizeHint().height()};
}

QSize StatusReadings::minimumSizeHint() const
{
    return {roomFor({m_ratio}), layout()->minimumSize().height()};
}

bool StatusReadings::event(QEvent* event)
{
    if (event->type() == QEvent::Resize)
        fit();
    return QWidget::event(event);
}

/// Units are the same all day; steps and updates follow from the ratio; how fast it runs is said in any case.
void StatusReadings::fit()
{
    std::vector<QLabel*> shown = spoken();
    for (QLabel* least :
         {m_units, m_steps, m_updates, m_connections, m_integrator, m_objects, m_contacts, m_pieces, m_broken})
        if (roomFor(shown) > width())
            std::erase(shown, least);
    for (QLabel* label : findChildren<QLabel*>())
        label->setVisible(std::find(shown.begin(), shown.end(), label) != shown.end());
}

QLabel* StatusReadings::add(const QString& name, const QString& tip)
{
    auto* label = new QLabel(this);
    label->setObjectName(name);
    label->setToolTip(tip);
    setRole(*label, "dimmed");
    layout()->addWidget(label);
    return label;
}

/// What is left out to keep up is said.
QString StatusReadings::stepsText(const Snapshot& snapshot)
{
    if (snapshot.rest > 0)
        return tr("At rest");
    const bool isImplicit = snapshot.integrator == Integrator::implicitEuler;
    if (isImplicit && snapshot.pace == Pace::wide)
        return tr("30 steps a second to keep up");
    if (isImplicit && snapshot.pace == Pace::rough)
        return tr("Rough steps to keep up");
    return snapshot.stepsPerFrame == 1 ? tr("1 step/frame") : tr("%1 steps/frame").arg(snapshot.stepsPerFrame);
}

void StatusReadings::showUnits(const QString& units)
{
    m_units->setText(units);
}

void StatusReadings::show(const Snapshot& snapshot)
{
    const bool isSlow = snapshot.ratio < realTime * m_speed;
    const QString chosen =
        tr("%1x of %2x as chosen")
            .arg(localNumber(snapshot.ratio, 'f', snapshot.ratio < 0.1 ? 3 : 2), localNumber(m_speed, 'g', 6));
    m_ratio->setText(!snapshot.playing ? tr("Paused") : m_speed == 1 ? ratioText(snapshot.ratio) : chosen);
    setRole(*m_ratio, snapshot.playing && isSlow ? "slow" : "heading");
    m_updates->setText(snapshot.playing ? tr("%1 Hz").arg(snapshot.updatesPerSecond, 0, 'f', 0) : QString());
    m_steps->setText(snapshot.playing ? stepsText(snapshot) : QString());
    m_steps->setToolTip(snapshot.pace == Pace::full
                            ? QString()
                            : tr("Forces are within 3 % of the largest. The Simulation panel says "
                                 "whether to keep up with real time or to be exact"));
    m_integrator->setText(snapshot.integrator == Integrator::implicitEuler  ? tr("Implicit")
                          : snapshot.integrator == Integrator::forwardEuler ? tr("Forward")
                                                                            : tr("Explicit"));
    m_integrator->setToolTip(said(snapshot.integratorReason));
    m_objects->setText(tr("%1 objects").arg(formatCount(snapshot.objects)));
    m_connections->setText(tr("%1 connections").arg(formatCount(snapshot.connections)));
    m_contacts->setText(tr("%1 contacts").arg(formatCount(snapshot.contacts)));
    m_broken->setText(snapshot.broken > 0 ? tr("%1 broken").arg(formatCount(snapshot.broken)) : QString());
    const QString pieces =
        snapshot.components == 1 ? tr("1 piece") : tr("%1 pieces").arg(formatCount(snapshot.components));
    m_pieces->setText(snapshot.components != snapshot.bodies.size() ? pieces : QString());
    updateGeometry();
    fit();
}

TaskReading::TaskReading(QWidget* parent)
    : QWidget(parent)
    , m_stage(new QLabel(this))
    , m_bar(new QProgressBar(this))
{
    setObjectName("taskReading");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(8);
    m_stage->setObjectName("taskStage");
    m_stage->setMinimumWidth(
        fontMetrics().horizontalAdvance(QStringLiteral("Opening assembly.step: preparing the simulation")));
    m_bar->setObjectName("taskProgress");
    m_bar->setRange(0, 1000);
    m_bar->setFixedWidth(160);
    m_bar->setTextVisible(false);
    auto* cancel = new QToolButton(this);
    cancel->setObjectName("taskCancel");
    cancel->setIcon(icon("close"));
    cancel->setText(tr("Cancel"));
    cancel->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    row->addWidget(m_stage);
    row->addWidget(m_bar);
    row->addWidget(cancel);
    connect(cancel, &QToolButton::clicked, this, &TaskReading::cancelClicked);
    hide();
}

void TaskReading::begin(const QString& title)
{
    m_title = title;
    progress(0, {});
    QWidget::show();
}

void TaskReading::progress(double fraction, const QString& stage)
{
    m_title = saidAnew(m_title);
    m_stage->setText(stage.isEmpty() ? m_title : m_title + ": " + stage);
    m_bar->setValue(static_cast<int>(fraction * m_bar->maximum()));
}

void TaskReading::end()
{
    hide();
}

} // namespace knead
