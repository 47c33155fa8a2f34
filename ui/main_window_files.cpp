// How files come into the main window and leave it: opening with and without choices, the import report, drops, export.
#include "ui/main_window.h"

#include "core/model/length_units.h"
#include "ui/language/words_of_files.h"
#include "ui/panels/banner.h"
#include "ui/panels/export_panel.h"
#include "ui/panels/home_page.h"
#include "ui/panels/import_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/selection/selection_model.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QRegularExpression>

#include <algorithm>

namespace knead {

namespace {

constexpr qint64 largeFile = 4'000'000; // [bytes]; reading takes seconds, so that a person should choose first
constexpr const char* defaultMaterial = "sponge-rubber";

Material startMaterial(const std::vector<MaterialPreset>& presets)
{
    const auto found = std::find_if(presets.begin(), presets.end(),
                                    [](const MaterialPreset& preset) { return preset.id == defaultMaterial; });
    return found == presets.end() ? Material{} : found->material;
}

} // namespace

void MainWindow::open(const QStringList& paths)
{
    if (openedAsProject(paths) || openedAsRecipe(paths))
        return;
    ImportChoices request;
    const Preferences wanted = readPreferences();
    request.options.relativeDeflection = wanted.detail;
    request.options.timeLimit = 60.0 * wanted.importMinutes;
    request.options.memoryLimit = (1U << 30U) * static_cast<double>(wanted.importGibibytes);
    qint64 size = 0;
    for (const QString& path : paths) {
        request.paths.push_back(QFile::encodeName(path).toStdString());
        size += QFileInfo(path).size();
    }
    if (size >= largeFile)
        openWithChoices(paths);
    else
        open(request);
}

void MainWindow::openWithChoices(const QStringList& paths)
{
    if (paths.empty() || isBusy())
        return;
    m_banner->hide();
    const auto work = [services = m_services, paths](TaskControl& control) {
        std::vector<FilePreview> previews;
        for (const QString& path : paths) {
            const double count = static_cast<double>(paths.size());
            TaskPortion portion(control, static_cast<double>(previews.size()) / count,
                                static_cast<double>(previews.size() + 1) / count);
            previews.push_back(services.preview(QFile::encodeName(path).toStdString(), portion));
        }
        return previews;
    };
    m_tasks.run<std::vector<FilePreview>>(
        tr("Looking into %1").arg(QFileInfo(paths.front()).fileName()), work,
        [this](std::vector<FilePreview> previews) { askForChoices(std::move(previews)); });
}

void MainWindow::open(const ImportChoices& request)
{
    if (request.paths.empty() || isBusy())
        return;
    m_banner->hide();
    const auto work = [services = m_services, request, material = startMaterial(m_services.materials)](
                          TaskControl& control) { return prepareFiles(services, request, material, control); };
    const QString name = QFileInfo(QFile::decodeName(request.paths.front().c_str())).fileName();
    const auto others = static_cast<int>(request.paths.size()) - 1;
    m_tasks.run<PreparedContent>(others == 0 ? tr("Opening %1").arg(name)
                                             : tr("Opening %1 and %n more", nullptr, others).arg(name),
                                 work, [this](PreparedContent prepared) { openPrepared(std::move(prepared)); });
}

void MainWindow::refill(double spacing)
{
    if (m_document.isEmpty() || isBusy())
        return;
    m_banner->hide();
    startRefill(spacing);
}

void MainWindow::startRefill(double spacing)
{
    const auto work = [before = m_document.content(), spacing, now = m_document.frame()->snapshot,
                       fixtures = m_document.fixtures().list()](TaskControl& control) {
        return prepareRefill(before, spacing, *now, fixtures, control);
    };
    const auto finish = [this, spacing, edits = m_document.edits(),
                         isSeen = m_document.showsEdits()](PreparedContent prepared) {
        if (isSeen && m_document.edits() == edits && !m_document.isGoing())
            showRefilled(std::move(prepared));
        else
            QTimer::singleShot(0, this, [this, spacing] { refillOnceMore(spacing); });
    };
    m_tasks.run<PreparedContent>(tr("Filling with a spacing of %1").arg(formatQuantity(spacing, Quantity::Length)),
                                 work, finish);
}

/// With what was done meanwhile, as soon as no hand holds anything any more.
void MainWindow::refillOnceMore(double spacing)
{
    constexpr int untilNextLook = 100; // [ms]
    if (m_document.isInGesture())
        QTimer::singleShot(untilNextLook, this, [this, spacing] { refillOnceMore(spacing); });
    else
        m_document.whenSettled([this, spacing] {
            if (!m_document.isEmpty() && !isBusy())
                startRefill(spacing);
        });
}

/// A part that does not suit the spacing, unlike the others, is only shown from now on.
void MainWindow::showRefilled(PreparedContent prepared)
{
    const std::map<std::size_t, std::string> before = m_document.content().unfilled;
    m_document.refill(std::move(prepared));
    for (const auto& [part, reason] : m_document.content().unfilled)
        if (!before.contains(part))
            showProblem(tr("\"%1\" is not simulated: %2").arg(m_document.nameOfPart(part), inWords(reason)));
}

void MainWindow::exportTo(const QString& path, const ExportRequest& request)
{
    if (m_document.isEmpty() || isBusy())
        return;
    const auto files =
        std::make_shared<const std::vector<PlannedFile>>(planFiles(path, request)); // large, and copied with `work`
    const auto work = [services = m_services, files, keepsReport = request.keepsReport](TaskControl& control) {
        std::vector<ExportReport> reports;
        const auto count = static_cast<double>(files->size());
        for (const PlannedFile& file : *files) {
            const auto done = static_cast<double>(reports.size());
            TaskPortion portion(control, done / count, (done + 1) / count);
            reports.push_back(services.exportParts(file.path, file.job, keepsReport, portion));
        }
        return reports;
    };
    m_tasks.run<std::vector<ExportReport>>(tr("Exporting %1").arg(QFileInfo(path).fileName()), work,
                                           [this](const std::vector<ExportReport>& reports) { showExport(reports); });
}

/// One file, or one for each part in a folder of their own.
std::vector<MainWindow::PlannedFile> MainWindow::planFiles(const QString& path, const ExportRequest& request) const
{
    const Model& model = *m_document.content().model;
    const std::vector<bool> keep = partsFor(request.which);
    const auto planned = [&](const QString& file, const std::vector<bool>& parts) {
        PlannedFile one{QFile::encodeName(file).toStdString(), m_document.exportJob(parts)};
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
        const QString name = m_document.nameOfPart(p).replace(unwanted, "_").left(100);
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

std::vector<bool> MainWindow::partsFor(ExportRequest::Which which) const
{
    const Content& content = m_document.content();
    std::vector<bool> keep(content.model->parts.size(), which == ExportRequest::Which::all);
    if (which == ExportRequest::Which::visible)
        for (std::size_t p = 0; p < keep.size(); ++p)
            keep[p] = !m_viewport->options().hiddenParts.contains(p);
    const Region& selected = m_document.selected().region();
    if (which == ExportRequest::Which::selected && selected.level == Level::Part)
        for (const auto& [body, items] : selected.items)
            keep[content.bodies[body]->part] = true;
    return keep;
}

void MainWindow::showExport(const std::vector<ExportReport>& reports)
{
    m_export->show(reports);
    auto* dock = qobject_cast<QDockWidget*>(m_export->parentWidget());
    dock->show();
    dock->raise();
    for (const ExportReport& report : reports) {
        m_document.notes().noteExport(report.file, static_cast<double>(QDateTime::currentSecsSinceEpoch()));
        const auto parts = report.parts.size();
        m_log->add((parts == 1 ? tr("Exported 1 part to %1.") : tr("Exported %2 parts to %1.").arg(parts))
                       .arg(QFile::decodeName(report.file.c_str())));
        if (!report.isSound())
            showProblem(tr("Not everything in %1 is sound; the export report says what is not.")
                            .arg(QFileInfo(QFile::decodeName(report.file.c_str())).fileName()));
    }
}

/// The report, and what matters most of it in the banner: once, not with work that was done in spite of it.
void MainWindow::showImport()
{
    const Content& content = m_document.content();
    const Model& model = *content.model;
    m_import->show(content);
    if (m_document.history().tree().records().size() > 1)
        return;
    auto* dock = qobject_cast<QDockWidget*>(m_import->parentWidget());
    if (m_import->hasRemarks())
        dock->raise();
    if (model.unitRemark) {
        const QString unit = QString::fromStdString(model.unitRemark->unit);
        showProblem(inWords(model.unitRemark->sentence), tr("Take as %1").arg(unit), [this, unit] { takeIn(unit); });
    } else if (!model.missing.empty()) {
        showProblem(model.missing.size() == 1
                        ? inWords(model.missing.front())
                        : tr("%1 parts of the file are missing; the import report says which and why.")
                              .arg(formatCount(model.missing.size())),
                    tr("Show report"), [dock] {
                        dock->show();
                        dock->raise();
                    });
    } else if (content.bodies.empty()) {
        showProblem(tr("Nothing in this file is closed, so nothing can be filled and simulated; the import report says "
                       "why. Open edges are drawn in color."),
                    tr("Show report"), [dock] {
                        dock->show();
                        dock->raise();
                    });
    }
}

/// The same model, changed and filled by another request.
void MainWindow::openAgain(const QString& title, std::function<Model(const Model&)> change,
                           const ImportChoices& request)
{
    if (m_document.isEmpty() || isBusy())
        return;
    m_banner->hide();
    const auto work = [model = m_document.content().model, change = std::move(change), request,
                       material = startMaterial(m_services.materials)](TaskControl& control) {
        return prepareModel(std::make_shared<const Model>(change(*model)), request, material, control);
    };
    m_tasks.run<PreparedContent>(title, work, [this](PreparedContent prepared) { openPrepared(std::move(prepared)); });
}

void MainWindow::takeIn(const QString& unit)
{
    ImportChoices request = m_document.content().request;
    request.options.unit = unit.toStdString();
    request.spacing.reset(); // it was chosen for another size
    m_projects->letGo([this, unit, request] {
        openAgain(
            tr("Taking lengths in %1").arg(unit),
            [name = request.options.unit](const Model& model) { return takenIn(model, name); }, request);
    });
}

void MainWindow::fillOpenParts()
{
    ImportChoices request = m_document.content().request;
    request.fillsOpenParts = true;
    request.options.heal = true;
    request.options.capsFlatOpenings = true;
    m_projects->letGo([this, request] { open(request); });
}

void MainWindow::takeHealed(bool heal)
{
    ImportChoices request = m_document.content().request;
    request.options.heal = heal;
    m_projects->letGo([this, request] { open(request); });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.empty() && std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) {
        m_home->showDrop(true);
        event->acceptProposedAction();
    }
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent* event)
{
    m_home->showDrop(false);
    QMainWindow::dragLeaveEvent(event);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    m_home->showDrop(false);
    activateWindow(); // the keys that follow are for this window, not for the one it comes from
    event->acceptProposedAction();
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        paths << url.toLocalFile();
    openInstead(paths);
}

} // namespace knead
