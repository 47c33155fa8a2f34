#include "io/mesh/corner_normals.h"
#include "io/picture/picture_writer.h"
#include "support/shapes.h"

#include <QImage>
#include <QtTest>

using namespace knead;

namespace {

constexpr Color orange{0.9F, 0.5F, 0.1F};

bool isOrange(QRgb pixel)
{
    return qRed(pixel) > qBlue(pixel) + 40;
}

/// The box of the pixels that show the body.
QRect shownIn(const QImage& image)
{
    QRect shown;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (isOrange(image.pixel(x, y)))
                shown |= QRect(x, y, 1, 1);
    return shown;
}

} // namespace

class PictureWriterTest : public QObject {
    Q_OBJECT

private slots:
    void bodyFillsThePictureInTheMiddle();
    void nearerBodyHidesTheOther();
    void topIsBrighterThanUnderside();
    void sameBodiesGiveSameBytes();
    void normalsAreSharpAcrossCreasesAndSmoothWithin();
    void impossiblePicturesAreRefused();

private:
    QImage draw(const std::vector<MeshBody>& bodies, const PictureOptions& options) const;

    QTemporaryDir m_folder;
};

QImage PictureWriterTest::draw(const std::vector<MeshBody>& bodies, const PictureOptions& options) const
{
    const QString path = m_folder.path() + "/picture.png";
    writePicture(path.toStdString(), bodies, options);
    return QImage(path).convertToFormat(QImage::Format_RGB32);
}

void PictureWriterTest::bodyFillsThePictureInTheMiddle()
{
    const QImage image = draw({{"bar", orange, shapes::box(Vec3(0.16, 0.02, 0.04))}}, {320, 200, Vec3(0, 1, 0)});
    QCOMPARE(image.size(), QSize(320, 200));
    const QRect shown = shownIn(image);
    QVERIFY2(std::abs(shown.width() - 0.82 * 320) <= 3, qPrintable(QString::number(shown.width())));
    QVERIFY(std::abs(shown.height() - 0.25 * shown.width()) <= 2);
    QVERIFY((shown.center() - QPoint(160, 100)).manhattanLength() <= 3);
}

void PictureWriterTest::nearerBodyHidesTheOther()
{
    const Color blue{0.1F, 0.3F, 0.9F};
    const TriangleMesh large = shapes::box(Vec3(0.1, 0.01, 0.1));
    const TriangleMesh small = shapes::moved(shapes::box(Vec3(0.05, 0.01, 0.05)), {Vec3(0, -0.05, 0)});
    const std::vector<MeshBody> bodies{{"small", orange, small}, {"large", blue, large}};
    QVERIFY(isOrange(draw(bodies, {100, 100, Vec3(0, 1, 0)}).pixel(50, 50)));
    QVERIFY(!isOrange(draw(bodies, {100, 100, Vec3(0, -1, 0)}).pixel(50, 50)));
}

void PictureWriterTest::topIsBrighterThanUnderside()
{
    const std::vector<MeshBody> bodies{{"box", orange, shapes::box(Vec3(0.1, 0.1, 0.1))}};
    const QRgb top = draw(bodies, {60, 60, Vec3(0.01, 0.01, -1)}).pixel(30, 30);
    const QRgb underside = draw(bodies, {60, 60, Vec3(0.01, 0.01, 1)}).pixel(30, 30);
    QVERIFY(qGray(top) > qGray(underside) + 10);
}

void PictureWriterTest::sameBodiesGiveSameBytes()
{
    const std::vector<MeshBody> bodies{{"torus", orange, shapes::torus(0.03, 0.01, 60, 30)}};
    QCOMPARE(draw(bodies, {160, 100}), draw(bodies, {160, 100}));
}

void PictureWriterTest::normalsAreSharpAcrossCreasesAndSmoothWithin()
{
    const TriangleMesh box = shapes::box(Vec3(1, 1, 1));
    for (const auto& corners : cornerNormals(box))
        for (const Vec3& normal : corners)
            QVERIFY(std::abs(normal.cwiseAbs().maxCoeff() - 1) < 1e-12);

    const TriangleMesh torus = shapes::torus(1, 0.25, 64, 48);
    const CornerNormals normals = cornerNormals(torus);
    for (std::size_t t = 0; t < torus.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& vertex = torus.vertices[torus.triangles[t][i]];
            const Vec3 middle = Vec3(vertex.x(), vertex.y(), 0).normalized();
            QVERIFY(normals[t][i].dot((vertex - middle).normalized()) > 0.999);
        }
}

void PictureWriterTest::impossiblePicturesAreRefused()
{
    const std::vector<MeshBody> bodies{{"box", orange, shapes::box(Vec3(1, 1, 1))}};
    const std::string path = (m_folder.path() + "/no.png").toStdString();
    QVERIFY_EXCEPTION_THROWN(writePicture(path, {}), std::runtime_error);
    QVERIFY_EXCEPTION_THROWN(writePicture(path, bodies, {0, 100}), std::runtime_error);
    QVERIFY_EXCEPTION_THROWN(writePicture(path, bodies, {100, 100, Vec3::Zero()}), std::runtime_error);
    QVERIFY_EXCEPTION_THROWN(writePicture(path + "/in/no/folder.png", bodies), std::runtime_error);
}

QTEST_GUILESS_MAIN(PictureWriterTest)
#include "picture_writer_test.moc"
