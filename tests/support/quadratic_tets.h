#pragma once

#include "core/geometry/vec3.h"

#include <QDir>
#include <QFile>
#include <QProcess>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// Meshes of tetrahedra with nodes in the middle of their edges, as people make them for CalculiX, and what that finds on them. All
/// in mm, N and MPa.
namespace knead::quadratic_tets {

struct Mesh {
    std::vector<Vec3> nodes;                             ///< [mm]
    std::vector<std::array<std::uint32_t, 10>> elements; ///< four corners, then middles of edges in CalculiX's order
};

/// Corners of the edges that nodes 4 .. 9 are the middles of.
inline constexpr std::array<std::array<std::size_t, 2>, 6> edgesOfTet{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// A place for three coordinates of a lattice.
using PlaceOf = std::function<Vec3(double, double, double)>;

/// Glues blocks: nodes in one place are one. Every cell of a lattice is six tetrahedra along its diagonal, so that blocks fit where
/// their lattices do.
class Blocks {
public:
    void add(const std::array<int, 3>& cells, const PlaceOf& placeOf)
    {
        constexpr std::array<std::array<std::size_t, 3>, 6> ways{
            {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
        for (int i = 0; i < cells[0]; ++i)
            for (int j = 0; j < cells[1]; ++j)
                for (int k = 0; k < cells[2]; ++k)
                    for (const auto& way : ways) {
                        std::array<Vec3, 4> corners{Vec3(i, j, k), {}, {}, {}};
                        for (std::size_t step = 0; step < 3; ++step)
                            corners.at(step + 1) =
                                corners.at(step) + Vec3::Unit(static_cast<Eigen::Index>(way.at(step)));
                        addTet(corners, placeOf);
                    }
    }

    /// A box between two corners [mm].
    void addBox(const Vec3& low, const Vec3& high, const std::array<int, 3>& cells)
    {
        const Vec3 step = (high - low).cwiseQuotient(Vec3(cells[0], cells[1], cells[2]));
        add(cells, [=](double u, double v, double w) -> Vec3 { return low + step.cwiseProduct(Vec3(u, v, w)); });
    }

    Mesh mesh;

private:
    void addTet(std::array<Vec3, 4> corners, const PlaceOf& placeOf)
    {
        const auto at = [&](const Vec3& lattice) { return placeOf(lattice.x(), lattice.y(), lattice.z()); };
        const Vec3 first = at(corners[0]);
        if ((at(corners[1]) - first).cross(at(corners[2]) - first).dot(at(corners[3]) - first) < 0)
            std::swap(corners[1], corners[2]);
        std::array<std::uint32_t, 10> element{};
        for (std::size_t c = 0; c < 4; ++c)
            element.at(c) = node(at(corners.at(c)));
        for (std::size_t e = 0; e < 6; ++e)
            element.at(4 + e) = node(at(0.5 * (corners.at(edgesOfTet[e][0]) + corners.at(edgesOfTet[e][1]))));
        mesh.elements.push_back(element);
    }

    std::uint32_t node(const Vec3& place)
    {
        std::array<long long, 3> key{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            key.at(axis) = std::llround(1e5 * place[static_cast<Eigen::Index>(axis)]);
        const auto [entry, isNew] = m_numbers.try_emplace(key, static_cast<std::uint32_t>(mesh.nodes.size()));
        if (isNew)
            mesh.nodes.push_back(place);
        return entry->second;
    }

    std::map<std::array<long long, 3>, std::uint32_t> m_numbers;
};

/// A square plate around a round hole through its middle, the origin, along z.
inline Mesh plateWithHole(double side, double radius, double thickness, const std::array<int, 3>& cells)
{
    Blocks blocks;
    const double quarter = cells[0] / 4.0;
    blocks.add(cells, [=](double u, double v, double w) -> Vec3 {
        // Around the square from the middle of its right side: a quarter of the way is a corner, a side, a corner.
        const double turns = std::floor(u / quarter + 0.5);
        const double along = 2 * (u / quarter - turns); // -1 .. 1
        const Eigen::AngleAxisd turn(turns * 1.5707963267948966, Vec3::UnitZ());
        const Vec3 outside = turn * Vec3(side / 2, along * side / 2, 0);
        const double angle = u / quarter * 1.5707963267948966;
        const Vec3 inside(radius * std::cos(angle), radius * std::sin(angle), 0);
        const double share = v / cells[1];
        return (1 - share) * inside + share * outside + Vec3(0, 0, thickness * (w / cells[2] - 0.5));
    });
    return std::move(blocks.mesh);
}

/// A face of the skin: three corners, then the middles of the edges 01, 12, 20.
using SkinFace = std::array<std::uint32_t, 6>;

/// The faces that only one element has.
inline std::vector<SkinFace> skinOf(const Mesh& mesh)
{
    constexpr std::array<std::array<std::size_t, 6>, 4> faces{
        {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};
    std::map<std::array<std::uint32_t, 3>, std::vector<SkinFace>> all;
    for (const auto& element : mesh.elements)
        for (const auto& local : faces) {
            SkinFace face{};
            for (std::size_t n = 0; n < 6; ++n)
                face.at(n) = element.at(local.at(n));
            std::array<std::uint32_t, 3> key{face[0], face[1], face[2]};
            std::sort(key.begin(), key.end());
            all[key].push_back(face);
        }
    std::vector<SkinFace> skin;
    for (const auto& [key, found] : all)
        if (found.size() == 1)
            skin.push_back(found.front());
    return skin;
}

/// What values at the nodes are within a face, by its own quadratic functions.
/// @param a, b shares of the first two corners
inline Vec3 within(const SkinFace& face, const std::vector<Vec3>& values, double a, double b)
{
    const double c = 1 - a - b;
    const std::array<double, 6> shape{a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1),
                                      4 * a * b,       4 * b * c,       4 * c * a};
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < 6; ++n)
        sum += shape.at(n) * values[face.at(n)];
    return sum;
}

/// How a mesh is held and pushed.
struct Loading {
    std::function<bool(const Vec3&)> held;   ///< nodes that stay where they are
    std::function<bool(const Vec3&)> pushed; ///< nodes that share the force
    Vec3 force = Vec3::Zero();               ///< [N]
    double modulus = 1000;                   ///< [MPa]
    bool isNonlinear = false;
};

/// The input for CalculiX.
inline std::string inputOf(const Mesh& mesh, const Loading& loading)
{
    std::string text = "*NODE, NSET=NALL\n";
    std::array<char, 160> line{};
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vec3& place = mesh.nodes[n];
        std::snprintf(line.data(), line.size(), "%zu,%.8g,%.8g,%.8g\n", n + 1, place.x(), place.y(), place.z());
        text += line.data();
    }
    text += "*ELEMENT, TYPE=C3D10, ELSET=EALL\n";
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        text += std::to_string(e + 1);
        for (const std::uint32_t node : mesh.elements[e])
            text += "," + std::to_string(node + 1);
        text += '\n';
    }
    text += "*MATERIAL, NAME=M\n*ELASTIC\n" + std::to_string(loading.modulus) +
            ",0.3\n*SOLID SECTION, ELSET=EALL, MATERIAL=M\n*STEP" + (loading.isNonlinear ? ", NLGEOM" : "") +
            "\n*STATIC\n*BOUNDARY\n";
    const auto count = static_cast<double>(std::ranges::count_if(mesh.nodes, loading.pushed));
    std::string forces = "*CLOAD\n";
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (loading.held(mesh.nodes[n]))
            text += std::to_string(n + 1) + ",1,3\n";
        if (loading.pushed(mesh.nodes[n]))
            for (int axis = 0; axis < 3; ++axis)
                if (loading.force[axis] != 0) {
                    std::snprintf(line.data(), line.size(), "%zu,%d,%.8g\n", n + 1, axis + 1,
                                  loading.force[axis] / count);
                    forces += line.data();
                }
    }
    return text + forces + "*NODE FILE, FREQUENCY=1000\nU\n*END STEP\n";
}

/// Writes text into a file.
inline void write(const QString& path, const std::string& text)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0)
        throw std::runtime_error("cannot write " + path.toStdString());
}

