#include "io/exact_shapes.h"
#include "io/importer.h"
#include "io/morph/brep_morph.h"
#include "support/space_maps.h"

#include <QtTest>

#include <cstdio>
#include <memory>

using namespace knead;

class MorphCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void table();
};

void MorphCorpusTest::table()
{
    const QString folder = qEnvironmentVariable("KNEAD_CORPUS");
    if (folder.isEmpty())
        QSKIP("no corpus");
    const QStringList files =
        QDir(folder + "/open").entryList({qEnvironmentVariable("KNEAD_FILES", "o*")}, QDir::Files);
    int pairs = 0, good = 0;
    for (const QString& file : files) {
        Model model;
        QElapsedTimer clock;
        try {
            model = importFile((folder + "/open/" + file).toStdString(), {});
        } catch (const std::exception& e) {
            continue;
        }
        std::map<std::pair<const void*, int>, bool> seen;
        for (const Part& part : model.parts) {
            if (!part.exact || !part.valid || !part.watertight)
                continue;
            const auto shapes = shapesFromBytes(*part.exact->bytes);
            const TopoDS_Shape shape = shapes[part.exact->number];
            const Box box = part.box;
            const double size = box.diagonal().norm();
            std::vector<std::pair<const char*, std::unique_ptr<SmoothMap>>> all;
            all.emplace_back("identity", std::make_unique<maps::Identity>());
            all.emplace_back("bend", std::make_unique<maps::Bend>(box, std::numbers::pi / 2));
            all.emplace_back("twist", std::make_unique<maps::Twist>(box, std::numbers::pi / 2));
            all.emplace_back("dent", std::make_unique<maps::Dent>(box.max(), -0.08 * box.sizes(), 0.15 * size));
            for (auto& [name, map] : all) {
                clock.start();
                MorphOptions options{.tolerance = 1e3 * 1e-4 * size};
                const MorphedShape result = morphShape(shape, *map, options);
                int failed = 0, unconverged = 0, poles = 0, kept = 0;
                for (const auto& note : result.notes) {
                    failed += note.kind == MorphedFaceKind::failed;
                    kept += note.kind == MorphedFaceKind::kept;
                    unconverged += !note.converged;
                    poles += note.poles;
                }
                ++pairs;
                good += result.isValid && !failed && !unconverged;
                std::printf("%-34s %-20.20s %-8s %5zu faces %4d kept %s fail %d unconv %d poles %6d tol/asked %8.4f "
                            "wid %d %6.0f ms\n",
                            qPrintable(file), part.name.c_str(), name, result.notes.size(), kept,
                            result.isValid ? "valid " : "INVALID", failed, unconverged, poles,
                            result.largestEdgeTolerance / options.tolerance, result.widenedVertices,
                            1e-6 * clock.nsecsElapsed());
                std::fflush(stdout);
            }
        }
    }
    std::printf("%d of %d\n", good, pairs);
}

QTEST_GUILESS_MAIN(MorphCorpusTest)
#include "morph_corpus_test.moc"
