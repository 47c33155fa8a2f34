#include "core/session/deformed_model.h"

#include "core/deformation/number_placement.h"
#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/model/part_tree.h"
#include "core/session/export_jobs.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/former_shape.h"
#include "core/skin/torn_parts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t mostDeformedTriangles = 400'000;
constexpr double edges = 200;         // of a mesh, across it
constexpr double leastWay = 1e-9;     // of the size of a part; objects that have moved less are where they were
constexpr double mappingShare = 0.05; // of the progress
constexpr double meshShare = 0.15;

bool isMeant(const std::vector<bool>& which, std::size_t part)
{
    return which.empty() || which[part];
}

bool isInPieces(const PartToExport& part)
{
    return part.aggregate &&
           ((part.broken && !part.broken->empty()) || (part.aggregate->former && part.aggregate->former->isInPieces()));
}

bool isWhereItWas(const PartToExport& part)
{
    if (part.aggregate == nullptr)
        return true;
    const double least = leastWay * part.part.box.diagonal().norm();
    return !part.aggregate->former && !isInPieces(part) &&
           std::ranges::all_of(part.displacements, [least](const Vec3& way) { return way.norm() <= least; });
}

void measure(Part& part)
{
    part.box = {};
    part.area = 0;
    for (const Vec3& vertex : part.mesh.vertices)
        part.box.extend(vertex);
    for (const TriangleMesh::Triangle& triangle : part.mesh.triangles)
        part.area += crossOf(part.mesh.vertices, triangle).norm() / 2;
    part.volume = part.watertight ? massProperties(part.mesh).volume : 0;
}

/// @throws Problem for a bend that would fold material over itself
void refuseFolds(const TriangleMesh& mesh, const std::vector<Deformation>& deformations)
{
    TriangleMesh now = mesh;
    for (const Deformation& deformation : deformations) {
        const auto* number = std::get_if<NumberDeformation>(&deformation);
        if (number == nullptr)
            return; // where a field takes the mesh is seen when it is carried
        if (const auto fold = foldOf(*number, now))
            throw Problem(*fold);
        mapOf(deformation)->evaluate(std::vector<Vec3>(now.vertices), now.vertices);
    }
}

/// The numbers of parts in the order of a tree, in which a file has them.
void listParts(const PartNode& node, std::vector<std::size_t>& order)
{
    if (node.part)
        order.push_back(*node.part);
    for (const PartNode& child : node.children)
        listParts(child, order);
}

/// Under the node of a part that has become several.
void putPieces(PartNode& node, std::size_t part, const std::vector<std::size_t>& pieces, const Model& model)
{
    for (PartNode& child : node.children)
        putPieces(child, part, pieces, model);
    if (node.part != part)
        return;
    node.part.reset();
    for (const std::size_t piece : pieces)
        node.children.push_back({model.parts[piece].name, piece, {}});
}

/// Makes a model after deformations, part by part.
class Deformer {
public:
    Deformer(const Model& model, const PresentShape& now, std::shared_ptr<const std::vector<Deformation>> deformations,
             const std::vector<bool>& which, const WriteAndRead& writeAndRead)
        : m_model(model)
        , m_deformations(std::move(deformations))
        , m_writeAndRead(writeAndRead)
    {
        const Snapshot none;
        m_parts = exportJobOf(model, now.snapshot ? std::span(now.partOfBody) : std::span<const std::size_t>(),
                              now.snapshot ? *now.snapshot : none)
                      .parts;
        for (std::size_t p = 0; p < m_parts.size(); ++p) {
            PartToExport& part = m_parts[p];
            part.relaxed.reset();
            if (isWhereItWas(part))
                part.aggregate = nullptr;
            m_result.isOfRest = m_result.isOfRest && part.aggregate == nullptr;
            if (part.aggregate == nullptr)
                part.displacements.clear();
            if (isMeant(which, p))
                part.deformations = m_deformations;
        }
    }

    DeformedModel make(TaskControl& control)
    {
        m_result.model = m_model;
        for (std::size_t p = 0; p < m_parts.size(); ++p)
            m_result.origin.push_back(p);
        for (const PartToExport& part : m_parts)
            if (part.deformations && !part.aggregate)
                refuseFolds(part.part.mesh, *m_deformations);
        TaskPortion mapping(control, 0, mappingShare);
        for (const PartToExport& part : m_parts)
            if (part.deformations && !part.part.exact && !m_map)
                m_map = mapOf(std::span(*m_deformations), mapping);
        TaskPortion carrying(control, mappingShare, meshShare);
        std::vector<bool> together(m_parts.size());
        for (std::size_t p = 0; p < m_parts.size(); ++p) {
            const bool isChanged = m_parts[p].deformations || m_parts[p].aggregate;
            together[p] = isChanged && m_parts[p].part.exact && !isInPieces(m_parts[p]);
            if (isChanged && !m_parts[p].part.exact)
                carryMesh(p, carrying);
        }
        TaskPortion writing(control, meshShare, 1);
        writeAll(together, writing);
        return std::move(m_result);
    }

private:
    /// Those that stay in one piece as one file; each of the others by itself, so that it is known whose pieces are whose.
    void writeAll(const std::vector<bool>& together, TaskControl& control)
    {
        std::vector<std::vector<bool>> files;
        if (std::ranges::count(together, true) > 0)
            files.push_back(together);
        for (std::size_t p = 0; p < m_parts.size(); ++p)
            if (m_parts[p].part.exact && isInPieces(m_parts[p]))
                files.emplace_back(m_parts.size())[p] = true;
        for (std::size_t i = 0; i < files.size(); ++i) {
            TaskPortion portion = TaskPortion::ofItem(control, i, files.size());
            write(files[i], portion);
        }
    }

