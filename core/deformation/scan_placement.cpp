#include "core/deformation/scan_placement.h"

#include "core/geometry/area_samples.h"
#include "core/task/parallel.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t fewScanSamples = 500;
constexpr std::size_t manyScanSamples = 4000;
constexpr int fewRounds = 15; // to tell which axes are right
constexpr int manyRounds = 60;
constexpr double scanTrim = 0.9;        // of the samples, the nearest ones
constexpr double onPart = 0.02;         // of the part's size
constexpr double liesThere = 0.67;      // of the scan: more, and it is registered from where it is
constexpr double leastScanCosine = 0.5; // between normals of the scan and of what is nearest: else it is another wall
constexpr double standsStill = 1e-9;    // of the size, or an angle

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

std::vector<AreaSamples::Sample> samplesOf(const TriangleMesh& mesh, std::size_t count)
{
    const AreaSamples samples(mesh, count);
    std::vector<AreaSamples::Sample> all(count);
    for (std::size_t i = 0; i < count; ++i)
        all[i] = samples[i];
    return all;
}

/// The middle of a surface and its principal axes, as columns of a rotation.
Pose axesOf(const std::vector<AreaSamples::Sample>& samples)
{
    Vec3 middle = Vec3::Zero();
    for (const AreaSamples::Sample& sample : samples)
        middle += sample.place / static_cast<double>(samples.size());
    Mat3 spread = Mat3::Zero();
    for (const AreaSamples::Sample& sample : samples)
        spread += (sample.place - middle) * (sample.place - middle).transpose();
    Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();
    if (axes.determinant() < 0)
        axes.col(0) = -axes.col(0);
    return {middle, Quaternion(axes)};
}

Pose together(const Pose& second, const Pose& first)
{
    return {second.toWorld(first.position), (second.rotation * first.rotation).normalized()};
}

/// A sample of the scan with what of the part is nearest to it.
struct ScanPair {
    Vec3 place;  ///< of the scan, where it lies now
    Vec3 point;  ///< of the part
    Vec3 normal; ///< there
    double distance = 0;
    bool counts = false;
};

std::vector<ScanPair> pairsAt(const std::vector<AreaSamples::Sample>& samples, const TriangleMesh& partMesh,
                              const SurfaceDistance& part, const Pose& pose)
{
    std::vector<ScanPair> pairs(samples.size());
    forEachBlock(samples.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 place = pose.toWorld(samples[i].place);
            const SurfaceDistance::Hit hit = part.nearest(place);
            const Vec3 normal = crossOf(partMesh.vertices, partMesh.triangles[hit.triangle]).stableNormalized();
            const double cosine = std::abs(normal.dot(pose.rotation * samples[i].normal));
            pairs[i] = {place, hit.point, normal, hit.distance, cosine >= leastScanCosine};
        }
    });
    return pairs;
}

/// Pairs farther apart than most do not count.
void trim(std::vector<ScanPair>& pairs)
{
    std::vector<double> distances;
    for (const ScanPair& pair : pairs)
        distances.push_back(pair.distance);
    const auto most =
        distances.begin() + static_cast<std::ptrdiff_t>(scanTrim * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), most, distances.end());
    for (ScanPair& pair : pairs)
        pair.counts = pair.counts && pair.distance <= *most;
}

/// The small motion that brings places nearest to the planes of their partners: sum (n (p + d + w x (p - middle) - q))^2 is least.
/// What says nothing, as sliding along a plane, does not move.
Pose stepOf(const std::vector<ScanPair>& pairs, const Vec3& middle, double size)
{
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (const ScanPair& pair : pairs) {
        if (!pair.counts)
            continue;
        Vector6 row;
        row << pair.normal, ((pair.place - middle) / size).cross(pair.normal);
        normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
        right += pair.normal.dot(pair.point - pair.place) * row;
    }
    normal.diagonal().array() += 1e-6 * std::max(normal.trace(), 1e-300);
    const Vector6 step = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    const Vec3 turn = step.tail<3>() / size;
    const double angle = turn.norm();
    const Quaternion rotation = angle > 0 ? Quaternion(Eigen::AngleAxisd(angle, turn / angle)) : Quaternion::Identity();
    return {middle + step.head<3>() - rotation * middle, rotation};
}

