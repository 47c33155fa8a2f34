#include "core/aggregate/fill.h"

#include "core/aggregate/cell_corners.h"
#include "core/aggregate/cut_cells.h"
#include "core/aggregate/moment_weights.h"
#include "core/aggregate/row_repair.h"
#include "core/aggregate/skin_balance.h"
#include "core/aggregate/skin_points.h"
#include "core/aggregate/spacing_choice.h"
#include "core/geometry/half_edges.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_cleaning.h"
#include "core/geometry/surface_distance.h"
#include "core/message/message.h"
#include "core/message/number_text.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knead {

namespace {

constexpr double rounding = 1e-9;     // of lengths
constexpr double mostDoubtful = 0.03; // of the volume, where the surface has holes
constexpr int exactLayers = 1;        // objects up to so many steps from the corners of cut cells get their exact depth

std::string inMillimetres(double length)
{
    return inDigits(length * 1000) + " mm";
}

[[noreturn]] void refuseTooManyObjects(const FillOptions& options)
{
    throw Problem(Message("Filling", "A spacing of %1 needs more than %2 objects. Choose a larger spacing.")
                      .with(inMillimetres(options.spacing), options.maximumObjects));
}

void checkVertices(const TriangleMesh& mesh)
{
    if (mesh.empty())
        throw Problem(Message("Filling",
                              "The part has no triangles, so there is nothing to fill. Import a part with a surface."));
    for (const Vec3& vertex : mesh.vertices)
        if (!vertex.allFinite())
            throw Problem(Message(
                "Filling", "A vertex of the surface is not at a finite place. Repair the file and import again."));
}

/// @returns its half-edges
HalfEdges checkClosed(const TriangleMesh& mesh)
{
    HalfEdges halfEdges = findHalfEdges(mesh);
    if (halfEdges.unpaired > 0)
        throw Problem(Message("Filling",
                              "The surface is not closed: %1 edges of triangles have no partner. Close the gaps "
                              "and import again.")
                          .with(halfEdges.unpaired));
    return halfEdges;
}

/// Refuses what could not be stored, before anything is allocated.
void checkSize(const MassProperties& properties, const FillOptions& options)
{
    const double a = options.spacing;
    if (!std::isfinite(a) || a <= 0)
        throw Problem(
            Message("Filling", "A spacing of %1 cannot be used. Enter a length above 0.").with(inMillimetres(a)));
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

/// How deep a flat surface through the cells around an object would be under it. For objects at holes.
double depthFromFullness(const Aggregate& aggregate, ObjectIndex object)
{
    const double a = aggregate.lattice.spacing;
    return std::clamp(2 * aggregate.volume[object] / (a * a * a) - 1, -1.0, 1.0) * a;
}

/// Depth of an object that is `distance` from a dirty surface, whose normals do not tell inside from outside.
/// A surface object further away than any surface in the cells around it could be is at a hole.
double depthAtDirtySurface(const CellCorners& corners, ObjectIndex object, double distance, const RowRepair& repair)
{
    const Lattice& lattice = corners.aggregate.lattice;
    const double acrossCell = std::sqrt(3.0) * lattice.spacing;
    if (corners.isSurface[object] != 0 && distance > (1 + rounding) * acrossCell)
        return depthFromFullness(corners.aggregate, object);
    const double winding = repair.orientation() * repair.windingNumber().at(lattice.position(object));
    return winding >= 0.5 ? distance : -distance;
}

/// All cells within exactLayers + 1 steps of the other objects are full, so these are at least that deep, as are those to
/// which no surface is nearer.
/// @param repair of a dirty surface, else null
void measureDepth(CellCorners& corners, const TriangleMesh& mesh, HalfEdges halfEdges, double orientation,
                  const RowRepair* repair, TaskControl& control)
{
    Aggregate& aggregate = corners.aggregate;
    const std::vector<ObjectIndex> nearSurface = objectsNearSurface(corners);
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
            if (!hit) {
                if (repair != nullptr)
                    aggregate.depth[object] = depthAtDirtySurface(corners, object, deep, *repair);
                continue;
            }
            guess = hit->triangle;
            aggregate.depth[object] = repair != nullptr ? depthAtDirtySurface(corners, object, hit->distance, *repair)
                                                        : -orientation * hit->signedDistance;
            if (!mesh.faceOfTriangle.empty())
                aggregate.face[object] = mesh.faceOfTriangle[hit->triangle];
        }
    });
}

