#include "io/mesh/mesh_orientation.h"

#include "core/geometry/mass_properties.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace knead {

namespace {

/// A triangle beside another one across an edge that no third one shares.
struct Neighbor {
    std::uint32_t triangle;
    bool agrees; ///< both run along the edge in opposite ways
};

class Neighborhood {
public:
    explicit Neighborhood(const TriangleMesh& mesh)
        : m_neighbors(mesh.triangles.size())
    {
        struct Use {
            std::uint32_t low;
            std::uint32_t high;
            std::uint32_t triangle;
            bool isForward;
        };
        std::vector<Use> uses;
        uses.reserve(3 * mesh.triangles.size());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.triangles[t][i];
                const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
                uses.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(t), a < b});
            }
        std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
            return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
        });
        const auto isSameEdge = [&](std::size_t i, std::size_t j) {
            return j < uses.size() && uses[i].low == uses[j].low && uses[i].high == uses[j].high;
        };
        for (std::size_t i = 0; i < uses.size();) {
            std::size_t end = i;
            while (isSameEdge(i, end))
                ++end;
            if (end - i == 2) {
                const bool agrees = uses[i].isForward != uses[i + 1].isForward;
                m_neighbors[uses[i].triangle].push_back({uses[i + 1].triangle, agrees});
                m_neighbors[uses[i + 1].triangle].push_back({uses[i].triangle, agrees});
            }
            i = end;
        }
    }

    const std::vector<Neighbor>& of(std::uint32_t triangle) const { return m_neighbors[triangle]; }

private:
    std::vector<std::vector<Neighbor>> m_neighbors;
};

void turn(TriangleMesh::Triangle& triangle)
{
    std::swap(triangle[1], triangle[2]);
}

/// A connected piece, and which of its triangles disagree with its first one.
struct Piece {
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> against;
    bool isTwoSided = true;
};

std::vector<Piece> piecesOf(const TriangleMesh& mesh)
{
    const Neighborhood neighborhood(mesh);
    constexpr signed char unseen = 0;
    std::vector<signed char> sense(mesh.triangles.size(), unseen);
    std::vector<Piece> pieces;
    for (std::uint32_t seed = 0; seed < sense.size(); ++seed) {
        if (sense[seed] != unseen)
            continue;
        Piece piece;
        sense[seed] = 1;
        piece.triangles.push_back(seed);
        for (std::size_t next = 0; next < piece.triangles.size(); ++next) {
            const std::uint32_t triangle = piece.triangles[next];
            if (sense[triangle] < 0)
                piece.against.push_back(triangle);
            for (const Neighbor& neighbor : neighborhood.of(triangle)) {
                const auto wanted = static_cast<signed char>(neighbor.agrees ? sense[triangle] : -sense[triangle]);
                if (sense[neighbor.triangle] == unseen) {
                    sense[neighbor.triangle] = wanted;
                    piece.triangles.push_back(neighbor.triangle);
                } else if (sense[neighbor.triangle] != wanted) {
                    piece.isTwoSided = false;
                }
            }
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

TriangleMesh meshOf(const TriangleMesh& mesh, const Piece& piece)
{
    TriangleMesh result;
    result.vertices = mesh.vertices;
    for (const std::uint32_t triangle : piece.triangles)
        result.triangles.push_back(mesh.triangles[triangle]);
    return result;
}

/// Signed solid angle under which a point sees a triangle (van Oosterom and Strackee 1983).
double solidAngle(const TriangleMesh& mesh, const TriangleMesh::Triangle& t, const Vec3& point)
{
    const Vec3 a = mesh.vertices[t[0]] - point;
    const Vec3 b = mesh.vertices[t[1]] - point;
    const Vec3 c = mesh.vertices[t[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool isInside(const Vec3& point, const TriangleMesh& closed)
{
    double angle = 0;
    for (const TriangleMesh::Triangle& triangle : closed.triangles)
        angle += solidAngle(closed, triangle, point);
    return std::abs(angle) > 2 * std::numbers::pi;
}

} // namespace

std::size_t orient(TriangleMesh& mesh)
{
    std::size_t turned = 0;
    for (const Piece& piece : piecesOf(mesh)) {
        if (piece.against.empty() || !piece.isTwoSided)
            continue;
        const bool fewAgainst = 2 * piece.against.size() <= piece.triangles.size();
        for (const std::uint32_t triangle : piece.against)
            turn(mesh.triangles[triangle]);
        if (!fewAgainst)
            for (const std::uint32_t triangle : piece.triangles)
                turn(mesh.triangles[triangle]);
        turned += std::min(piece.against.size(), piece.triangles.size() - piece.against.size());
    }
    return turned;
}

bool turnOutward(TriangleMesh& mesh)
{
    const std::vector<Piece> pieces = piecesOf(mesh);
    std::vector<TriangleMesh> closed;
    std::vector<std::size_t> pieceOf;
    constexpr std::size_t mostPieces = 64; // each is compared with each
    if (pieces.size() > mostPieces)
        return false;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (TriangleMesh own = meshOf(mesh, pieces[i]); isWatertight(own)) {
            closed.push_back(std::move(own));
            pieceOf.push_back(i);
        }
    bool found = false;
    for (std::size_t i = 0; i < closed.size(); ++i) {
        if (massProperties(closed[i]).volume >= 0)
            continue;
        const Vec3 point = closed[i].vertices[closed[i].triangles.front().front()];
        bool isVoid = false;
        for (std::size_t other = 0; other < closed.size() && !isVoid; ++other)
            isVoid = other != i && isInside(point, closed[other]);
        if (isVoid)
            continue;
        for (const std::uint32_t triangle : pieces[pieceOf[i]].triangles)
            turn(mesh.triangles[triangle]);
        found = true;
    }
    return found;
}

} // namespace knead
