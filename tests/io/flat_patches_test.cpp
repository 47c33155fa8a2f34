#include "io/brep/occt_session.h"
#include "io/morph/brep_morph.h"
#include "support/space_maps.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <QtTest>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <set>

using namespace knead;

Q_DECLARE_METATYPE(TopoDS_Shape)

namespace {

double volumeOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

int freeEdgesOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
    int count = 0;
    for (int i = 1; i <= faces.Extent(); ++i)
        count += !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i))) && faces(i).Extent() != 2 ? 1 : 0;
    return count;
}

std::size_t facesOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return static_cast<std::size_t>(faces.Extent());
}

MorphOptions optionsFor(std::set<std::uint32_t> flat)
{
    return {.tolerance = 0.01,
            .flat = std::move(flat),
            .flatFineness = {.deflection = 0.05, .angle = 0.35, .longestSide = 3}};
}

/// Bends everything that lies along x about an axis far above [m].
class Arc final : public maps::PointMap {
public:
    double featureSize() const override { return 0.02; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const double turn = point.x() / radius;
        return {(radius - point.z()) * std::sin(turn), point.y() + 0.05 * point.x() * point.z() / radius,
                radius - (radius - point.z()) * std::cos(turn)};
    }

private:
    static constexpr double radius = 0.06;
};

TopoDS_Shape plate()
{
    return BRepPrimAPI_MakeBox(gp_Pnt(-20, -10, 0), 40, 20, 8).Shape();
}

TopoDS_Shape rectangle()
{
    return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), -20, 20, -10, 10).Face();
}

TopoDS_Shape boredPlate()
{
    const gp_Ax2 axis(gp_Pnt(-6, 0, -1), gp::DZ());
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(plate(), BRepPrimAPI_MakeCylinder(axis, 3, 10).Shape());
    return BRepAlgoAPI_Cut(bored, BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(-6, 0, 6), gp::DZ()), 3, 6, 3).Shape());
}

TopoDS_Shape roundedPlate()
{
    const TopoDS_Shape box = plate();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(2, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

/// With a hollow ball inside that does not reach its skin, and half a ball cut off its top.
TopoDS_Shape hollowBlock()
{
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-15, -10, 0), 30, 20, 20).Shape();
    const TopoDS_Shape hollow = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeSphere(gp_Pnt(5, 0, 9), 5).Shape());
    return BRepAlgoAPI_Cut(hollow, BRepPrimAPI_MakeSphere(gp_Pnt(-8, 0, 20), 4).Shape());
}

} // namespace

/// Single faces made of triangles, whose neighbors stay smooth.
class FlatPatchesTest : public QObject {
    Q_OBJECT

private slots:
    void eachFaceAlone_data();
    void eachFaceAlone();
    void neighborsTogether();
};

void FlatPatchesTest::eachFaceAlone_data()
{
    const OcctSession session;
    QTest::addColumn<TopoDS_Shape>("shape");
    QTest::newRow("plate") << plate();
    QTest::newRow("bored plate with a countersink") << boredPlate();
    QTest::newRow("plate with rounded edges and corners") << roundedPlate();
    QTest::newRow("block with a void and a dimple") << hollowBlock();
    QTest::newRow("cylinder") << BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()), 6, 20).Shape();
    QTest::newRow("cone to a tip") << BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()), 6, 0, 20).Shape();
    QTest::newRow("ball") << BRepPrimAPI_MakeSphere(8).Shape();
    QTest::newRow("ring") << BRepPrimAPI_MakeTorus(12, 4).Shape();
    // Its bottom and its top are one face at two places.
    QTest::newRow("prism") << BRepPrimAPI_MakePrism(rectangle(), gp_Vec(0, 0, 8)).Shape();
    QTest::newRow("plate inside out") << plate().Reversed();
}

void FlatPatchesTest::eachFaceAlone()
{
    const OcctSession session;
    QFETCH(const TopoDS_Shape, shape);
    const MorphedShape smooth = morphShape(shape, Arc(), optionsFor({}));
    QVERIFY(smooth.isValid && smooth.faulty.empty());
    const double volume = volumeOf(smooth.shape);
    const std::size_t faces = facesOf(shape);
    for (std::uint32_t face = 0; face < faces; ++face) {
        const MorphedShape mixed = morphShape(shape, Arc(), optionsFor({face}));
        const QByteArray which = "face " + QByteArray::number(face);
        QVERIFY2(mixed.isValid, which);
        QCOMPARE(freeEdgesOf(mixed.shape), 0);
        const double error = volumeOf(mixed.shape) / volume - 1;
        QVERIFY2(std::abs(error) < 0.01, qPrintable(which + QString(": %1").arg(error)));
        // All others are one face still, with the surface that they have without it.
        QVERIFY2(facesOf(mixed.shape) > faces, which);
        QCOMPARE(mixed.origin.size(), facesOf(mixed.shape));
        TopTools_IndexedMapOfShape written;
        TopExp::MapShapes(mixed.shape, TopAbs_FACE, written);
        std::vector<std::size_t> counts(faces, 0);
        for (std::size_t i = 0; i < mixed.origin.size(); ++i) {
            ++counts[mixed.origin[i]];
            const GeomAdaptor_Surface surface(BRep_Tool::Surface(TopoDS::Face(written(static_cast<int>(i) + 1))));
            QVERIFY2(mixed.origin[i] != face || surface.GetType() == GeomAbs_Plane, which);
        }
        for (std::uint32_t other = 0; other < faces; ++other) {
            QVERIFY(other == face ? counts[other] > 1 : counts[other] == 1);
            QCOMPARE(mixed.notes[other].kind, other == face ? MorphedFaceKind::flat : smooth.notes[other].kind);
            QVERIFY(other == face || mixed.notes[other].error == smooth.notes[other].error);
        }
    }
}

/// Between two of them the edge goes with them.
void FlatPatchesTest::neighborsTogether()
{
    const OcctSession session;
    const TopoDS_Shape shape = boredPlate();
    const std::size_t faces = facesOf(shape);
    const double volume = volumeOf(morphShape(shape, Arc(), optionsFor({})).shape);
    for (std::uint32_t first = 0; first < faces; ++first)
        for (std::uint32_t second = first + 1; second < faces; ++second) {
            const MorphedShape mixed = morphShape(shape, Arc(), optionsFor({first, second}));
            QVERIFY(mixed.isValid);
            QCOMPARE(freeEdgesOf(mixed.shape), 0);
            QVERIFY(std::abs(volumeOf(mixed.shape) / volume - 1) < 0.01);
        }
}

QTEST_GUILESS_MAIN(FlatPatchesTest)
#include "flat_patches_test.moc"
