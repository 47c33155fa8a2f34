#pragma once

#include "core/task/parallel.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace knead {

/// What each block of forEachBlock() comes to.
template <typename Value, typename OfBlock>
std::vector<Value> ofEachBlock(std::size_t count, std::size_t blockSize, OfBlock&& ofBlock)
{
    std::vector<Value> values((count + blockSize - 1) / blockSize);
    forEachBlock(count, blockSize,
                 [&](std::size_t begin, std::size_t end) { values[begin / blockSize] = ofBlock(begin, end); });
    return values;
}

/// Sum of ofBlock(begin, end), in the order of the blocks: same bits for any number of threads.
template <typename OfBlock>
double sumOverBlocks(std::size_t count, std::size_t blockSize, OfBlock&& ofBlock)
{
    const std::vector<double> sums = ofEachBlock<double>(count, blockSize, ofBlock);
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace knead
