#include "core/aggregate/fill.h"

#include "core/aggregate/cell_corners.h"
#include "core/aggregate/cut_cells.h"
#include "core/aggregate/spacing_choice.h"
#include "core/geometry/half_edges.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_distance.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace knead {

namespace {

constexpr double rounding = 1e-9; // of lengths
constexpr int exactLayers = 1;    // objects up to so many steps from the corners of cut cells get their exact depth

std::string inMillimetres(double length)
{
    std::ostringstream text;
    text << length * 1000 << " mm";
    return text.str();
}

[[noreturn]] void refuseTooManyObjects(const FillOptions& options)
{
    throw std::runtime_error("A spacing of " + inMillimetres(options.spacing) + " needs more than " +
                             std::to_string(options.maximumObjects) + " objects. Choose a larger spacing.");
}

/// @returns its half-edges
HalfEdges checkMesh(const TriangleMesh& mesh)
{
    if (mesh.empty())
        throw std::runtime_error(
            "The part has no triangles, so there is nothing to fill. Import a part with a surface.");
    for (const Vec3& vertex : mesh.vertices)
        if (!vertex.allFinite())
            throw std::runtime_error(
                "A vertex of the surface is not at a finite place. Repair the file and import again.");
    HalfEdges halfEdges = findHalfEdges(mesh);
    if (halfEdges.unpaired > 0)
        throw std::runtime_error("The surface is not closed: " + std::to_string(halfEdges.unpaired) +
                                 " edges of triangles have no partner. Close the gaps and import again.");
    return halfEdges;
}

/// Refuses what could not be stored, before anything is allocated.
void checkSize(const MassProperties& properties, const FillOptions& options)
{
    const double a = options.spacing;
    if (!std::isfinite(a) || a <= 0)
        throw std::runtime_error("A spacing of " + inMillimetres(a) + " cannot be used. Enter a length above 0.");
    const auto most = static_cast<double>(options.maximumObjects);
    if (std::abs(properties.volume) / (a * a * a) > most || properties.box.sizes().maxCoeff() / a > most)
        refuseTooManyObjects(options);
}

/// Marks objects next to marked ones along one axis, in both senses.
void growAlong(const Lattice& lattice, std::size_t axis, std::vector<std::uint8_t>& marks)
{
    const std::vector<std::uint8_t> before = marks;
    for (const Lattice::Segment& segment : lattice.segments[axis])
        for (ObjectIndex low = segment.begin; low < segment.end; ++low) {
            const ObjectIndex high = low + static_cast<ObjectIndex>(segment.offset);
            Lattice::Node neighbor = lattice.nodes[low];
            ++neighbor[axis];
            if ((before[low] | before[high]) == 0 || lattice.nodes[high] != neighbor)
                continue;
            marks[low] |= before[high];
            marks[high] |= before[low];
        }
}

/// Objects within exactLayers steps of a surface object, diagonals counted as one step. Growing axis by axis reaches
/// all of them: where a node on the way is missing, the objects around the gap are surface objects themselves.
std::vector<ObjectIndex> objectsNearSurface(const CellCorners& corners)
{
    std::vector<std::uint8_t> marks = corners.isSurface;
    for (int layer = 0; layer < exactLayers; ++layer)
        for (std::size_t axis = 0; axis < 3; ++axis)
            growAlong(corners.aggregate.lattice, axis, marks);
    std::vector<ObjectIndex> objects;
    for (ObjectIndex object = 0; object < marks.size(); ++object)
        if (marks[object] != 0)
            objects.push_back(object);
    return objects;
}

/// All cells within exactLayers + 1 steps of the other objects are full, so these are at least that deep, as are those to
/// which no surface is nearer.
void measureDepth(Aggregate& aggregate, const std::vector<ObjectIndex>& nearSurface, const TriangleMesh& mesh,
                  HalfEdges halfEdges, double orientation, TaskControl& control)
{
    const double deep = (exactLayers + 1) * aggregate.lattice.spacing;
    const double reach = (1 + rounding) * deep;
    aggregate.depth.assign(aggregate.size(), deep);
    aggregate.face.assign(aggregate.size(), Aggregate::noFace);
    control.throwIfCancelled();
    const SurfaceDistance surface(mesh, std::move(halfEdges));
    forEachBlock(nearSurface.size(), 1024, control, "measuring depth", [&](std::size_t begin, std::size_t end) {
        std::uint32_t guess = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const ObjectIndex object = nearSurface[i];
            const auto hit = surface.nearestWithin(reach, aggregate.lattice.position(object), guess);
            if (!hit)
                continue;
            guess = hit->triangle;
            aggregate.depth[object] = -orientation * hit->signedDistance;
            if (!mesh.faceOfTriangle.empty())
                aggregate.face[object] = mesh.faceOfTriangle[hit->triangle];
        }
    });
}

} // namespace

Aggregate fill(const TriangleMesh& mesh, const FillOptions& options, TaskControl& control)
{
    control.report(0, "checking the surface");
    HalfEdges halfEdges = checkMesh(mesh);
    const MassProperties properties = massProperties(mesh);
    checkSize(properties, options);

    const double orientation = properties.volume < 0 ? -1 : 1;
    const CellGrid grid = gridAround(properties.box, options.spacing);
    TaskPortion cutting(control, 0.1, 0.5);
    const CutCells cells = cutCells(mesh, grid, orientation, options.minimumFraction, cutting);
    if (cells.size() == 0)
        throw std::runtime_error("The part is too thin for a spacing of " + inMillimetres(options.spacing) +
                                 ": no cell holds enough material. Choose a smaller spacing.");
    if (countCorners(cells) > std::min<std::size_t>(options.maximumObjects, 0x7fffffff))
        refuseTooManyObjects(options);

    TaskPortion joining(control, 0.5, 0.6);
    CellCorners corners = joinCells(cells, grid, joining);
    corners.aggregate.meshVolume = std::abs(properties.volume);
    TaskPortion measuring(control, 0.6, 1);
    measureDepth(corners.aggregate, objectsNearSurface(corners), mesh, std::move(halfEdges), orientation, measuring);
    return std::move(corners.aggregate);
}

double spacingForCellsAcross(const TriangleMesh& mesh, double cells)
{
    return spacingFor({SpacingChoice::Kind::CellsAlong, cells}, sizeOf(mesh));
}

double spacingForObjectCount(const TriangleMesh& mesh, double objects)
{
    return spacingFor({SpacingChoice::Kind::Objects, objects}, sizeOf(mesh));
}

} // namespace knead
