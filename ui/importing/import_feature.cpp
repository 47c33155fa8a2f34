#include "ui/importing/import_feature.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/format_filters.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/panels/import_panel.h"
#include "ui/preferences/preferences.h"
#include "ui/project/project_keeper.h"
#include "ui/project/projects_feature.h"
#include "ui/project/recipes_feature.h"
#include "ui/units.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr qint64 largeFile = 4'000'000; // [bytes]; reading takes seconds, so that a person should choose first

} // namespace

ImportFeature::Actions::Actions(QWidget& window)
    : open(makeAction(window, {"open", QT_TRANSLATE_NOOP("Actions", "&Open..."), "open", "Ctrl+O",
                               QT_TRANSLATE_NOOP("Actions", "Open a part, a project or a recipe")}))
    , openWithChoices(makeAction(
          window,
          {"openWithChoices", QT_TRANSLATE_NOOP("Actions", "Open with &choices..."), nullptr, "Ctrl+Shift+O",
           QT_TRANSLATE_NOOP("Actions", "Look into files and choose parts, detail and units before they are opened")}))
    , addPart(makeAction(window, {"addPart", QT_TRANSLATE_NOOP("Actions", "Add &part..."), nullptr, "",
                                  QT_TRANSLATE_NOOP("Actions", "Put the parts of other files beside those that "
                                                               "are open, in the shape that these have now")}))
{
}

ImportFeature::ImportFeature(const Workbench& bench, ProjectsFeature& projects, RecipesFeature& recipes)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_projects(projects)
    , m_recipes(recipes)
    , m_panel(new ImportPanel(&bench.window))
{
    bench.docks.add("importDock", tr("Import report"), m_panel);
    bench.availability.needPart({m_actions.addPart});
    connect(m_actions.open, &QAction::triggered, this, [this] { askForFile(false); });
    connect(m_actions.openWithChoices, &QAction::triggered, this, [this] { askForFile(true); });
    connect(m_actions.addPart, &QAction::triggered, this, &ImportFeature::askForParts);
    connect(m_panel, &ImportPanel::unitChosen, this, &ImportFeature::takeIn);
    connect(m_panel, &ImportPanel::healingChosen, this, &ImportFeature::takeHealed);
    connect(m_panel, &ImportPanel::fillingChosen, this, &ImportFeature::fillOpenParts);
    connect(m_panel, &ImportPanel::placeWanted, this, &ImportFeature::placeWanted);
    connect(&projects, &ProjectsFeature::fileChosen, this, [this](const QString& path) { openInstead({path}); });
}

/// With what the preferences say.
ImportChoices ImportFeature::usualChoices(const QStringList& paths) const
{
    ImportChoices request;
    const Preferences wanted = readPreferences();
    request.options.relativeDeflection = wanted.detail;
    request.options.timeLimit = 60.0 * wanted.importMinutes;
    request.options.memoryLimit = (1U << 30U) * static_cast<double>(wanted.importGibibytes);
    for (const QString& path : paths)
        request.paths.push_back(QFile::encodeName(path).toStdString());
    return request;
}

void ImportFeature::open(const QStringList& paths)
{
    if (m_projects.opened(paths) || m_recipes.opened(paths))
        return;
    qint64 size = 0;
    for (const QString& path : paths)
        size += QFileInfo(path).size();
    if (size >= largeFile)
        openWithChoices(paths);
    else
        open(usualChoices(paths));
}

void ImportFeature::open(const ImportChoices& request)
{
    open(request, startMaterial(m_bench.services.materials), {});
}

void ImportFeature::openOf(const std::string& preset, const QString& path, std::function<void()> then)
{
    const std::vector<MaterialPreset>& all = m_bench.services.materials;
    const auto found = std::ranges::find(all, preset, &MaterialPreset::id);
    const Material material = found != all.end() ? found->material : startMaterial(all);
    m_projects.keeper().letGo(
        [this, path, material, then = std::move(then)] { open(usualChoices({path}), material, then); });
}

