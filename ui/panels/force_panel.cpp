#include "ui/panels/force_panel.h"

#include "ui/panels/form.h"
#include "ui/panels/plot_view.h"

#include <QAction>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QEvent>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double shortestTime = 0.1; // that the axis shows [s]

constexpr int pace = 120;                         // between two looks [ms]
constexpr int restPerLook = 6;                    // times as long as a look takes, the window does something else
constexpr std::uint64_t fixtureIds = 1ULL << 32U; // of their lines, beyond those of tools

// Okabe and Ito's colors, told apart by everyone; in an order that is strong on white and on black.
const std::array<QColor, 7> curveColors = {QColor(0xe6, 0x7e, 0x00), QColor(0x1f, 0x83, 0xd6), QColor(0x00, 0x9e, 0x73),
                                           QColor(0xcc, 0x5f, 0xa0), QColor(0xd5, 0x3e, 0x2a), QColor(0x56, 0xb4, 0xe9),
                                           QColor(0xb8, 0xa8, 0x1e)};

} // namespace

ForcePanel::ForcePanel(Document& document, QAction* exportTable, QAction* withStrokes, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_withStrokes(withStrokes)
    , m_plot(new PlotView(this))
    , m_component(makeChoice("forceComponent", this))
    , m_soon(new QTimer(this))
{
    setObjectName("forcePanel");
    m_plot->setObjectName("forcePlot");
    m_component->addItems({tr("Magnitude"), tr("X"), tr("Y"), tr("Z")});
    m_component->setToolTip(tr("What of the force is plotted"));
    m_component->setFocusPolicy(Qt::ClickFocus);
    auto* button = new QToolButton(this);
    button->setDefaultAction(exportTable);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    auto* strokes = boxFor(withStrokes, this);
    strokes->setFocusPolicy(Qt::NoFocus);
    auto* side = new QVBoxLayout;
    side->setContentsMargins(8, 6, 8, 6);
    side->addWidget(m_component);
    side->addWidget(strokes);
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
    connect(m_component, &QComboBox::currentIndexChanged, this, [this] { plot(std::move(m_record)); });
    connect(withStrokes, &QAction::toggled, m_soon, qOverload<>(&QTimer::start));
    connect(&document, &Document::changed, this, &ForcePanel::documentChanged);
    plot({});
}

void ForcePanel::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model)
        plot({});
    if (isVisible() && what != Document::Change::Selection && what != Document::Change::Fixtures && !m_soon->isActive())
        m_soon->start();
}

void ForcePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_soon->start();
}

void ForcePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        plot(std::move(m_record));
}

void ForcePanel::plot(ForceRecord record)
{
    m_record = std::move(record);
    const auto component = static_cast<ForceComponent>(m_component->currentIndex());
    std::vector<PlotLine> lines;
    for (const ForceRecord::Curve& curve : m_record.curves) {
        PlotLine line{.name = QString::fromStdString(curve.name),
                      .color = curveColors[lines.size() % curveColors.size()],
                      .id = curve.isTool ? curve.id : fixtureIds + curve.id,
                      .style = curve.isTool ? Qt::SolidLine : Qt::DashLine};
        for (std::size_t i = 0; i < curve.forces.size(); ++i)
            line.points.emplace_back(m_record.times[i], curve.forces[i] ? valueOf(*curve.forces[i], component) : NAN);
        lines.push_back(std::move(line));
    }
    m_plot->setHint(tr("Add a tool and press Space: forces over time appear here."));
    m_plot->show(std::move(lines), Quantity::Force, tr("Force"), PlotRange{0, std::max(m_record.end, shortestTime)});
}

/// Leaves the window most of its time, however long the timeline is.
void ForcePanel::bringUpToDate()
{
    QElapsedTimer clock;
    clock.start();
    plot(forceRecordOf(m_document.timeline(), m_withStrokes->isChecked()));
    m_plot->repaint(); // now: it is part of what a look takes
    m_soon->setInterval(std::max(pace, restPerLook * static_cast<int>(clock.elapsed())));
}

} // namespace knead
