#include "ui/panels/force_panel.h"

#include "ui/panels/force_plot.h"
#include "ui/panels/form.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace knead {

namespace {

constexpr int pace = 120;      // between two looks [ms]
constexpr int restPerLook = 6; // times as long as a look takes, the window does something else

} // namespace

ForcePanel::ForcePanel(Document& document, QAction* exportTable, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_plot(new ForcePlot(this))
    , m_component(makeChoice("forceComponent", this))
    , m_soon(new QTimer(this))
{
    setObjectName("forcePanel");
    m_component->addItems({tr("Magnitude"), tr("X"), tr("Y"), tr("Z")});
    m_component->setToolTip(tr("What of the force is plotted"));
    m_component->setFocusPolicy(Qt::ClickFocus);
    auto* button = new QToolButton(this);
    button->setDefaultAction(exportTable);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    auto* side = new QVBoxLayout;
    side->setContentsMargins(8, 6, 8, 6);
    side->addWidget(m_component);
    side->addWidget(button);
    side->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_plot, 1);
    row->addLayout(side);
    m_soon->setSingleShot(true);
    m_soon->setInterval(pace);
    connect(m_soon, &QTimer::timeout, this, &ForcePanel::bringUpToDate);
    connect(m_component, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_plot->show(static_cast<ForceComponent>(index)); });
    connect(&document, &Document::changed, this, &ForcePanel::documentChanged);
}

void ForcePanel::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model)
        m_plot->show(ForceRecord());
    if (isVisible() && what != Document::Change::Selection && what != Document::Change::Fixtures && !m_soon->isActive())
        m_soon->start();
}

void ForcePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_soon->start();
}

/// Leaves the window most of its time, however long the timeline is.
void ForcePanel::bringUpToDate()
{
    QElapsedTimer clock;
    clock.start();
    m_plot->show(forceRecordOf(m_document.timeline()));
    m_plot->repaint(); // now: it is part of what a look takes
    m_soon->setInterval(std::max(pace, restPerLook * static_cast<int>(clock.elapsed())));
}

} // namespace knead
