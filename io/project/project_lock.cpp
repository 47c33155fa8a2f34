#include "io/project/project_lock.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"

#include <ctime>
#include <filesystem>

#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// However the project is called: by links, or from another folder.
std::string lockFileOf(const std::string& path)
{
    std::error_code error;
    fs::path project = fs::weakly_canonical(path, error);
    if (error)
        project = path;
    fs::path name = ".";
    name += project.filename();
    name += ".lock";
    return (project.parent_path() / name).string();
}

std::string timeWords(double time)
{
    const auto seconds = static_cast<std::time_t>(time);
    std::tm parts{};
    char text[32] = {};
    localtime_r(&seconds, &parts);
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
    return text;
}

Message sentenceAbout(const std::optional<Owner>& owner)
{
    if (!owner)
        return Message("Project", "another window works on it. Close it there, or open a copy.");
    if (owner->process == getpid())
        return Message("Project", "another window of this program works on it. Close it there, or open a copy.");
    return Message("Project",
                   "another window works on it (process %1 on %2, since %3). Close it there, or open a copy.")
        .with(owner->process, owner->host, timeWords(owner->since));
}

} // namespace

ProjectLock::ProjectLock(const std::string& path)
    : m_file(lockFileOf(path))
    , m_lock(m_file)
{
    if (m_lock.result() == FileLock::Result::taken)
        failReading(path, sentenceAbout(FileLock::ownerIn(m_file)));
}

ProjectLock::~ProjectLock()
{
    if (m_lock.isHeld())
        unlink(m_file.c_str());
}

} // namespace knead
