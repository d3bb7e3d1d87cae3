/* SPDX-License-Identifier: MIT */
/* Answers of the kernel, after its Documentation/gpu/drm-uapi.rst and drivers/gpu/drm. */
#define _DEFAULT_SOURCE
#define _FILE_OFFSET_BITS 64    /* mmap under the name used by the port */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
#include <linux/netlink.h>
#include "fake_kms.h"

fake_card fake;

static const uint32_t crtcs[] = { 40, FAKE_CRTC }, encoders[] = { 50, 51 },
                      connectors[] = { FAKE_CONNECTOR, 61 };

void fake_mode(int i, uint32_t width, uint32_t height, bool preferred)
{
    fake.modes[i] = (struct drm_mode_modeinfo){
        .clock = width * height,
        .hdisplay = (uint16_t)width, .vdisplay = (uint16_t)height,
        .htotal = (uint16_t)(width + 8), .vtotal = (uint16_t)(height + 4),
        .type = DRM_MODE_TYPE_DRIVER | (preferred ? DRM_MODE_TYPE_PREFERRED : 0u),
    };
}

static void free_memory(void)
{
    for (int i = 0; i < FAKE_BUFFERS; i++)
        free(fake.buffers[i].memory);
}

void fake_reset(void)
{
    free_memory();
    fake = (fake_card){ .status = KMS_CONNECTED, .n_modes = 2, .card = -1, .plug = -1,
                        .next = 100, .connector = FAKE_CONNECTOR };
    fake_mode(0, 64, 48, false);
    fake_mode(1, 48, 32, true);
    fake.crtc = (struct drm_mode_crtc){ .crtc_id = FAKE_CRTC, .fb_id = FAKE_CONSOLE,
                                        .mode_valid = 1, .mode = fake.modes[1] };
}

void fake_new_card(void)
{
    for (int i = 0; i < FAKE_BUFFERS; i++)
        fake.buffers[i].handle = fake.buffers[i].fb = 0;
    fake.gone = fake.flip_pending = fake.master = false;
    fake.crtc.fb_id = FAKE_CONSOLE;
    fake.crtc.mode = fake.modes[1];
    fake.connector = FAKE_CONNECTOR;
}

unsigned fake_left(void)
{
    unsigned n = 0;
    for (int i = 0; i < FAKE_BUFFERS; i++)
        n += (fake.buffers[i].handle ? 1u : 0) + (fake.buffers[i].fb ? 1u : 0)
           + (fake.buffers[i].mapped ? 1u : 0);
    return n;
}

static fake_buffer *by_handle(uint32_t handle)
{
    for (int i = 0; handle && i < FAKE_BUFFERS; i++)
        if (fake.buffers[i].handle == handle)
            return &fake.buffers[i];
    return NULL;
}

static fake_buffer *by_fb(uint32_t fb)
{
    for (int i = 0; fb && i < FAKE_BUFFERS; i++)
        if (fake.buffers[i].fb == fb)
            return &fake.buffers[i];
    return NULL;
}

const fake_buffer *fake_shown(void)
{
    return by_fb(fake.crtc.fb_id);
}

void fake_report(uint64_t number)
{
    struct drm_event_vblank e = { .base = { DRM_EVENT_FLIP_COMPLETE, sizeof e },
                                  .user_data = number };
    if (write(fake.card, &e, sizeof e) != sizeof e)
        abort();
}

void fake_vblank(void)
{
    if (fake.flip_pending)
        fake_report(fake.flip_number);
    fake.flip_pending = false;
}

void fake_uevent(const char *subsystem)
{
    char text[200];
    int n = snprintf(text, sizeof text, "change@/devices/x%cACTION=change%cSUBSYSTEM=%s%c"
                     "HOTPLUG=1%c", 0, 0, subsystem, 0, 0);
    if (send(fake.plug, text, (size_t)n, 0) != n)
        abort();
}

static int refused(int error)
{
    errno = error;
    return -1;
}

/* -- requests ---------------------------------------------------------------------- */

static int get_resources(struct drm_mode_card_res *r)
{
    uint32_t n = fake.no_crtc ? 0 : 2;
    if (r->count_crtcs >= n && n)
        memcpy((void *)(uintptr_t)r->crtc_id_ptr, crtcs, sizeof crtcs);
    if (r->count_connectors >= 2)
        memcpy((void *)(uintptr_t)r->connector_id_ptr, connectors, sizeof connectors);
    if (r->count_encoders >= 2)
        memcpy((void *)(uintptr_t)r->encoder_id_ptr, encoders, sizeof encoders);
    r->count_crtcs = n;
    r->count_connectors = r->count_encoders = 2;
    return 0;
}

