#include "ui/panels/performance_panel.h"

#include "ui/language/said.h"
#include "ui/panels/status_readings.h"
#include "ui/screen_reader.h"
#include "ui/units.h"

#include <QGridLayout>
#include <QLabel>
#include <QPaintEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

constexpr double frameSeconds = 1.0 / 60;
// Readings follow the frames slowly enough to be read.
constexpr double smoothing = 0.15;
constexpr int chipSize = 10;
constexpr int rowsPerColumn = 4;

struct StageLook {
    const char* name;
    const char* tip;
    QColor color;
};

/// In the order of Stage, then the snapshot. Distinct on light and dark ground, and for people who see few colors by their
/// lightness.
const std::array<StageLook, stageCount + 1>& looks()
{
    static const std::array<StageLook, stageCount + 1> all{{
        {QT_TRANSLATE_NOOP("PerformancePanel", "Tools"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Commands and the motion of tools"), "#9aa5b1"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Vicinity"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Finding what may touch"), "#e6a23c"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Material"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Plastic flow, breaking and annealing"), "#d9622b"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Connections"),
         QT_TRANSLATE_NOOP("PerformancePanel",
                           "Forces of structural connections, or the equations of an implicit step"),
         "#3d8bfd"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Contacts"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Forces of contacts, joints and fixtures"), "#2fa56a"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Motion"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Integration of velocities and positions"), "#8b6fd8"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Checks"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Health, the stable step, and states to go back to"), "#c9579b"},
        {QT_TRANSLATE_NOOP("PerformancePanel", "Snapshot"),
         QT_TRANSLATE_NOOP("PerformancePanel", "Handing the state to the window"), "#5fc2c9"},
    }};
    return all;
}

std::string withDecimals(double number, int decimals)
{
    return localNumber(number, 'f', decimals).toStdString();
}

QString milliseconds(double seconds)
{
    return said(Message("PerformancePanel", "%1 ms").with(withDecimals(1e3 * seconds, 2)));
}

QString perStep(double seconds)
{
    return said(
        seconds < 1e-3
            ? Message("PerformancePanel", "%1 µs/step").with(withDecimals(1e6 * seconds, seconds < 1e-5 ? 1 : 0))
            : Message("PerformancePanel", "%1 ms/step").with(withDecimals(1e3 * seconds, 2)));
}

QLabel* dimmed(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setProperty("role", "dimmed");
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return label;
}

} // namespace

/// The stages side by side on the length of a frame. When they need more than a frame, the bar is theirs and a mark shows where
/// the frame would end.
class PerformancePanel::BudgetBar final : public QWidget {
public:
    explicit BudgetBar(QWidget* parent)
        : QWidget(parent)
    {
        setObjectName("frameBudget");
        setFixedHeight(18);
        readAs(*this, QAccessible::Chart, [this] { return spoken(); });
        setAccessibleName(PerformancePanel::tr("Time of a frame"));
        setToolTip(PerformancePanel::tr("Time of a frame; its whole length is a sixtieth of a second"));
    }

    void show(const std::vector<double>& seconds)
    {
        m_seconds = seconds;
        update();
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setPen(Qt::NoPen);
        painter.fillRect(rect(), palette().color(QPalette::Base));
        const double all = std::accumulate(m_seconds.begin(), m_seconds.end(), 0.0);
        const double length = std::max(frameSeconds, all);
        double begin = 0;
        for (std::size_t stage = 0; stage < m_seconds.size(); ++stage) {
            const double end = begin + m_seconds[stage];
            const auto left = static_cast<int>(std::lround(begin / length * width()));
            const auto right = static_cast<int>(std::lround(end / length * width()));
            painter.fillRect(QRect(left, 0, right - left, height()), looks()[stage].color);
            begin = end;
        }
        if (all > frameSeconds) {
            const auto mark = static_cast<int>(std::lround(frameSeconds / length * width()));
            painter.fillRect(QRect(mark - 1, 0, 2, height()), palette().color(QPalette::Text));
        }
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }

private:
    /// For those who do not see it.
    QString spoken() const
    {
        QStringList stages;
        for (std::size_t stage = 0; stage < m_seconds.size(); ++stage)
            stages << PerformancePanel::tr(looks()[stage].name) + ' ' + milliseconds(m_seconds[stage]);
        return stages.join(QStringLiteral(", "));
    }

    std::vector<double> m_seconds;
};

