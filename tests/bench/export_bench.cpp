// Carrying a plate with rounded holes through the map of its bent objects; then the whole export: morphed, written as STEP, read
// back and compared. Beside it the same export of the plate where nothing has moved.
#include "core/aggregate/fill.h"
#include "core/skin/skin_map.h"
#include "io/brep/exact_shapes.h"
#include "io/export/exporter.h"
#include "io/importer.h"
#include "io/morph/brep_morph.h"
#include "support/space_maps.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <numbers>

namespace {

using namespace knead;

constexpr double pitch = 12;    // of holes [mm]
constexpr double thickness = 8; // [mm]
constexpr double rim = 0.8;     // radius of the rounding [mm]

/// A plate with n x m holes, rounded at both rims: 6 + 3 n m faces.
TopoDS_Shape plate(int n, int m)
{
    TopoDS_Compound drills;
    BRep_Builder builder;
    builder.MakeCompound(drills);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j)
            builder.Add(drills,
                        BRepPrimAPI_MakeCylinder(gp_Ax2({(i + 0.5) * pitch, (j + 0.5) * pitch, -1}, gp_Dir(0, 0, 1)), 3,
                                                 2 + thickness)
                            .Shape());
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(n * pitch, m * pitch, thickness).Shape(), drills);
    BRepFilletAPI_MakeFillet fillet(drilled);
    for (TopExp_Explorer edges(drilled, TopAbs_EDGE); edges.More(); edges.Next()) {
        double first = 0;
        double last = 0;
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (!curve.IsNull() && curve->IsClosed() && fillet.Contour(edge) == 0)
            fillet.Add(rim, edge);
    }
    return fillet.Shape();
}

struct BentPlate {
    ExportJob job;
    ExportJob unmoved;
};

const BentPlate& bentPlate(int n, int m)
{
    static std::map<std::pair<int, int>, BentPlate> plates;
    auto [found, isNew] = plates.try_emplace({n, m});
    if (!isNew)
        return found->second;
    const std::string path = (std::filesystem::temp_directory_path() / "knead_export_bench.brep").string();
    BRepTools::Write(plate(n, m), path.c_str());
    const Model model = importFile(path);
    std::filesystem::remove(path);
    PartToExport part{.part = model.parts.front()};
    part.aggregate = std::make_shared<const Aggregate>(
        fill(part.part.mesh, {.spacing = spacingForObjectCount(part.part.mesh, 20'000)}));
    const maps::Bend bend(part.part.box, 0.5 * std::numbers::pi);
    for (ObjectIndex i = 0; i < part.aggregate->size(); ++i) {
        const Vec3 at = part.aggregate->lattice.position(i);
        part.displacements.push_back(bend.at(at) - at);
    }
    BentPlate& bent = found->second;
    bent.job.tree = bent.unmoved.tree = model.tree;
    bent.job.parts.push_back(part);
    bent.unmoved.parts.push_back({.part = part.part});
    return bent;
}

void countFaces(benchmark::State& state, std::size_t faces)
{
    state.counters["faces"] = static_cast<double>(faces);
    state.counters["faces/s"] =
        benchmark::Counter(static_cast<double>(faces), benchmark::Counter::kIsIterationInvariantRate);
}

void morphPlate(benchmark::State& state)
{
    const BentPlate& bent = bentPlate(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const PartToExport& part = bent.job.parts.front();
    const TopoDS_Shape shape = shapesFromBytes(*part.part.exact->bytes)[part.part.exact->number];
    const SkinMap map(*part.aggregate, part.displacements);
    for (auto _ : state) {
        const MorphedShape morphed =
            morphShape(shape, map, {.tolerance = 0.1 * part.part.box.diagonal().norm()}); // 1e-4 of it, in mm
        if (!morphed.isValid)
            state.SkipWithError("the plate is not valid");
    }
    countFaces(state, part.part.faces.size());
}

void exportPlate(benchmark::State& state)
{
    const BentPlate& bent = bentPlate(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const ExportJob& job = state.range(2) != 0 ? bent.job : bent.unmoved;
    ExportedFile file;
    for (auto _ : state) {
        file = exportCad(FormatKind::Step, job, TaskControl::none());
        if (!file.report.isSound() || file.report.parts.front().form != PartExportReport::Form::exact) {
            std::string why;
            for (const std::string& line : linesOf(file.report))
                why += line + "\n";
            state.SkipWithError(why.c_str());
            return;
        }
    }
    const std::size_t faces = job.parts.front().part.faces.size();
    countFaces(state, faces);
    state.counters["bytes/face"] = static_cast<double>(file.bytes.size()) / static_cast<double>(faces);
    state.counters["kink_degrees"] = file.report.parts.front().largestKink * 180 / std::numbers::pi;
}

BENCHMARK(morphPlate)
    ->ArgNames({"n", "m"})
    ->Args({5, 4})
    ->Args({10, 8})
    ->Args({20, 16})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(exportPlate)
    ->ArgNames({"n", "m", "moved"})
    ->Args({5, 4, 1})
    ->Args({10, 8, 1})
    ->Args({20, 16, 1})
    ->Args({10, 8, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
