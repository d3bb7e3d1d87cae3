/* SPDX-License-Identifier: MIT */
/* The DRM/KMS port on a card with every kind of fault. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>
#include "../../ports/app/files/log.h"
#include <cmocka.h>
#include "../../ports/app/fullscreen/screen.h"
#include "fake_kms.h"
#include "tests/lib/messages.h"

static const screen_port *const port = &screen_kms;
static char folder[] = "/tmp/test-kms-XXXXXX", pipe_name[64], plain_name[64];
static char said[400];
static uint32_t pixels[128 * 128];

/* -- helpers ----------------------------------------------------------------------- */

static unsigned open_files(void)
{
    unsigned n = 0;
    for (int fd = 0; fd < 256; fd++)
        n += fcntl(fd, F_GETFD) != -1;
    return n;
}

/* Opens the port; messages go to `said`. */
static int try_open(screen **s, const char *device, uint32_t width, uint32_t height)
{
    messages m = messages_begin();
    int code = port->open(s, device, width, height);
    messages_end(&m, said, sizeof said);
    return code;
}

/* Closes the test's end of the hotplug socket. */
static void close_plug(void)
{
    if (fake.plug >= 0)
        close(fake.plug);
    fake.plug = -1;
}

static screen *opened(uint32_t width, uint32_t height)
{
    screen *s = NULL;
    int code = try_open(&s, pipe_name, width, height);
    assert_string_equal(said, "");
    assert_int_equal(code, EXIT_DONE);
    assert_non_null(s);
    return s;
}

static picture picture_of(uint32_t width, uint32_t height, uint32_t seed)
{
    picture p = { .format = TP_FORMAT_XRGB8888, .width = width, .height = height,
                  .row_bytes = width * 4, .rows = (uint8_t *)pixels };
    for (uint32_t i = 0; i < width * height; i++)
        pixels[i] = (seed + i) * 2654435761u >> 8;
    return p;
}

/* Returns the shown pixel as 0x00RRGGBB; in 565 the low bits are 0. */
static uint32_t shown_at(const fake_buffer *b, uint32_t x, uint32_t y)
{
    const uint8_t *row = b->memory + (size_t)y * b->pitch;
    uint32_t wide;
    uint16_t narrow;
    memcpy(&wide, row + (b->bits == 32 ? x * 4 : 0), 4);
    memcpy(&narrow, row + (b->bits == 16 ? x * 2 : 0), 2);
    if (b->bits == 32)
        return wide;
    return (narrow & 0xf800u) << 8 | (narrow & 0x07e0u) << 5 | (narrow & 0x001fu) << 3;
}

/* Returns the number of screen pixels unlike the centred picture with a black border. */
static unsigned differences(const picture *p)
{
    const fake_buffer *b = fake_shown();
    unsigned n = 0;
    assert_non_null(b);
    const uint32_t mask = b->bits == 32 ? 0xffffff : 0xf8fcf8;
    int left = ((int)b->width - (int)p->width) / 2;
    int top = ((int)b->height - (int)p->height) / 2;
    for (int y = 0; y < (int)b->height; y++)
        for (int x = 0; x < (int)b->width; x++) {
            int u = x - left, v = y - top;
            bool in = u >= 0 && v >= 0 && u < (int)p->width && v < (int)p->height;
            uint32_t want = in ? pixels[v * (int)p->width + u] & mask : 0;
            n += shown_at(b, (uint32_t)x, (uint32_t)y) != want;
        }
    return n;
}

static void show(screen *s, uint32_t width, uint32_t height, uint32_t seed)
{
    picture p = picture_of(width, height, seed);
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_false(port->lacks(s));
    assert_int_equal(differences(&p), 0);
    pixels[(height / 2) * width + width / 2] ^= 0x800000;       /* a wrong pixel is found */
    assert_int_equal(differences(&p), 1);
}

static void show_nothing(screen *s)
{
    unsigned flips = fake.flips, sets = fake.sets;
    picture p = picture_of(64, 48, 9);
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_int_equal(fake.flips + fake.sets, flips + sets);
    assert_false(port->lacks(s));
    assert_null(fake_shown());
}

