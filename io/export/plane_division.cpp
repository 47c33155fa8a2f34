#include "io/export/plane_division.h"

#include "io/brep/face_integral.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double sameVolume = 1e-4; // of it: so far do integrals over a face with many holes and over its pieces agree
constexpr double touching = 1e-5;   // [mm]: what only comes so near to a plane is not gone through

// [mm], one after the other: edges of a face that lies in a plane may miss it by more than their tolerance tells.
constexpr std::array fuzzinesses{0.0, 1e-4, 1e-3};
constexpr double mostFuzziness = 2e-5; // of the size

double sizeOfBox(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    return std::sqrt(box.SquareExtent());
}

/// Whether a face has material on both sides of a plane, as far as its box tells.
bool mayGoThrough(const TopoDS_Shape& face, const gp_Pln& plane)
{
    Bnd_Box box;
    BRepBndLib::AddOptimal(face, box, false, false);
    if (box.IsVoid())
        return false;
    std::array<double, 6> bounds{};
    box.Get(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
    double least = 1e100;
    double most = -1e100;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const gp_Pnt at(bounds[(corner & 1U) != 0 ? 3 : 0], bounds[(corner & 2U) != 0 ? 4 : 1],
                        bounds[(corner & 4U) != 0 ? 5 : 2]);
        const double height = gp_Vec(plane.Location(), at).Dot(gp_Vec(plane.Axis().Direction()));
        least = std::min(least, height);
        most = std::max(most, height);
    }
    return least < -touching && most > touching;
}

/// Faces and what holds them, rebuilt around the pieces of the faces.
class Rebuilding {
public:
    explicit Rebuilding(BRepAlgoAPI_Splitter& splitter)
        : m_splitter(splitter)
    {
    }

    TopoDS_Shape of(const TopoDS_Shape& shape)
    {
        const TopoDS_Shape forward = shape.Oriented(TopAbs_FORWARD);
        TopoDS_Shape image = forward.EmptyCopied();
        for (TopoDS_Iterator child(forward); child.More(); child.Next())
            if (child.Value().ShapeType() == TopAbs_FACE)
                addPieces(child.Value(), image);
            else if (child.Value().ShapeType() < TopAbs_FACE)
                m_builder.Add(image, of(child.Value()));
            else
                m_builder.Add(image, child.Value());
        image.Closed(shape.Closed());
        return image.Oriented(shape.Orientation());
    }

    /// Per face of a shape: which it is a piece of.
    std::vector<std::uint32_t> origin(const TopoDS_Shape& source, const TopoDS_Shape& result)
    {
        TopTools_IndexedMapOfShape before;
        TopTools_IndexedMapOfShape after;
        TopExp::MapShapes(source, TopAbs_FACE, before);
        TopExp::MapShapes(result, TopAbs_FACE, after);
        std::vector<std::uint32_t> origin(static_cast<std::size_t>(after.Extent()), nothing);
        for (int i = 1; i <= before.Extent(); ++i)
            for (const TopoDS_Shape& piece : piecesOf(before(i)))
                if (const int index = after.FindIndex(piece); index > 0)
                    origin[static_cast<std::size_t>(index - 1)] = static_cast<std::uint32_t>(i - 1);
        return origin;
    }

    static constexpr std::uint32_t nothing = 0xffffffffU;

private:
    TopTools_ListOfShape piecesOf(const TopoDS_Shape& face)
    {
        TopTools_ListOfShape pieces = m_splitter.Modified(face);
        if (pieces.IsEmpty())
            pieces.Append(face);
        return pieces;
    }

    void addPieces(const TopoDS_Shape& face, TopoDS_Shape& parent)
    {
        for (const TopoDS_Shape& piece : piecesOf(face.Oriented(TopAbs_FORWARD)))
            m_builder.Add(parent, piece.Composed(face.Orientation()));
    }

    BRepAlgoAPI_Splitter& m_splitter;
    BRep_Builder m_builder;
};

std::size_t freeEdgesOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
    std::size_t count = 0;
    for (int i = 1; i <= facesOfEdge.Extent(); ++i)
        count += facesOfEdge(i).Extent() < 2 && !BRep_Tool::Degenerated(TopoDS::Edge(facesOfEdge.FindKey(i))) ? 1 : 0;
    return count;
}

