#include "io/project/project_file.h"
#include "io/project/schema.h"
#include "support/byte_mutation.h"
#include "support/same_values.h"
#include "support/sample_project.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <QtTest>

#include <filesystem>
#include <fstream>

using namespace knead;

/// Files that are not as they were written: refused in a sentence, and rescued as far as they are whole.
class ProjectDamageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    Project m_project = sample::project();
    std::string m_sound; ///< the bytes of its file

    std::string path(const std::string& name) const
    {
        return m_folder.filePath(QString::fromStdString(name)).toStdString();
    }

    std::string file(const std::string& bytes) const
    {
        std::ofstream(path("damaged.knead"), std::ios::binary | std::ios::trunc) << bytes;
        return path("damaged.knead");
    }

    std::string bytesOf(const std::string& name) const
    {
        std::ifstream in(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// A copy in which SQL was carried out.
    std::string changed(const std::string& sql) const
    {
        file(m_sound);
        SQLite::Database(path("damaged.knead"), SQLite::OPEN_READWRITE).exec(sql);
        return path("damaged.knead");
    }

    static std::string complaint(const std::string& path)
    {
        try {
            readProject(path);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    }

    static bool isSentence(const std::string& text)
    {
        return text.starts_with("damaged.knead: ") && text.ends_with('.') && text.find('\n') == std::string::npos;
    }

    /// What any caller relies on.
    static bool isSound(const Project& project)
    {
        for (std::size_t i = 0; i < project.entries.size(); ++i) {
            const HistoryRecord& entry = project.entries[i];
            if (entry.start >= project.starts.size() || (i > 0 ? entry.parent >= i : entry.parent != 0))
                return false;
        }
        for (const ProjectMark& mark : project.marks)
            if (mark.entry >= project.entries.size())
                return false;
        return project.entries.empty() ? project.current == 0 : project.current < project.entries.size();
    }

    /// Refused, or the same; and what is rescued is sound.
    bool isWithstood(const std::string& bytes, int& refused)
    {
        const std::string damaged = file(bytes);
        try {
            if (!same::values(readProject(damaged), m_project))
                return false;
        } catch (const std::runtime_error& error) {
            ++refused;
            if (!isSentence(error.what()))
                qWarning("%s", error.what());
        }
        try {
            return isSound(rescueProject(damaged).project);
        } catch (const std::runtime_error& error) {
            return isSentence(error.what());
        }
    }

private slots:
    void initTestCase()
    {
        writeProject(path("sound.knead"), m_project);
        m_sound = bytesOf("sound.knead");
    }

    void aSoundFileIsRescuedWhole()
    {
        const RescuedProject rescued = rescueProject(path("sound.knead"));
        QVERIFY(rescued.missing.empty());
        QVERIFY(same::values(rescued.project, m_project));
    }

    void cutOffFilesAreRefused()
    {
        int refused = 0;
        int tried = 0;
        for (std::size_t length = 0; length < m_sound.size(); length += 511, ++tried)
            QVERIFY2(isWithstood(m_sound.substr(0, length), refused), std::to_string(length).c_str());
        QCOMPARE(refused, tried);
    }

    void noSingleBitGoesUnnoticed()
    {
        fuzz::Random random(21);
        int refused = 0;
        for (int trial = 0; trial < 1000; ++trial) {
            std::string damaged = m_sound;
            char& byte = damaged[random.below(damaged.size())];
            byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random.below(8)));
            QVERIFY2(isWithstood(damaged, refused), std::to_string(trial).c_str());
        }
        QVERIFY(refused > 300); // the others hit room that holds nothing
    }

    void fuzzedFilesAreRefusedOrTheSame()
    {
        fuzz::Random random(22);
        int refused = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            std::string damaged = m_sound;
            for (std::size_t i = random.below(4); i < 4; ++i)
                fuzz::mutateBytes(damaged, random);
            QVERIFY2(isWithstood(damaged, refused), std::to_string(trial).c_str());
        }
        QVERIFY(refused > 1500);
    }

    /// Damage in the middle of pages: as when a disk loses sectors.
    void lostSectorsAreNoticed()
    {
        fuzz::Random random(23);
        int refused = 0;
        for (int trial = 0; trial < 200; ++trial) {
            std::string damaged = m_sound;
            damaged.replace(512 * random.below(damaged.size() / 512), 512, std::string(512, '\0'));
            QVERIFY2(isWithstood(damaged, refused), std::to_string(trial).c_str());
        }
        QVERIFY(refused > 50);
    }

    void everyTableIsChecked_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* sql, const char* words) { QTest::newRow(sql) << sql << words; };
        row("UPDATE entries SET step = 13 WHERE id = 2",
            "entry 2 (row 2 of the table entries is not as it was written)");
        row("UPDATE entries SET moment_blob = NULL WHERE id = 2", "entry 2 (row 2 of the table entries");
        row("DELETE FROM entries WHERE id = 3", "entry 3 (row 3 of the table entries is missing)");
        row("UPDATE contents SET rows = 3 WHERE table_name = 'entries'", "the number of rows of the table entries");
        row("UPDATE bodies SET material = '{}' WHERE id = 1", "start state 0 (row 1 of the table bodies");
        row("DELETE FROM blobs WHERE id = 1", "the model (row 1 of the table blobs is missing)");
        row("UPDATE tool_parts SET place = ''", "tool part 0 (row 0 of the table tool_parts");
        row("UPDATE view SET thumbnail_png = x'00'", "the view (row 0 of the table view");
        row("UPDATE marks SET words = 'bad' WHERE id = 1", "mark 1 (row 1 of the table marks");
        row("DELETE FROM panels WHERE id = 0", "what panel 0 kept (row 0 of the table panels is missing)");
        row("DROP TABLE marks", "its tables are not those of a project");
    }

    void everyTableIsChecked()
    {
        QFETCH(QString, sql);
        QFETCH(QString, words);
        const std::string sentence = complaint(changed(sql.toStdString()));
        const QString beginning = "damaged.knead: the project is damaged: " + words;
        QVERIFY2(QString::fromStdString(sentence).startsWith(beginning), sentence.c_str());
        QVERIFY2(sentence.ends_with("What is whole can be rescued."), sentence.c_str());
    }

    /// An entry that is lost takes along what followed it, and nothing else.
    void whatDependsOnALostEntryIsLost()
    {
        const RescuedProject rescued = rescueProject(changed("UPDATE entries SET name = 'x' WHERE id = 1"));
        const Project& project = rescued.project;
        QVERIFY(same::values(*project.model, *m_project.model));
        QCOMPARE(project.entries.size(), std::size_t{2});
        QVERIFY(same::values(project.entries[0], m_project.entries[0]));
        QCOMPARE(project.entries[1].name, m_project.entries[3].name);
        QVERIFY(same::values(project.entries[1].moment, m_project.entries[3].moment));
        QCOMPARE(project.marks.size(), std::size_t{1});
        QCOMPARE(project.marks[0].entry, 1U);
        QCOMPARE(project.current, 0U);
        QCOMPARE(rescued.missing.size(), std::size_t{4}); // two entries, which was shown, a mark
        QVERIFY(QString::fromStdString(rescued.missing[1].english()).contains("the entry that it follows is missing"));
    }

    void whatWasDoneBeforeALostEntryIsShown()
    {
        QCOMPARE(m_project.current, 2U);
        const RescuedProject rescued = rescueProject(changed("UPDATE entries SET name = 'x' WHERE id = 2"));
        QCOMPARE(rescued.project.entries.size(), std::size_t{3});
        QCOMPARE(rescued.project.current, 1U);
    }

    void aLostMomentIsNoLostEntry()
    {
        const int blob =
            SQLite::Database(path("sound.knead")).execAndGet("SELECT moment_blob FROM entries WHERE id = 3").getInt();
        const RescuedProject rescued = rescueProject(changed("DELETE FROM blobs WHERE id = " + std::to_string(blob)));
        QCOMPARE(rescued.project.entries.size(), std::size_t{4});
        QVERIFY(rescued.project.entries[3].moment == nullptr);
        QVERIFY(rescued.project.entries[2].moment != nullptr);
        QCOMPARE(rescued.missing.size(), std::size_t{1});
        QVERIFY(QString::fromStdString(rescued.missing[0].english()).startsWith("the state of entry 3 ("));
    }

    /// The history lies before its states.
    void aFileThatWasCutOffKeepsItsHistory()
    {
        Project project = m_project;
        project.entries[0].moment = sample::moment(1U << 20U, 9);
        project.entries[3].moment = sample::moment(1U << 20U, 10);
        writeProject(path("large.knead"), project);
        const std::string bytes = bytesOf("large.knead");
        const RescuedProject rescued = rescueProject(file(bytes.substr(0, bytes.size() * 3 / 4)));
        QCOMPARE(rescued.project.entries.size(), std::size_t{4});
        QVERIFY(same::values(rescued.project.starts, project.starts));
        QVERIFY(same::values(*rescued.project.model, *project.model));
        QVERIFY(rescued.project.entries[3].moment == nullptr);
        QVERIFY(!rescued.missing.empty());
    }

    void whatIsNoProjectIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("words");
        QTest::newRow("empty") << QByteArray() << "the file is empty.";
        QTest::newRow("text") << QByteArray("ISO-10303-21;\nHEADER;") << "this is not a Knead project.";
        QTest::newRow("header only") << QByteArray("SQLite format 3\0", 16) << "";
        QTest::newRow("noise") << QByteArray("SQLite format 3\0", 16) + QByteArray(5000, 'x') << "";
    }

    void whatIsNoProjectIsRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, words);
        const std::string damaged = file(bytes.toStdString());
        const std::string sentence = complaint(damaged);
        QVERIFY2(isSentence(sentence), sentence.c_str());
        QVERIFY2(QString::fromStdString(sentence).endsWith(words), sentence.c_str());
        QVERIFY_EXCEPTION_THROWN(rescueProject(damaged), std::runtime_error);
    }

    void placesWithoutAFileAreNamed()
    {
        QCOMPARE(complaint(path("none.knead")), std::string("none.knead: there is no such file."));
        QVERIFY(QString::fromStdString(complaint(m_folder.path().toStdString()))
                    .endsWith("this is a folder, not a project."));
        QVERIFY(QString::fromStdString(complaint("/dev/zero")).endsWith("this is no file, and no project either."));
    }

    void databasesOfOthersAreRefused()
    {
        std::filesystem::remove(path("damaged.knead"));
        SQLite::Database database(path("damaged.knead"), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec("CREATE TABLE entries (id INTEGER PRIMARY KEY, words TEXT)");
        QCOMPARE(complaint(path("damaged.knead")),
                 std::string("damaged.knead: this is a database of another program, not a Knead project."));
    }

    /// A view in place of a table could take forever.
    void codeInAFileDoesNotRun()
    {
        const std::string endless =
            "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n) SELECT i AS id FROM n";
        const std::string bad = changed("DROP TABLE contents; CREATE VIEW contents AS " + endless);
        QVERIFY(isSentence(complaint(bad)));
    }

    void whatRunsInAFileIsRefused()
    {
        const std::string refused = "damaged.knead: the file holds triggers, views or virtual tables";
        QVERIFY(complaint(changed("DROP TABLE marks; CREATE VIEW marks AS SELECT 1")).starts_with(refused));
    }

    void newerFilesAreRefused()
    {
        QCOMPARE(complaint(changed("PRAGMA user_version = 7")),
                 std::string(
                     "damaged.knead: a newer Knead saved this project (version 7 of the file; this program reads up to "
                     "2). Update Knead to open it."));
    }

    /// Version 0, made by hand: without marks and panels.
    void olderFilesAreReadAndStayAsTheyAre()
    {
        const std::string old = changed("DROP TABLE marks; DROP TABLE panels; PRAGMA user_version = 0;"
                                        "DELETE FROM contents WHERE table_name IN ('marks', 'panels')");
        const std::string before = bytesOf("damaged.knead");
        Project expected = m_project;
        expected.marks.clear();
        expected.panels.clear();
        QVERIFY(same::values(readProject(old), expected));
        const RescuedProject rescued = rescueProject(old);
        QVERIFY(rescued.missing.empty());
        QVERIFY(same::values(rescued.project, expected));
        QCOMPARE(bytesOf("damaged.knead"), before);
        writeProject(old, readProject(old));
        SQLite::Database database(old);
        QCOMPARE(database.execAndGet("PRAGMA user_version").getInt(), schemaVersion);
    }

    /// Of an older file that is damaged nothing is taken for sound.
    void olderFilesAreCheckedToo()
    {
        const std::string old = changed("DROP TABLE marks; DROP TABLE panels; PRAGMA user_version = 0;"
                                        "DELETE FROM contents WHERE table_name IN ('marks', 'panels');"
                                        "UPDATE entries SET step = 13 WHERE id = 2");
        QVERIFY(QString::fromStdString(complaint(old)).contains("entry 2"));
    }

    /// Nothing that says how much it holds is believed before it is there.
    void smallFilesDoNotFillTheMemory()
    {
        QVERIFY(!complaint(changed("UPDATE contents SET rows = 9000000000000000000")).empty());
        QVERIFY(rescueProject(path("damaged.knead")).project.starts.size() == 2);
        QVERIFY(!complaint(changed("UPDATE blobs SET raw_bytes = 9000000000000000000")).empty());
    }
};

QTEST_GUILESS_MAIN(ProjectDamageTest)
#include "project_damage_test.moc"
