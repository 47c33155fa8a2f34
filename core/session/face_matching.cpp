#include "core/session/face_matching.h"

#include "core/geometry/assignment.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

// What differences cost. A face that is found in another place by a quarter of the size of the part, or faces another way by 60
// degrees, is no more likely that face than none.
constexpr double placeWeight = 4;
constexpr double relativeWeight = 0.5; // of the place in the box, where counted from an end it fits better
constexpr double normalWeight = 1;     // times (1 - cos) for planes
constexpr double spreadWeight = 1;
constexpr double areaWeight = 0.3; // times the logarithm of the ratio
constexpr double bulgeWeight = 1;
constexpr double neighborWeight = 0.5;
constexpr double colorBonus = 0.4;
constexpr double costOfNone = 1;
constexpr std::size_t manyNames = 4;    // most of so many are of faces that are alike, or they are numbers
constexpr std::size_t mostOptions = 16; // per face: the cheapest
constexpr int rounds = 3;               // the first one knows no neighbors

using Pairs = std::vector<std::optional<std::uint32_t>>;

constexpr std::size_t trianglesAtOnce = 4096; // between looks at whether to go on
constexpr std::size_t facesAtOnce = 8;

void addNeighbors(const TriangleMesh& mesh, std::vector<FaceLook>& looks, const TaskControl& control)
{
    std::unordered_map<std::uint64_t, std::uint32_t> faceAt; // edge
    faceAt.reserve(3 * mesh.triangles.size() / 2);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (t % trianglesAtOnce == 0)
            control.throwIfCancelled();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t face = mesh.faceOfTriangle[t];
            const std::uint64_t edge = pairKey(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
            const auto [at, isNew] = faceAt.emplace(edge, face);
            if (isNew || at->second == face)
                continue;
            looks[face].neighbors.push_back(at->second);
            looks[at->second].neighbors.push_back(face);
        }
    }
    for (FaceLook& look : looks) {
        std::ranges::sort(look.neighbors);
        look.neighbors.erase(std::ranges::unique(look.neighbors).begin(), look.neighbors.end());
    }
}

FaceLook carried(FaceLook look, const AffineMap& to)
{
    const double scale = std::cbrt(std::abs(to.linear.determinant()));
    const Mat3 turn = to.linear / scale;
    look.area *= scale * scale;
    look.center = to.at(look.center);
    look.normal = turn * look.normal;
    look.spread = turn * look.spread * turn.transpose();
    look.bulge *= scale;
    return look;
}

Box carried(const Box& box, const AffineMap& to)
{
    Box result;
    for (int corner = 0; corner < 8; ++corner)
        result.extend(to.at(box.corner(static_cast<Box::CornerType>(corner))));
    return result;
}

/// Along one axis, as shares of the size: from the end that fits better, and in proportion.
double placeDifference(double before, double minBefore, double maxBefore, double after, double minAfter,
                       double maxAfter)
{
    const double size = std::max(maxBefore - minBefore, maxAfter - minAfter);
    if (size <= 0)
        return 0;
    const double fromLow = std::abs((before - minBefore) - (after - minAfter)) / size;
    const double fromHigh = std::abs((maxBefore - before) - (maxAfter - after)) / size;
    const double inProportion = std::abs((before - minBefore) / std::max(maxBefore - minBefore, 1e-12 * size) -
                                         (after - minAfter) / std::max(maxAfter - minAfter, 1e-12 * size));
    return placeWeight * std::min({fromLow, fromHigh, inProportion}) + relativeWeight * inProportion;
}

bool haveSameColor(const FaceLook& a, const FaceLook& b)
{
    return a.color && b.color && *a.color == *b.color;
}

double differenceOf(const FaceLook& before, const Box& boxBefore, const FaceLook& after, const Box& boxAfter)
{
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = placeDifference(before.center[axis], boxBefore.min()[axis], boxBefore.max()[axis],
                                      after.center[axis], boxAfter.min()[axis], boxAfter.max()[axis]);
    const double size = std::sqrt(std::max(before.area, after.area));
    if (size <= 0)
        return costOfNone;
    double cost = place.norm();
    cost += normalWeight * (before.normal - after.normal).squaredNorm() / 2;
    cost += spreadWeight * (before.spread - after.spread).norm();
    cost += areaWeight * std::abs(std::log(std::max(before.area, 1e-30) / std::max(after.area, 1e-30)));
    cost += bulgeWeight * std::abs(before.bulge - after.bulge) / size;
    if (haveSameColor(before, after))
        cost = std::max(0.0, cost - colorBonus);
    else if (before.color != after.color)
        cost += colorBonus / 2;
    return cost;
}

/// Share of the neighbors that are neighbors of the other face, too.
double sharedNeighbors(const FaceLook& before, const FaceLook& after, const Pairs& pairs)
{
    if (before.neighbors.empty() || after.neighbors.empty())
        return 1;
    const auto isShared = [&](std::uint32_t face) {
        return pairs[face] && std::ranges::binary_search(after.neighbors, *pairs[face]);
    };
    const auto shared = std::ranges::count_if(before.neighbors, isShared);
    return static_cast<double>(shared) / static_cast<double>(std::max(before.neighbors.size(), after.neighbors.size()));
}

using Options = std::vector<std::vector<PairingOption>>;

