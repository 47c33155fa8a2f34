#include "core/geometry/mass_properties.h"
#include "io/brep/free_edges.h"
#include "io/brep/healing.h"
#include "io/document/cad_part.h"
#include "io/document/size_limits.h"
#include "io/importer.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Trsf.hxx>

#include <QtTest>

#include <numbers>

using namespace knead;

// Shapes are made with edges that their faces do not share, as most IGES files have them, and brought back together.
// Lengths in mm.

namespace {

using Faces = std::vector<TopoDS_Shape>;

/// Copies, so that no two share an edge.
Faces separateFaces(const TopoDS_Shape& shape)
{
    Faces faces;
    for (TopExp_Explorer found(shape, TopAbs_FACE); found.More(); found.Next())
        faces.push_back(BRepBuilderAPI_Copy(found.Current()).Shape());
    return faces;
}

Faces operator+(Faces a, const Faces& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TopoDS_Shape compound(const Faces& shapes)
{
    TopoDS_Compound result;
    const BRep_Builder builder;
    builder.MakeCompound(result);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(result, shape);
    return result;
}

TopoDS_Shape box(double x, double y, double z, const gp_Pnt& corner = gp_Pnt(0, 0, 0))
{
    return BRepPrimAPI_MakeBox(corner, x, y, z).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& by)
{
    gp_Trsf shift;
    shift.SetTranslation(by);
    return shape.Moved(shift);
}

std::vector<CadBody> healed(const TopoDS_Shape& shape, bool capsFlatOpenings = false)
{
    return healed({shape, shape, {}, {}, {}}, capsFlatOpenings, TaskControl::none());
}

double volumeOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kind, found);
    return found.Extent();
}

bool mention(const std::vector<knead::Message>& sentences, const std::string& words)
{
    return std::any_of(sentences.begin(), sentences.end(), [&](const knead::Message& sentence) {
        return sentence.english().find(words) != std::string::npos;
    });
}

Part partOf(const CadBody& body)
{
    return makePart(body, {}, {}, {});
}

bool isClose(double value, double expected, double relative = 1e-9)
{
    return std::abs(value - expected) <= relative * std::abs(expected);
}

} // namespace

class HealingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void separateFacesBecomeASolid();
    void curvedFacesBecomeASolid();
    void soundSolidIsUntouched();
    void sickFacesAreRebuilt();
    void shortEdgesAreNotNearTheirNeighbors();
    void faceColorsSurvive();
    void innerShellBecomesAVoid();
    void twoVolumesBecomeTwoBodies();
    void insideOutShellIsTurned();
    void turnedFaceIsTurnedBack();
    void gapIsClosedAndReported();
    void wideGapStaysOpen();
    void thinPlateKeepsItsSides();
    void openBoxTellsItsBorder();
    void boxOfOneFaceLessIsNoSolid();
    void flatOpeningIsCappedAtWish();
    void curvedOpeningIsNotCapped();
    void importHealsUnlessToldNotTo();
    void sickPartDoesNotTakeTheOthersAlong();
    void flatSolidsAreLeftOut();
    void onlySickPartsAreRefused();

private:
    std::string write(const std::string& name, const TopoDS_Shape& shape) const;

    QTemporaryDir m_folder;
};

std::string HealingTest::write(const std::string& name, const TopoDS_Shape& shape) const
{
    const std::string path = m_folder.path().toStdString() + "/" + name;
    BRepTools::Write(shape, path.c_str());
    return path;
}

void HealingTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
}

void HealingTest::separateFacesBecomeASolid()
{
    const std::vector<CadBody> bodies = healed(compound(separateFaces(box(10, 20, 30))));
    QCOMPARE(bodies.size(), std::size_t(1));
    const Part part = partOf(bodies.front());
    QCOMPARE(part.solids, 1);
    QCOMPARE(part.faces.size(), std::size_t(6));
    QCOMPARE(part.edges, 12);
    QVERIFY(part.valid && part.canBeFilled() && part.openEdges.empty());
    QVERIFY(isClose(part.volume, 6e-6));
    QVERIFY(mention(part.repairs, "6 separate faces were sewn"));
    QVERIFY(mention(part.repairs, "made a solid"));
}

void HealingTest::curvedFacesBecomeASolid()
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 20).Shape();
    const std::vector<CadBody> bodies = healed(compound(separateFaces(cylinder)));
    QCOMPARE(bodies.size(), std::size_t(1));
    const Part part = partOf(bodies.front());
    QVERIFY(part.canBeFilled());
    QVERIFY(isClose(part.volume, 500e-9 * std::numbers::pi));
}

