/* SPDX-License-Identifier: MIT */
/* Opening a card, becoming DRM master, choosing and setting a mode; on failure each
 * earlier step is undone. */
#define _POSIX_C_SOURCE 200809L
#include "card.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/epoll.h>
#include <unistd.h>

#define SIDE  4096              /* largest side of a picture, px */
#define CARDS 16
#define DRI   "/dev/dri/"
#define HOW   (O_RDWR | O_CLOEXEC | O_NONBLOCK)

static bool ask(const kms_card *c, unsigned long request, void *what)
{
    return kms_ask(c->fd, request, what);
}

/* Writes the reason of a failure to c->why, for a message to the person.  Returns false. */
static bool cannot(kms_card *c, const char *what)
{
    snprintf(c->why, sizeof c->why, "%s: %s", what, strerror(errno));
    return false;
}

void kms_close_card(kms_card *c)
{
    if (c->fd >= 0)
        close(c->fd);
    c->fd = -1;
    c->master = false;
}

static bool is_card(kms_card *c)
{
    struct drm_version version = { 0 };
    struct drm_get_cap dumb = { .capability = DRM_CAP_DUMB_BUFFER };
    struct epoll_event wanted = { .events = EPOLLIN };
    if (!ask(c, DRM_IOCTL_VERSION, &version))
        return cannot(c, "is not a graphics card");
    errno = EOPNOTSUPP;
    c->blind = !ask(c, DRM_IOCTL_GET_CAP, &dumb) || !dumb.value;
    if (c->blind)
        return cannot(c, "has no dumb buffers");
    return epoll_ctl(c->both, EPOLL_CTL_ADD, c->fd, &wanted) == 0
        || cannot(c, "has no events");
}

static void read_seat(const char *device, char seat[128])
{
    char name[96];
    ssize_t n = -1;
    if (strncmp(device, DRI, sizeof DRI - 1) == 0
        && snprintf(name, sizeof name, "/sys/class/drm/%s/device",
                    device + sizeof DRI - 1) < (int)sizeof name)
        n = readlink(name, seat, 127);
    seat[n > 0 ? n : 0] = 0;
}

/* Opens a card again after unplugging.  It comes back with another number if a process
 * still holds the old one open: the card is found by its place in the hardware (`seat`). */
static int open_again(const kms_card *c)
{
    char device[32], seat[128];
    for (int i = 0; i < CARDS; i++) {
        snprintf(device, sizeof device, DRI "card%d", i);
        read_seat(device, seat);
        if (strcmp(seat, c->seat) == 0)
            return open(device, HOW);
    }
    errno = ENOENT;
    return -1;
}

static bool open_card(kms_card *c)
{
    c->fd = c->seat[0] ? open_again(c) : open(c->device, HOW);
    if (c->fd < 0)
        return cannot(c, "cannot be opened");
    if (!c->seat[0])
        read_seat(c->device, c->seat);
    if (is_card(c))
        return true;
    kms_close_card(c);
    return false;
}

uint32_t kms_crtc(const kms_card *c)
{
    return c->now.crtc < KMS_LIMIT ? c->heads.crtcs[c->now.crtc] : 0;
}

bool kms_set_crtc(kms_card *c, const kms_buffer *b)
{
    struct drm_mode_crtc to = { .crtc_id = kms_crtc(c), .fb_id = b->fb,
                                .mode = c->now.mode, .mode_valid = 1,
                                .count_connectors = 1,
                                .set_connectors_ptr = (uintptr_t)&c->now.connector };
    return ask(c, DRM_IOCTL_MODE_SETCRTC, &to);
}

void kms_darken(kms_card *c)
{
    kms_buffer_free(c->fd, &c->buffers[0]);
    kms_buffer_free(c->fd, &c->buffers[1]);
    c->lit = false;
}

static uint32_t side(uint32_t wanted, uint32_t mode)
{
    uint32_t most = mode < SIDE ? mode : SIDE;
    return wanted && wanted < most ? wanted : most;
}

