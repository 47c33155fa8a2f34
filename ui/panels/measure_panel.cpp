#include "ui/panels/measure_panel.h"

#include "ui/language/said.h"
#include "ui/measuring/measurement_words.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace knead {

namespace {

enum MeasureColumn { nameColumn, nowColumn, restColumn, changeColumn, measureColumns };

/// "+1.25 mm"; nothing where rounding is all there is.
QString changeText(const Reading& reading)
{
    const double change = reading.now - reading.rest;
    constexpr double rounding = 1e-9;
    const double least = reading.quantity == Quantity::Length ? 5e-9 : 0; // [m]
    if (std::abs(change) <= std::max(least, rounding * std::max(std::abs(reading.now), std::abs(reading.rest))))
        return QStringLiteral("–");
    const QString text = formatReading(change, reading.quantity);
    const bool hasShare = reading.quantity == Quantity::Volume && reading.rest != 0;
    const QString share =
        hasShare ? QStringLiteral(" (%1 %)").arg(localNumber(QString::asprintf("%+.2f", 100 * change / reading.rest)))
                 : QString();
    return (change > 0 ? "+" + text : text) + share;
}

/// A tree with keys of its own, whatever the window uses them for.
class KeyTree final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;
    std::function<void()> copy;
    std::function<void()> remove;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride && action(static_cast<QKeyEvent*>(event)) != nullptr) {
            event->accept();
            return true;
        }
        return QTreeWidget::event(event);
    }

    void keyPressEvent(QKeyEvent* event) override
    {
        if (const auto* wanted = action(event))
            (*wanted)();
        else
            QTreeWidget::keyPressEvent(event);
    }

private:
    const std::function<void()>* action(QKeyEvent* event) const
    {
        if (event->matches(QKeySequence::Copy))
            return &copy;
        return event->matches(QKeySequence::Delete) ? &remove : nullptr;
    }
};

/// Whether the first reading is the measurement, and the others say more about it; else all are alike.
bool hasMain(MeasureKind kind)
{
    return kind != MeasureKind::point && kind != MeasureKind::box && kind != MeasureKind::mass;
}

/// All that the view shows of a measurement; nothing where it is not to be seen.
std::optional<ReportPlace> placeOf(const Measured& result)
{
    ReportPlace place;
    for (const Vec3& point : result.mark.points)
        place.box.extend(point);
    for (const std::vector<Vec3>& line : result.mark.lines)
        for (const Vec3& point : line)
            place.box.extend(point);
    return place.box.isEmpty() || result.readings.empty() ? std::nullopt : std::optional(place);
}

void fill(QTreeWidgetItem* row, const Reading& reading)
{
    row->setText(nowColumn, formatQuantity(reading.now, reading.quantity));
    row->setText(restColumn, formatQuantity(reading.rest, reading.quantity));
    row->setText(changeColumn, changeText(reading));
}

} // namespace

MeasurePanel::MeasurePanel(MeasurementList& list, const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent)
    , m_list(list)
    , m_tree(new KeyTree(this))
    , m_hint(new QLabel(
          tr("Nothing is measured yet. Choose what to measure above, then click on the part; corners attract. "
             "Numbers follow the material while time runs."),
          this))
{
    setObjectName("measurePanel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    makeButtons(actions);
    m_hint->setProperty("role", "dimmed");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_hint->setMargin(8);
    makeTree();
    column->addWidget(m_hint, 1);
    column->addWidget(m_tree, 1);
    showState();
}

void MeasurePanel::makeButtons(const QList<QAction*>& actions)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        row->addWidget(button);
    }
    row->addStretch(1);
    auto* compare = makeButton("measureCompare", "compare-two", tr("Compare..."),
                               tr("Compare the parts with their original shape, and write a report"));
    m_copy = makeButton("measureCopy", "copy", tr("Copy"), tr("Copy the table (Ctrl+C)"));
    m_csv = makeButton("measureCsv", "export", tr("CSV..."), tr("Write the table to a file, units in its columns"));
    m_delete = makeButton("measureDelete", "delete", {}, tr("Delete the selected measurements, or all (Del)"));
    for (QToolButton* button : {compare, m_copy, m_csv, m_delete})
        row->addWidget(button);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
    connect(compare, &QToolButton::clicked, this, &MeasurePanel::comparisonWanted);
    connect(m_copy, &QToolButton::clicked, this, &MeasurePanel::copy);
    connect(m_csv, &QToolButton::clicked, this, &MeasurePanel::csvWanted);
    connect(m_delete, &QToolButton::clicked, this, &MeasurePanel::removeSelected);
}