void ImportFeature::open(const ImportChoices& request, const Material& material, std::function<void()> then)
{
    if (request.paths.empty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto work = [services = m_bench.services, request, material](TaskControl& control) {
        return prepareFiles(services.import, request, material, control);
    };
    const QString name = QFileInfo(QFile::decodeName(request.paths.front().c_str())).fileName();
    const auto others = static_cast<int>(request.paths.size()) - 1;
    m_bench.tasks.run<PreparedModel>(others == 0 ? said(Message("ImportFeature", "Opening %1").with(name.toStdString()))
                                                 : tr("Opening %1 and %n more", nullptr, others).arg(name),
                                     work, [this, then = std::move(then)](PreparedModel prepared) {
                                         m_projects.open(std::move(prepared));
                                         if (then)
                                             then();
                                     });
}

void ImportFeature::openWithChoices(const QStringList& paths)
{
    if (paths.empty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto work = [services = m_bench.services, paths](TaskControl& control) {
        std::vector<FilePreview> previews;
        for (const QString& path : paths) {
            const double count = static_cast<double>(paths.size());
            TaskPortion portion(control, static_cast<double>(previews.size()) / count,
                                static_cast<double>(previews.size() + 1) / count);
            previews.push_back(services.preview(QFile::encodeName(path).toStdString(), portion));
        }
        return previews;
    };
    m_bench.tasks.run<std::vector<FilePreview>>(
        said(Message("ImportFeature", "Looking into %1").with(QFileInfo(paths.front()).fileName().toStdString())), work,
        [this](std::vector<FilePreview> previews) { askForChoices(std::move(previews)); });
}

void ImportFeature::askForFile(bool withChoices)
{
    const QString all = patternsToRead();
    QStringList filters = QStringList(tr("Parts (%1)").arg(all)) + filtersToRead();
    if (!withChoices) {
        const QString ending = "*." + QString::fromStdString(m_bench.services.projects.ending);
        const QString recipes = "*." + QString::fromStdString(m_bench.services.recipes.ending);
        filters[0] = tr("Projects, recipes and parts (%1)").arg(ending + ' ' + recipes + ' ' + all);
        filters.insert(1, m_projects.keeper().filter());
        filters.insert(2, tr("Recipes (%1)").arg(recipes));
    }
    const QString title = withChoices ? tr("Open parts") : tr("Open a project, a recipe or parts");
    const FileQuestion question{.name = "openDialog", .title = title, .filters = filters, .key = "folder"};
    askForFilesToRead(m_bench.window, question, [this, withChoices](const QStringList& paths) {
        m_projects.keeper().letGo([this, withChoices, paths] { withChoices ? openWithChoices(paths) : open(paths); });
    });
}

void ImportFeature::askForChoices(std::vector<FilePreview> previews)
{
    auto* dialog = new ImportDialog(std::move(previews), &m_bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { open(dialog->request()); });
    dialog->open();
}

void ImportFeature::openInstead(const QStringList& paths)
{
    m_projects.keeper().letGo([this, paths] { open(paths); });
}

void ImportFeature::refill(double spacing)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    startRefill(spacing);
}

void ImportFeature::startRefill(double spacing)
{
    const auto work = [before = m_bench.document.content(), spacing, now = m_bench.document.frame()->snapshot,
                       fixtures = m_bench.document.fixtures().list()](TaskControl& control) {
        return prepareRefill(before, spacing, *now, fixtures, control);
    };
    const auto finish = [this, spacing, edits = m_bench.document.edits(),
                         isSeen = m_bench.document.showsEdits()](PreparedModel prepared) {
        if (isSeen && m_bench.document.edits() == edits && !m_bench.document.isGoing())
            showRefilled(std::move(prepared));
        else
            QTimer::singleShot(0, this, [this, spacing] { refillOnceMore(spacing); });
    };
    m_bench.tasks.run<PreparedModel>(said(Message("ImportFeature", "Filling with a spacing of %1")
                                              .with(formatQuantity(spacing, Quantity::Length).toStdString())),
                                     work, finish);
}

/// With what was done meanwhile, as soon as no hand holds anything any more.
void ImportFeature::refillOnceMore(double spacing)
{
    constexpr int untilNextLook = 100; // [ms]
    if (m_bench.document.isInGesture())
        QTimer::singleShot(untilNextLook, this, [this, spacing] { refillOnceMore(spacing); });
    else
        m_bench.document.whenSettled([this, spacing] {
            if (!m_bench.document.isEmpty() && !m_bench.isBusy())
                startRefill(spacing);
        });
}

/// A part that does not suit the spacing, unlike the others, is only shown from now on.
void ImportFeature::showRefilled(PreparedModel prepared)
{
    const std::map<std::size_t, Message> before = m_bench.document.content().unfilled;
    m_bench.document.refill(std::move(prepared));
    for (const auto& [part, reason] : m_bench.document.content().unfilled)
        if (!before.contains(part))
            m_bench.notices.problem(said(Message("ImportFeature", "\"%1\" is not simulated: %2")
                                             .with(m_bench.document.nameOfPart(part).toStdString(), reason)));
}

void ImportFeature::tellOfModel()
{
    const FilledModel& content = m_bench.document.content();
    const bool isSimulated = !content.bodies.empty();
    const QString name = QFileInfo(QString::fromStdString(content.model->file)).fileName();
    const Snapshot& start = *m_bench.document.frame()->snapshot;
    if (!isSimulated)
        m_bench.notices.note(
            tr("%1: %2, %3 surfaces to look at, nothing to simulate.")
                .arg(name, QString::fromStdString(content.model->format), formatCount(content.surfaces.size())));
    else
        m_bench.notices.note(tr("%1: %2, %3 objects of spacing %4, %5 connections, time step %6.")
                                 .arg(name, QString::fromStdString(content.model->format), formatCount(start.objects),
                                      formatQuantity(content.spacing, Quantity::Length), formatCount(start.connections),
                                      formatReading(start.timeStep, Quantity::Time)));
    for (const Message& warning : content.warnings)
        m_bench.notices.warn(said(warning));
}

void ImportFeature::showImport()
{
    const FilledModel& content = m_bench.document.content();
    const Model& model = *content.model;
    const bool isAsRead = content.model == m_bench.document.opened();
    m_panel->show(content, isAsRead);
    if (!isAsRead || m_bench.document.history().tree().records().size() > 1)
        return;
    if (m_panel->hasRemarks())
        m_bench.docks.of("importDock").raise();
    if (model.unitRemark) {
        const QString unit = QString::fromStdString(model.unitRemark->unit);
        m_bench.notices.problem(said(model.unitRemark->sentence),
                                said(Message("ImportFeature", "Take as %1").with(unit.toStdString())),
                                [this, unit] { takeIn(unit); });
    } else if (!model.missing.empty()) {
        m_bench.notices.problem(
            model.missing.size() == 1
                ? said(model.missing.front())
                : said(Message("ImportFeature",
                               "%1 parts of the file are missing; the import report says which and why.")
                           .with(formatCount(model.missing.size()).toStdString())),
            tr("Show report"), [this] { m_bench.docks.show("importDock"); });
    } else if (content.bodies.empty()) {
        m_bench.notices.problem(
            tr("Nothing in this file is closed, so nothing can be filled and simulated; the import report says "
               "why. Open edges are drawn in color."),
            tr("Show report"), [this] { m_bench.docks.show("importDock"); });
    }
}

void ImportFeature::showNothing()
{
    m_panel->clear();
}

/// The same model, changed and filled by another request.
void ImportFeature::openAgain(const QString& title, std::function<Model(const Model&)> change,
                              const ImportChoices& request)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto work = [model = m_bench.document.content().model, change = std::move(change), request,
                       material = startMaterial(m_bench.services.materials)](TaskControl& control) {
        return prepareModel(std::make_shared<const Model>(change(*model)), request, material, control);
    };
    m_bench.tasks.run<PreparedModel>(title, work,
                                     [this](PreparedModel prepared) { m_projects.open(std::move(prepared)); });
}

void ImportFeature::takeIn(const QString& unit)
{
    ImportChoices request = m_bench.document.content().request;
    request.options.unit = unit.toStdString();
    request.spacing.reset(); // it was chosen for another size
    m_projects.keeper().letGo([this, unit, request] {
        openAgain(
            said(Message("ImportFeature", "Taking lengths in %1").with(unit.toStdString())),
            [name = request.options.unit](const Model& model) { return takenIn(model, name); }, request);
    });
}

void ImportFeature::fillOpenParts()
{
    ImportChoices request = m_bench.document.content().request;
    request.fillsOpenParts = true;
    request.options.heal = true;
    request.options.capsFlatOpenings = true;
    m_projects.keeper().letGo([this, request] { open(request); });
}

void ImportFeature::takeHealed(bool heal)
{
    ImportChoices request = m_bench.document.content().request;
    request.options.heal = heal;
    m_projects.keeper().letGo([this, request] { open(request); });
}

} // namespace knead
