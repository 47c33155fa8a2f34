#include "core/session/deformed_faces.h"

#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace knead {

namespace {

constexpr std::size_t samplesPerFace = 12;

/// The largest triangles of each face: enough to tell where it lies.
std::vector<std::vector<std::uint32_t>> samplesOf(const TriangleMesh& mesh, std::size_t faces)
{
    std::vector<std::vector<std::uint32_t>> samples(faces);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (t < mesh.faceOfTriangle.size() && mesh.faceOfTriangle[t] < faces)
            samples[mesh.faceOfTriangle[t]].push_back(t);
    const auto area = [&mesh](std::uint32_t t) { return crossOf(mesh.vertices, mesh.triangles[t]).norm(); };
    for (std::vector<std::uint32_t>& some : samples) {
        std::ranges::sort(some, std::ranges::greater(), area);
        some.resize(std::min(some.size(), samplesPerFace));
    }
    return samples;
}

/// No other fixture has it.
std::string freeName(const std::string& name, std::set<std::string>& taken)
{
    std::string free = name;
    for (int number = 2; !taken.insert(free).second; ++number)
        free = name + " " + std::to_string(number);
    return free;
}

} // namespace

std::vector<std::uint32_t> facesBefore(const TriangleMesh& now, std::size_t faces, const TriangleMesh& before)
{
    const SurfaceDistance distance(before);
    std::vector<std::uint32_t> result(faces);
    const auto samples = samplesOf(now, faces);
    for (std::size_t face = 0; face < faces; ++face) {
        std::map<std::uint32_t, double> votes;
        for (const std::uint32_t t : samples[face]) {
            const auto [a, b, c] = cornersOf(now.vertices, now.triangles[t]);
            const std::uint32_t nearest = distance.nearest((a + b + c) / 3).triangle;
            votes[before.faceOfTriangle[nearest]] += crossOf(now.vertices, now.triangles[t]).norm();
        }
        const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
        result[face] = most == votes.end() ? 0 : most->first;
    }
    return result;
}

std::vector<FaceFixture> fixturesAfter(const std::vector<FaceFixture>& fixtures, const FilledModel& before,
                                       const FilledModel& after, const std::vector<std::size_t>& origin,
                                       const std::function<TriangleMesh(BodyId body)>& surfaceOf)
{
    std::vector<FaceFixture> result;
    std::set<std::string> taken;
    std::map<BodyId, std::vector<std::uint32_t>> known; ///< per body of `after`
    for (const FaceFixture& fixture : fixtures) {
        if (fixture.faces.empty() || fixture.body >= before.bodies.size())
            continue;
        const std::size_t part = before.bodies[fixture.body]->part;
        for (BodyId body = 0; body < after.bodies.size(); ++body) {
            const std::size_t own = after.bodies[body]->part;
            const Part& now = after.model->parts[own];
            if (origin[own] != part || now.faces.empty())
                continue;
            if (!known.contains(body))
                known[body] = facesBefore(now.mesh, now.faces.size(), surfaceOf(fixture.body));
            FaceFixture next = fixture;
            next.body = body;
            next.id.reset();
            next.faces.clear();
            for (std::uint32_t face = 0; face < now.faces.size(); ++face)
                if (std::ranges::count(fixture.faces, known[body][face]) > 0)
                    next.faces.push_back(face);
            if (next.faces.empty())
                continue;
            next.name = freeName(fixture.name, taken);
            next.key = static_cast<std::uint32_t>(result.size() + 1);
            result.push_back(std::move(next));
        }
    }
    return result;
}

} // namespace knead
