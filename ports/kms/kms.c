/* SPDX-License-Identifier: MIT */
/* A screen by Linux's mode setting (DRM/KMS): dumb buffers and plain kernel calls.
 *
 * There are two buffers of the mode's size.  A picture is drawn into the hidden buffer,
 * and the kernel flips to it at the next vertical blank.  Without flips the driver is
 * told to show the other buffer (SETCRTC).  Without room for two buffers, pictures are
 * drawn into the shown one.  Any fault at run time (monitor or card unplugged, screen
 * taken by another program) leaves the screen dark: pictures are dropped, and after a
 * hotplug event, or once a second, the screen is set up anew.
 *
 * A flip shows the whole picture.  For pictures shown in other ways DIRTYFB informs
 * drivers with a buffer of their own, to be copied to the screen. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <linux/netlink.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/fullscreen/screen.h"
#include "card.h"

#define LOST_MS 250             /* a flip pending for longer is given up */
#define LOOK_MS 1000

struct screen {
    kms_card card;
    int      plugs, second;     /* hotplug socket; timer of 1 s; -1: none */
    bool     away;
    bool     drawn;             /* a picture was drawn since lit */
    bool     flips, dirty;      /* calls supported by the driver, until one fails */
    uint64_t flip, pending;     /* numbers of flips; 0: none */
    int64_t  flipped, looked;   /* times, ms */
};

static int64_t now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

/* -- events -------------------------------------------------------------------------- */

/* Reads flip events.  Returns false if the card fails. */
static bool read_flips(screen *s)
{
    struct drm_event_vblank e;
    char news[1024];
    ssize_t n;
    while ((n = read(s->card.fd, news, sizeof news)) > 0)
        for (ssize_t at = 0; at + (ssize_t)sizeof e <= n; at += (ssize_t)e.base.length) {
            memcpy(&e, news + at, sizeof e);
            if (e.base.type == DRM_EVENT_FLIP_COMPLETE && e.user_data == s->pending)
                s->pending = 0;
            if (e.base.length < sizeof e.base)
                break;
        }
    return n < 0 && (errno == EAGAIN || errno == EINTR);
}

static void wait_flip(screen *s)
{
    struct pollfd p = { .fd = s->card.fd, .events = POLLIN };
    int64_t left;
    while (s->pending && (left = s->flipped + LOST_MS - now_ms()) > 0)
        if (poll(&p, 1, (int)left) > 0 && !read_flips(s))
            break;
    s->pending = 0;
}

/* Opens the netlink group for kernel events; without it a check per second remains. */
static int open_plugs(void)
{
    struct sockaddr_nl from = { .nl_family = AF_NETLINK, .nl_groups = 1 };
    int fd = socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK,
                    NETLINK_KOBJECT_UEVENT);
    if (fd >= 0 && bind(fd, (struct sockaddr *)&from, sizeof from) != 0) {
        close(fd);
        fd = -1;
    }
    return fd;
}

static int open_second(void)
{
    const struct itimerspec every = { .it_interval.tv_sec = 1, .it_value.tv_sec = 1 };
    int fd = timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK);
    if (fd >= 0)
        timerfd_settime(fd, 0, &every, NULL);
    return fd;
}

/* True if an event concerns a graphics card.  A message is a list of 0-terminated words. */
static bool read_plugs(screen *s)
{
    char text[4096];
    ssize_t n;
    bool any = false;
    while ((n = recv(s->plugs, text, sizeof text - 1, 0)) >= 0 || errno == ENOBUFS) {
        any = any || n < 0;     /* overflow: some were lost */
        text[n < 0 ? 0 : n] = 0;
        for (ssize_t at = 0; at < n; at += (ssize_t)strlen(text + at) + 1)
            any = any || strcmp(text + at, "SUBSYSTEM=drm") == 0;
    }
    return any;
}

/* -- losing and taking the screen ---------------------------------------------------- */

static bool take(screen *s, bool first)
{
    s->pending = 0;
    s->drawn = false;
    s->flips = s->dirty = true;
    return first ? kms_take_first(&s->card) : kms_take(&s->card, false);
}

static void look(screen *s, bool probe)
{
    struct drm_version version = { 0 };
    kms_card *c = &s->card;
    if (!s->away && !kms_still_ours(c, probe)) {
        kms_darken(c);
        if (!take(s, false) && c->fd >= 0 && !kms_ask(c->fd, DRM_IOCTL_VERSION, &version))
            kms_close_card(c);  /* unplugged; may come back */
    }
    s->looked = now_ms();
}

static int kms_events(screen *s)
{
    uint64_t seconds;
    bool well = s->card.fd < 0 || read_flips(s);
    bool plugged = s->plugs >= 0 && read_plugs(s);
    bool second = s->second >= 0 && read(s->second, &seconds, sizeof seconds) > 0;
    if (plugged || !well || second || now_ms() - s->looked >= LOOK_MS)
        look(s, plugged || !well);
    return EXIT_DONE;
}

/* -- pictures ------------------------------------------------------------------------ */

