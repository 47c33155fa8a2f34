#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/python/bindings.h"
#include "app/resources.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <dlfcn.h>

namespace knead::python {

namespace fs = std::filesystem;

namespace {

/// The file of this module.
fs::path ownPath()
{
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&findOwnFiles), &info) == 0 || info.dli_fname == nullptr)
        return {};
    std::error_code ignored;
    return fs::weakly_canonical(info.dli_fname, ignored);
}

/// The program knead: $KNEAD_PROGRAM, else the one in bin of a folder above, as installed, or in app, as built.
std::string knead()
{
    if (const char* chosen = std::getenv("KNEAD_PROGRAM"))
        return chosen;
    std::error_code ignored;
    for (fs::path folder = ownPath().parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        for (const char* place : {"bin/knead", "app/knead"})
            if (fs::is_regular_file(folder / place, ignored))
                return (folder / place).string();
    return {};
}

} // namespace

void findOwnFiles()
{
    const std::string program = knead();
    if (program.empty())
        return; // files cannot be read; who tries is told so
    setProgramWithResources(program);
    setCadProgram(cadProgramBeside(program));
}

} // namespace knead::python
