// Recipes in the main window: opened, to be played; and written, of what was done.
#include "ui/main_window.h"

#include "ui/dialogs/file_question.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/project/recent_files.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace knead {

namespace {

std::string encoded(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

} // namespace

/// @return whether they were a matter of recipes
bool MainWindow::openedAsRecipe(const QStringList& paths)
{
    const QString ending = QString::fromStdString(m_services.recipes.ending);
    const auto isRecipe = [&](const QString& path) {
        return !ending.isEmpty() && QFileInfo(path).suffix().compare(ending, Qt::CaseInsensitive) == 0;
    };
    if (std::none_of(paths.begin(), paths.end(), isRecipe))
        return false;
    if (paths.size() == 1)
        openRecipe(paths.front());
    else
        showProblem(tr("A recipe is opened alone: choose one file, or only parts."));
    return true;
}

void MainWindow::openRecipe(const QString& path)
{
    if (isBusy())
        return;
    m_banner->hide();
    const QString name = QFileInfo(path).fileName();
    const QString title = tr("Opening %1").arg(name);
    const auto work = [services = m_services.recipes, path, title](TaskControl& control) {
        constexpr double readShare = 0.7; // of the progress
        TaskPortion reading(control, 0, readShare);
        RecipeStart recipe = services.open(encoded(path), reading);
        TaskPortion preparing(control, readShare, 1);
        return prepareRecipe(std::move(recipe), preparing);
    };
    const auto finish = [this, path, name](PreparedContent prepared) {
        prepared.name = tr("Open %1").arg(name).toStdString();
        m_projects->open(std::move(prepared));
        recent_files::add(path);
        listRecent();
        m_log->add(tr("Play carries out %1; what is done by hand comes on top of it.").arg(name));
    };
    m_tasks.run<PreparedContent>(title, work, finish);
}

void MainWindow::askForRecipe()
{
    if (m_document.isEmpty())
        return;
    const QString ending = QString::fromStdString(m_services.recipes.ending);
    const FileQuestion question{.name = "recipeDialog",
                                .title = tr("Export as a recipe"),
                                .filters = {tr("Recipes (*.%1)").arg(ending)},
                                .key = "recipeFolder",
                                .file = QFileInfo(m_projects->name()).completeBaseName() + ".recipe." + ending};
    askForFileToWrite(*this, question, [this](const QString& path) { exportRecipe(path); });
}

void MainWindow::exportRecipe(const QString& path)
{
    if (m_document.isEmpty() || isBusy())
        return;
    m_banner->hide();
    m_document.whenSettled([this, path] { writeRecipe(path); });
}

/// All that was done has become part of the history.
void MainWindow::writeRecipe(const QString& path)
{
    const auto work = [write = m_services.recipes.write, path, project = m_document.project(),
                       saved = m_projects->path()](TaskControl&) {
        return write(encoded(path), project, encoded(saved));
    };
    const auto finish = [this, path](const std::vector<std::string>& remarks) {
        m_log->add(tr("Exported the session as a recipe to %1.").arg(path));
        for (const std::string& remark : remarks)
            m_log->add(QString::fromStdString(remark), LogPanel::Kind::Warning);
    };
    const QString title = tr("Exporting %1").arg(QFileInfo(path).fileName());
    if (!m_tasks.run<std::vector<std::string>>(title, work, finish))
        isBusy(); // says with what
}

} // namespace knead
