#include "corpus/check.h"

#include "core/geometry/surface_distance.h"

#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace knead::corpus {

namespace {

using Json = nlohmann::ordered_json;

constexpr double fineShare = 1e-4; // of the diagonal: chord error of the triangles that the STL is compared with
constexpr double fineAngle = 0.1;  // [rad]
constexpr std::size_t mostSamples = 20'000;

int countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(shape, kind, shapes);
    return shapes.Extent();
}

int countFreeEdges(const TopoDS_Shape& shape)
{
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
    int count = 0;
    for (int i = 1; i <= faces.Extent(); ++i)
        count += !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i))) && faces(i).Extent() == 1 ? 1 : 0;
    return count;
}

void append(const Handle(Poly_Triangulation) & triangulation, const gp_Trsf& placement, TriangleMesh& mesh)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_Pnt point = triangulation->Node(i).Transformed(placement);
        mesh.vertices.emplace_back(point.X(), point.Y(), point.Z());
    }
    for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
        int a = 0;
        int b = 0;
        int c = 0;
        triangulation->Triangle(t).Get(a, b, c);
        const auto node = [&](int n) { return first + static_cast<std::uint32_t>(n) - 1; };
        mesh.triangles.push_back({node(a), node(b), node(c)});
    }
}

TriangleMesh fineTriangles(const TopoDS_Shape& shape, double diagonal)
{
    const BRepMesh_IncrementalMesh triangulated(shape, fineShare * diagonal, false, fineAngle, true);
    TriangleMesh mesh;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation)& triangulation =
            BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), location);
        if (!triangulation.IsNull())
            append(triangulation, location.Transformation(), mesh);
    }
    return mesh;
}

/// Of a binary STL; none where there is no such file.
TriangleMesh trianglesOfStl(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    file.seekg(80);
    std::uint32_t count = 0;
    file.read(reinterpret_cast<char*>(&count), sizeof count);
    TriangleMesh mesh;
    for (std::uint32_t t = 0; t < count && file; ++t) {
        std::array<float, 12> numbers{}; // normal and corners
        file.read(reinterpret_cast<char*>(numbers.data()), sizeof numbers);
        file.seekg(2, std::ios::cur);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t corner = 3; corner < numbers.size(); corner += 3)
            mesh.vertices.emplace_back(numbers.at(corner), numbers.at(corner + 1), numbers.at(corner + 2));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Largest distance of points of one surface from another one.
double farthest(const TriangleMesh& from, const TriangleMesh& to)
{
    const SurfaceDistance surface(to);
    double largest = 0;
    const std::size_t stride = from.triangles.size() / mostSamples + 1;
    for (std::size_t t = 0; t < from.triangles.size(); t += stride) {
        const auto& [a, b, c] = from.triangles[t];
        largest = std::max(largest, surface.nearest(from.vertices[a]).distance);
        largest =
            std::max(largest, surface.nearest((from.vertices[a] + from.vertices[b] + from.vertices[c]) / 3).distance);
    }
    return largest;
}

int countNames(const TDF_LabelSequence& labels)
{
    int count = 0;
    for (const TDF_Label& label : labels) {
        Handle(TDataStd_Name) name;
        count += label.FindAttribute(TDataStd_Name::GetID(), name) && name->Get().Length() > 0 ? 1 : 0;
    }
    return count;
}

Json checkStep(const std::string& step, const std::string& stl)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    STEPCAFControl_Reader reader;
    if (reader.ReadFile(step.c_str()) != IFSelect_RetDone || !reader.Transfer(document))
        return {{"error", "the STEP file cannot be read"}};
    const TopoDS_Shape shape = reader.Reader().OneShape();
    if (shape.IsNull())
        return {{"error", "the STEP file holds no shape"}};
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    const double diagonal = std::sqrt(box.SquareExtent());
    GProp_GProps volume;
    BRepGProp::VolumeProperties(shape, volume, 1e-5);
    double tolerance = 0;
    for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
        tolerance = std::max(tolerance, BRep_Tool::MaxTolerance(shape, kind));
    TDF_LabelSequence shapes;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetShapes(shapes);
    TDF_LabelSequence colors;
    XCAFDoc_DocumentTool::ColorTool(document->Main())->GetColors(colors);
    Json result{{"solids", countOf(shape, TopAbs_SOLID)},
                {"faces", countOf(shape, TopAbs_FACE)},
                {"free_edges", countFreeEdges(shape)},
                {"valid", BRepCheck_Analyzer(shape).IsValid() == Standard_True},
                {"volume_mm3", volume.Mass()},
                {"size_mm", diagonal},
                {"largest_tolerance_mm", tolerance},
                {"names", countNames(shapes)},
                {"colors", colors.Length()}};
    const TriangleMesh mesh = trianglesOfStl(stl);
    const TriangleMesh fine = fineTriangles(shape, diagonal);
    if (!fine.triangles.empty() && !mesh.triangles.empty()) {
        result["stl_to_step_mm"] = farthest(mesh, fine);
        result["step_to_stl_mm"] = farthest(fine, mesh);
    }
    return result;
}

} // namespace

nlohmann::ordered_json checkFiles(const std::string& step, const std::string& stl)
try {
    return checkStep(step, stl);
} catch (const Standard_Failure& failure) {
    return {{"error", failure.DynamicType()->Name()}};
}

} // namespace knead::corpus
