#include "ui/panels/export_panel.h"

#include "ui/theme.h"
#include "ui/units.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>

namespace knead {

namespace {

QString text(const std::string& sentence)
{
    return QString::fromStdString(sentence);
}

QString changed(int before, int after)
{
    return before == after ? formatCount(static_cast<std::size_t>(after))
                           : QStringLiteral("%1 → %2").arg(formatCount(static_cast<std::size_t>(before)),
                                                           formatCount(static_cast<std::size_t>(after)));
}

QString shortLength(double metres)
{
    constexpr double rounding = 1e-12; // [m], of places as far off as parts are large
    return QStringLiteral("%1 mm").arg(metres < rounding ? 0 : 1e3 * metres, 0, 'g', 2);
}

QString formOf(const PartExportReport& part)
{
    switch (part.form) {
    case PartExportReport::Form::exact:
        return ExportPanel::tr("smooth faces");
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
    if (part.largestDeviation > part.tolerance && part.samples > 0)
        return ExportPanel::tr("further from the material than asked for");
    return part.closed ? ExportPanel::tr("closed and valid") : ExportPanel::tr("valid, open as it was");
}

QTreeWidgetItem* rowOf(const PartExportReport& part)
{
    const bool isMesh = part.form == PartExportReport::Form::mesh;
    auto* row = new QTreeWidgetItem;
    row->setIcon(0, icon(part.isSound() ? "part" : "warning"));
    row->setText(0, text(part.name));
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
    row->setText(6, QStringLiteral("%1 cm³ (%2 %)")
                        .arg(1e6 * part.volume, 0, 'g', 6)
                        .arg(100 * (part.restVolume > 0 ? part.volume / part.restVolume - 1 : 0), 0, 'f', 2));
    row->setText(7, part.density > 0 ? QStringLiteral("%1 g").arg(1e3 * part.density * part.volume, 0, 'g', 5)
                                     : QString());
    QStringList remarks;
    if (!part.reason.empty())
        remarks << ExportPanel::tr("Not as smooth faces: %1").arg(text(part.reason));
    for (const std::string& remark : part.remarks)
        remarks << text(remark);
    if (!part.nameKept)
        remarks << ExportPanel::tr("Its name was not found again.");
    if (!part.colorsKept)
        remarks << ExportPanel::tr("Not all of its colors were found again.");
    for (const QString& remark : remarks)
        row->addChild(new QTreeWidgetItem({remark}));
    return row;
}

} // namespace

ExportPanel::ExportPanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel(tr("Nothing was exported yet."), this))
    , m_parts(new QTreeWidget(this))
{
    setObjectName("exportPanel");
    m_summary->setObjectName("exportSummary");
    m_parts->setObjectName("exportedParts");
    m_parts->setFrameShape(QFrame::NoFrame);
    m_parts->setHeaderLabels({tr("Part"), tr("Read back"), tr("As"), tr("Solids"), tr("Faces"),
                              tr("Distance to the material"), tr("Volume (since opened)"), tr("Mass")});
    m_parts->setUniformRowHeights(true);
    m_parts->setRootIsDecorated(true);
    m_parts->header()->setStretchLastSection(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->addWidget(m_summary);
    column->addWidget(m_parts, 1);
}

void ExportPanel::show(const std::vector<ExportReport>& reports)
{
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
            for (int child = 0; child < row->childCount(); ++child)
                row->child(child)->setFirstColumnSpanned(true); // the tree must know it by then
            sound += part.isSound() ? 1 : 0;
            ++parts;
        }
        for (const std::string& warning : report.warnings)
            warnings << text(warning);
    }
    for (const QString& warning : warnings) {
        auto* row = new QTreeWidgetItem(m_parts, {warning});
        row->setIcon(0, icon("warning"));
        row->setFirstColumnSpanned(true);
    }
    m_parts->expandAll();
    for (int column = 0; column < m_parts->columnCount(); ++column)
        m_parts->resizeColumnToContents(column);
    const QString files = reports.size() == 1 ? QFileInfo(QFile::decodeName(reports.front().file.c_str())).fileName()
                                              : tr("%1 files").arg(reports.size());
    m_summary->setText(tr("%1: %2, %3 MB in %4 s. %5")
                           .arg(files, reports.empty() ? QString() : text(reports.front().format))
                           .arg(1e-6 * static_cast<double>(bytes), 0, 'g', 3)
                           .arg(seconds, 0, 'f', 1)
                           .arg(sound == parts ? tr("All parts are sound.")
                                               : tr("%1 of %2 parts are not sound.").arg(parts - sound).arg(parts)));
}

} // namespace knead
