#include "io/files/own_folders.h"
#include "io/files/safe_file.h"

#include <QtTest>

#include <csignal>
#include <filesystem>

#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

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

    /// Whatever folder it was to be in.
    void whatWasKilledIsRemovedAtTheNextStart()
    {
        QTemporaryDir state;
        qputenv("XDG_STATE_HOME", state.path().toUtf8());
        const auto filesIn = [](const QString& folder) {
            return QDir(folder).entryList(QDir::Files | QDir::System | QDir::Hidden).size();
        };
        const QString notes = state.filePath("knead/unfinished");
        QTemporaryDir exports;
        const pid_t killed = fork();
        if (killed == 0) {
            SafeFile file(exports.filePath("part.stl").toStdString());
            file.write("half");
            raise(SIGKILL);
        }
        QCOMPARE(waitpid(killed, nullptr, 0), killed);
        SafeFile mine(exports.filePath("other.stl").toStdString());
        QCOMPARE(filesIn(exports.path()), 2);
        QCOMPARE(filesIn(notes), 2);
        removeUnfinished();
        QCOMPARE(filesIn(exports.path()), 1);
        QCOMPARE(filesIn(notes), 1);
        mine.keep();
        QCOMPARE(filesIn(notes), 0);
        QVERIFY(QFile::exists(exports.filePath("other.stl")));
        // A note that leads to a file of a person.
        QVERIFY(QFile::link(exports.filePath("other.stl"), notes + "/other.stl"));
        removeUnfinished();
        QVERIFY(QFile::exists(exports.filePath("other.stl")) && filesIn(notes) == 0);
        qunsetenv("XDG_STATE_HOME");
    }

    void noHomeIsNoFolderOfAll()
    {
        const QByteArray home = qgetenv("HOME");
        qputenv("XDG_STATE_HOME", "relative");
        qputenv("HOME", "/home/ann");
        QCOMPARE(ownFolder("XDG_STATE_HOME", ".local/state"), std::string("/home/ann/.local/state"));
        for (const bool isEmpty : {false, true}) {
            if (isEmpty)
                qputenv("HOME", "");
            else
                qunsetenv("HOME");
            const std::string folder = ownFolder("XDG_STATE_HOME", ".local/state");
            const passwd* person = getpwuid(getuid());
            QCOMPARE(folder, std::string(person != nullptr ? person->pw_dir : "/nonexistent") + "/.local/state");
        }
        qputenv("XDG_STATE_HOME", "/state");
        QCOMPARE(ownFolder("XDG_STATE_HOME", ".local/state"), std::string("/state"));
        qunsetenv("XDG_STATE_HOME");
        qputenv("HOME", home);
    }
};

QTEST_GUILESS_MAIN(SafeFileTest)
#include "safe_file_test.moc"
