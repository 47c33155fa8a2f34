#pragma once

#include "io/worker/import_worker.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace knead {

/// Readers that need not be loaded: most of the time of a reader of a small file goes into finding the symbols of the CAD
/// libraries. A process forked off at first forks once for every reader_launcher, which stands for the reader: it has its descriptors
/// and arguments, ends as it ended, and takes it along when it is ended itself.
///
/// Made by one thread, before there are others; what the environment is then is that of the readers. All is gone with the
/// process that made it.
class LoadedReader {
public:
    /// @param folder for the socket
    /// @throws std::runtime_error when there is no room for it
    explicit LoadedReader(const std::string& folder)
    {
        sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
        const std::string path = folder + "/reader";
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        const int listener = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
        if (path.size() >= sizeof address.sun_path || pipe2(m_life.data(), O_CLOEXEC) != 0 ||
            bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            listen(listener, 64) != 0)
            throw std::runtime_error(path + ": readers cannot listen there.");
        if (const pid_t between = fork(); between > 0) {
            waitpid(between, nullptr, 0);
            ::close(listener);
            ::close(m_life[0]);
            setenv("KNEAD_LOADED_READER", path.c_str(), 1);
        } else {
            if (between == 0 && fork() == 0) // nobody's child, so that the tests see their own only
                serve(listener);
            _exit(0);
        }
    }
    ~LoadedReader() { ::close(m_life[1]); }
    LoadedReader(const LoadedReader&) = delete;
    LoadedReader& operator=(const LoadedReader&) = delete;

private:
    static constexpr std::size_t descriptors = 5; // as in reader_launcher.c
    static constexpr std::size_t longestRequest = 1 << 16;

    struct Request {
        std::vector<char> words;
        std::array<int, descriptors> files{};
        bool isWhole = false;
    };

    void serve(int listener)
    {
        ::close(m_life[1]);
        std::signal(SIGCHLD, SIG_IGN);
        std::array<pollfd, 2> watched{{{m_life[0], POLLIN, 0}, {listener, POLLIN, 0}}};
        while (poll(watched.data(), watched.size(), -1) < 0 || watched[0].revents == 0) {
            const int connection = watched[1].revents == 0 ? -1 : accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
            if (connection < 0)
                continue;
            if (fork() == 0)
                attend(connection);
            ::close(connection);
        }
        _exit(0);
    }

    /// Sees to one reader, in a process of its own.
    static void attend(int connection)
    {
        std::signal(SIGCHLD, SIG_DFL);
        Request request = received(connection);
        const pid_t reader = request.isWhole ? fork() : -1;
        if (reader == 0)
            read(request);
        if (reader < 0)
            _exit(1);
        for (const int file : request.files)
            ::close(file);
        std::array<pollfd, 2> watched{
            {{connection, POLLIN, 0}, {static_cast<int>(syscall(SYS_pidfd_open, reader, 0)), POLLIN, 0}}};
        while (poll(watched.data(), watched.size(), -1) < 0) {}
        if (watched[1].revents == 0) // the launcher was ended
            kill(reader, SIGKILL);
        int status = 0;
        waitpid(reader, &status, 0);
        send(connection, &status, sizeof status, MSG_NOSIGNAL);
        _exit(0);
    }

    static Request received(int connection)
    {
        Request request{.words = std::vector<char>(longestRequest)};
        union {
            cmsghdr header;
            std::array<char, CMSG_SPACE(sizeof request.files)> bytes;
        } control{};
        iovec text{request.words.data(), request.words.size()};
        msghdr message{};
        message.msg_iov = &text;
        message.msg_iovlen = 1;
        message.msg_control = &control;
        message.msg_controllen = sizeof control;
        const ssize_t length = recvmsg(connection, &message, MSG_CMSG_CLOEXEC);
        const cmsghdr* header = CMSG_FIRSTHDR(&message);
        if (length > 0 && header != nullptr && header->cmsg_len == CMSG_LEN(sizeof request.files)) {
            std::memcpy(request.files.data(), CMSG_DATA(header), sizeof request.files);
            request.words.resize(static_cast<std::size_t>(length));
            request.isWhole = true;
        }
        return request;
    }

    /// As a program that has just been started.
    static void read(Request& request)
    {
        setpgid(0, 0);
        for (int& file : request.files) // out of the way of those that they become
            file = fcntl(file, F_DUPFD_CLOEXEC, 16);
        for (std::size_t i = 0; i < descriptors; ++i)
            dup2(request.files[i], static_cast<int>(i));
        close_range(descriptors, ~0U, 0);
        std::vector<char*> arguments;
        for (char* word = request.words.data(); word < request.words.data() + request.words.size();
             word += std::strlen(word) + 1)
            arguments.push_back(word);
        arguments.push_back(nullptr);
        _exit(runImportWorker(static_cast<int>(arguments.size()) - 1, arguments.data()));
    }

    std::array<int, 2> m_life{}; ///< ends with this process, and so do the readers
};

} // namespace knead
