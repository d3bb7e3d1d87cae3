/* SPDX-License-Identifier: MIT */
/* Prints the state of a console in lines that can be compared.
 *
 *     vm_state TTY            settings of the console, its framebuffer and its card
 *     vm_state TTY THING      sets one, in the way of a careless program:
 *                             text, graphics, raw, process, pan, colours, crtc, master
 *
 * The project's programs must restore this state. A missing device (card, framebuffer) has
 * no lines. `crtc` and `master` hold the card for a minute. */
#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#if __has_include(<drm/drm.h>)
#include <drm/drm.h>
#else
#include <libdrm/drm.h>
#endif

#define CRTCS 8

static void tell_console(int tty)
{
    int mode = -1, keyboard = -1;
    struct vt_mode vt;
    struct vt_stat front;

    if (!ioctl(tty, KDGETMODE, &mode))
        printf("mode %s\n", mode == KD_TEXT ? "text" : "graphics");
    if (!ioctl(tty, KDGKBMODE, &keyboard))
        printf("keyboard %d\n", keyboard);
    if (!ioctl(tty, VT_GETMODE, &vt))
        printf("switching %s, signals %d %d\n", vt.mode == VT_AUTO ? "auto" : "process",
               vt.relsig, vt.acqsig);
    if (!ioctl(tty, VT_GETSTATE, &front))
        printf("in front %d\n", front.v_active);
}

static void tell_terminal(int tty)
{
    struct termios t;

    if (tcgetattr(tty, &t))
        return;
    printf("terminal %x %x %x %x, keys", t.c_iflag, t.c_oflag, t.c_cflag, t.c_lflag);
    for (int i = 0; i < NCCS; i++)
        printf(" %d", t.c_cc[i]);
    printf("\n");
}

static void tell_framebuffer(int fb)
{
    struct fb_var_screeninfo v;
    uint16_t c[3][256];
    struct fb_cmap map = { .len = 256, .red = c[0], .green = c[1], .blue = c[2] };

    if (ioctl(fb, FBIOGET_VSCREENINFO, &v))
        return;
    printf("framebuffer %ux%u of %ux%u at %u,%u, %u bits: %u/%u %u/%u %u/%u\n", v.xres,
           v.yres, v.xres_virtual, v.yres_virtual, v.xoffset, v.yoffset, v.bits_per_pixel,
           v.red.offset, v.red.length, v.green.offset, v.green.length, v.blue.offset,
           v.blue.length);
    if (v.bits_per_pixel > 8 || ioctl(fb, FBIOGETCMAP, &map))
        return;
    for (int i = 0; i < 256; i++)
        if (c[0][i] || c[1][i] || c[2][i])
            printf("colour %d %04x %04x %04x\n", i, c[0][i], c[1][i], c[2][i]);
}

/* If no process is master of the card, the process that opens the card becomes master. */
static void tell_card(int card)
{
    uint32_t ids[CRTCS];
    struct drm_mode_card_res r = { .crtc_id_ptr = (uintptr_t)ids, .count_crtcs = CRTCS };

    if (card < 0)
        return;
    printf("card %s\n", ioctl(card, DRM_IOCTL_SET_MASTER, NULL) ? "taken" : "free");
    if (ioctl(card, DRM_IOCTL_MODE_GETRESOURCES, &r))
        return;
    for (uint32_t i = 0; i < r.count_crtcs && i < CRTCS; i++) {
        struct drm_mode_crtc c = { .crtc_id = ids[i] };
        if (!ioctl(card, DRM_IOCTL_MODE_GETCRTC, &c))
            printf("crtc %u: buffer %u at %u,%u, mode %d %s\n", c.crtc_id, c.fb_id, c.x,
                   c.y, c.mode_valid, c.mode_valid ? c.mode.name : "");
    }
}

static int leave_terminal(int tty, const char *thing)
{
    struct vt_mode process = { .mode = VT_PROCESS };
    struct termios t;

    if (strcmp(thing, "text") == 0)
        return ioctl(tty, KDSETMODE, KD_TEXT);
    if (strcmp(thing, "graphics") == 0)
        return ioctl(tty, KDSETMODE, KD_GRAPHICS);
    if (strcmp(thing, "process") == 0)
        return ioctl(tty, VT_SETMODE, &process);
    if (strcmp(thing, "raw") || tcgetattr(tty, &t))
        return -1;
    t.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    return tcsetattr(tty, TCSANOW, &t);
}

static int leave_framebuffer(int fb, const char *thing)
{
    struct fb_var_screeninfo v;
    uint16_t one = 0x5500;
    struct fb_cmap map = { .start = 3, .len = 1, .red = &one, .green = &one,
                           .blue = &one };

    if (strcmp(thing, "colours") == 0)
        return ioctl(fb, FBIOPUTCMAP, &map);
    if (strcmp(thing, "pan") || ioctl(fb, FBIOGET_VSCREENINFO, &v))
        return -1;
    v.yoffset = v.yres_virtual - v.yres;
    return ioctl(fb, FBIOPAN_DISPLAY, &v);
}

/* Turns the first CRTC off as master, and stays. */
static int leave_card(int card, const char *thing)
{
    uint32_t id;
    struct drm_mode_card_res r = { .crtc_id_ptr = (uintptr_t)&id, .count_crtcs = 1 };

    if (strcmp(thing, "master") == 0)
        return ioctl(card, DRM_IOCTL_SET_MASTER, NULL) ? -1 : (int)sleep(60);
    if (strcmp(thing, "crtc") || ioctl(card, DRM_IOCTL_MODE_GETRESOURCES, &r))
        return -1;
    struct drm_mode_crtc off = { .crtc_id = id };
    return ioctl(card, DRM_IOCTL_MODE_SETCRTC, &off) ? -1 : (int)sleep(60);
}

int main(int argc, char **argv)
{
    int tty = argc > 1 ? open(argv[1], O_RDWR | O_NOCTTY) : -1;
    int fb = open("/dev/fb0", O_RDWR), card = open("/dev/dri/card0", O_RDWR);

    if (argc == 3)
        return leave_terminal(tty, argv[2]) && leave_framebuffer(fb, argv[2])
            && leave_card(card, argv[2]);
    if (argc != 2 || tty < 0)
        return 2;
    tell_console(tty);
    tell_terminal(tty);
    tell_framebuffer(fb);
    tell_card(card);
    return 0;
}
