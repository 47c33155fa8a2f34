#include "ui/recording/picture_feature.h"

#include "core/message/message.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/recording/offscreen_renderer.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

namespace knead {

PictureFeature::PictureFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_action(makeAction(bench.window,
                          {"savePicture", QT_TRANSLATE_NOOP("Actions", "Save &picture..."), nullptr, "Ctrl+Shift+P",
                           QT_TRANSLATE_NOOP("Actions", "Write what the view shows as a picture of any size")}))
{
    bench.availability.needPart({m_action});
    connect(m_action, &QAction::triggered, this, &PictureFeature::ask);
}

PictureFeature::Seen PictureFeature::seen() const
{
    const ViewportWidget& view = m_bench.viewport;
    Seen seen{view.look(), view.shownFrame(), view.window().height};
    if (seen.frame)
        seen.look.content.bodies = seen.frame->filled; // those of the past may have come apart since
    return seen;
}

/// The picture shows what was seen when it was asked for, whatever happens while the dialogs are open.
void PictureFeature::ask()
{
    if (m_bench.document.isEmpty())
        return;
    const QSize size = m_bench.viewport.size() * m_bench.viewport.devicePixelRatioF();
    auto* dialog = new PictureDialog(size, &m_bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, seen = seen()] { askForPlace(dialog->picture(), seen); });
    dialog->open();
}

void PictureFeature::askForPlace(const Picture& picture, const Seen& seen)
{
    const bool isPng = picture.kind == Picture::Kind::png;
    const FileQuestion question{
        .name = "pictureFileDialog",
        .title = tr("Save the picture"),
        .filters = {isPng ? QStringLiteral("PNG (*.png)") : QStringLiteral("JPEG (*.jpg *.jpeg)")},
        .key = "picture/folder",
        .file = m_bench.nameForFile(isPng ? ".png" : ".jpg")};
    askForFileToWrite(m_bench.window, question,
                      [this, picture, seen](const QString& path) { save(path, picture, seen); });
}

void PictureFeature::save(const QString& path, const Picture& wanted, const Seen& seen)
{
    if (!seen.frame || m_bench.isBusy())
        return;
    OffscreenRenderer::Surface surface;
    try {
        surface = OffscreenRenderer::makeSurface();
    } catch (const std::exception& error) {
        m_bench.notices.problem(said(messageOf(error)));
        return;
    }
    Picture picture = wanted;
    picture.kind = kindOfPicture(path, wanted.kind);
    picture.isClear = wanted.isClear && picture.kind == Picture::Kind::png;
    SceneLook look = seen.look;
    look.options.grid = look.options.grid && picture.hasGround;
    const auto work = [services = m_bench.services, path = QFile::encodeName(path).toStdString(), picture, look,
                       frame = seen.frame, scale = picture.size.height() / seen.height, surface,
                       writing = tr("writing the picture").toStdString()](TaskControl& control) {
        OffscreenRenderer offscreen(look, picture.size, surface);
        offscreen.setScale(scale);
        offscreen.showCube(picture.hasCube);
        control.throwIfCancelled();
        const QImage image = picture.isClear ? offscreen.drawClear(frame) : offscreen.draw(frame, {});
        control.throwIfCancelled();
        control.report(0.5, writing); // packing takes about as long as drawing
        services.writeSafely(path,
                             [&](const std::string& pathForNow) { writePicture(image, picture.kind, pathForNow); });
        return true;
    };
    const QString name = QFileInfo(path).fileName();
    m_bench.tasks.run<bool>(
        said(Message("PictureFeature", "Drawing %1").with(name.toStdString())), work,
        [this, name](bool /*isDone*/) { m_bench.notices.note(tr("%1: picture saved.").arg(name)); });
}

} // namespace knead
