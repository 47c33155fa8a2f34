#include "core/deformation/scan_field.h"

#include "core/deformation/field_fit_words.h"
#include "core/deformation/scan_placement.h"
#include "core/geometry/area_samples.h"
#include "core/geometry/point_tree.h"
#include "core/message/number_text.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
constexpr std::size_t lookRounds = 3;
constexpr int smoothRounds = 100; // so far, in the root of it spacings, motion along the surface spreads

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
    const TriangleMesh& scan;
    SurfaceDistance toScan;
    const SurfaceDistance& toPart;
    double mostAlong = 0; ///< [m]
    double spacing = 0;   ///< of the points [m]
};

/// Where the normal of a point, from where it moved, meets the scan: by Newton's method on the distance to its nearest triangle. Then
/// back to the part.
void look(ScanLook& point, const ScanAndPart& both)
{
    constexpr int rounds = 4;
    const Vec3& normal = point.sample.normal;
    const Vec3 start = point.sample.place + point.moved;
    double along = 0;
    double cosine = 0;
    Vec3 there = start;
    point.distance = both.toScan.nearest(point.sample.place).distance;
    point.counts = false;
    for (int round = 0; round < rounds; ++round) {
        const SurfaceDistance::Hit hit = both.toScan.nearest(start + along * normal);
        const Vec3 other = crossOf(both.scan.vertices, both.scan.triangles[hit.triangle]).stableNormalized();
        cosine = normal.dot(other);
        there = hit.point;
        if (std::abs(cosine) < leastLookCosine)
            return;
        along = other.dot(hit.point - start) / cosine;
    }
    const double off = (start + along * normal - there).norm();
    const double back = (both.toPart.nearest(there - point.moved).point - point.sample.place).norm();
    const double slack = backShare * std::abs(along) + backSpacings * both.spacing;
    point.along = along + normal.dot(point.moved);
    point.counts = cosine > 0 && std::abs(point.along) <= both.mostAlong && back <= slack && off <= slack;
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

/// Motions u in space from what normals n tell of them: sum (n u - along)^2 + smoothingWeight |u - mean of u around|^2 is least, by
/// rounds of Jacobi's method. Points that do not count go with those around them.
void smooth(std::vector<ScanLook>& looks, const Neighbors& neighbors)
{
    std::vector<Vec3> next(looks.size());
    for (int round = 0; round < smoothRounds; ++round) {
        forEachBlock(looks.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Vec3 mean = Vec3::Zero();
                for (const PointTree::Found& neighbor : neighbors[i])
                    mean += looks[neighbor.point].moved / static_cast<double>(neighbors[i].size());
                const Vec3& normal = looks[i].sample.normal;
                next[i] = mean;
                if (looks[i].counts)
                    next[i] += (looks[i].along - normal.dot(mean)) / (1 + smoothingWeight) * normal;
            }
        });
        for (std::size_t i = 0; i < looks.size(); ++i)
            looks[i].moved = next[i];
    }
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
        smooth(looks, neighbors);
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
    const std::vector<ScanLook> looks = compared(
        part, {there, SurfaceDistance(there), toPart, options.mostDistance * size, spacing}, options, comparing);
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
