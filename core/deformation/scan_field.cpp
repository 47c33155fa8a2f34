#include "core/deformation/scan_field.h"

#include "core/deformation/field_fit_words.h"
#include "core/deformation/scan_placement.h"
#include "core/geometry/area_samples.h"
#include "core/geometry/point_tree.h"
#include "core/geometry/surface_ray.h"
#include "core/message/number_text.h"
#include "core/task/parallel_progress.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace knead {

namespace {

constexpr double leastOverlap = 0.5;      // of the scan: with less on the part, it is of something else
constexpr double leastKept = 0.3;         // of the points of the part that must find the scan
constexpr double leastLookCosine = 0.5;   // between the normals of the part and of the scan: else it is another wall
constexpr double backShare = 0.5;         // of the way to the scan, by which the way back may end elsewhere, and
constexpr double backSpacings = 2;        // of the points, more
constexpr std::size_t scanNeighbors = 12; // that say whether a point is an outlier, and smooth
constexpr double outlierSpreads = 6;      // median deviations from the median of its neighbors
constexpr double leastSpread = 1e-4;      // of the part's size: less is told by no scan
constexpr double smoothingWeight = 0.5;   // weight of the neighbors' mean against a point's own look
constexpr std::size_t lookRounds = 12;
constexpr double settled =
    1e-4; // of the part's size: when no point moves farther in a round, the next would say the same

/// A point of the part, and how it moved.
struct ScanLook {
    AreaSamples::Sample sample;
    Vec3 moved = Vec3::Zero(); ///< as far as it is known [m]
    double along = 0;          ///< how far along its normal it moved, as the scan has it [m]
    double distance = 0;       ///< of the scan from where it was [m]
    bool counts = false;
};

TriangleMesh placed(TriangleMesh mesh, const Pose& pose)
{
    for (Vec3& vertex : mesh.vertices)
        vertex = pose.toWorld(vertex);
    return mesh;
}

/// The surfaces that are compared.
struct ScanAndPart {
    ScanAndPart(const TriangleMesh& scan_, const TriangleMesh& part, double mostAlong_, double spacing_)
        : scan(scan_)
        , toScan(scan)
        , alongScan{SurfaceRay(scan, 1), SurfaceRay(scan, -1)}
        , alongPart{SurfaceRay(part, 1), SurfaceRay(part, -1)}
        , mostAlong(mostAlong_)
        , spacing(spacing_)
        , slack(0.01 * spacing_)
    {
    }

    const TriangleMesh& scan;
    SurfaceDistance toScan;
    std::array<SurfaceRay, 2> alongScan; ///< outward and inward
    std::array<SurfaceRay, 2> alongPart;
    double mostAlong; ///< [m]
    double spacing;   ///< of the points [m]
    double slack;     ///< rounding [m]
};

/// How far along a normal a line through a place meets a surface that looks the same way, next to the place [m].
/// @param slack by which the place may lie off the surface that it is on [m]
std::optional<double> meets(const std::array<SurfaceRay, 2>& surface, const Vec3& place, const Vec3& normal,
                            double slack)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::optional<double> along;
    for (const double side : {1.0, -1.0}) {
        const auto exit = surface[side > 0 ? 0 : 1].firstExit(place - side * slack * normal, side * normal, none);
        if (exit && exit->cosine >= leastLookCosine && (!along || std::abs(exit->distance - slack) < std::abs(*along)))
            along = side * (exit->distance - slack);
    }
    return along;
}

/// Where the normal of a point, from where it moved, meets the scan, and from there back to the part.
void look(ScanLook& point, const ScanAndPart& both)
{
    const Vec3& normal = point.sample.normal;
    const Vec3 start = point.sample.place + point.moved;
    point.distance = both.toScan.nearest(point.sample.place).distance;
    point.counts = false;
    const std::optional<double> along = meets(both.alongScan, start, normal, both.slack);
    if (!along)
        return;
    const Vec3 there = start + *along * normal;
    const Vec3 other =
        crossOf(both.scan.vertices, both.scan.triangles[both.toScan.nearest(there).triangle]).stableNormalized();
    const std::optional<double> back = meets(both.alongPart, there - point.moved, other, both.slack);
    if (!back)
        return;
    const double off = (there - point.moved + *back * other - point.sample.place).norm();
    point.along = *along + normal.dot(point.moved);
    point.counts =
        std::abs(point.along) <= both.mostAlong && off <= backShare * std::abs(*along) + backSpacings * both.spacing;
}

