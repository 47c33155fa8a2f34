#include "ui/panels/export_panel.h"

#include "core/message/message.h"
#include "ui/language/said.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

QString changed(int before, int after)
{
    return before == after ? formatCount(static_cast<std::size_t>(after))
                           : QStringLiteral("%1 → %2").arg(formatCount(static_cast<std::size_t>(before)),
                                                           formatCount(static_cast<std::size_t>(after)));
}

QString shortLength(double metres)
{
    constexpr double rounding = 1e-12; // [m], of places as far off as parts are large
    return formatReading(metres < rounding ? 0 : metres, Quantity::Length);
}

QString formOf(const PartExportReport& part)
{
    switch (part.form) {
    case PartExportReport::Form::exact:
        return part.flatFaces == 0 ? ExportPanel::tr("smooth faces")
                                   : ExportPanel::tr("smooth faces, %1 flat").arg(part.flatFaces);
    case PartExportReport::Form::faceted:
        return ExportPanel::tr("flat triangles");
    case PartExportReport::Form::mesh:
        return ExportPanel::tr("mesh");
    }
    return {};
}

QString verdictOf(const PartExportReport& part)
{
    if (!part.valid)
        return ExportPanel::tr("does not pass the geometry checks");
    if (part.wasClosed && (!part.closed || part.freeEdges > 0))
        return ExportPanel::tr("not closed");
    if (std::abs(part.volumeError()) > largestVolumeError)
        return ExportPanel::tr("its volume is off");
    if ((part.largestDeviation > part.tolerance && part.samples > 0) || part.largestFlatDeviation > part.flatTolerance)
        return ExportPanel::tr("further from the material than asked for");
    if (part.crossesItself)
        return ExportPanel::tr("passes through itself");
    if (part.largestKink > largestKinkOfSoundParts)
        return ExportPanel::tr("not smooth where it was");
    return part.closed ? ExportPanel::tr("closed and valid") : ExportPanel::tr("valid, open as it was");
}

QTreeWidgetItem* rowOf(const PartExportReport& part)
{
    const bool isMesh = part.form == PartExportReport::Form::mesh;
    auto* row = new QTreeWidgetItem;
    row->setIcon(0, icon(part.isSound() ? "part" : "warning"));
    row->setText(0, QString::fromStdString(part.name));
    row->setText(1, verdictOf(part));
    row->setText(2, formOf(part));
    row->setText(3, changed(part.solidsBefore, part.solidsAfter));
    row->setText(4, isMesh ? formatCount(static_cast<std::size_t>(part.facesAfter))
                           : changed(part.facesBefore, part.facesAfter));
    row->setText(
        5,
        part.samples == 0
            ? QString()
            : ExportPanel::tr("%1, mean %2").arg(shortLength(part.largestDeviation), shortLength(part.meanDeviation)));
    row->setText(6, QStringLiteral("%1 (%2)").arg(formatQuantity(part.volume, Quantity::Volume),
                                                  formatChange(part.volumeChange())));
    row->setText(7, part.density > 0 ? formatQuantity(part.density * part.volume, Quantity::Mass) : QString());
    QStringList remarks;
    if (!part.reason.empty())
        remarks << ExportPanel::tr("Not as smooth faces: %1").arg(said(part.reason));
    for (const Message& remark : part.remarks)
        remarks << said(remark);
    if (!part.nameKept)
        remarks << ExportPanel::tr("Its name was not found again.");
    if (!part.colorsKept)
        remarks << ExportPanel::tr("Not all of its colors were found again.");
    for (const QString& remark : remarks)
        row->addChild(new QTreeWidgetItem({remark}));
    return row;
}

/// Sentences go over all columns and break into as many lines as they need.
class SentenceDelegate final : public QStyledItemDelegate {
public:
    explicit SentenceDelegate(QTreeWidget& tree)
        : QStyledItemDelegate(&tree)
        , m_tree(tree)
    {
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        if (!m_tree.isFirstColumnSpanned(index.row(), index.parent()))
            return QStyledItemDelegate::sizeHint(option, index);
        constexpr int padding = 8; // left and right [pixels]
        const int depth = index.parent().isValid() ? 2 : 1;
        const int width = std::max(m_tree.viewport()->width(), m_tree.header()->length());
        QStyleOptionViewItem wide(option);
        wide.rect = QRect(0, 0, width - depth * m_tree.indentation() - padding, 1);
        wide.features |= QStyleOptionViewItem::WrapText;
        return {1, QStyledItemDelegate::sizeHint(wide, index).height()}; // no column is as wide for it
    }

private:
    const QTreeWidget& m_tree;
};

