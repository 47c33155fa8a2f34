#include "core/geometry/mass_properties.h"
#include "io/brep/face_triangulation.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <QtTest>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double pi = std::numbers::pi;
const Tessellation fine{2e-5, 0.2}; // 0.02 mm

double volumeOf(const TopoDS_Shape& shape) // [m^3]
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return 1e-9 * properties.Mass();
}

TopoDS_Face disk(double radius, double z)
{
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), radius);
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)), true).Face();
}

/// A frustum whose cone runs once around from -pi to pi, as in countersinks of some programs.
TopoDS_Shape countersink(double semiAngle)
{
    const double low = 0.6;
    const double height = 0.4;
    const double high = low + height * std::tan(semiAngle);
    const Handle(Geom_ConicalSurface) cone =
        new Geom_ConicalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), semiAngle, low);
    BRepBuilderAPI_Sewing sewing(1e-5);
    sewing.Add(BRepBuilderAPI_MakeFace(cone, -pi, pi, 0, height / std::cos(semiAngle), 1e-7).Face());
    sewing.Add(disk(low, 0));
    sewing.Add(disk(high, height));
    sewing.Perform();
    BRepBuilderAPI_MakeSolid solid;
    for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next())
        solid.Add(TopoDS::Shell(shells.Current()));
    return solid.Solid();
}

TopoDS_Shape roundedBlock()
{
    const TopoDS_Shape block =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 14, 8).Shape(),
                        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(8, 7, -1), gp_Dir(0, 0, 1)), 3, 20));
    BRepFilletAPI_MakeFillet fillet(block);
    for (TopExp_Explorer edges(block, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(1.2, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

TopoDS_Shape loft()
{
    BRepOffsetAPI_ThruSections sections(true, false);
    for (const auto& [radius, z, shift] :
         {std::tuple(6.0, 0.0, 0.0), std::tuple(4.0, 9.0, 3.0), std::tuple(7.0, 20.0, -2.0)})
        sections.AddWire(BRepBuilderAPI_MakeWire(
            BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(shift, 0, z), gp_Dir(0, 0, 1)), radius))));
    return sections.Shape();
}

struct Solid {
    const char* name;
    TopoDS_Shape shape;
};

std::vector<Solid> solids()
{
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
    gp_Trsf mirrored;
    mirrored.SetMirror(gp_Ax2(gp_Pnt(3, 0, 0), gp_Dir(1, 0.4, 0)));
    const TopoDS_Shape block = roundedBlock();
    return {{"ball", BRepPrimAPI_MakeSphere(9).Shape()},
            {"ring", BRepPrimAPI_MakeTorus(12, 4).Shape()},
            {"pointed cone", BRepPrimAPI_MakeCone(0, 7, 11).Shape()},
            {"rounded block", block},
            {"turned block", block.Moved(turned)},
            {"mirrored block", block.Moved(mirrored, false)},
            {"loft", loft()}};
}

/// Away with the triangles of every nth face.
int strip(const TopoDS_Shape& shape, int nth)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    int count = 0;
    for (int i = 1; i <= faces.Extent(); i += nth, ++count)
        BRep_Builder().UpdateFace(TopoDS::Face(faces(i)), Handle(Poly_Triangulation)());
    return count;
}

void compareWithSolid(const TriangleMesh& mesh, const TopoDS_Shape& shape, double tolerance)
{
    QVERIFY(isWatertight(mesh));
    const double volume = std::abs(volumeOf(shape));
    QVERIFY2(std::abs(massProperties(mesh).volume / volume - 1) < tolerance,
             std::to_string(massProperties(mesh).volume / volume - 1).c_str());
}

} // namespace

class FaceTriangulationTest : public QObject {
    Q_OBJECT

private slots:
    void aFullConeHasTrianglesAtAnyAngle_data();
    void aFullConeHasTrianglesAtAnyAngle();
    void facesWithoutTrianglesGetThem_data();
    void facesWithoutTrianglesGetThem();
    void aFaceThatWasCutDifferentlyIsMadeToMeetItsNeighbor();
    void whatIsWholeStaysAsItIs();
};

