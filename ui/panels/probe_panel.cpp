#include "ui/panels/probe_panel.h"

#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr int readingTime = 80;     // [ms]
constexpr int probeSwatchSize = 12; // [pixels]

struct QuantityLook {
    const char* name;
    const char* title; ///< in the plot
    Quantity quantity;
    double ProbeSample::*value;
};

/// In the order of ProbeQuantity.
const std::array<QuantityLook, 4>& quantityLooks()
{
    static const std::array<QuantityLook, 4> all{{
        {QT_TRANSLATE_NOOP("ProbePanel", "Displacement"), QT_TRANSLATE_NOOP("ProbePanel", "Displacement"),
         Quantity::Length, &ProbeSample::displacement},
        {QT_TRANSLATE_NOOP("ProbePanel", "Equivalent strain"), QT_TRANSLATE_NOOP("ProbePanel", "Equivalent strain"),
         Quantity::Number, &ProbeSample::strain},
        {QT_TRANSLATE_NOOP("ProbePanel", "Von Mises stress"), QT_TRANSLATE_NOOP("ProbePanel", "Von Mises stress"),
         Quantity::Pressure, &ProbeSample::stress},
        {QT_TRANSLATE_NOOP("ProbePanel", "Force on tools"), QT_TRANSLATE_NOOP("ProbePanel", "Force on all tools"),
         Quantity::Force, &ProbeSample::force},
    }};
    return all;
}

QIcon swatch(const QColor& color)
{
    QPixmap pixmap(probeSwatchSize, probeSwatchSize);
    pixmap.fill(color);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // the color of the curve, in a selected line, too
    return icon;
}

QString reading(double value, Quantity quantity)
{
    return std::isfinite(value) ? formatReading(value, quantity) : QStringLiteral("–");
}

} // namespace