/* Sets the mode with black buffers, of 32 bits per pixel or, if refused, 16. */
static bool light(kms_card *c)
{
    uint32_t w = c->now.mode.hdisplay, h = c->now.mode.vdisplay;
    for (uint32_t bits = 32; bits >= 16; bits -= 16) {
        c->lit = kms_buffer_make(c->fd, &c->buffers[0], w, h, bits)
              && kms_set_crtc(c, &c->buffers[0]);
        if (c->lit) {
            c->n_buffers = kms_buffer_make(c->fd, &c->buffers[1], w, h, bits) ? 2 : 1;
            c->front = 0;
            c->width = side(c->wanted_w, w);
            c->height = side(c->wanted_h, h);
            return true;
        }
        cannot(c, "cannot show a picture");
        kms_darken(c);
    }
    return false;
}

/* Saves the picture and mode of the console or of the program before us. */
static bool remember(kms_card *c)
{
    struct drm_mode_crtc was = { .crtc_id = kms_crtc(c) };
    if (c->before.crtc_id)
        return true;
    if (!ask(c, DRM_IOCTL_MODE_GETCRTC, &was))
        return cannot(c, "does not report its current mode");
    was.count_connectors = 0;
    for (uint32_t i = 0; i < c->heads.n_connectors; i++)
        if (c->heads.driven_by[i] == was.crtc_id)
            c->before_on[was.count_connectors++] = c->heads.connectors[i];
    c->before = was;
    return true;
}

bool kms_take(kms_card *c, bool fits)
{
    static const char *const lacks[] = {
        [KMS_NOTHING] = "nothing is connected to it",
        [KMS_NO_MODE] = "the connected display has no mode",
        [KMS_NO_CRTC] = "it cannot drive the connected display",
    };
    if (c->fd < 0 && !open_card(c))
        return false;
    c->master = ask(c, DRM_IOCTL_SET_MASTER, NULL);
    if (!c->master)
        return cannot(c, "another program uses the screen");
    c->blind = !kms_connectors_scan(c->fd, &c->heads, c->wanted_w, c->wanted_h, &c->now);
    if (c->blind)
        return cannot(c, "cannot set a mode");
    if (c->now.verdict < KMS_SMALL)
        snprintf(c->why, sizeof c->why, "%s", lacks[c->now.verdict]);
    else if (c->now.verdict == KMS_SMALL && fits)
        snprintf(c->why, sizeof c->why, "its mode of %ux%u is smaller than %ux%u",
                 c->now.mode.hdisplay, c->now.mode.vdisplay, c->wanted_w, c->wanted_h);
    else
        return remember(c) && light(c);
    return false;
}

bool kms_take_first(kms_card *c)
{
    static const char *const all[] = { DRI "card0", DRI "card1", DRI "card2",
                                       DRI "card3" };
    const size_t n = sizeof all / sizeof *all;
    const char *device = c->device;
    char why[sizeof c->why];
    bool took = kms_take(c, true);
    memcpy(why, c->why, sizeof why);
    for (size_t i = 1; i < n && !took && c->blind && strcmp(c->device, all[i - 1]) == 0;
         i++) {
        kms_close_card(c);
        c->seat[0] = 0;
        c->blind = false;
        c->device = all[i];
        took = kms_take(c, true);
    }
    if (!took && c->fd < 0) {           /* no other card: report the first one's fault */
        c->device = device;
        memcpy(c->why, why, sizeof why);
    }
    return took;
}

bool kms_still_ours(kms_card *c, bool probe)
{
    struct drm_mode_crtc is = { .crtc_id = kms_crtc(c) };
    return c->lit && kms_connectors_still_valid(c->fd, &c->heads, &c->now, probe)
           && ask(c, DRM_IOCTL_MODE_GETCRTC, &is) && is.fb_id != 0
           && (is.fb_id == c->buffers[0].fb || is.fb_id == c->buffers[1].fb);
}

/* Restores the old picture before freeing our buffers: freeing the shown buffer turns
 * the CRTC off. */
void kms_give_back(kms_card *c)
{
    struct drm_mode_crtc to = { .crtc_id = c->before.crtc_id };
    if (c->before.mode_valid && c->before.fb_id && c->before.count_connectors > 0) {
        to = c->before;
        to.set_connectors_ptr = (uintptr_t)c->before_on;
    }
    if (c->master && to.crtc_id)
        ask(c, DRM_IOCTL_MODE_SETCRTC, &to);
    kms_darken(c);
}
