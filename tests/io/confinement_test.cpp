#include "io/worker/confinement.h"
#include "io/worker/file_rules.h"
#include "io/worker/own_process.h"
#include "support/skip.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include <fcntl.h>
#include <linux/io_uring.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace knead;

namespace {

using Attempt = std::function<bool()>; ///< whether it succeeded; otherwise errno says why not

/// How an attempt ends in a process of its own.
/// @return 0: it succeeded; errno; or the signal that ended the process, negative
int outcomeIn(const std::function<void()>& confine, const Attempt& attempt)
{
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL); // Qt Test's own writes a stack trace
        confine();
        errno = 0;
        _exit(attempt() ? 0 : errno);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

int outcome(const Attempt& attempt, const std::vector<std::string>& readable = {})
{
    return outcomeIn([&] { confineOwnProcess(readable); }, attempt);
}

bool canRead(const std::string& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    char first = 0;
    return file >= 0 && read(file, &first, 1) == 1;
}

constexpr const char* noLandlock = "The running kernel has no Landlock (Linux 5.13), or it is switched off.";
constexpr const char* noFilter = "The running kernel filters no system calls, or not for this kind of machine.";

struct Refused {
    const char* name;
    Attempt attempt;
};

/// Refused by the filter of system calls, whatever the kernel allows otherwise.
const Refused refusedByTheFilter[] = {
    {"a socket of the internet", [] { return socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
    {"a socket of the machine", [] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
    {"a socket of the kernel", [] { return socket(AF_NETLINK, SOCK_RAW, 0) >= 0; }},
    {"a pair of sockets",
     [] {
         int ends[2];
         return socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0;
     }},
    {"a connection", [] { return connect(0, nullptr, 0) == 0; }},
    {"another program",
     [] {
         char* const words[] = {nullptr};
         return execve("/bin/true", words, words) == 0;
     }},
    {"another program by a descriptor",
     [] {
         char* const words[] = {nullptr};
         return syscall(SYS_execveat, AT_FDCWD, "/bin/true", words, words, 0) == 0;
     }},
    {"a process", [] { return fork() >= 0; }},
    {"a process with a program",
     [] {
         pid_t child = 0;
         char name[] = "true";
         char* const words[] = {name, nullptr};
         errno = posix_spawn(&child, "/bin/true", nullptr, nullptr, words, words + 1);
         return errno == 0;
     }},
    {"being traced", [] { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }},
    {"tracing", [] { return ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr) == 0; }},
    {"memory of another process",
     [] {
         char byte = 0;
         iovec here{&byte, 1};
         return process_vm_readv(getppid(), &here, 1, &here, 1, 0) >= 0;
     }},
    {"a signal to another process", [] { return kill(getppid(), 0) == 0; }},
    {"a signal to all processes", [] { return kill(-1, 0) == 0; }},
    {"limits of another process",
     [] {
         rlimit limits{};
         return prlimit(getppid(), RLIMIT_CORE, nullptr, &limits) == 0;
     }},
    {"a mount", [] { return mount("none", "/tmp", "tmpfs", 0, nullptr) == 0; }},
    {"a namespace", [] { return unshare(CLONE_NEWUSER) == 0; }},
    {"another root", [] { return chroot("/tmp") == 0; }},
    {"a program for the kernel", [] { return syscall(SYS_bpf, 0, nullptr, 0) >= 0; }},
    {"counters", [] { return syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0) >= 0; }},
    {"keys", [] { return syscall(SYS_keyctl, 0, 0, 0, 0, 0) >= 0; }},
    {"calls by a ring",
     [] {
         io_uring_params parameters{};
         return syscall(SYS_io_uring_setup, 1, &parameters) >= 0;
     }},
    {"faults of pages", [] { return syscall(SYS_userfaultfd, 0) >= 0; }},
    {"memory shared with others", [] { return syscall(SYS_shmget, 0, 4096, 0600) >= 0; }},
    {"privileges looked into again", [] { return prctl(PR_SET_DUMPABLE, 1) == 0; }},
};

struct Writing {
    const char* name;
    bool (*attempt)(const char* there, const char* other); ///< a file that is there, and one that is not
};

/// Whatever rights the person has: the tests may be run by root.
const Writing refusedWriting[] = {
    {"made", [](const char*, const char* other) { return open(other, O_WRONLY | O_CREAT, 0600) >= 0; }},
    {"opened", [](const char* there, const char*) { return open(there, O_RDWR) >= 0; }},
    {"opened anew", [](const char* there, const char*) { return open(there, O_RDONLY | O_TRUNC) >= 0; }},
    {"nameless", [](const char*, const char*) { return open("/tmp", O_TMPFILE | O_WRONLY, 0600) >= 0; }},
    {"removed", [](const char* there, const char*) { return unlink(there) == 0; }},
    {"renamed", [](const char* there, const char* other) { return rename(there, other) == 0; }},
    {"linked", [](const char* there, const char* other) { return link(there, other) == 0; }},
    {"pointed to", [](const char* there, const char* other) { return symlink(there, other) == 0; }},
    {"cut", [](const char* there, const char*) { return truncate(there, 0) == 0; }},
    {"given to all", [](const char* there, const char*) { return chmod(there, 0777) == 0; }},
    {"a folder", [](const char*, const char* other) { return mkdir(other, 0700) == 0; }},
    {"a pipe", [](const char*, const char* other) { return mkfifo(other, 0600) == 0; }},
#ifdef SYS_open
    {"opened by an older call",
     [](const char*, const char* other) { return syscall(SYS_open, other, O_WRONLY | O_CREAT, 0600) >= 0; }},
#endif
};

} // namespace

/// What a process cannot do that reads files of strangers, tried from within; and what it still can.
class ConfinementTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theKernelRefuses_data();
    void theKernelRefuses();
    void nothingIsWritten_data();
    void nothingIsWritten();
    void callsThatCannotBeLookedIntoAreUnknown();
    void numbersOfAnotherMachineEndIt();
    void filesElsewhereAreNotRead();
    void whatItWasToldIsRead();
    void landlockAloneKeepsFilesToo();
    void threadsAreStillMade();
    void itEndsItselfAsBefore();
    void otherDescriptorsAreClosed();
    void nothingIsGivenBack();
    void limitsCannotBeRaised();
    void theEnvironmentTellsNoSecrets();

private:
    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    QTemporaryDir m_folder;
};

