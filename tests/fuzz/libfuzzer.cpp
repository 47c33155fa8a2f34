// One target as a program of libFuzzer. KNEAD_FUZZ_SEEDS names a folder that gets its seeds first.
#include "fuzz/targets.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

const knead::fuzz::Target& target()
{
    static const knead::fuzz::Target one = knead::fuzz::KNEAD_FUZZ_TARGET();
    return one;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/)
{
    const char* folder = std::getenv("KNEAD_FUZZ_SEEDS");
    if (folder == nullptr)
        return 0;
    std::filesystem::create_directories(folder);
    const std::vector<std::string> seeds = target().seeds();
    for (std::size_t i = 0; i < seeds.size(); ++i)
        std::ofstream(std::filesystem::path(folder) / ("seed-" + std::to_string(i)), std::ios::binary) << seeds[i];
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    target().read({reinterpret_cast<const char*>(data), size});
    return 0;
}