struct Registered {
    Pose pose;
    double offset = 0; ///< root mean square of the nearest ones [m]
};

Registered registered(const std::vector<AreaSamples::Sample>& samples, const TriangleMesh& partMesh,
                      const SurfaceDistance& part, Pose pose, int rounds, double size)
{
    for (int round = 0; round < rounds; ++round) {
        std::vector<ScanPair> pairs = pairsAt(samples, partMesh, part, pose);
        trim(pairs);
        Vec3 middle = Vec3::Zero();
        for (const ScanPair& pair : pairs)
            middle += pair.place / static_cast<double>(pairs.size());
        const Pose step = stepOf(pairs, middle, size);
        pose = together(step, pose);
        const double moved = (step.toWorld(middle) - middle).norm() / size + step.rotation.vec().norm();
        if (moved < standsStill)
            break;
    }
    std::vector<ScanPair> pairs = pairsAt(samples, partMesh, part, pose);
    std::sort(pairs.begin(), pairs.end(),
              [](const ScanPair& one, const ScanPair& other) { return one.distance < other.distance; });
    const auto count = static_cast<std::size_t>(std::ceil(scanTrim * static_cast<double>(pairs.size())));
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i)
        squares += pairs[i].distance * pairs[i].distance;
    return {pose, std::sqrt(squares / static_cast<double>(count))};
}

double overlapOf(const std::vector<AreaSamples::Sample>& samples, const SurfaceDistance& part, const Pose& pose,
                 double reach)
{
    std::size_t on = 0;
    for (const AreaSamples::Sample& sample : samples)
        on += part.nearestWithin(reach, pose.toWorld(sample.place)) ? 1 : 0;
    return static_cast<double>(on) / static_cast<double>(samples.size());
}

/// All 24 ways to lay the axes of one frame along those of another: which axes are the long ones may be told by chance.
std::vector<Pose> waysToLay(const Pose& scan, const Pose& part)
{
    std::vector<Pose> ways;
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 3; ++second)
            for (int signs = 0; signs < 4 && first != second; ++signs) {
                Mat3 turn;
                turn.col(0) = ((signs & 1) != 0 ? -1 : 1) * Vec3::Unit(first);
                turn.col(1) = ((signs & 2) != 0 ? -1 : 1) * Vec3::Unit(second);
                turn.col(2) = turn.col(0).cross(turn.col(1));
                const Quaternion rotation = part.rotation * Quaternion(turn) * scan.rotation.conjugate();
                ways.push_back({part.position - rotation * scan.position, rotation});
            }
    return ways;
}

} // namespace

ScanPlacement placeScan(const TriangleMesh& scan, const TriangleMesh& partMesh, const SurfaceDistance& part,
                        TaskControl& control)
{
    const double size = boxOfPlaces(partMesh.vertices).diagonal().norm();
    const std::vector<AreaSamples::Sample> few = samplesOf(scan, fewScanSamples);
    const std::vector<AreaSamples::Sample> many = samplesOf(scan, manyScanSamples);
    Registered best;
    if (overlapOf(few, part, best.pose, onPart * size) < liesThere) {
        best.offset = size;
        const std::vector<Pose> ways = waysToLay(axesOf(many), axesOf(samplesOf(partMesh, manyScanSamples)));
        for (std::size_t i = 0; i < ways.size(); ++i) {
            control.throwIfCancelled();
            control.report(static_cast<double>(i) / static_cast<double>(ways.size()), "placing the scan");
            const Registered way = registered(few, partMesh, part, ways[i], fewRounds, size);
            if (way.offset < best.offset)
                best = way;
        }
    }
    control.throwIfCancelled();
    best = registered(many, partMesh, part, best.pose, manyRounds, size);
    return {best.pose, best.offset, overlapOf(many, part, best.pose, onPart * size)};
}

} // namespace knead
