#include "app/resources.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

namespace {

std::string& chosenProgramOfResources()
{
    static std::string path;
    return path;
}

fs::path programOfResources()
{
    std::error_code ignored;
    return chosenProgramOfResources().empty() ? fs::read_symlink("/proc/self/exe", ignored)
                                              : fs::path(chosenProgramOfResources());
}

} // namespace

std::string resourcesFolder()
{
    if (const char* chosen = std::getenv("KNEAD_RESOURCES"))
        return chosen;
    std::error_code ignored;
    const fs::path program = programOfResources();
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        if (fs::is_directory(folder / KNEAD_DATA_FOLDER / "materials", ignored))
            return (folder / KNEAD_DATA_FOLDER).string();
    throw std::runtime_error("The folder " KNEAD_DATA_FOLDER " with examples and materials is missing: it is in no "
                             "folder above " +
                             program.string() + ". Install Knead anew, or set KNEAD_RESOURCES to where it is.");
}

void setProgramWithResources(const std::string& path)
{
    chosenProgramOfResources() = path;
}

std::string materialsFile()
{
    return resourcesFolder() + "/materials/materials.json";
}

} // namespace knead