    void write(const std::vector<bool>& keep, TaskControl& control)
    {
        ExportJob job;
        job.tree = prunedTree(m_model.tree, keep);
        std::vector<std::size_t> kept;
        for (std::size_t p = 0; p < keep.size(); ++p)
            if (keep[p]) {
                kept.push_back(p);
                job.parts.push_back(m_parts[p]);
            }
        std::vector<std::size_t> order;
        listParts(job.tree, order);
        WrittenModel written = m_writeAndRead(std::move(job), control);
        std::vector<Part>& read = written.model.parts;
        if (read.size() < kept.size() || (kept.size() > 1 && read.size() != kept.size()) || order.size() != kept.size())
            throw Problem(Message("Deformation", "%1 of %2 parts came back from being deformed; nothing was changed.")
                              .with(read.size(), kept.size()));
        if (kept.size() == 1)
            replace(kept.front(), std::move(read));
        else
            for (std::size_t i = 0; i < order.size(); ++i)
                replace(kept[order[i]], {std::move(read[i])});
        ExportReport& report = m_result.report;
        if (report.parts.empty())
            report = std::move(written.report);
        else
            std::ranges::move(written.report.parts, std::back_inserter(report.parts));
    }

    /// A mesh, or what its objects make of it, where the deformations take it.
    void carryMesh(std::size_t p, TaskControl& control)
    {
        ExportJob job;
        job.parts.push_back(m_parts[p]);
        job.tree = {m_model.parts[p].name, std::size_t{0}, {}};
        std::vector<Part> pieces;
        for (PartToExport& piece : withPieces(std::move(job), mostDeformedTriangles, control).parts) {
            Part& part = pieces.emplace_back(std::move(piece.part));
            if (piece.aggregate)
                part.mesh =
                    deformedSurface(part.mesh, *piece.aggregate, piece.displacements, mostDeformedTriangles, control);
            if (piece.deformations) {
                const double longest =
                    std::max(m_map->featureSize() / 4, m_model.parts[p].box.diagonal().norm() / edges);
                part.mesh = carriedMesh(part.mesh, *m_map, longest, mostDeformedTriangles);
                for (std::vector<Vec3>& edge : part.openEdges)
                    m_map->evaluate(std::vector<Vec3>(edge), edge);
            }
            measure(part);
        }
        replace(p, std::move(pieces));
    }

    /// Puts what has become of a part in its place, under its name.
    void replace(std::size_t p, std::vector<Part> pieces)
    {
        Model& model = m_result.model;
        std::vector<std::size_t> places;
        for (Part& piece : pieces) {
            const Part& before = m_model.parts[p];
            piece.visible = before.visible;
            piece.layer = before.layer;
            piece.repairs.clear();
            if (pieces.size() == 1) {
                piece.name = before.name;
                piece.path = before.path;
                piece.bodyOf = before.bodyOf;
            } else {
                piece.path = before.path + "/" + piece.name;
                piece.bodyOf.clear();
            }
            places.push_back(places.empty() ? p : model.parts.size());
            if (places.back() == p) {
                model.parts[p] = std::move(piece);
                continue;
            }
            model.parts.push_back(std::move(piece));
            m_result.origin.push_back(p);
        }
        if (places.size() > 1)
            putPieces(model.tree, p, places, model);
    }

    const Model& m_model;
    std::shared_ptr<const std::vector<Deformation>> m_deformations;
    const WriteAndRead& m_writeAndRead;
    std::vector<PartToExport> m_parts;      ///< of the model, as they are now
    std::shared_ptr<const SmoothMap> m_map; ///< where meshes need it
    DeformedModel m_result;
};

} // namespace

DeformedModel deformedModel(const Model& model, const PresentShape& now,
                            const std::shared_ptr<const std::vector<Deformation>>& deformations,
                            const std::vector<bool>& which, const WriteAndRead& writeAndRead, TaskControl& control)
{
    return Deformer(model, now, deformations, which, writeAndRead).make(control);
}

DeformedModel deformedModel(const Model& model, const std::shared_ptr<const std::vector<Deformation>>& deformations,
                            const std::vector<bool>& which, const WriteAndRead& writeAndRead, TaskControl& control)
{
    return deformedModel(model, {}, deformations, which, writeAndRead, control);
}

} // namespace knead
