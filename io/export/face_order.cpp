#include "io/export/face_order.h"

#include "io/morph/trimmed_face.h"

#include <BRepClass3d.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <limits>
#include <numeric>

namespace knead {

namespace {

std::vector<TopoDS_Shape> childrenOf(const TopoDS_Shape& shape)
{
    std::vector<TopoDS_Shape> children;
    for (TopoDS_Iterator child(shape); child.More(); child.Next())
        children.push_back(child.Value());
    return children;
}

/// A shape like another one, of other children.
TopoDS_Shape remade(const TopoDS_Shape& like, const std::vector<TopoDS_Shape>& children)
{
    TopoDS_Shape shape = like.EmptyCopied();
    for (const TopoDS_Shape& child : children)
        BRep_Builder().Add(shape, child);
    shape.Closed(like.Closed());
    return shape;
}

TopoDS_Shape rotatedShell(const TopoDS_Shape& shell, std::size_t first)
{
    std::vector<TopoDS_Shape> faces = childrenOf(shell);
    if (faces.empty())
        return shell;
    std::rotate(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(first % faces.size()), faces.end());
    return remade(shell, faces);
}

TopoDS_Shape rotated(const TopoDS_Shape& shape, std::size_t first)
{
    if (shape.ShapeType() > TopAbs_SOLID)
        return shape;
    std::vector<TopoDS_Shape> children = childrenOf(shape);
    for (TopoDS_Shape& child : children)
        if (shape.ShapeType() != TopAbs_SOLID)
            child = rotated(child, first);
        else if (child.IsSame(BRepClass3d::OuterShell(TopoDS::Solid(shape))))
            child = rotatedShell(child, first);
    return remade(shape, children);
}

/// The middle of its edges, per face.
std::vector<Vec3> middlesOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<Vec3> middles;
    for (int i = 1; i <= faces.Extent(); ++i) {
        const std::vector<Vec3> places = placesOnEdges(faces(i));
        const Vec3 sum = std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero()));
        middles.push_back(sum / std::max(1.0, static_cast<double>(places.size())));
    }
    return middles;
}

} // namespace

OrderedShape withFaceFirst(const TopoDS_Shape& shape, std::size_t first)
{
    OrderedShape result{rotated(shape, first), {}};
    TopTools_IndexedMapOfShape before;
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(shape, TopAbs_FACE, before);
    TopExp::MapShapes(result.shape, TopAbs_FACE, after);
    for (int i = 1; i <= after.Extent(); ++i)
        result.order.push_back(static_cast<std::uint32_t>(before.FindIndex(after(i)) - 1));
    return result;
}

std::vector<std::uint32_t> orderReadBack(const TopoDS_Shape& written, const TopoDS_Shape& back, double near)
try {
    const std::vector<Vec3> wanted = middlesOf(written);
    const std::vector<Vec3> found = middlesOf(back);
    if (wanted.size() != found.size())
        return {};
    std::vector<std::uint32_t> order(found.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<std::uint32_t> faces; // out of order, and where they may be
    for (const std::uint32_t face : order)
        if ((found[face] - wanted[face]).norm() > near)
            faces.push_back(face);
    std::vector<std::uint32_t> places = faces;
    const auto take =
        [&](double reach) { // those that lie so near first, so that one that moved takes no place of another
            std::erase_if(faces, [&](std::uint32_t face) {
                const auto nearest = std::ranges::min_element(
                    places, {}, [&](std::uint32_t place) { return (found[place] - wanted[face]).squaredNorm(); });
                if ((found[*nearest] - wanted[face]).norm() > reach)
                    return false;
                order[*nearest] = face;
                places.erase(nearest);
                return true;
            });
        };
    take(near);
    take(std::numeric_limits<double>::infinity());
    return order;
} catch (const Standard_Failure&) { // edges without curves
    return {};
}

} // namespace knead
