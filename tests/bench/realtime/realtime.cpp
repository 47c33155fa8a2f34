// Frames under a recorded hand, as a person would see them: how long each takes, in milliseconds and in evaluations of all forces of
// the same body, measured between frames of the same run, which the noise of a machine cannot bend.
#include "core/mechanics/structural_connections.h"
#include "core/simulation/simulation.h"
#include "core/task/kept_memory.h"
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

/// What a hand felt and made.
struct Played {
    std::vector<double> times; ///< of frames [ms]
    std::vector<Vec3> forces;  ///< at the ends of frames, of the hand's tool [N]
    double iterations = 0;     ///< of conjugate gradients
    double steps = 0;
    double mostForce = 0;  ///< [N]
    double largestWay = 0; ///< of any object in the end [m]
    std::vector<Vec3> places;
    std::string trouble;
};

/// @param unit measured between the frames; null: it is not
Played playAt(Pace pace, const RealtimeScene& scene, Unit* unit)
{
    Simulation simulation{Scene(scene.scene)};
    simulation.post(SetPace{pace});
    const Pose start = scene.depth > 0 ? scene.scene.manipulators[0].pose : Pose{};
    Played played;
    const auto frames = static_cast<int>(handSeconds / frame + 0.5);
    for (int n = 0; n < frames && played.trouble.empty(); ++n) {
        if (unit != nullptr && n % framesPerUnit == 0)
            unit->measure();
        const double end = frame * (n + 1);
        const Clock::time_point begin = Clock::now();
        if (scene.depth > 0) {
            Pose wanted = start;
            wanted.position += handAt(scene, end);
            simulation.post(SetManipulatorMotion{0, GoTo{wanted}});
        }
        SnapshotPointer shot;
        while (simulation.time() < end - 1e-9 && played.trouble.empty()) {
            simulation.step();
            shot = simulation.snapshot();
            played.iterations += shot->solverIterations;
            ++played.steps;
            if (!shot->tools.empty())
                played.mostForce = std::max(played.mostForce, shot->tools[0].force.norm());
            if (!shot->health.ok)
                played.trouble = shot->health.message.english();
        }
        played.times.push_back(millisecondsSince(begin));
        if (shot && !shot->tools.empty())
            played.forces.push_back(shot->tools[0].force);
    }
    const auto last = simulation.snapshot();
    for (std::size_t b = 0; b < last->bodies.size(); ++b)
        for (ObjectIndex i = 0; i < last->bodies[b].positions.size(); ++i) {
            played.places.push_back(last->bodies[b].positions[i]);
            played.largestWay = std::max(played.largestWay, last->bodies[b].displacement(i).norm());
        }
    return played;
}

/// The 95th percentile of how far the forces are from those of a tight solve, by the largest; 0 without any.
double forceError(const Played& played, const Played& tight)
{
    std::vector<double> errors;
    for (std::size_t n = 0; n < std::min(played.forces.size(), tight.forces.size()); ++n)
        errors.push_back((played.forces[n] - tight.forces[n]).norm());
    return errors.empty() || tight.mostForce == 0 ? 0 : share(errors, 0.95) / tight.mostForce;
}

/// How far any place in the end is from that of a tight solve, by the largest way.
double placeError(const Played& played, const Played& tight)
{
    double most = 0;
    for (std::size_t i = 0; i < std::min(played.places.size(), tight.places.size()); ++i)
        most = std::max(most, (played.places[i] - tight.places[i]).norm());
    return tight.largestWay > 0 ? most / tight.largestWay : 0;
}

nlohmann::json play(const RealtimeScene& scene, const char* material, bool compares)
{
    Unit unit(scene.scene);
    const Played played = playAt(Pace::full, scene, &unit);
    const Played tight = compares ? playAt(Pace::exact, scene, nullptr) : Played{};
    const std::vector<double>& times = played.times;
    const double milliseconds = std::accumulate(times.begin(), times.end(), 0.0);
    const double counted = static_cast<double>(times.size());
    std::size_t objects = 0;
    for (const knead::Body& body : scene.scene.bodies)
        objects += body.aggregate->size();
    nlohmann::json row{{"scene", scene.name},
                       {"material", material},
                       {"objects", objects},
                       {"unit_ms", unit.median()},
                       {"median_ms", share(times, 0.5)},
                       {"p95_ms", share(times, 0.95)},
                       {"p99_ms", share(times, 0.99)},
                       {"median_units", share(times, 0.5) / unit.median()},
                       {"p95_units", share(times, 0.95) / unit.median()},
                       {"ratio", 1e3 * frame * counted / milliseconds},
                       {"iterations_per_frame", played.iterations / counted},
                       {"steps_per_frame", played.steps / counted},
                       {"most_force_n", played.mostForce},
                       {"force_limit_n", scene.depth > 0 ? scene.scene.manipulators[0].forceLimit : 0},
                       {"stopped", played.trouble}};
    if (compares) {
        row["force_error"] = forceError(played, tight);
        row["place_error"] = placeError(played, tight);
    }
    std::printf("%-11s %-16s %6zu  %5.2f  %7.1f %7.1f %7.1f  %6.0f %6.0f  %5.2f  %6.1f %5.2f  %6.2f %6.2f%s\n",
                scene.name.c_str(), material, objects, unit.median(), share(times, 0.5), share(times, 0.95),
                share(times, 0.99), share(times, 0.5) / unit.median(), share(times, 0.95) / unit.median(),
                1e3 * frame * counted / milliseconds, played.iterations / counted, played.steps / counted,
                100 * forceError(played, tight), 100 * placeError(played, tight),
                played.trouble.empty() ? "" : "  stopped");
    std::fflush(stdout);
    return row;
}

} // namespace

/// knead_realtime OUT.json [OBJECTS] [MATERIAL] [SCENE] [tight]
int main(int argc, char** argv)
{
    keepFreedMemory();
    const double objects = argc > 2 ? std::atof(argv[2]) : 27'000;
    const std::string onlyMaterial = argc > 3 ? argv[3] : "";
    const std::string onlyScene = argc > 4 ? argv[4] : "";
    const bool compares = argc > 5 && argv[5] == std::string("tight");
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
        "steps   force places\n                                        ms       ms       ms      ms    units  units"
        "                         %% off  %% off\n");
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
                rows.push_back(play(scene, named.name, compares));
    }
    if (argc > 1)
        std::ofstream(argv[1]) << rows.dump(1) << '\n';
    return 0;
}