static void assert_size(const screen *s, uint32_t width, uint32_t height)
{
    uint32_t w = 0, h = 0;
    port->size(s, &w, &h);
    assert_int_equal(w, width);
    assert_int_equal(h, height);
}

static void refuse(int i, unsigned long request, int error, unsigned from)
{
    fake.refuse[i].request = request;
    fake.refuse[i].error = error;
    fake.refuse[i].from = from;
}

static void assert_console_is_back(void)
{
    assert_int_equal(fake.crtc.crtc_id, FAKE_CRTC);
    assert_int_equal(fake.crtc.fb_id, FAKE_CONSOLE);
    assert_int_equal(fake.crtc.mode.hdisplay, 48);
    assert_int_equal(fake.connector, FAKE_CONNECTOR);
    assert_int_equal(fake_left(), 0);
}

static void close_and_look(screen *s)
{
    port->close(s);
    assert_console_is_back();
}

/* -- start-up ---------------------------------------------------------------------- */

/* Each call up to the end of open() fails in turn: no resource of ours is left and the
 * console's picture is restored; optional calls are done without. */
static void nothing_is_left_wherever_start_up_fails(void **state)
{
    (void)state;
    static const int errors[] = { ENOMEM, EINVAL, EACCES, ENODEV, EBUSY };
    unsigned refused = 0, did = 0;
    for (unsigned e = 0; e < sizeof errors / sizeof *errors; e++) {
        unsigned last = 0;
        for (unsigned n = 1; last == 0 || n <= last; n++) {
            screen *s = NULL;
            fake_reset();
            fake.fail_call = n;
            fake.fail_errno = errors[e];
            unsigned files = open_files();
            int code = try_open(&s, pipe_name, 0, 0);
            fake.fail_call = 0;
            if (code == EXIT_DONE) {
                did++;
                last = fake.calls < n ? n : 0;
                port->close(s);
            } else {
                refused++;
                assert_int_equal(code, EXIT_DISPLAY);
                assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1);
                assert_non_null(strstr(said, pipe_name));
            }
            close_plug();
            assert_console_is_back();
            assert_int_equal(open_files(), files);
            assert_true(n < 100);
            if (last)
                break;
        }
    }
    assert_true(refused >= 5 * 7);
    assert_true(did >= 5 * 3);
}

static void expect_refusal(const char *device, uint32_t width, const char *words)
{
    screen *s = NULL;
    unsigned files = open_files();
    assert_int_equal(try_open(&s, device, width, 0), EXIT_DISPLAY);
    assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1);
    if (!strstr(said, words) || strncmp(said, device, strlen(device)) != 0)
        fail_msg("said: %s", said);
    close_plug();
    assert_int_equal(open_files(), files);
    assert_int_equal(fake_left(), 0);
    assert_int_equal(fake.sets, 0);
    fake_reset();
}

static void bad_devices_are_told_in_a_line(void **state)
{
    (void)state;
    fake_reset();
    expect_refusal("/nowhere/card0", 0, "No such file");
    expect_refusal("/tmp", 0, "cannot be opened");
    fake.no_card = true;
    expect_refusal(plain_name, 0, "is not a graphics card");
    fake.no_dumb = true;
    expect_refusal(pipe_name, 0, "dumb buffers");
    fake.taken = true;
    expect_refusal(pipe_name, 0, "another program uses the screen");
    refuse(0, DRM_IOCTL_MODE_GETRESOURCES, EOPNOTSUPP, 0);
    expect_refusal(pipe_name, 0, "cannot set a mode");
    fake.status = KMS_DISCONNECTED;
    expect_refusal(pipe_name, 0, "nothing is connected");
    fake.n_modes = 0;
    expect_refusal(pipe_name, 0, "has no mode");
    fake.no_crtc = true;
    expect_refusal(pipe_name, 0, "cannot drive");
    expect_refusal(pipe_name, 65, "48x32 is smaller than 65x0");
}

