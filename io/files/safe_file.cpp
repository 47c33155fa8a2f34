#include "io/files/safe_file.h"

#include "core/message/message.h"
#include "io/files/own_folders.h"
#include "io/formats/cad_format.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr const char* beginning = ".knead-";
constexpr const char* endingOfParts = ".part";

/// Short, since the name of the target may be as long as the file system allows.
std::string nameBeside(const std::string& target)
{
    static std::atomic<unsigned> counter = 0;
    const std::string name = beginning + std::to_string(getpid()) + "-" + std::to_string(counter++) + endingOfParts;
    return (fs::path(target).parent_path() / name).string();
}

/// Marks a file as one that somebody is writing, for removeLeftOvers(). @return false when it was removed just before
bool markAsOurs(int descriptor)
{
    flock(descriptor, LOCK_EX | LOCK_NB); // without locks nobody takes it for left over either
    struct stat status {};
    return fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

std::string folderOfNotes()
{
    return ownFolder("XDG_STATE_HOME", ".local/state") + "/knead/unfinished";
}

/// A link to a file that is not finished. @return its path; empty when it cannot be made
std::string noteOf(const std::string& path)
{
    std::error_code error;
    const fs::path folder = folderOfNotes();
    const fs::path note = folder / fs::path(path).filename();
    const fs::path target = fs::absolute(path, error);
    fs::create_symlink(target, note, error);
    if (error == std::errc::no_such_file_or_directory) {
        fs::create_directories(folder, error);
        fs::create_symlink(target, note, error);
    }
    return error ? std::string() : note.string();
}

/// Removes a file that nobody is writing, if it is called like those that are not finished.
/// @return whether nobody is writing it
bool removeIfLeftOver(const fs::path& path)
{
    const std::string name = path.filename().string();
    if (!name.starts_with(beginning) || !name.ends_with(endingOfParts))
        return true;
    const int descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return true;
    const bool isLeftOver = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    if (isLeftOver)
        unlink(path.c_str());
    close(descriptor);
    return isLeftOver;
}

void copyPermissions(const std::string& from, int to)
{
    struct stat status {};
    if (stat(from.c_str(), &status) == 0)
        fchmod(to, status.st_mode & 0777U);
}

} // namespace

SafeFile::SafeFile(const std::string& path)
    : m_target(path)
{
    do {
        if (m_descriptor >= 0)
            close(m_descriptor);
        m_path = nameBeside(path);
        m_descriptor = open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (m_descriptor < 0)
            fail();
    } while (!markAsOurs(m_descriptor));
    m_note = noteOf(m_path);
    copyPermissions(m_target, m_descriptor);
}

SafeFile::~SafeFile()
{
    if (m_descriptor >= 0)
        close(m_descriptor);
    if (!m_path.empty())
        unlink(m_path.c_str());
    dropNote();
}

void SafeFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail();
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void SafeFile::finish()
{
    if (fsync(m_descriptor) != 0 && errno != EINVAL && errno != EROFS) // some file systems have no fsync
        fail();
    const int other =
        dup(m_descriptor); // some disks refuse only at a close; the file stays marked as ours until keep()
    if (other >= 0 && close(other) != 0)
        fail();
}

void SafeFile::keep()
{
    finish();
    if (std::rename(m_path.c_str(), m_target.c_str()) != 0)
        fail();
    m_path.clear();
    dropNote();
    close(std::exchange(m_descriptor, -1));
    syncFolder(fs::path(m_target).parent_path().string());
}

void SafeFile::dropNote()
{
    if (!m_note.empty())
        unlink(m_note.c_str());
    m_note.clear();
}

void SafeFile::fail() const
{
    fail(Message::verbatim(std::strerror(errno)));
}

void SafeFile::fail(const Message& reason) const
{
    failReading(m_target,
                Message("File", "the file cannot be written (%1); choose another place or make room.").with(reason));
}

void removeLeftOvers(const std::string& path)
{
    const fs::path parent = fs::path(path).parent_path();
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(parent.empty() ? "." : parent, error))
        removeIfLeftOver(entry.path());
}

void removeUnfinished()
{
    std::error_code error;
    for (const fs::directory_entry& note : fs::directory_iterator(folderOfNotes(), error))
        if (note.is_symlink(error) && removeIfLeftOver(fs::read_symlink(note.path(), error)))
            fs::remove(note.path(), error);
}

/// So that a power failure does not bring back what lay there before.
void syncFolder(const std::string& folder)
{
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    fsync(descriptor);
    close(descriptor);
}

void writeFileSafely(const std::string& path, std::string_view bytes)
{
    SafeFile file(path);
    file.write(bytes);
    file.keep();
}

void checkIsWritable(const std::string& path)
{
    const SafeFile file(path);
}

} // namespace knead
