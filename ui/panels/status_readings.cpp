#include "ui/panels/status_readings.h"

#include "ui/theme.h"
#include "ui/units.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStyle>
#include <QToolButton>

namespace knead {

namespace {

constexpr double realTime = 0.95; // from here on the ratio counts as real time

void setRole(QLabel* label, const char* role)
{
    if (label->property("role").toString() == role)
        return;
    label->setProperty("role", role);
    label->style()->unpolish(label);
    label->style()->polish(label);
}

} // namespace

QString ratioText(double ratio)
{
    const QString number = QString::number(ratio, 'f', ratio < 0.1 ? 3 : 2) + 'x';
    return ratio < realTime ? QObject::tr("%1 slower than real time").arg(number) : number;
}

StatusReadings::StatusReadings(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("statusReadings");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(14);
    m_ratio = add("ratio", tr("Simulated time per wall time"));
    m_updates = add("updates", tr("Frames the simulation delivers per second"));
    m_steps = add("steps", tr("Time steps per frame"));
    m_integrator = add("integratorInUse", {});
    m_objects = add("objectCount", tr("Spheres the bodies are made of"));
    m_connections = add("connectionCount", tr("Structural connections between objects"));
    m_contacts = add("contactCount", tr("Contact connections now"));
    m_broken = add("brokenCount", tr("Structural connections that broke so far"));
    m_pieces = add("pieceCount", tr("Connected pieces of material"));
    add("units", tr("Units of what is shown"))->setText("mm, N, MPa");
}

QLabel* StatusReadings::add(const QString& name, const QString& tip)
{
    auto* label = new QLabel(this);
    label->setObjectName(name);
    label->setToolTip(tip);
    setRole(label, "dimmed");
    layout()->addWidget(label);
    return label;
}

void StatusReadings::show(const Snapshot& snapshot)
{
    const bool isSlow = snapshot.ratio < realTime * m_speed;
    const QString chosen =
        tr("%1x of %2x as chosen").arg(snapshot.ratio, 0, 'f', snapshot.ratio < 0.1 ? 3 : 2).arg(m_speed);
    m_ratio->setText(!snapshot.playing ? tr("Paused") : m_speed == 1 ? ratioText(snapshot.ratio) : chosen);
    setRole(m_ratio, snapshot.playing && isSlow ? "slow" : "heading");
    m_updates->setText(snapshot.playing ? tr("%1 Hz").arg(snapshot.updatesPerSecond, 0, 'f', 0) : QString());
    m_steps->setText(snapshot.playing ? (snapshot.stepsPerFrame == 1 ? tr("1 step/frame")
                                                                     : tr("%1 steps/frame").arg(snapshot.stepsPerFrame))
                                      : QString());
    m_updates->setVisible(snapshot.playing);
    m_steps->setVisible(snapshot.playing);
    m_integrator->setText(snapshot.integrator == Integrator::implicitEuler  ? tr("Implicit")
                          : snapshot.integrator == Integrator::forwardEuler ? tr("Forward")
                                                                            : tr("Explicit"));
    m_integrator->setToolTip(QString::fromStdString(snapshot.integratorReason));
    m_objects->setText(tr("%1 objects").arg(formatCount(snapshot.objects)));
    m_connections->setText(tr("%1 connections").arg(formatCount(snapshot.connections)));
    m_contacts->setText(tr("%1 contacts").arg(formatCount(snapshot.contacts)));
    m_broken->setText(tr("%1 broken").arg(formatCount(snapshot.broken)));
    m_broken->setVisible(snapshot.broken > 0);
    m_pieces->setText(snapshot.components == 1 ? tr("1 piece") : tr("%1 pieces").arg(formatCount(snapshot.components)));
    m_pieces->setVisible(snapshot.components != snapshot.bodies.size());
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
    m_stage->setText(stage.isEmpty() ? m_title : m_title + ": " + stage);
    m_bar->setValue(static_cast<int>(fraction * m_bar->maximum()));
}

void TaskReading::end()
{
    hide();
}

} // namespace knead
