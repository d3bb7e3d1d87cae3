/* SPDX-License-Identifier: MIT */
/* The driver of all panels: windows, strips, bands and two buffers.
 *
 * A window extends from a tile's first row to the picture's last row: bands as wide as the
 * picture follow without another command; a strip beside the last one sets its own window.
 * Each frame sets its first window anew: a byte lost by the panel spoils one frame only.
 *
 * At most one transfer is in progress, and tiles are packed into the other buffer.  This
 * also holds after a wait that timed out: until a wait succeeds nothing is sent, and the
 * buffers are not exchanged. */
#include "lcd.h"

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

enum { NONE = -1 };

#define TRY(call) \
    do { \
        const lcd_status status_ = (call); \
        if (status_ != LCD_OK) \
            return status_; \
    } while (0)

/* Visible part of a tile in glass coordinates, x0 .. y1, and the pixels of the tile cut
 * off before it. */
typedef struct {
    int32_t x0, y0, x1, y1, skip_x, skip_y;
} lcd_part;

/* -- checks of the config ------------------------------------------------------------ */

/* Returns the walk of a turned picture over the glass, relative to upright.  Turned by one
 * quarter, picture rows run down the glass, the first row on the right. */
static uint8_t walk(const lcd_config *c)
{
    static const uint8_t quarter[4] = { 0, LCD_MX | LCD_MV, LCD_MX | LCD_MY,
                                        LCD_MY | LCD_MV };
    unsigned bits = quarter[c->turn & 3];
    if (c->mirror)
        bits ^= bits & LCD_MV ? LCD_MY : LCD_MX;
    return (uint8_t)(c->bgr ? bits ^ LCD_BGR : bits);
}

static uint32_t units(const lcd_panel *p, uint32_t pixels)
{
    return (pixels + p->unit - 1) / p->unit;
}

static void place_glass(lcd *l)
{
    const lcd_panel *p = l->config.panel;
    const bool swap = l->bits & LCD_MV;
    const int x = l->bits & LCD_MX ? p->cols - p->x - p->width : p->x;
    const int y = l->bits & LCD_MY ? p->rows - p->y - p->height : p->y;
    l->width = swap ? p->height : p->width;
    l->height = swap ? p->width : p->height;
    l->dx = (uint16_t)(swap ? y : x);
    l->dy = (uint16_t)(swap ? x : y);
}

static lcd_status check(const lcd_config *c)
{
    const lcd_panel *p = c->panel;
    const tp_config *f = &c->frame;
    const unsigned bits = walk(c);
    const bool swap = bits & LCD_MV;
    if (!c->wires.command || !c->wires.data || !c->wires.pause
        || (p->update.count && !c->wires.wait))
        return LCD_E_WIRES;
    if (c->turn > 3 || (bits & ~(unsigned)p->able))
        return LCD_E_TURN;
    if (f->format != p->format)
        return LCD_E_FORMAT;
    if (tp_config_check(f, NULL, NULL) != TP_OK || c->x >= (swap ? p->height : p->width)
        || c->y >= (swap ? p->width : p->height) || c->x + (int32_t)f->width <= 0
        || c->y + (int32_t)f->height <= 0)
        return LCD_E_SIZE;
    if (c->x % p->unit || (p->pack && f->width % p->unit))
        return LCD_E_PLACE;
    return LCD_OK;
}

static size_t buffer_bytes(const lcd_config *c)
{
    tp_config f;
    tp_config_check(&c->frame, &f, NULL);
    const size_t row = (size_t)units(c->panel, f.tile_width) * c->panel->unit_bytes;
    return (row * f.tile_height + LCD_ALIGN - 1) / LCD_ALIGN * LCD_ALIGN;
}

size_t lcd_bytes(const lcd_config *config, lcd_status *why)
{
    const lcd_status status = check(config);
    if (why)
        *why = status;
    return status == LCD_OK ? 2 * buffer_bytes(config) : 0;
}

