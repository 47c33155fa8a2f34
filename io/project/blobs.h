#pragma once

#include "core/task/task_control.h"
#include "io/project/rows.h"

#include <cstdint>
#include <span>

namespace knead {

/// Long bytes in the table blobs, in pieces of 8 MiB, each compressed with Zstandard in a row of its own. A blob is known by
/// the id of its first piece; the others follow it.
class Blobs {
public:
    explicit Blobs(SQLite::Database& database)
        : m_database(database)
    {
    }

    /// Where a blob of some size will be, when it is put later.
    std::int64_t reserve(std::size_t size);
    /// @throws SQLite::Exception, Cancelled
    void put(std::int64_t id, std::span<const std::byte> bytes, TaskControl& control = TaskControl::none());
    std::int64_t put(std::span<const std::byte> bytes, TaskControl& control = TaskControl::none());
    void drop(std::int64_t id, std::size_t size);

    /// @param budget bytes that may still be read, so that a small file cannot fill the memory; counts down
    /// @throws DamagedData, SQLite::Exception, Cancelled
    static Bytes read(SQLite::Database& database, std::int64_t id, std::size_t& budget, TaskControl& control);

private:
    SQLite::Database& m_database;
    std::int64_t m_next = 1;
    Bytes m_packed; ///< scratch
};

} // namespace knead
