#include "core/deformation/number_deformation.h"
#include "io/brep/exact_shapes.h"
#include "io/export/plane_division.h"
#include "io/morph/brep_morph.h"
#include "support/export_jobs.h"
#include "support/skip.h"
#include "support/space_maps.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <QtTest>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace knead;
using namespace export_jobs;

namespace {

constexpr double pi = std::numbers::pi;

/// Of the example's tube: 20 x 2 mm, 200 mm along x, bent between 50 and 150 mm.
NumberDeformation quarterBend()
{
    return {.kind = NumberKind::bend, .from = 0.05, .to = 0.15, .angle = pi / 2};
}

ExportedFile exported(const Model& model, const std::vector<Deformation>& deformations)
{
    ExportJob job = jobOf(model, nullptr);
    const auto list = std::make_shared<const std::vector<Deformation>>(deformations);
    for (PartToExport& part : job.parts)
        part.deformations = list;
    return exportCad(FormatKind::Step, job, TaskControl::none());
}

TopoDS_Shape shapeIn(const ExportedFile& file)
{
    QTemporaryDir folder;
    QFile out(folder.filePath("out.step"));
    out.open(QIODevice::WriteOnly);
    out.write(file.bytes.data(), static_cast<qint64>(file.bytes.size()));
    out.close();
    STEPControl_Reader reader;
    reader.ReadFile(qPrintable(out.fileName()));
    reader.TransferRoots();
    return reader.OneShape();
}

/// How many faces there are of each kind.
std::map<GeomAbs_SurfaceType, int> formsOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::map<GeomAbs_SurfaceType, int> forms;
    for (int i = 1; i <= faces.Extent(); ++i)
        ++forms[GeomAdaptor_Surface(BRep_Tool::Surface(TopoDS::Face(faces(i)))).GetType()];
    return forms;
}

std::vector<gp_Torus> toriOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<gp_Torus> tori;
    for (int i = 1; i <= faces.Extent(); ++i)
        if (const GeomAdaptor_Surface surface(BRep_Tool::Surface(TopoDS::Face(faces(i))));
            surface.GetType() == GeomAbs_Torus)
            tori.push_back(surface.Torus());
    return tori;
}

/// 10 mm each way, with a hole of radius 2 mm through its middle; the seam of that is at x = 7.
TopoDS_Shape boredCube()
{
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
    const gp_Ax2 axis(gp_Pnt(5, 5, 0), gp::DZ());
    return BRepAlgoAPI_Cut(cube, BRepPrimAPI_MakeCylinder(axis, 2, 10).Shape()).Shape();
}

void tell(const ExportedFile& file)
{
    for (const std::string& line : linesOf(file.report))
        qInfo("%s", line.c_str());
}

} // namespace

class NumberDeformationTest : public QObject {
    Q_OBJECT
private slots:
    void aTubeBendsIntoTori();
    void aBarBendsIntoCylindersAndPlanes();
    void aTubeThatTapersGetsCones();
    void aTwistedTubeKeepsItsVolume();
    void whatIsStretchedStaysWhatItIs();
    void aBendBackGivesTheTubeBack();
    void whatEasesIsNotDivided();
    void facesAreDividedOnlyWherePlanesGoThrough();
    void piecesThatShareASurfaceStayFit();
    void facesThatMissThePlaneTheyLieInAreDivided();
    void anEdgeThatLiesAPeriodAwayIsBroughtBack();
};

