#include "core/task/parallel.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace knead {

void forEachBlock(std::size_t count, std::size_t blockSize,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    const std::size_t blocks = (count + blockSize - 1) / blockSize;
    const auto runBlock = [&](std::size_t block) { body(block * blockSize, std::min(count, (block + 1) * blockSize)); };
    if (blocks <= 2) {
        for (std::size_t block = 0; block < blocks; ++block)
            runBlock(block);
        return;
    }
    tbb::parallel_for(std::size_t{0}, blocks, runBlock);
}

} // namespace knead
