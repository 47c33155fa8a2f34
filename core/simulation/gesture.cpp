#include "core/simulation/gesture.h"

#include <algorithm>
#include <utility>

namespace knead {

std::uint32_t resetsIn(const std::vector<RecordedCommand>& commands)
{
    return static_cast<std::uint32_t>(std::count_if(commands.begin(), commands.end(), [](const auto& recorded) {
        return std::holds_alternative<Reset>(recorded.command);
    }));
}

std::vector<RecordedCommand> commandsBefore(const std::vector<RecordedCommand>& commands, std::uint32_t run,
                                            std::uint64_t step)
{
    std::uint32_t passed = 0;
    auto end = commands.begin();
    for (; end != commands.end() && (passed < run || (passed == run && end->step < step)); ++end)
        if (std::holds_alternative<Reset>(end->command))
            ++passed;
    return {commands.begin(), end};
}

Gesture endGesture(Simulation& simulation)
{
    MomentPointer moment = simulation.keepMoment();
    return {.commands = simulation.takeRecording(), .moment = std::move(moment), .hash = simulation.stateHash()};
}

} // namespace knead
