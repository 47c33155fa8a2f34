#include "ui/frame/text_files.h"

#include "ui/dialogs/file_question.h"
#include "ui/frame/notices.h"
#include "ui/frame/workbench.h"
#include "ui/language/said.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

#include <stdexcept>

namespace knead {

namespace {

struct TextFiles {
    Q_DECLARE_TR_FUNCTIONS(TextFiles)
};

/// @param path that is told to the person; `pathForNow` is written to
void write(const QByteArray& bytes, const std::string& pathForNow, const QString& path)
{
    QFile file(QFile::decodeName(pathForNow.c_str()));
    if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        throw Problem(
            Message("TextFiles", "%1 cannot be written (%2). Choose another folder, or make room on the disk.")
                .with(path.toStdString(), file.errorString().toStdString()));
}

} // namespace

void askForTextFile(const Workbench& bench, const QString& title, const QString& ending, const QStringList& filters,
                    std::function<void(const QString& path)> then)
{
    const FileQuestion question{.name = "textFileDialog",
                                .title = title,
                                .filters = filters,
                                .key = "exportFolder",
                                .folder = {},
                                .file = bench.nameForFile(ending)};
    askForFileToWrite(bench.window, question, std::move(then));
}

void writeTextFile(const Workbench& bench, const QString& path, std::function<QByteArray()> bytes)
{
    if (bench.isBusy())
        return;
    bench.notices.hide();
    const auto work = [services = bench.services, path, bytes = std::move(bytes)](TaskControl&) {
        services.writeSafely(QFile::encodeName(path).toStdString(),
                             [&](const std::string& pathForNow) { write(bytes(), pathForNow, path); });
        return true;
    };
    bench.tasks.run<bool>(
        said(Message("TextFiles", "Writing %1").with(QFileInfo(path).fileName().toStdString())), work,
        [&notices = bench.notices, path](bool) { notices.note(TextFiles::tr("Written: %1.").arg(path)); });
}

} // namespace knead
