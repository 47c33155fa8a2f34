#include "app/cad_program.h"

#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

std::string cadProgramBeside(const std::string& program)
{
    constexpr const char* name = "knead-cad-worker";
    const fs::path folder = fs::path(program).parent_path();
    const fs::path installed = folder / "../libexec/knead" / name;
    std::error_code ignored;
    const bool isInstalled = !fs::exists(folder / name, ignored) && fs::exists(installed, ignored);
    return isInstalled ? installed.lexically_normal().string() : (folder / name).string();
}

std::string ownCadProgram()
{
    static const std::string path = cadProgramBeside(fs::read_symlink("/proc/self/exe").string());
    static const int opened = open(path.c_str(), O_PATH | O_CLOEXEC);
    // Started by this name it is the file that was opened, whatever lies at the path since.
    return opened < 0 ? path : "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(opened);
}

} // namespace knead
