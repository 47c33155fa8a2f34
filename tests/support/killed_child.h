#pragma once

#include "support/fuzz_random.h"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

/// Processes that do the same thing again and again, saying a number before and after each time, until they are killed.
namespace knead::killed {

/// In the child.
inline void say(std::uint32_t number)
{
    [[maybe_unused]] const auto written = write(STDOUT_FILENO, &number, sizeof number);
}

/// What a child said until it was killed.
struct Said {
    std::uint32_t begun = 0; ///< the last one
    std::uint32_t ended = 0;

    bool isCut() const { return begun != ended; } ///< it was killed in the middle
};

/// This program once more, at work until kill().
class Child {
public:
    explicit Child(std::vector<std::string> arguments)
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            return;
        arguments.insert(arguments.begin(), "killed");
        std::vector<char*> words;
        for (std::string& argument : arguments)
            words.push_back(argument.data());
        words.push_back(nullptr);
        m_process = fork();
        if (m_process == 0) {
            dup2(ends[1], STDOUT_FILENO);
            execv("/proc/self/exe", words.data());
            _exit(127);
        }
        close(ends[1]);
        m_said = ends[0];
    }
    ~Child()
    {
        kill();
        close(m_said);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Until it has begun something. @return whether it did
    bool waitForBegin()
    {
        while (m_numbers.begun == 0)
            if (!next())
                return false;
        return true;
    }

    /// Until it has ended something. @return whether it did
    bool waitForEnd()
    {
        while (m_numbers.ended == 0)
            if (!next())
                return false;
        return true;
    }

    Said kill()
    {
        if (m_process > 0) {
            ::kill(m_process, SIGKILL);
            waitpid(m_process, nullptr, 0);
            m_process = 0;
            while (next()) {}
        }
        return m_numbers;
    }

private:
    bool next()
    {
        std::uint32_t number = 0;
        if (read(m_said, &number, sizeof number) != sizeof number)
            return false;
        (m_numbers.begun == number ? m_numbers.ended : m_numbers.begun) = number;
        return true;
    }

    pid_t m_process = 0;
    int m_said = -1;
    Said m_numbers;
};

inline void waitAWhile(fuzz::Random& random, std::size_t mostMicroseconds = 15'000)
{
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(mostMicroseconds)));
}

} // namespace knead::killed
