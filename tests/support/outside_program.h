#pragma once

#include "support/skip.h"
#include "support/workshop.h"

#include <QStandardPaths>

/// Programs of the system that look at what Knead writes.
namespace workshop {

inline bool isThere(const char* program)
{
    return !QStandardPaths::findExecutable(program).isEmpty();
}

/// Runs a program in a folder; what it says in English.
inline Outcome outside(const QString& program, const QStringList& arguments, const QString& folder,
                       QProcessEnvironment environment = serverEnvironment())
{
    environment.insert("LC_ALL", "C.UTF-8");
    environment.insert("HOME", folder);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    process.start(program, arguments);
    if (!process.waitForFinished(programPatience) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

} // namespace workshop

/// For a test that needs one of them: packages.txt has them all.
#define KNEAD_NEEDS_PROGRAM(program)                                                                                   \
    if (!workshop::isThere(program))                                                                                   \
    KNEAD_SKIP_WITHOUT("tools", program " is missing; ./dev setup installs it.")
