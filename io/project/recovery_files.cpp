#include "io/project/recovery_files.h"

#include "io/project/schema.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include <sys/stat.h>

namespace knead::recovery_files {

namespace fs = std::filesystem;

namespace {

constexpr const char* parts[] = {"work.db", "work.db-wal", "work.db-shm", "work.db-journal"};

} // namespace

std::string lock(const std::string& folder)
{
    return (fs::path(folder) / "owner").string();
}

std::string database(const std::string& folder)
{
    return (fs::path(folder) / parts[0]).string();
}

FileLock patientLock(const std::string& folder, std::chrono::milliseconds patience)
{
    const auto end = std::chrono::steady_clock::now() + patience;
    FileLock taken(lock(folder), false);
    while (taken.result() == FileLock::Result::taken && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        taken = FileLock(lock(folder), false);
    }
    return taken;
}

/// Locked for this connection alone before the log is touched: then it needs no memory shared with others, which network
/// folders do not have. Each commit is on the disk when it is done, so that a power failure takes no more than a kill does.
std::unique_ptr<SQLite::Database> open(const std::string& folder)
{
    auto result =
        std::make_unique<SQLite::Database>(database(folder), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 1000);
    result->exec("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; "
                 "PRAGMA application_id = " +
                 std::to_string(applicationId) + "; PRAGMA user_version = " + std::to_string(schemaVersion));
    return result;
}

void settle(SQLite::Database& database)
{
    database.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
}

std::uint64_t size(const std::string& folder)
{
    std::uint64_t bytes = 0;
    for (const char* part : parts) {
        std::error_code error;
        const auto size = fs::file_size(fs::path(folder) / part, error);
        bytes += error ? 0 : size;
    }
    return bytes;
}

std::string stampOf(const std::string& path)
{
    struct stat status {};
    if (stat(path.c_str(), &status) != 0)
        return {};
    return std::to_string(status.st_size) + " bytes at " + std::to_string(status.st_mtim.tv_sec) + " s " +
           std::to_string(status.st_mtim.tv_nsec) + " ns";
}

void remove(const std::string& folder)
{
    std::error_code error;
    for (const char* part : parts)
        fs::remove(fs::path(folder) / part, error);
    fs::remove_all(folder, error);
}

} // namespace knead::recovery_files
