#include "core/document/moment_bytes.h"
#include "core/document/moment_content.h"
#include "fuzz/targets.h"
#include "support/scenes_of_every_kind.h"

#include <algorithm>
#include <array>
#include <functional>

namespace knead::fuzz {

namespace {

constexpr std::size_t header = 8 + 4 + 8 + 8 + 8; // mark, version, two sizes, checksum

/// A scene in its middle, to which moments are gone back to.
struct MomentScene {
    explicit MomentScene(const scenes::KindOfScene& kind)
        : bodies(kind.scene.bodies)
        , simulation(kind.scene)
    {
        scenes::runSteps(simulation, kind, 0, kind.steps);
        moment = simulation.keepMoment();
        parts = toolPartsOf(kind.scene, simulation.recording());
    }

    std::vector<Body> bodies;
    Simulation simulation;
    MomentPointer moment;
    ToolParts parts;
};

scenes::KindOfScene pressedAndFilledAnew()
{
    const auto commands = [](int step) -> std::vector<Command> {
        switch (step) {
        case 40:
            return {Refill{0, 2e-3}};
        case 50:
            return {AddFixture{{"hold", 0, {0, 1, 2}}}, SetMaterial{0, scenes::clay(), {3, 4}}};
        default:
            return {};
        }
    };
    return {"filled anew", scenes::smallPress(scenes::soft(), 3), 60, {}, commands};
}

constexpr std::size_t sceneCount = 5;

MomentScene& sceneAt(std::size_t number)
{
    static std::array<std::unique_ptr<MomentScene>, sceneCount> all;
    static const std::array<std::function<scenes::KindOfScene()>, sceneCount> kinds{
        pressedAndFilledAnew, scenes::stickyLumps, scenes::rigidAndGlue, scenes::slitAndPart,
        [] { return scenes::loadedAndTurned(Integrator::implicitEuler); }};
    if (all[number] == nullptr)
        all[number] = std::make_unique<MomentScene>(kinds[number]());
    return *all[number];
}

/// A scene and a version, a byte each, then what is packed in a moment.
std::vector<std::string> moments()
{
    std::vector<std::string> all;
    for (std::size_t number = 0; number < sceneCount; ++number) {
        const Bytes content = momentContent(*sceneAt(number).moment);
        all.push_back({static_cast<char>(number), static_cast<char>(momentVersion)});
        all.back().append(reinterpret_cast<const char*>(content.data()), content.size());
    }
    return all;
}

/// With its header made right: what is wrong with the rest is to be found.
Bytes signedMoment(const MomentScene& scene, std::uint32_t version, std::span<const std::byte> content)
{
    Bytes bytes = momentToBytes(*scene.moment);
    ByteWriter numbers;
    numbers(version);
    numbers(static_cast<std::uint64_t>(content.size()));
    numbers(static_cast<std::uint64_t>(content.size()));
    numbers(momentSum(version, content));
    bytes.resize(header);
    std::ranges::copy(numbers.take(), bytes.begin() + 8);
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
}

/// What is taken can be gone to.
bool readMoment(std::string_view input)
{
    if (input.size() < 2)
        return false;
    MomentScene& scene = sceneAt(static_cast<unsigned char>(input[0]) % sceneCount);
    const Bytes bytes =
        signedMoment(scene, static_cast<unsigned char>(input[1]), std::as_bytes(std::span(input.substr(2))));
    const auto read = [&](const Bytes& all) { return momentFromBytes(all, scene.bodies, scene.parts); };
    return isTaken([&] {
        const Moment moment = read(bytes);
        requireSameBack(
            moment, [](const Moment& one) { return momentToBytes(one); }, read);
        scene.simulation.goTo(std::make_shared<const Moment>(moment));
        scene.simulation.step();
    });
}

} // namespace

Target momentTarget()
{
    return {moments, readMoment};
}

} // namespace knead::fuzz
