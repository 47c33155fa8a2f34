#pragma once

#include <optional>
#include <string>

namespace knead {

/// Who works on something.
struct Owner {
    std::string host;
    int process = 0;
    double since = 0; ///< [s since 1970]
};

/// A file that one window at a time holds, on this machine or another one. The system lets go of it when the process ends,
/// however it ends: neither its age nor what stands in it decides. In it stands the owner, for others to read.
class FileLock {
public:
    enum class Result {
        held,
        taken,      ///< by another window
        impossible, ///< the folder takes no such file, or the file system no locks
    };

    /// Holds nothing.
    FileLock() = default;
    /// Tries to get hold of a file. @param makes it when it is not there
    explicit FileLock(const std::string& path, bool makes = true);
    /// Lets go of it. The file stays; who holds it may remove it before.
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    Result result() const { return m_result; }
    bool isHeld() const { return m_result == Result::held; }

    /// What stands in the file; empty when that is nothing sensible.
    static std::optional<Owner> ownerIn(const std::string& path);

private:
    void lock();
    bool isAt(const std::string& path) const;
    void writeOwner() const;

    int m_descriptor = -1;
    Result m_result = Result::impossible;
};

} // namespace knead