/// Rows are as high as the width of the tree makes them.
class ReportTree final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QTreeWidget::resizeEvent(event);
        scheduleDelayedItemsLayout();
    }
};

} // namespace

ExportPanel::ExportPanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel(tr("Nothing was exported yet."), this))
    , m_parts(new ReportTree(this))
{
    setObjectName("exportPanel");
    m_summary->setObjectName("exportSummary");
    m_parts->setObjectName("exportedParts");
    m_parts->setAccessibleName(tr("Exported parts"));
    m_parts->setFrameShape(QFrame::NoFrame);
    m_parts->setHeaderLabels({tr("Part"), tr("Read back"), tr("As"), tr("Solids"), tr("Faces"),
                              tr("Distance to the material"), tr("Volume (since opened)"), tr("Mass")});
    m_places = new PlaceRows(*m_parts);
    connect(m_places, &PlaceRows::wanted, this, &ExportPanel::placeWanted);
    m_parts->setWordWrap(true);
    m_parts->setItemDelegate(new SentenceDelegate(*m_parts));
    m_parts->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_parts->setRootIsDecorated(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->addWidget(m_summary);
    column->addWidget(m_parts, 1);
    fitColumns();
}

void ExportPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        QTimer::singleShot(0, this, &ExportPanel::fitColumns); // once the titles have it, too
    if (event->type() != QEvent::LanguageChange)
        return;
    if (!m_reports.empty())
        show(std::vector<ExportReport>(m_reports), PlaceOf(m_placeOf));
    fitColumns();
}

/// Titles are seen in full also while there is nothing below them.
void ExportPanel::fitColumns()
{
    for (int column = 0; column < m_parts->columnCount(); ++column)
        m_parts->resizeColumnToContents(column);
}

void ExportPanel::forgetPlaces()
{
    m_placeOf = {};
    for (int row = 0; row < m_parts->topLevelItemCount(); ++row)
        m_places->set(*m_parts->topLevelItem(row), std::nullopt);
}

/// How many of the parts came back as they should.
QString ExportPanel::verdict(std::size_t sound, std::size_t parts)
{
    if (sound == parts)
        return parts == 1 ? tr("The part is sound.") : tr("All parts are sound.");
    if (parts == 1)
        return tr("The part is not sound.");
    return parts - sound == 1 ? tr("One of %1 parts is not sound.").arg(parts)
                              : tr("%1 of %2 parts are not sound.").arg(parts - sound).arg(parts);
}

void ExportPanel::show(const std::vector<ExportReport>& reports, const PlaceOf& placeOf)
{
    m_reports = reports;
    m_placeOf = placeOf;
    m_parts->clear();
    std::uint64_t bytes = 0;
    double seconds = 0;
    std::size_t sound = 0;
    std::size_t parts = 0;
    QStringList warnings;
    for (const ExportReport& report : reports) {
        bytes += report.bytes;
        seconds += report.seconds;
        for (const PartExportReport& part : report.parts) {
            QTreeWidgetItem* row = rowOf(part);
            m_parts->addTopLevelItem(row);
            m_places->set(*row, placeOf ? placeOf(part) : std::nullopt);
            for (int child = 0; child < row->childCount(); ++child)
                row->child(child)->setFirstColumnSpanned(true); // the tree must know it by then
            sound += part.isSound() ? 1 : 0;
            ++parts;
        }
        for (const Message& warning : report.warnings)
            warnings << said(warning);
    }
    for (const QString& warning : warnings) {
        auto* row = new QTreeWidgetItem(m_parts, {warning});
        row->setIcon(0, icon("warning"));
        row->setFirstColumnSpanned(true);
    }
    m_parts->expandAll();
    fitColumns();
    const QString files = reports.size() == 1 ? QFileInfo(QFile::decodeName(reports.front().file.c_str())).fileName()
                                              : tr("%1 files").arg(reports.size());
    m_summary->setText(tr("%1: %2, %3 MB in %4 s. %5")
                           .arg(files, reports.empty() ? QString() : QString::fromStdString(reports.front().format))
                           .arg(localNumber(1e-6 * static_cast<double>(bytes), 'g', 3), localNumber(seconds, 'f', 1))
                           .arg(verdict(sound, parts)));
}

} // namespace knead
