#include "io/mesh/open_borders.h"

#include "core/geometry/half_edges.h"
#include "core/model/number_words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t mostLinesChained = 5000; // each with each

struct OpenEdge {
    std::uint32_t end;
    std::uint32_t face;
};

double extentOf(const Polyline& line)
{
    Box box;
    for (const Vec3& point : line)
        box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Whether a border comes back to its start and stays within a hundredth of its size of a plane: what is missing there
/// is one flat face.
bool isFlatLoop(const Polyline& line)
{
    constexpr double flat = 0.01;
    const double extent = extentOf(line);
    if ((line.back() - line.front()).norm() > 1e-3 * extent)
        return false;
    Vec3 middle = Vec3::Zero();
    Vec3 normal = Vec3::Zero(); // sum of cross products (Newell)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        middle += line[i] / static_cast<double>(line.size() - 1);
        normal += (line[i] - line.front()).cross(line[i + 1] - line.front());
    }
    normal.normalize();
    return std::all_of(line.begin(), line.end(),
                       [&](const Vec3& point) { return std::abs((point - middle).dot(normal)) <= flat * extent; });
}

} // namespace

double lengthOf(const Polyline& line)
{
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += (line[i + 1] - line[i]).norm();
    return length;
}

/// Runs against the direction of the triangles. As many open edges start at a vertex as end there, so every walk comes
/// back to its start.
std::vector<OpenLoop> openLoopsOf(const TriangleMesh& mesh)
{
    const HalfEdges halfEdges = findHalfEdges(mesh);
    std::vector<OpenLoop> loops;
    if (halfEdges.unpaired == 0)
        return loops;
    std::unordered_multimap<std::uint32_t, OpenEdge> openEdges;
    std::vector<std::uint32_t> starts;
    for (std::size_t h = 0; h < halfEdges.twin.size(); ++h) {
        const TriangleMesh::Triangle& t = mesh.triangles[h / 3];
        const bool isCollapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        if (halfEdges.twin[h] != HalfEdges::none || isCollapsed)
            continue;
        const std::uint32_t start = t[(h + 1) % 3];
        openEdges.insert({start, {t[h % 3], mesh.faceOfTriangle.empty() ? 0 : mesh.faceOfTriangle[h / 3]}});
        starts.push_back(start);
    }
    for (const std::uint32_t start : starts) {
        OpenLoop loop;
        for (auto edge = openEdges.find(start); edge != openEdges.end(); edge = openEdges.find(loop.vertices.back())) {
            loop.face = edge->second.face;
            loop.vertices.push_back(edge->second.end);
            openEdges.erase(edge);
            if (loop.vertices.back() == start)
                break;
        }
        if (!loop.vertices.empty())
            loops.push_back(std::move(loop));
    }
    return loops;
}

std::vector<std::vector<Vec3>> openBordersOf(const TriangleMesh& mesh)
{
    std::vector<Polyline> borders;
    for (const OpenLoop& loop : openLoopsOf(mesh)) {
        Polyline border;
        for (const std::uint32_t vertex : loop.vertices)
            border.push_back(mesh.vertices[vertex]);
        border.push_back(border.front());
        borders.push_back(std::move(border));
    }
    return borders;
}

std::vector<std::vector<Vec3>> chained(std::vector<std::vector<Vec3>> lines, double tolerance)
{
    if (lines.size() > mostLinesChained)
        return lines;
    std::vector<Polyline> chains;
    std::vector<char> isUsed(lines.size(), 0);
    for (std::size_t first = 0; first < lines.size(); ++first) {
        if (isUsed[first])
            continue;
        isUsed[first] = 1;
        Polyline chain = lines[first];
        const auto next = [&] {
            for (std::size_t i = 0; i < lines.size(); ++i)
                if (!isUsed[i] && (lines[i].front() - chain.back()).norm() <= tolerance)
                    return i;
            return lines.size();
        };
        while ((chain.front() - chain.back()).norm() > tolerance) {
            const std::size_t follower = next();
            if (follower == lines.size())
                break;
            isUsed[follower] = 1;
            chain.insert(chain.end(), lines[follower].begin() + 1, lines[follower].end());
        }
        chains.push_back(std::move(chain));
    }
    return chains;
}

Message describeBorders(std::size_t edges, const std::vector<std::vector<Vec3>>& borders)
{
    double length = 0;
    double largest = 0;
    bool isFlat = false;
    for (const Polyline& border : borders) {
        length += lengthOf(border);
        if (const double extent = extentOf(border); extent > largest) {
            largest = extent;
            isFlat = isFlatLoop(border);
        }
    }
    const Message openEdges =
        edges == 1 ? Message("Repair", "1 open edge") : Message("Repair", "%1 open edges").with(edges);
    const Message inBorders =
        borders.size() == 1 ? Message("Repair", "1 border") : Message("Repair", "%1 borders").with(borders.size());
    const Message all = isFlat
                            ? Message("Repair", "%1 in %2, %3 long in all; the largest opening is %4 across and flat")
                            : Message("Repair", "%1 in %2, %3 long in all; the largest opening is %4 across");
    return all.with(openEdges, inBorders, lengthWords(length), lengthWords(largest));
}

Message describeBorders(const std::vector<std::vector<Vec3>>& borders)
{
    std::size_t edges = 0;
    for (const Polyline& border : borders)
        edges += border.size() - 1;
    return describeBorders(edges, borders);
}

} // namespace knead
