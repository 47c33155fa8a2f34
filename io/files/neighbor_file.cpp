#include "io/files/neighbor_file.h"

#include <algorithm>
#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

bool isNeighborFile(const std::string& file, const std::string& path)
{
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error || !fs::is_regular_file(real, error))
        return false;
    const fs::path folder = fs::canonical(fs::absolute(path).parent_path(), error);
    return !error && std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

} // namespace knead
