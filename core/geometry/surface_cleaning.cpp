#include "core/geometry/surface_cleaning.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;

/// The same corners in ascending order, and whether that runs the same way round.
struct Sorted {
    Triangle corners;
    bool sameWay;
};

Sorted sorted(Triangle t)
{
    bool sameWay = true;
    for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
        if (t[static_cast<std::size_t>(i)] > t[static_cast<std::size_t>(j)]) {
            std::swap(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]);
            sameWay = !sameWay;
        }
    return {t, sameWay};
}

TriangleMesh withoutDoubles(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<Sorted> keys;
    keys.reserve(order.size());
    for (const Triangle& triangle : mesh.triangles)
        keys.push_back(sorted(triangle));
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(keys[a].corners, a) < std::pair(keys[b].corners, b);
    });
    std::vector<std::uint8_t> isKept(order.size(), 0);
    for (std::size_t i = 0; i < order.size();) {
        std::size_t next = i;
        int balance = 0;
        for (; next < order.size() && keys[order[next]].corners == keys[order[i]].corners; ++next)
            balance += keys[order[next]].sameWay ? 1 : -1;
        for (std::size_t j = i; j < next; ++j)
            if (balance != 0 && keys[order[j]].sameWay == (balance > 0)) {
                isKept[order[j]] = 1;
                break;
            }
        i = next;
    }
    TriangleMesh result;
    result.vertices = mesh.vertices;
    for (std::size_t t = 0; t < isKept.size(); ++t) {
        if (isKept[t] == 0)
            continue;
        result.triangles.push_back(mesh.triangles[t]);
        if (!mesh.faceOfTriangle.empty())
            result.faceOfTriangle.push_back(mesh.faceOfTriangle[t]);
    }
    return result;
}

/// For each side of each triangle the side of the only other triangle there; none at holes and where more meet.
/// Side 3 t + i runs from corner i to corner i + 1 of triangle t.
std::vector<std::uint32_t> oppositeSides(const TriangleMesh& mesh, std::uint32_t none)
{
    struct Side {
        std::uint32_t low;
        std::uint32_t high;
        std::uint32_t side;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
            sides.push_back({low, high, 3 * t + i});
        }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return std::tuple(a.low, a.high, a.side) < std::tuple(b.low, b.high, b.side);
    });
    std::vector<std::uint32_t> opposite(sides.size(), none);
    const auto same = [&](std::size_t i, std::size_t j) {
        return j < sides.size() && sides[i].low == sides[j].low && sides[i].high == sides[j].high;
    };
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t next = i + 1;
        while (same(i, next))
            ++next;
        if (next - i == 2) {
            opposite[sides[i].side] = sides[i + 1].side;
            opposite[sides[i + 1].side] = sides[i].side;
        }
        i = next;
    }
    return opposite;
}

/// @returns how many were turned
std::size_t turnOneWay(TriangleMesh& mesh)
{
    constexpr std::uint32_t none = 0xffffffffU;
    enum class Way : std::uint8_t { unknown, same, turned };
    const std::vector<std::uint32_t> opposite = oppositeSides(mesh, none);
    std::vector<Way> ways(mesh.triangles.size(), Way::unknown);
    std::vector<std::uint32_t> stretch;
    std::size_t turned = 0;
    for (std::uint32_t start = 0; start < ways.size(); ++start) {
        if (ways[start] != Way::unknown)
            continue;
        stretch.assign(1, start);
        ways[start] = Way::same;
        double balance = 0; // area that stays by area that is to be turned
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const std::uint32_t t = stretch[i];
            balance += (ways[t] == Way::same ? 1 : -1) * 0.5 * crossOf(mesh.vertices, mesh.triangles[t]).norm();
            for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
                const std::uint32_t other = opposite[side];
                if (other == none || ways[other / 3] != Way::unknown)
                    continue;
                const bool agrees = mesh.triangles[t][side % 3] != mesh.triangles[other / 3][other % 3];
                ways[other / 3] = agrees == (ways[t] == Way::same) ? Way::same : Way::turned;
                stretch.push_back(other / 3);
            }
        }
        const Way wrong = balance < 0 ? Way::same : Way::turned;
        for (const std::uint32_t t : stretch)
            if (ways[t] == wrong) {
                std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
                ++turned;
            }
    }
    return turned;
}

} // namespace

CleanSurface cleanSurface(const TriangleMesh& mesh)
{
    CleanSurface result;
    result.mesh = withoutDoubles(mesh);
    result.removed = mesh.triangles.size() - result.mesh.triangles.size();
    result.flipped = turnOneWay(result.mesh);
    return result;
}

} // namespace knead
