#pragma once

#include "support/outside_program.h"

#include <QFile>

/// The build that a test is of.
namespace workshop {

inline QString buildFolder()
{
    return QFileInfo(KNEAD_PROGRAM).dir().absoluteFilePath("..");
}

/// What it was configured with; empty: nothing.
inline QByteArray buildSetting(const char* name)
{
    QFile cache(QDir(buildFolder()).filePath("CMakeCache.txt"));
    if (cache.open(QIODevice::ReadOnly))
        for (const QByteArray& line : cache.readAll().split('\n'))
            if (line.startsWith(QByteArray(name) + ':'))
                return line.mid(line.indexOf('=') + 1);
    return {};
}

/// Installs what was built: the program, or one component of what there is besides.
inline Outcome installInto(const QString& folder, const QStringList& more, const QString& home)
{
    return outside("cmake", QStringList{"--install", buildFolder(), "--prefix", folder} + more, home);
}

} // namespace workshop