double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

using Neighbors = std::vector<std::vector<PointTree::Found>>;

Neighbors neighborsOf(const std::vector<ScanLook>& looks)
{
    std::vector<Vec3> places;
    for (const ScanLook& one : looks)
        places.push_back(one.sample.place);
    const PointTree tree(places);
    Neighbors neighbors(places.size());
    forEachBlock(places.size(), 128, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            neighbors[i] = tree.nearest(places[i], scanNeighbors);
    });
    return neighbors;
}

/// Points that say otherwise than those beside them on the same side.
void dropOddOnes(std::vector<ScanLook>& looks, const Neighbors& neighbors, double size)
{
    constexpr double sameSide = 0.7; // cosine between normals
    constexpr std::size_t fewToTell = 4;
    std::vector<char> odd(looks.size());
    for (std::size_t i = 0; i < looks.size(); ++i) {
        std::vector<double> values;
        for (const PointTree::Found& neighbor : neighbors[i]) {
            const ScanLook& other = looks[neighbor.point];
            if (other.counts && other.sample.normal.dot(looks[i].sample.normal) > sameSide)
                values.push_back(other.along);
        }
        if (values.size() < fewToTell)
            continue;
        const double middle = medianOf(values);
        for (double& value : values)
            value = std::abs(value - middle);
        odd[i] = std::abs(looks[i].along - middle) > outlierSpreads * std::max(medianOf(values), leastSpread * size);
    }
    for (std::size_t i = 0; i < looks.size(); ++i)
        looks[i].counts = looks[i].counts && odd[i] == 0;
}

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// smoothingWeight / 2 mean |u_i - u_j|^2 over neighbors, summed over all, and (n u)^2 of those that count, as a quadratic form.
SparseRows formOf(const std::vector<ScanLook>& looks, const Neighbors& neighbors)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        const Vec3& normal = looks[i].sample.normal;
        for (int a = 0; looks[i].counts && a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                entries.emplace_back(row + a, row + b, normal[a] * normal[b]);
        const double weight = smoothingWeight / 2 / static_cast<double>(neighbors[i].size());
        for (const PointTree::Found& neighbor : neighbors[i]) {
            const auto column = static_cast<Eigen::Index>(3 * neighbor.point);
            for (int a = 0; a < 3 && column != row; ++a) {
                entries.emplace_back(row + a, row + a, weight);
                entries.emplace_back(column + a, column + a, weight);
                entries.emplace_back(row + a, column + a, -weight);
                entries.emplace_back(column + a, row + a, -weight);
            }
        }
    }
    const auto size = static_cast<Eigen::Index>(3 * looks.size());
    SparseRows form(size, size);
    form.setFromTriplets(entries.begin(), entries.end());
    return form;
}

/// Motions u in space from what normals n tell of them: sum (n u - along)^2 over points that count, and the differences between
/// neighbors are least together (Dirichlet energy), by conjugate gradients. Points that do not count go with those around them.
/// @return how far a point moved on at most [m]
double smooth(std::vector<ScanLook>& looks, const Neighbors& neighbors)
{
    constexpr double tolerance = 1e-5;
    constexpr int mostRounds = 1000;
    const SparseRows form = formOf(looks, neighbors);
    Eigen::VectorXd told = Eigen::VectorXd::Zero(form.rows());
    Eigen::VectorXd moved(form.rows());
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        moved.segment<3>(row) = looks[i].moved;
        if (looks[i].counts)
            told.segment<3>(row) = looks[i].along * looks[i].sample.normal;
    }
    Eigen::ConjugateGradient<SparseRows, Eigen::Lower | Eigen::Upper> solver(form);
    solver.setTolerance(tolerance);
    solver.setMaxIterations(mostRounds);
    moved = solver.solveWithGuess(told, moved).eval();
    double farthest = 0;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Vec3 next = moved.segment<3>(static_cast<Eigen::Index>(3 * i));
        farthest = std::max(farthest, (next - looks[i].moved).norm());
        looks[i].moved = next;
    }
    return farthest;
}

