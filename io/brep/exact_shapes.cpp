#include "io/brep/exact_shapes.h"

#include "core/message/message.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <sstream>

namespace knead {

std::string shapesToBytes(const std::vector<TopoDS_Shape>& shapes)
{
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(all, shape);
    std::ostringstream stream;
    BinTools::Write(all, stream, false, false, BinTools_FormatVersion_CURRENT);
    return std::move(stream).str();
}

std::vector<TopoDS_Shape> shapesFromBytes(std::string_view bytes)
{
    TopoDS_Shape all;
    try {
        std::istringstream stream{std::string(bytes)};
        BinTools::Read(all, stream);
    } catch (const Standard_Failure&) {
        all.Nullify();
    }
    if (all.IsNull() || all.ShapeType() != TopAbs_COMPOUND)
        throw Problem(Message("Repair", "The exact shapes of the parts cannot be understood; import the file again."));
    std::vector<TopoDS_Shape> shapes;
    for (TopoDS_Iterator shape(all); shape.More(); shape.Next())
        shapes.push_back(shape.Value());
    return shapes;
}

} // namespace knead
