// How a project is saved, and what is asked before unsaved work would be lost.
#include "core/message/message.h"
#include "ui/language/said.h"
#include "ui/project/project_keeper.h"

#include "ui/dialogs/file_question.h"
#include "ui/dialogs/recent_files.h"
#include "ui/project/encoded_path.h"
#include "ui/project/project_view.h"
#include "ui/project/thumbnails.h"
#include "ui/tasks/task_runner.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTimer>

#include <chrono>
#include <thread>
#include <utility>

namespace knead {

namespace {

/// One after the other.
std::function<void()> both(std::function<void()> first, std::function<void()> second)
{
    return [first = std::move(first), second = std::move(second)] {
        if (first)
            first();
        if (second)
            second();
    };
}

/// A saving that was cancelled may be on its way out, and shall not end after the next one to its file.
/// @throws Cancelled
std::unique_lock<std::mutex> turnOf(std::mutex& turn, const TaskControl& control)
{
    std::unique_lock lock(turn, std::defer_lock);
    while (!lock.try_lock()) {
        control.throwIfCancelled();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return lock;
}

} // namespace

/// What writing a file comes to.
struct ProjectKeeper::SavedFile {
    QString path;
    std::uint64_t revision = 0; ///< of the history in it
    QImage picture;             ///< what the view showed
    std::shared_ptr<void> lock;
    Message problem; ///< a sentence; empty: it was written
};

void ProjectKeeper::save(std::function<void()> then)
{
    if (m_path.isEmpty())
        saveAs(std::move(then));
    else
        saveTo(m_path, std::move(then));
}

void ProjectKeeper::saveAs(std::function<void()> then)
{
    if (m_window.document.isEmpty())
        return;
    const FileQuestion question{.name = "saveDialog",
                                .title = tr("Save the project"),
                                .filters = {filter()},
                                .key = "projectFolder",
                                .folder = m_path.isEmpty() ? QString() : QFileInfo(m_path).absolutePath(),
                                .file = QFileInfo(name()).completeBaseName() + '.' +
                                        QString::fromStdString(m_services.ending)};
    askForFileToWrite(*m_window.widget, question,
                      [this, then = std::move(then)](const QString& path) { saveUnder(path, then); });
}

/// The dialog asked before a file is replaced, but not by this name when it has another ending.
void ProjectKeeper::saveUnder(const QString& path, const std::function<void()>& then)
{
    const QString whole = isProject(path) ? path : path + '.' + QString::fromStdString(m_services.ending);
    if (whole != path && QFileInfo::exists(whole))
        emit problem(said(Message("ProjectKeeper", "%1 is there already: choose another name, or choose that file.")
                              .with(whole.toStdString())),
                     tr("Save as..."), [this, then] { saveAs(then); });
    else
        saveTo(whole, then);
}

void ProjectKeeper::saveTo(const QString& path, std::function<void()> then)
{
    if (m_window.document.isEmpty())
        return;
    if (m_saving) { // what is done while it goes on is saved after it
        m_saving->then = both(std::move(m_saving->then), [this, path, then = std::move(then)] {
            if (isModified() || QFileInfo(path).absoluteFilePath() != m_path)
                saveTo(path, then);
            else if (then)
                then();
        });
        return;
    }
    if (m_window.tasks.isRunning()) {
        emit problem(
            said(Message("ProjectKeeper", "%1 is still going on: wait for it, or cancel it with Esc, and save again.")
                     .with(m_window.tasks.title().toStdString())),
            {}, {});
        return;
    }
    m_saving = Saving{QFileInfo(path).absoluteFilePath(), std::move(then)};
    m_window.document.whenSettled([this] { startSaving(); });
}

/// All that was done has become part of the history. That may have begun a task, as going far in the history does.
void ProjectKeeper::startSaving()
{
    if (!m_saving || m_saving->stage != Saving::Stage::settling)
        return;
    if (m_window.tasks.isRunning()) {
        m_saving->stage = Saving::Stage::waiting;
        return;
    }
    historyChanged(); // in case it is told of it later
    m_saving->stage = Saving::Stage::running;
    m_autosave.savingBegins();
    SavedFile file{.path = m_saving->path,
                   .revision = m_window.document.history().revision(),
                   .picture = m_window.viewport.portrait()};
    if (isOwnFile(encoded(file.path)))
        file.lock = m_lock;
    std::shared_ptr<std::mutex>& turn = m_turns[file.path];
    if (turn == nullptr)
        turn = std::make_shared<std::mutex>();
    const auto work = [services = m_services, file, project = collect(), turn](TaskControl& control) mutable {
        const std::unique_lock lock = turnOf(*turn, control);
        SavedFile done = file;
        try {
            if (!done.lock)
                done.lock = services.lock(encoded(done.path));
            project.view.thumbnail = thumbnailOf(done.picture);
            services.write(encoded(done.path), project, control);
            control.throwIfCancelled(); // nobody would let go of the lock
        } catch (const Cancelled&) {
            throw;
        } catch (const std::runtime_error& error) {
            done.problem = messageOf(error);
        }
        return done;
    };
    const QString title =
        said(Message("ProjectKeeper", "Saving %1").with(QFileInfo(file.path).fileName().toStdString()));
    m_window.tasks.run<SavedFile>(title, work, [this](SavedFile done) { finishSaving(std::move(done)); });
}

/// A task has ended.
void ProjectKeeper::goOnSaving()
{
    if (!m_saving || m_saving->stage != Saving::Stage::waiting)
        return;
    m_saving->stage = Saving::Stage::settling;
    m_window.document.whenSettled([this] { startSaving(); });
}

void ProjectKeeper::finishSaving(SavedFile file)
{
    const std::function<void()> then = std::exchange(m_saving, std::nullopt)->then;
    if (!file.problem.empty()) {
        emit problem(said(file.problem), tr("Save as..."), [this, then] { saveAs(then); });
        return;
    }
    m_path = file.path;
    m_lock = std::move(file.lock);
    m_savedRevision = file.revision;
    m_autosave.saved(encoded(m_path));
    recent_files::add(m_path);
    thumbnails::keep(m_path, file.picture);
    emit recentChanged();
    emit told(tr("Saved %1.").arg(m_path));
    noteModified();
    emit changed();
    if (then)
        then();
}

Project ProjectKeeper::collect() const
{
    Project project = m_window.document.project();
    project.marks = m_marks;
    project.panels = panels();
    project.view = view();
    return project;
}

std::map<std::string, std::string> ProjectKeeper::panels() const
{
    std::map<std::string, std::string> result = m_window.document.panels();
    result.insert(m_panels.begin(), m_panels.end()); // where they are not the document's, which are newer
    for (const auto& [name, panel] : m_kept)
        if (std::string memory = panel.memory(); memory.empty())
            result.erase(name);
        else
            result[name] = std::move(memory);
    return result;
}

ProjectView ProjectKeeper::view() const
{
    ProjectView result;
    result.camera = kept(m_window.viewport.cameraAfterTurning());
    const auto& hidden = m_window.viewport.options().hiddenParts;
    result.hiddenParts.assign(hidden.begin(), hidden.end());
    return result;
}

WorkState ProjectKeeper::state() const
{
    return {.projectFile = encoded(m_path), .isSaved = !isModified(), .gesture = {}, .step = 0};
}

void ProjectKeeper::letGo(std::function<void()> then)
{
    if (!isModified()) {
        if (m_saving)
            m_saving->then = both(std::move(m_saving->then), [this, then = std::move(then)] { letGo(then); });
        else
            then();
        return;
    }
    if (m_question) {
        m_question->raise();
        return;
    }
    m_question = new QMessageBox(QMessageBox::NoIcon, tr("Unsaved changes"),
                                 m_path.isEmpty() ? tr("Save the work on \"%1\" as a project?").arg(name())
                                                  : tr("Save the changes to \"%1\"?").arg(name()),
                                 QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window.widget);
    m_question->setObjectName("saveQuestion");
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    m_question->setIconPixmap(icon("save").pixmap(32, 32));
    m_question->setInformativeText(m_path.isEmpty() ? tr("It has never been saved.")
                                                    : tr("What was done since it was saved is lost otherwise."));
    m_question->setDefaultButton(QMessageBox::Save);
    m_question->button(QMessageBox::Save)->setText(tr("&Save"));
    m_question->button(QMessageBox::Discard)->setText(tr("&Discard"));
    m_question->button(QMessageBox::Cancel)->setText(tr("&Cancel"));
    connect(m_question, &QMessageBox::finished, this, [this, then = std::move(then)](int button) {
        if (button == QMessageBox::Save)
            saveAll(then);
        else if (button == QMessageBox::Discard)
            afterSaving(then);
    });
    m_question->open();
}

/// Time stands still from now on; what is done by hand while the file is written is asked about again.
void ProjectKeeper::saveAll(const std::function<void()>& then)
{
    m_window.document.pause();
    save([this, then] { letGo(then); });
}

/// What was asked for before is saved, whatever becomes of the rest.
void ProjectKeeper::afterSaving(const std::function<void()>& then)
{
    if (m_saving)
        m_saving->then = both(std::move(m_saving->then), [this, then] { afterSaving(then); });
    else
        then();
}

void ProjectKeeper::closeProject()
{
    m_autosave.discard();
    {
        const QScopedValueRollback changing(m_isChanging, true);
        m_window.document.close();
    }
    ++m_documents;
    m_isNew = m_wasModified = false;
    m_saving.reset();
    m_savedRevision.reset();
    m_path.clear();
    m_lock.reset();
    m_marks.clear();
    m_panels.clear();
    emit changed();
}

void ProjectKeeper::close()
{
    m_watch->stop();
    m_autosave.discard();
    m_lock.reset();
}

} // namespace knead