void FaceTriangulationTest::aFullConeHasTrianglesAtAnyAngle_data()
{
    QTest::addColumn<double>("degrees");
    for (const double degrees : {30.0, 41.0, 45.0, 50.0, 60.0})
        QTest::newRow(std::to_string(degrees).c_str()) << degrees;
}

void FaceTriangulationTest::aFullConeHasTrianglesAtAnyAngle()
{
    QFETCH(double, degrees);
    const TopoDS_Shape shape = countersink(degrees * pi / 180);
    compareWithSolid(tessellate(shape, {2e-6, 0.1}), shape, 4e-3);
}

void FaceTriangulationTest::facesWithoutTrianglesGetThem_data()
{
    QTest::addColumn<int>("solid");
    QTest::addColumn<int>("nth");
    const auto all = solids();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const int nth : {1, 2, 3})
            QTest::addRow("%s, every %d", all[i].name, nth) << static_cast<int>(i) << nth;
}

void FaceTriangulationTest::facesWithoutTrianglesGetThem()
{
    QFETCH(int, solid);
    QFETCH(int, nth);
    const TopoDS_Shape shape = solids()[static_cast<std::size_t>(solid)].shape;
    const TriangleMesh before = tessellate(shape, fine);
    compareWithSolid(before, shape, 1e-2);
    QVERIFY(strip(shape, nth) > 0);
    QVERIFY(!isWatertight(collectTriangles(shape, fine, VertexPlace::onFaces)));
    mendTriangles(shape, fine);
    const TriangleMesh after = collectTriangles(shape, fine, VertexPlace::onFaces);
    compareWithSolid(after, shape, 1e-2);
    QVERIFY(after.triangles.size() < 3 * before.triangles.size());
    // Points that are moved off the surface by what its triangles say of it hold its volume.
    compareWithSolid(collectTriangles(shape, fine, VertexPlace::volumeTrue), shape, 1e-3);
}

void FaceTriangulationTest::aFaceThatWasCutDifferentlyIsMadeToMeetItsNeighbor()
{
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
    const TopoDS_Shape coarse = BRepPrimAPI_MakeCylinder(5, 10).Shape();
    tessellate(shape, fine);
    tessellate(coarse, {1e-3, 0.8});
    TopTools_IndexedMapOfShape faces;
    TopTools_IndexedMapOfShape coarseFaces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(coarse, TopAbs_FACE, coarseFaces);
    const TopoDS_Face& end = TopoDS::Face(faces(3));
    const TopoDS_Face& coarseEnd = TopoDS::Face(coarseFaces(3));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(coarseEnd, location);
    const TopoDS_Edge circle = TopoDS::Edge(TopExp_Explorer(end, TopAbs_EDGE).Current());
    const TopoDS_Edge coarseCircle = TopoDS::Edge(TopExp_Explorer(coarseEnd, TopAbs_EDGE).Current());
    BRep_Builder().UpdateFace(end, triangles);
    BRep_Builder().UpdateEdge(circle, BRep_Tool::PolygonOnTriangulation(coarseCircle, triangles, location), triangles,
                              location);
    QVERIFY(!isWatertight(collectTriangles(shape, fine, VertexPlace::onFaces)));
    mendTriangles(shape, fine);
    compareWithSolid(collectTriangles(shape, fine, VertexPlace::onFaces), shape, 1e-2);
}

void FaceTriangulationTest::whatIsWholeStaysAsItIs()
{
    const TopoDS_Shape shape = roundedBlock();
    const BRepMesh_IncrementalMesh triangulated(shape, 0.02, false, 0.2);
    const TriangleMesh before = collectTriangles(shape, fine, VertexPlace::onFaces);
    mendTriangles(shape, fine);
    const TriangleMesh after = collectTriangles(shape, fine, VertexPlace::onFaces);
    QVERIFY(isWatertight(before));
    QCOMPARE(after.vertices, before.vertices);
    QCOMPARE(after.triangles, before.triangles);
}

QTEST_APPLESS_MAIN(FaceTriangulationTest)
#include "face_triangulation_test.moc"