static int get_connector(struct drm_mode_get_connector *c)
{
    bool ours = c->connector_id == FAKE_CONNECTOR;
    uint32_t n = ours && fake.status == KMS_CONNECTED ? fake.n_modes : 0;
    fake.probes += c->count_modes == 0;
    if (c->count_modes >= n && n)
        memcpy((void *)(uintptr_t)c->modes_ptr, fake.modes, n * sizeof *fake.modes);
    if (c->count_encoders >= 1)
        *(uint32_t *)(uintptr_t)c->encoders_ptr = ours ? 50 : 51;
    c->count_modes = n;
    c->count_encoders = 1;
    c->encoder_id = ours && fake.connector ? 50 : 0;
    c->connection = ours ? fake.status : KMS_DISCONNECTED;
    return 0;
}

static int get_encoder(struct drm_mode_get_encoder *e)
{
    e->possible_crtcs = fake.no_crtc ? 0 : 3;
    e->crtc_id = e->encoder_id == 50 && fake.connector ? fake.crtc.crtc_id
               : e->encoder_id == 51 && fake.other     ? crtcs[0]
                                                       : 0;
    return 0;
}

static int set_crtc(const struct drm_mode_crtc *c)
{
    if (c->fb_id && c->fb_id != FAKE_CONSOLE && !by_fb(c->fb_id))
        return refused(ENOENT);
    if (c->fb_id && (!c->mode_valid || c->count_connectors != 1))
        return refused(EINVAL);
    if (!c->fb_id && (c->mode_valid || c->count_connectors))
        return refused(EINVAL);
    fake.sets++;
    fake.crtc = *c;
    fake.connector = c->fb_id ? *(const uint32_t *)(uintptr_t)c->set_connectors_ptr : 0;
    return 0;
}

static int page_flip(const struct drm_mode_crtc_page_flip *f)
{
    if (!fake.crtc.fb_id || fake.flip_pending || f->crtc_id != fake.crtc.crtc_id)
        return refused(EBUSY);
    if (!by_fb(f->fb_id) || !(f->flags & DRM_MODE_PAGE_FLIP_EVENT))
        return refused(EINVAL);
    fake.flips++;
    fake.drawn_while_shown += f->fb_id == fake.crtc.fb_id;
    fake.crtc.fb_id = f->fb_id;
    fake.flip_number = f->user_data;
    fake.flip_pending = true;
    if (!fake.stalls)
        fake_vblank();
    return 0;
}

static int create_dumb(struct drm_mode_create_dumb *d)
{
    for (int i = 0; i < FAKE_BUFFERS; i++) {
        fake_buffer *b = &fake.buffers[i];
        if (b->handle || b->fb || b->mapped)
            continue;
        d->pitch = d->width * d->bpp / 8 + 24;          /* padding behind each row */
        d->size = (uint64_t)d->pitch * d->height;
        d->handle = fake.next++;
        free(b->memory);
        *b = (fake_buffer){ .handle = d->handle, .width = d->width, .height = d->height,
                            .pitch = d->pitch, .bits = d->bpp };
        b->memory = malloc(d->size);
        memset(b->memory, 0xa5, d->size);
        return 0;
    }
    return refused(ENOMEM);
}

static int add_fb(struct drm_mode_fb_cmd *f)
{
    fake_buffer *b = by_handle(f->handle);
    if (!b || f->width != b->width || f->pitch != b->pitch || f->bpp != b->bits
        || f->depth != (f->bpp == 32 ? 24 : 16))
        return refused(EINVAL);
    b->fb = f->fb_id = fake.next++;
    return 0;
}

static int remove_fb(const uint32_t *fb)
{
    fake_buffer *b = by_fb(*fb);
    if (!b)
        return refused(ENOENT);
    if (fake.crtc.fb_id == *fb)
        fake.crtc.fb_id = fake.connector = 0;
    b->fb = 0;
    return 0;
}

static int destroy_dumb(const struct drm_mode_destroy_dumb *d)
{
    fake_buffer *b = by_handle(d->handle);
    if (!b)
        return refused(EINVAL);
    b->handle = 0;
    return 0;
}

static int map_dumb(struct drm_mode_map_dumb *m)
{
    m->offset = (uint64_t)m->handle << 32;
    return by_handle(m->handle) ? 0 : refused(ENOENT);
}

static int get_crtc(struct drm_mode_crtc *c)
{
    uint32_t id = c->crtc_id;
    *c = id == fake.crtc.crtc_id ? fake.crtc : (struct drm_mode_crtc){ .crtc_id = id };
    c->set_connectors_ptr = 0;
    return 0;
}

static int master_only(unsigned long request, void *what)
{
    if (!fake.master || fake.taken)
        return refused(EACCES);
    switch (request) {
    case DRM_IOCTL_MODE_SETCRTC:    return set_crtc(what);
    case DRM_IOCTL_MODE_PAGE_FLIP:  return page_flip(what);
    default:
        fake.dirties++;
        return 0;
    }
}

