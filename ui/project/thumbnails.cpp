#include "ui/project/thumbnails.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <QThreadPool>

namespace knead::thumbnails {

namespace {

constexpr int most = 40;

QDir folder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures");
}

QString pictureOf(const QString& file)
{
    const QByteArray path = QFileInfo(file).absoluteFilePath().toUtf8();
    return QCryptographicHash::hash(path, QCryptographicHash::Sha1).toHex() + ".png";
}

/// The middle of it, as wide for its height as all pictures are.
QImage cut(const QImage& view)
{
    const QImage wide = view.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QImage middle =
        wide.copy(QRect(QPoint((wide.width() - size.width()) / 2, (wide.height() - size.height()) / 2), size));
    middle.setDevicePixelRatio(1);
    return middle.convertToFormat(QImage::Format_RGB32);
}

void write(const QString& name, const QImage& view)
{
    if (!folder().mkpath("."))
        return;
    QSaveFile out(folder().filePath(name));
    if (out.open(QIODevice::WriteOnly) && cut(view).save(&out, "PNG"))
        out.commit();
    const QStringList kept = folder().entryList({"*.png"}, QDir::Files, QDir::Time);
    for (const QString& old : kept.mid(most))
        QFile::remove(folder().filePath(old));
}

} // namespace

QImage of(const QString& file)
{
    const QFileInfo picture(folder().filePath(pictureOf(file)));
    if (!picture.exists() || QFileInfo(file).lastModified() > picture.lastModified())
        return {};
    return QImage(picture.filePath());
}

void keep(const QString& file, const QImage& view)
{
    if (!file.isEmpty() && !view.isNull())
        QThreadPool::globalInstance()->start([name = pictureOf(file), view] { write(name, view); });
}

} // namespace knead::thumbnails
