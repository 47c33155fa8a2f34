/* The child that a test starts instead of a reader: hands what it was given to a LoadedReader, and ends as that one's reader does. */
#define _GNU_SOURCE
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

enum { descriptors = 5, /* input, output, errors, and child_descriptors */ longestRequest = 1 << 16, noReader = 99 };

static int sendRequest(int connection, int argc, char** argv)
{
    static char words[longestRequest];
    size_t length = 0;
    for (int i = 0; i < argc; ++i) {
        const size_t size = strlen(argv[i]) + 1;
        if (length + size > sizeof words)
            return 0;
        memcpy(words + length, argv[i], size);
        length += size;
    }
    union {
        struct cmsghdr header;
        char bytes[CMSG_SPACE(descriptors * sizeof(int))];
    } control = {0};
    struct iovec text = {words, length};
    struct msghdr message = {
        .msg_iov = &text, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
    struct cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(descriptors * sizeof(int));
    for (int i = 0; i < descriptors; ++i)
        memcpy(CMSG_DATA(header) + (size_t)i * sizeof i, &i, sizeof i);
    return sendmsg(connection, &message, 0) == (ssize_t)length;
}

int main(int argc, char** argv)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const char* name = getenv("KNEAD_LOADED_READER");
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    if (name == NULL || strlen(name) >= sizeof address.sun_path)
        return noReader;
    memcpy(address.sun_path, name, strlen(name));
    const int connection = socket(AF_UNIX, SOCK_SEQPACKET, 0);
    int status = 0;
    if (connect(connection, (const struct sockaddr*)&address, sizeof address) != 0 ||
        !sendRequest(connection, argc, argv) || recv(connection, &status, sizeof status, 0) != sizeof status)
        return noReader;
    if (!WIFSIGNALED(status))
        return WEXITSTATUS(status);
    const struct rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    kill(getpid(), WTERMSIG(status));
    return noReader;
}
