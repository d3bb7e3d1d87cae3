/* SPDX-License-Identifier: MIT */
/* /dev/fb0: the frame buffer device of Linux, mapped into memory.
 *
 * The current mode is kept: 8, 16, 24 or 32 bits per pixel, channels and line length as
 * described by the driver (app/fullscreen/pixel_layout.h).  If the memory holds two
 * screens, pictures are written to the hidden page, and the display is panned to it; not
 * with DRM drivers, which copy the first page only.  Otherwise pictures are written into
 * the visible page during the vertical blank. close() restores the former content of the
 * screen. */
#define _GNU_SOURCE             /* for flock, memmem */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/fullscreen/pixel_layout.h"
#include "app/fullscreen/screen.h"
#include "pixel/pixel.h"

typedef struct { uint16_t red[256], green[256], blue[256]; } colours;

struct screen {
    const char *device;
    int       fd;
    struct fb_var_screeninfo var;       /* both as found at the start */
    struct fb_fix_screeninfo fix;
    colours   found;                    /* colour table as found */
    bool      tabled;                   /* has a colour table, for indices or per channel */
    int       table_of;                 /* format with its table set, -1: none */
    pixel_layout layout;
    uint32_t  width, height;            /* of pictures, px */
    uint8_t  *map, *saved;              /* saved: former content */
    uint8_t  *row;                      /* a row being converted: the map is slow to
                                         * write */
    bool      pan, blank, away;         /* pan: two pages; blank: FBIO_WAITFORVSYNC works */
    bool      shown;                    /* after the first picture a failure is EXIT_LOST */
    uint32_t  page, cleared;            /* page: the visible one; cleared: bit per page
                                         * with black borders */
};

static int refuse(const screen *s, const char *what)
{
    return log_fail(s->shown ? EXIT_LOST : EXIT_DISPLAY, "%s: %s: %s", s->device, what,
                    strerror(errno));
}

/* -- detection ----------------------------------------------------------------------- */

static pixel_channel make_channel(const struct fb_bitfield *field)
{
    return (pixel_channel){ (uint8_t)(field->offset < 255 ? field->offset : 255),
                            (uint8_t)(field->length < 255 ? field->length : 255) };
}

static bool describe(screen *s)
{
    const struct fb_var_screeninfo *v = &s->var;
    const uint32_t visual = s->fix.visual;
    const bool indexed = visual == FB_VISUAL_PSEUDOCOLOR && !v->grayscale;
    s->tabled = visual == FB_VISUAL_PSEUDOCOLOR || visual == FB_VISUAL_DIRECTCOLOR;
    if (s->fix.type != FB_TYPE_PACKED_PIXELS || v->nonstd || v->grayscale > 1
        || (!s->tabled && !v->grayscale && visual != FB_VISUAL_TRUECOLOR))
        return false;
    s->layout = (pixel_layout){
        .bits = v->bits_per_pixel, .indexed = indexed, .grey = v->grayscale == 1,
        .big = machine_is_big(), .red = make_channel(&v->red),
        .green = make_channel(&v->green), .blue = make_channel(&v->blue),
        .spare = make_channel(&v->transp),
    };
    return pixel_layout_is_supported(&s->layout);
}

static size_t pixel_bytes(const screen *s)
{
    return s->layout.bits / 8;
}

/* True if the mapped memory holds the whole screen. */
static bool fits(const screen *s)
{
    const uint64_t rows = (uint64_t)s->var.yoffset + s->var.yres, line = s->fix.line_length;
    return line >= (s->var.xoffset + (uint64_t)s->var.xres) * pixel_bytes(s)
        && rows * line <= s->fix.smem_len;
}

