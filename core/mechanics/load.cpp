#include "core/mechanics/load.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace knead {

namespace {

constexpr double largestAmount = 1e12;
constexpr double longestRamp = 3600; // [s]

// Triangles are cut until their sides are no longer than this [a]: the functions of a cell are products, which one point in the
// middle of a piece integrates to 1 % then. Sums and first moments are exact for any size.
constexpr double pieceSize = 0.5;
constexpr int mostCuts = 24;

// Of what the functions of a cell are on the objects that exist; below, the nearest object carries the piece.
constexpr double leastCover = 0.05;

// Directions in which a patch extends less than this share of its size count as flat.
constexpr double flatShare = 1e-6;

/// What an object carries while pieces of the surface are added up.
struct Carried {
    double share = 0;
    Vec3 area = Vec3::Zero();
};

/// A piece of the surface, small against a cell.
struct Piece {
    Vec3 center;
    Vec3 area; ///< outward [m^2]
};

/// Adds up the surface piece by piece, and its own integrals to compare with.
class PatchMaker {
public:
    explicit PatchMaker(const Aggregate& aggregate)
        : m_lattice(aggregate.lattice)
    {
    }

    void add(const Piece& piece)
    {
        const double size = piece.area.norm();
        m_total += size;
        m_moment += size * piece.center;
        m_turn += piece.center.cross(piece.area);
        const Vec3 place = m_lattice.coordinates(piece.center);
        const Vec3 low = place.array().floor();
        std::array<std::pair<ObjectIndex, double>, 8> corners;
        std::size_t count = 0;
        double cover = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            Lattice::Node node{};
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const int up = corner >> axis & 1;
                const double within = place[axis] - low[axis];
                weight *= up == 1 ? within : 1 - within;
                node[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(low[axis]) + up;
            }
            const ObjectIndex object = weight > 0 ? m_lattice.find(node) : static_cast<ObjectIndex>(m_lattice.size());
            if (object >= m_lattice.size())
                continue;
            corners[count++] = {object, weight};
            cover += weight;
        }
        if (cover < leastCover) {
            corners[0] = {nearest(piece.center), 1};
            count = 1;
            cover = 1;
        }
        for (std::size_t i = 0; i < count; ++i) {
            Carried& carried = m_carried[corners[i].first];
            carried.share += corners[i].second / cover * size;
            carried.area += corners[i].second / cover * piece.area;
        }
    }

    LoadPatch take()
    {
        LoadPatch patch;
        for (const auto& [object, carried] : m_carried) {
            patch.objects.push_back(object);
            patch.share.push_back(carried.share);
            patch.area.push_back(carried.area);
        }
        if (m_total > 0)
            keepMoments(patch);
        return patch;
    }

private:
    ObjectIndex nearest(const Vec3& place) const
    {
        ObjectIndex best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (ObjectIndex object = 0; object < m_lattice.size(); ++object)
            if (const double distance = (m_lattice.position(object) - place).squaredNorm(); distance < least) {
                least = distance;
                best = object;
            }
        return best;
    }

    /// Where corners of cells are missing, first moments are put right by what is linear in place.
    void keepMoments(LoadPatch& patch) const
    {
        Vec3 center = Vec3::Zero();
        Vec3 lacking = m_moment;
        Vec3 turn = m_turn;
        for (std::size_t i = 0; i < patch.objects.size(); ++i) {
            const Vec3 place = m_lattice.position(patch.objects[i]);
            center += patch.share[i] * place / m_total;
            lacking -= patch.share[i] * place;
            turn -= place.cross(patch.area[i]);
        }
        Mat3 spread = Mat3::Zero();
        for (std::size_t i = 0; i < patch.objects.size(); ++i) {
            const Vec3 arm = m_lattice.position(patch.objects[i]) - center;
            spread += patch.share[i] * arm * arm.transpose();
        }
        const Mat3 inertia = spread.trace() * Mat3::Identity() - spread;
        const Vec3 slope = solved(spread, lacking);
        const Vec3 spin = solved(inertia, turn);
        const std::vector<double> share = patch.share;
        for (std::size_t i = 0; i < patch.objects.size(); ++i) {
            const Vec3 arm = m_lattice.position(patch.objects[i]) - center;
            patch.share[i] += share[i] * slope.dot(arm);
            patch.area[i] += share[i] * spin.cross(arm);
        }
    }