bool isAsSound(const TopoDS_Shape& now, const TopoDS_Shape& before)
{
    const double size = sizeOfBox(before);
    const double volume = faceIntegralsOf(before).volume;
    const double slack = sameVolume * std::max(std::abs(volume), 1e-3 * size * size * size);
    const std::size_t free = freeEdgesOf(before);
    return (free > 0 || std::abs(faceIntegralsOf(now).volume - volume) <= slack) &&
           (free > 0 ? freeEdgesOf(now) > 0 : freeEdgesOf(now) == 0) &&
           (BRepCheck_Analyzer(now).IsValid() || !BRepCheck_Analyzer(before).IsValid());
}

/// @param fuzziness what lies so near to each other is one [mm], beside tolerances
std::optional<PlaneDivision> divide(const TopoDS_Shape& shape, const TopTools_ListOfShape& tools, double fuzziness)
{
    // All faces as one argument: solids would be divided themselves, and several shells meet each other.
    TopoDS_Compound faces;
    const BRep_Builder builder;
    builder.MakeCompound(faces);
    TopTools_IndexedMapOfShape each;
    TopExp::MapShapes(shape, TopAbs_FACE, each);
    for (int i = 1; i <= each.Extent(); ++i)
        builder.Add(faces, each(i).Oriented(TopAbs_FORWARD));
    TopTools_ListOfShape arguments;
    arguments.Append(faces);
    BRepAlgoAPI_Splitter splitter;
    splitter.SetArguments(arguments);
    splitter.SetTools(tools);
    splitter.SetNonDestructive(true);
    splitter.SetFuzzyValue(fuzziness);
    splitter.Build();
    if (splitter.HasErrors())
        return std::nullopt;
    Rebuilding rebuilding(splitter);
    PlaneDivision result;
    result.shape.shape = rebuilding.of(shape);
    result.shape.origin = rebuilding.origin(shape, result.shape.shape);
    std::vector<int> pieces(static_cast<std::size_t>(each.Extent()), 0);
    for (const std::uint32_t face : result.shape.origin) {
        if (face == Rebuilding::nothing)
            return std::nullopt;
        ++pieces[face];
    }
    result.divided = static_cast<std::size_t>(std::ranges::count_if(pieces, [](int count) { return count > 1; }));
    if (std::ranges::count(pieces, 0) > 0 || !isAsSound(result.shape.shape, shape))
        return std::nullopt;
    return result;
}

/// Faces of planes as large as a shape, those that go through a face of it.
TopTools_ListOfShape facesAt(std::span<const gp_Pln> planes, const TopoDS_Shape& shape,
                             const TopTools_IndexedMapOfShape& faces)
{
    TopTools_ListOfShape tools;
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    const gp_Pnt middle(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()));
    const double size = sizeOfBox(shape);
    for (const gp_Pln& plane : planes) {
        bool isNeeded = false;
        for (int i = 1; i <= faces.Extent() && !isNeeded; ++i)
            isNeeded = mayGoThrough(faces(i), plane);
        if (!isNeeded)
            continue;
        const gp_Vec offset(middle, plane.Location());
        const gp_Vec normal(plane.Axis().Direction());
        const gp_Pln near(middle.Translated(offset.Dot(normal) * normal), plane.Axis().Direction());
        tools.Append(BRepBuilderAPI_MakeFace(near, -size, size, -size, size).Face());
    }
    return tools;
}

std::optional<PlaneDivision> tryToDivide(const TopoDS_Shape& shape, const TopTools_ListOfShape& tools, double fuzziness)
{
    try {
        return divide(shape, tools, fuzziness);
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
}

} // namespace

std::optional<PlaneDivision> dividedAtPlanes(const TopoDS_Shape& shape, std::span<const gp_Pln> planes)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopTools_ListOfShape tools;
    double size = 0;
    try {
        tools = facesAt(planes, shape, faces);
        size = sizeOfBox(shape);
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
    if (tools.IsEmpty()) {
        PlaneDivision whole{{shape, {}}, 0};
        for (int i = 0; i < faces.Extent(); ++i)
            whole.shape.origin.push_back(static_cast<std::uint32_t>(i));
        return whole;
    }
    for (const double fuzziness : fuzzinesses)
        if (fuzziness <= mostFuzziness * size)
            if (auto divided = tryToDivide(shape, tools, fuzziness))
                return divided;
    return std::nullopt;
}

} // namespace knead
