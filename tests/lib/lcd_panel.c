/* SPDX-License-Identifier: MIT */
/* Models of panels; see panel.h. The number of arguments of each command is known and
 * enforced. Pixels fill the window in MADCTL's order and continue at its first corner when
 * the window is full. */
#include "tests/lib/lcd_panel.h"
#include "pixel/pixel.h"
#include <string.h>

enum { DCS_COLS = 240, DCS_ROWS = 320, PAPER_COLS = 176, PAPER_ROWS = 296, ANY = 255 };
enum { MY = 0x80, MX = 0x40, MV = 0x20, BGR = 0x08 };

typedef struct {
    uint8_t code, arguments;    /* ANY: pixels follow */
} known;

static const known dcs[] = {
    { 0x00, 0 }, { 0x01, 0 },   { 0x10, 0 }, { 0x11, 0 }, { 0x13, 0 },
    { 0x20, 0 }, { 0x21, 0 },   { 0x28, 0 }, { 0x29, 0 }, { 0x2a, 4 },
    { 0x2b, 4 }, { 0x2c, ANY }, { 0x36, 1 }, { 0x3a, 1 }, { 0x3c, ANY },
};
static const known ili9341[] = {
    { 0xb1, 2 }, { 0xb6, 3 }, { 0xc0, 1 }, { 0xc1, 1 }, { 0xc5, 2 }, { 0xc7, 1 },
};
static const known ssd1680[] = {
    { 0x01, 3 }, { 0x10, 1 }, { 0x11, 1 },   { 0x12, 0 },   { 0x18, 1 },  { 0x20, 0 },
    { 0x21, 2 }, { 0x22, 1 }, { 0x24, ANY }, { 0x26, ANY }, { 0x37, 10 }, { 0x3c, 1 },
    { 0x44, 2 }, { 0x45, 4 }, { 0x4e, 1 },   { 0x4f, 2 },
};

static void refuse(panel_model *p, const char *why)
{
    p->faults++;
    if (!p->fault)
        p->fault = why;
    p->begun = false;
}

static int find(const known *list, size_t count, uint8_t code)
{
    for (size_t i = 0; i < count; i++)
        if (list[i].code == code)
            return list[i].arguments;
    return -1;
}

/* Number of arguments of a command of this kind of panel; -1: no such command. */
static int arguments_of(panel_model_kind kind, uint8_t code)
{
    int n = kind == PANEL_SSD1680 ? find(ssd1680, sizeof ssd1680 / sizeof *ssd1680, code)
                                  : find(dcs, sizeof dcs / sizeof *dcs, code);
    if (n < 0 && kind == PANEL_ILI9341)
        n = find(ili9341, sizeof ili9341 / sizeof *ili9341, code);
    return n;
}

/* -- MIPI DCS ----------------------------------------------------------------------- */

static void dcs_reset(panel_model *p)
{
    p->reset = true;
    p->awake = p->lit = p->inverted = p->begun = false;
    p->walk = 0;
    p->pixel_size = 0x66;                       /* 18 bits */
    p->x0 = p->y0 = 0;
    p->x1 = DCS_COLS - 1;
    p->y1 = DCS_ROWS - 1;
    p->ready_ms = p->ms + 5;
    p->wake_ms = p->ms + 120;
}

static void dcs_command(panel_model *p, uint8_t code)
{
    if (p->ms < p->ready_ms || (code == 0x11 && p->ms < p->wake_ms))
        refuse(p, "a command too early");
    switch (code) {
    case 0x01: dcs_reset(p); break;
    case 0x10: p->awake = false; p->wake_ms = p->ms + 120; break;
    case 0x11: p->awake = true; p->ready_ms = p->ms + 5; break;
    case 0x20: p->inverted = false; break;
    case 0x21: p->inverted = true; break;
    case 0x28: p->lit = false; break;
    case 0x29: p->lit = true; break;
    case 0x2c:
        p->x = p->x0;
        p->y = p->y0;
        p->begun = true;
        break;
    case 0x3c:
        if (!p->begun)
            refuse(p, "a write goes on that has not begun");
    }
}

static void dcs_range(panel_model *p, uint32_t *first, uint32_t *last, uint32_t side)
{
    const uint8_t *a = p->argument;
    *first = (uint32_t)(a[0] << 8 | a[1]);
    *last = (uint32_t)(a[2] << 8 | a[3]);
    if (*first > *last || *last >= side)
        refuse(p, "a window beyond the memory");
}