static int look(screen *s)
{
    const struct fb_var_screeninfo *v = &s->var;
    if (ioctl(s->fd, FBIOGET_VSCREENINFO, &s->var)
        || ioctl(s->fd, FBIOGET_FSCREENINFO, &s->fix))
        return errno == ENOTTY || errno == EINVAL
                   ? log_fail(EXIT_DISPLAY, "%s: is not a frame buffer", s->device)
                   : refuse(s, "its mode");
    if (!describe(s) || !fits(s))
        return log_fail(EXIT_DISPLAY, "%s: unknown pixel layout: %u bits, red %u/%u,"
                    " green %u/%u, blue %u/%u, visual %u, %ux%u, lines of %u bytes",
                    s->device, v->bits_per_pixel, v->red.offset, v->red.length,
                    v->green.offset, v->green.length, v->blue.offset, v->blue.length,
                    s->fix.visual, v->xres, v->yres, s->fix.line_length);
    s->pan = s->fix.ypanstep > 0 && v->yres % s->fix.ypanstep == 0 && v->xoffset == 0
        && !memmem(s->fix.id, sizeof s->fix.id, "drm", 3) && v->yres_virtual >= 2 * v->yres
        && 2 * (uint64_t)v->yres * s->fix.line_length <= s->fix.smem_len;
    return EXIT_DONE;
}

static int choose_size(screen *s, uint32_t width, uint32_t height)
{
    s->width = width ? width : s->var.xres;
    s->height = height ? height : s->var.yres;
    if (s->width <= s->var.xres && s->height <= s->var.yres)
        return EXIT_DONE;
    return log_fail(EXIT_DISPLAY, "%s: %ux%u pixels, smaller than the picture of %ux%u",
                    s->device, s->var.xres, s->var.yres, s->width, s->height);
}

/* -- colour table -------------------------------------------------------------------- */

static int table_call(const screen *s, unsigned long request, colours *c)
{
    struct fb_cmap map = { 0, 256, c->red, c->green, c->blue, NULL };
    return ioctl(s->fd, request, &map);
}

/* Sets the table: the format's colours for indices, a linear ramp for channels. */
static int set_table(screen *s, tp_format format)
{
    colours c;
    const int of = s->layout.indexed ? (int)format : 0;
    if (!s->tabled || s->table_of == of)
        return EXIT_DONE;
    pixel_layout_table(s->layout.indexed ? format : TP_FORMAT_L8, c.red, c.green, c.blue);
    s->table_of = of;
    return table_call(s, FBIOPUTCMAP, &c) ? refuse(s, "its colours") : EXIT_DONE;
}

/* -- pictures ------------------------------------------------------------------------ */

/* Returns the first line of the page for the next picture. */
static uint32_t first_line(const screen *s)
{
    return s->pan ? (1 - s->page) * s->var.yres : s->var.yoffset;
}

static uint8_t *line(const screen *s, uint32_t y)
{
    return s->map + (first_line(s) + (size_t)y) * s->fix.line_length
         + s->var.xoffset * pixel_bytes(s);
}

/* Writes a picture centred with a black border; index 0 is black in every colour table. */
static void write_page(screen *s, const picture *p)
{
    const size_t bytes = pixel_bytes(s), left = (s->var.xres - p->width) / 2 * bytes;
    const uint32_t top = (s->var.yres - p->height) / 2, bit = s->pan ? 2u - s->page : 1u;
    for (uint32_t y = 0; y < s->var.yres && !(s->cleared & bit); y++)
        memset(line(s, y), 0, s->var.xres * bytes);
    s->cleared |= bit;
    for (uint32_t y = 0; y < p->height; y++) {
        pixel_layout_row(&s->layout, s->row, p, y);
        memcpy(line(s, top + y) + left, s->row, p->width * bytes);
    }
}

static void wait_blank(screen *s)
{
    uint32_t zero = 0;
    if (s->blank)
        s->blank = ioctl(s->fd, FBIO_WAITFORVSYNC, &zero) == 0;
}

static bool pan(screen *s)
{
    struct fb_var_screeninfo to = s->var;
    to.yoffset = first_line(s);
    s->pan = ioctl(s->fd, FBIOPAN_DISPLAY, &to) == 0;
    s->page = s->pan ? 1 - s->page : 0;
    s->cleared = s->pan ? s->cleared : 0;
    return s->pan;
}

/* True if the display was unplugged.  Its memory stays mapped, but each call fails with
 * ENODEV. */
static bool is_gone(const screen *s)
{
    struct fb_var_screeninfo now;
    return ioctl(s->fd, FBIOGET_VSCREENINFO, &now) != 0 && errno == ENODEV;
}

