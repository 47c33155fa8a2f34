#include "io/mesh/volume_fit.h"

#include "io/brep/millimeter.h"

#include <BRepAdaptor_Surface.hxx>
#include <Eigen/Eigenvalues>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cstddef>

namespace knead {

namespace {

/// Of a paraboloid over its triangle: the volume is so much of area times height in the middle.
constexpr double meanHeight = 0.75;
/// Faces that meet at less than some 35 degrees move a common point along their common normal: exactly along both would be
/// far along the edge.
constexpr double leastShare = 0.09;       // of the sum of the eigenvalues
constexpr double sameSquaredAngle = 1e-9; // squared angle

/// Twice the area, along the normal.
Vec3 crossOf(const std::vector<Vec3>& vertices, const TriangleMesh::Triangle& t)
{
    const Vec3& a = vertices[t[0]];
    return (vertices[t[1]] - a).cross(vertices[t[2]] - a);
}

/// What faces ask of a point: flat ones that it stays on them, others that it moves along their normals.
class Requests {
public:
    void stayOn(const Vec3& normal) { m_flat += normal * normal.transpose(); }

    void moveAlong(const Vec3& normal, double distance)
    {
        m_curved += normal * normal.transpose();
        m_distances += distance * normal;
    }

    /// The shortest move that fulfills the former exactly and the latter as well as can be.
    Vec3 move() const
    {
        if (m_distances.isZero(0))
            return Vec3::Zero();
        Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> flat(m_flat);
        for (int i = 0; i < 3; ++i)
            if (flat.eigenvalues()[i] > sameSquaredAngle)
                free -= flat.eigenvectors().col(i) * flat.eigenvectors().col(i).transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> curved(free * m_curved * free);
        Vec3 result = Vec3::Zero();
        for (int i = 0; i < 3; ++i)
            if (const double value = curved.eigenvalues()[i]; value > leastShare * m_curved.trace()) {
                const Vec3 axis = curved.eigenvectors().col(i);
                result += axis.dot(m_distances) / value * axis;
            }
        return free * result;
    }

private:
    Eigen::Matrix3d m_flat = Eigen::Matrix3d::Zero();   // sum of n n^T
    Eigen::Matrix3d m_curved = Eigen::Matrix3d::Zero(); // sum of n n^T
    Vec3 m_distances = Vec3::Zero();                    // sum of n times distance
};

/// Takes moves back that turn a triangle over.
void keepSides(const TriangleMesh& mesh, const std::vector<std::uint32_t>& pointOfNode, std::vector<Vec3>& moves)
{
    std::vector<Vec3> moved(mesh.vertices.size());
    for (bool isAnyTurned = true; isAnyTurned;) {
        for (std::size_t node = 0; node < moved.size(); ++node)
            moved[node] = mesh.vertices[node] + moves[pointOfNode[node]];
        isAnyTurned = false;
        for (const TriangleMesh::Triangle& t : mesh.triangles) {
            const bool isMoved =
                std::any_of(t.begin(), t.end(), [&](auto n) { return !moves[pointOfNode[n]].isZero(0); });
            const Vec3 before = crossOf(mesh.vertices, t);
            const bool isLine = pointOfNode[t[0]] == pointOfNode[t[1]] || pointOfNode[t[1]] == pointOfNode[t[2]] ||
                                pointOfNode[t[2]] == pointOfNode[t[0]];
            if (!isMoved || isLine || crossOf(moved, t).dot(before) > 0)
                continue;
            isAnyTurned = true;
            for (const std::uint32_t node : t)
                moves[pointOfNode[node]].setZero();
        }
    }
}

} // namespace

void VolumeFit::addFace(const TopoDS_Face& face, const Poly_Triangulation& triangulation, const TriangleMesh& mesh,
                        std::uint32_t firstNode)
{
    m_heights.resize(mesh.triangles.size(), 0);
    const BRepAdaptor_Surface surface(face, false);
    const bool isFlat = surface.GetType() == GeomAbs_Plane;
    m_isFlat.resize(mesh.vertices.size(), isFlat ? 1 : 0);
    if (isFlat || !triangulation.HasUVNodes())
        return;
    const std::size_t first = mesh.triangles.size() - static_cast<std::size_t>(triangulation.NbTriangles());
    for (std::size_t t = first; t < mesh.triangles.size(); ++t) {
        const TriangleMesh::Triangle& triangle = mesh.triangles[t];
        const Vec3 cross = crossOf(mesh.vertices, triangle);
        const double length = cross.norm();
        if (!(length > 0))
            continue;
        gp_XY parameters(0, 0);
        Vec3 middle = Vec3::Zero();
        for (const std::uint32_t node : triangle) {
            parameters += triangulation.UVNode(static_cast<int>(node - firstNode) + 1).XY() / 3;
            middle += mesh.vertices[node] / 3;
        }
        const gp_Pnt point = surface.Value(parameters.X(), parameters.Y());
        m_heights[t] = (millimeter * Vec3(point.X(), point.Y(), point.Z()) - middle).dot(cross) / length;
    }
}

std::vector<Vec3> VolumeFit::moves(const TriangleMesh& mesh, const std::vector<std::uint32_t>& pointOfNode,
                                   double longest) const
{
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    std::vector<double> areas(mesh.vertices.size(), 0);
    std::vector<double> distances(mesh.vertices.size(), 0); // times area
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 cross = crossOf(mesh.vertices, mesh.triangles[t]);
        const double area = cross.norm();
        for (const std::uint32_t node : mesh.triangles[t]) {
            normals[node] += cross;
            areas[node] += area;
            distances[node] += area * meanHeight * m_heights[t];
        }
    }
    std::vector<Requests> requests(mesh.vertices.size());
    for (std::size_t node = 0; node < mesh.vertices.size(); ++node) {
        const double length = normals[node].norm();
        if (!(length > 0))
            continue;
        Requests& ofPoint = requests[pointOfNode[node]];
        if (m_isFlat[node] != 0)
            ofPoint.stayOn(normals[node] / length);
        else
            ofPoint.moveAlong(normals[node] / length, distances[node] / areas[node]);
    }
    std::vector<Vec3> moves(mesh.vertices.size(), Vec3::Zero());
    for (std::size_t node = 0; node < mesh.vertices.size(); ++node)
        if (pointOfNode[node] == node) {
            const Vec3 move = requests[node].move();
            moves[node] = move * std::min(1.0, longest / std::max(move.norm(), 1e-300));
        }
    keepSides(mesh, pointOfNode, moves);
    for (std::size_t node = 0; node < mesh.vertices.size(); ++node)
        moves[node] = moves[pointOfNode[node]];
    return moves;
}

} // namespace knead
