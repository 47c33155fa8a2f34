#include "app/resources.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

std::string resourcesFolder()
{
    if (const char* chosen = std::getenv("KNEAD_RESOURCES"))
        return chosen;
    std::error_code ignored;
    const fs::path installed = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "../share/knead";
    for (const fs::path& folder : {installed, fs::path(KNEAD_SOURCE_RESOURCES)})
        if (fs::is_directory(folder / "materials", ignored))
            return fs::weakly_canonical(folder).string();
    throw std::runtime_error("The resources folder is missing: neither " + installed.string() + " nor " +
                             KNEAD_SOURCE_RESOURCES + " exists. Set KNEAD_RESOURCES to the folder named resources.");
}

std::string materialsFile()
{
    return resourcesFolder() + "/materials/materials.json";
}

} // namespace knead