    /// Least x of A x = b; nothing along directions in which A is zero.
    static Vec3 solved(const Mat3& matrix, const Vec3& right)
    {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(matrix);
        Vec3 solution = Vec3::Zero();
        for (Eigen::Index k = 0; k < 3; ++k)
            if (solver.eigenvalues()[k] > flatShare * solver.eigenvalues()[2])
                solution +=
                    solver.eigenvectors().col(k) * solver.eigenvectors().col(k).dot(right) / solver.eigenvalues()[k];
        return solution;
    }

    const Lattice& m_lattice;
    std::map<ObjectIndex, Carried> m_carried;
    double m_total = 0;           ///< [m^2]
    Vec3 m_moment = Vec3::Zero(); ///< integral of X dA
    Vec3 m_turn = Vec3::Zero();   ///< integral of X x n dA
};

/// Calls visit(piece) for small pieces of a triangle: its longest side is halved until it is short.
template <typename Visit>
void cut(const std::array<Vec3, 3>& corners, double longest, int cuts, Visit&& visit)
{
    std::size_t side = 0;
    std::array<double, 3> length{};
    for (std::size_t i = 0; i < 3; ++i)
        length[i] = (corners[(i + 1) % 3] - corners[i]).norm();
    side = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
    if (length[side] <= longest || cuts == mostCuts) {
        const Vec3 area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        visit(Piece{(corners[0] + corners[1] + corners[2]) / 3, area});
        return;
    }
    const std::size_t next = (side + 1) % 3;
    const std::size_t last = (side + 2) % 3;
    const Vec3 middle = 0.5 * (corners[side] + corners[next]);
    cut({corners[side], middle, corners[last]}, longest, cuts + 1, visit);
    cut({middle, corners[next], corners[last]}, longest, cuts + 1, visit);
}

} // namespace

LoadAmount between(const LoadAmount& from, const LoadAmount& to, double share)
{
    return {.force = from.force + share * (to.force - from.force),
            .moment = from.moment + share * (to.moment - from.moment),
            .pressure = from.pressure + share * (to.pressure - from.pressure)};
}

LoadPatch loadPatch(const Aggregate& aggregate, const TriangleMesh& mesh, const std::vector<std::uint32_t>& faces,
                    const std::optional<Box>& box)
{
    PatchMaker maker(aggregate);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool isOfFaces = !faces.empty() && t < mesh.faceOfTriangle.size() &&
                               std::find(faces.begin(), faces.end(), mesh.faceOfTriangle[t]) != faces.end();
        if (!faces.empty() && !isOfFaces)
            continue;
        std::array<Vec3, 3> corners;
        Box around;
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = mesh.vertices[mesh.triangles[t][c]];
            around.extend(corners[c]);
        }
        if (box && !box->intersects(around))
            continue;
        cut(corners, pieceSize * aggregate.lattice.spacing, 0, [&](const Piece& piece) {
            if (!box || box->contains(piece.center))
                maker.add(piece);
        });
    }
    return maker.take();
}

Message amountProblem(const LoadAmount& amount, double ramp)
{
    if (!(amount.force.norm() <= largestAmount) || !(amount.moment.norm() <= largestAmount) ||
        !(std::abs(amount.pressure) <= largestAmount))
        return Message("Load", "A load must not be larger than 1e12 N, N m or Pa.");
    if (!(ramp >= 0 && ramp <= longestRamp))
        return Message("Load", "A load must rise within 0 to 3600 s.");
    return {};
}