static void dcs_arguments(panel_model *p)
{
    const bool swap = p->walk & MV;
    switch (p->command) {
    case 0x2a: dcs_range(p, &p->x0, &p->x1, swap ? DCS_ROWS : DCS_COLS); break;
    case 0x2b: dcs_range(p, &p->y0, &p->y1, swap ? DCS_COLS : DCS_ROWS); break;
    case 0x36: p->walk = p->argument[0]; break;
    case 0x3a: p->pixel_size = p->argument[0]; break;
    }
}

/* Advances to the next pixel of the window, and wraps at its end. */
static void step(panel_model *p)
{
    p->pixels++;
    if (p->x++ < p->x1)
        return;
    p->x = p->x0;
    if (p->y++ < p->y1)
        return;
    p->y = p->y0;
    p->wraps++;
}

static void dcs_pixel(panel_model *p, uint8_t byte)
{
    if (p->pixel_size != 0x55 || !p->begun) {
        refuse(p, p->begun ? "pixels of another size than 16 bits" : "pixels nowhere");
        return;
    }
    p->argument[p->arguments++ & 1] = byte;
    if (p->arguments & 1)
        return;
    uint32_t col = p->walk & MV ? p->y : p->x, row = p->walk & MV ? p->x : p->y;
    if (col >= DCS_COLS || row >= DCS_ROWS) {
        refuse(p, "a pixel beyond the memory");
        return;
    }
    col = p->walk & MX ? DCS_COLS - 1 - col : col;
    row = p->walk & MY ? DCS_ROWS - 1 - row : row;
    p->memory[row * PANEL_COLS + col] = (uint32_t)(p->argument[0] << 8 | p->argument[1]);
    step(p);
}

static uint32_t dcs_seen(const panel_model *p, uint32_t x, uint32_t y)
{
    const bool ili = p->kind == PANEL_ILI9341;
    uint32_t c = p->memory[y * PANEL_COLS + (ili ? DCS_COLS - 1 - x : x)];
    if (!p->lit || !p->awake)
        return PANEL_DARK;
    if (c == PANEL_NOTHING)
        return c;
    if (p->inverted == ili)                     /* only one panel inverts */
        c = ~c & 0xffff;
    const uint32_t r = c >> 11, g = c >> 5 & 63, b = c & 31;
    const uint32_t red = r << 3 | r >> 2, blue = b << 3 | b >> 2;
    const bool right = !(p->walk & BGR) != ili;
    return (right ? red : blue) << 16 | (g << 2 | g >> 4) << 8 | (right ? blue : red);
}

/* -- SSD1680 ------------------------------------------------------------------------ */

/* Update of the e-paper. Mode 1 shows the content of 24h; mode 2 drives the pixels that
 * differ from 26h, and exchanges 24h and 26h on request. */
static void paper_update(panel_model *p)
{
    const bool differing = p->sequence & 0x08;
    if ((p->sequence & 0xc4) != 0xc4) {
        refuse(p, "an update without clock, voltages or display");
        return;
    }
    for (size_t i = 0; i < sizeof p->paper; i++) {
        const uint8_t drive = differing ? p->plane[0][i] ^ p->plane[1][i] : 0xff;
        p->paper[i] = (uint8_t)((p->paper[i] & ~drive) | (p->plane[0][i] & drive));
    }
    if (differing && p->option & 0x40)
        for (size_t i = 0; i < sizeof p->paper; i++) {
            const uint8_t swap = p->plane[0][i];
            p->plane[0][i] = p->plane[1][i];
            p->plane[1][i] = swap;
        }
    p->updates++;
    p->partial += differing;
    p->lit = true;
}

static void paper_command(panel_model *p, uint8_t code)
{
    if (code == 0x12 || code == 0x20)
        p->busy = true;
    if (code == 0x12) {
        p->reset = p->awake = true;
        p->walk = 3;
        p->option = 0;
    } else if (code == 0x20) {
        paper_update(p);
    }
    p->begun = code == 0x24 || code == 0x26;
}