/* -- commands ------------------------------------------------------------------------ */

static lcd_status await_wires(lcd *l, lcd_until until)
{
    const lcd_wires *w = &l->config.wires;
    return !w->wait || w->wait(w->user, until) ? LCD_OK : LCD_E_BLOCKED;
}

/* Waits until no transfer is in progress. */
static lcd_status settle(lcd *l)
{
    const lcd_status status = l->flying ? await_wires(l, LCD_SENT) : LCD_OK;
    l->flying = status != LCD_OK;
    return status;
}

static void command(lcd *l, uint8_t byte)
{
    l->sent++;
    l->config.wires.command(l->config.wires.user, byte);
}

static void fly(lcd *l, const uint8_t *bytes, size_t count)
{
    l->flying = true;
    l->sent += count;
    l->config.wires.data(l->config.wires.user, bytes, count);
}

static lcd_status order(lcd *l, uint8_t code, const uint8_t *arguments, size_t count)
{
    TRY(settle(l));
    command(l, code);
    if (l->config.panel->flags & LCD_ALL_COMMANDS)
        for (; count; count--)
            command(l, *arguments++);
    else if (count)
        fly(l, arguments, count);
    return settle(l);
}

static lcd_status run(lcd *l, lcd_script script)
{
    const uint8_t *at = script.bytes;
    while (at < script.bytes + script.count) {
        const uint8_t code = at[0], flags = at[1], count = flags & LCD_COUNT;
        TRY(order(l, code, at + 2, count));
        at += 2 + count;
        if (flags & LCD_PAUSE)
            l->config.wires.pause(l->config.wires.user, *at++);
        if (flags & LCD_BUSY)
            TRY(await_wires(l, LCD_IDLE));
    }
    return LCD_OK;
}

lcd_status lcd_open(lcd *l, const lcd_config *config, void *memory)
{
    const lcd_panel *p = config->panel;
    TRY(check(config));
    *l = (lcd){ .config = *config };
    tp_config_check(&config->frame, &l->config.frame, NULL);
    l->buffer[0] = memory;
    l->buffer[1] = l->buffer[0] + buffer_bytes(config);
    l->bits = walk(config) ^ p->upright;
    place_glass(l);
    l->arguments[0] = p->turned ? p->turned(l->bits) : l->bits;
    TRY(run(l, p->start));
    return p->set_turn ? order(l, p->set_turn, l->arguments, 1) : LCD_OK;
}

/* -- pixels -------------------------------------------------------------------------- */

static uint8_t *put(const lcd *l, uint8_t *to, uint32_t value, unsigned bytes)
{
    const unsigned low = l->config.panel->flags & LCD_LOW_FIRST ? 0 : bytes - 1;
    to[bytes - 1 - low] = (uint8_t)(value >> 8);
    to[low] = (uint8_t)value;
    return to + bytes;
}

/* Sends an address command: `first`, and `last` unless negative. */
static lcd_status address(lcd *l, uint8_t code, uint32_t first, int32_t last,
                          unsigned bytes)
{
    uint8_t *end = put(l, l->arguments, first, bytes);
    if (last >= 0)
        end = put(l, end, (uint32_t)last, bytes);
    return code ? order(l, code, l->arguments, (size_t)(end - l->arguments)) : LCD_OK;
}

static lcd_status open_window(lcd *l, const lcd_part *w, uint8_t write)
{
    const lcd_panel *p = l->config.panel;
    const uint32_t x = (l->dx + (uint32_t)w->x0) / p->unit, y = l->dy + (uint32_t)w->y0;
    const uint32_t count = units(p, (uint32_t)(w->x1 - w->x0));
    const int32_t bottom = l->config.y + (int32_t)l->config.frame.height;
    const int32_t end = l->dy + (bottom < l->height ? bottom : l->height);
    l->next = NONE;
    TRY(address(l, p->set_x, x, (int32_t)(x + count) - 1, p->x_bytes));
    TRY(address(l, p->set_y, y, end - 1, p->y_bytes));
    TRY(address(l, p->at_x, x, NONE, p->x_bytes));
    TRY(address(l, p->at_y, y, NONE, p->y_bytes));
    if (write)
        TRY(order(l, write, NULL, 0));
    l->x0 = w->x0;
    l->x1 = w->x1;
    l->windows++;
    return LCD_OK;
}