PerformancePanel::PerformancePanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel(this))
    , m_rates(new QLabel(this))
    , m_bar(new BudgetBar(this))
    , m_smooth(looks().size())
{
    setObjectName("performance");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 10, 6);
    column->setSpacing(5);
    auto* lines = new QHBoxLayout;
    m_summary->setObjectName("performanceSummary");
    m_rates->setObjectName("performanceRates");
    m_rates->setProperty("role", "dimmed");
    m_rates->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    lines->addWidget(m_summary, 1);
    lines->addWidget(m_rates);
    column->addLayout(lines);
    column->addWidget(m_bar);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    constexpr int cellsPerRow = 5; // swatch, name, per frame, per step, gap
    for (std::size_t stage = 0; stage < looks().size(); ++stage) {
        const StageLook& look = looks()[stage];
        const int row = static_cast<int>(stage) % rowsPerColumn;
        const int cell = static_cast<int>(stage) / rowsPerColumn * cellsPerRow;
        QPixmap swatch(chipSize, chipSize);
        swatch.fill(look.color);
        auto* color = new QLabel(this);
        color->setPixmap(swatch);
        auto* name = new QLabel(tr(look.name), this);
        name->setToolTip(tr(look.tip));
        m_rows.push_back({dimmed(this), dimmed(this)});
        m_rows.back().frame->setObjectName(QStringLiteral("stage%1").arg(stage));
        m_rows.back().frame->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("000.00 ms")));
        m_rows.back().step->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000 µs/step")));
        grid->addWidget(color, row, cell);
        grid->addWidget(name, row, cell + 1);
        grid->addWidget(m_rows.back().frame, row, cell + 2);
        grid->addWidget(m_rows.back().step, row, cell + 3);
        grid->setColumnMinimumWidth(cell + 4, 24);
    }
    grid->setColumnStretch(2 * cellsPerRow, 1);
    column->addLayout(grid);
    column->addStretch(1);
    clear();
}

void PerformancePanel::clear()
{
    m_smooth.assign(looks().size(), 0.0);
    m_bar->show({});
    m_rates->clear();
    m_summary->setText(tr("Open a part and press play to see where the time goes."));
    for (const Row& row : m_rows) {
        row.frame->clear();
        row.step->clear();
    }
}

void PerformancePanel::show(const Snapshot& snapshot)
{
    if (!snapshot.playing)
        return; // the last readings stay, to be read at leisure
    std::vector<double> seconds(snapshot.stages.begin(), snapshot.stages.end());
    for (double& stage : seconds)
        stage *= snapshot.stepsPerFrame;
    seconds.push_back(snapshot.snapshotSeconds);
    const bool isFirst = std::accumulate(m_smooth.begin(), m_smooth.end(), 0.0) == 0;
    for (std::size_t stage = 0; stage < seconds.size(); ++stage)
        m_smooth[stage] += (isFirst ? 1 : smoothing) * (seconds[stage] - m_smooth[stage]);
    if (isVisible())
        showStages(snapshot);
}

void PerformancePanel::showStages(const Snapshot& snapshot)
{
    m_bar->show(m_smooth);
    const double stepping = std::accumulate(m_smooth.begin(), m_smooth.end() - 1, 0.0);
    const int steps = std::max(snapshot.stepsPerFrame, 1);
    m_summary->setText(
        said((steps == 1 ? Message("PerformancePanel", "%1, %2 step of %3 per frame")
                         : Message("PerformancePanel", "%1, %2 steps of %3 per frame"))
                 .with(ratioWords(snapshot.ratio), formatCount(static_cast<std::size_t>(steps)).toStdString(),
                       formatReading(snapshot.timeStep, Quantity::Time).toStdString())));
    if (snapshot.solverIterations > 0)
        m_rates->setText(said(Message("PerformancePanel", "%1 iterations of the solver in the last step, %2 objects")
                                  .with(snapshot.solverIterations, formatCount(snapshot.objects).toStdString())));
    else if (stepping > 0)
        m_rates->setText(
            said(Message("PerformancePanel", "%1 million connections per second, %2 objects")
                     .with(withDecimals(1e-6 * static_cast<double>(snapshot.connections) * steps / stepping, 0),
                           formatCount(snapshot.objects).toStdString())));
    for (std::size_t stage = 0; stage < m_rows.size(); ++stage) {
        m_rows[stage].frame->setText(milliseconds(m_smooth[stage]));
        m_rows[stage].step->setText(stage < stageCount ? perStep(m_smooth[stage] / steps) : QString());
    }
}

} // namespace knead
