#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/aggregate/spacing_choice.h"
#include "core/geometry/mass_properties.h"
#include "core/skin/fragments.h"
#include "io/importer.h"
#include "support/skip.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

// Breaks every closed solid of the folder of CAD files that KNEAD_CORPUS names into pieces around five places.

namespace {

constexpr double cellsAlong = 40;

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

class FragmentsCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void brokenSolidsAreClosed_data();
    void brokenSolidsAreClosed();

private:
    static void checkPart(const Part& part);
};

void FragmentsCorpusTest::brokenSolidsAreClosed_data()
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

void FragmentsCorpusTest::brokenSolidsAreClosed()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const Model model = importFile(path.toStdString());
    for (const Part& part : model.parts)
        if (part.canBeFilled() && !QTest::currentTestFailed())
            checkPart(part);
}

void FragmentsCorpusTest::checkPart(const Part& part)
{
    const FillingSize size = sizeOf(part.mesh);
    const Aggregate aggregate =
        fill(part.mesh, {.spacing = spacingFor({SpacingChoice::Kind::CellsAlong, cellsAlong}, size)});
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

QTEST_GUILESS_MAIN(FragmentsCorpusTest)
#include "fragments_corpus_test.moc"
