// Asks for the name of a file.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace knead {

/// What is asked. The folder of the answer is remembered in the settings; where none is yet, that of what was opened last is
/// proposed, or the person's own.
struct FileQuestion {
    QString name;        ///< of the dialog as an object
    QString title;       ///< of the dialog
    QStringList filters; ///< "STEP (*.step *.stp)", the chosen one first
    QString key;         ///< of the folder in the settings
    QString folder;      ///< proposed in place of the one remembered; empty: none
    QString file;        ///< proposed, without its folder
};

/// "step" of "STEP (*.step *.stp)"; empty where the filter takes every name.
QString endingOf(const QString& filter);

/// Asks where to write, and before a file is replaced. A name without an ending gets that of the filter. Returns at once; what
/// comes then is an event of its own, after the dialog is gone, and not at all where it was given up.
void askForFileToWrite(QWidget& parent, const FileQuestion& question, std::function<void(const QString& path)> then);

/// Asks for files that are there, one or more. As askForFileToWrite().
void askForFilesToRead(QWidget& parent, const FileQuestion& question,
                       std::function<void(const QStringList& paths)> then);

} // namespace knead
