#include "ui/recording/picture.h"

#include "ui/recording/sentence.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>

namespace knead {

namespace {

constexpr int jpegQuality = 92; // of 100: nothing is seen of what is left out

struct PictureWords {
    Q_DECLARE_TR_FUNCTIONS(Picture)
};

} // namespace

void writePicture(const QImage& image, Picture::Kind kind, const std::string& path)
{
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QImageWriter writer(&bytes, kind == Picture::Kind::png ? "png" : "jpeg");
    if (kind == Picture::Kind::jpeg)
        writer.setQuality(jpegQuality);
    if (!writer.write(image))
        failWith(PictureWords::tr("The picture cannot be written in this format (%1). Choose another one.")
                     .arg(writer.errorString()));
    QFile file(QFile::decodeName(path.c_str()));
    const bool isOpen = file.open(QIODevice::WriteOnly);
    if (!isOpen || file.write(bytes.data()) != bytes.size() || !file.flush())
        failWith(PictureWords::tr("The picture cannot be written in %1 (%2). Free some room, or choose another place.")
                     .arg(QFileInfo(file).absolutePath(), file.errorString()));
}

Picture::Kind kindOfPicture(const QString& path, Picture::Kind otherwise)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == "png")
        return Picture::Kind::png;
    return ending == "jpg" || ending == "jpeg" ? Picture::Kind::jpeg : otherwise;
}

} // namespace knead