void checkBoundsVolume(const CutCells& cells, bool isClosed)
{
    if (isClosed && cells.decided() == 0)
        return;
    const double volume = cells.volume();
    if (volume <= 0 || cells.doubtful() > mostDoubtful * volume)
        throw Problem(Message("Filling",
                              "The surface does not bound a volume: its holes are too large to tell inside from "
                              "outside. Close them and import again."));
}

/// @param cleaned what was done to the surface already; none: the surface must be closed
Aggregate fillSurface(const TriangleMesh& mesh, HalfEdges halfEdges, const SurfaceRepair* cleaned,
                      const FillOptions& options, TaskControl& control)
{
    const MassProperties properties = massProperties(mesh);
    checkSize(properties, options);

    const double orientation = properties.volume < 0 ? -1 : 1;
    const CellGrid grid = gridAround(properties.box, options.spacing, options.rowAxis);
    std::optional<RowRepair> repair;
    if (cleaned != nullptr)
        repair.emplace(mesh, halfEdges, grid, orientation);
    TaskPortion cutting(control, 0.1, 0.5);
    const CutCells cells =
        cutCells(mesh, grid, orientation, options.minimumFraction, cutting, repair ? &*repair : nullptr);
    checkBoundsVolume(cells, halfEdges.unpaired == 0);
    if (cells.size() == 0)
        throw Problem(Message("Filling",
                              "The part is too thin for a spacing of %1: no cell holds enough material. Choose a "
                              "smaller spacing.")
                          .with(inMillimetres(options.spacing)));
    if (countCorners(cells) > std::min<std::size_t>(options.maximumObjects, 0x7fffffff))
        refuseTooManyObjects(options);

    TaskPortion joining(control, 0.5, 0.55);
    CellCorners corners = joinCells(cells, grid, joining);
    TaskPortion fitting(control, 0.55, 0.65);
    corners.aggregate = withFittedMoments(cells, std::move(corners.aggregate), fitting);
    TaskPortion balancing(control, 0.65, 0.85);
    corners.aggregate = withBalancedSkin(cells, std::move(corners.aggregate), corners.isSurface, balancing);
    corners.aggregate.meshVolume = std::abs(properties.volume);
    const bool isDirty = cells.decided() > 0;
    if (isDirty)
        corners.aggregate.meshVolume = corners.aggregate.filledVolume;
    if (cleaned != nullptr) {
        corners.aggregate.repair = *cleaned;
        corners.aggregate.repair.decidedCells = cells.decided();
        corners.aggregate.repair.doubtfulShare = cells.doubtful() / cells.volume();
    }
    TaskPortion measuring(control, 0.85, 1);
    corners.aggregate.skin = skinPoints(mesh, corners.aggregate.lattice, orientation);
    measureDepth(corners, mesh, std::move(halfEdges), orientation, isDirty ? &*repair : nullptr, measuring);
    return std::move(corners.aggregate);
}

} // namespace

Aggregate fill(const TriangleMesh& mesh, const FillOptions& options, TaskControl& control)
{
    control.report(0, "checking the surface");
    checkVertices(mesh);
    if (options.dirty == DirtySurface::refuse)
        return fillSurface(mesh, checkClosed(mesh), nullptr, options, control);
    const CleanSurface clean = cleanSurface(mesh);
    const SurfaceRepair repair{.removedTriangles = clean.removed, .flippedTriangles = clean.flipped};
    return fillSurface(clean.mesh, findHalfEdges(clean.mesh), &repair, options, control);
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