void HealingTest::soundSolidIsUntouched()
{
    const TopoDS_Shape solid = box(1, 2, 3);
    const std::vector<CadBody> bodies = healed(solid);
    QCOMPARE(bodies.size(), std::size_t(1));
    QVERIFY(bodies.front().shape.IsEqual(solid));
    QVERIFY(bodies.front().repairs.empty());
}

/// A corner that lies off the edges and faces that meet there.
void HealingTest::sickFacesAreRebuilt()
{
    const TopoDS_Shape solid = box(10, 20, 30);
    const TopoDS_Vertex corner = TopoDS::Vertex(TopExp_Explorer(solid, TopAbs_VERTEX).Current());
    BRep_Builder().UpdateVertex(corner, BRep_Tool::Pnt(corner).Translated({1e-3, 1e-3, 1e-3}), 1e-7);
    QVERIFY(!BRepCheck_Analyzer(solid).IsValid());
    const std::vector<CadBody> bodies = healed(solid);
    QCOMPARE(bodies.size(), std::size_t(1));
    QVERIFY(BRepCheck_Analyzer(bodies.front().shape).IsValid());
    QCOMPARE(bodies.front().repairs.size(), std::size_t(1));
    QVERIFY2(mention(bodies.front().repairs, "3 faces that failed the geometry checks were rebuilt"),
             bodies.front().repairs.front().english().c_str());
    QVERIFY(isClose(volumeOf(bodies.front().shape), 6000));
}

/// The border of this plate has a cut corner that is shorter than the distance.
void HealingTest::shortEdgesAreNotNearTheirNeighbors()
{
    BRepBuilderAPI_MakePolygon border;
    for (const gp_Pnt& corner :
         {gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 9.99, 0), gp_Pnt(9.99, 10, 0), gp_Pnt(0, 10, 0)})
        border.Add(corner);
    border.Close();
    const TopoDS_Shape plate = BRepBuilderAPI_MakeFace(border.Wire()).Shape();
    QVERIFY(!canBeSewn(plate, 0.01));
    QVERIFY(canBeSewn(compound({plate, moved(plate, {0, 0, 0.005})}), 0.01));
}

void HealingTest::faceColorsSurvive()
{
    const Faces faces = separateFaces(box(10, 20, 30));
    CadDocument document;
    const auto colorOf = [](std::size_t face) { return Color{0.1F * static_cast<float>(face), 0.5F, 0.5F}; };
    std::vector<Vec3> middles; // [m]
    for (std::size_t i = 0; i < faces.size(); ++i) {
        document.colors.set(faces[i], colorOf(i));
        document.names.set(faces[i], "side " + std::to_string(i));
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces[i], properties);
        const gp_Pnt middle = properties.CentreOfMass();
        middles.emplace_back(1e-3 * middle.X(), 1e-3 * middle.Y(), 1e-3 * middle.Z());
    }
    const CadBody body = healed(compound(faces)).front();
    const Part part = makePart(body, {}, document, {});
    QCOMPARE(part.faces.size(), faces.size());
    for (std::uint32_t face = 0; face < part.faces.size(); ++face) {
        Box ofFace;
        for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t)
            if (part.mesh.faceOfTriangle[t] == face)
                for (const std::uint32_t vertex : part.mesh.triangles[t])
                    ofFace.extend(part.mesh.vertices[vertex]);
        const auto original = std::find_if(middles.begin(), middles.end(), [&](const Vec3& middle) {
            return (middle - ofFace.center()).norm() < 1e-9;
        });
        QVERIFY(original != middles.end());
        const auto side = static_cast<std::size_t>(original - middles.begin());
        QCOMPARE(part.faces[face].color.value(), colorOf(side));
        QCOMPARE(part.faces[face].name, "side " + std::to_string(side));
    }
}

void HealingTest::innerShellBecomesAVoid()
{
    const TopoDS_Shape inner = BRepPrimAPI_MakeSphere(gp_Pnt(10, 10, 10), 5).Shape();
    const std::vector<CadBody> bodies = healed(compound(separateFaces(box(20, 20, 20)) + separateFaces(inner)));
    QCOMPARE(bodies.size(), std::size_t(1));
    QCOMPARE(count(bodies.front().shape, TopAbs_SHELL), 2);
    const Part part = partOf(bodies.front());
    QVERIFY(part.valid && part.canBeFilled());
    QVERIFY(isClose(part.volume, (8000 - 500 * std::numbers::pi / 3) * 1e-9));
    QVERIFY(mention(part.repairs, "1 void"));
}

