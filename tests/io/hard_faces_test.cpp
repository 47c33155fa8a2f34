#include "io/brep/occt_session.h"
#include "io/export/divided_shape.h"
#include "io/morph/brep_morph.h"
#include "support/export_jobs.h"
#include "support/skip.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <QtTest>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <numbers>

using namespace knead;
using namespace export_jobs;

namespace {

double volumeOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// How many faces have a seam.
int closedFaces(const TopoDS_Shape& shape)
{
    int count = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        bool isClosed = false;
        for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
            isClosed = isClosed || BRep_Tool::IsClosed(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current()));
        count += isClosed ? 1 : 0;
    }
    return count;
}

/// A tube of 40 mm with a window cut out of its side.
TopoDS_Shape tube()
{
    const TopoDS_Shape outside = BRepPrimAPI_MakeCylinder(12, 40).Shape();
    const TopoDS_Shape inside = BRepPrimAPI_MakeCylinder(9, 40).Shape();
    const TopoDS_Shape window = BRepPrimAPI_MakeBox(gp_Pnt(-20, -4, 12), gp_Pnt(0, 4, 25)).Shape();
    return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(outside, inside).Shape(), window).Shape();
}

/// A sleeve of 13 mm with a slit; of its last 2.4 mm, two tongues less than a millimetre wide are left.
TopoDS_Shape sleeveWithTongues()
{
    const TopoDS_Shape round = BRepPrimAPI_MakeCylinder(2.5, 13).Shape();
    TopoDS_Shape shape = BRepAlgoAPI_Cut(round, BRepPrimAPI_MakeCylinder(2, 13).Shape()).Shape();
    shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeBox(gp_Pnt(-4, -1.8, -1), gp_Pnt(-1, 1.8, 14)).Shape());
    for (const auto& [low, high] : {std::pair(-4.0, -1.6), std::pair(-0.9, 0.7), std::pair(1.4, 4.0)})
        shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeBox(gp_Pnt(-4, low, 10.6), gp_Pnt(4, high, 14)).Shape());
    return shape;
}

/// A bend about an axis far away [m].
class WideArc final : public maps::PointMap {
public:
    double featureSize() const override { return 0.02; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const double turn = point.x() / radius;
        return {(radius - point.z()) * std::sin(turn), point.y(), radius - (radius - point.z()) * std::cos(turn)};
    }

private:
    static constexpr double radius = 0.05;
};

/// A part that is pulled longer, with a step of three thousandths of a feature close to its end, as skins have beside thin
/// walls.
class SteppedStretch final : public maps::PointMap {
public:
    explicit SteppedStretch(double end)
        : m_place(end - 5e-7)
    {
    }
    double featureSize() const override { return 1e-3; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        return {1.02 * point.x() - (point.x() > m_place ? 3e-6 : 0), point.y(), point.z()};
    }

private:
    double m_place;
};

} // namespace

/// Faces that need more than to be fitted.
class HardFacesTest : public QObject {
    Q_OBJECT
private slots:
    void closedFacesAreDivided();
    void shapesWithoutClosedFacesStay();
    void tonguesNeedFewPoles();
    void smallStepsAreNoFolds();
    void pairsThatOnceCameBackUnsound_data();
    void pairsThatOnceCameBackUnsound();
};

void HardFacesTest::closedFacesAreDivided()
{
    const OcctSession session;
    const TopoDS_Shape whole = tube();
    QCOMPARE(closedFaces(whole), 2);
    const DividedShape divided = withoutClosedFaces(whole);
    QCOMPARE(closedFaces(divided.shape), 0);
    QVERIFY(BRepCheck_Analyzer(divided.shape).IsValid());
    QVERIFY(std::abs(volumeOf(divided.shape) - volumeOf(whole)) < 1e-6 * volumeOf(whole));

    // Each piece lies on the surface it came from.
    TopTools_IndexedMapOfShape before;
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(whole, TopAbs_FACE, before);
    TopExp::MapShapes(divided.shape, TopAbs_FACE, after);
    QCOMPARE(after.Extent(), before.Extent() + 2);
    QCOMPARE(divided.origin.size(), static_cast<std::size_t>(after.Extent()));
    std::vector<double> areas(static_cast<std::size_t>(before.Extent()), 0);
    const auto areaOf = [](const TopoDS_Shape& face) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties);
        return properties.Mass();
    };
    for (int i = 1; i <= after.Extent(); ++i)
        areas[divided.origin[static_cast<std::size_t>(i - 1)]] += areaOf(after(i));
    for (int i = 1; i <= before.Extent(); ++i)
        QVERIFY(std::abs(areas[static_cast<std::size_t>(i - 1)] / areaOf(before(i)) - 1) < 1e-6);
}

void HardFacesTest::shapesWithoutClosedFacesStay()
{
    const OcctSession session;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const DividedShape divided = withoutClosedFaces(box);
    QVERIFY(divided.shape.IsSame(box));
    QCOMPARE(divided.origin.size(), std::size_t{6});
}

/// What a spline does between the tongues must not disturb it on them: then it needs more and more knots.
void HardFacesTest::tonguesNeedFewPoles()
{
    const OcctSession session;
    const MorphOptions options{.tolerance = 0.016};
    const MorphedShape bent = morphShape(sleeveWithTongues(), WideArc(), options, TaskControl::none());
    QVERIFY(bent.isValid);
    for (const MorphedFaceNote& note : bent.notes) {
        QVERIFY(note.converged);
        QVERIFY(note.error <= options.faceTolerance());
        QVERIFY2(note.poles <= 400, qPrintable(QString::number(note.poles)));
    }
}

void HardFacesTest::smallStepsAreNoFolds()
{
    const Model model = example("bar.step");
    ExportJob job = jobOf(model, nullptr);
    job.parts.front().map = std::make_shared<SteppedStretch>(boxOf(model).max().x());
    const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
    QCOMPARE(file.report.parts.front().form, PartExportReport::Form::exact);
    QVERIFY(file.report.isSound());
}

void HardFacesTest::pairsThatOnceCameBackUnsound_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("isTwisted");
    QTest::newRow("tiny edges at seams") << "o23_nist_ctc02_ap242.stp" << true;
    QTest::newRow("faces that do not survive being copied") << "o35_gmsh_impeller.stp" << false;
}

void HardFacesTest::pairsThatOnceCameBackUnsound()
{
    QFETCH(QString, file);
    QFETCH(bool, isTwisted);
    const QString folder = qEnvironmentVariable("KNEAD_CORPUS");
    if (folder.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const Model model = importFile((folder + "/open/" + file).toStdString());
    QCOMPARE(model.parts.size(), std::size_t{1});
    ExportJob job = jobOf(model, nullptr);
    if (isTwisted)
        job.parts.front().map = std::make_shared<maps::Twist>(model.parts.front().box, std::numbers::pi / 2);
    else
        job.parts.front().map = std::make_shared<maps::Identity>();
    const ExportedFile written = exportCad(FormatKind::Step, job, TaskControl::none());
    const PartExportReport& part = written.report.parts.front();
    QCOMPARE(part.form, PartExportReport::Form::exact);
    QVERIFY2(part.isFit(), part.remarks.empty() ? "" : part.remarks.back().english().c_str());
    QVERIFY(part.facesAfter >= part.facesBefore);
    QVERIFY(part.colorsKept);
    QVERIFY(!part.crossesItself); // though chords of its triangles cross, near walls and gaps that are thin
}

QTEST_GUILESS_MAIN(HardFacesTest)
#include "hard_faces_test.moc"
