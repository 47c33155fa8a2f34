// The map of a displacement field: made from a sixty-fourth of a million nodes on, to see the growth, and looked at. The field is that of
// a plate with a hole under tension and bending: smooth but near the hole.
#include "core/deformation/field_map.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>

namespace {

using namespace knead;

constexpr double radius = 0.01;

Vec3 displacementAt(const Vec3& p)
{
    const double r = std::max(std::hypot(p.x(), p.y()), radius) / radius;
    const double a = std::atan2(p.y(), p.x());
    return {
        1e-6 * (3 * r * std::cos(a) + 2 / r * (3 * std::cos(a) + std::cos(3 * a)) - 2 / (r * r * r) * std::cos(3 * a)) -
            0.2 * p.z() * p.x(),
        1e-6 * (-r * std::sin(a) + 2 / r * (-std::sin(a) + std::sin(3 * a)) - 2 / (r * r * r) * std::sin(3 * a)),
        0.1 * p.x() * p.x() + 0.3 * p.x() * p.x() * p.x()};
}

/// About so many nodes in a plate of 100 x 100 x 10 mm around the hole, by chance a little off a lattice.
std::shared_ptr<const DisplacementField> plate(std::int64_t nodes)
{
    static std::map<std::int64_t, std::shared_ptr<const DisplacementField>> kept;
    auto& field = kept[nodes];
    if (field != nullptr)
        return field;
    DisplacementField made;
    std::minstd_rand random(1);
    const double spacing = std::cbrt(1e-4 / static_cast<double>(nodes));
    const auto chance = [&] { return 0.4 * spacing * (static_cast<double>(random() % 10007) / 10007 - 0.5); };
    for (double x = -0.05; x <= 0.05; x += spacing)
        for (double y = -0.05; y <= 0.05; y += spacing)
            for (double z = 0; z <= 0.01; z += spacing)
                if (const Vec3 node(x + chance(), y + chance(), z + chance()); node.head<2>().norm() >= radius) {
                    made.nodes.push_back(node);
                    made.displacements.push_back(displacementAt(node));
                }
    return field = std::make_shared<const DisplacementField>(std::move(made));
}

void makeFieldMap(benchmark::State& state)
{
    const auto field = plate(state.range(0));
    std::shared_ptr<const SmoothMap> map;
    for (auto _ : state)
        map = fieldMap({.field = field});
    const auto nodes = static_cast<double>(field->nodes.size());
    state.counters["nodes"] = nodes;
    state.counters["nodes/s"] = benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["feature_mm"] = 1e3 * map->featureSize();
}
BENCHMARK(makeFieldMap)->RangeMultiplier(4)->Range(1 << 14, 1 << 20)->Unit(benchmark::kMillisecond)->UseRealTime();

void evaluate(benchmark::State& state, const FieldDeformation& deformation)
{
    const auto map = fieldMap(deformation);
    std::minstd_rand random(2);
    const auto chance = [&] { return static_cast<double>(random() % 100003) / 100003; };
    std::vector<Vec3> points(1'000'000); // along lines, as who fits faces asks
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = i % 50 == 0 ? Vec3(0.1 * chance() - 0.05, 0.1 * chance() - 0.05, 0.01 * chance())
                                : Vec3(points[i - 1] + Vec3(1e-4, 5e-5, 0));
    std::vector<Vec3> places(points.size());
    double worst = 0;
    for (auto _ : state)
        map->evaluate(points, places);
    if (deformation.kept.empty())
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].head<2>().norm() >= radius && points[i].head<2>().cwiseAbs().maxCoeff() < 0.05)
                worst = std::max(worst, (places[i] - points[i] - displacementAt(points[i])).norm());
    state.counters["error_um"] = 1e6 * worst;
    state.counters["points/s"] =
        benchmark::Counter(static_cast<double>(points.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void evaluateFieldMap(benchmark::State& state)
{
    evaluate(state, {.field = plate(state.range(0))});
}
BENCHMARK(evaluateFieldMap)->Arg(1 << 16)->Arg(1 << 20)->Unit(benchmark::kMillisecond)->UseRealTime();

void evaluateBesideKeptFaces(benchmark::State& state)
{
    evaluate(state, {.field = plate(1 << 16), .kept = shapes::cylinder(radius, 0.02, 64), .fade = 0.005});
}
BENCHMARK(evaluateBesideKeptFaces)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
