#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <functional>

namespace knead {

struct Workbench;

/// Asks where to write a table or a report.
/// @param ending of the name that is proposed, after that of the part
void askForTextFile(const Workbench& bench, const QString& title, const QString& ending, const QStringList& filters,
                    std::function<void(const QString& path)> then);

/// Writes a file in the background, whole or not at all, and says so; nothing while something else is done.
/// @param bytes what is written; called there
void writeTextFile(const Workbench& bench, const QString& path, std::function<QByteArray()> bytes);

} // namespace knead
