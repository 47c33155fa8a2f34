#include "ui/dialogs/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace knead::recent_files {

namespace {

constexpr const char* key = "recentFiles";

} // namespace

QStringList list()
{
    return QSettings().value(key).toStringList();
}

void add(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList paths = list();
    paths.removeAll(absolute);
    paths.prepend(absolute);
    QSettings().setValue(key, QStringList(paths.mid(0, most)));
}

void remove(const QString& path)
{
    QStringList paths = list();
    paths.removeAll(QFileInfo(path).absoluteFilePath());
    QSettings().setValue(key, paths);
}

void clear()
{
    QSettings().remove(key);
}

} // namespace knead::recent_files