ProbePanel::ProbePanel(ProbeSet& probes, QAction* place, QWidget* parent)
    : QWidget(parent)
    , m_probes(probes)
    , m_list(new QTreeWidget(this))
    , m_plot(new PlotView(this))
    , m_soon(new QTimer(this))
{
    setObjectName("probePanel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    makeRow(place);
    m_list->setObjectName("probes");
    m_list->setAccessibleName(tr("Probes"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setRootIsDecorated(false);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setHeaderLabels({tr("Probe"), tr("Displacement"), tr("Strain"), tr("Stress")});
    m_list->header()->setDefaultSectionSize(88);
    m_list->setColumnWidth(0, 92);
    m_plot->setObjectName("probePlot");
    sayWhatToDo();
    auto* halves = new QSplitter(this);
    halves->addWidget(m_list);
    halves->addWidget(m_plot);
    halves->setStretchFactor(0, 0);
    halves->setStretchFactor(1, 1);
    halves->setSizes({370, 700});
    halves->setChildrenCollapsible(false);
    column->addWidget(halves, 1);
    m_soon->setSingleShot(true);
    m_soon->setInterval(readingTime);
    connect(m_soon, &QTimer::timeout, this, &ProbePanel::showReadings);
    connect(&probes, &ProbeSet::changed, this, &ProbePanel::makeRows);
    connect(&probes, &ProbeSet::sampled, this, [this] {
        if (isVisible() && !m_soon->isActive())
            m_soon->start();
    });
    makeRows();
}

void ProbePanel::makeRow(QAction* place)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    auto* button = new QToolButton(this);
    button->setDefaultAction(place);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    m_quantity = makeChoice("probeQuantity", this);
    for (const QuantityLook& look : quantityLooks())
        m_quantity->addItem(tr(look.name));
    m_quantity->setToolTip(tr("What is plotted over time"));
    connect(m_quantity, &QComboBox::currentIndexChanged, this, &ProbePanel::chooseQuantity);
    m_csv = new QToolButton(this);
    m_csv->setObjectName("probeCsv");
    m_csv->setIcon(icon("export"));
    m_csv->setText(tr("CSV..."));
    m_csv->setToolTip(tr("Write all readings over time to a file, units in its header"));
    m_csv->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_csv->setAutoRaise(true);
    connect(m_csv, &QToolButton::clicked, this, &ProbePanel::csvWanted);
    m_delete = new QToolButton(this);
    m_delete->setObjectName("probeDelete");
    m_delete->setIcon(icon("delete"));
    m_delete->setToolTip(tr("Delete the selected probes, or all"));
    m_delete->setAccessibleName(m_delete->toolTip());
    m_delete->setAutoRaise(true);
    connect(m_delete, &QToolButton::clicked, this, &ProbePanel::removeSelected);
    row->addWidget(button);
    row->addWidget(m_quantity);
    row->addStretch(1);
    row->addWidget(m_csv);
    row->addWidget(m_delete);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

ProbeQuantity ProbePanel::quantity() const
{
    return static_cast<ProbeQuantity>(m_quantity->currentIndex());
}

void ProbePanel::chooseQuantity()
{
    m_probes.setWithStrains(quantity() == ProbeQuantity::strain || quantity() == ProbeQuantity::stress);
    showReadings();
}

void ProbePanel::makeRows()
{
    m_list->clear();
    for (const Probe& probe : m_probes.all()) {
        auto* row = new QTreeWidgetItem(m_list);
        row->setIcon(0, swatch(probe.color));
    }
    for (QToolButton* button : {m_csv, m_delete})
        button->setEnabled(!m_probes.all().empty());
    m_list->setVisible(!m_probes.all().empty());
    showReadings();
}

void ProbePanel::showReadings()
{
    const auto& probes = m_probes.all();
    std::vector<PlotLine> lines;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const bool isOneForAll = quantity() == ProbeQuantity::force;
        if (!isOneForAll || i == 0)
            lines.push_back(lineOf(probes[i]));
        QTreeWidgetItem* row = m_list->topLevelItem(static_cast<int>(i));
        row->setText(0, tr("Probe %1").arg(probes[i].number)); // each time: the language may be another one
        if (probes[i].samples.empty())
            continue;
        const ProbeSample& now = probes[i].samples.back();
        row->setText(1, reading(now.displacement, Quantity::Length));
        row->setText(2, reading(now.strain, Quantity::Number));
        row->setText(3, reading(now.stress, Quantity::Pressure));
    }
    const QuantityLook& look = quantityLooks()[static_cast<std::size_t>(quantity())];
    m_plot->show(std::move(lines), look.quantity, tr(look.title));
}

PlotLine ProbePanel::lineOf(const Probe& probe) const
{
    const QuantityLook& look = quantityLooks()[static_cast<std::size_t>(quantity())];
    const bool isForce = quantity() == ProbeQuantity::force;
    PlotLine line{isForce ? tr("All tools") : tr("Probe %1").arg(probe.number),
                  probe.color,
                  {},
                  static_cast<std::uint64_t>(probe.number)};
    line.points.reserve(probe.samples.size());
    for (const ProbeSample& sample : probe.samples)
        line.points.emplace_back(sample.time, sample.*look.value);
    return line;
}

void ProbePanel::removeSelected()
{
    std::vector<int> rows;
    for (QTreeWidgetItem* row : m_list->selectedItems())
        rows.push_back(m_list->indexOfTopLevelItem(row));
    if (rows.empty())
        return m_probes.clear();
    std::sort(rows.rbegin(), rows.rend());
    for (const int row : rows)
        m_probes.remove(static_cast<std::size_t>(row));
}

void ProbePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        sayWhatToDo();
        showReadings();
    }
}

void ProbePanel::sayWhatToDo()
{
    m_plot->setHint(
        tr("No probes yet. Place one on the part: it goes along with the material and plots what it reads, also of "
           "what was simulated before."));
}

void ProbePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_soon->start();
}

} // namespace knead
