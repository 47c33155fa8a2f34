#include "ui/exporting/export_feature.h"

#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/format_filters.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/panels/export_panel.h"
#include "ui/selection/selection_model.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QRegularExpression>

#include <memory>

namespace knead {

ExportFeature::ExportFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_action(makeAction(bench.window, {"export", QT_TRANSLATE_NOOP("Actions", "&Export..."), "export", "Ctrl+E",
                                         QT_TRANSLATE_NOOP("Actions", "Write the deformed part to a file")}))
    , m_panel(new ExportPanel(&bench.window))
{
    bench.docks.add("exportDock", tr("Export report"), m_panel);
    bench.availability.needBodies({m_action});
    connect(m_action, &QAction::triggered, this, &ExportFeature::askForExport);
    connect(m_panel, &ExportPanel::placeWanted, this, &ExportFeature::placeWanted);
    connect(&m_bench.document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model && m_bench.document.content().model != m_exported)
            m_panel->forgetPlaces(); // they were in another part
    });
}

void ExportFeature::askForExport()
{
    if (m_bench.document.isEmpty())
        return;
    constexpr int mostNames = 3;
    QStringList names;
    if (const Region& region = m_bench.document.selected().region(); region.level == Level::Part)
        for (const auto& [body, items] : region.items)
            names << m_bench.document.nameOfBody(body);
    if (names.size() > mostNames)
        names = names.mid(0, mostNames) << QStringLiteral("\u2026");
    auto* dialog = new ExportDialog(names.join(QStringLiteral(", ")), !m_bench.viewport.options().hiddenParts.empty(),
                                    &m_bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { askForPlace(dialog->request(), dialog->format()); });
    dialog->open();
}

void ExportFeature::askForPlace(const ExportRequest& request, const FileFormat& format)
{
    const QString ending = QString::fromStdString(format.endings.front());
    const FileQuestion question{.name = "exportFileDialog",
                                .title = request.onePerPart ? tr("Export a file for each part")
                                                            : tr("Export the deformed parts"),
                                .filters = {filterOf(format)},
                                .key = "exportFolder",
                                .file = m_bench.nameForFile("-deformed." + ending)};
    askForFileToWrite(m_bench.window, question, [this, request](const QString& path) { exportTo(path, request); });
}

void ExportFeature::exportTo(const QString& path, const ExportRequest& request)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    const auto files =
        std::make_shared<const std::vector<PlannedFile>>(planFiles(path, request)); // large, and copied with `work`
    const auto work = [services = m_bench.services, files, keepsReport = request.keepsReport](TaskControl& control) {
        std::vector<ExportReport> reports;
        const auto count = static_cast<double>(files->size());
        for (const PlannedFile& file : *files) {
            const auto done = static_cast<double>(reports.size());
            TaskPortion portion(control, done / count, (done + 1) / count);
            reports.push_back(services.exportParts(file.path, file.job, keepsReport, portion));
        }
        return reports;
    };
    m_bench.tasks.run<std::vector<ExportReport>>(
        said(Message("ExportFeature", "Exporting %1").with(QFileInfo(path).fileName().toStdString())), work,
        [this](const std::vector<ExportReport>& reports) { showExport(reports); });
}

/// One file, or one for each part in a folder of their own.
std::vector<ExportFeature::PlannedFile> ExportFeature::planFiles(const QString& path,
                                                                 const ExportRequest& request) const
{
    const Model& model = *m_bench.document.content().model;
    const std::vector<bool> keep = partsFor(request.which);
    const auto planned = [&](const QString& file, const std::vector<bool>& parts) {
        PlannedFile one{QFile::encodeName(file).toStdString(), m_bench.document.exportJob(parts)};
        const std::string unit = request.options.unit.empty() ? one.job.options.unit : request.options.unit;
        one.job.options = request.options;
        one.job.options.unit = unit;
        return one;
    };
    std::vector<PlannedFile> files;
    if (!request.onePerPart) {
        files.push_back(planned(path, keep));
        return files;
    }
    const QFileInfo info(path);
    QStringList used;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (!keep[p])
            continue;
        static const QRegularExpression unwanted("[/\\\\:*?\"<>|\\x00-\\x1f]");
        const QString name = m_bench.document.nameOfPart(p).replace(unwanted, "_").left(100);
        const QString stem = info.completeBaseName() + "-" + name;
        QString unique = stem;
        for (int number = 2; used.contains(unique); ++number)
            unique = QStringLiteral("%1-%2").arg(stem).arg(number);
        used << unique;
        std::vector<bool> only(model.parts.size(), false);
        only[p] = true;
        files.push_back(planned(info.dir().filePath(unique + "." + info.suffix()), only));
    }
    return files;
}

std::vector<bool> ExportFeature::partsFor(ExportRequest::Which which) const
{
    const FilledModel& content = m_bench.document.content();
    std::vector<bool> keep(content.model->parts.size(), which == ExportRequest::Which::all);
    if (which == ExportRequest::Which::visible)
        for (std::size_t p = 0; p < keep.size(); ++p)
            keep[p] = !m_bench.viewport.options().hiddenParts.contains(p);
    const Region& selected = m_bench.document.selected().region();
    if (which == ExportRequest::Which::selected && selected.level == Level::Part)
        for (const auto& [body, items] : selected.items)
            keep[content.bodies[body]->part] = true;
    return keep;
}

/// Where it is folded or passes through itself, or else the part. Pieces are named after their part.
std::optional<ReportPlace> ExportFeature::placeOf(const PartExportReport& part) const
{
    if (part.fold)
        return ReportPlace::at(*part.fold);
    const std::shared_ptr<const Model>& model = m_bench.document.content().model;
    std::optional<std::size_t> found;
    for (std::size_t p = 0; model && p < model->parts.size(); ++p)
        for (const std::string& name : {model->parts[p].name, m_bench.document.nameOfPart(p).toStdString()})
            if (part.name == name)
                return ReportPlace::ofPart(p);
            else if (!name.empty() && part.name.starts_with(name))
                found = p;
    return found ? std::optional(ReportPlace::ofPart(*found)) : std::nullopt;
}

void ExportFeature::showDeformed(const ExportReport& report)
{
    if (report.parts.empty())
        return; // meshes only
    m_exported = m_bench.document.content().model;
    m_panel->show({report}, [this](const PartExportReport& part) { return placeOf(part); });
    if (report.isSound())
        return;
    m_bench.docks.show("exportDock");
    m_bench.notices.problem(
        tr("The shape that the parts have now is not sound everywhere; the export report says where. Undo goes "
           "back to the parts as they were."));
}

void ExportFeature::showExport(const std::vector<ExportReport>& reports)
{
    m_exported = m_bench.document.content().model;
    m_panel->show(reports, [this](const PartExportReport& part) { return placeOf(part); });
    m_bench.docks.show("exportDock");
    for (const ExportReport& report : reports) {
        m_bench.document.notes().noteExport(report.file, static_cast<double>(QDateTime::currentSecsSinceEpoch()));
        const auto parts = report.parts.size();
        const QString file = QFile::decodeName(report.file.c_str());
        m_bench.notices.note(parts == 1 ? tr("Exported 1 part to %1.").arg(file)
                                        : tr("Exported %2 parts to %1.").arg(file).arg(parts));
        if (!report.isSound())
            m_bench.notices.problem(
                said(Message("ExportFeature", "Not everything in %1 is sound; the export report says what is not.")
                         .with(QFileInfo(QFile::decodeName(report.file.c_str())).fileName().toStdString())));
    }
}

} // namespace knead
