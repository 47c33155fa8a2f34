#include "app/space_mouse.h"

#include <spnav.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace knead {

namespace {

constexpr int retryTime = 2000;        // until a daemon is looked for again [ms]
constexpr double fullDeflection = 350; // of the usual devices [counts]

/// Asking in vain costs libspnav a little memory each time.
bool mayBeThere()
{
    const char* chosen = std::getenv("SPNAV_SOCKET");
    std::error_code error;
    return (chosen != nullptr && std::filesystem::exists(chosen, error)) ||
           std::filesystem::exists("/etc/spnavrc", error) || std::filesystem::exists("/var/run/spnav.sock", error);
}

/// The daemon has closed the connection.
bool isClosed(int socket)
{
    char byte = 0;
    const ssize_t read = recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return read == 0 || (read < 0 && errno != EAGAIN && errno != EINTR);
}

/// The thread that listens. libspnav has one connection per process, and opening it may take a third of a second.
class Listening {
public:
    explicit Listening(std::function<void(const SpaceEvent&)> listener)
        : m_listener(std::move(listener))
        , m_wake(eventfd(0, EFD_CLOEXEC))
        , m_thread([this](const std::stop_token& stop) { run(stop); })
    {
    }

    ~Listening()
    {
        m_thread.request_stop();
        eventfd_write(m_wake, 1);
        m_thread.join();
        close(m_wake);
    }

    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;

private:
    void run(const std::stop_token& stop)
    {
        // A daemon that goes away while it is written to must not take the program along.
        sigset_t pipe;
        sigemptyset(&pipe);
        sigaddset(&pipe, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
        static std::mutex connection;
        while (!stop.stop_requested()) {
            if (const std::unique_lock lock(connection, std::try_to_lock); lock && mayBeThere() && spnav_open() == 0) {
                m_listener({.kind = SpaceEvent::Kind::connected});
                listen(stop);
                spnav_close();
                m_listener({.kind = SpaceEvent::Kind::disconnected});
            }
            wait(-1, retryTime);
        }
    }

    /// Until the connection ends.
    void listen(const std::stop_token& stop)
    {
        while (!stop.stop_requested()) {
            wait(spnav_fd(), -1);
            if (stop.stop_requested() || isClosed(spnav_fd()))
                return;
            spnav_event event{};
            while (spnav_poll_event(&event) != 0)
                tell(event);
        }
    }

    void tell(const spnav_event& event)
    {
        if (event.type == SPNAV_EVENT_MOTION) {
            const spnav_event_motion& m = event.motion;
            m_listener({.kind = SpaceEvent::Kind::motion,
                        .motion = spaceMotionOf({m.x, m.y, m.z}, {m.rx, m.ry, m.rz}, m.period)});
        } else if (event.type == SPNAV_EVENT_BUTTON && event.button.press != 0) {
            m_listener({.kind = SpaceEvent::Kind::buttonPressed, .motion = {}, .button = event.button.bnum});
        }
    }

    /// For something to read, or the end.
    void wait(int socket, int milliseconds) const
    {
        pollfd both[] = {{m_wake, POLLIN, 0}, {socket, POLLIN, 0}};
        poll(both, socket < 0 ? 1 : 2, milliseconds);
    }

    std::function<void(const SpaceEvent&)> m_listener;
    int m_wake;
    std::jthread m_thread;
};

} // namespace

std::shared_ptr<void> listenToSpaceMouse(std::function<void(const SpaceEvent&)> listener)
{
    return std::make_shared<Listening>(std::move(listener));
}

/// spacenavd counts z away from the eye.
SpaceMotion spaceMotionOf(const int (&push)[3], const int (&turn)[3], unsigned milliseconds)
{
    constexpr double second = 1000; // [ms]
    return {.push = Vec3(push[0], push[1], -push[2]) / fullDeflection,
            .turn = Vec3(turn[0], turn[1], -turn[2]) / fullDeflection,
            .seconds = milliseconds / second};
}

} // namespace knead
