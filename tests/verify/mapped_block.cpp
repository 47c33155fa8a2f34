#include "verify/mapped_block.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace knead::book {

namespace {

constexpr double pi = std::numbers::pi;

/// Six times the volume that a surface bounds; negative when it faces inwards [m^3].
double sixVolumes(const TriangleMesh& mesh)
{
    double sum = 0;
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
    return sum;
}

/// Where the ray at an angle leaves a square of half width 1 around the origin.
Eigen::Vector2d onSquare(double angle)
{
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    return ray / ray.cwiseAbs().maxCoeff();
}

} // namespace

TriangleMesh surfaceOf(const MappedBlock& block)
{
    TriangleMesh mesh;
    std::map<std::tuple<int, int, int>, std::uint32_t> numbers;
    const auto vertex = [&](std::array<int, 3> node) {
        if (block.closed)
            node[0] %= block.cells[0];
        const auto [entry, isNew] = numbers.try_emplace({node[0], node[1], node[2]}, mesh.vertices.size());
        if (isNew)
            mesh.vertices.push_back(block.at(node[0], node[1], node[2]));
        return entry->second;
    };
    for (std::size_t axis = block.closed ? 1 : 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (int i = 0; i < block.cells[(axis + 1) % 3]; ++i)
                for (int j = 0; j < block.cells[(axis + 2) % 3]; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> node{};
                        node[axis] = far ? block.cells[axis] : 0;
                        node[(axis + 1) % 3] = i + di;
                        node[(axis + 2) % 3] = j + dj;
                        return vertex(node);
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    if (far) {
                        mesh.triangles.push_back({a, b, c});
                        mesh.triangles.push_back({a, c, d});
                    } else {
                        mesh.triangles.push_back({a, c, b});
                        mesh.triangles.push_back({a, d, c});
                    }
                }
    if (sixVolumes(mesh) < 0)
        for (TriangleMesh::Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    return mesh;
}

MappedBlock bar(const Vec3& size, int across)
{
    const auto cells = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(across * length / size.z())));
    };
    return {.cells = {cells(size.x()), cells(size.y()), across}, .place = [size](double u, double v, double w) {
                return Vec3(size.cwiseProduct(Vec3(u - 0.5, v - 0.5, w - 0.5)));
            }};
}

MappedBlock roundBar(double radius, double length, int across)
{
    const int along = std::max(2, static_cast<int>(std::lround(across * length / (2 * radius))));
    return {.cells = {along, across, across}, .place = [=](double u, double v, double w) {
                // Squares around the middle become circles, more so the further out they are.
                const Eigen::Vector2d square(2 * v - 1, 2 * w - 1);
                const double out = square.cwiseAbs().maxCoeff();
                Eigen::Vector2d disc = square;
                if (out > 0) {
                    const Eigen::Vector2d circle = out * square.normalized();
                    disc = (1 - out) * 0.75 * square + (1 - 0.75 * (1 - out)) * circle;
                }
                return Vec3((u - 0.5) * length, radius * disc.x(), radius * disc.y());
            }};
}

MappedBlock pipe(double innerRadius, double outerRadius, double length, int thick)
{
    const double wall = outerRadius - innerRadius;
    const int around = std::max(24, static_cast<int>(std::lround(2 * pi * outerRadius / wall * thick / 2)));
    const int along = std::max(2, static_cast<int>(std::lround(length / wall * thick / 2)));
    return {.cells = {around, thick, along},
            .place =
                [=](double u, double v, double w) {
                    const double r = innerRadius + v * wall;
                    return Vec3((w - 0.5) * length, r * std::cos(2 * pi * u), r * std::sin(2 * pi * u));
                },
            .closed = true};
}

MappedBlock squarePipe(double width, double wall, double length, int thick)
{
    const int perSide = 4 * std::max(2, static_cast<int>(std::lround(width / wall / 4)));
    const int along = std::max(4, static_cast<int>(std::lround(length / wall / 2)));
    return {.cells = {4 * perSide, thick, along},
            .place =
                [=](double u, double v, double w) {
                    // Even steps along each side; corners at u = 1/8, 3/8 ...
                    const double turn = 4 * u;
                    const int side = static_cast<int>(std::floor(turn + 0.5)) % 4;
                    const double along1 = turn - std::floor(turn + 0.5); // -1/2 .. 1/2 along the side
                    const double half = width / 2 - (1 - v) * wall;
                    const Eigen::Vector2d onSide(half, 2 * along1 * half);
                    const Eigen::Vector2d place = Eigen::Rotation2Dd(side * pi / 2) * onSide;
                    return Vec3((w - 0.5) * length, place.x(), place.y());
                },
            .closed = true};
}

MappedBlock plateWithHole(double length, double width, double holeRadius, double thickness, int around)
{
    return {.cells = {around, around * 3 / 8, 1},
            .place =
                [=](double u, double v, double w) {
                    const double angle = 2 * pi * u;
                    const Eigen::Vector2d inner = holeRadius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
                    const double outward = std::pow(v, 1.6); // finer at the hole
                    const Eigen::Vector2d outer = onSquare(angle).cwiseProduct(Eigen::Vector2d(length, width)) / 2;
                    const Eigen::Vector2d p = (1 - outward) * inner + outward * outer;
                    return Vec3(p.x(), p.y(), (w - 0.5) * thickness);
                },
            .closed = true};
}

MappedBlock ringSector(double innerRadius, double outerRadius, double thickness, double from, double to, int through)
{
    const double wall = outerRadius - innerRadius;
    const auto cells = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / wall * through)));
    };
    return {.cells = {std::max(8, cells(0.5 * (innerRadius + outerRadius) * (to - from))), through, cells(thickness)},
            .place = [=](double u, double v, double w) {
                const double angle = from + u * (to - from);
                const double r = innerRadius + v * wall;
                return Vec3(r * std::cos(angle), r * std::sin(angle), (w - 0.5) * thickness);
            }};
}

} // namespace knead::book