static int set_master(bool on)
{
    if (on && fake.taken)
        return refused(EBUSY);
    fake.master = on;
    return 0;
}

static bool is_wide(unsigned long request, const void *what)
{
    const fake_buffer *b;
    switch (request) {
    case DRM_IOCTL_MODE_CREATE_DUMB:
        return ((const struct drm_mode_create_dumb *)what)->bpp == 32;
    case DRM_IOCTL_MODE_ADDFB:
        return ((const struct drm_mode_fb_cmd *)what)->bpp == 32;
    default:
        b = by_fb(((const struct drm_mode_crtc *)what)->fb_id);
        return b && b->bits == 32;
    }
}

static int answer(unsigned long request, void *what)
{
    switch (request) {
    case DRM_IOCTL_VERSION:             return 0;
    case DRM_IOCTL_GET_CAP:
        ((struct drm_get_cap *)what)->value = !fake.no_dumb;
        return 0;
    case DRM_IOCTL_SET_MASTER:          return set_master(true);
    case DRM_IOCTL_DROP_MASTER:         return set_master(false);
    case DRM_IOCTL_MODE_GETRESOURCES:   return get_resources(what);
    case DRM_IOCTL_MODE_GETCONNECTOR:   return get_connector(what);
    case DRM_IOCTL_MODE_GETENCODER:     return get_encoder(what);
    case DRM_IOCTL_MODE_GETCRTC:        return get_crtc(what);
    case DRM_IOCTL_MODE_CREATE_DUMB:    return create_dumb(what);
    case DRM_IOCTL_MODE_ADDFB:          return add_fb(what);
    case DRM_IOCTL_MODE_RMFB:           return remove_fb(what);
    case DRM_IOCTL_MODE_MAP_DUMB:       return map_dumb(what);
    case DRM_IOCTL_MODE_DESTROY_DUMB:   return destroy_dumb(what);
    default:                            return master_only(request, what);
    }
}

/* -- replaced system calls --------------------------------------------------------- */

/* True for the call number fake.fail_call, chosen by a test; sets errno. */
static bool fails(void)
{
    if (++fake.calls != fake.fail_call)
        return false;
    errno = fake.fail_errno;
    return true;
}

int ioctl(int fd, unsigned long request, ...)
{
    va_list rest;
    va_start(rest, request);
    void *what = va_arg(rest, void *);
    va_end(rest);
    if ((request >> 8 & 255) != DRM_IOCTL_BASE)
        return (int)syscall(SYS_ioctl, fd, request, what);
    fake.card = fd;
    if (fake.interrupts && (fake.interrupted = !fake.interrupted))
        return refused(EINTR);
    if (fails())
        return -1;
    if (fake.no_card || fake.gone)
        return refused(fake.gone ? ENODEV : ENOTTY);
    for (int i = 0; i < FAKE_REFUSALS; i++)
        if (fake.refuse[i].request == request && fake.refuse[i].error
            && (!fake.refuse[i].from || !--fake.refuse[i].from))
            return refused(fake.refuse[i].error);
    if (fake.no_wide == request && is_wide(request, what))
        return refused(EINVAL);
    return answer(request, what);
}

void *mmap(void *at, size_t bytes, int prot, int flags, int fd, off_t offset)
{
    fake_buffer *b = by_handle((uint32_t)((uint64_t)offset >> 32));
    if (!b)
        return (void *)syscall(SYS_mmap, at, bytes, prot, flags, fd, offset);
    if (fails())
        return MAP_FAILED;
    b->mapped = true;
    return b->memory;
}

int munmap(void *at, size_t bytes)
{
    for (int i = 0; at && i < FAKE_BUFFERS; i++)
        if (fake.buffers[i].memory == at) {
            fake.buffers[i].mapped = false;
            return 0;
        }
    return (int)syscall(SYS_munmap, at, bytes);
}

int socket(int domain, int type, int protocol)
{
    int pair[2];
    if (domain != AF_NETLINK)
        return (int)syscall(SYS_socket, domain, type, protocol);
    if (fails() || fake.no_netlink)
        return -1;
    if (socketpair(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, pair) != 0)
        abort();
    fake.plug = pair[1];
    return pair[0];
}

int bind(int fd, const struct sockaddr *name, socklen_t bytes)
{
    if (name->sa_family != AF_NETLINK)
        return (int)syscall(SYS_bind, fd, name, bytes);
    return fails() ? -1 : 0;
}

int clock_gettime(clockid_t clock, struct timespec *t)
{
    int r = (int)syscall(SYS_clock_gettime, clock, t);
    t->tv_sec += fake.later_ms / 1000;
    t->tv_nsec += fake.later_ms % 1000 * 1000000;
    if (t->tv_nsec >= 1000000000) {
        t->tv_nsec -= 1000000000;
        t->tv_sec++;
    }
    return r;
}