Message loadProblem(const Load& load, std::size_t objects)
{
    const LoadPatch& patch = load.patch;
    if (patch.empty() || patch.share.size() != patch.objects.size() || patch.area.size() != patch.objects.size())
        return Message("Load", "Load \"%1\" acts on nothing.").with(load.name);
    double total = 0;
    for (std::size_t i = 0; i < patch.objects.size(); ++i) {
        if (patch.objects[i] >= objects || (i > 0 && patch.objects[i] <= patch.objects[i - 1]))
            return Message("Load", "Load \"%1\" names an object that does not exist.").with(load.name);
        if (!std::isfinite(patch.share[i]) || !patch.area[i].allFinite())
            return Message("Load", "Load \"%1\" has an area that is no number.").with(load.name);
        total += patch.share[i];
    }
    if (!(total > 0))
        return Message("Load", "Load \"%1\" acts on nothing.").with(load.name);
    return amountProblem(load.amount, load.ramp);
}

LoadForces::LoadForces(const LoadPatch& patch, const Aggregate& aggregate)
    : m_objects(patch.objects)
    , m_share(patch.share)
    , m_area(patch.area)
    , m_neighbors(patch.objects.size())
    , m_forces(patch.objects.size(), Vec3::Zero())
{
    double total = 0;
    for (const double share : m_share)
        total += share;
    const Lattice& lattice = aggregate.lattice;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        m_share[i] /= total;
        const Vec3 place = lattice.position(m_objects[i]);
        m_center += m_share[i] * place;
        Mat3 shape = Mat3::Zero();
        for (int code = 0; code < 27; ++code) {
            Lattice::Node node = lattice.nodes[m_objects[i]];
            const std::array<int, 3> step{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
            for (std::size_t axis = 0; axis < 3; ++axis)
                node[axis] += step[axis];
            const ObjectIndex other = lattice.find(node);
            if (other >= lattice.size() || other == m_objects[i])
                continue;
            const Vec3 offset = lattice.position(other) - place;
            shape += offset * offset.transpose();
            m_neighbors[i].push_back({other, offset});
        }
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(shape);
        if (!(solver.eigenvalues()[0] > flatShare * solver.eigenvalues()[2])) {
            m_neighbors[i].clear(); // flat: its area does not follow
            continue;
        }
        const Mat3 inverse = shape.inverse();
        for (Neighbor& neighbor : m_neighbors[i])
            neighbor.reference = inverse * neighbor.reference;
    }
}

const std::vector<Vec3>& LoadForces::at(const VectorArray& position, const LoadAmount& amount)
{
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_forces[i] = m_share[i] * amount.force;
    if (!amount.moment.isZero(0))
        addMoment(position, amount.moment);
    if (amount.pressure != 0)
        addPressure(position, amount.pressure);
    return m_forces;
}

void LoadForces::addMoment(const VectorArray& position, const Vec3& moment)
{
    double mass = 0;
    Vec3 center = Vec3::Zero();
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        mass += std::abs(m_share[i]);
        center += std::abs(m_share[i]) * position.at(m_objects[i]);
    }
    center /= mass;
    Mat3 inertia = Mat3::Zero();
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const Vec3 arm = position.at(m_objects[i]) - center;
        inertia += std::abs(m_share[i]) * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    const Vec3 spin = inertia.ldlt().solve(moment);
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_forces[i] += std::abs(m_share[i]) * spin.cross(position.at(m_objects[i]) - center);
}

/// cof(G) has the columns g2 x g3, g3 x g1, g1 x g2; an area A at rest is cof(G) A now.
void LoadForces::addPressure(const VectorArray& position, double pressure)
{
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        Mat3 gradient = m_neighbors[i].empty() ? Mat3(Mat3::Identity()) : Mat3(Mat3::Zero());
        const Vec3 place = position.at(m_objects[i]);
        for (const Neighbor& neighbor : m_neighbors[i])
            gradient += (position.at(neighbor.object) - place) * neighbor.reference.transpose();
        const Vec3 x = gradient.col(0);
        const Vec3 y = gradient.col(1);
        const Vec3 z = gradient.col(2);
        const Vec3& area = m_area[i];
        m_forces[i] -= pressure * (area.x() * y.cross(z) + area.y() * z.cross(x) + area.z() * x.cross(y));
    }
}

} // namespace knead
