#include "io/project/guarded_database.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "io/project/rows.h"
#include "support/sample_project.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>
#include <zstd.h>

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>

#include <sys/resource.h>

using namespace knead;

namespace {

/// Cancelled from the start, or after some looks at it.
class CancelAfter final : public TaskControl {
public:
    explicit CancelAfter(int looks)
        : m_left(looks)
    {
    }
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return m_left-- <= 0; }

private:
    mutable int m_left;
};

constexpr const char* endless = "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n) SELECT ";

/// Zeros, packed to a ten thousandth.
Bytes bombOf(std::size_t size)
{
    const Bytes zeros(size);
    Bytes packed(ZSTD_compressBound(size));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), size, 1));
    return packed;
}

/// A frame that says it holds 2^50 bytes: a mark, a descriptor for eight bytes of size in one segment, the size, a last empty block.
Bytes lyingFrame()
{
    Bytes frame;
    for (const unsigned byte : {0x28U, 0xB5U, 0x2FU, 0xFDU, 0xE0U, 0U, 0U, 0U, 0U, 0U, 0U, 4U, 0U, 1U, 0U, 0U})
        frame.push_back(static_cast<std::byte>(byte));
    return frame;
}

void takeModelFrom(std::int64_t blob, SQLite::Database& database)
{
    const Row row = rowAt(database, "project", 0);
    putRow(database, "project", {std::int64_t{0}, row.text(1), blob, row.integer(3)});
}

} // namespace

/// Projects made by somebody who means harm: each costs a sentence.
class HostileProjectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { writeProject(path("sound.knead"), sample::project()); }
    void whatCouldRunIsRefused_data();
    void whatCouldRunIsRefused();
    void aViewUnderAnotherKindIsNotRun();
    void bombsOfZstandardAreNotUnpacked();
    void momentsThatLieAreNotUnpacked();
    void hugeCountsAreNotBelieved_data();
    void hugeCountsAreNotBelieved();
    void whatWasNeverThereIsNotListed();
    void queriesCanBeCancelled();
    void readingCanBeCancelled();

private:
    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    /// A copy in which SQL was carried out.
    std::string changed(const std::string& sql) const
    {
        return changedBy([&](SQLite::Database& database) { database.exec(sql); });
    }

    std::string changedBy(const std::function<void(SQLite::Database&)>& change) const
    {
        std::filesystem::copy_file(path("sound.knead"), path("hostile.knead"),
                                   std::filesystem::copy_options::overwrite_existing);
        SQLite::Database database(path("hostile.knead"), SQLite::OPEN_READWRITE);
        change(database);
        return path("hostile.knead");
    }

    static std::string complaint(const std::string& path)
    {
        try {
            readProject(path);
        } catch (const Problem& problem) {
            return problem.what();
        }
        return {};
    }

    /// Whether reading and rescuing end in a sentence each, or in a project, in little memory.
    static void bothAreSurvived(const std::string& path)
    {
        const std::string sentence = complaint(path);
        QVERIFY2(sentence.starts_with("hostile.knead: ") && sentence.ends_with('.') &&
                     sentence.find('\n') == std::string::npos,
                 sentence.c_str());
        try {
            rescueProject(path);
        } catch (const Problem& problem) {
            QVERIFY(QString(problem.what()).startsWith("hostile.knead: "));
        }
    }

    QTemporaryDir m_folder;
};

void HostileProjectTest::whatCouldRunIsRefused_data()
{
    QTest::addColumn<QString>("sql");
    const QString deep = QString(endless) + "i FROM n";
    QTest::newRow("trigger") << "CREATE TRIGGER t AFTER INSERT ON marks BEGIN DELETE FROM blobs; END";
    QTest::newRow("view") << "CREATE VIEW more AS SELECT 1 AS id";
    QTest::newRow("endless view") << "DROP TABLE contents; CREATE VIEW contents AS " + deep;
    QTest::newRow("endless view of words")
        << "DROP TABLE IF EXISTS entry_words; CREATE VIEW entry_words AS " + deep; // a table that files may have or not
    QTest::newRow("trigger on a view") << "CREATE VIEW v AS SELECT 1 AS id; CREATE TRIGGER t INSTEAD OF INSERT ON v "
                                          "BEGIN DELETE FROM blobs; END";
    QTest::newRow("virtual table")
        << "PRAGMA writable_schema = ON; INSERT INTO sqlite_schema VALUES ('table', 'files', 'files', 0, "
           "'CREATE VIRTUAL TABLE files USING fts5(words)')";
}

void HostileProjectTest::whatCouldRunIsRefused()
{
    QFETCH(QString, sql);
    const std::string hostile = changed(sql.toStdString());
    const std::string expected = "hostile.knead: the file holds triggers, views or virtual tables, which no Knead "
                                 "writes: somebody else put them there. Nothing of it was opened.";
    QCOMPARE(complaint(hostile), expected);
    QVERIFY_THROWS_EXCEPTION(Problem, rescueProject(hostile));
}

