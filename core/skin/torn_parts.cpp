#include "core/skin/torn_parts.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/skin/fragments.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

/// A crack has no color of its own: its face comes behind those of the part.
Part pieceOf(const Part& whole, TriangleMesh mesh, std::size_t number)
{
    Part piece;
    piece.name = whole.name + ", piece " + std::to_string(number);
    piece.path = whole.path + "/" + piece.name;
    piece.color = whole.color;
    piece.layer = whole.layer;
    piece.visible = whole.visible;
    piece.faces = whole.faces;
    piece.faces.emplace_back();
    const auto crack = static_cast<std::uint32_t>(piece.faces.size() - 1);
    for (std::uint32_t& face : mesh.faceOfTriangle)
        face = face < crack ? face : crack;
    const MassProperties properties = massProperties(mesh);
    piece.volume = properties.volume;
    piece.area = properties.area;
    piece.box = properties.box;
    piece.solids = piece.shells = 1;
    piece.watertight = piece.valid = true;
    piece.mesh = std::move(mesh);
    return piece;
}

/// The pieces of one part; none when it hangs together.
std::vector<PartToExport> piecesOf(const PartToExport& whole, std::size_t mostTriangles, TaskControl& control)
{
    if (whole.aggregate == nullptr || whole.broken == nullptr || whole.broken->empty())
        return {};
    const TriangleMesh skin = refine(whole.part.mesh, whole.aggregate->lattice.spacing, mostTriangles);
    std::vector<Fragment> fragments = fragmentsOf(*whole.aggregate, skin, *whole.broken, {}, control);
    if (fragments.size() < 2)
        return {};
    auto places = carried(*whole.aggregate, fragments, *whole.broken, whole.displacements, control);
    std::vector<PartToExport> pieces;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        fragments[i].mesh.vertices = std::move(places[i]);
        PartToExport piece{.part = pieceOf(whole.part, std::move(fragments[i].mesh), i + 1)};
        piece.density = whole.density;
        piece.reason = "the part is torn; this is one of " + std::to_string(fragments.size()) + " pieces.";
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Puts what has become of the parts into the tree.
/// @param first number of the first piece of each part, and how many there are
void renumber(PartNode& node, const std::vector<std::pair<std::size_t, std::size_t>>& pieces,
              const std::vector<PartToExport>& parts)
{
    for (PartNode& child : node.children)
        renumber(child, pieces, parts);
    if (!node.part)
        return;
    const auto [first, count] = pieces[*node.part];
    if (count == 1) {
        node.part = first;
        return;
    }
    node.part.reset();
    for (std::size_t i = first; i < first + count; ++i)
        node.children.push_back({parts[i].part.name, i, {}});
}

} // namespace

ExportJob withPieces(ExportJob job, std::size_t mostTriangles, TaskControl& control)
{
    ExportJob result;
    result.options = job.options;
    std::vector<std::pair<std::size_t, std::size_t>> numbers;
    const auto count = static_cast<double>(job.parts.size());
    for (PartToExport& part : job.parts) {
        const auto done = static_cast<double>(numbers.size());
        TaskPortion portion(control, done / count, (done + 1) / count);
        std::vector<PartToExport> pieces = piecesOf(part, mostTriangles, portion);
        if (pieces.empty())
            pieces.push_back(std::move(part));
        numbers.emplace_back(result.parts.size(), pieces.size());
        std::move(pieces.begin(), pieces.end(), std::back_inserter(result.parts));
    }
    result.tree = std::move(job.tree);
    renumber(result.tree, numbers, result.parts);
    return result;
}

} // namespace knead
