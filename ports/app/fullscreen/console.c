/* SPDX-License-Identifier: MIT */
/* Linux consoles by console_ioctl(4).  KD_GRAPHICS keeps the kernel's text and cursor
 * off the picture.  With VT_PROCESS the kernel asks before it switches to another
 * terminal.  Without a usable virtual terminal the screen counts as ours alone.  Keys
 * come from standard input, if it is a terminal, and from the virtual terminal. */
#define _GNU_SOURCE             /* for O_CLOEXEC, major, minor */
#include "console.h"
#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include "app/files/log.h"

#define TTY_MAJOR 4
#define VTS       63            /* /dev/tty1 .. /dev/tty63 */

/* -- detection ----------------------------------------------------------------------- */

static bool is_vt(int fd)
{
    int mode;
    return ioctl(fd, KDGETMODE, &mode) == 0;
}

/* Returns the number of an open virtual terminal, independent of the name used; 0 if
 * unknown. */
static int terminal_number(int fd)
{
    unsigned device = 0;
    if (ioctl(fd, TIOCGDEV, &device) || major(device) != TTY_MAJOR || minor(device) > VTS)
        return 0;
    return (int)minor(device);
}

/* Opens the active virtual terminal, for a start from outside of any terminal. */
static int open_front(void)
{
    struct vt_stat front;
    char name[32];
    const int fd = open("/dev/tty0", O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (fd < 0 || ioctl(fd, VT_GETSTATE, &front))
        return fd;
    snprintf(name, sizeof name, "/dev/tty%d", front.v_active);
    const int own = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (own < 0)
        return fd;
    close(fd);
    return own;
}

/* True if we may read the terminal: a background job of a shell may not. */
static bool readable(int fd)
{
    const pid_t front = isatty(fd) ? tcgetpgrp(fd) : 0;
    return isatty(fd) && (front < 0 || front == getpgrp());
}

static void add_keys(console *c, int i, int fd)
{
    c->keys[i].fd = readable(fd) && tcgetattr(fd, &c->keys[i].was) == 0 ? fd : -1;
}

/* Returns a descriptor of the virtual terminal: standard input, or a newly opened one;
 * -1 if none. */
static int find(void)
{
    if (is_vt(STDIN_FILENO))
        return STDIN_FILENO;
    int fd = open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (fd >= 0 && is_vt(fd))
        return fd;
    if (fd >= 0)
        close(fd);
    fd = open_front();
    if (fd >= 0 && is_vt(fd))
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

int console_open(console *c)
{
    memset(c, 0, sizeof *c);
    c->vt = find();
    c->keys[0].fd = c->keys[1].fd = -1;
    add_keys(c, 0, STDIN_FILENO);
    if (c->vt < 0)
        return EXIT_DONE;
    if (c->vt != STDIN_FILENO)
        add_keys(c, 1, c->vt);
    c->number = terminal_number(c->vt);
    if (ioctl(c->vt, KDGETMODE, &c->mode) || ioctl(c->vt, VT_GETMODE, &c->switching)) {
        const int error = errno;
        console_close(c);
        return log_fail(EXIT_DISPLAY, "the console's mode: %s", strerror(error));
    }
    if (c->mode == KD_TEXT)
        return EXIT_DONE;
    console_close(c);
    return log_fail(EXIT_DISPLAY, "the console is busy: another program draws on it");
}

/* -- taking and restoring ------------------------------------------------------------ */

static int take_keys(const console *c)
{
    for (int i = 0; i < CONSOLE_KEYS; i++) {
        struct termios raw = c->keys[i].was;
        if (c->keys[i].fd < 0)
            continue;
        raw.c_iflag &= ~(tcflag_t)(BRKINT | ICRNL | INPCK | ISTRIP | IXON);
        raw.c_lflag &= ~(tcflag_t)(ECHO | ICANON | IEXTEN | ISIG);
        raw.c_cc[VMIN] = 0;
        raw.c_cc[VTIME] = 0;
        if (tcsetattr(c->keys[i].fd, TCSANOW, &raw))
            return log_fail(EXIT_DISPLAY, "the terminal's mode: %s", strerror(errno));
    }
    return EXIT_DONE;
}

/* Sets the switch signals first: KD_GRAPHICS must not be on without them. */
int console_take(console *c)
{
    const struct vt_mode asked = { .mode = VT_PROCESS, .relsig = CONSOLE_AWAY,
                                   .acqsig = CONSOLE_BACK };
    const int code = take_keys(c);
    if (code || c->vt < 0)
        return code;
    if (ioctl(c->vt, VT_SETMODE, &asked))
        return log_fail(EXIT_DISPLAY, "the console's switching: %s", strerror(errno));
    if (ioctl(c->vt, KDSETMODE, KD_GRAPHICS))
        return log_fail(EXIT_DISPLAY, "the console's graphics mode: %s", strerror(errno));
    return EXIT_DONE;
}

/* If the leader of the session dies, the kernel hangs up its terminal: open descriptors
 * are dead, but the terminal can be opened again. */
static void open_again(console *c)
{
    char name[32];
    int mode;
    if (c->vt < 0 || !c->number || ioctl(c->vt, KDGETMODE, &mode) == 0)
        return;
    snprintf(name, sizeof name, "/dev/tty%d", c->number);
    const int fd = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    for (int i = 0; i < CONSOLE_KEYS && fd >= 0; i++)
        if (c->keys[i].fd == c->vt)
            c->keys[i].fd = fd;
    c->vt = fd >= 0 ? fd : c->vt;
}

/* Restores the switch mode first, then the text mode: KD_TEXT may redraw another active
 * terminal. */
void console_restore(console *c)
{
    open_again(c);
    if (c->vt >= 0) {
        (void)ioctl(c->vt, VT_SETMODE, &c->switching);
        (void)ioctl(c->vt, KDSETMODE, c->mode);
    }
    for (int i = 0; i < CONSOLE_KEYS; i++)
        if (c->keys[i].fd >= 0) {
            tcflush(c->keys[i].fd, TCIFLUSH);
            tcsetattr(c->keys[i].fd, TCSANOW, &c->keys[i].was);
        }
}

void console_close(console *c)
{
    if (c->vt >= 0 && c->vt != STDIN_FILENO)
        close(c->vt);
    c->vt = c->keys[0].fd = c->keys[1].fd = -1;
}

/* -- keys ---------------------------------------------------------------------------- */

int console_fds(const console *c, struct pollfd fds[CONSOLE_KEYS])
{
    int n = 0;
    for (int i = 0; i < CONSOLE_KEYS; i++)
        if (c->keys[i].fd >= 0)
            fds[n++] = (struct pollfd){ .fd = c->keys[i].fd, .events = POLLIN };
    return n;
}

/* Stops listening to a descriptor after a hangup.  A read without bytes alone is no
 * fault: another program on the same terminal may have taken the bytes reported by poll. */
static void forget(console *c, int fd)
{
    for (int i = 0; i < CONSOLE_KEYS; i++)
        if (c->keys[i].fd == fd)
            c->keys[i].fd = -1;
}

void console_read(console *c, const struct pollfd *fds, int count, terminal_keys *k)
{
    uint8_t bytes[64];
    for (int i = 0; i < count; i++) {
        if (!fds[i].revents)
            continue;
        const ssize_t n = read(fds[i].fd, bytes, sizeof bytes);
        if (n > 0)
            terminal_keys_add_bytes(k, bytes, (size_t)n);
        else if (n == 0 ? fds[i].revents & (POLLHUP | POLLERR)
                        : errno != EINTR && errno != EAGAIN)
            forget(c, fds[i].fd);
    }
}

/* -- switching ----------------------------------------------------------------------- */

bool console_front(const console *c)
{
    struct vt_stat front;
    return c->vt < 0 || !c->number || ioctl(c->vt, VT_GETSTATE, &front)
        || front.v_active == c->number;
}

void console_give(console *c)
{
    if (c->vt >= 0)
        (void)ioctl(c->vt, VT_RELDISP, 1);
}

void console_taken_back(console *c)
{
    if (c->vt >= 0)
        (void)ioctl(c->vt, VT_RELDISP, VT_ACKACQ);
}
