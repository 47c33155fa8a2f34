#include "core/session/contact_shade.h"
#include "core/session/render_mesh.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace knead;

/// A torus of about 30,000 vertices with a ball and a box beside it, both so large that they shade all of it.
void shadeBesideTools(benchmark::State& state)
{
    const TriangleMesh torus = shapes::torus(0.03, 0.01, 300, 100);
    const RenderMesh mesh = renderMesh(torus);
    std::vector<float> points;
    for (const std::uint32_t vertex : mesh.source)
        for (const double coordinate : torus.vertices[vertex])
            points.push_back(static_cast<float>(coordinate));
    const std::vector<float> normals = renderNormals(mesh, points);
    std::vector<ToolState> tools(2);
    tools[0].kind = ToolKind::ball;
    tools[0].size = Vec3::Constant(0.1);
    tools[0].pose.position = Vec3(0, 0, 0.065);
    tools[1].kind = ToolKind::box;
    tools[1].size = Vec3::Constant(0.1);
    tools[1].pose.position = Vec3(0.1, 0, 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(contactShades(points, normals, tools));
    state.counters["vertices/s"] =
        benchmark::Counter(static_cast<double>(points.size()) / 3, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(shadeBesideTools)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
