#include "core/aggregate/fill.h"
#include "core/session/ambient_shade.h"
#include "core/session/contact_shade.h"
#include "core/session/render_mesh.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace knead;

/// Of about 30,000 vertices, as it is drawn.
struct Torus {
    TriangleMesh mesh = shapes::torus(0.03, 0.01, 300, 100);
    std::vector<float> points;
    std::vector<float> normals;

    Torus()
    {
        const RenderMesh render = renderMesh(mesh);
        for (const std::uint32_t vertex : render.source)
            for (const double coordinate : mesh.vertices[vertex])
                points.push_back(static_cast<float>(coordinate));
        normals = renderNormals(render, points);
    }

    void count(benchmark::State& state) const
    {
        state.counters["vertices/s"] =
            benchmark::Counter(static_cast<double>(points.size()) / 3, benchmark::Counter::kIsIterationInvariantRate);
    }
};

/// A ball and a box beside it, both so large that they shade all of it.
void shadeBesideTools(benchmark::State& state)
{
    const Torus torus;
    std::vector<ToolState> tools(2);
    tools[0].kind = ToolKind::ball;
    tools[0].size = Vec3::Constant(0.1);
    tools[0].pose.position = Vec3(0, 0, 0.065);
    tools[1].kind = ToolKind::box;
    tools[1].size = Vec3::Constant(0.1);
    tools[1].pose.position = Vec3(0.1, 0, 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(contactShades(torus.points, torus.normals, tools));
    torus.count(state);
}
BENCHMARK(shadeBesideTools)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Filled with about 30,000 objects: the grids of its material, and the shades.
void shadeInHollows(benchmark::State& state)
{
    const Torus torus;
    Snapshot::BodyState body;
    body.aggregate = std::make_shared<const Aggregate>(fill(torus.mesh, {.spacing = 1.25e-3}));
    for (std::size_t i = 0; i < body.aggregate->size(); ++i)
        body.positions.push_back(body.aggregate->lattice.position(i));
    for (auto _ : state)
        benchmark::DoNotOptimize(ambientShades(torus.points, torus.normals, MaterialAround({&body, 1})));
    torus.count(state);
}
BENCHMARK(shadeInHollows)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
