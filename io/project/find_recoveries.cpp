#include "core/message/message.h"
#include "io/files/own_folders.h"
#include "io/project/recovery.h"
#include "io/project/recovery_files.h"
#include "io/project/rows.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// What its tables say; none when nothing in it would be lost.
std::optional<Recovery> summaryOf(const std::string& folder)
{
    Recovery recovery{.folder = folder};
    std::error_code error;
    if (!fs::exists(recovery_files::database(folder), error))
        return std::nullopt;
    try {
        const auto database = recovery_files::open(folder);
        if (!database->tableExists("session"))
            return std::nullopt;
        const Row session = rowAt(*database, "session", 0);
        recovery.projectFile = session.text(1);
        if (session.integer(2) != 0)
            return std::nullopt;
        SQLite::Statement entries(*database, "SELECT count(*), max(made_at_unix_s) FROM entries");
        if (entries.executeStep()) {
            recovery.entries = entries.getColumn(0).getUInt();
            recovery.lastChange = entries.getColumn(1).getDouble();
        }
        SQLite::Statement parts(*database, "SELECT name FROM parts ORDER BY id LIMIT 1");
        if (parts.executeStep())
            recovery.part = parts.getColumn(0).getString();
    } catch (const std::runtime_error&) {
        // It is listed with what is known of it: perhaps it can be rescued.
    }
    return recovery;
}

/// None when a window works on it. Another window that looks at the same time holds its lock only while it does.
std::optional<Recovery> recoveryIn(const std::string& folder)
{
    const FileLock lock = recovery_files::patientLock(folder, std::chrono::milliseconds(200));
    std::error_code error;
    const bool hasLock = fs::exists(recovery_files::lock(folder), error);
    if (hasLock && !lock.isHeld())
        return std::nullopt;
    std::optional<Recovery> recovery = hasLock ? summaryOf(folder) : std::nullopt;
    if (!recovery)
        recovery_files::remove(folder);
    return recovery;
}

/// What a window that was killed had just begun to make. @return whether it is that
bool removedHalfMade(const fs::directory_entry& entry)
{
    constexpr auto patience = std::chrono::minutes(1); // it takes a window milliseconds
    std::error_code error;
    if (!entry.path().filename().string().starts_with("new-"))
        return false;
    const auto changed = entry.last_write_time(error);
    const FileLock lock(recovery_files::lock(entry.path().string()), false);
    if (!error && fs::file_time_type::clock::now() - changed > patience && lock.result() != FileLock::Result::taken)
        recovery_files::remove(entry.path().string());
    return true;
}

} // namespace

std::string recoveryFolder()
{
    return ownFolder("XDG_STATE_HOME", ".local/state") + "/knead/recovery";
}

std::vector<Recovery> findRecoveries(const std::string& folder)
{
    std::vector<Recovery> recoveries;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_directory(error) && !removedHalfMade(entry) &&
            entry.path().filename().string().starts_with("work-"))
            if (auto recovery = recoveryIn(entry.path().string()))
                recoveries.push_back(std::move(*recovery));
    std::sort(recoveries.begin(), recoveries.end(),
              [](const Recovery& a, const Recovery& b) { return a.lastChange > b.lastChange; });
    return recoveries;
}

void dropRecovery(const Recovery& recovery)
{
    const FileLock lock = recovery_files::patientLock(recovery.folder);
    if (lock.result() == FileLock::Result::taken)
        throw Problem(Message("Project", "Another window works on this: discard it there."));
    recovery_files::remove(recovery.folder);
}

} // namespace knead
