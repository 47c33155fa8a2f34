#include "io/files/own_folders.h"

#include <array>
#include <cstdlib>
#include <filesystem>

#include <pwd.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

bool isAbsolute(const char* path)
{
    return path != nullptr && fs::path(path).is_absolute();
}

fs::path homeFolder()
{
    if (const char* home = std::getenv("HOME"); isAbsolute(home))
        return home;
    passwd entry{};
    passwd* found = nullptr;
    std::array<char, 4096> texts{};
    if (getpwuid_r(getuid(), &entry, texts.data(), texts.size(), &found) == 0 && found != nullptr &&
        isAbsolute(found->pw_dir))
        return found->pw_dir;
    return "/nonexistent"; // as the system itself says of those who have none
}

} // namespace

std::string ownFolder(const char* variable, const std::string& belowHome)
{
    const char* chosen = std::getenv(variable);
    return (isAbsolute(chosen) ? fs::path(chosen) : homeFolder() / belowHome).string();
}

} // namespace knead