/// Pappus: the volume is the area of the section times the way of its center, which keeps its length.
void NumberDeformationTest::aTubeBendsIntoTori()
{
    const Model model = example("tube.step");
    const ExportedFile file = exported(model, {quarterBend()});
    tell(file);
    QVERIFY(file.report.isSound());
    const PartExportReport& report = file.report.parts.front();
    const double volume = pi * (0.01 * 0.01 - 0.008 * 0.008) * 0.2;
    QVERIFY2(std::abs(report.volume / volume - 1) < 1e-9, qPrintable(QString::number(report.volume / volume - 1)));
    QCOMPARE(report.facesBefore, 4);
    QCOMPARE(report.facesAfter, 8); // two cylinders came in three pieces each
    QVERIFY(report.remarks.front().english().find("2 faces were divided at the planes") != std::string::npos);
    QVERIFY(report.largestDeviation < 1e-9);
    QVERIFY(report.colorsKept && report.nameKept);

    const TopoDS_Shape shape = shapeIn(file);
    QVERIFY(BRepCheck_Analyzer(shape).IsValid());
    const auto forms = formsOf(shape);
    QCOMPARE(forms.at(GeomAbs_Plane), 2);
    QCOMPARE(forms.at(GeomAbs_Cylinder), 4);
    QCOMPARE(forms.at(GeomAbs_Torus), 2);
    std::set<int> radii;
    for (const gp_Torus& torus : toriOf(shape)) {
        QVERIFY(std::abs(torus.MajorRadius() - 200 / pi) < 1e-6); // 100 mm along a quarter of a circle
        radii.insert(qRound(1e5 * torus.MinorRadius()));
        QVERIFY(torus.Position().Direction().IsParallel(gp::DY(), 1e-9));
        QVERIFY(torus.Location().Distance(gp_Pnt(50, 0, 200 / pi)) < 1e-6);
    }
    QCOMPARE(radii, std::set<int>({800'000, 1'000'000}));
}

void NumberDeformationTest::aBarBendsIntoCylindersAndPlanes()
{
    const Model model = example("bar.step"); // 160 x 20 x 20 mm
    const Box box = boxOf(model);
    const NumberDeformation bend{
        .kind = NumberKind::bend, .origin = box.center(), .from = -0.04, .to = 0.04, .angle = pi / 3, .stays = 0.5};
    const ExportedFile file = exported(model, {bend});
    tell(file);
    QVERIFY(file.report.isSound());
    const PartExportReport& report = file.report.parts.front();
    QVERIFY(std::abs(report.volume / report.restVolume - 1) < 1e-9);
    QVERIFY(report.largestDeviation < 1e-9);
    const auto forms = formsOf(shapeIn(file));
    QCOMPARE(forms.at(GeomAbs_Cylinder), 2);
    QCOMPARE(forms.at(GeomAbs_Plane), 2 + 3 * 4 - 2);
    QCOMPARE(forms.size(), std::size_t{2});
}

void NumberDeformationTest::aTubeThatTapersGetsCones()
{
    const Model model = example("tube.step");
    const NumberDeformation taper{.kind = NumberKind::taper, .from = 0.05, .to = 0.15, .factor = 0.5};
    const ExportedFile file = exported(model, {taper});
    tell(file);
    QVERIFY(file.report.isSound());
    // The section shrinks to a quarter; between, its mean is (1 + 1/2 + 1/4) / 3.
    const double section = pi * (0.01 * 0.01 - 0.008 * 0.008);
    const double volume = section * (0.05 + 0.1 * (1 + 0.5 + 0.25) / 3 + 0.05 / 4);
    QVERIFY(std::abs(file.report.parts.front().volume / volume - 1) < 1e-9);
    const auto forms = formsOf(shapeIn(file));
    QCOMPARE(forms.at(GeomAbs_Cone), 2);
    QCOMPARE(forms.at(GeomAbs_Cylinder), 4);
    QCOMPARE(forms.at(GeomAbs_Plane), 2);
}

void NumberDeformationTest::aTwistedTubeKeepsItsVolume()
{
    const Model model = example("tube.step");
    const NumberDeformation twist{.kind = NumberKind::twist, .from = 0.05, .to = 0.15, .angle = 1};
    const ExportedFile file = exported(model, {twist});
    tell(file);
    QVERIFY(file.report.isSound());
    QVERIFY(std::abs(file.report.parts.front().volume / file.report.parts.front().restVolume - 1) < 1e-5);
}

void NumberDeformationTest::whatIsStretchedStaysWhatItIs()
{
    const Model model = example("tube.step");
    const NumberDeformation stretch{.kind = NumberKind::stretch, .from = 0.05, .to = 0.15, .factor = 1.5};
    const ExportedFile file = exported(model, {stretch});
    tell(file);
    QVERIFY(file.report.isSound());
    QVERIFY(std::abs(file.report.parts.front().volume / file.report.parts.front().restVolume - 1.25) < 1e-9);
    const auto forms = formsOf(shapeIn(file));
    QCOMPARE(forms.at(GeomAbs_Cylinder), 6);
    QCOMPARE(forms.at(GeomAbs_Plane), 2);
}

/// The planes of the second bend lie in what the first one makes of the tube, whose other end stays there.
void NumberDeformationTest::aBendBackGivesTheTubeBack()
{
    const Model model = example("tube.step");
    NumberDeformation there = quarterBend();
    there.angle = 0.5;
    NumberDeformation more = there; // along the leg that the first one turned, from its end on
    const double radius = 0.1 / 0.5;
    more.origin = Vec3(0.05 + radius * std::sin(0.5), 0, radius * (1 - std::cos(0.5)));
    more.axis = Vec3(std::cos(0.5), 0, std::sin(0.5));
    more.side = Vec3(-std::sin(0.5), 0, std::cos(0.5));
    more.from = 0.01;
    more.to = 0.04;
    more.angle = -0.7;
    const ExportedFile file = exported(model, {there, more});
    tell(file);
    QVERIFY(file.report.isSound());
    const PartExportReport& report = file.report.parts.front();
    QVERIFY(std::abs(report.volume / report.restVolume - 1) < 1e-9);
    QCOMPARE(report.facesBefore, 4);
    const auto forms = formsOf(shapeIn(file));
    QCOMPARE(forms.at(GeomAbs_Torus), 4);
    QCOMPARE(forms.at(GeomAbs_Cylinder), 6);
}

void NumberDeformationTest::whatEasesIsNotDivided()
{
    const Model model = example("tube.step");
    NumberDeformation bend = quarterBend();
    bend.eases = true;
    const ExportedFile file = exported(model, {bend});
    tell(file);
    QVERIFY(file.report.isSound());
    QCOMPARE(file.report.parts.front().facesAfter, 4);
    QVERIFY(std::abs(file.report.parts.front().volume / file.report.parts.front().restVolume - 1) < 1e-4);
}

void NumberDeformationTest::facesAreDividedOnlyWherePlanesGoThrough()
{
    const TopoDS_Shape bored = boredCube();
    const auto dividedAt = [&](double x) {
        return dividedAtPlanes(bored, std::vector{gp_Pln(gp_Pnt(x, 100, -30), gp::DX())});
    };
    const auto through = dividedAt(5);
    QVERIFY(through);
    QCOMPARE(through->divided, std::size_t{5});                     // two sides, top and bottom, and the hole
    QCOMPARE(through->shape.origin.size(), std::size_t{7 + 4 + 2}); // the hole in three: it begins at x = 7
    const auto beside = dividedAt(1);
    QVERIFY(beside);
    QCOMPARE(beside->divided, std::size_t{4});
    for (const double outside : {0.0, 10.0, -1.0}) {
        const auto none = dividedAt(outside);
        QVERIFY(none);
        QCOMPARE(none->divided, std::size_t{0});
        QVERIFY(none->shape.shape.IsSame(bored));
    }
}

void NumberDeformationTest::piecesThatShareASurfaceStayFit()
{
    const auto divided = dividedAtPlanes(boredCube(), std::vector{gp_Pln(gp_Pnt(5, 0, 0), gp::DX())});
    QVERIFY(divided);
    const maps::Identity stays;
    const MorphedShape carried = morphShape(divided->shape.shape, stays, {}, TaskControl::none());
    QVERIFY(carried.isValid); // on both sides of the seam of the hole, at x = 7, lies a piece of it
    for (const MorphedFaceNote& note : carried.notes)
        QVERIFY(note.kind == MorphedFaceKind::kept);
}

/// Of a shell of 457 faces one lies in the plane where a twist begins, and one of its edges half a micrometer beside where it should.
void NumberDeformationTest::facesThatMissThePlaneTheyLieInAreDivided()
{
    const QString corpus = qEnvironmentVariable("KNEAD_CORPUS");
    if (corpus.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const Model model = importFile(corpus.toStdString() + "/hard/x08_openhand_l12.igs");
    const auto part = std::ranges::find(model.parts, std::string("CLAMSHELL_TOP_10416"), &Part::name);
    QVERIFY(part != model.parts.end());
    const TopoDS_Shape shape = shapesFromBytes(*part->exact->bytes)[part->exact->number];
    const auto divided = dividedAtPlanes(shape, std::vector{gp_Pln(gp_Pnt(0, 5.5, 0), gp::DY())});
    QVERIFY(divided);
    QVERIFY(divided->divided > 10);
}

void NumberDeformationTest::anEdgeThatLiesAPeriodAwayIsBroughtBack()
{
    const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(3, 8, pi).Shape();
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(half, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
        if (GeomAdaptor_Surface(BRep_Tool::Surface(face)).GetType() != GeomAbs_Cylinder)
            continue;
        const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current().Oriented(TopAbs_FORWARD));
        double first = 0;
        double last = 0;
        const auto curve = Handle(Geom2d_Curve)::DownCast(
            BRep_Tool::CurveOnSurface(edge, face, first, last)->Translated(gp_Vec2d(-2 * pi, 0)));
        BRep_Builder().UpdateEdge(edge, curve, face, 1e-7);
    }
    QVERIFY(!BRepCheck_Analyzer(half).IsValid());
    const MorphedShape carried = morphShape(half, maps::Identity(), {}, TaskControl::none());
    QVERIFY(carried.isValid);
    QVERIFY(BRepCheck_Analyzer(carried.shape).IsValid());
}

QTEST_GUILESS_MAIN(NumberDeformationTest)
#include "number_deformation_test.moc"