void ConfinementTest::initTestCase()
{
    for (const char* name : {"input.step", "beside.step"})
        std::ofstream(path(name)) << "ISO-10303-21;";
    std::filesystem::create_symlink("/etc/passwd", path("link.step"));
    qInfo("Landlock %d, filter of system calls: %s", landlockVersion(), confinementHere().filtersCalls ? "yes" : "no");
}

void ConfinementTest::theKernelRefuses_data()
{
    QTest::addColumn<int>("number");
    for (const Refused& refused : refusedByTheFilter)
        QTest::newRow(refused.name) << static_cast<int>(&refused - refusedByTheFilter);
}

void ConfinementTest::theKernelRefuses()
{
    if (!confinementHere().filtersCalls)
        KNEAD_SKIP_WITHOUT("seccomp", noFilter);
    QFETCH(int, number);
    QCOMPARE(outcome(refusedByTheFilter[number].attempt), EPERM);
}

void ConfinementTest::nothingIsWritten_data()
{
    QTest::addColumn<int>("number");
    for (const Writing& refused : refusedWriting)
        QTest::newRow(refused.name) << static_cast<int>(&refused - refusedWriting);
}

void ConfinementTest::nothingIsWritten()
{
    if (!confinementHere().filtersCalls)
        KNEAD_SKIP_WITHOUT("seccomp", noFilter);
    QFETCH(int, number);
    const std::string there = path("input.step");
    const std::string other = path("other.step");
    const auto attempt = [&] { return refusedWriting[number].attempt(there.c_str(), other.c_str()); };
    QCOMPARE(outcome(attempt, {m_folder.path().toStdString()}), EPERM);
    QCOMPARE(std::filesystem::file_size(there), 13U);
    QVERIFY(!std::filesystem::exists(other));
}

/// Their arguments lie in memory, where a filter cannot look; the C library then takes the older ones.
void ConfinementTest::callsThatCannotBeLookedIntoAreUnknown()
{
    if (!confinementHere().filtersCalls)
        KNEAD_SKIP_WITHOUT("seccomp", noFilter);
    QCOMPARE(outcome([] { return syscall(SYS_clone3, nullptr, 0) >= 0; }), ENOSYS);
    QCOMPARE(outcome([] { return syscall(SYS_openat2, AT_FDCWD, "/dev/null", nullptr, 0) >= 0; }), ENOSYS);
}

void ConfinementTest::numbersOfAnotherMachineEndIt()
{
    if (!confinementHere().filtersCalls)
        KNEAD_SKIP_WITHOUT("seccomp", noFilter);
#ifdef __x86_64__
    constexpr long inX32 = 0x40000000;
    QCOMPARE(outcome([] { return syscall(inX32 + SYS_getpid) >= 0; }), -SIGSYS);
#endif
}

void ConfinementTest::filesElsewhereAreNotRead()
{
    if (landlockVersion() == 0)
        KNEAD_SKIP_WITHOUT("landlock", noLandlock);
    QVERIFY(canRead("/etc/passwd"));
    const std::string input = path("input.step");
    const std::string ofParent = "/proc/" + std::to_string(getpid()) + "/environ";
    for (const std::string& file : {std::string("/etc/passwd"), ofParent, path("beside.step"), path("link.step")})
        QCOMPARE(outcome([&] { return canRead(file); }, {input}), EACCES);
    QCOMPARE(outcome([&] { return canRead(path("link.step")); }, {m_folder.path().toStdString()}), EACCES);
    const auto looksAround = [](const std::string& folder) {
        return open(folder.c_str(), O_RDONLY | O_DIRECTORY) >= 0;
    };
    for (const std::string& folder : {std::string("/"), std::string("/home"), m_folder.path().toStdString()})
        QCOMPARE(outcome([&] { return looksAround(folder); }, {input}), EACCES);
}

