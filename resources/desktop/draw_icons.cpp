// Draws an SVG as PNGs for those who show icons: draw_icons PICTURE.svg FILE.png SIZE [FILE.png SIZE ...], sizes in pixels.
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <cstdio>

namespace {

bool draw(QSvgRenderer& picture, const QString& file, int size)
{
    QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    picture.render(&painter);
    painter.end();
    return image.save(file, "PNG");
}

} // namespace

int main(int argc, char** argv)
{
    QSvgRenderer picture(QString::fromLocal8Bit(argc > 1 ? argv[1] : ""));
    bool isDrawn = picture.isValid();
    for (int i = 2; isDrawn && i + 1 < argc; i += 2)
        isDrawn = draw(picture, QString::fromLocal8Bit(argv[i]), QByteArray(argv[i + 1]).toInt());
    if (!isDrawn)
        std::fprintf(stderr, "draw_icons: %s cannot be drawn\n", argc > 1 ? argv[1] : "what is not named");
    return isDrawn ? 0 : 1;
}
