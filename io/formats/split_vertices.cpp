#include "io/formats/split_vertices.h"

#include "core/task/parallel.h"

#include <numeric>

namespace knead {

namespace {

constexpr std::size_t shortestRun = 1U << 14U;
constexpr std::size_t mostRuns = 64; // each looks at all triangles
constexpr std::size_t fansPerBlock = 512;
constexpr float sameNormalCosine = 0.9999F; // cosine, of 0.8 degrees

} // namespace

SplitVertices::SplitVertices(const MeshBody& body)
    : m_body(body)
    , m_colors(groupByColor(body))
    , m_runLength(std::max(shortestRun, body.mesh.vertices.size() / mostRuns))
    , m_places(body.mesh.vertices.size(), none)
{
    m_used.reserve(body.mesh.vertices.size());
}

void SplitVertices::choose(const ColorGroups::Group& group)
{
    for (const std::uint32_t vertex : m_used)
        m_places[vertex] = none;
    m_used.clear();
    m_extras.clear();
    m_offsets.clear();
    m_group = group;
    forEachCorner([this](std::uint32_t triangle, std::uint32_t corner) {
        const std::uint32_t vertex = m_body.mesh.triangles[triangle][corner];
        if (m_places[vertex] != none)
            return;
        m_places[vertex] = static_cast<std::uint32_t>(m_used.size());
        m_used.push_back(vertex);
    });
    for (std::size_t begin = 0; begin < m_used.size(); begin += m_runLength) {
        const Run run = runFrom(begin);
        takeExtras(run, begin);
        takeOffsets(run, begin);
    }
    std::sort(m_offsets.begin(), m_offsets.end());
}

SplitVertices::Run SplitVertices::runFrom(std::size_t begin) const
{
    const std::size_t count = std::min(m_runLength, m_used.size() - begin);
    const auto forEachHere = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < m_body.mesh.triangles.size(); ++t)
            for (std::uint32_t corner = 0; corner < 3; ++corner)
                if (const std::size_t place = m_places[m_body.mesh.triangles[t][corner]] - begin; place < count)
                    visit(place, MeshCorner{t, corner});
    };
    Run run;
    run.first.assign(count + 1, 0);
    forEachHere([&](std::size_t place, const MeshCorner&) { ++run.first[place + 1]; });
    std::partial_sum(run.first.begin(), run.first.end(), run.first.begin());
    run.corners.resize(run.first.back());
    run.normal.resize(run.first.back());
    run.kind.assign(run.first.back(), none);
    std::vector<std::size_t> next(run.first.begin(), run.first.end() - 1);
    forEachHere([&](std::size_t place, const MeshCorner& corner) { run.corners[next[place]++] = corner; });
    forEachBlock(count, fansPerBlock, [&](std::size_t from, std::size_t to) {
        for (std::size_t vertex = from; vertex < to; ++vertex)
            tellKindsApart(run, vertex);
    });
    return run;
}

void SplitVertices::tellKindsApart(Run& run, std::size_t vertex) const
{
    const std::size_t begin = run.first[vertex];
    const std::size_t end = run.first[vertex + 1];
    const std::vector<Vec3> normals = fanNormals(m_body.mesh, std::span(run.corners.data() + begin, end - begin));
    std::vector<std::size_t> firsts; // of each kind
    for (std::size_t c = begin; c < end; ++c) {
        const Vec3& normal = normals[c - begin];
        run.normal[c] = (normal.isZero() ? Vec3(Vec3::UnitZ()) : normal).cast<float>();
        if (!isOfGroup(run.corners[c].triangle))
            continue;
        const auto same = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t first) {
            return run.normal[first].dot(run.normal[c]) > sameNormalCosine;
        });
        run.kind[c] = static_cast<std::uint32_t>(same - firsts.begin());
        if (same == firsts.end())
            firsts.push_back(c);
    }
}

bool SplitVertices::isOfGroup(std::uint32_t triangle) const
{
    return m_colors.groups.size() == 1 || toBytes(colorOf(m_body, triangle)) == toBytes(m_group.color);
}

void SplitVertices::takeExtras(const Run& run, std::size_t begin)
{
    for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
        std::uint32_t kinds = 0;
        for (std::size_t c = run.first[i]; c < run.first[i + 1]; ++c)
            if (run.kind[c] != none)
                kinds = std::max(kinds, run.kind[c] + 1);
        if (kinds > 1)
            m_extras.emplace_back(begin + i, (m_extras.empty() ? 0 : m_extras.back().second) + kinds - 1);
    }
}

void SplitVertices::takeOffsets(const Run& run, std::size_t begin)
{
    if (std::none_of(run.kind.begin(), run.kind.end(), [](std::uint32_t kind) { return kind != none && kind > 0; }))
        return;
    std::uint64_t sequence = 0;
    forEachCorner([&](std::uint32_t triangle, std::uint32_t corner) {
        const std::size_t place = m_places[m_body.mesh.triangles[triangle][corner]] - begin;
        if (place < run.first.size() - 1) // those before the run are far beyond its end
            for (std::size_t c = run.first[place]; c < run.first[place + 1]; ++c)
                if (run.corners[c].triangle == triangle && run.corners[c].index == corner && run.kind[c] > 0)
                    m_offsets.emplace_back(sequence, run.kind[c]);
        ++sequence;
    });
}

} // namespace knead
