// The dialogs of the main window: files and help.
#include "ui/main_window.h"

#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/project/project_keeper.h"
#include "ui/selection/selection_model.h"
#include "ui/viewport/viewport_widget.h"

#include <QFileInfo>
#include <QMessageBox>

namespace knead {

namespace {

/// "STEP (*.step *.stp)"
QString filterOf(const Services::Format& format)
{
    QStringList patterns;
    for (const std::string& ending : format.endings)
        patterns << "*." + QString::fromStdString(ending);
    return QStringLiteral("%1 (%2)").arg(QString::fromStdString(format.name), patterns.join(' '));
}

QStringList filtersOf(const std::vector<Services::Format>& formats)
{
    QStringList filters;
    for (const Services::Format& format : formats)
        filters << filterOf(format);
    return filters;
}

} // namespace

void MainWindow::askForFile(bool withChoices)
{
    QStringList all;
    for (const Services::Format& format : m_services.importFormats)
        for (const std::string& ending : format.endings)
            all << "*." + QString::fromStdString(ending);
    QStringList filters = QStringList(tr("Parts (%1)").arg(all.join(' '))) + filtersOf(m_services.importFormats);
    if (!withChoices) {
        const QString ending = "*." + QString::fromStdString(m_services.projects.ending);
        const QString recipes = "*." + QString::fromStdString(m_services.recipes.ending);
        filters[0] = tr("Projects, recipes and parts (%1)").arg(ending + ' ' + recipes + ' ' + all.join(' '));
        filters.insert(1, m_projects->filter());
        filters.insert(2, tr("Recipes (%1)").arg(recipes));
    }
    const QString title = withChoices ? tr("Open parts") : tr("Open a project, a recipe or parts");
    const FileQuestion question{.name = "openDialog", .title = title, .filters = filters, .key = "folder"};
    askForFilesToRead(*this, question, [this, withChoices](const QStringList& paths) {
        m_projects->letGo([this, withChoices, paths] { withChoices ? openWithChoices(paths) : open(paths); });
    });
}

void MainWindow::askForChoices(std::vector<FilePreview> previews)
{
    auto* dialog = new ImportDialog(std::move(previews), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { open(dialog->request()); });
    dialog->open();
}

void MainWindow::askForExport()
{
    if (m_document.isEmpty())
        return;
    constexpr int mostNames = 3;
    QStringList names;
    if (const Region& region = m_document.selected().region(); region.level == Level::Part)
        for (const auto& [body, items] : region.items)
            names << m_document.nameOfBody(body);
    if (names.size() > mostNames)
        names = names.mid(0, mostNames) << QStringLiteral("\u2026");
    auto* dialog = new ExportDialog(m_services.exportFormats, names.join(QStringLiteral(", ")),
                                    !m_viewport->options().hiddenParts.empty(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { askForPlace(dialog->request(), dialog->format()); });
    dialog->open();
}

void MainWindow::askForPlace(const ExportRequest& request, const Services::Format& format)
{
    const QString proposed = QFileInfo(QString::fromStdString(m_document.content().model->file)).completeBaseName();
    const QString ending = QString::fromStdString(format.endings.front());
    const FileQuestion question{.name = "exportFileDialog",
                                .title = request.onePerPart ? tr("Export a file for each part")
                                                            : tr("Export the deformed parts"),
                                .filters = {filterOf(format)},
                                .key = "exportFolder",
                                .file = proposed + "-deformed." + ending};
    askForFileToWrite(*this, question, [this, request](const QString& path) { exportTo(path, request); });
}

void MainWindow::showControls()
{
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Mouse and keys"), {}, QMessageBox::Close, this);
    box->setObjectName("controlsBox");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::RichText);
    box->setText(tr("<table cellpadding=3>"
                    "<tr><td><b>Left button</b></td><td>select; drag a tool</td></tr>"
                    "<tr><td><b>Middle button</b></td><td>orbit; with Shift or Ctrl pan</td></tr>"
                    "<tr><td><b>Wheel</b></td><td>zoom to the cursor</td></tr>"
                    "<tr><td><b>Arrows, PgUp, PgDn</b></td><td>drive the selected tool; Shift is slower</td></tr>"
                    "<tr><td><b>Space, . , Backspace</b></td><td>play or pause, one step, reset</td></tr>"
                    "<tr><td><b>B, X, Del</b></td><td>add a block, fix faces, remove</td></tr>"
                    "<tr><td><b>G, N</b></td><td>gravity, re-normalize</td></tr>"
                    "<tr><td><b>O, H, E</b></td><td>objects, hide body, edges</td></tr>"
                    "<tr><td><b>7, 0, numeric pad 1, 3</b></td><td>top, isometric, front, right; Ctrl: from the other "
                    "side</td></tr>"
                    "<tr><td><b>1, 2, 3, 4</b></td><td>clicks select parts, faces, edges, objects; Ctrl adds</td></tr>"
                    "<tr><td><b>5, F</b></td><td>perspective or parallel, fit</td></tr>"
                    "<tr><td><b>Ctrl+S</b></td><td>save the project; Ctrl+Shift+S under another name</td></tr>"
                    "<tr><td><b>Shift+F1, F2, F4</b></td><td>one, two, four views; V: the active view alone</td></tr>"
                    "<tr><td><b>Ctrl+K</b></td><td>find any command; F11: full screen</td></tr>"
                    "<tr><td><b>Esc</b></td><td>cancel</td></tr></table>"));
    box->open();
}

} // namespace knead
