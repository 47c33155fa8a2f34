#include "io/project/project_lock.h"

#include <QtTest>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

using namespace knead;

namespace {

std::string complaint(const std::function<void()>& attempt)
{
    try {
        attempt();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

} // namespace

class ProjectLockTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_temporary;
    std::string m_folder;

private slots:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_folder = m_temporary->path().toStdString();
    }

    void oneWindowHasAProject()
    {
        const std::string path = m_folder + "/a.knead";
        std::ofstream(path).flush();
        std::filesystem::create_symlink("a.knead", m_folder + "/link.knead");
        {
            const ProjectLock lock(path);
            QVERIFY(lock.isHeld());
            QCOMPARE(
                complaint([&] { ProjectLock other(path); }),
                std::string("a.knead: another window of this program works on it. Close it there, or open a copy."));
            QVERIFY(!complaint([&] { ProjectLock other(m_folder + "/./link.knead"); }).empty());
            QVERIFY(ProjectLock(m_folder + "/b.knead").isHeld());
        }
        QVERIFY(ProjectLock(path).isHeld());
        QVERIFY(!std::filesystem::exists(m_folder + "/.a.knead.lock"));
    }

    void anotherProcessIsNamed()
    {
        const std::string path = m_folder + "/a.knead";
        int ready[2];
        QCOMPARE(pipe(ready), 0);
        const pid_t child = fork();
        if (child == 0) {
            const ProjectLock lock(path);
            [[maybe_unused]] const auto written = write(ready[1], "x", 1);
            pause();
            _exit(0);
        }
        char byte = 0;
        QCOMPARE(read(ready[0], &byte, 1), 1);
        const std::string sentence = complaint([&] { ProjectLock other(path); });
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        char host[256] = {};
        gethostname(host, sizeof host - 1);
        const std::string expected =
            "a.knead: another window works on it (process " + std::to_string(child) + " on " + host + ", since 2";
        QVERIFY2(sentence.starts_with(expected), sentence.c_str());
        QVERIFY2(sentence.ends_with("). Close it there, or open a copy."), sentence.c_str());
        QVERIFY(ProjectLock(path).isHeld()); // the killed one has it no more, whatever stands in the file
    }

    void whereNoLockCanBeHadNobodyIsKeptFromAnything()
    {
        const ProjectLock lock("/proc/a.knead");
        QVERIFY(!lock.isHeld());
    }
};

QTEST_GUILESS_MAIN(ProjectLockTest)
#include "project_lock_test.moc"
