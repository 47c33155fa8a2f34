#include "gallery/gallery.h"
#include "support/deep.h"

#include <QDir>
#include <QImage>
#include <QSet>
#include <QTemporaryDir>
#include <QtTest>

using namespace knead;

namespace {

constexpr int fewestColors = 300;
constexpr double mostVolumeError = 1e-3;
const QString folder = KNEAD_RESOURCES "/gallery";

/// How much coarser the lattice is than that of the recipe: 1.5 takes a fourth of the time.
double coarserFor(const std::string& name)
{
    if (name == "bent-bracket" || name == "stamped-cake")
        return 1; // with fewer cells steel breaks where it bends, and clay folds over itself at the rays of the star
    if (name == "twisted-handle")
        return 1.2;
    return 1.5;
}

int colorsIn(const QImage& picture)
{
    QSet<QRgb> colors;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            colors.insert(picture.pixel(x, y));
    return static_cast<int>(colors.size());
}

} // namespace

/// The recipes of the gallery, with coarser lattices.
class GalleryTest : public QObject {
    Q_OBJECT

private slots:
    void piecesAreSoundAndSmooth_data();
    void piecesAreSoundAndSmooth();
    void pageShowsAllPieces();

private:
    QTemporaryDir m_out;
    std::vector<nlohmann::ordered_json> m_pieces;
};

void GalleryTest::piecesAreSoundAndSmooth_data()
{
    QTest::addColumn<int>("index");
    const std::vector<gallery::Piece> pieces = gallery::read(folder);
    for (std::size_t i = 0; i < pieces.size();
         i += loadOf<std::size_t>(3, 1)) // four of them are one of each kind of work
        QTest::newRow(pieces[i].name.c_str()) << static_cast<int>(i);
}

void GalleryTest::piecesAreSoundAndSmooth()
{
    QFETCH(int, index);
    const gallery::Piece piece = gallery::read(folder).at(static_cast<std::size_t>(index));
    m_pieces.push_back(gallery::carryOut(KNEAD_PROGRAM, piece, folder, m_out.path(), coarserFor(piece.name)));
    const nlohmann::ordered_json& came = m_pieces.back();
    QVERIFY2(gallery::isGood(came), came.dump().c_str());
    QVERIFY2(std::abs(came.at("volume_error").get<double>()) < mostVolumeError, came.dump().c_str());
    QVERIFY(QFile::exists(m_out.filePath(QString::fromStdString(came.at("step").get<std::string>()))));
    QImage before(m_out.filePath(QString::fromStdString(came.at("before").get<std::string>())));
    QImage after(m_out.filePath(QString::fromStdString(came.at("after").get<std::string>())));
    QCOMPARE(before.size(), QSize(960, 600));
    QCOMPARE(after.size(), QSize(960, 600));
    QVERIFY(colorsIn(before) > fewestColors);
    QVERIFY(colorsIn(after) > fewestColors);
    QVERIFY(before != after);
}

/// Of what the function before made.
void GalleryTest::pageShowsAllPieces()
{
    const QString page = QString::fromStdString(gallery::pageOf(m_pieces));
    const auto count = static_cast<qsizetype>(m_pieces.size());
    QCOMPARE(count, loadOf(4, 10));
    QCOMPARE(page.count("<section"), count);
    QCOMPARE(page.count("<img"), 2 * count);
    QCOMPARE(page.count(">STEP</a>"), count);
    QVERIFY(!page.contains("class='fault'"));
}

QTEST_GUILESS_MAIN(GalleryTest)
#include "gallery_test.moc"
