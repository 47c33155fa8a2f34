#pragma once

#include "core/message/message.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace SQLite {
class Database;
}

namespace knead {

/// A row, a blob or what they say is not as it was written. The text says which and how, without a full stop, for a sentence.
struct DamagedData : Problem {
    using Problem::Problem;
};

using Bytes = std::vector<std::byte>;

/// A value of a column: nothing, a whole number, a number (which SQLite keeps without the sign of 0), a text or bytes.
using RowValue = std::variant<std::monostate, std::int64_t, double, std::string, Bytes>;

/// A row of a table whose first column is its id and whose last one is the CRC-32 of the others: for each column a letter for its
/// type (n, i, f, t, b), then the number in eight bytes, or the length and the bytes; lowest byte first.
class Row {
public:
    Row(std::string table, std::vector<RowValue> values)
        : m_table(std::move(table))
        , m_values(std::move(values))
    {
    }

    bool isNull(std::size_t column) const;
    /// @throws DamagedData when the column holds something else, or a number out of range
    std::int64_t integer(std::size_t column) const;
    std::uint32_t index(std::size_t column) const; ///< 0 .. 2^32 - 1
    double number(std::size_t column) const;
    const std::string& text(std::size_t column) const;
    const Bytes& bytes(std::size_t column) const;

private:
    template <class Value>
    const Value& get(std::size_t column) const;

    std::string m_table;
    std::vector<RowValue> m_values; ///< without the checksum
};

/// Adds a row and its checksum; replaces one of the same id. @throws SQLite::Exception
void putRow(SQLite::Database& database, const std::string& table, std::vector<RowValue> values);

/// @throws DamagedData when there is no such row or it is not as it was written; SQLite::Exception
Row rowAt(SQLite::Database& database, const std::string& table, std::int64_t id);

void dropRow(SQLite::Database& database, const std::string& table, std::int64_t id);

} // namespace knead
