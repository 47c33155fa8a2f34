#pragma once

#include <QFile>
#include <QString>

#include <string>

namespace knead {

/// A path as the file system has it.
inline std::string encoded(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

} // namespace knead
