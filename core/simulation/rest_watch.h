#pragma once

#include "core/mechanics/tool_shape.h"
#include "core/mechanics/vector_array.h"

#include <cstdint>
#include <vector>

namespace knead {

/// What a scene was like a while ago, to tell whether anything has moved since. It rests where nothing did, and where nothing that drives
/// it has changed: then steps cost nothing until something does.
struct RestWatch {
    bool isWatching = false;
    double begin = 0;                ///< when that was [s]
    std::vector<VectorArray> places; ///< per body [m]
    std::vector<Pose> wanted;        ///< per tool, where its hand wanted it
    double flowed = 0;               ///< energy that flow had taken [J]
    bool rests = false;
    std::uint64_t count = 0; ///< of rests so far

    /// Something may move now.
    void disturb()
    {
        isWatching = false;
        rests = false;
    }
};

} // namespace knead