/// Those of one name, whatever else differs; but not where names are numbers that a program counted anew: then most of them are of
/// faces that are nothing alike.
class NamedPairs {
public:
    NamedPairs(std::span<const FaceLook> before, const Box& boxBefore, std::span<const FaceLook> after,
               const Box& boxAfter)
        : m_after(before.size())
        , m_isTaken(after.size())
    {
        std::unordered_map<std::string_view, std::uint32_t> named;
        // What has no triangles has no place either.
        for (std::uint32_t a = 0; a < after.size(); ++a)
            if (!after[a].name.empty() && after[a].area > 0)
                named.emplace(after[a].name, a);
        std::size_t pairs = 0;
        std::size_t unlike = 0;
        for (std::size_t b = 0; b < before.size(); ++b)
            if (const auto found = named.find(before[b].name); found != named.end() && before[b].area > 0) {
                m_after[b] = found->second;
                m_isTaken[found->second] = true;
                ++pairs;
                unlike += differenceOf(before[b], boxBefore, after[found->second], boxAfter) >= costOfNone ? 1 : 0;
            }
        if (pairs >= manyNames && 2 * unlike > pairs) {
            m_after.assign(before.size(), std::nullopt);
            m_isTaken.assign(after.size(), false);
        }
    }

    std::optional<std::uint32_t> partnerOf(std::size_t before) const { return m_after[before]; }
    bool isTaken(std::size_t after) const { return m_isTaken[after]; }

private:
    Pairs m_after; // by the number of the face before
    std::vector<bool> m_isTaken;
};

Options optionsOf(std::span<const FaceLook> before, const Box& boxBefore, std::span<const FaceLook> after,
                  const Box& boxAfter, const NamedPairs& named, const TaskControl& control)
{
    Options options(before.size());
    forEachBlock(before.size(), facesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            if (const auto partner = named.partnerOf(b)) {
                options[b].push_back({*partner, 0});
                continue;
            }
            for (std::uint32_t a = 0; a < after.size(); ++a) {
                if (named.isTaken(a))
                    continue;
                if (const double cost = differenceOf(before[b], boxBefore, after[a], boxAfter); cost < costOfNone)
                    options[b].push_back({a, cost});
            }
            std::ranges::stable_sort(options[b], {}, &PairingOption::cost);
            options[b].resize(std::min(options[b].size(), mostOptions));
        }
    });
    return options;
}

/// Those before with what their neighbors say.
Options withNeighbors(Options options, std::span<const FaceLook> before, std::span<const FaceLook> after,
                      const Pairs& pairs)
{
    for (std::size_t b = 0; b < options.size(); ++b)
        for (PairingOption& option : options[b])
            option.cost += neighborWeight * (1 - sharedNeighbors(before[b], after[option.other], pairs));
    return options;
}

} // namespace

std::vector<FaceLook> faceLooks(const Part& part, const TaskControl& control)
{
    const TriangleMesh& mesh = part.mesh;
    std::vector<FaceLook> looks(std::max<std::size_t>(part.faces.size(), 1));
    const bool hasFaces = !part.faces.empty() && !mesh.faceOfTriangle.empty();
    const auto lookOf = [&](std::size_t t) -> FaceLook& { return looks[hasFaces ? mesh.faceOfTriangle[t] : 0]; };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
        const Vec3 cross = crossOf(corners) / 2;
        const double area = cross.norm();
        if (area == 0)
            continue;
        FaceLook& look = lookOf(t);
        look.area += area;
        look.center += area / 3 * (corners[0] + corners[1] + corners[2]);
        look.normal += cross;
        look.spread += cross * cross.transpose() / area;
    }
    for (FaceLook& look : looks)
        if (look.area > 0) {
            look.center /= look.area;
            look.normal /= look.area;
            look.spread /= look.area;
        }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
        FaceLook& look = lookOf(t);
        if (look.area > 0)
            look.bulge +=
                crossOf(corners).dot((corners[0] + corners[1] + corners[2]) / 3 - look.center) / 2 / look.area;
    }
    std::unordered_map<std::string_view, std::size_t> uses;
    for (const PartFace& face : part.faces)
        ++uses[face.name];
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
        looks[f].color = part.faces[f].color;
        if (uses[part.faces[f].name] == 1)
            looks[f].name = part.faces[f].name;
    }
    if (hasFaces)
        addNeighbors(mesh, looks, control);
    return looks;
}

std::vector<FaceMatch> matchFaces(std::span<const FaceLook> before, const Box& boxBefore,
                                  std::span<const FaceLook> after, const Box& boxAfter, const AffineMap& to,
                                  const TaskControl& control)
{
    std::vector<FaceLook> there;
    for (const FaceLook& look : before)
        there.push_back(carried(look, to));
    const Box boxThere = carried(boxBefore, to);
    const NamedPairs named(there, boxThere, after, boxAfter);
    const Options plain = optionsOf(there, boxThere, after, boxAfter, named, control);
    Options options = plain;
    Pairs pairs;
    for (int round = 0; round < rounds; ++round) {
        if (round > 0)
            options = withNeighbors(plain, there, after, pairs);
        pairs = leastCostPairs(options, after.size(), costOfNone + (round > 0 ? neighborWeight / 2 : 0), control);
    }
    std::vector<FaceMatch> matches;
    for (std::uint32_t b = 0; b < pairs.size(); ++b) {
        if (!pairs[b])
            continue;
        if (named.partnerOf(b)) {
            matches.push_back({.before = b, .after = *pairs[b], .by = FoundBy::name, .score = 1});
            continue;
        }
        const auto chosen = std::ranges::find(options[b], *pairs[b], &PairingOption::other);
        matches.push_back({.before = b,
                           .after = *pairs[b],
                           .by = haveSameColor(there[b], after[*pairs[b]]) ? FoundBy::color : FoundBy::place,
                           .score = std::clamp(1 - chosen->cost / (costOfNone + neighborWeight), 0.0, 1.0)});
    }
    return matches;
}

} // namespace knead