/// Looks, smooths, and looks again from where points have come to: near edges only that meets the face that is meant.
std::vector<ScanLook> compared(const TriangleMesh& part, const ScanAndPart& both, const ScanOptions& options,
                               TaskControl& control)
{
    const AreaSamples samples(part, options.samples);
    const double size = boxOfPlaces(part.vertices).diagonal().norm();
    std::vector<ScanLook> looks(samples.size());
    for (std::size_t i = 0; i < looks.size(); ++i)
        looks[i].sample = samples[i];
    const Neighbors neighbors = neighborsOf(looks);
    for (std::size_t round = 0; round < lookRounds; ++round) {
        TaskPortion looking = TaskPortion::ofItem(control, round, lookRounds);
        forEachBlock(looks.size(), 64, looking, "comparing the scan with the part",
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i)
                             look(looks[i], both);
                     });
        dropOddOnes(looks, neighbors, size);
        if (smooth(looks, neighbors) < settled * size)
            break;
    }
    return looks;
}

void sayWhatWasFound(ScanField& result, double size)
{
    const double moved = (result.toPart.toWorld(Vec3::Zero())).norm();
    const double turned = 2 * std::acos(std::min(1.0, std::abs(result.toPart.rotation.w()))) * 180 / std::numbers::pi;
    if (moved > 1e-3 * size || turned > 0.1)
        result.remarks.push_back(
            Message("Field",
                    "The scan was moved by (%1, %2, %3) mm and turned by %4 degrees, so that it lies on the part.")
                .with(inDigits(1e3 * result.toPart.position.x(), 4), inDigits(1e3 * result.toPart.position.y(), 4),
                      inDigits(1e3 * result.toPart.position.z(), 4), inDigits(turned, 4)));
    if (result.outliers > 0)
        result.remarks.push_back(
            Message("Field",
                    "At %1 of %2 points of the part the scan says nothing to go by, as where it has a hole; the "
                    "field is continued there. The farthest lies %3 mm from the scan, at %4.")
                .with(result.outliers, result.samples, inDigits(1e3 * result.farthest, 4),
                      placeInMillimetres(result.farthestPlace)));
}

void checkScan(const TriangleMesh& scan, const TriangleMesh& part)
{
    if (scan.empty() || part.empty())
        throw Problem(Message("Field", "The scan or the part has no triangles."));
    if (!std::all_of(scan.vertices.begin(), scan.vertices.end(), [](const Vec3& v) { return v.allFinite(); }))
        throw Problem(Message("Field", "The scan has a corner that is no place."));
    if (!(AreaSamples(scan, 1).area() > 0))
        throw Problem(Message("Field", "The triangles of the scan have no area."));
}

[[noreturn]] void refuseScan(double share)
{
    throw Problem(Message("Field",
                          "The scan does not lie on the part: only %1 % of it does, however it is turned. Look at its "
                          "unit, or lay it on the part and say that it stays in place.")
                      .with(inDigits(100 * share, 3)));
}

} // namespace

ScanField scanField(const TriangleMesh& scan, const TriangleMesh& part, const ScanOptions& options,
                    TaskControl& control)
{
    checkScan(scan, part);
    const double size = boxOfPlaces(part.vertices).diagonal().norm();
    const SurfaceDistance toPart(part);
    ScanField result;
    TaskPortion placing(control, 0, 0.5);
    if (!options.staysInPlace) {
        const ScanPlacement placement = placeScan(scan, part, toPart, placing);
        if (placement.overlap < leastOverlap)
            refuseScan(placement.overlap);
        result.toPart = placement.toPart;
    }
    const TriangleMesh there = placed(scan, result.toPart);
    const double spacing = std::sqrt(AreaSamples(part, 1).area() / static_cast<double>(options.samples));
    TaskPortion comparing(control, 0.5, 1);
    const std::vector<ScanLook> looks =
        compared(part, ScanAndPart(there, part, options.mostDistance * size, spacing), options, comparing);
    result.samples = looks.size();
    for (const ScanLook& one : looks) {
        if (one.counts) {
            result.field.nodes.push_back(one.sample.place);
            result.field.displacements.push_back(one.moved);
            continue;
        }
        ++result.outliers;
        if (one.distance >= result.farthest) {
            result.farthest = one.distance;
            result.farthestPlace = one.sample.place;
        }
    }
    const double kept = static_cast<double>(result.field.nodes.size()) / static_cast<double>(result.samples);
    if (kept < leastKept)
        refuseScan(kept);
    sayWhatWasFound(result, size);
    return result;
}

} // namespace knead
