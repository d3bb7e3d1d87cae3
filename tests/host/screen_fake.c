/* SPDX-License-Identifier: MIT */
/* A fake frame buffer and console for machines without: loaded before the program
 * (LD_PRELOAD), it answers the system calls in place of a driver.  The memory is an
 * ordinary file.
 *
 * FAKE_FB "width height bits line rows visual red/len green/len blue/len spare/len
 *             grey pan": numbers, with blanks for the slashes
 * FAKE_VT standard input is a virtual terminal in this mode (0: text); unset: there is
 *             none
 * FAKE_LOG file for a line per call that changes something FAKE_FAIL number of the call
 * to fail, counting all calls FAKE_GONE name of a file; once it exists, the screen is
 * unplugged FAKE_HANG panning never returns FAKE_SLOW fsync takes a second */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { WIDTH, HEIGHT, BITS, LINE, ROWS, VISUAL, RED, GREEN = RED + 2, BLUE = GREEN + 2,
       SPARE = BLUE + 2, GREY = SPARE + 2, PAN, NUMBERS };

/* The fake driver's state, shared by the processes. */
typedef struct {
    pid_t    opener;            /* panning always returns in this process */
    unsigned calls, yoffset, red[256], green[256], blue[256];
} driver;

static driver *state;

__attribute__((constructor)) static void begin(void)
{
    state = mmap(NULL, sizeof *state, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS,
                 -1, 0);
    state->opener = getpid();
}

static void note(const char *format, ...)
{
    char text[128];
    va_list list;
    const char *name = getenv("FAKE_LOG");
    const int fd = name ? open(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666) : -1;
    va_start(list, format);
    const int n = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (fd >= 0 && write(fd, text, (size_t)n) < 0)
        _exit(99);
    if (fd >= 0)
        close(fd);
}

static int read_numbers(unsigned number[NUMBERS])
{
    const char *text = getenv("FAKE_FB");
    char *end;
    for (int i = 0; text && i < NUMBERS; i++, text = end)
        number[i] = (unsigned)strtoul(text, &end, 10);
    return text != NULL;
}

static struct fb_bitfield field(const unsigned *at)
{
    return (struct fb_bitfield){ .offset = at[0], .length = at[1] };
}

static void get_var(struct fb_var_screeninfo *v, const unsigned *n)
{
    *v = (struct fb_var_screeninfo){
        .xres = n[WIDTH], .yres = n[HEIGHT], .xres_virtual = n[WIDTH],
        .yres_virtual = n[ROWS], .yoffset = state->yoffset, .bits_per_pixel = n[BITS],
        .grayscale = n[GREY], .red = field(n + RED), .green = field(n + GREEN),
        .blue = field(n + BLUE), .transp = field(n + SPARE),
    };
}

static void get_fix(struct fb_fix_screeninfo *f, const unsigned *n)
{
    *f = (struct fb_fix_screeninfo){
        .id = "fake", .smem_len = n[LINE] * n[ROWS], .type = FB_TYPE_PACKED_PIXELS,
        .visual = n[VISUAL], .ypanstep = (uint16_t)n[PAN], .line_length = n[LINE],
    };
}

static void table(const struct fb_cmap *map, int put)
{
    for (unsigned i = 0; i < map->len && i < 256; i++) {
        unsigned *of[3] = { state->red + i, state->green + i, state->blue + i };
        uint16_t *to[3] = { map->red + i, map->green + i, map->blue + i };
        for (int c = 0; c < 3; c++)
            if (put)
                *of[c] = (unsigned)*to[c];
            else
                *to[c] = (uint16_t)*of[c];
    }
    note(put ? "table %04x %04x %04x\n" : "", state->red[7], state->green[7],
         state->blue[7]);
}

static int frame_buffer(unsigned long request, void *to)
{
    unsigned n[NUMBERS];
    if (!read_numbers(n)) {
        errno = ENOTTY;
        return -1;
    }
    switch (request) {
    case FBIOGET_VSCREENINFO: get_var(to, n); return 0;
    case FBIOGET_FSCREENINFO: get_fix(to, n); return 0;
    case FBIOGETCMAP: table(to, 0); return 0;
    case FBIOPUTCMAP: table(to, 1); return 0;
    case FBIOPAN_DISPLAY:
        while (getenv("FAKE_HANG") && getpid() != state->opener)
            sleep(1);
        state->yoffset = ((struct fb_var_screeninfo *)to)->yoffset;
        note("pan %u\n", state->yoffset);
        return 0;
    default:
        errno = EINVAL;
        return -1;
    }
}

static int terminal(unsigned long request, void *to)
{
    switch (request) {
    case KDGETMODE: *(int *)to = atoi(getenv("FAKE_VT")); return 0;
    case VT_GETMODE: memset(to, 0, sizeof(struct vt_mode)); return 0;
    case VT_SETMODE: note("switching %d\n", ((struct vt_mode *)to)->mode); return 0;
    case KDSETMODE: note("mode %d\n", (int)(intptr_t)to); return 0;
    case VT_RELDISP: note("release %d\n", (int)(intptr_t)to); return 0;
    default: errno = EINVAL; return -1;
    }
}

int fsync(int fd)
{
    (void)fd;
    if (getenv("FAKE_SLOW"))
        sleep(1);
    return 0;
}

int ioctl(int fd, unsigned long request, ...);

int ioctl(int fd, unsigned long request, ...)
{
    int (*real)(int, unsigned long, ...);
    *(void **)&real = dlsym(RTLD_NEXT, "ioctl");
    va_list list;
    va_start(list, request);
    void *to = va_arg(list, void *);
    va_end(list);
    const int is_fb = request >> 8 == 'F';
    if (!is_fb && request >> 8 != 'K' && request >> 8 != 'V')
        return real(fd, request, to);
    if (!is_fb && (fd != 0 || !getenv("FAKE_VT"))) {
        errno = ENOTTY;
        return -1;
    }
    const char *fail = getenv("FAKE_FAIL"), *gone = getenv("FAKE_GONE");
    if (is_fb && gone && access(gone, F_OK) == 0) {
        errno = ENODEV;
        return -1;
    }
    if (fail && ++state->calls == (unsigned)atoi(fail)) {
        note("failed %lx\n", request);
        errno = EIO;
        return -1;
    }
    return is_fb ? frame_buffer(request, to) : terminal(request, to);
}
