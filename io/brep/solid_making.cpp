#include "io/brep/solid_making.h"

#include "core/message/message.h"
#include "io/brep/free_edges.h"
#include "io/brep/shape_measure.h"
#include "io/document/size_limits.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Shell.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace knead {

namespace {

struct ClosedShell {
    TopoDS_Shell shell;      // outward
    FaceIntegrals integrals; // volume positive
    Bnd_Box box;
    bool wasTurned = false;
    std::optional<std::size_t> around; // the smallest shell that holds it
    int depth = 0;                     // how many hold it
};

TopoDS_Solid solidOf(const TopoDS_Shell& shell)
{
    TopoDS_Solid solid;
    const BRep_Builder builder;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    return solid;
}

TopoDS_Shell shellOf(const TopoDS_Shape& face)
{
    TopoDS_Shell shell;
    const BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, face);
    return shell;
}

/// A shell whose faces agree on which side is out, if that can be reached by turning faces.
TopoDS_Shell oriented(const TopoDS_Shell& shell)
{
    if (freeEdgesOf(shell).IsEmpty())
        return shell;
    ShapeFix_Shell fix;
    fix.FixFaceOrientation(shell);
    return fix.NbShells() == 1 ? fix.Shell() : shell;
}

/// @param known integrals of the shell as it is given
std::optional<ClosedShell> closedShell(const TopoDS_Shell& given, const std::optional<FaceIntegrals>& known)
{
    ClosedShell result;
    result.shell = oriented(given);
    if (!freeEdgesOf(result.shell).IsEmpty())
        return std::nullopt;
    BRepBndLib::Add(result.shell, result.box, false);
    result.integrals = known && result.shell.IsEqual(given) ? *known : faceIntegralsOf(result.shell);
    const double volume = result.integrals.volume;
    if (result.box.IsVoid() ||
        !(std::abs(volume) > leastVolumeShare * std::pow(std::sqrt(result.box.SquareExtent()), 3)))
        return std::nullopt;
    result.integrals.volume = std::abs(volume);
    result.wasTurned = volume < 0;
    if (result.wasTurned)
        result.shell.Reverse();
    result.shell.Closed(true);
    return result;
}

/// Vertices decide, of which all lie on the same side when the shells do not cross.
bool holds(const ClosedShell& outer, const ClosedShell& inner)
{
    const gp_Pnt low = inner.box.CornerMin();
    const gp_Pnt high = inner.box.CornerMax();
    if (outer.box.IsOut(low) || outer.box.IsOut(high))
        return false;
    BRepClass3d_SolidClassifier classifier(solidOf(outer.shell));
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(inner.shell, TopAbs_VERTEX, vertices);
    int inside = 0;
    for (int i = 1; i <= vertices.Extent(); ++i) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices(i));
        classifier.Perform(BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex));
        if (classifier.State() == TopAbs_OUT)
            return false;
        inside += classifier.State() == TopAbs_IN ? 1 : 0;
    }
    return inside > 0;
}

/// From large to small, so that what holds a shell stands before it.
void nest(std::vector<ClosedShell>& shells)
{
    std::stable_sort(shells.begin(), shells.end(), [](const ClosedShell& a, const ClosedShell& b) {
        return a.integrals.volume > b.integrals.volume;
    });
    for (std::size_t inner = 0; inner < shells.size(); ++inner)
        for (std::size_t outer = 0; outer < inner; ++outer)
            if (holds(shells[outer], shells[inner])) {
                shells[inner].around = outer;
                ++shells[inner].depth;
            }
}

bool isVoid(const ClosedShell& shell)
{
    return shell.depth % 2 == 1;
}

CadBody solidBody(const std::vector<ClosedShell>& shells, std::size_t outer, const CadBody& from)
{
    CadBody body = from;
    FaceIntegrals integrals = shells[outer].integrals;
    TopoDS_Solid solid = solidOf(shells[outer].shell);
    std::size_t turned = shells[outer].wasTurned ? 1 : 0;
    std::size_t voids = 0;
    for (const ClosedShell& shell : shells)
        if (isVoid(shell) && shell.around == outer) {
            BRep_Builder().Add(solid, shell.shell.Reversed());
            integrals.area += shell.integrals.area;
            integrals.volume -= shell.integrals.volume;
            turned += shell.wasTurned ? 0 : 1;
            ++voids;
        }
    if (turned > 0)
        body.repairs.push_back(turned == 1 ? Message("Repair", "1 shell was inside out and turned.")
                                           : Message("Repair", "%1 shells were inside out and turned.").with(turned));
    body.repairs.push_back(
        voids == 0   ? Message("Repair", "The closed surface was made a solid.")
        : voids == 1 ? Message("Repair", "The closed surface was made a solid, with 1 void in it.")
                     : Message("Repair", "The closed surface was made a solid, with %1 voids in it.").with(voids));
    body.shape = solid;
    body.isValid.reset();
    body.failure.reset();
    body.integrals = integrals;
    return body;
}

} // namespace

std::vector<CadBody> solidsOf(const CadBody& surface)
{
    std::vector<ClosedShell> shells;
    TopoDS_Compound open;
    const BRep_Builder builder;
    builder.MakeCompound(open);
    bool isAnyOpen = false;
    const auto keepOpen = [&](const TopoDS_Shape& shape) {
        builder.Add(open, shape);
        isAnyOpen = true;
    };
    const bool isOneShell = surface.shape.ShapeType() == TopAbs_SHELL;
    const auto take = [&](const TopoDS_Shell& shell, const TopoDS_Shape& asItIs) {
        if (auto closed = closedShell(shell, isOneShell ? surface.integrals : std::nullopt))
            shells.push_back(std::move(*closed));
        else
            keepOpen(asItIs);
    };
    for (TopExp_Explorer found(surface.shape, TopAbs_SHELL); found.More(); found.Next())
        take(TopoDS::Shell(found.Current()), found.Current());
    for (TopExp_Explorer found(surface.shape, TopAbs_FACE, TopAbs_SHELL); found.More(); found.Next())
        take(shellOf(found.Current()), found.Current()); // a sphere is one face
    if (shells.empty())
        return {surface};

    nest(shells);
    std::vector<CadBody> bodies;
    for (std::size_t i = 0; i < shells.size(); ++i)
        if (!isVoid(shells[i]))
            bodies.push_back(solidBody(shells, i, surface));
    if (isAnyOpen) {
        CadBody rest = surface;
        rest.shape = open;
        rest.isValid.reset();
        rest.failure.reset();
        rest.integrals.reset();
        bodies.push_back(std::move(rest));
    }
    return bodies;
}

} // namespace knead
