#pragma once

#include <cstdint>

namespace knead {

/// What a frame of the implicit scheme may leave out, so that a scene keeps up with real time: accuracy goes first, then steps. Part of
/// what is simulated, and so recorded: whoever repeats a run must change it at the same steps. Moments
/// keep the numbers.
enum class Pace : std::uint8_t {
    full = 0,  ///< a step per frame of 1/60 s
    rough = 1, ///< the same, solved less well
    wide = 2,  ///< and a step per two frames
    exact = 3, ///< a step per frame, solved as well as makes sense: to compare with
};

struct PaceNumbers {
    double longestStep = 0;  ///< of the implicit scheme [s]
    double tolerance = 0;    ///< share of what acts in a step that it may lack
    double whereItFlows = 0; ///< the same where material yields: what is lacking there is pressed out of shape for good
};

/// With rough ones, forces of tools are off by up to 3 % of the largest, and places by 1 % of the largest way; with full ones, by 1 %
/// and .2 %. Steps of two frames smooth what comes and goes within them, and damp what swings.
constexpr PaceNumbers numbersOf(Pace pace)
{
    constexpr double frame = 1.0 / 60;
    switch (pace) {
    case Pace::rough:
        return {.longestStep = frame, .tolerance = 0.1, .whereItFlows = 0.04};
    case Pace::wide:
        return {.longestStep = 2 * frame, .tolerance = 0.1, .whereItFlows = 0.04};
    case Pace::exact:
        return {.longestStep = frame, .tolerance = 1e-3, .whereItFlows = 1e-3};
    case Pace::full:
        break;
    }
    return {.longestStep = frame, .tolerance = 0.02, .whereItFlows = 0.02};
}

} // namespace knead
