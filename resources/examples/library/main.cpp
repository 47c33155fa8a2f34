// Reads a STEP file, presses a ball into the first part from above, and writes what comes of it as STEP again.
#include "core/session/export_jobs.h"
#include "core/session/part_filling.h"
#include "core/simulation/simulation.h"
#include "io/export/exporter.h"
#include "io/files/safe_file.h"
#include "io/importer.h"

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

namespace {

using namespace knead;

constexpr std::array<std::size_t, 1> bodies{0}; // the part of each body

/// The part, soft, on a floor. A ball twice as wide as the part is thick comes down by a quarter of that in a second.
Scene sceneOf(const std::shared_ptr<const Model>& model)
{
    const Part& part = model->parts.front();
    const double spacing = spacingForObjectCount(part.mesh, 3000);
    const double height = part.box.sizes().z();
    const Vec3 top(part.box.center().x(), part.box.center().y(), part.box.max().z());

    Manipulator ball{.name = "Ball", .size = Vec3::Constant(2 * height), .kind = ToolKind::ball};
    ball.pose.position = top + Vec3(0, 0, height);
    ball.motion = DriveAt{.velocity = Vec3(0, 0, -height / 4)};

    Scene scene;
    scene.bodies.push_back({.name = part.name,
                            .aggregate = fillPart(part, spacing, Arrangement::cutCells, TaskControl::none()),
                            .material = {.youngsModulus = 1e6, .yieldStress = 1e5},
                            .surface = surfaceOf(model, 0)});
    scene.manipulators.push_back(ball);
    scene.floorHeight = part.box.min().z();
    scene.integrator = Integrator::implicitEuler;
    return scene;
}

void press(const char* from, const char* to)
{
    // Here, in this process; importIsolated() reads files of strangers in one that is locked in.
    const auto model = std::make_shared<const Model>(importFile(from));
    Simulation simulation(sceneOf(model));
    while (simulation.time() < 1 && simulation.health().ok)
        simulation.step();
    if (!simulation.health().ok)
        throw Problem(simulation.health().message);

    ExportJob job = exportJobOf(*model, bodies, *simulation.snapshot());
    const ExportedFile file = exportCad(FormatKind::Step, std::move(job), TaskControl::none());
    writeFileSafely(to, file.bytes);
    for (const PartExportReport& part : file.report.parts)
        std::printf("%s: %d faces, %.3f cm3, %s\n", part.name.c_str(), part.facesAfter, 1e6 * part.volume,
                    part.isSound() ? "sound" : "not sound");
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
        return std::fprintf(stderr, "press PART.step PRESSED.step\n"), 2;
    try {
        press(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
