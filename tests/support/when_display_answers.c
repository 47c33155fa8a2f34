/* Waits until the display of DISPLAY answers, then becomes the program that it was handed: a display that has just been started, or
   that another program has just left, may refuse connections for a moment. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

/* Whether a display answers a client that says hello, be it that it refuses to talk to it. */
static int answers(int display)
{
    /* Of the X protocol: little endian, version 11.0, no name and no data of an authorization. */
    static const unsigned char hello[12] = {'l', 0, 11, 0};
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    const struct timeval patience = {.tv_sec = 5};
    unsigned char answer;
    int isAnswered;
    const int connection = socket(AF_UNIX, SOCK_STREAM, 0);
    snprintf(address.sun_path, sizeof address.sun_path, "/tmp/.X11-unix/X%d", display);
    setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    isAnswered = connect(connection, (const struct sockaddr*)&address, sizeof address) == 0 &&
                 send(connection, hello, sizeof hello, MSG_NOSIGNAL) == (ssize_t)sizeof hello &&
                 read(connection, &answer, 1) == 1;
    close(connection);
    return isAnswered;
}

int main(int argc, char** argv)
{
    const char* name = getenv("DISPLAY");
    const struct timespec pause = {.tv_nsec = 50 * 1000 * 1000};
    if (argc < 2)
        return 2;
    if (name != NULL && name[0] == ':') { /* one of this machine */
        const int display = atoi(name + 1);
        int tries = 600; /* half a minute */
        while (!answers(display) && --tries > 0)
            nanosleep(&pause, NULL);
        if (tries == 0)
            fprintf(stderr, "The display %s does not answer.\n", name);
    }
    execvp(argv[1], argv + 1);
    perror(argv[1]);
    return 127;
}
