#include "ui/dialogs/file_question.h"

#include "ui/dialogs/recent_files.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QHeaderView>
#include <QLocale>
#include <QSettings>
#include <QTreeView>

namespace knead {

namespace {

constexpr QSize leastDialog(860, 540); // [pixels]
constexpr int columnMargin = 24;       // around a text [pixels]

/// Names get what there is, and sizes, kinds and dates what they take: Qt's columns are as wide as in the smallest
/// dialog.
void makeColumnsWide(QFileDialog& dialog)
{
    auto* list = dialog.findChild<QTreeView*>("treeView");
    if (list == nullptr) // a dialog of the system
        return;
    const QFontMetrics metrics = list->fontMetrics();
    QHeaderView* header = list->header();
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(metrics.horizontalAdvance(QStringLiteral("1000.00 MiB")) + columnMargin);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
    const QString date = QLocale::system().toString(QDateTime({2020, 12, 28}, {22, 58}), QLocale::ShortFormat);
    const QString texts[] = {{}, "1000.00 MiB", "knead File Folder", date};
    for (int column = 1; column < header->count() && column < 4; ++column) {
        header->setSectionResizeMode(column, QHeaderView::Interactive);
        header->resizeSection(column, metrics.horizontalAdvance(texts[column]) + columnMargin);
    }
    dialog.resize(dialog.size().expandedTo(leastDialog));
}

/// Where files are written and read until a person says otherwise: beside what was opened last, if that is a place of their own.
QString folderOfLastFile()
{
    const QStringList files = recent_files::list();
    const QFileInfo folder(files.isEmpty() ? QString() : QFileInfo(files.front()).absolutePath());
    return folder.isDir() && folder.isWritable() ? folder.absoluteFilePath() : QDir::homePath();
}

QFileDialog* makeDialog(QWidget& parent, const FileQuestion& question)
{
    const QSettings settings;
    QString last = settings.value(question.key, settings.value("folder")).toString();
    if (last.isEmpty())
        last = folderOfLastFile();
    // Qt's own dialog asks the system to watch each folder, which takes 20 to 50 ms where many names were ever looked up in it. It
    // begins with a small one, or it would begin with the last one there was.
    auto* dialog = new QFileDialog(&parent, question.title, QDir::rootPath());
    if (auto* files = dialog->findChild<QFileSystemModel*>())
        files->setOption(QFileSystemModel::DontWatchForChanges);
    dialog->setDirectory(question.folder.isEmpty() ? last : question.folder);
    dialog->setObjectName(question.name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilters(question.filters);
    makeColumnsWide(*dialog);
    return dialog;
}

void remember(const QString& key, const QString& path)
{
    QSettings().setValue(key, QFileInfo(path).absolutePath());
}

} // namespace

QString endingOf(const QString& filter)
{
    const qsizetype begin = filter.indexOf(QStringLiteral("*."));
    if (begin < 0)
        return {};
    qsizetype end = begin + 2;
    while (end < filter.size() && filter[end].isLetterOrNumber())
        ++end;
    return filter.sliced(begin + 2, end - begin - 2);
}

void askForFileToWrite(QWidget& parent, const FileQuestion& question, std::function<void(const QString&)> then)
{
    QFileDialog* dialog = makeDialog(parent, question);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setFileMode(QFileDialog::AnyFile);
    dialog->selectFile(question.file);
    const auto useEnding = [dialog](const QString& filter) { dialog->setDefaultSuffix(endingOf(filter)); };
    useEnding(dialog->selectedNameFilter());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, useEnding);
    QObject::connect(
        dialog, &QFileDialog::fileSelected, &parent,
        [key = question.key, then = std::move(then)](const QString& path) {
            remember(key, path);
            then(path);
        },
        Qt::QueuedConnection);
    dialog->open();
}

void askForFilesToRead(QWidget& parent, const FileQuestion& question, std::function<void(const QStringList&)> then)
{
    QFileDialog* dialog = makeDialog(parent, question);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    QObject::connect(
        dialog, &QFileDialog::filesSelected, &parent,
        [key = question.key, then = std::move(then)](const QStringList& paths) {
            remember(key, paths.front());
            then(paths);
        },
        Qt::QueuedConnection);
    dialog->open();
}

} // namespace knead
