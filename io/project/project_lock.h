#pragma once

#include "io/project/file_lock.h"

#include <string>

namespace knead {

/// Keeps two windows from working on one project file: while it lives, others that ask are refused. The lock is on the file
/// ".NAME.lock" beside the project, since the project itself is replaced at each save; it goes with the process.
class ProjectLock {
public:
    /// @throws Problem that says who works on it (host, process, since when) and what to do
    explicit ProjectLock(const std::string& path);
    ~ProjectLock();
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;

    /// False where no lock can be had, as on a disk that is read-only: then nobody is kept from anything.
    bool isHeld() const { return m_lock.isHeld(); }

private:
    std::string m_file;
    FileLock m_lock;
};

} // namespace knead
