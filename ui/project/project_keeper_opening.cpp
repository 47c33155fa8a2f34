// How a project comes into the window: from its file, as a copy, rescued, or recovered.
#include "core/message/message.h"
#include "ui/language/said.h"
#include "ui/project/project_keeper.h"

#include "ui/dialogs/recent_files.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/panels/model_tree.h"
#include "ui/project/project_view.h"
#include "ui/tasks/task_runner.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QScopedValueRollback>

#include <stdexcept>
#include <utility>

namespace knead {

namespace {

QString titleOf(const ProjectRequest& request)
{
    if (request.recovery)
        return said(
            Message("ProjectKeeper", "Recovering %1").with(RecoveryDialog::nameOf(*request.recovery).toStdString()));
    const QString name = QFileInfo(QFile::decodeName(request.path.c_str())).fileName();
    return request.rescues ? said(Message("ProjectKeeper", "Rescuing %1").with(name.toStdString()))
                           : said(Message("ProjectKeeper", "Opening %1").with(name.toStdString()));
}

/// The program may go on in another folder, and so may the next one that recovers the work.
std::string absolute(const std::string& path)
{
    const QFileInfo file(QFile::decodeName(path.c_str()));
    return path.empty() ? path : QFile::encodeName(file.absoluteFilePath()).toStdString();
}

} // namespace

void ProjectKeeper::open(const ProjectRequest& request)
{
    ProjectRequest whole = request;
    whole.path = absolute(request.path);
    const auto finish = [this, whole](ReadProject read) {
        if (read.obstacle == ReadProject::Obstacle::none)
            show(std::move(read));
        else
            offerRemedy(whole, read);
    };
    ProjectRequest own = whole;
    if (isOwnFile(request.recovery ? request.recovery->projectFile : whole.path))
        own.lock = m_lock;
    const auto work = [services = m_services, packing = m_packing, own](TaskControl& control) {
        return readProjectFor(own, services, packing, control);
    };
    if (m_window.tasks.run<ReadProject>(titleOf(request), work, finish))
        emit opening();
    else
        emit problem(said(Message("ProjectKeeper", "%1 is still going on: wait for it, or cancel it with Esc.")
                              .with(m_window.tasks.title().toStdString())),
                     {}, {});
}

void ProjectKeeper::offerRemedy(const ProjectRequest& request, const ReadProject& read)
{
    const bool isLocked = read.obstacle == ReadProject::Obstacle::lock;
    ProjectRequest other = request;
    other.isCopy = true;
    other.rescues = !isLocked;
    emit problem(said(read.sentence), isLocked ? tr("Open a copy") : tr("Rescue what is whole"),
                 [this, other] { letGo([this, other] { open(other); }); });
}

void ProjectKeeper::show(ReadProject read)
{
    const QString path = QFile::decodeName(read.path.c_str());
    const bool isRecovered = read.kept != nullptr;
    if (!showModel(read))
        return;
    m_saving.reset();
    m_path = path;
    m_lock = std::move(read.lock);
    m_marks = std::move(read.marks);
    m_panels = std::move(read.panels);
    showView(read.view, isRecovered);
    {
        const QScopedValueRollback changing(m_isChanging, true); // the recovery is still that of the last project
        for (const auto& [panel, kept] : m_kept)
            kept.remember(m_panels.contains(panel) ? m_panels[panel] : std::string());
    }
    if (!m_isNew) {
        m_savedRevision.reset();
        if (read.isSaved)
            m_savedRevision = m_window.document.history().revision();
        if (read.kept)
            m_autosave.takeOver(std::move(read.kept), collect(), state());
        else
            m_autosave.begin(collect(), state());
        m_gestureKept = m_viewKept = Clock::now();
    }
    if (!m_path.isEmpty()) {
        recent_files::add(m_path);
        emit recentChanged();
        emit shown();
    }
    m_wasModified = isModified();
    emit changed();
    if (isRecovered)
        tellOfWaiting(); // one less
    if (!read.sentence.empty())
        emit problem(said(read.sentence), tr("Save as..."), [this] { saveAs(); });
    if (!read.missing.empty())
        listMissing(read.missing);
}

/// @return whether it could be; else nothing has changed
bool ProjectKeeper::showModel(ReadProject& read)
{
    if (read.parts) {
        open(std::move(*read.parts));
        return true;
    }
    try {
        const QScopedValueRollback changing(m_isChanging, true);
        m_window.document.open(std::move(*read.project));
        ++m_documents;
        m_isNew = false;
        return true;
    } catch (const std::runtime_error& error) {
        emit problem(said(messageOf(error)), {}, {});
        return false;
    }
}

/// A camera that was kept for a window of another size may leave parts beside the view. Who saved it may have wanted
/// that, but nobody chose when recovered work was kept.
void ProjectKeeper::showView(const ProjectView& view, bool isRecovered)
{
    const Camera camera = restored(view.camera);
    emit perspectiveRestored(camera.perspective);
    m_window.viewport.jumpTo(camera);
    m_window.tree.hideParts({view.hiddenParts.begin(), view.hiddenParts.end()});
    if (isRecovered && !m_window.viewport.showsAll())
        m_window.viewport.fit();
}

void ProjectKeeper::listMissing(const std::vector<Message>& missing)
{
    constexpr std::size_t most = 12;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(missing.size(), most); ++i)
        lines << QStringLiteral("\u2022 ") + said(missing[i]);
    if (missing.size() > most)
        lines << tr("and %1 more").arg(missing.size() - most);
    for (const Message& phrase : missing)
        emit told(tr("Not whole: %1").arg(said(phrase)));
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Not everything is whole"),
                                tr("This could not be brought back:"), QMessageBox::Ok, m_window.widget);
    box->setObjectName("missingBox");
    box->setIconPixmap(icon("warning").pixmap(32, 32));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(lines.join('\n'));
    box->open();
}

// --- recovery -------------------------------------------------------------------------------------------------------------

void ProjectKeeper::offerRecoveries(bool saysNone)
{
    m_autosave.find([this, saysNone](std::vector<Recovery> found) { showRecoveries(std::move(found), saysNone); });
}

void ProjectKeeper::showRecoveries(std::vector<Recovery> found, bool saysNone)
{
    if (found.empty()) {
        if (saysNone)
            emit problem(tr("There is no unsaved work to recover."), {}, {});
        return;
    }
    auto* dialog = new RecoveryDialog(std::move(found), m_window.widget);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::recoverClicked, this, &ProjectKeeper::recover);
    connect(dialog, &RecoveryDialog::discardClicked, this,
            [this](const Recovery& recovery) { m_autosave.drop(recovery); });
    connect(dialog, &QDialog::finished, this, &ProjectKeeper::tellOfWaiting);
    dialog->open();
}

/// After what was asked for in the dialog, and when it is done.
void ProjectKeeper::tellOfWaiting()
{
    m_autosave.find([this](const std::vector<Recovery>& found) {
        QStringList names;
        for (const Recovery& recovery : found)
            names << RecoveryDialog::nameOf(recovery);
        emit recoveriesWaiting(names);
    });
}

void ProjectKeeper::recover(const Recovery& recovery)
{
    letGo([this, recovery] { open({.path = {}, .recovery = recovery}); });
}

} // namespace knead