static bool flip(screen *s, const kms_buffer *b)
{
    struct drm_mode_crtc_page_flip f = { .crtc_id = kms_crtc(&s->card), .fb_id = b->fb,
                                         .flags = DRM_MODE_PAGE_FLIP_EVENT,
                                         .user_data = ++s->flip };
    if (!s->flips)
        return false;
    if (!kms_ask(s->card.fd, DRM_IOCTL_MODE_PAGE_FLIP, &f)) {
        s->flips = errno == EBUSY || errno == EACCES || errno == ENOSPC;   /* temporary */
        return false;
    }
    s->pending = s->flip;
    s->flipped = now_ms();
    return true;
}

static void tell(screen *s)
{
    kms_card *c = &s->card;
    struct drm_mode_fb_dirty_cmd d = { .fb_id = c->buffers[c->front].fb };
    if (s->dirty && !kms_ask(c->fd, DRM_IOCTL_MODE_DIRTYFB, &d))
        s->dirty = errno != ENOSYS && errno != EINVAL && errno != EOPNOTSUPP;
}

/* The hidden buffer cannot be shown: not master, unplugged, or no memory.  Goes dark, or
 * goes on with one buffer. */
static void fall_back(screen *s, const picture *p)
{
    kms_card *c = &s->card;
    if (errno == EACCES || errno == EPERM || errno == ENODEV) {
        c->master = c->master && errno == ENODEV;
        kms_darken(c);
        return;
    }
    kms_buffer_free(c->fd, &c->buffers[1 - c->front]);
    c->buffers[0] = c->buffers[c->front];
    if (c->front == 1)
        c->buffers[1] = (kms_buffer){ 0 };
    c->front = 0;
    c->n_buffers = 1;
    kms_buffer_draw(&c->buffers[0], p);
    tell(s);
}

static int kms_show(screen *s, const picture *p)
{
    kms_card *c = &s->card;
    if (now_ms() - s->looked >= LOOK_MS)
        look(s, false);
    if (!c->lit)
        return EXIT_DONE;
    wait_flip(s);
    s->drawn = true;
    uint32_t back = c->n_buffers == 2 ? 1 - c->front : c->front;
    kms_buffer_draw(&c->buffers[back], p);
    bool flipped = back != c->front && flip(s, &c->buffers[back]);
    if (back != c->front && !flipped && !kms_set_crtc(c, &c->buffers[back])) {
        fall_back(s, p);
        return EXIT_DONE;
    }
    c->front = back;
    if (!flipped)
        tell(s);
    return EXIT_DONE;
}

static bool kms_ready(const screen *s)
{
    return !s->pending || now_ms() - s->flipped >= LOST_MS;
}

static bool kms_lacks(const screen *s)
{
    return s->card.lit && !s->drawn;
}

/* -- the port ------------------------------------------------------------------------ */

static void kms_close(screen *s)
{
    wait_flip(s);
    kms_give_back(&s->card);
    kms_close_card(&s->card);
    const int fds[] = { s->plugs, s->second, s->card.both };
    for (int i = 0; i < 3; i++)
        if (fds[i] >= 0)
            close(fds[i]);
    free(s);
}

static int kms_open(screen **to, const char *device, uint32_t width, uint32_t height)
{
    struct epoll_event wanted = { .events = EPOLLIN };
    screen *s = calloc(1, sizeof *s);
    if (!s)
        return log_fail_memory(sizeof *s);
    s->card = (kms_card){ .device = device, .fd = -1, .wanted_w = width,
                          .wanted_h = height, .both = epoll_create1(EPOLL_CLOEXEC) };
    const int fds[] = { s->plugs = open_plugs(), s->second = open_second() };
    for (int i = 0; i < 2; i++)
        if (fds[i] >= 0)
            epoll_ctl(s->card.both, EPOLL_CTL_ADD, fds[i], &wanted);
    s->looked = now_ms();
    if (take(s, true)) {
        *to = s;
        return EXIT_DONE;
    }
    int code = log_fail(EXIT_DISPLAY, "%s: %s", s->card.device, s->card.why);
    kms_close(s);
    return code;
}

static void kms_size(const screen *s, uint32_t *width, uint32_t *height)
{
    *width = s->card.width;
    *height = s->card.height;
}

static int kms_fds(const screen *s)
{
    return s->card.both;
}

static tp_format kms_format(const screen *s)
{
    return s->card.buffers[0].bits == 16 ? TP_FORMAT_RGB565 : TP_FORMAT_XRGB8888;
}

/* Restores the screen for other programs; on return the screen is set up anew. */
static int kms_away(screen *s)
{
    wait_flip(s);
    kms_give_back(&s->card);
    s->away = true;
    if (s->card.fd >= 0 && kms_ask(s->card.fd, DRM_IOCTL_DROP_MASTER, NULL))
        s->card.master = false;
    return EXIT_DONE;
}

static int kms_back(screen *s)
{
    s->away = false;
    look(s, false);
    return EXIT_DONE;
}

const screen_port screen_kms = {
    .name = "kms", .device = "/dev/dri/card0", .open = kms_open, .size = kms_size,
    .fds = kms_fds, .events = kms_events, .show = kms_show, .ready = kms_ready,
    .lacks = kms_lacks, .format = kms_format, .away = kms_away, .back = kms_back,
    .close = kms_close,
};
