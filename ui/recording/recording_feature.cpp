#include "ui/recording/recording_feature.h"

#include "core/message/message.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/record_dialog.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/recording/offscreen_renderer.h"
#include "ui/units.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/view_name.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

namespace knead {

RecordingFeature::Actions::Actions(QWidget& window)
    : video(makeAction(window,
                       {"recordVideo", QT_TRANSLATE_NOOP("Actions", "Record &video..."), "record", "",
                        QT_TRANSLATE_NOOP("Actions", "Make a video of what was simulated, as the view shows it")}))
    , pictures(makeAction(window, {"recordPictures", QT_TRANSLATE_NOOP("Actions", "Record p&ictures..."), nullptr, "",
                                   QT_TRANSLATE_NOOP("Actions", "Write what was simulated as a sequence of pictures")}))
{
}

RecordingFeature::RecordingFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
{
    bench.availability.needBodies({m_actions.video, m_actions.pictures});
    connect(m_actions.video, &QAction::triggered, this, [this] { askForRecording(Recording::Kind::video); });
    connect(m_actions.pictures, &QAction::triggered, this, [this] { askForRecording(Recording::Kind::pictures); });
}

void RecordingFeature::askForRecording(Recording::Kind kind)
{
    if (m_bench.document.isPlaying())
        m_bench.document.pause();
    m_bench.document.whenSettled([this, kind] {
        const Timeline line = m_bench.document.timeline();
        if (line.pictures.empty()) {
            m_bench.notices.problem(tr("There is nothing to record yet: press Play and let something happen first."));
            return;
        }
        const RecordDialog::ShownView view{
            .size = m_bench.viewport.size() * m_bench.viewport.devicePixelRatioF(),
            .name = m_bench.views.areSeveral() ? nameOfView(m_bench.viewport.cameraAfterTurning()) : QString()};
        auto* dialog = new RecordDialog(kind, line.end, view, &m_bench.window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &QDialog::accepted, this, [this, dialog] { askForPlace(dialog->recording()); });
        dialog->open();
    });
}

void RecordingFeature::askForPlace(const Recording& recording)
{
    const bool isVideo = recording.kind == Recording::Kind::video;
    const FileQuestion question{.name = "recordFileDialog",
                                .title = isVideo ? tr("Save the video") : tr("Make a folder for the pictures"),
                                .filters = {isVideo ? tr("Video (*.ogv)") : tr("Folder (*)")},
                                .key = "record/folder",
                                .file = m_bench.nameForFile(isVideo ? ".ogv" : "-pictures")};
    askForFileToWrite(m_bench.window, question, [this, recording](const QString& path) { record(path, recording); });
}

void RecordingFeature::record(const QString& path, const Recording& recording)
{
    const Timeline line = m_bench.document.timeline();
    if (line.pictures.empty() || m_bench.isBusy())
        return;
    OffscreenRenderer::Surface surface;
    try {
        surface = OffscreenRenderer::makeSurface();
    } catch (const std::exception& error) {
        m_bench.notices.problem(said(messageOf(error)));
        return;
    }
    const auto work = [services = m_bench.services, path = QFile::encodeName(path).toStdString(), recording, line,
                       surface, look = m_bench.viewport.look()](TaskControl& control) {
        OffscreenRenderer offscreen(look, recording.size, surface);
        const auto draw = [&](const FramePointer& frame, double at) {
            return offscreen.draw(frame, recording.hasReadings ? std::optional(at) : std::nullopt);
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
    m_bench.tasks.run<std::size_t>(
        said(Message("RecordingFeature", "Recording %1").with(name.toStdString())), work,
        [this, name](std::size_t pictures) {
            m_bench.notices.note(pictures == 1 ? tr("%1: 1 picture recorded.").arg(name)
                                               : tr("%1: %2 pictures recorded.").arg(name, formatCount(pictures)));
        });
}

} // namespace knead
