// What the main window does to make videos and pictures of what was simulated.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/record_dialog.h"
#include "ui/panels/log_panel.h"
#include "ui/recording/studio.h"
#include "ui/units.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/view_name.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QFileInfo>

namespace knead {

void MainWindow::connectRecording()
{
    connect(m_actions->recordVideo, &QAction::triggered, this, [this] { askForRecording(Recording::Kind::video); });
    connect(m_actions->recordPictures, &QAction::triggered, this,
            [this] { askForRecording(Recording::Kind::pictures); });
}

void MainWindow::askForRecording(Recording::Kind kind)
{
    if (m_document.isPlaying())
        m_document.pause();
    m_document.whenSettled([this, kind] {
        const Timeline line = m_document.timeline();
        if (line.pictures.empty()) {
            showProblem(tr("There is nothing to record yet: press Play and let something happen first."));
            return;
        }
        const RecordDialog::ShownView view{.size = m_viewport->size() * m_viewport->devicePixelRatioF(),
                                           .name = m_views->areSeveral() ? nameOfView(m_viewport->cameraAfterTurning())
                                                                         : QString()};
        auto* dialog = new RecordDialog(kind, line.end, view, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &QDialog::accepted, this, [this, dialog] { askForPlace(dialog->recording()); });
        dialog->open();
    });
}

void MainWindow::askForPlace(const Recording& recording)
{
    const bool isVideo = recording.kind == Recording::Kind::video;
    const QString proposed = QFileInfo(QString::fromStdString(m_document.content().model->file)).completeBaseName();
    const FileQuestion question{.name = "recordFileDialog",
                                .title = isVideo ? tr("Save the video") : tr("Make a folder for the pictures"),
                                .filters = {isVideo ? tr("Video (*.ogv)") : tr("Folder (*)")},
                                .key = "record/folder",
                                .file = proposed + (isVideo ? ".ogv" : "-pictures")};
    askForFileToWrite(*this, question, [this, recording](const QString& path) { record(path, recording); });
}

void MainWindow::record(const QString& path, const Recording& recording)
{
    const Timeline line = m_document.timeline();
    if (line.pictures.empty() || isBusy())
        return;
    Studio::Surface surface;
    try {
        surface = Studio::makeSurface();
    } catch (const std::exception& error) {
        showProblem(QString::fromStdString(error.what()));
        return;
    }
    const auto work = [services = m_services, path = QFile::encodeName(path).toStdString(), recording, line, surface,
                       look = m_viewport->look()](TaskControl& control) {
        Studio studio(look, recording.size, surface);
        const auto draw = [&](const FramePointer& frame, double at) {
            return studio.draw(frame, recording.hasReadings ? std::optional(at) : std::nullopt);
        };
        if (recording.kind == Recording::Kind::pictures)
            knead::record(recording, line, look.content, draw, *makePictureWriter(path), control);
        else
            services.writeSafely(path, [&](const std::string& pathForNow) {
                knead::record(recording, line, look.content, draw, *makeVideoWriter(pathForNow, recording.rate),
                              control);
            });
        return recording.pictures();
    };
    const QString name = QFileInfo(path).fileName();
    m_tasks.run<std::size_t>(tr("Recording %1").arg(name), work, [this, name](std::size_t pictures) {
        m_log->add(pictures == 1 ? tr("%1: 1 picture recorded.").arg(name)
                                 : tr("%1: %2 pictures recorded.").arg(name, formatCount(pictures)));
    });
}

} // namespace knead