QToolButton* MeasurePanel::makeButton(const char* name, const char* picture, const QString& text, const QString& tip)
{
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setIcon(icon(picture));
    button->setText(text);
    button->setToolTip(tip);
    if (text.isEmpty())
        button->setAccessibleName(tip);
    button->setAutoRaise(true);
    button->setToolButtonStyle(text.isEmpty() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
    return button;
}

void MeasurePanel::makeTree()
{
    m_tree->setObjectName("measurements");
    m_tree->setAccessibleName(tr("Measurements"));
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setHeaderLabels({tr("Measurement"), tr("Now"), tr("At rest"), tr("Change")});
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setUniformRowHeights(true);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->setDefaultSectionSize(130);
    m_tree->setColumnWidth(nameColumn, 190);
    m_places = new PlaceRows(*m_tree);
    connect(m_places, &PlaceRows::wanted, this, &MeasurePanel::placeWanted);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &MeasurePanel::selectionChanged);
    auto* keys = static_cast<KeyTree*>(m_tree);
    keys->copy = [this] { copy(); };
    keys->remove = [this] { removeSelected(); };
}

void MeasurePanel::show(const std::vector<Measured>& results)
{
    m_results = results;
    std::vector<std::size_t> shape;
    for (std::size_t i = 0; i < results.size(); ++i) {
        shape.push_back(static_cast<std::size_t>(m_list.all()[i].kind) << 8U | results[i].readings.size());
        shape.push_back(static_cast<std::size_t>(m_list.all()[i].number));
    }
    if (shape != m_shape)
        makeRows();
    m_shape = shape;
    showNames();
    showNumbers();
    showState();
}

/// A measurement with several readings has them below it.
void MeasurePanel::makeRows()
{
    m_tree->clear();
    for (std::size_t i = 0; i < m_results.size(); ++i) {
        const Measurement& measurement = m_list.all()[i];
        auto* row = new QTreeWidgetItem(m_tree);
        row->setIcon(nameColumn, icon(lookOf(measurement.kind).icon));
        for (std::size_t r = hasMain(measurement.kind) ? 1 : 0; r < m_results[i].readings.size(); ++r)
            new QTreeWidgetItem(row);
        row->setExpanded(!hasMain(measurement.kind));
    }
}

/// Each time, since the language may be another one.
void MeasurePanel::showNames()
{
    for (std::size_t i = 0; i < m_results.size(); ++i) {
        QTreeWidgetItem* row = m_tree->topLevelItem(static_cast<int>(i));
        row->setText(nameColumn, nameOf(m_list.all()[i]));
        const int first = hasMain(m_list.all()[i].kind) ? 1 : 0;
        for (int child = 0; child < row->childCount(); ++child)
            row->child(child)->setText(nameColumn,
                                       said(m_results[i].readings[static_cast<std::size_t>(first + child)].name));
    }
}

void MeasurePanel::showNumbers()
{
    for (std::size_t i = 0; i < m_results.size(); ++i) {
        const Measured& result = m_results[i];
        QTreeWidgetItem* row = m_tree->topLevelItem(static_cast<int>(i));
        if (result.readings.empty()) {
            row->setText(nowColumn, tr("none"));
        } else {
            const bool isMain = hasMain(m_list.all()[i].kind);
            if (isMain)
                fill(row, result.readings.front());
            for (int child = 0; child < row->childCount(); ++child)
                fill(row->child(child), result.readings[static_cast<std::size_t>(child) + (isMain ? 1 : 0)]);
        }
        m_places->set(*row, placeOf(result));
        const QString remark = remarkOn(result);
        if (row->toolTip(nowColumn).isEmpty() != remark.isEmpty())
            row->setIcon(nowColumn, remark.isEmpty() ? QIcon() : icon("warning"));
        for (int c = 0; c < measureColumns; ++c)
            row->setToolTip(c, remark);
    }
}

void MeasurePanel::showState()
{
    const bool hasAny = !m_results.empty();
    m_tree->setVisible(hasAny);
    m_hint->setVisible(!hasAny);
    for (QToolButton* button : {m_copy, m_csv, m_delete})
        button->setEnabled(hasAny);
}

std::vector<std::size_t> MeasurePanel::selected() const
{
    std::set<std::size_t> indices;
    for (QTreeWidgetItem* row : m_tree->selectedItems()) {
        QTreeWidgetItem* top = row->parent() != nullptr ? row->parent() : row;
        indices.insert(static_cast<std::size_t>(m_tree->indexOfTopLevelItem(top)));
    }
    return {indices.begin(), indices.end()};
}

/// As text with tabs, which spreadsheets and mails take: the selected ones, or all.
void MeasurePanel::copy()
{
    std::vector<std::size_t> wanted = selected();
    if (wanted.empty())
        for (std::size_t i = 0; i < m_results.size(); ++i)
            wanted.push_back(i);
    QString text =
        QStringList{tr("Measurement"), tr("Reading"), tr("Now"), tr("At rest"), tr("Change")}.join('\t') + '\n';
    for (const std::size_t i : wanted)
        for (const Reading& reading : m_results[i].readings)
            text +=
                QStringList{nameOf(m_list.all()[i]), said(reading.name), formatQuantity(reading.now, reading.quantity),
                            formatQuantity(reading.rest, reading.quantity), changeText(reading)}
                    .join('\t') +
                '\n';
    QApplication::clipboard()->setText(text);
}

void MeasurePanel::removeSelected()
{
    std::vector<std::size_t> wanted = selected();
    if (wanted.empty())
        return m_list.clear();
    std::reverse(wanted.begin(), wanted.end());
    for (const std::size_t index : wanted)
        m_list.remove(index);
}

} // namespace knead
