#include "ui/project/recipes_feature.h"

#include "core/message/message.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/file_question.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/project/encoded_path.h"
#include "ui/project/project_keeper.h"
#include "ui/project/projects_feature.h"

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <memory>

namespace knead {

RecipesFeature::RecipesFeature(const Workbench& bench, ProjectsFeature& projects)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_projects(projects)
    , m_export(makeAction(
          bench.window,
          {"exportRecipe", QT_TRANSLATE_NOOP("Actions", "Export as &recipe..."), nullptr, "",
           QT_TRANSLATE_NOOP("Actions", "Write what was done as a recipe, to be read, changed and carried out again")}))
{
    bench.availability.needBodies({m_export});
    connect(m_export, &QAction::triggered, this, &RecipesFeature::askForRecipe);
    connect(&bench.document, &Document::recipeEnded, this, &RecipesFeature::offerExports);
    connect(&bench.document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model && m_model != m_bench.document.content().model)
            m_exports.clear(); // of a recipe that is open no more
    });
}

/// The window writes nothing of its own accord.
void RecipesFeature::offerExports()
{
    if (m_exports.isEmpty())
        return;
    const QString sentence = said(Message("RecipesFeature", "The recipe names files to export: %1.")
                                      .with(m_exports.join(QStringLiteral(", ")).toStdString()));
    m_bench.notices.warn(sentence);
    m_bench.notices.advise(sentence, tr("Export..."), [this] { emit exportWanted(); });
}

bool RecipesFeature::opened(const QStringList& paths)
{
    const QString ending = QString::fromStdString(m_bench.services.recipes.ending);
    const auto isRecipe = [&](const QString& path) {
        return !ending.isEmpty() && QFileInfo(path).suffix().compare(ending, Qt::CaseInsensitive) == 0;
    };
    if (std::none_of(paths.begin(), paths.end(), isRecipe))
        return false;
    if (paths.size() == 1)
        open(paths.front());
    else
        m_bench.notices.problem(tr("A recipe is opened alone: choose one file, or only parts."));
    return true;
}

void RecipesFeature::open(const QString& path)
{
    if (m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const QString name = QFileInfo(path).fileName();
    const QString title = said(Message("RecipesFeature", "Opening %1").with(name.toStdString()));
    const auto exports = std::make_shared<QStringList>();
    const auto work = [services = m_bench.services.recipes, path, title, exports](TaskControl& control) {
        constexpr double readShare = 0.7; // of the progress
        TaskPortion reading(control, 0, readShare);
        RecipeStart recipe = services.open(encoded(path), reading);
        for (const RecipeExport& wanted : recipe.exports)
            *exports << QString::fromStdString(wanted.file);
        TaskPortion preparing(control, readShare, 1);
        return prepareRecipe(std::move(recipe), preparing);
    };
    const auto finish = [this, path, name, exports](PreparedModel prepared) {
        prepared.name = Message("RecipesFeature", "Open %1").with(name.toStdString());
        m_projects.keeper().open(std::move(prepared));
        m_model = m_bench.document.content().model;
        m_exports = *exports;
        m_projects.addRecent(path);
        m_bench.notices.note(tr("Play carries out %1; what is done by hand comes on top of it.").arg(name));
    };
    m_bench.tasks.run<PreparedModel>(title, work, finish);
}

void RecipesFeature::askForRecipe()
{
    if (m_bench.document.isEmpty())
        return;
    const QString ending = QString::fromStdString(m_bench.services.recipes.ending);
    const FileQuestion question{.name = "recipeDialog",
                                .title = tr("Export as a recipe"),
                                .filters = {tr("Recipes (*.%1)").arg(ending)},
                                .key = "recipeFolder",
                                .file = QFileInfo(m_projects.keeper().name()).completeBaseName() + ".recipe." + ending};
    askForFileToWrite(m_bench.window, question, [this](const QString& path) { exportTo(path); });
}

void RecipesFeature::exportTo(const QString& path)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    m_bench.document.whenSettled([this, path] { write(path); });
}

/// All that was done has become part of the history.
void RecipesFeature::write(const QString& path)
{
    const auto work = [write = m_bench.services.recipes.write, path, project = m_bench.document.project(),
                       saved = m_projects.keeper().path()](TaskControl&) {
        return write(encoded(path), project, encoded(saved));
    };
    const auto finish = [this, path](const std::vector<Message>& remarks) {
        m_bench.notices.note(tr("Exported the session as a recipe to %1.").arg(path));
        for (const Message& remark : remarks)
            m_bench.notices.warn(said(remark));
    };
    const QString title =
        said(Message("RecipesFeature", "Exporting %1").with(QFileInfo(path).fileName().toStdString()));
    if (!m_bench.tasks.run<std::vector<Message>>(title, work, finish))
        m_bench.isBusy(); // says with what
}

} // namespace knead
