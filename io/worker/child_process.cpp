#include "io/worker/child_process.h"

#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longestMessage = 4096;
constexpr int pollInterval = 50; // [ms]

/// @param sentence with a place for why
[[noreturn]] void fail(const Message& sentence, int error)
{
    throw Problem(sentence.with(std::generic_category().message(error)));
}

/// An open file that is closed in the end.
class Descriptor {
public:
    explicit Descriptor(int number = -1)
        : m_number(number)
    {
    }
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    void close()
    {
        if (m_number >= 0)
            ::close(m_number);
        m_number = -1;
    }
    int get() const { return m_number; }

private:
    int m_number;
};

struct Pipe {
    Descriptor readEnd;
    Descriptor writeEnd;
};

class SpawnActions {
public:
    SpawnActions() { posix_spawn_file_actions_init(&m_actions); }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&m_actions); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    posix_spawn_file_actions_t* get() { return &m_actions; }

private:
    posix_spawn_file_actions_t m_actions{};
};

class SpawnAttributes {
public:
    SpawnAttributes()
    {
        posix_spawnattr_init(&m_attributes);
        sigset_t signals;
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&m_attributes, &signals);
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&m_attributes, &signals);
        posix_spawnattr_setpgroup(&m_attributes, 0);
        posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    }
    ~SpawnAttributes() { posix_spawnattr_destroy(&m_attributes); }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;

    const posix_spawnattr_t* get() const { return &m_attributes; }

private:
    posix_spawnattr_t m_attributes{};
};

/// Where a standard descriptor of the child leads.
void lead(SpawnActions& actions, int standard, const NamelessFile* file)
{
    if (file != nullptr)
        posix_spawn_file_actions_adddup2(actions.get(), file->descriptor(), standard);
    else
        posix_spawn_file_actions_addopen(actions.get(), standard, "/dev/null",
                                         standard == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0);
}

pid_t start(const ChildProgram& program, int lines)
{
    SpawnActions actions;
    lead(actions, STDIN_FILENO, nullptr);
    lead(actions, STDOUT_FILENO, program.output);
    lead(actions, STDERR_FILENO, program.errors);
    posix_spawn_file_actions_adddup2(actions.get(), lines, child_descriptors::lines);
    if (program.result != nullptr)
        posix_spawn_file_actions_adddup2(actions.get(), program.result->descriptor(), child_descriptors::result);
    posix_spawn_file_actions_addclosefrom_np(actions.get(),
                                             child_descriptors::lines + (program.result != nullptr ? 2 : 1));
    std::vector<char*> words;
    for (const std::string& argument : program.arguments)
        words.push_back(const_cast<char*>(argument.c_str())); // posix_spawn only reads them
    words.push_back(nullptr);
    std::vector<char*> variables;
    if (program.environment) {
        for (const std::string& variable : *program.environment)
            variables.push_back(const_cast<char*>(variable.c_str()));
        variables.push_back(nullptr);
    }
    pid_t child = 0;
    const SpawnAttributes attributes;
    const int error = posix_spawnp(&child, program.program.c_str(), actions.get(), attributes.get(), words.data(),
                                   program.environment ? variables.data() : environ);
    if (error != 0)
        fail(Message("Work", "The process of %1 cannot be started (%2).").with(program.program), error);
    return child;
}

/// A started process that is ended, at the latest, when this goes.
class Child {
public:
    explicit Child(pid_t id)
        : m_id(id)
    {
    }
    ~Child()
    {
        if (m_id > 0)
            end();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Its wait status once it has ended by itself.
    std::optional<int> status()
    {
        int status = 0;
        pid_t ended = 0;
        while ((ended = waitpid(m_id, &status, WNOHANG)) < 0 && errno == EINTR) {}
        if (ended == 0)
            return std::nullopt;
        m_id = 0;
        return status;
    }

    /// Ends the process with all it may have started.
    void end()
    {
        kill(-m_id, SIGKILL);
        kill(m_id, SIGKILL);
        while (waitpid(m_id, nullptr, 0) < 0 && errno == EINTR) {}
        m_id = 0;
    }

private:
    pid_t m_id;
};

/// Cuts what comes through a pipe into lines. A line without end is dropped.
class LineReader {
public:
    LineReader(int descriptor, const std::function<void(std::string_view)>& onLine)
        : m_descriptor(descriptor)
        , m_onLine(onLine)
    {
    }

    /// Waits a moment for more. @return false once nothing more can come
    bool wait()
    {
        pollfd watched{.fd = m_descriptor, .events = POLLIN, .revents = 0};
        if (poll(&watched, 1, pollInterval) <= 0)
            return true;
        std::array<char, 4096> block{};
        const ssize_t count = read(m_descriptor, block.data(), block.size());
        if (count <= 0)
            return count < 0 && errno == EINTR;
        for (const char character : std::string_view(block.data(), static_cast<std::size_t>(count)))
            take(character);
        return true;
    }

private:
    void take(char character)
    {
        if (character == '\n') {
            m_onLine(m_line);
            m_line.clear();
        } else if (m_line.size() < longestMessage) {
            m_line += character;
        }
    }

    int m_descriptor;
    const std::function<void(std::string_view)>& m_onLine;
    std::string m_line;
};

} // namespace

ChildEnd runChild(const ChildProgram& program, double wallTime,
                  const std::function<void(std::string_view line)>& onLine, const std::function<bool()>& isCancelled)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        fail(Message("Work", "A pipe to another process cannot be made (%1)."), errno);
    Descriptor readEnd(ends[0]);
    Descriptor writeEnd(aboveThoseOfChildren(ends[1]));
    const Clock::time_point deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wallTime));
    Child child(start(program, writeEnd.get()));
    writeEnd.close();

    LineReader lines(readEnd.get(), onLine);
    bool mayCome = true;
    for (;;) {
        if (mayCome)
            mayCome = lines.wait();
        else if (const std::optional<int> status = child.status())
            return WIFSIGNALED(*status) ? ChildEnd{ChildEnd::Kind::signaled, WTERMSIG(*status)}
                                        : ChildEnd{ChildEnd::Kind::exited, WEXITSTATUS(*status)};
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (isCancelled())
            return {ChildEnd::Kind::cancelled, 0};
        if (Clock::now() > deadline)
            return {ChildEnd::Kind::tooLong, 0};
    }
}

Message reasonOfSignal(int signal)
{
    switch (signal) {
    case SIGSEGV:
    case SIGBUS:
        return Message("Work", "memory access");
    case SIGFPE:
        return Message("Work", "arithmetic");
    case SIGABRT:
        return Message("Work", "internal error");
    case SIGILL:
        return Message("Work", "illegal instruction");
    case SIGKILL:
        return Message("Work", "ended from outside, perhaps because the machine ran out of memory");
    default:
        return Message("Work", "signal %1").with(signal);
    }
}

} // namespace knead
