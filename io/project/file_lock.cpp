#include "io/project/file_lock.h"

#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace knead {

namespace {

std::string hostName()
{
    char name[256] = {};
    return gethostname(name, sizeof name - 1) == 0 ? name : "this machine";
}

} // namespace

FileLock::FileLock(const std::string& path, bool makes)
{
    do {
        if (m_descriptor >= 0)
            close(m_descriptor);
        m_result = Result::impossible;
        m_descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | (makes ? O_CREAT : 0), 0644);
        if (m_descriptor >= 0)
            lock();
    } while (isHeld() && !isAt(path)); // whoever had it before took it away meanwhile
    if (isHeld())
        writeOwner();
}

FileLock::~FileLock()
{
    if (m_descriptor >= 0)
        close(m_descriptor);
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_result(std::exchange(other.m_result, Result::impossible))
{
}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    std::swap(m_result, other.m_result);
    return *this;
}

bool FileLock::isAt(const std::string& path) const
{
    struct stat own {};
    struct stat there {};
    return fstat(m_descriptor, &own) == 0 && stat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
           own.st_dev == there.st_dev;
}

/// flock, not fcntl: its locks belong to the open file, so that two windows of one process are told apart, and closing the
/// file elsewhere in the process does not lose them.
void FileLock::lock()
{
    int failed = flock(m_descriptor, LOCK_EX | LOCK_NB);
    while (failed != 0 && errno == EINTR)
        failed = flock(m_descriptor, LOCK_EX | LOCK_NB);
    if (failed == 0)
        m_result = Result::held;
    else if (errno == EWOULDBLOCK)
        m_result = Result::taken;
}

/// For people only, so nothing depends on its success.
void FileLock::writeOwner() const
{
    const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
    std::ostringstream text;
    text.precision(15);
    text << getpid() << ' ' << now.count() << ' ' << hostName() << '\n';
    if (ftruncate(m_descriptor, 0) == 0) {
        const std::string line = text.str();
        [[maybe_unused]] const auto written = pwrite(m_descriptor, line.data(), line.size(), 0);
    }
}

std::optional<Owner> FileLock::ownerIn(const std::string& path)
{
    std::ifstream file(path);
    Owner owner;
    file >> owner.process >> owner.since >> owner.host;
    return file && owner.process > 0 ? std::optional(owner) : std::nullopt;
}

} // namespace knead
