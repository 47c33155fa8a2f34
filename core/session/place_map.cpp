#include "core/session/place_map.h"

#include "core/task/parallel.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

constexpr double nearestShare = 1e-3;    // of the size: how near a face counts as at it
constexpr std::size_t placesAtOnce = 16; // between looks at whether to go on; each asks all faces
constexpr double pullDistance = 10;      // sizes: a face so far away says as much as the median does

double scaleOf(const AffineMap& map)
{
    return std::cbrt(std::abs(map.linear.determinant()));
}

/// The triangles of each face. @param faces how many there are
std::vector<std::vector<std::uint32_t>> trianglesOfFaces(const TriangleMesh& mesh, std::size_t faces)
{
    std::vector<std::vector<std::uint32_t>> triangles(faces);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (const std::uint32_t face = mesh.faceOfTriangle.empty() ? 0 : mesh.faceOfTriangle[t]; face < faces)
            triangles[face].push_back(t);
    return triangles;
}

/// Some triangles by themselves.
TriangleMesh meshOf(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles)
{
    TriangleMesh piece;
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    for (const std::uint32_t t : triangles) {
        TriangleMesh::Triangle& triangle = piece.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.triangles[t][k];
            const auto [at, isNew] = number.emplace(vertex, static_cast<std::uint32_t>(piece.vertices.size()));
            if (isNew)
                piece.vertices.push_back(mesh.vertices[vertex]);
            triangle[k] = at->second;
        }
    }
    return piece;
}

Vec3 medianOf(std::vector<Vec3> vectors)
{
    Vec3 median = Vec3::Zero();
    if (vectors.empty())
        return median;
    for (int axis = 0; axis < 3; ++axis) {
        const auto middle = vectors.begin() + static_cast<std::ptrdiff_t>(vectors.size() / 2);
        std::ranges::nth_element(vectors, middle, {}, [axis](const Vec3& v) { return v[axis]; });
        median[axis] = (*middle)[axis];
    }
    return median;
}

} // namespace

struct PlaceMap::Face {
    TriangleMesh mesh;
    std::optional<SurfaceDistance> distance; // of the mesh
    Vec3 beyond = Vec3::Zero();              // d
    double grown = 0;                        // in radius [m]
    Mat3 known = Mat3::Zero();               // P

    /// d and what grew, where the surface faces that way there.
    Vec3 wantedAt(const SurfaceDistance::Hit& hit, const Mat3& turn) const
    {
        const Vec3 normal = crossOf(mesh.vertices, mesh.triangles[hit.triangle]).normalized();
        return beyond + grown * (turn * normal);
    }
};

PlaceMap::PlaceMap(const Part& before, std::span<const FaceLook> looksBefore, std::span<const FaceLook> looksAfter,
                   std::span<const FaceMatch> matches, const AffineMap& base, const TaskControl& control)
    : m_base(base)
{
    const double scale = scaleOf(base);
    const Mat3 turn = base.linear / scale;
    const std::vector<std::vector<std::uint32_t>> triangles = trianglesOfFaces(before.mesh, looksBefore.size());
    std::vector<std::unique_ptr<const Face>> faces(matches.size());
    forEachBlock(matches.size(), 1, control, [&](std::size_t i, std::size_t) {
        const FaceMatch& match = matches[i];
        if (triangles[match.before].empty())
            return;
        const FaceLook& from = looksBefore[match.before];
        const FaceLook& to = looksAfter[match.after];
        auto face = std::make_unique<Face>();
        face->mesh = meshOf(before.mesh, triangles[match.before]);
        face->distance.emplace(face->mesh);
        face->beyond = to.center - base.at(from.center);
        face->grown = to.bulge - scale * from.bulge;
        face->known = turn * from.spread * turn.transpose();
        faces[i] = std::move(face);
    });
    std::vector<Vec3> all;
    for (auto& face : faces)
        if (face) {
            all.push_back(face->beyond);
            m_faces.push_back(std::move(face));
        }
    m_median = medianOf(std::move(all));
    const double size = std::max(boxOfPlaces(before.mesh.vertices).diagonal().norm(), 1e-9);
    m_nearest = nearestShare * size;
    m_pull = std::pow(pullDistance * size, -4);
}

PlaceMap::~PlaceMap() = default;

Vec3 PlaceMap::beyond(const Vec3& place) const
{
    const Mat3 turn = m_base.linear / scaleOf(m_base);
    Mat3 sum = m_pull * Mat3::Identity();
    Vec3 wanted = m_pull * m_median;
    for (const auto& face : m_faces) {
        const SurfaceDistance::Hit hit = face->distance->nearest(place);
        const double nearness = 1 / (hit.distance * hit.distance + m_nearest * m_nearest);
        const Mat3 weighed = nearness * nearness * face->known;
        sum += weighed;
        wanted += weighed * face->wantedAt(hit, turn);
    }
    return sum.ldlt().solve(wanted);
}

std::vector<Vec3> PlaceMap::at(std::span<const Vec3> places, const TaskControl& control) const
{
    std::vector<Vec3> result(places.size());
    forEachBlock(places.size(), placesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result[i] = at(places[i]);
    });
    return result;
}

} // namespace knead
