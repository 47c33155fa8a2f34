#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/aggregate/spacing_choice.h"
#include "core/geometry/mass_properties.h"
#include "core/skin/fragments.h"
#include "io/importer.h"
#include "support/deep.h"
#include "support/skip.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace knead;

// Fills every closed solid of the folder of CAD files that KNEAD_CORPUS names: with 30 cells along the longest edge, and
// with two cells across the thinnest wall where that is finer. Then breaks it into pieces around five places. One test does both,
// since it takes longer to read some of the files.

namespace {

constexpr double cellsAlong = 30;
constexpr double cellsAcrossWall = 2;
constexpr double cellsAlongBroken = 40;
constexpr double mostObjects = 100'000;
constexpr double mostObjectsDeep = 300'000;

/// Its faces overlap by up to 0.06 mm: the volume is not known better than to a percent.
const std::set<std::string> uncertainVolume{"o24_axom_boxed_sphere_cm.step"};

QString percent(double share)
{
    return QString::number(100 * share, 'g', 3) + " %";
}

std::vector<BrokenConnection> brokenAround(const Aggregate& aggregate, const Box& box)
{
    const Vec3 shares[] = {{0.2, 0.3, 0.6}, {0.8, 0.25, 0.3}, {0.45, 0.8, 0.4}, {0.6, 0.5, 0.9}, {0.4, 0.45, 0.1}};
    const auto nearest = [&](const Vec3& X) {
        const auto distance = [&](const Vec3& share) {
            return (box.min() + share.cwiseProduct(box.sizes()) - X).norm();
        };
        return std::min_element(std::begin(shares), std::end(shares),
                                [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); }) -
               std::begin(shares);
    };
    std::vector<BrokenConnection> broken;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex o = segment.begin; o < segment.end; ++o)
                if (aggregate.weight[d][o] > 0 &&
                    nearest(aggregate.lattice.position(o)) !=
                        nearest(aggregate.lattice.position(o + static_cast<ObjectIndex>(segment.offset))))
                    broken.push_back({d, o});
    return broken;
}

} // namespace

class FillCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void closedSolidsFillAndBreak_data();
    void closedSolidsFillAndBreak();

private:
    static void checkPart(const Part& part, bool isCertain);
    static void checkFilling(const Part& part, double spacing, double bound);
    static void checkFragments(const Part& part);
};

void FillCorpusTest::closedSolidsFillAndBreak_data()
{
    QTest::addColumn<QString>("path");
    const QString corpus = qEnvironmentVariable("KNEAD_CORPUS");
    const QDir folder(corpus + "/open");
    if (!corpus.isEmpty())
        for (const QString& file : folder.entryList({"o[0-9]*"}, QDir::Files, QDir::Name))
            QTest::newRow(qPrintable(file)) << folder.filePath(file);
    else
        QTest::newRow("no corpus") << QString();
}

void FillCorpusTest::closedSolidsFillAndBreak()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const Model model = importFile(path.toStdString());
    std::size_t open = 0;
    for (const Part& part : model.parts) {
        if (part.canBeFilled())
            checkPart(part, !uncertainVolume.contains(QFileInfo(path).fileName().toStdString()));
        else
            ++open;
        if (part.canBeFilled() && !QTest::currentTestFailed())
            checkFragments(part);
        if (QTest::currentTestFailed())
            return;
    }
    if (open == model.parts.size())
        QSKIP("no closed solid in it");
    if (open > 0)
        qInfo("%zu of %zu parts are open, so they are not filled", open, model.parts.size());
}

void FillCorpusTest::checkPart(const Part& part, bool isCertain)
{
    const double bound = isCertain ? 1e-3 : 1e-2;
    const FillingSize size = sizeWithWalls(part.mesh);
    QVERIFY2(size.thinnestWall > 0 && size.thinnestWall <= size.box.diagonal().norm(), part.path.c_str());
    const double coarse = spacingFor({SpacingChoice::Kind::CellsAlong, cellsAlong}, size);
    const double fine = spacingFor({SpacingChoice::Kind::CellsAcrossWall, cellsAcrossWall}, size);
    if (fine >= coarse) {
        checkFilling(part, coarse, bound);
        return;
    }
    const double finest = spacingFor({SpacingChoice::Kind::Objects, loadOf(mostObjects, mostObjectsDeep)}, size);
    if (fine < finest)
        qInfo("%s: two cells across its wall of %.3g mm would be %.2g objects; filled with %.2g cells across",
              part.path.c_str(), 1000 * size.thinnestWall, estimatedObjects(size, fine), size.thinnestWall / finest);
    checkFilling(part, std::max(fine, finest), bound);
}

void FillCorpusTest::checkFilling(const Part& part, double spacing, double bound)
{
    const Aggregate aggregate = fill(part.mesh, {.spacing = spacing});
    const double error = aggregate.filledVolume / part.volume - 1;
    const QString what = QString("%1: volume off by %2").arg(part.path.c_str(), percent(error));
    QVERIFY2(std::abs(error) <= bound, qPrintable(what));
    // The cells hold what the triangles bound, whatever those are worth.
    QVERIFY2(std::abs(aggregate.filledVolume / aggregate.meshVolume - 1) < 1e-9, qPrintable(what));
    for (const std::uint32_t face : aggregate.face)
        QVERIFY(face == Aggregate::noFace || face < part.faces.size());
}

void FillCorpusTest::checkFragments(const Part& part)
{
    const FillingSize size = sizeOf(part.mesh);
    const Aggregate aggregate =
        fill(part.mesh, {.spacing = spacingFor({SpacingChoice::Kind::CellsAlong, cellsAlongBroken}, size)});
    const std::vector<BrokenConnection> broken = brokenAround(aggregate, size.box);
    QElapsedTimer timer;
    timer.start();
    const std::vector<Fragment> fragments = fragmentsOf(aggregate, part.mesh, broken);
    const auto milliseconds = timer.elapsed();
    const double whole = massProperties(part.mesh).volume;
    const double cell = std::pow(aggregate.lattice.spacing, 3);
    double sum = 0;
    double worst = 0;
    std::size_t uncut = 0;
    for (const Fragment& fragment : fragments) {
        QVERIFY2(isWatertight(fragment.mesh), part.path.c_str());
        QVERIFY2(fragment.volume > 0, part.path.c_str());
        sum += fragment.volume;
        uncut += fragment.isUncut ? 1 : 0;
        double volume = 0;
        for (const auto& objects : {fragment.objects, fragment.dust})
            for (const ObjectIndex object : objects)
                volume += aggregate.volume[object];
        worst = std::max(worst, std::abs(fragment.volume - volume) / aggregate.filledVolume);
    }
    qInfo("%s: %zu triangles, %zu objects, %.0f cells of material, %zu fragments in %lld ms, %zu uncut, shares off by "
          "%.4f",
          part.path.c_str(), part.mesh.triangles.size(), aggregate.size(), whole / cell, fragments.size(),
          static_cast<long long>(milliseconds), uncut, worst);
    QVERIFY2(std::abs(sum / whole - 1) < 1e-9, qPrintable(QString::number(sum / whole - 1)));
    QCOMPARE(uncut, std::size_t{0});
}

QTEST_GUILESS_MAIN(FillCorpusTest)
#include "fill_corpus_test.moc"
