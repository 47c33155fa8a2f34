#include "core/simulation/scene.h"

#include "core/geometry/surface_distance.h"
#include "core/skin/refilled.h"
#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double depthRounding = 1e-9; // [a]: objects on a border belong to it whatever their last bits are

/// A set of CAD faces with fast look-up.
class FaceSet {
public:
    explicit FaceSet(std::vector<std::uint32_t> faces)
        : m_faces(std::move(faces))
    {
        std::sort(m_faces.begin(), m_faces.end());
    }

    bool contains(std::uint32_t face) const { return std::binary_search(m_faces.begin(), m_faces.end(), face); }

private:
    std::vector<std::uint32_t> m_faces;
};

TriangleMesh trianglesOf(const TriangleMesh& mesh, const FaceSet& faces)
{
    TriangleMesh part;
    for (std::size_t t = 0; t < mesh.faceOfTriangle.size(); ++t)
        if (faces.contains(mesh.faceOfTriangle[t]))
            part.triangles.push_back(mesh.triangles[t]);
    if (!part.empty())
        part.vertices = mesh.vertices;
    return part;
}

std::vector<ObjectIndex> markedObjects(const std::vector<std::uint8_t>& marks)
{
    std::vector<ObjectIndex> objects;
    for (ObjectIndex object = 0; object < marks.size(); ++object)
        if (marks[object] != 0)
            objects.push_back(object);
    return objects;
}

} // namespace

/// An object outside belongs to the faces when the place of the surface nearest to it does. The corners of kept cells
/// are hardly ever further out than `beyond`.
std::vector<ObjectIndex> objectsAtFaces(const Aggregate& aggregate, const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& faces)
{
    constexpr double within = 0.5; // [a]
    constexpr double beyond = 1.5; // [a]
    const FaceSet chosen(faces);
    const TriangleMesh part = trianglesOf(aggregate.former ? surfaceWhenFilled(mesh, aggregate) : mesh, chosen);
    if (part.empty())
        return {};
    const SurfaceDistance surface(part);
    const double a = aggregate.lattice.spacing;
    std::vector<std::uint8_t> marks(aggregate.size(), 0);
    forEachBlock(aggregate.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (aggregate.depth[i] > (within + depthRounding) * a)
                continue;
            const double distance = surface.nearest(aggregate.lattice.position(static_cast<ObjectIndex>(i))).distance;
            const bool outside = aggregate.depth[i] < -depthRounding * a && chosen.contains(aggregate.face[i]);
            marks[i] = distance <= ((outside ? beyond : within) + depthRounding) * a ? 1 : 0;
        }
    });
    return markedObjects(marks);
}

std::vector<ObjectIndex> objectsInBox(const Aggregate& aggregate, const Box& box)
{
    const Vec3 margin = Vec3::Constant(depthRounding * aggregate.lattice.spacing);
    const Box wider(box.min() - margin, box.max() + margin);
    std::vector<ObjectIndex> objects;
    for (ObjectIndex object = 0; object < aggregate.size(); ++object)
        if (wider.contains(aggregate.lattice.position(object)))
            objects.push_back(object);
    return objects;
}

} // namespace knead
