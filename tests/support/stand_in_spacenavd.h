#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

namespace knead {

/// Speaks the protocol of spacenavd at a socket of its own: one client at a time.
class StandInSpacenavd {
public:
    /// @param answersVersion as spacenavd 1.0 does; older ones do not
    explicit StandInSpacenavd(std::string path, bool answersVersion = true)
        : m_path(std::move(path))
        , m_socket(socket(AF_UNIX, SOCK_STREAM, 0))
        , m_answersVersion(answersVersion)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, m_path.c_str(), sizeof address.sun_path - 1);
        bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
        listen(m_socket, 1);
        m_thread = std::thread([this] { serve(); });
    }
    ~StandInSpacenavd()
    {
        m_ends = true;
        m_thread.join();
        hangUp();
        close(m_socket);
        unlink(m_path.c_str());
    }
    StandInSpacenavd(const StandInSpacenavd&) = delete;
    StandInSpacenavd& operator=(const StandInSpacenavd&) = delete;

    bool hasClient() const { return m_client >= 0; }
    void hangUp()
    {
        if (const int client = m_client.exchange(-1); client >= 0)
            close(client);
    }

    void move(const std::array<std::int32_t, 3>& push, const std::array<std::int32_t, 3>& turn, std::int32_t period)
    {
        send({0, push[0], push[1], push[2], turn[0], turn[1], turn[2], period});
    }
    void pressAndRelease(std::int32_t button)
    {
        send({1, button});
        send({2, button});
    }

private:
    void send(const std::array<std::int32_t, 8>& packet) const
    {
        [[maybe_unused]] const ssize_t sent = ::send(m_client, packet.data(), sizeof packet, MSG_NOSIGNAL);
    }

    void serve()
    {
        while (!m_ends) {
            pollfd waiting{m_socket, POLLIN, 0};
            if (m_client >= 0 || poll(&waiting, 1, 10) <= 0) {
                usleep(5000);
                continue;
            }
            const int client = accept(m_socket, nullptr, nullptr);
            std::uint32_t request = 0; // which version the client speaks
            if (read(client, &request, sizeof request) == sizeof request && m_answersVersion)
                ::send(client, &request, sizeof request, MSG_NOSIGNAL);
            m_client = client;
        }
    }

    std::string m_path;
    int m_socket;
    bool m_answersVersion;
    std::atomic<int> m_client{-1};
    std::atomic<bool> m_ends{false};
    std::thread m_thread;
};

} // namespace knead
