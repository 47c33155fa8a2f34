#include "fuzz/targets.h"
#include "io/project/packing.h"
#include "io/project/project_database.h"
#include "io/project/project_reader.h"
#include "io/project/project_tables.h"
#include "io/project/rows.h"
#include "io/project/schema.h"
#include "support/same_values.h"
#include "support/sample_project.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cstring>

namespace knead::fuzz {

namespace {

constexpr std::size_t longestSeed = 20'000;
constexpr std::uint64_t bytesOfFile = 1U << 20U; // which bounds how many rows are believed

/// A value of a row of the sample, by the table and the column.
struct Place {
    std::string table;
    std::int64_t row = 0;
    std::size_t column = 0;
};

/// The sample in memory, with all places in it that can be changed.
struct SampleDatabase {
    SampleDatabase()
        : SampleDatabase(sample::project())
    {
    }

    explicit SampleDatabase(const Project& project)
    {
        prepareProjectDatabase(database);
        database.exec("PRAGMA journal_mode = MEMORY; BEGIN");
        makeTables(database, projectTables());
        ProjectTables(database).addProject(project, TaskControl::none());
        database.exec("COMMIT");
    }

    std::vector<Place> places()
    {
        std::vector<Place> all;
        for (const TableForm& table : projectTables()) {
            SQLite::Statement rows(database, std::string("SELECT * FROM ") + table.name + " ORDER BY id");
            while (rows.executeStep())
                for (int column = 1; column + 1 < rows.getColumnCount(); ++column)
                    all.push_back({table.name, rows.getColumn(0).getInt64(), static_cast<std::size_t>(column)});
        }
        return all;
    }

    SQLite::Database database{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

SampleDatabase& sampleDatabase()
{
    static SampleDatabase one;
    return one;
}

const std::vector<Place>& places()
{
    static const std::vector<Place> all = sampleDatabase().places();
    return all;
}

RowValue valueOf(const SQLite::Column& column)
{
    if (column.isInteger())
        return column.getInt64();
    if (column.isFloat())
        return column.getDouble();
    if (column.isText())
        return column.getString();
    const auto* bytes = static_cast<const std::byte*>(column.getBlob());
    return column.isBlob() ? RowValue(Bytes(bytes, bytes + column.getBytes())) : RowValue();
}

std::vector<RowValue> rowOf(const Place& place)
{
    SQLite::Statement row(sampleDatabase().database, "SELECT * FROM " + place.table + " WHERE id = ?");
    row.bind(1, place.row);
    row.executeStep();
    std::vector<RowValue> values;
    for (int column = 0; column + 1 < row.getColumnCount(); ++column)
        values.push_back(valueOf(row.getColumn(column)));
    return values;
}

bool isPacked(const Place& place)
{
    return place.table == "blobs" && place.column == 4;
}

std::string bytesOf(const Bytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class Number>
std::string bytesOf(Number number)
{
    return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// A value as the rest of an input: blobs unpacked.
std::string contentOf(const Place& place, const std::vector<RowValue>& row)
{
    const RowValue& value = row[place.column];
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    if (const auto* number = std::get_if<std::int64_t>(&value))
        return bytesOf(*number);
    if (const auto* number = std::get_if<double>(&value))
        return bytesOf(*number);
    const auto* bytes = std::get_if<Bytes>(&value);
    if (bytes == nullptr)
        return {};
    return bytesOf(isPacked(place)
                       ? zstandardPacking().unpack(*bytes, static_cast<std::size_t>(std::get<std::int64_t>(row[3])))
                       : *bytes);
}

template <class Number>
Number numberIn(std::string_view bytes)
{
    Number number{};
    std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof number));
    return number;
}

/// The other way: the kind of value stays, but that what is nothing may become a number.
void put(const Place& place, std::string_view bytes, std::vector<RowValue>& row)
{
    RowValue& value = row[place.column];
    const std::span<const std::byte> raw = std::as_bytes(std::span(bytes));
    if (std::holds_alternative<std::monostate>(value) && bytes.empty())
        return;
    if (std::holds_alternative<std::string>(value))
        value = std::string(bytes);
    else if (std::holds_alternative<double>(value))
        value = numberIn<double>(bytes);
    else if (!std::holds_alternative<Bytes>(value))
        value = numberIn<std::int64_t>(bytes);
    else if (isPacked(place)) {
        value = zstandardPacking().pack(raw);
        row[3] = static_cast<std::int64_t>(bytes.size());
    } else
        value = Bytes(raw.begin(), raw.end());
}

/// Which place it is, in two bytes, and its value.
std::vector<std::string> values()
{
    std::vector<std::string> all;
    for (std::size_t i = 0; i < places().size(); ++i)
        if (std::string value = bytesOf(static_cast<std::uint16_t>(i)) + contentOf(places()[i], rowOf(places()[i]));
            value.size() < longestSeed)
            all.push_back(value);
    return all;
}

/// What whoever opens it relies on.
void requireSound(const Project& project)
{
    for (std::size_t i = 0; i < project.entries.size(); ++i) {
        const HistoryRecord& entry = project.entries[i];
        if (entry.start >= project.starts.size() || (i > 0 ? entry.parent >= i : entry.parent != 0))
            throw Finding("an entry comes from one that is not there");
    }
    if (std::ranges::any_of(project.marks,
                            [&](const ProjectMark& mark) { return mark.entry >= project.entries.size(); }))
        throw Finding("a mark is of an entry that is not there");
    if (project.entries.empty() ? project.current != 0 : project.current >= project.entries.size())
        throw Finding("the present entry is not there");
}

Project readFrom(SQLite::Database& database, bool rescues)
{
    Project project = ProjectReader(database, {.rescues = rescues, .bytes = bytesOfFile}, TaskControl::none()).read();
    requireSound(project);
    return project;
}

void requireSameWritten(const Project& project)
{
    try {
        SampleDatabase written(project);
        if (!same::values(readFrom(written.database, false), project))
            throw Finding("a project that was written is read as another");
    } catch (const Problem& problem) {
        throw Finding(std::string("a project that was written is refused: ") + problem.what());
    }
}

bool readProjectWith(std::string_view input)
{
    if (input.size() < 2)
        return false;
    const Place& place = places()[numberIn<std::uint16_t>(input.substr(0, 2)) % places().size()];
    SQLite::Database& database = sampleDatabase().database;
    std::vector<RowValue> row = rowOf(place);
    put(place, input.substr(2), row);
    SQLite::Transaction backAtTheEnd(database);
    putRow(database, place.table, row);
    const bool isWhole = isTaken([&] { requireSameWritten(readFrom(database, false)); });
    isTaken([&] { readFrom(database, true); });
    return isWhole;
}

} // namespace

Target projectTarget()
{
    return {values, readProjectWith};
}

} // namespace knead::fuzz