/* Shows a picture.  If panning fails, only one page is used from now on. */
static int fb_show(screen *s, const picture *p)
{
    if (is_gone(s))
        return refuse(s, "the display is lost");
    if (!pixel_layout_accepts(&s->layout, p->format))
        return log_fail(EXIT_DISPLAY, "%s: 8 bits a pixel take %sl8 or i1, not %s",
                        s->device, s->layout.grey ? "" : "p8, ",
                        tp_format_name(p->format));
    const int code = set_table(s, p->format);
    if (code)
        return code;
    s->shown = true;
    if (s->pan)
        write_page(s, p);
    const bool panned = s->pan && pan(s);
    wait_blank(s);
    if (!panned)
        write_page(s, p);
    return EXIT_DONE;
}

static void fb_size(const screen *s, uint32_t *width, uint32_t *height)
{
    *width = s->width;
    *height = s->height;
}

static tp_format fb_format(const screen *s)
{
    return pixel_layout_format(&s->layout);
}

/* Restores the colour table, shared by all consoles: text consoles set only a few
 * entries. */
static int fb_away(screen *s)
{
    s->away = true;
    if (s->tabled)
        (void)table_call(s, FBIOPUTCMAP, &s->found);
    return EXIT_DONE;
}

/* Meanwhile the console may have written to the memory and changed the table. */
static int fb_back(screen *s)
{
    s->away = false;
    s->cleared = 0;
    s->table_of = -1;
    return EXIT_DONE;
}

/* -- beginning and end --------------------------------------------------------------- */

/* Returns the memory to be written: the visible rows, or both pages. */
static uint8_t *touched(const screen *s, size_t *bytes)
{
    const size_t of_line = s->fix.line_length;
    *bytes = (s->pan ? 2 : 1) * of_line * s->var.yres;
    return s->map + (s->pan ? 0 : s->var.yoffset) * of_line;
}

static void restore(screen *s)
{
    size_t bytes;
    uint8_t *to = touched(s, &bytes);
    memcpy(to, s->saved, bytes);
    if (s->pan)
        (void)ioctl(s->fd, FBIOPAN_DISPLAY, &s->var);
    (void)fb_away(s);
}

static void fb_close(screen *s)
{
    if (s->saved && !s->away)
        restore(s);
    if (s->map)
        munmap(s->map, s->fix.smem_len);
    if (s->fd >= 0)
        close(s->fd);
    free(s->saved);
    free(s->row);
    free(s);
}

static int save(screen *s)
{
    size_t bytes;
    if (s->tabled && table_call(s, FBIOGETCMAP, &s->found))
        return refuse(s, "its colours");
    void *at = mmap(NULL, s->fix.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, s->fd, 0);
    if (at == MAP_FAILED)
        return refuse(s, "its memory");
    s->map = at;
    s->row = malloc(s->width * pixel_bytes(s));
    const uint8_t *found = touched(s, &bytes);
    s->saved = s->row ? malloc(bytes) : NULL;
    if (!s->saved)
        return log_fail_memory(bytes);
    memcpy(s->saved, found, bytes);
    s->page = s->var.yoffset >= s->var.yres;
    return EXIT_DONE;
}

static int fb_open(screen **to, const char *device, uint32_t width, uint32_t height)
{
    screen *s = calloc(1, sizeof *s);
    if (!s)
        return log_fail_memory(sizeof *s);
    *to = s;
    *s = (screen){ .device = device, .blank = true, .table_of = -1,
                   .fd = open(device, O_RDWR | O_CLOEXEC) };
    int code = s->fd < 0 ? refuse(s, "cannot be opened") : EXIT_DONE;
    if (!code && flock(s->fd, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK)
        code = log_fail(EXIT_DISPLAY, "%s: busy, another program shows a scene on it",
                        device);
    code = code ? code : look(s);
    code = code ? code : choose_size(s, width, height);
    code = code ? code : save(s);
    if (code)
        fb_close(s);
    return code;
}

const screen_port screen_fb = {
    .name = "fb", .device = "/dev/fb0",
    .open = fb_open, .size = fb_size, .show = fb_show, .format = fb_format,
    .away = fb_away, .back = fb_back, .close = fb_close,
};
