#include "ui/dialogs/comparison_dialog.h"

#include "ui/theme.h"
#include "ui/units.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int comparisonWidth = 860; // at least; as wide as its columns [pixels]
constexpr int comparedHeight = 360;  // of its height at the start; more parts are scrolled to [pixels]

QString lengthText(double length)
{
    return formatReading(length, Quantity::Length);
}

QTreeWidgetItem* rowOf(const BodyComparison& body)
{
    auto* row = new QTreeWidgetItem(
        {QString::fromStdString(body.name), lengthText(body.largestDistance), lengthText(body.meanDistance),
         lengthText(body.largestDisplacement), formatQuantity(body.rest.volume, Quantity::Volume),
         formatQuantity(body.now.volume, Quantity::Volume), formatChange(body.now.volume / body.rest.volume - 1),
         formatQuantity(body.now.mass, Quantity::Mass)});
    row->setIcon(0, icon("part"));
    for (int column = 1; column < row->columnCount(); ++column)
        row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    return row;
}

} // namespace

ComparisonDialog::ComparisonDialog(const Comparison& comparison, QWidget* parent)
    : ModelessDialog(parent)
{
    setObjectName("comparisonDialog");
    setWindowTitle(tr("Compare with original"));
    auto* intro =
        new QLabel(tr("How far the skin is from the nearest point of the original surface, at %1 of simulated "
                      "time. The mean is by area.")
                       .arg(formatReading(comparison.time, Quantity::Time)),
                   this);
    intro->setWordWrap(true);
    auto* table = new QTreeWidget(this);
    table->setObjectName("comparison");
    table->setRootIsDecorated(false);
    table->setHeaderLabels({tr("Part"), tr("Largest distance"), tr("Mean distance"), tr("Largest displacement"),
                            tr("Volume at rest"), tr("Volume now"), tr("Change"), tr("Mass")});
    for (int column = 1; column < table->columnCount(); ++column) // over their numbers
        table->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    auto* places = new PlaceRows(*table);
    connect(places, &PlaceRows::wanted, this, &ComparisonDialog::placeWanted);
    for (const BodyComparison& body : comparison.bodies) {
        QTreeWidgetItem* row = rowOf(body);
        table->addTopLevelItem(row);
        if (body.largestDistance > 0)
            places->set(*row, ReportPlace::at(body.farthest));
    }
    for (int column = 0; column < table->columnCount(); ++column)
        table->resizeColumnToContents(column);
    table->setAllColumnsShowFocus(true);
    table->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* report = buttons->addButton(tr("Write report..."), QDialogButtonBox::ActionRole);
    report->setObjectName("writeReport");
    setRole(*report, "primary");
    report->setToolTip(tr("A page with these numbers, what was measured and a picture of the view, as PDF or HTML"));
    connect(report, &QPushButton::clicked, this, &ComparisonDialog::reportWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(intro);
    column->addWidget(table, 1);
    column->addWidget(buttons);
    report->setFocus();
    const QMargins rim = column->contentsMargins();
    const int room =
        table->header()->length() + 2 * table->frameWidth() + table->verticalScrollBar()->sizeHint().width();
    const int width = std::max(comparisonWidth, room + rim.left() + rim.right());
    const int others = column->totalHeightForWidth(width) - table->sizeHint().height();
    resize(width, others + std::min(table->sizeHint().height(), comparedHeight));
}

} // namespace knead
