#include "io/files/safe_file.h"

#include <QtTest>

#include <filesystem>

using namespace knead;

class SafeFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

private slots:
    void aFileIsOursUntilItHasItsName()
    {
        const std::string path = m_folder.filePath("a.txt").toStdString();
        SafeFile file(path);
        file.write("whole");
        removeLeftOvers(path);
        file.finish();
        removeLeftOvers(path); // as another window does
        file.keep();
        QCOMPARE(std::filesystem::file_size(path), std::uintmax_t{5});
    }

    void whatIsNotKeptLeavesNothing()
    {
        const std::string path = m_folder.filePath("b.txt").toStdString();
        {
            SafeFile file(path);
            file.write("half");
            file.finish();
        }
        QVERIFY(!std::filesystem::exists(path));
        QCOMPARE(QDir(m_folder.path()).entryList({".knead-*"}, QDir::Files | QDir::Hidden).size(), 0);
    }
};

QTEST_GUILESS_MAIN(SafeFileTest)
#include "safe_file_test.moc"
