#include "io/files/nameless_file.h"

#include "core/message/message.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace knead {

namespace {

constexpr int lowestOwn = 16; // descriptors of the parent are above those of the child

/// @param sentence with a place for why
[[noreturn]] void failAboutFile(const Message& sentence, int error)
{
    throw Problem(sentence.with(std::generic_category().message(error)));
}

int newTemporaryFile()
{
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    if (error)
        throw Problem(Message("File", "There is no folder for temporary files; set TMPDIR to one you may write to."));
    std::string name = (folder / "knead-XXXXXX").string();
    const int descriptor = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0)
        failAboutFile(Message("File", "%1: no temporary file can be made there (%2).").with(folder.string()), errno);
    unlink(name.c_str());
    return descriptor;
}

int newMemoryFile()
{
    const int descriptor = memfd_create("knead", MFD_CLOEXEC);
    if (descriptor < 0)
        failAboutFile(Message("File", "No file can be made in memory (%1)."), errno);
    return descriptor;
}

} // namespace

int aboveThoseOfChildren(int descriptor)
{
    const int result = fcntl(descriptor, F_DUPFD_CLOEXEC, lowestOwn);
    const int error = errno;
    ::close(descriptor);
    if (result < 0)
        failAboutFile(Message("Work", "A pipe to another process cannot be made (%1)."), error);
    return result;
}

NamelessFile::NamelessFile(Place place)
    : m_descriptor(aboveThoseOfChildren(place == Place::folder ? newTemporaryFile() : newMemoryFile()))
{
}

NamelessFile::~NamelessFile()
{
    close(m_descriptor);
}

void NamelessFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(m_descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            failAboutFile(Message("File",
                                  "The folder for temporary files takes no more; make room there, or set TMPDIR to "
                                  "another folder (%1)."),
                          errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::string NamelessFile::content() const
{
    struct stat facts {};
    if (fstat(m_descriptor, &facts) != 0)
        failAboutFile(Message("Work", "What was read cannot be fetched (%1)."), errno);
    std::string bytes(static_cast<std::size_t>(facts.st_size), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = pread(m_descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            failAboutFile(Message("Work", "What was read cannot be fetched (%1)."), errno);
        if (count == 0)
            break;
        done += static_cast<std::size_t>(count);
    }
    bytes.resize(done);
    return bytes;
}

} // namespace knead
