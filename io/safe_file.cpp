#include "io/safe_file.h"

#include "io/cad_format.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// Short, since the name of the target may be as long as the file system allows.
std::string nameBeside(const std::string& target)
{
    static std::atomic<unsigned> counter = 0;
    const std::string name = ".knead-" + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".part";
    return (fs::path(target).parent_path() / name).string();
}

} // namespace

SafeFile::SafeFile(const std::string& path)
    : m_target(path)
    , m_path(nameBeside(path))
    , m_descriptor(open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666))
{
    if (m_descriptor < 0)
        fail();
}

SafeFile::~SafeFile()
{
    if (m_descriptor >= 0)
        close(m_descriptor);
    if (!m_path.empty())
        unlink(m_path.c_str());
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
    if (m_descriptor < 0)
        return;
    if (fsync(m_descriptor) != 0 && errno != EINVAL && errno != EROFS) // some file systems have no fsync
        fail();
    const int closed = close(m_descriptor);
    m_descriptor = -1;
    if (closed != 0)
        fail();
}

void SafeFile::keep()
{
    finish();
    if (std::rename(m_path.c_str(), m_target.c_str()) != 0)
        fail();
    m_path.clear();
}

void SafeFile::fail() const
{
    const std::string reason = std::strerror(errno);
    throw std::runtime_error(shortName(m_target) + ": the file cannot be written (" + reason +
                             "); choose another place or make room.");
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