/* -- pictures ---------------------------------------------------------------------- */

static void every_picture_is_shown_exactly(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(64, 48);
    assert_size(s, 64, 48);
    assert_int_equal(port->format(s), TP_FORMAT_XRGB8888);
    assert_true(port->fds(s) >= 0);
    for (uint32_t i = 0; i < 5; i++)
        show(s, 64, 48, i);
    show(s, 33, 21, 7);         /* centred; the old picture around it is erased */
    show(s, 33, 21, 8);
    show(s, 80, 60, 9);         /* cropped around the middle */
    show(s, 17, 100, 9);
    assert_int_equal(fake.flips, 9);
    assert_int_equal(fake.drawn_while_shown, 0);
    assert_int_equal(fake.sets, 1);
    assert_int_equal(fake.dirties, 0);
    close_and_look(s);
    close_plug();

    fake_reset();               /* a smaller picture as wanted, the preferred mode */
    s = opened(20, 10);
    assert_size(s, 20, 10);
    show(s, 20, 10, 3);
    assert_int_equal(fake_shown()->width, 48);
    close_and_look(s);
    close_plug();
}

static void in_sixteen_bits_where_there_are_no_more(void **state)
{
    (void)state;
    const unsigned long at[] = { DRM_IOCTL_MODE_CREATE_DUMB, DRM_IOCTL_MODE_ADDFB,
                                 DRM_IOCTL_MODE_SETCRTC };
    for (int i = 0; i < 3; i++) {
        fake_reset();
        fake.no_wide = at[i];
        screen *s = opened(0, 0);
        assert_int_equal(port->format(s), TP_FORMAT_RGB565);
        show(s, 48, 32, 1);
        show(s, 48, 32, 2);
        show(s, 30, 20, 2);
        show(s, 50, 40, 3);
        assert_int_equal(fake_shown()->bits, 16);
        close_and_look(s);
        close_plug();
    }
}

static void a_flip_is_awaited(void **state)
{
    (void)state;
    fake_reset();
    fake.stalls = true;
    screen *s = opened(64, 48);
    show(s, 64, 48, 1);
    assert_false(port->ready(s));
    fake_report(fake.flip_number + 1);          /* the number of another flip */
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_false(port->ready(s));
    fake_vblank();
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_true(port->ready(s));

    show(s, 64, 48, 2);                         /* never completed */
    fake.later_ms += 100;
    assert_false(port->ready(s));
    fake.later_ms += 200;
    assert_true(port->ready(s));
    unsigned sets = fake.sets;
    show(s, 64, 48, 3);                         /* the kernel still waits: SETCRTC */
    assert_int_equal(fake.sets, sets + 1);
    fake_vblank();
    fake.stalls = false;
    unsigned flips = fake.flips;
    show(s, 64, 48, 4);                         /* then flips again */
    assert_int_equal(fake.flips, flips + 1);
    close_and_look(s);
    close_plug();
}

static void on_alarm(int signal)
{
    (void)signal;
    fake_vblank();
}

/* The flip completes while the next picture waits, together with a signal. */
static void a_picture_waits_for_the_flip_before_it(void **state)
{
    (void)state;
    const struct itimerval soon = { .it_value.tv_usec = 20000 };
    struct sigaction old, act = { .sa_handler = on_alarm };
    fake_reset();
    fake.stalls = true;
    screen *s = opened(64, 48);
    show(s, 64, 48, 1);
    sigaction(SIGALRM, &act, &old);
    setitimer(ITIMER_REAL, &soon, NULL);
    show(s, 64, 48, 2);
    sigaction(SIGALRM, &old, NULL);
    assert_int_equal(fake.flips, 2);
    assert_int_equal(fake.sets, 1);
    fake_vblank();
    close_and_look(s);
    close_plug();
}

