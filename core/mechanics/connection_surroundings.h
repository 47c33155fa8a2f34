#pragma once

#include "core/kernels/kernels.h"
#include "core/mechanics/connection_data.h"
#include "core/task/parallel.h"

namespace knead {

/// Calls run(part) for the parts of runs that lie in begin .. end.
template <typename Run>
void forEachRun(const std::vector<LatticeRun>& runs, std::size_t begin, std::size_t end, Run run)
{
    auto next = std::partition_point(runs.begin(), runs.end(), [&](const LatticeRun& r) { return r.end <= begin; });
    for (; next != runs.end() && next->begin < end; ++next)
        run(*next, std::max<std::size_t>(next->begin, begin), std::min<std::size_t>(next->end, end));
}

/// Calls run() for the runs of objects whose stress is found together, on several threads.
template <typename Run>
void forEachSurroundings(const ConnectionData& data, const VectorArray& position, Run&& run)
{
    const auto stiffness = pointersTo<const double*>(data.stiffness);
    const auto inverseShape = pointersTo<const double*>(data.inverseShape);
    forEachBlock(position.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        forEachRun(data.stressRuns, begin, end, [&](const LatticeRun& part, std::size_t first, std::size_t last) {
            run(kernels::Surroundings{.begin = first,
                                      .end = last,
                                      .position = position.data(),
                                      .stride = static_cast<std::ptrdiff_t>(position.stride()),
                                      .forward = part.forward,
                                      .backward = part.backward,
                                      .ahead = part.ahead.data(),
                                      .behind = part.behind.data(),
                                      .hasBehind = data.hasBehind.data(),
                                      .stiffness = stiffness.data(),
                                      .inverseShape = inverseShape.data(),
                                      .restDilatation = data.changes.restDilatation.data(),
                                      .spacing = data.aggregate->lattice.spacing});
        });
    });
}

} // namespace knead