void ConfinementTest::whatItWasToldIsRead()
{
    QCOMPARE(outcome([&] { return canRead(path("input.step")); }, {path("input.step")}), 0);
    QCOMPARE(outcome([&] { return canRead(path("beside.step")); }, {m_folder.path().toStdString()}), 0);
    // A link is where a person keeps the file; what it leads to is meant.
    QCOMPARE(outcome([&] { return canRead(path("link.step")); }, {path("link.step")}), 0);
    QCOMPARE(readableFor("part.stl", false), std::vector<std::string>{"part.stl"});
    QCOMPARE(readableFor("/a/b.step", true), (std::vector<std::string>{"/a/b.step", "/a"}));
}

/// Where a system call is forgotten in the filter.
void ConfinementTest::landlockAloneKeepsFilesToo()
{
    if (landlockVersion() == 0)
        KNEAD_SKIP_WITHOUT("landlock", noLandlock);
    const auto confine = [&] {
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        restrictFiles({path("input.step")});
    };
    const std::string other = path("other.step");
    QCOMPARE(outcomeIn(confine, [&] { return open(other.c_str(), O_WRONLY | O_CREAT, 0600) >= 0; }), EACCES);
    QCOMPARE(outcomeIn(confine, [&] { return open(path("input.step").c_str(), O_WRONLY) >= 0; }), EACCES);
    QCOMPARE(outcomeIn(confine, [&] { return unlink(path("beside.step").c_str()) == 0; }), EACCES);
    QCOMPARE(outcomeIn(confine, [] { return execl("/bin/true", "true", nullptr) == 0; }), EACCES);
    QVERIFY(!std::filesystem::exists(other));
}

void ConfinementTest::threadsAreStillMade()
{
    const auto works = [] {
        int found = 0;
        std::thread([&] { found = 7; }).join();
        return found == 7;
    };
    QCOMPARE(outcome(works), 0);
    const auto threadsAreIn = [] {
        int error = 0;
        std::thread([&] { error = socket(AF_INET, SOCK_STREAM, 0) < 0 ? errno : 0; }).join();
        errno = error;
        return false;
    };
    if (confinementHere().filtersCalls)
        QCOMPARE(outcome(threadsAreIn), EPERM);
}

/// A crash of the reader is told by its signal.
void ConfinementTest::itEndsItselfAsBefore()
{
    QCOMPARE(outcome([]() -> bool { std::abort(); }), -SIGABRT);
    QCOMPARE(outcome([] { return raise(SIGKILL) == 0; }), -SIGKILL);
}

void ConfinementTest::otherDescriptorsAreClosed()
{
    const int secret = open("/etc/passwd", O_RDONLY);
    const int high = fcntl(secret, F_DUPFD, 30);
    QVERIFY(high >= 30);
    QCOMPARE(outcome([&] { return fcntl(high, F_GETFD) >= 0; }), EBADF);
    close(high);
    close(secret);
}

void ConfinementTest::nothingIsGivenBack()
{
    const auto isLocked = [] {
        return prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1 && prctl(PR_GET_DUMPABLE) == 0 &&
               (!confinementHere().filtersCalls || prctl(PR_GET_SECCOMP) == 2);
    };
    QCOMPARE(outcome(isLocked), 0);
}

void ConfinementTest::limitsCannotBeRaised()
{
    const auto isLimited = [](__rlimit_resource resource, rlim_t most) {
        rlimit limits{};
        return getrlimit(resource, &limits) == 0 && limits.rlim_cur <= most && limits.rlim_max <= most;
    };
    const auto limit = [] { limitOwnProcess({.memory = 1ULL << 36U, .processorTime = 100}); };
    QCOMPARE(outcomeIn(limit,
                       [&] {
                           return isLimited(RLIMIT_CORE, 0) && isLimited(RLIMIT_NOFILE, 256) &&
                                  isLimited(RLIMIT_FSIZE, 1ULL << 36U) && isLimited(RLIMIT_CPU, 110) &&
                                  isLimited(RLIMIT_NPROC, 1'000'000);
                       }),
             0);
}

void ConfinementTest::theEnvironmentTellsNoSecrets()
{
    qputenv("SESSION_TOKEN", "secret");
    qputenv("CSF_TestResources", "/somewhere");
    const std::vector<std::string> environment = environmentForConfined();
    const auto holds = [&](const char* name) {
        return std::ranges::any_of(environment,
                                   [&](const std::string& variable) { return variable.starts_with(name); });
    };
    QVERIFY(holds("CSF_TestResources=/somewhere"));
    for (const char* name : {"SESSION_TOKEN", "HOME", "PATH", "DISPLAY", "DBUS_SESSION_BUS_ADDRESS", "SSH_AUTH_SOCK"})
        QVERIFY2(!holds(name), name);
    qunsetenv("SESSION_TOKEN");
    qunsetenv("CSF_TestResources");
}

QTEST_GUILESS_MAIN(ConfinementTest)
#include "confinement_test.moc"