static void without_flips_buffers_are_set_and_told(void **state)
{
    (void)state;
    fake_reset();
    refuse(0, DRM_IOCTL_MODE_PAGE_FLIP, EINVAL, 0);
    screen *s = opened(64, 48);
    const fake_buffer *first = fake_shown();
    show(s, 64, 48, 1);
    assert_ptr_not_equal(fake_shown(), first);
    show(s, 64, 48, 2);
    assert_ptr_equal(fake_shown(), first);
    assert_int_equal(fake.sets, 3);
    assert_int_equal(fake.dirties, 2);
    refuse(1, DRM_IOCTL_MODE_DIRTYFB, EIO, 0);        /* temporary */
    show(s, 64, 48, 3);
    refuse(1, 0, 0, 0);
    show(s, 64, 48, 4);
    assert_int_equal(fake.dirties, 3);
    refuse(1, DRM_IOCTL_MODE_DIRTYFB, ENOSYS, 0);       /* not needed: never again */
    show(s, 64, 48, 5);
    unsigned calls = fake.calls;
    show(s, 64, 48, 6);
    assert_int_equal(fake.calls, calls + 1);
    close_and_look(s);
    close_plug();
}

static void without_room_for_two_the_shown_one_is_drawn_into(void **state)
{
    (void)state;
    fake_reset();
    screen *s;
    for (int i = 0; i < 3; i++) {
        const unsigned long at[] = { DRM_IOCTL_MODE_CREATE_DUMB, DRM_IOCTL_MODE_ADDFB,
                                     DRM_IOCTL_MODE_MAP_DUMB };
        fake_reset();
        refuse(0, at[i], ENOMEM, 2);
        s = opened(64, 48);
        assert_int_equal(fake_left(), 3);
        for (uint32_t seed = 0; seed < 3; seed++)
            show(s, 64, 48, seed);
        assert_int_equal(fake.sets, 1);
        assert_int_equal(fake.flips, 0);
        assert_int_equal(fake.dirties, 3);
        close_and_look(s);
        close_plug();
    }
    for (unsigned at = 1; at < 4; at++) {       /* or no memory for both on the card */
        fake_reset();
        s = opened(64, 48);
        for (uint32_t i = 1; i < at; i++)
            show(s, 64, 48, i);
        refuse(0, DRM_IOCTL_MODE_PAGE_FLIP, ENOMEM, 0);
        refuse(1, DRM_IOCTL_MODE_SETCRTC, ENOMEM, 0);
        for (uint32_t i = 0; i < 3; i++)
            show(s, 64, 48, 10 + i);
        assert_int_equal(fake.dirties, 3);
        assert_int_equal(fake_left(), 3);
        refuse(1, 0, 0, 0);
        close_and_look(s);
        close_plug();
    }
}

/* -- plugs ------------------------------------------------------------------------- */

static void unplug(screen *s)
{
    fake.status = KMS_DISCONNECTED;
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
}

static void a_monitor_goes_and_another_comes(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(0, 0);
    assert_size(s, 48, 32);
    show(s, 48, 32, 1);
    unsigned probes = fake.probes;
    fake_uevent("usb");                 /* not ours */
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_int_equal(fake.probes, probes);
    fake_uevent("drm");                 /* nothing has changed */
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_true(fake.probes > probes);
    assert_int_equal(fake.sets, 1);
    unplug(s);
    assert_int_equal(fake_left(), 0);
    assert_size(s, 48, 32);
    show_nothing(s);
    fake.later_ms += 5000;
    show_nothing(s);
    fake.status = KMS_CONNECTED;
    fake_mode(1, 100, 60, true);
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_size(s, 100, 60);
    assert_true(port->lacks(s));
    show(s, 48, 32, 2);                 /* still of the old size */
    show(s, 100, 60, 3);
    show(s, 100, 60, 4);
    assert_int_equal(fake.crtc.mode.hdisplay, 100);
    close_and_look(s);
    close_plug();
}

static void a_smaller_one_gets_pictures_of_its_own_size(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(64, 48);
    unplug(s);
    fake.status = KMS_CONNECTED;
    fake.n_modes = 1;
    fake_mode(0, 50, 60, true);
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_size(s, 50, 48);
    show(s, 64, 48, 3);
    close_and_look(s);
    close_plug();
}

