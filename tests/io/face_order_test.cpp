#include "core/simulation/first_press.h"
#include "core/simulation/simulation.h"
#include "io/brep/exact_shapes.h"
#include "io/brep/occt_session.h"
#include "io/export/bent_faces.h"
#include "io/export/export_check.h"
#include "io/export/face_order.h"
#include "support/export_jobs.h"
#include "support/hard_parts.h"
#include "support/space_maps.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <QtTest>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

using namespace knead;
using namespace export_jobs;

namespace {

/// As a program sees it that reads with OpenCASCADE and mends nothing [mm^3].
double volumeAsRead(const ExportedFile& file)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("out.step");
    QFile out(path);
    if (!out.open(QIODevice::WriteOnly) ||
        out.write(file.bytes.data(), static_cast<qint64>(file.bytes.size())) != static_cast<qint64>(file.bytes.size()))
        return 0;
    out.close();
    const OcctSession session;
    STEPControl_Reader reader;
    if (reader.ReadFile(path.toUtf8().constData()) != IFSelect_RetDone)
        return 0;
    reader.TransferRoots();
    GProp_GProps properties;
    BRepGProp::VolumeProperties(reader.OneShape(), properties);
    return properties.Mass();
}

/// A part in soft rubber after its first press.
PartToExport pressed(const Model& model)
{
    const Part& part = model.parts.front();
    const FirstPress press = firstPress(model);
    PartToExport out{.part = part};
    out.aggregate = std::make_shared<const Aggregate>(
        fill(part.mesh, {.spacing = spacingForObjectCount(part.mesh, static_cast<std::size_t>(press.objects))}));
    Material rubber;
    rubber.density = 1100;
    rubber.youngsModulus = 1e6;
    rubber.poissonRatio = 0.35;
    Scene scene;
    scene.bodies.push_back({.name = part.name, .aggregate = out.aggregate, .material = rubber});
    scene.fixtures.push_back({.name = "end", .objects = objectsInBox(*out.aggregate, press.held)});
    scene.manipulators.push_back(press.block);
    scene.integrator = Integrator::automatic;
    Simulation simulation(std::move(scene));
    while (simulation.snapshot()->time < press.duration && simulation.health().ok)
        simulation.step();
    out.displacements = simulation.snapshot()->bodies[0].displacements();
    return out;
}

class FaceOrderTest : public QObject {
    Q_OBJECT

private slots:
    void putsAnotherFaceFirst();
    void facesAreFoundInAnotherOrder();
    void facesThatCameBackInAnotherOrderAreCompared();
    void springsAreReadAsTheyAre();
};

void FaceOrderTest::putsAnotherFaceFirst()
{
    const OcctSession session;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    TopTools_IndexedMapOfShape before;
    TopExp::MapShapes(box, TopAbs_FACE, before);
    for (const std::size_t first : {0, 2, 7}) {
        const OrderedShape ordered = withFaceFirst(box, first);
        QCOMPARE(ordered.shape.ShapeType(), TopAbs_SOLID);
        QVERIFY(BRepCheck_Analyzer(ordered.shape).IsValid());
        TopTools_IndexedMapOfShape after;
        TopExp::MapShapes(ordered.shape, TopAbs_FACE, after);
        QCOMPARE(ordered.order.size(), std::size_t{6});
        QCOMPARE(ordered.order.front(), static_cast<std::uint32_t>(first % 6));
        for (int i = 1; i <= 6; ++i)
            QVERIFY(after(i).IsEqual(before(static_cast<int>(ordered.order[static_cast<std::size_t>(i) - 1]) + 1)));
    }
}

void FaceOrderTest::facesAreFoundInAnotherOrder()
{
    const OcctSession session;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const OrderedShape ordered = withFaceFirst(box, 2);
    QVERIFY(orderReadBack(box, ordered.shape, 1e-3) == ordered.order);
    QVERIFY(orderReadBack(box, box, 1e-3) == withFaceFirst(box, 0).order);
    // One that lies elsewhere takes the place that is left.
    const TopoDS_Shape longer = withFaceFirst(BRepPrimAPI_MakeBox(1, 2, 3.5).Shape(), 2).shape;
    QVERIFY(orderReadBack(box, longer, 1e-3) == ordered.order);
    QVERIFY(orderReadBack(box, TopExp_Explorer(box, TopAbs_FACE).Current(), 1e-3).empty());
}

/// As where OpenCASCADE turned a face: those beside it come in another order, and are the same faces all the same.
void FaceOrderTest::facesThatCameBackInAnotherOrderAreCompared()
{
    const Model model = example("bracket.step");
    ExportJob job = jobOf(model, nullptr);
    PartToExport& part = job.parts.front();
    job.tree = {};
    job.tree.children.push_back({part.part.name, 0, {}});
    part.map = std::make_shared<maps::Twist>(part.part.box, 0.3);
    for (std::size_t i = 0; i < part.part.faces.size(); ++i)
        part.part.faces[i] = {.color = Color{0, i % 2 == 0 ? 1.0F : 0.0F, 0},
                              .name = std::string("Seat ") + static_cast<char>('A' + i)};
    std::vector<ReadyPart> written;
    std::string bytes;
    {
        const OcctSession session;
        const TopoDS_Shape shape = shapesFromBytes(*part.part.exact->bytes)[part.part.exact->number];
        written.push_back(makeReady(part, shape, job.options, {}, TaskControl::none()));
        bytes = writeCad(FormatKind::Step, {written.front().out}, job.tree, job.options, TaskControl::none());
        putFaceFirst(part.part, 3, written.front());
    }
    ExportedFile file;
    file.bytes = bytes;
    const Model back = readBack(file, "step");
    const OcctSession session;
    QVERIFY(checkWritten(written, back, TaskControl::none()).empty());
    const PartExportReport& report = written.front().report;
    QVERIFY2(report.largestDeviation <= report.tolerance, qPrintable(QString::number(report.largestDeviation)));
    QVERIFY(report.isSound());
    QVERIFY(report.colorsKept);
    QVERIFY2(report.remarks.empty(), report.remarks.empty() ? "" : report.remarks.front().english().c_str());
}

/// Faces that are long and wound: rays graze them.
void FaceOrderTest::springsAreReadAsTheyAre()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("spring.brep").toStdString();
    {
        const OcctSession session;
        QVERIFY(BRepTools::Write(hard_shapes::spring(4, 2, 0.8, 0), path.c_str()));
    }
    const Model model = importFile(path);
    ExportJob job = jobOf(model, nullptr);
    job.parts.front() = pressed(model);
    job.parts.front().part.faces.front().color = Color{1, 0, 0};
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = file.report.parts.front();
    QCOMPARE(part.form, PartExportReport::Form::exact);
    QVERIFY(part.isSound());
    QVERIFY(part.colorsKept);
    QVERIFY(std::abs(volumeAsRead(file) / (1e9 * part.skinVolume) - 1) < 2e-3);
}

} // namespace

QTEST_GUILESS_MAIN(FaceOrderTest)
#include "face_order_test.moc"