static lcd_part seen(const lcd *l, const tp_tile *t)
{
    const int32_t x = l->config.x + (int32_t)t->x0, x1 = l->config.x + (int32_t)t->x1;
    const int32_t y = l->config.y + (int32_t)t->y0, y1 = l->config.y + (int32_t)t->y1;
    return (lcd_part){
        .x0 = x > 0 ? x : 0, .x1 = x1 < l->width ? x1 : l->width,
        .y0 = y > 0 ? y : 0, .y1 = y1 < l->height ? y1 : l->height,
        .skip_x = x < 0 ? -x : 0, .skip_y = y < 0 ? -y : 0,
    };
}

/* Packs the visible part of a tile, row after row; returns the bytes. */
static size_t pack(const lcd *l, uint8_t *to, const tp_tile *tile, const lcd_part *w)
{
    const lcd_panel *p = l->config.panel;
    const uint32_t count = units(p, (uint32_t)(w->x1 - w->x0));
    const size_t bytes = (size_t)count * p->unit_bytes;
    const uint8_t *from = (const uint8_t *)tile->pixels
                        + (size_t)w->skip_y * tile->stride
                        + tp_format_row_bytes(p->format, w->skip_x);
    uint8_t *row = to;
    for (int32_t y = w->y0; y < w->y1; y++, from += tile->stride, row += bytes)
        if (p->pack)
            p->pack(row, from, count * p->unit);
        else
            memcpy(row, from, bytes);
    return (size_t)(row - to);
}

/* -- frames -------------------------------------------------------------------------- */

void lcd_begin(lcd *l)
{
    l->next = NONE;
    l->whole = !l->done || l->since >= l->config.whole_every;
    l->done = false;
}

lcd_status lcd_tile(lcd *l, const tp_tile *tile)
{
    const lcd_panel *p = l->config.panel;
    const tp_config *f = &l->config.frame;
    const lcd_part w = seen(l, tile);
    uint8_t *const buffer = l->buffer[l->turn];
    if (tile->x1 - tile->x0 > f->tile_width || tile->y1 - tile->y0 > f->tile_height)
        return LCD_E_SIZE;
    if (w.x0 >= w.x1 || w.y0 >= w.y1)
        return LCD_OK;                                  /* outside of the glass */
    const size_t bytes = pack(l, buffer, tile, &w);
    if (p->write_old && l->whole) {
        TRY(open_window(l, &w, p->write_old));
        fly(l, buffer, bytes);
    }
    TRY(settle(l));
    if (w.y0 != l->next || w.x0 != l->x0 || w.x1 != l->x1)
        TRY(open_window(l, &w, p->write));
    fly(l, buffer, bytes);
    l->next = w.y1;
    l->turn ^= 1;
    return LCD_OK;
}

lcd_status lcd_end(lcd *l)
{
    const lcd_panel *p = l->config.panel;
    TRY(settle(l));
    TRY(run(l, l->whole ? p->update : p->partly));
    if (!l->frames)
        TRY(run(l, p->on));
    l->since = l->whole ? 1 : l->since + 1;
    l->done = true;
    l->frames++;
    return LCD_OK;
}

lcd_status lcd_show(lcd *l, const tp_frame *frame, void *scratch)
{
    tp_tile tile;
    lcd_begin(l);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        TRY(lcd_tile(l, &tile));
    return lcd_end(l);
}
