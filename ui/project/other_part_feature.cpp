#include "ui/project/other_part_feature.h"

#include "core/message/message.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/format_filters.h"
#include "ui/dialogs/other_part_dialog.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/project/encoded_path.h"
#include "ui/project/project_keeper.h"
#include "ui/project/projects_feature.h"

#include <QAction>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

#include <memory>
#include <utility>

namespace knead {

struct OtherPartFeature::Found {
    QString name; ///< of the file
    TransferReport report;
    std::shared_ptr<PreparedModel> prepared;
};

namespace {

/// What was found, in a few lines.
QString linesOf(const TransferReport& report)
{
    QStringList lines{said(
        Message("OtherPartFeature", "%1 of %2 faces were found again.").with(report.found(), report.faces.size()))};
    for (const TransferReport::Moved& moved : report.moved)
        lines << said(Message("OtherPartFeature", "Moved: %1 by %2 mm")
                          .with(moved.what, QString::number(1000 * moved.shift.norm(), 'f', 2).toStdString()));
    for (const Message& sentence : report.leftOut)
        lines << said(sentence);
    constexpr qsizetype most = 16;
    const qsizetype more = lines.size() - most;
    if (more > 0) {
        lines.resize(most);
        lines << said(Message("OtherPartFeature", "and %1 more").with(more));
    }
    return lines.join('\n');
}

} // namespace

OtherPartFeature::OtherPartFeature(const Workbench& bench, ProjectsFeature& projects)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_projects(projects)
    , m_action(makeAction(bench.window,
                          {"applyToPart", QT_TRANSLATE_NOOP("Actions", "Appl&y to another part..."), nullptr, "",
                           QT_TRANSLATE_NOOP("Actions", "Do what was done here to another part, such as the next "
                                                        "revision of this one")}))
{
    bench.availability.needBodies({m_action});
    connect(m_action, &QAction::triggered, this, &OtherPartFeature::ask);
}

void OtherPartFeature::ask()
{
    if (m_bench.document.isEmpty())
        return;
    const FileQuestion question{.name = "otherPartDialog",
                                .title = tr("Apply to another part"),
                                .filters = QStringList(tr("Parts (%1)").arg(patternsToRead())) + filtersToRead(),
                                .key = "folder"};
    askForFilesToRead(m_bench.window, question, [this](const QStringList& paths) { askAbout(paths.front()); });
}

void OtherPartFeature::askAbout(const QString& path)
{
    if (m_bench.document.isEmpty())
        return;
    auto* dialog = new OtherPartDialog(QFileInfo(path).fileName(), &m_bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] { applyTo(path, dialog->options()); });
    dialog->open();
}

void OtherPartFeature::applyTo(const QString& path, const TransferOptions& options)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    m_bench.document.whenSettled([this, path, options] { find(path, options); });
}

/// All that was done has become part of the history.
void OtherPartFeature::find(const QString& path, const TransferOptions& options)
{
    const QString name = QFileInfo(path).fileName();
    const auto work = [apply = m_bench.services.recipes.apply, path, name, project = m_bench.document.project(),
                       saved = m_projects.keeper().path(), options](TaskControl& control) {
        constexpr double foundShare = 0.8; // of the progress
        TaskPortion finding(control, 0, foundShare);
        AppliedPart applied = apply(encoded(path), project, encoded(saved), options, finding);
        TaskPortion preparing(control, foundShare, 1);
        return Found{name, std::move(applied.report),
                     std::make_shared<PreparedModel>(prepareRecipe(std::move(applied.start), preparing))};
    };
    const QString title = said(Message("OtherPartFeature", "Finding the faces again on %1").with(name.toStdString()));
    if (!m_bench.tasks.run<Found>(title, work, [this](const Found& found) { show(found); }))
        m_bench.isBusy(); // says with what
}

void OtherPartFeature::show(const Found& found)
{
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Apply to another part"),
                                tr("This is what was found again on %1:").arg(found.name), QMessageBox::Cancel,
                                &m_bench.window);
    box->setObjectName("otherPartBox");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(linesOf(found.report));
    QPushButton* go = box->addButton(tr("Open"), QMessageBox::AcceptRole);
    go->setObjectName("otherPartOpen");
    box->setDefaultButton(go);
    connect(go, &QPushButton::clicked, this,
            [this, found] { m_projects.keeper().letGo([this, found] { open(found); }); });
    box->open();
}

void OtherPartFeature::open(const Found& found)
{
    found.prepared->name = Message("OtherPartFeature", "Apply to %1").with(found.name.toStdString());
    m_projects.keeper().open(std::move(*found.prepared));
    m_bench.notices.note(tr("Play carries out on %1 what was done before.").arg(found.name));
}

} // namespace knead