static void paper_arguments(panel_model *p)
{
    const uint8_t *a = p->argument;
    switch (p->command) {
    case 0x10: p->awake = false; break;
    case 0x11: p->walk = a[0]; break;
    case 0x22: p->sequence = a[0]; break;
    case 0x37: p->option = a[5]; break;
    case 0x44: p->x0 = a[0]; p->x1 = a[1]; break;
    case 0x45:
        p->y0 = a[0] | (uint32_t)a[1] << 8;
        p->y1 = a[2] | (uint32_t)a[3] << 8;
        break;
    case 0x4e: p->x = a[0]; break;
    case 0x4f: p->y = a[0] | (uint32_t)a[1] << 8; break;
    }
    if (p->x0 > p->x1 || p->x1 >= PAPER_COLS / 8 || p->y0 > p->y1 || p->y1 >= PAPER_ROWS
        || p->walk != 3)
        refuse(p, "a window beyond the memory, or walked in an order that is not here");
}

static void paper_eight(panel_model *p, uint8_t byte)
{
    if (p->x < p->x0 || p->x > p->x1 || p->y < p->y0 || p->y > p->y1) {
        refuse(p, "pixels beside the window");
        return;
    }
    p->plane[p->command == 0x26][p->y * PANEL_COLS / 8 + p->x] = byte;
    step(p);
}

static uint32_t paper_seen(const panel_model *p, uint32_t x, uint32_t y)
{
    if (!p->lit)
        return PANEL_DARK;
    return p->paper[y * PANEL_COLS / 8 + x / 8] >> (7 - x % 8) & 1 ? 0xffffff : 0;
}

/* -- all panels --------------------------------------------------------------------- */

void panel_power(panel_model *p, panel_model_kind kind)
{
    memset(p, 0, sizeof *p);
    p->kind = kind;
    p->command = -1;
    for (size_t i = 0; i < sizeof p->memory / sizeof *p->memory; i++)
        p->memory[i] = PANEL_NOTHING;
    for (size_t i = 0; i < sizeof p->paper; i++) {
        p->plane[0][i] = (uint8_t)(i * 37);             /* content after power on */
        p->plane[1][i] = (uint8_t)(i * 101 + 7);
        p->paper[i] = (uint8_t)(i * 59 + 3);
    }
}

static void take_command(panel_model *p, uint8_t code)
{
    const bool paper = p->kind == PANEL_SSD1680;
    const int before = p->command < 0 ? 0 : arguments_of(p->kind, (uint8_t)p->command);
    if (before == ANY ? !paper && p->arguments & 1 : (int)p->arguments < before)
        refuse(p, "a command cut short");
    if (arguments_of(p->kind, code) < 0)
        refuse(p, "no such command");
    if (!p->reset && code != (paper ? 0x12 : 0x01))
        refuse(p, "a command before the reset");
    p->command = code;
    p->arguments = 0;
    (paper ? paper_command : dcs_command)(p, code);
}

static void take_data(panel_model *p, uint8_t byte)
{
    const bool paper = p->kind == PANEL_SSD1680;
    const int count = p->command < 0 ? 0 : arguments_of(p->kind, (uint8_t)p->command);
    if (count == ANY) {
        (paper ? paper_eight : dcs_pixel)(p, byte);
    } else if ((int)p->arguments >= count) {
        refuse(p, "data that no command asked for");
    } else {
        p->argument[p->arguments++] = byte;
        if ((int)p->arguments == count)
            (paper ? paper_arguments : dcs_arguments)(p);
    }
}

void panel_byte(panel_model *p, bool data, uint8_t byte)
{
    p->bytes++;
    if (p->busy)
        refuse(p, "a byte while BUSY");
    (data ? take_data : take_command)(p, byte);
}

void panel_pause(panel_model *p, uint32_t ms)
{
    p->ms += ms;
}

void panel_idle(panel_model *p)
{
    p->busy = false;
}

uint32_t panel_seen(const panel_model *p, uint32_t x, uint32_t y)
{
    return p->kind == PANEL_SSD1680 ? paper_seen(p, x, y) : dcs_seen(p, x, y);
}

static void take_oldest(panel_model *p)
{
    const panel_transfer t = p->pending[0];
    if (tp_crc32(0, t.bytes, t.count) != t.crc)
        p->overwritten++;
    for (size_t i = 0; i < t.count; i++)
        panel_byte(p, true, t.bytes[i]);
    p->waiting--;
    memmove(p->pending, p->pending + 1, p->waiting * sizeof *p->pending);
}

void panel_send(panel_model *p, const uint8_t *bytes, size_t count)
{
    p->pending[p->waiting++] = (panel_transfer){ bytes, count, tp_crc32(0, bytes, count) };
    while (p->waiting > p->late)
        take_oldest(p);
}

void panel_settle(panel_model *p)
{
    while (p->waiting)
        take_oldest(p);
}