void HealingTest::twoVolumesBecomeTwoBodies()
{
    const Faces faces = separateFaces(box(10, 10, 10)) + separateFaces(box(5, 5, 5, gp_Pnt(50, 0, 0)));
    const std::vector<CadBody> bodies = healed(compound(faces));
    QCOMPARE(bodies.size(), std::size_t(2));
    QVERIFY(isClose(volumeOf(bodies[0].shape), 1000));
    QVERIFY(isClose(volumeOf(bodies[1].shape), 125));
}

void HealingTest::insideOutShellIsTurned()
{
    TopoDS_Shape shell = TopExp_Explorer(box(10, 10, 10), TopAbs_SHELL).Current();
    shell.Reverse();
    const std::vector<CadBody> bodies = healed(compound({shell}));
    QCOMPARE(bodies.size(), std::size_t(1));
    QCOMPARE(count(bodies.front().shape, TopAbs_SOLID), 1);
    QVERIFY(isClose(volumeOf(bodies.front().shape), 1000));
    QVERIFY(mention(bodies.front().repairs, "inside out"));
}

void HealingTest::turnedFaceIsTurnedBack()
{
    Faces faces = separateFaces(box(10, 10, 10));
    faces[2].Reverse();
    const std::vector<CadBody> bodies = healed(compound(faces));
    QCOMPARE(bodies.size(), std::size_t(1));
    QVERIFY(freeEdgesOf(bodies.front().shape).IsEmpty());
    QVERIFY(isClose(volumeOf(bodies.front().shape), 1000));
}

void HealingTest::gapIsClosedAndReported()
{
    Faces faces = separateFaces(box(10, 10, 10));
    faces[0] = moved(faces[0], gp_Vec(-0.005, 0, 0)); // 0.3 thousandths of the diagonal
    const std::vector<CadBody> bodies = healed(compound(faces));
    QCOMPARE(bodies.size(), std::size_t(1));
    const Part part = partOf(bodies.front());
    QVERIFY(part.canBeFilled());
    QVERIFY(isClose(part.volume, 1e-6, 1e-3));
    QVERIFY2(mention(part.repairs, "the widest gap between two of them is 5 um"),
             part.repairs.front().english().c_str());
}

void HealingTest::wideGapStaysOpen()
{
    Faces faces = separateFaces(box(10, 10, 10));
    faces[0] = moved(faces[0], gp_Vec(-0.2, 0, 0)); // a hundredth of the diagonal
    const std::vector<CadBody> bodies = healed(compound(faces));
    QCOMPARE(bodies.size(), std::size_t(1));
    const Part part = partOf(bodies.front());
    QCOMPARE(part.solids, 0);
    QVERIFY(!part.canBeFilled() && !part.openEdges.empty());
    QVERIFY(mention(part.warnings, "8 open edges in 2 borders, 80 mm long"));
}

void HealingTest::thinPlateKeepsItsSides()
{
    Faces faces = separateFaces(box(100, 100, 0.02));
    for (TopoDS_Shape& face : faces)
        if (GProp_GProps area; BRepGProp::SurfaceProperties(face, area), area.Mass() > 5000) {
            face = moved(face, gp_Vec(0.1, 0, 0)); // a gap wider than the plate is thick
            break;
        }
    for (const CadBody& body : healed(compound(faces))) {
        GProp_GProps area;
        BRepGProp::SurfaceProperties(body.shape, area);
        QCOMPARE(count(body.shape, TopAbs_FACE), 6);
        QVERIFY(isClose(area.Mass(), 20008, 1e-3));
    }
}

void HealingTest::openBoxTellsItsBorder()
{
    Faces faces = separateFaces(box(10, 10, 10));
    faces.pop_back();
    const Part part = partOf(healed(compound(faces)).front());
    QCOMPARE(part.solids, 0);
    QCOMPARE(part.openEdges.size(), std::size_t(1));
    const std::vector<Vec3>& border = part.openEdges.front();
    double length = 0;
    for (std::size_t i = 0; i + 1 < border.size(); ++i)
        length += (border[i + 1] - border[i]).norm();
    QVERIFY(isClose(length, 0.04));
    QVERIFY((border.front() - border.back()).norm() < 1e-9);
    QVERIFY(mention(part.warnings,
                    "4 open edges in 1 border, 40 mm long in all; the largest opening is 14.1 mm across and flat"));
}

