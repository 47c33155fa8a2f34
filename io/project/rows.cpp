#include "io/project/rows.h"

#include "core/message/message.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <limits>

namespace knead {

namespace {

static_assert(std::endian::native == std::endian::little, "checksums are of numbers with the lowest byte first");

/// CRC-32 of the values of a row, see Row.
class RowCheck {
public:
    void add(const RowValue& value)
    {
        std::visit([this](const auto& content) { add(content); }, value);
    }
    std::int64_t value() const { return static_cast<std::int64_t>(m_check); }

private:
    void add(std::monostate) { add("n", 1); }
    void add(std::int64_t number) { addNumber('i', number); }
    void add(double number) { addNumber('f', number == 0 ? 0.0 : number); }
    void add(const std::string& text) { addBytes('t', text.data(), text.size()); }
    void add(const Bytes& bytes) { addBytes('b', bytes.data(), bytes.size()); }

    template <class Number>
    void addNumber(char letter, Number number)
    {
        char bytes[1 + sizeof number] = {letter};
        std::memcpy(bytes + 1, &number, sizeof number);
        add(bytes, sizeof bytes);
    }
    void addBytes(char letter, const void* bytes, std::size_t size)
    {
        addNumber(letter, static_cast<std::uint64_t>(size));
        add(bytes, size);
    }
    void add(const void* bytes, std::size_t size)
    {
        m_check = crc32_z(m_check, static_cast<const Bytef*>(bytes), size);
    }

    uLong m_check = crc32_z(0, nullptr, 0);
};

void bindValue(SQLite::Statement& statement, int column, const RowValue& value)
{
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        statement.bind(column, *integer);
    else if (const auto* number = std::get_if<double>(&value))
        statement.bind(column, *number);
    else if (const auto* text = std::get_if<std::string>(&value))
        statement.bindNoCopy(column, *text);
    else if (const auto* bytes = std::get_if<Bytes>(&value))
        statement.bindNoCopy(column, bytes->empty() ? "" : static_cast<const void*>(bytes->data()),
                             static_cast<int>(bytes->size())); // without an address it would be nothing at all
    else
        statement.bind(column);
}

RowValue valueOf(const SQLite::Column& column)
{
    if (column.isInteger())
        return column.getInt64();
    if (column.isFloat())
        return column.getDouble();
    if (column.isText())
        return column.getString();
    if (!column.isBlob())
        return std::monostate{};
    const auto* bytes = static_cast<const std::byte*>(column.getBlob());
    return Bytes(bytes, bytes + column.getBytes());
}

Message nameOf(const std::string& table, std::int64_t id)
{
    return Message("Project", "row %1 of the table %2").with(id, table);
}

} // namespace

template <class Value>
const Value& Row::get(std::size_t column) const
{
    if (column >= m_values.size() || !std::holds_alternative<Value>(m_values[column]))
        throw DamagedData(Message("Project", "a value in the table %1 is of the wrong kind").with(m_table));
    return std::get<Value>(m_values[column]);
}

bool Row::isNull(std::size_t column) const
{
    return column < m_values.size() && std::holds_alternative<std::monostate>(m_values[column]);
}

std::int64_t Row::integer(std::size_t column) const
{
    return get<std::int64_t>(column);
}

std::uint32_t Row::index(std::size_t column) const
{
    const std::int64_t number = integer(column);
    if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
        throw DamagedData(Message("Project", "a number in the table %1 is out of range").with(m_table));
    return static_cast<std::uint32_t>(number);
}

double Row::number(std::size_t column) const
{
    return get<double>(column);
}

const std::string& Row::text(std::size_t column) const
{
    return get<std::string>(column);
}

const Bytes& Row::bytes(std::size_t column) const
{
    return get<Bytes>(column);
}

void putRow(SQLite::Database& database, const std::string& table, std::vector<RowValue> values)
{
    RowCheck check;
    for (const RowValue& value : values)
        check.add(value);
    values.emplace_back(check.value());
    std::string marks = "?";
    for (std::size_t i = 1; i < values.size(); ++i)
        marks += ", ?";
    SQLite::Statement statement(database, "INSERT OR REPLACE INTO " + table + " VALUES (" + marks + ")");
    for (std::size_t i = 0; i < values.size(); ++i)
        bindValue(statement, static_cast<int>(i) + 1, values[i]);
    statement.exec();
}

Row rowAt(SQLite::Database& database, const std::string& table, std::int64_t id)
{
    SQLite::Statement statement(database, "SELECT * FROM " + table + " WHERE id = ?");
    statement.bind(1, id);
    if (!statement.executeStep())
        throw DamagedData(Message("Project", "%1 is missing").with(nameOf(table, id)));
    RowCheck check;
    std::vector<RowValue> values;
    const int count = statement.getColumnCount() - 1;
    for (int i = 0; i < count; ++i)
        check.add(values.emplace_back(valueOf(statement.getColumn(i))));
    const RowValue written = valueOf(statement.getColumn(count));
    if (written != RowValue(check.value()) || values.front() != RowValue(id))
        throw DamagedData(Message("Project", "%1 is not as it was written").with(nameOf(table, id)));
    return {table, std::move(values)};
}

void dropRow(SQLite::Database& database, const std::string& table, std::int64_t id)
{
    SQLite::Statement statement(database, "DELETE FROM " + table + " WHERE id = ?");
    statement.bind(1, id);
    statement.exec();
}

} // namespace knead