static void plugs_are_seen_without_news(void **state)
{
    (void)state;
    fake_reset();
    fake.no_netlink = true;
    screen *s = opened(0, 0);
    show(s, 48, 32, 1);
    unsigned probes = fake.probes;
    fake.status = KMS_DISCONNECTED;
    show(s, 48, 32, 1);                 /* not yet */
    fake.later_ms += 1000;
    show_nothing(s);
    fake.status = KMS_CONNECTED;
    fake.later_ms += 1000;
    assert_int_equal(port->events(s), EXIT_DONE);       /* though nothing is drawn */
    assert_true(port->lacks(s));
    show(s, 48, 32, 2);
    probes = fake.probes;
    fake.later_ms += 1000;
    show(s, 48, 32, 2);
    assert_int_equal(fake.probes, probes);      /* no slow probe while all is well */
    close_and_look(s);
}

static void a_monitor_changed_between_two_looks_is_seen(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(0, 0);
    fake_mode(1, 40, 20, true);
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_size(s, 40, 20);
    show(s, 40, 20, 1);
    close_and_look(s);
    close_plug();
}

static void a_card_goes_and_comes_back(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(0, 0);
    show(s, 48, 32, 1);
    unsigned files = open_files();
    picture p = picture_of(48, 32, 2);
    fake.gone = true;
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_int_equal(port->events(s), EXIT_DONE);
    fake.later_ms += 1000;
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_int_equal(open_files(), files - 1);  /* else the kernel would keep the card */
    fake_new_card();
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_int_equal(open_files(), files - 1);
    refuse(0, DRM_IOCTL_GET_CAP, EIO, 0);       /* not ready yet */
    fake.later_ms += 1000;
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    assert_int_equal(open_files(), files - 1);
    refuse(0, 0, 0, 0);
    fake.later_ms += 1000;
    show(s, 48, 32, 3);
    assert_int_equal(open_files(), files);
    show(s, 48, 32, 4);
    assert_true(fake.flips >= 3);
    close_and_look(s);
    close_plug();
}

/* -- other programs ---------------------------------------------------------------- */

static void other_terminals_find_what_they_had(void **state)
{
    (void)state;
    fake_reset();
    fake.stalls = true;
    screen *s = opened(0, 0);
    show(s, 48, 32, 1);
    fake_vblank();
    assert_int_equal(port->away(s), EXIT_DONE);
    assert_console_is_back();
    assert_false(fake.master);
    unsigned calls = fake.calls;
    fake.later_ms += 5000;
    show_nothing(s);
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
    assert_int_equal(fake.calls, calls);        /* the card is left alone */
    assert_size(s, 48, 32);
    assert_int_equal(port->back(s), EXIT_DONE);
    assert_true(fake.master);
    fake.stalls = false;
    show(s, 48, 32, 2);
    show(s, 48, 32, 3);

    assert_int_equal(port->away(s), EXIT_DONE);
    fake.taken = true;
    assert_int_equal(port->back(s), EXIT_DONE); /* the other program still has it */
    show_nothing(s);
    fake.later_ms += 1000;
    show_nothing(s);
    fake.taken = false;
    show_nothing(s);
    fake.later_ms += 1000;
    show(s, 48, 32, 4);
    close_and_look(s);
    close_plug();
}

static void a_screen_that_another_program_takes_is_missed(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(0, 0);
    picture p = picture_of(48, 32, 2);
    show(s, 48, 32, 1);
    fake.taken = true;                          /* no longer master */
    fake.master = false;
    assert_int_equal(port->show(s, &p), EXIT_DONE);
    show_nothing(s);
    fake.taken = false;
    fake.later_ms += 1000;
    show(s, 48, 32, 2);
    fake.crtc.fb_id = 77;                       /* another program has set a picture */
    fake.later_ms += 1000;
    show(s, 48, 32, 3);
    assert_int_equal(fake_left(), 6);
    close_and_look(s);
    close_plug();
}

