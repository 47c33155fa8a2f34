#include "io/mesh/mesh_repair.h"

#include "core/message/message.h"
#include "core/model/number_words.h"
#include "io/brep/hole_closing.h"
#include "io/mesh/mesh_orientation.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;

Triangle sorted(Triangle triangle)
{
    std::sort(triangle.begin(), triangle.end());
    return triangle;
}

/// +1 when the corners run as in the sorted triangle, -1 when they run against it.
int senseOf(const Triangle& t)
{
    const int swaps = (t[0] > t[1] ? 1 : 0) + (t[1] > t[2] ? 1 : 0) + (t[0] > t[2] ? 1 : 0);
    return swaps % 2 == 0 ? 1 : -1;
}

TriangleMesh only(const TriangleMesh& mesh, const std::vector<char>& isKept)
{
    TriangleMesh result;
    result.vertices = mesh.vertices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (isKept[t]) {
            result.triangles.push_back(mesh.triangles[t]);
            if (!mesh.faceOfTriangle.empty())
                result.faceOfTriangle.push_back(mesh.faceOfTriangle[t]);
        }
    return result;
}

struct Stacks {
    std::vector<char> isKept; ///< per triangle: one of each stack, of the sense that prevails; none of a fold
    std::vector<char> isFold; ///< per triangle: first of a stack of which half face the other way
    std::size_t doubled = 0;  ///< triangles beyond the first of their sense
    std::size_t folds = 0;
};

/// Triangles of the same corners, however they run.
Stacks findStacks(const TriangleMesh& mesh)
{
    const std::size_t count = mesh.triangles.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::vector<Triangle> keys(count);
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), keys.begin(), sorted);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });

    Stacks stacks{std::vector<char>(count, 0), std::vector<char>(count, 0)};
    for (std::size_t begin = 0; begin < count;) {
        std::size_t end = begin;
        int sense = 0;
        for (; end < count && keys[order[end]] == keys[order[begin]]; ++end)
            sense += senseOf(mesh.triangles[order[end]]);
        if (sense == 0) {
            stacks.isFold[order[begin]] = 1;
            ++stacks.folds;
            stacks.doubled += end - begin - 2;
        } else {
            const auto prevails = [&](std::size_t t) { return senseOf(mesh.triangles[t]) * sense > 0; };
            stacks.isKept[*std::find_if(order.begin() + static_cast<std::ptrdiff_t>(begin), order.end(), prevails)] = 1;
            stacks.doubled += end - begin - 1;
        }
        begin = end;
    }
    return stacks;
}

/// A surface given with both its sides is all folds: one side of it is kept.
bool isDoubleSided(const Stacks& stacks)
{
    return 4 * stacks.folds > stacks.isKept.size();
}

void removeStacks(RepairedMesh& result)
{
    Stacks stacks = findStacks(result.mesh);
    if (stacks.doubled == 0 && stacks.folds == 0)
        return;
    if (stacks.doubled > 0)
        result.repairs.push_back(
            stacks.doubled == 1 ? Message("Repair", "1 triangle was there twice and removed.")
                                : Message("Repair", "%1 triangles were there twice and removed.").with(stacks.doubled));
    if (isDoubleSided(stacks)) {
        std::transform(stacks.isKept.begin(), stacks.isKept.end(), stacks.isFold.begin(), stacks.isKept.begin(),
                       [](char kept, char fold) { return static_cast<char>(kept | fold); });
        result.repairs.push_back(
            Message("Repair", "The surface was given with both its sides; one of them was removed."));
    } else if (stacks.folds > 0) {
        result.repairs.push_back(
            stacks.folds == 1
                ? Message("Repair", "1 pair of triangles back to back was removed.")
                : Message("Repair", "%1 pairs of triangles back to back were removed.").with(stacks.folds));
    }
    result.mesh = only(result.mesh, stacks.isKept);
}

} // namespace

TriangleMesh withoutFolds(const TriangleMesh& mesh)
{
    const Stacks stacks = findStacks(mesh);
    return stacks.folds == 0 || isDoubleSided(stacks) ? mesh : only(mesh, stacks.isKept);
}

RepairedMesh repaired(TriangleMesh mesh, bool capsFlatOpenings)
{
    RepairedMesh result{std::move(mesh), {}};
    removeStacks(result);
    if (const std::size_t turned = orient(result.mesh); turned > 0)
        result.repairs.push_back(
            turned == 1 ? Message("Repair", "1 triangle faced the wrong way and was turned.")
                        : Message("Repair", "%1 triangles faced the wrong way and were turned.").with(turned));
    HoleClosing closing = capsFlatOpenings ? closeHoles(std::move(result.mesh), 1) : closeHoles(std::move(result.mesh));
    result.mesh = std::move(closing.mesh);
    if (closing.holes > 0)
        result.repairs.push_back(closing.holes == 1
                                     ? Message("Repair", "1 small hole was closed, which added %1 to the area.")
                                           .with(percentWords(closing.addedShare))
                                     : Message("Repair", "%1 small holes were closed, which added %2 to the area.")
                                           .with(closing.holes, percentWords(closing.addedShare)));
    if (turnOutward(result.mesh))
        result.repairs.push_back(Message("Repair", "The surface was inside out and has been turned."));
    return result;
}

} // namespace knead
