// Knead beside programs that do similar work, in one run on one machine: connection-steps per second, and ratios.
#include "core/simulation/simulation.h"
#include "core/simulation/snapshot.h"
#include "peers/bullet_peer.h"
#include "peers/lammps_peer.h"
#include "support/thread_limit.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

using namespace knead;

namespace {

constexpr int rounds = 5;                     // of everything, in turn; the best of each counts
constexpr double connectionStepsTimed = 30e6; // per round and program

Scene sceneOf(const PeerBar& bar)
{
    Material material;
    material.youngsModulus = 2e5;
    material.poissonRatio = 0.25; // connections alone, as the others have
    Scene scene;
    scene.bodies.push_back({.name = "bar", .aggregate = bar.aggregate, .material = material});
    return scene;
}

/// Whole steps: contacts, connections, motion, checks. The bar flies and turns as that of the others.
double kneadStepTime(const PeerBar& bar, int threads, int steps)
{
    return onThreads(threads, [&] {
        Scene scene = sceneOf(bar);
        const double perStep = 1 / Simulation(scene).timeStep();
        scene.bodies[0].velocity =
            PeerBar::speed * bar.aggregate->lattice.spacing * perStep * Vec3(3, 2, 1).normalized();
        scene.bodies[0].angularVelocity = PeerBar::spin * perStep * bar.aggregate->lattice.axes.col(0);
        Simulation simulation(std::move(scene));
        for (int step = 0; step < 20; ++step)
            simulation.step();
        const auto start = std::chrono::steady_clock::now();
        for (int step = 0; step < steps; ++step)
            simulation.step();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
    });
}

struct Contender {
    std::string name;
    int cores;
    std::function<double(const PeerBar&, int steps)> stepTime;
};

std::vector<Contender> contenders(const std::filesystem::path& folder)
{
    const auto lammps = [&](LammpsWork work, int processes) {
        return [=](const PeerBar& bar, int steps) { return lammpsStepTime(bar, work, processes, steps, folder); };
    };
    std::vector<Contender> all;
    for (const int cores : {1, 2}) {
        all.push_back({"Knead, whole step", cores,
                       [cores](const PeerBar& bar, int steps) { return kneadStepTime(bar, cores, steps); }});
        all.push_back({"LAMMPS, bonds and contacts", cores, lammps(LammpsWork::bondsAndContacts, cores)});
        all.push_back({"LAMMPS, bonds without damping", cores, lammps(LammpsWork::bondsAlone, cores)});
        if (cores == 1)
            all.push_back({"Bullet, soft body links", cores, bulletStepTime});
    }
    return all;
}

/// Prints a table of one bar and returns it.
nlohmann::json compare(const PeerBar& bar, const std::vector<Contender>& all)
{
    const auto connections = static_cast<double>(bar.connections.size());
    const int steps = static_cast<int>(connectionStepsTimed / connections);
    std::vector<double> best(all.size(), std::numeric_limits<double>::infinity());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < all.size(); ++i)
            best[i] = std::min(best[i], all[i].stepTime(bar, steps));
    std::printf("\n%zu objects, %zu connections, best of %d rounds of %d steps\n", bar.places.size(),
                bar.connections.size(), rounds, steps);
    std::printf("%-32s %5s %14s %20s %18s\n", "", "cores", "us per step", "connection-steps/s", "Knead is faster by");
    nlohmann::json rows = nlohmann::json::array();
    double knead = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool own = i == 0 || all[i].cores != all[i - 1].cores;
        knead = own ? best[i] : knead;
        std::printf("%-32s %5d %14.1f %18.1f M %18s\n", all[i].name.c_str(), all[i].cores, 1e6 * best[i],
                    1e-6 * connections / best[i],
                    own ? "" : (std::to_string(best[i] / knead).substr(0, 4) + " x").c_str());
        rows.push_back({{"program", all[i].name},
                        {"cores", all[i].cores},
                        {"step_s", best[i]},
                        {"connection_steps_per_s", connections / best[i]},
                        {"knead_is_faster_by", best[i] / knead}});
    }
    return {{"objects", bar.places.size()}, {"connections", bar.connections.size()}, {"rows", rows}};
}

} // namespace

/// Usage: knead_peers FOLDER
int main(int count, char** arguments)
{
    try {
        const std::filesystem::path out = count > 1 ? arguments[1] : "out/bench";
        const std::filesystem::path folder = out / "peers";
        std::filesystem::create_directories(folder);
        const std::vector<Contender> all = contenders(folder);
        nlohmann::json bars = nlohmann::json::array();
        for (const std::array<int, 3>& objects : {std::array{10, 10, 34}, std::array{15, 30, 60}})
            bars.push_back(compare(makePeerBar(objects), all));
        std::ofstream stream(out / "peers.json");
        stream << nlohmann::json{{"bars", bars}}.dump(2) << "\n";
        if (!stream.flush())
            throw std::runtime_error((out / "peers.json").string() + " could not be written.");
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return EXIT_FAILURE;
    }
}
