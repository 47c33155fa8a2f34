#include "core/aggregate/fill.h"
#include "io/export/exporter.h"
#include "io/importer.h"
#include "support/space_maps.h"

#include <QtTest>

#include <numbers>

using namespace knead;

namespace {

/// All closed parts of a model, each point of their material where a map takes it.
ExportJob jobOf(const Model& model, const SmoothMap* map, double cells = 24)
{
    ExportJob job;
    job.tree = model.tree;
    for (const Part& part : model.parts) {
        PartToExport out{.part = part, .density = 1000};
        if (map != nullptr && part.canBeFilled()) {
            out.aggregate = std::make_shared<const Aggregate>(
                fill(part.mesh, {.spacing = spacingForCellsAcross(part.mesh, cells)}));
            for (ObjectIndex i = 0; i < out.aggregate->size(); ++i) {
                const Vec3 at = out.aggregate->lattice.position(i);
                out.displacements.push_back(map->at(at) - at);
            }
        }
        job.parts.push_back(std::move(out));
    }
    return job;
}

} // namespace

class ExporterTest : public QObject {
    Q_OBJECT
private slots:
    void probe()
    {
        const QString file = qEnvironmentVariable("PROBE");
        if (file.isEmpty())
            QSKIP("none");
        QElapsedTimer clock;
        clock.start();
        const Model model = importFile(file.toStdString(), {});
        std::printf("import %lld ms\n", clock.restart());
        Box box;
        for (const Part& part : model.parts)
            box.extend(part.box);
        const maps::Bend map(box, std::numbers::pi / 2);
        const ExportJob job = jobOf(model, qEnvironmentVariableIsSet("STILL") ? nullptr : &map);
        std::printf("fill %lld ms, %zu objects\n", clock.restart(), job.parts[0].displacements.size());
        const ExportedFile out = exportCad(FormatKind::Step, job, TaskControl::none());
        std::printf("export %lld ms\n", clock.restart());
        for (const std::string& line : linesOf(out.report))
            std::printf("%s\n", line.c_str());
        QFile result("/tmp/probe.step");
        QVERIFY(result.open(QIODevice::WriteOnly));
        result.write(out.bytes.data(), static_cast<qint64>(out.bytes.size()));
    }
};

QTEST_GUILESS_MAIN(ExporterTest)
#include "exporter_test.moc"
