#include "app/version_text.h"

#include "app/cad_program.h"
#include "io/library_versions.h"
#include "io/worker/confinement.h"

#include <filesystem>

namespace knead {

namespace {

std::string readerLine()
{
    const std::string reader = cadProgramBeside(std::filesystem::read_symlink("/proc/self/exe").string());
    std::error_code ignored;
    return "Reader of files: " + reader +
           (std::filesystem::exists(reader, ignored) ? "" : ", which is missing: files cannot be opened; install it");
}

std::string filesLine(const Confinement& here)
{
    if (here.landlock == 0)
        return "Landlock: this kernel has none (Linux 5.13), or it is switched off: the reader can read other files of "
               "yours than the one that is opened";
    return "Landlock: version " + std::to_string(here.landlock) +
           ": the reader reads the file that is opened, those beside it where it may name some, and nothing else of "
           "yours";
}

std::string callsLine(const Confinement& here)
{
    if (!here.filtersCalls)
        return "seccomp: this kernel, or Knead on this kind of machine, has no filter of system calls: the reader can "
               "write files, open sockets and start programs";
    return "seccomp: yes: the reader writes no files, opens no sockets and starts no programs";
}

} // namespace

std::string versionText()
{
    return std::string("knead ") + KNEAD_VERSION;
}

std::string verboseVersionText()
{
    std::string text = versionText() + "\n";
    for (const LibraryVersion& library : libraryVersions())
        text += library.name + " " + library.version + ", " + library.license + "\n";
    const Confinement here = confinementHere();
    return text + readerLine() + "\n" + filesLine(here) + "\n" + callsLine(here);
}

} // namespace knead
