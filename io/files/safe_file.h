#pragma once

#include "core/message/message.h"
#include "io/files/byte_sink.h"

#include <string>
#include <string_view>

namespace knead {

/// A file that appears whole or not at all: written piece by piece under a temporary name in the same folder, and renamed by
/// keep(). Until then, and when it is not kept, what lay at the path stays as it was and nothing else is left behind, but by a
/// process that is killed: see removeLeftOvers() and removeUnfinished(). A file that was there gives its permissions to the new one.
/// All functions throw a Problem that names the file and why the disk refused.
class SafeFile final : public ByteSink {
public:
    explicit SafeFile(const std::string& path);
    ~SafeFile() override;
    SafeFile(const SafeFile&) = delete;
    SafeFile& operator=(const SafeFile&) = delete;

    void write(std::string_view bytes) override;

    /// For libraries that write files by their names; nothing else must be written then.
    const std::string& pathForNow() const { return m_path; }

    /// @throws Problem as when the disk refuses. @param reason in a few words
    [[noreturn]] void fail(const Message& reason) const;

    /// Makes sure that the disk has all of it: what can fail for want of room has not failed after this. For files that
    /// belong together: all are finished before the first is kept.
    void finish();

    /// Finishes the file and puts it in its place.
    void keep();

private:
    [[noreturn]] void fail() const;
    void dropNote();

    std::string m_target;
    std::string m_path;    ///< for now; empty when kept
    std::string m_note;    ///< that it is not finished; empty when there is none
    int m_descriptor = -1; ///< negative when kept
};

/// Removes what processes that were killed had begun to write in the folder of a path; what others are writing stays.
void removeLeftOvers(const std::string& path);

/// Removes what processes of the same person that were killed had begun to write, in whatever folder; what others are writing stays.
/// For the start of the program. What is being written is noted in the folder of its state ($XDG_STATE_HOME/knead/unfinished), where
/// that can be made. Any thread.
void removeUnfinished();

/// Makes sure that the disk has the names in a folder, as far as its file system can.
void syncFolder(const std::string& folder);

/// Writes a file whole or not at all, as SafeFile does.
/// @throws Problem that names the file and why the disk refused; nothing is left behind.
void writeFileSafely(const std::string& path, std::string_view bytes);

/// Whether writeFileSafely() could begin there now; leaves nothing behind.
/// @throws Problem, as that would
void checkIsWritable(const std::string& path);

} // namespace knead
