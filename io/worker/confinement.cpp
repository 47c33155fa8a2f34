#include "io/worker/confinement.h"

#include "io/worker/call_filter.h"
#include "io/worker/child_process.h"
#include "io/worker/file_rules.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <link.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// What the C library and TBB ask of the machine and of the process itself.
constexpr const char* ownFiles[] = {"/etc/ld.so.cache",    "/dev/null",      "/dev/urandom",  "/proc/self",
                                    "/proc/meminfo",       "/proc/stat",     "/proc/cpuinfo", "/proc/sys/vm",
                                    "/sys/devices/system", "/sys/kernel/mm", "/sys/fs/cgroup"};

/// Of variables for OpenCASCADE that name files or folders.
constexpr std::string_view resourceVariables[] = {"CSF_", "CASROOT="};

constexpr std::string_view knownVariables[] = {
    "LD_LIBRARY_PATH=", "MMGT_", "TBB_", "ASAN_OPTIONS=", "LSAN_OPTIONS=", "TSAN_OPTIONS=", "UBSAN_OPTIONS=", "KNEAD_"};

template <std::size_t Count>
bool beginsAsOneOf(std::string_view variable, const std::string_view (&names)[Count])
{
    return std::any_of(std::begin(names), std::end(names),
                       [&](std::string_view name) { return variable.starts_with(name); });
}

int addFolderOfLibrary(dl_phdr_info* library, std::size_t, void* folders)
{
    const fs::path path = library->dlpi_name;
    if (path.is_absolute())
        static_cast<std::vector<std::string>*>(folders)->push_back(path.parent_path().string());
    return 0;
}

void addResources(std::vector<std::string>& readable)
{
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (const std::string_view text = *variable; beginsAsOneOf(text, resourceVariables))
            readable.emplace_back(text.substr(std::min(text.find('=') + 1, text.size())));
}

std::vector<std::string> withOwnNeeds(std::vector<std::string> readable)
{
    readable.insert(readable.end(), std::begin(ownFiles), std::end(ownFiles));
    dl_iterate_phdr(addFolderOfLibrary, &readable);
    addResources(readable);
    std::sort(readable.begin(), readable.end());
    readable.erase(std::unique(readable.begin(), readable.end()), readable.end());
    return readable;
}

} // namespace

Confinement confinementHere()
{
    return {landlockVersion(), canFilterCalls()};
}

void confineOwnProcess(const std::vector<std::string>& readable)
{
    close_range(child_descriptors::result + 1, ~0U, 0);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    restrictFiles(withOwnNeeds(readable));
    filterCalls();
}

std::vector<std::string> readableFor(const std::string& path, bool namesOthers)
{
    if (!namesOthers)
        return {path};
    return {path, std::filesystem::absolute(path).parent_path().string()};
}

std::vector<std::string> environmentForConfined()
{
    std::vector<std::string> known;
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (beginsAsOneOf(*variable, knownVariables) || beginsAsOneOf(*variable, resourceVariables))
            known.emplace_back(*variable);
    return known;
}

} // namespace knead