/// SQLite goes by the text, not by the kind beside it.
void HostileProjectTest::aViewUnderAnotherKindIsNotRun()
{
    const std::string hostile =
        changed("DROP TABLE contents; PRAGMA writable_schema = ON; INSERT INTO sqlite_schema VALUES ('table', "
                "'contents', 'contents', 0, 'CREATE VIEW contents AS " +
                std::string(endless) + "i AS id FROM n')");
    bothAreSurvived(hostile);
}

void HostileProjectTest::bombsOfZstandardAreNotUnpacked()
{
    constexpr std::int64_t piece = 8 << 20;
    const Bytes bomb = bombOf(static_cast<std::size_t>(piece));
    QVERIFY(bomb.size() < 2000);
    // Three gigabytes in a row for the model, in a file of half a megabyte.
    constexpr std::int64_t pieces = 400;
    const std::string hostile = changedBy([&](SQLite::Database& database) {
        SQLite::Transaction transaction(database);
        for (std::int64_t i = 0; i < pieces; ++i)
            putRow(database, "blobs", {1000 + i, i, pieces, piece, bomb});
        takeModelFrom(1000, database);
        transaction.commit();
    });
    bothAreSurvived(hostile);
    for (const std::int64_t size : {std::int64_t{1} << 50, piece, std::int64_t{16}}) {
        const std::string lying = changedBy([&](SQLite::Database& database) {
            putRow(database, "blobs", {std::int64_t{1000}, std::int64_t{0}, std::int64_t{1}, size, lyingFrame()});
            takeModelFrom(1000, database);
        });
        bothAreSurvived(lying);
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    QVERIFY2(used.ru_maxrss < 1'000'000, "A bomb was unpacked."); // [KB]
}

void HostileProjectTest::momentsThatLieAreNotUnpacked()
{
    const Packing packing = zstandardPacking();
    constexpr std::size_t enormous = std::size_t{1} << 50;
    QVERIFY_THROWS_EXCEPTION(Problem, packing.unpack(lyingFrame(), 16));
    QVERIFY_THROWS_EXCEPTION(Problem, packing.unpack(bombOf(1000), enormous));
}

void HostileProjectTest::hugeCountsAreNotBelieved_data()
{
    QTest::addColumn<QString>("table");
    for (const char* table : {"starts", "entries"})
        QTest::newRow(table) << table;
}

void HostileProjectTest::hugeCountsAreNotBelieved()
{
    QFETCH(QString, table);
    constexpr std::int64_t many = 4'000'000'000'000'000'000;
    const std::string hostile = changedBy([&](SQLite::Database& database) {
        SQLite::Statement statement(database, "SELECT id FROM contents WHERE table_name = ?");
        statement.bind(1, table.toStdString());
        QVERIFY(statement.executeStep());
        putRow(database, "contents", {statement.getColumn(0).getInt64(), table.toStdString(), many});
    });
    bothAreSurvived(hostile);
}

/// A row for each fourth byte: no list of so much that was lost is made.
void HostileProjectTest::whatWasNeverThereIsNotListed()
{
    const std::string hostile = changedBy([](SQLite::Database& database) {
        putRow(database, "blobs",
               {std::int64_t{9000}, std::int64_t{0}, std::int64_t{1}, std::int64_t{0}, Bytes(600'000)});
        SQLite::Statement statement(database, "SELECT id FROM contents WHERE table_name = 'marks'");
        QVERIFY(statement.executeStep());
        putRow(database, "contents", {statement.getColumn(0).getInt64(), std::string("marks"), std::int64_t{1} << 40});
    });
    try {
        rescueProject(hostile);
        QFAIL("It was rescued.");
    } catch (const Problem& problem) {
        QVERIFY2(QString(problem.what()).startsWith("hostile.knead: nothing of this project can be read any more"),
                 problem.what());
    }
}

/// As a task that the person cancels.
void HostileProjectTest::queriesCanBeCancelled()
{
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    const CancelAfter control(3);
    endQueriesWith(control, database);
    QVERIFY_THROWS_EXCEPTION(SQLite::Exception, database.execAndGet(std::string(endless) + "max(i) FROM n"));
    QCOMPARE(sqlite3_errcode(database.getHandle()), SQLITE_INTERRUPT);
}

void HostileProjectTest::readingCanBeCancelled()
{
    // Which is long to look through: three thousand tables.
    const std::string hostile = changedBy([&](SQLite::Database& database) {
        SQLite::Transaction transaction(database);
        for (int i = 0; i < 3000; ++i)
            database.exec("CREATE TABLE t" + std::to_string(i) + " (id INTEGER PRIMARY KEY)");
        transaction.commit();
    });
    for (const int looks : {0, 1, 5}) {
        CancelAfter first(looks);
        QVERIFY_THROWS_EXCEPTION(Cancelled, readProject(hostile, first));
        CancelAfter second(looks);
        QVERIFY_THROWS_EXCEPTION(Cancelled, rescueProject(hostile, second));
    }
}

QTEST_GUILESS_MAIN(HostileProjectTest)
#include "hostile_project_test.moc"