/// Runs CalculiX in a folder. @return the path of its results @throws std::runtime_error
inline std::string solve(const QString& folder, const QString& name, const std::string& input)
{
    write(QDir(folder).filePath(name + ".inp"), input);
    QProcess process;
    process.setWorkingDirectory(folder);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start("ccx", {"-i", name});
    if (!process.waitForFinished(600'000) || process.exitCode() != 0)
        throw std::runtime_error("CalculiX (the package calculix-ccx) does not run: " +
                                 process.readAll().right(500).toStdString());
    return QDir(folder).filePath(name + ".frd").toStdString();
}

/// Displacements of the last step of a file of results, as its columns say [mm].
inline std::vector<Vec3> displacementsIn(const std::string& path, std::size_t nodes)
{
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("cannot read " + path);
    std::vector<Vec3> values(nodes, Vec3::Zero());
    bool isWanted = false;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine();
        if (line.startsWith(" -4"))
            isWanted = line.contains("DISP");
        if (isWanted && line.startsWith(" -1"))
            for (int axis = 0; axis < 3; ++axis)
                values.at(line.mid(3, 10).trimmed().toUInt() - 1)[axis] =
                    line.mid(13 + 12 * axis, 12).trimmed().toDouble();
    }
    return values;
}

} // namespace knead::quadratic_tets