static void closing_while_away_touches_nothing(void **state)
{
    (void)state;
    fake_reset();
    screen *s = opened(0, 0);
    show(s, 48, 32, 1);
    assert_int_equal(port->away(s), EXIT_DONE);
    fake.taken = true;
    fake.crtc.fb_id = 77;
    unsigned sets = fake.sets;
    port->close(s);
    assert_int_equal(fake.sets, sets);
    assert_int_equal(fake.crtc.fb_id, 77);
    assert_int_equal(fake_left(), 0);
    close_plug();
}

/* Without a mode; with a mode and no picture; with another CRTC in use. */
static void a_screen_that_was_off_is_off_again(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        fake_reset();
        fake.crtc.mode_valid = i == 1;
        fake.crtc.fb_id = 0;
        fake.connector = i == 1 ? FAKE_CONNECTOR : 0;
        fake.other = i == 2;
        unsigned files = open_files();
        screen *s = opened(0, 0);
        assert_int_equal(fake.crtc.crtc_id, i == 0 ? 40 : FAKE_CRTC);
        show(s, 48, 32, 1);
        port->close(s);
        close_plug();
        assert_int_equal(fake.crtc.fb_id, 0);
        assert_int_equal(fake.connector, 0);
        assert_int_equal(fake.crtc.mode_valid, 0);
        assert_int_equal(fake_left(), 0);
        assert_int_equal(open_files(), files);
    }
}

static void signals_break_nothing_off(void **state)
{
    (void)state;
    fake_reset();
    fake.interrupts = true;                     /* every call is interrupted once */
    screen *s = opened(64, 48);
    show(s, 64, 48, 1);
    show(s, 64, 48, 2);
    fake.later_ms += 1000;
    show(s, 64, 48, 3);
    assert_int_equal(fake.flips, 3);
    unplug(s);
    fake.status = KMS_CONNECTED;
    fake_uevent("drm");
    assert_int_equal(port->events(s), EXIT_DONE);
    show(s, 64, 48, 4);
    close_and_look(s);
    close_plug();
}

/* -- the pipe ---------------------------------------------------------------------- */

static int make_names(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return 1;
    snprintf(pipe_name, sizeof pipe_name, "%s/card0", folder);
    snprintf(plain_name, sizeof plain_name, "%s/plain", folder);
    int fd = open(plain_name, O_CREAT | O_WRONLY, 0600);
    return fd < 0 || close(fd) != 0 || mkfifo(pipe_name, 0600) != 0;
}

static int remove_names(void **state)
{
    (void)state;
    fake_reset();
    return remove(pipe_name) + remove(plain_name) + remove(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_left_wherever_start_up_fails),
        cmocka_unit_test(bad_devices_are_told_in_a_line),
        cmocka_unit_test(every_picture_is_shown_exactly),
        cmocka_unit_test(in_sixteen_bits_where_there_are_no_more),
        cmocka_unit_test(a_flip_is_awaited),
        cmocka_unit_test(a_picture_waits_for_the_flip_before_it),
        cmocka_unit_test(without_flips_buffers_are_set_and_told),
        cmocka_unit_test(without_room_for_two_the_shown_one_is_drawn_into),
        cmocka_unit_test(a_monitor_goes_and_another_comes),
        cmocka_unit_test(a_smaller_one_gets_pictures_of_its_own_size),
        cmocka_unit_test(plugs_are_seen_without_news),
        cmocka_unit_test(a_monitor_changed_between_two_looks_is_seen),
        cmocka_unit_test(a_card_goes_and_comes_back),
        cmocka_unit_test(other_terminals_find_what_they_had),
        cmocka_unit_test(a_screen_that_another_program_takes_is_missed),
        cmocka_unit_test(closing_while_away_touches_nothing),
        cmocka_unit_test(a_screen_that_was_off_is_off_again),
        cmocka_unit_test(signals_break_nothing_off),
    };
    return cmocka_run_group_tests_name("kms", tests, make_names, remove_names);
}