void HealingTest::boxOfOneFaceLessIsNoSolid()
{
    Faces faces = separateFaces(box(10, 10, 10));
    faces.pop_back();
    TopoDS_Shell shell;
    TopoDS_Solid solid;
    const BRep_Builder builder;
    builder.MakeShell(shell);
    for (const TopoDS_Shape& face : faces)
        builder.Add(shell, face);
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    const Part part = partOf(healed(solid).front());
    QVERIFY(!part.canBeFilled() && part.volume == 0 && !part.openEdges.empty());
}

void HealingTest::flatOpeningIsCappedAtWish()
{
    Faces faces = separateFaces(box(10, 20, 30));
    faces.erase(faces.begin() + 4);
    QCOMPARE(count(healed(compound(faces))[0].shape, TopAbs_SOLID), 0);
    const std::vector<CadBody> bodies = healed(compound(faces), true);
    QCOMPARE(bodies.size(), std::size_t(1));
    QCOMPARE(count(bodies[0].shape, TopAbs_SOLID), 1);
    QVERIFY(std::abs(volumeOf(bodies[0].shape) - 6000) < 1e-6);
    QVERIFY(mention(bodies[0].repairs, "1 flat opening was closed with a plane face, 9 % of the area"));

    // A tube: both of its ends.
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 20).Shape();
    Faces tube = separateFaces(cylinder);
    std::erase_if(tube, [](const TopoDS_Shape& face) { return count(face, TopAbs_EDGE) == 1; });
    QCOMPARE(tube.size(), std::size_t(1));
    const std::vector<CadBody> closed = healed(compound(tube), true);
    QVERIFY(std::abs(volumeOf(closed[0].shape) - 500 * std::numbers::pi) < 1e-6);
}

/// Two neighboring faces of a box are missing: their border does not lie in a plane.
void HealingTest::curvedOpeningIsNotCapped()
{
    Faces faces = separateFaces(box(10, 20, 30));
    faces.erase(faces.begin() + 4);
    faces.erase(faces.begin());
    for (const CadBody& body : healed(compound(faces), true))
        QCOMPARE(count(body.shape, TopAbs_SOLID), 0);
}

void HealingTest::importHealsUnlessToldNotTo()
{
    const std::string path = write("faces.brep", compound(separateFaces(box(10, 10, 10))));
    QCOMPARE(importFile(path).parts.front().solids, 1);
    const Part asItIs = importFile(path, {.heal = false}).parts.front();
    QCOMPARE(asItIs.solids, 0);
    QCOMPARE(asItIs.edges, 24);
    QVERIFY(asItIs.repairs.empty() && !asItIs.canBeFilled());
}

void HealingTest::sickPartDoesNotTakeTheOthersAlong()
{
    const TopoDS_Shape farAway = box(10, 10, 10, gp_Pnt(1e9, 0, 0));
    const Model model = importFile(write("two.brep", compound({box(10, 10, 10), farAway})));
    QCOMPARE(model.parts.size(), std::size_t(1));
    QVERIFY(isClose(model.parts.front().volume, 1e-6));
    QCOMPARE(model.missing.size(), std::size_t(1));
    QVERIFY(mention(model.missing, "\"two (2)\" was left out: it reaches farther than 100 km"));
    QCOMPARE(model.tree.children.front().children.size(), std::size_t(1));
}

/// Two faces on the same edges: where one is said to lie beside them, its integral finds a volume, and there is none.
void HealingTest::flatSolidsAreLeftOut()
{
    Part flat;
    flat.name = "flat";
    flat.mesh.vertices = {{0, 0, 0}, {0.02, 0, 0}, {0.02, 0, 0.002}};
    flat.mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    for (const Vec3& vertex : flat.mesh.vertices)
        flat.box.extend(vertex);
    flat.solids = 1;
    flat.volume = 3.6e-9;
    flat.area = 40e-6;
    flat.watertight = true;
    QCOMPARE(sicknessOf(flat).value_or(knead::Message()).english(), std::string("the solid has no volume"));
    flat.mesh.vertices.emplace_back(0.01, 0.01, 0);
    flat.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    if (massProperties(flat.mesh).volume < 0)
        for (auto& triangle : flat.mesh.triangles)
            std::swap(triangle[0], triangle[1]);
    QVERIFY(!sicknessOf(flat));
}

void HealingTest::onlySickPartsAreRefused()
{
    try {
        importFile(write("far.brep", box(10, 10, 10, gp_Pnt(1e9, 0, 0))));
    } catch (const std::runtime_error& error) {
        QCOMPARE(error.what(), "far.brep: \"far\" was left out: it reaches farther than 100 km from the origin; check "
                               "the length unit and the position.");
        return;
    }
    QFAIL("a part that is out of reach was imported");
}

QTEST_GUILESS_MAIN(HealingTest)
#include "healing_test.moc"
