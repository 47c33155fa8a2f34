// Frames under a recorded hand, as a person would see them: how long each takes, in milliseconds and in evaluations of all forces of
// the same body, measured between frames of the same run, which the noise of a machine cannot bend.
#include "core/mechanics/structural_connections.h"
#include "core/simulation/simulation.h"
#include "io/material_library.h"
#include "realtime/realtime_scenes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>

using namespace knead;

namespace {

using Clock = std::chrono::steady_clock;
constexpr double frame = 1.0 / 60; // [s]
constexpr int framesPerUnit = 6;   // an evaluation is measured so often

double millisecondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// The forces of the bodies of a scene at rest, evaluated.
class Unit {
public:
    explicit Unit(const Scene& scene)
    {
        m_bodies.reserve(scene.bodies.size());
        for (const knead::Body& body : scene.bodies) {
            m_bodies.push_back(std::make_unique<Evaluated>(body));
            measure();
        }
        m_times.clear();
    }

    void measure()
    {
        const Clock::time_point begin = Clock::now();
        for (const auto& body : m_bodies)
            body->connections.computeForces(body->state, frame, frame);
        m_times.push_back(millisecondsSince(begin));
    }

    double median() const
    {
        std::vector<double> times = m_times;
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    }

private:
    struct Evaluated {
        explicit Evaluated(const knead::Body& body)
            : materials(body.material, body.aggregate->size())
            , connections(body.aggregate, materials)
            , state(objectsAtRest(*body.aggregate))
        {
        }
        MaterialMap materials;
        StructuralConnections connections;
        ObjectState state;
    };
    std::vector<std::unique_ptr<Evaluated>> m_bodies;
    std::vector<double> m_times;
};

double share(std::vector<double> values, double of)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(of * static_cast<double>(values.size() - 1))];
}

nlohmann::json play(const RealtimeScene& played, const char* material)
{
    Unit unit(played.scene);
    Simulation simulation{Scene(played.scene)};
    const Pose start = played.depth > 0 ? played.scene.manipulators[0].pose : Pose{};
    std::vector<double> times;
    double iterations = 0;
    double steps = 0;
    double mostForce = 0;
    std::string trouble;
    const auto frames = static_cast<int>(handSeconds / frame + 0.5);
    for (int n = 0; n < frames && trouble.empty(); ++n) {
        if (n % framesPerUnit == 0)
            unit.measure();
        const double end = frame * (n + 1);
        const Clock::time_point begin = Clock::now();
        if (played.depth > 0) {
            Pose wanted = start;
            wanted.position += handAt(played, end);
            simulation.post(SetManipulatorMotion{0, GoTo{wanted}});
        }
        while (simulation.time() < end - 1e-9) {
            simulation.step();
            const auto shot = simulation.snapshot();
            iterations += shot->solverIterations;
            ++steps;
            if (!shot->tools.empty())
                mostForce = std::max(mostForce, shot->tools[0].force.norm());
            if (!shot->health.ok) {
                trouble = shot->health.message;
                break;
            }
        }
        times.push_back(millisecondsSince(begin));
    }
    const double milliseconds = std::accumulate(times.begin(), times.end(), 0.0);
    const double counted = static_cast<double>(times.size());
    std::size_t objects = 0;
    for (const knead::Body& body : played.scene.bodies)
        objects += body.aggregate->size();
    nlohmann::json row{{"scene", played.name},
                       {"material", material},
                       {"objects", objects},
                       {"unit_ms", unit.median()},
                       {"median_ms", share(times, 0.5)},
                       {"p95_ms", share(times, 0.95)},
                       {"p99_ms", share(times, 0.99)},
                       {"median_units", share(times, 0.5) / unit.median()},
                       {"p95_units", share(times, 0.95) / unit.median()},
                       {"ratio", 1e3 * frame * counted / milliseconds},
                       {"iterations_per_frame", iterations / counted},
                       {"steps_per_frame", steps / counted},
                       {"most_force_n", mostForce},
                       {"force_limit_n", played.depth > 0 ? played.scene.manipulators[0].forceLimit : 0},
                       {"stopped", trouble}};
    std::printf("%-11s %-16s %6zu  %5.2f  %7.1f %7.1f %7.1f  %6.0f %6.0f  %5.2f  %6.1f %5.2f%s\n", played.name.c_str(),
                material, objects, unit.median(), share(times, 0.5), share(times, 0.95), share(times, 0.99),
                share(times, 0.5) / unit.median(), share(times, 0.95) / unit.median(),
                1e3 * frame * counted / milliseconds, iterations / counted, steps / counted,
                trouble.empty() ? "" : "  stopped");
    std::fflush(stdout);
    return row;
}

} // namespace

/// knead_realtime OUT.json [OBJECTS] [MATERIAL] [SCENE]
int main(int argc, char** argv)
{
    const double objects = argc > 2 ? std::atof(argv[2]) : 27'000;
    const std::string onlyMaterial = argc > 3 ? argv[3] : "";
    const std::string onlyScene = argc > 4 ? argv[4] : "";
    struct Named {
        const char* name;
        const char* preset;
        double poisson; ///< in place of the preset's; 0: as it is
    };
    const Named materials[] = {{"sponge", "sponge-rubber", 0},
                               {"rubber .45", "silicone-rubber", 0.45},
                               {"rubber .49", "silicone-rubber", 0.49},
                               {"steel", "steel", 0},
                               {"clay", "modeling-clay", 0}};
    const std::vector<MaterialPreset> presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
    std::printf(
        "scene       material        objects   unit   median     95 %%    99 %%   median   95 %%  ratio    CG/frame "
        "steps\n                                        ms       ms       ms      ms    units  units\n");
    nlohmann::json rows = nlohmann::json::array();
    for (const Named& named : materials) {
        if (!onlyMaterial.empty() && onlyMaterial != named.name)
            continue;
        const auto preset =
            std::find_if(presets.begin(), presets.end(), [&](const MaterialPreset& p) { return p.id == named.preset; });
        if (preset == presets.end()) {
            std::fprintf(stderr, "there is no material %s\n", named.preset);
            return 1;
        }
        Material material = preset->material;
        if (named.poisson > 0)
            material.poissonRatio = named.poisson;
        for (const RealtimeScene& scene : realtimeScenes(material, objects))
            if (onlyScene.empty() || onlyScene == scene.name)
                rows.push_back(play(scene, named.name));
    }
    if (argc > 1)
        std::ofstream(argv[1]) << rows.dump(1) << '\n';
    return 0;
}
