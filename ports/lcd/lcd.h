/* SPDX-License-Identifier: MIT */
/* Panels that take commands and data over a few wires: SPI or 8080 displays with a memory
 * of their own, OLEDs and e-paper.
 *
 *     static uint64_t memory[N];                      N: lcd_bytes(&config) / 8
 *     if (lcd_open(&panel, &config, memory)) ...      reset, orientation
 *     tp_frame_begin(frame, &world);
 *     if (lcd_show(&panel, frame, scratch)) ...       every tile, then the update
 *
 * A panel is a table of constants (lcd_panel); the board is four functions (lcd_wires),
 * of which two matter.  Two buffers of one tile each hold what is sent: while one is on
 * the wires the core draws the next tile into its scratch, which is packed into the
 * other.  Nothing here is kept of the world or the frame: after a failure the next frame
 * is whole again. */
#ifndef LCD_H
#define LCD_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/frame.h"

#define LCD_STATUS_LIST(X) \
    X(OK,        "ok") \
    X(E_TURN,    "the panel cannot be turned or mirrored so") \
    X(E_FORMAT,  "the panel shows another pixel format") \
    X(E_SIZE,    "tile or picture of no size, or no part of it on the panel") \
    X(E_PLACE,   "the picture begins or ends within a byte of the panel") \
    X(E_WIRES,   "a function of the wires is missing") \
    X(E_BLOCKED, "the panel does not answer")

typedef enum {
#define X(name, text) LCD_##name,
    LCD_STATUS_LIST(X)
#undef X
    LCD_STATUS_COUNT
} lcd_status;

const char *lcd_status_text(lcd_status status);

/* -- the board ---------------------------------------------------------------------- */

typedef enum {
    LCD_SENT,               /* the bytes of the last data() have left their buffer */
    LCD_IDLE                /* the panel's BUSY line is free: e-paper alone */
} lcd_until;

typedef struct {
    void *user;
    void (*command)(void *user, uint8_t byte);      /* D/C low; returns when it is sent */
    /* D/C high.  May return at once and go on by DMA: the bytes stay until the next wait
     * for LCD_SENT, and nothing else is asked of the wires before it. */
    void (*data)(void *user, const uint8_t *bytes, size_t count);
    /* False: it took too long, and the frame is given up.  NULL: data() returns when all
     * is sent; not for panels with a BUSY line. */
    bool (*wait)(void *user, lcd_until until);
    void (*pause)(void *user, uint32_t ms);
} lcd_wires;

/* -- a panel ------------------------------------------------------------------------ */

/* Commands in a row, each `command, count, argument ...`.  Flags in the count: a byte of
 * milliseconds follows the arguments; BUSY is waited for after them. */
typedef struct {
    const uint8_t *bytes;
    size_t         count;
} lcd_script;
#define LCD_SCRIPT(array) { array, sizeof array }
enum { LCD_PAUSE = 0x80, LCD_BUSY = 0x40, LCD_COUNT = 0x3f };

/* How the memory is walked, in the bits of MADCTL (36h) of MIPI DCS: rows from below,
 * columns from the right, rows and columns exchanged, blue first. */
enum { LCD_MY = 0x80, LCD_MX = 0x40, LCD_MV = 0x20, LCD_BGR = 0x08 };

enum { LCD_ALIGN = 32 };     /* what each buffer is rounded up to: a line of a cache */

enum {
    LCD_LOW_FIRST = 1,      /* addresses of two bytes: the low one first */
    LCD_ALL_COMMANDS = 2    /* arguments are sent as commands are, D/C low */
};

typedef struct {
    uint16_t  cols, rows;           /* the controller's memory, in pixels */
    uint16_t  x, y, width, height;  /* the glass in it, not turned */
    tp_format format;               /* that tiles are drawn in */
    uint8_t   unit;                 /* pixels to a column address: 1, 2, 8 */
    uint8_t   unit_bytes;           /* of them, as sent */
    uint8_t   set_x, set_y;         /* commands: first and last column address, row */
    uint8_t   at_x, at_y;           /* commands: where to begin; 0: there are none */
    uint8_t   write;                /* command before pixels; 0: there is none */
    uint8_t   write_old;            /* e-paper: into the memory of what is shown; or 0 */
    uint8_t   x_bytes, y_bytes;     /* of an address: 1, 2 */
    uint8_t   flags;                /* LCD_LOW_FIRST, LCD_ALL_COMMANDS */
    uint8_t   upright;              /* MX MY BGR that show a picture upright */
    uint8_t   able;                 /* MX MY MV BGR that can be other than that */
    uint8_t   set_turn;             /* command that takes them; 0: there is none */
    uint8_t (*turned)(uint8_t bits);        /* its argument; NULL: the bits */
    lcd_script start;               /* after the reset line */
    lcd_script on;                  /* after the first frame: light, where there is any */
    lcd_script update;              /* after a frame's last tile: whole; empty: none */
    lcd_script partly;              /* the same of what has changed */
    /* `pixels`, a multiple of `unit`, as they are sent; NULL: as they are drawn. */
    void (*pack)(uint8_t *to, const uint8_t *from, uint32_t pixels);
} lcd_panel;

extern const lcd_panel lcd_ili9341, lcd_st7789, lcd_st7789_240x240, lcd_st7789_135x240;
extern const lcd_panel lcd_ssd1680;         /* e-paper, 122x250 */
extern const lcd_panel lcd_ssd0323;         /* OLED of greys, 128x64 */

/* -- the driver ---------------------------------------------------------------------- */

typedef struct {
    const lcd_panel *panel;
    lcd_wires        wires;
    tp_config frame;                /* as the frame is made; the panel's format */
    int16_t          x, y;          /* the picture's corner on the glass as turned; what
                                     * is beside the glass is drawn but not sent */
    uint8_t          turn;          /* quarters, clockwise: 0..3 */
    bool             mirror;        /* left and right exchanged */
    bool             bgr;           /* red and blue exchanged: glass of the other order */
    uint16_t         whole_every;   /* of an e-paper's updates one in so many is whole,
                                     * the others partial; 0, 1: all */
} lcd_config;

typedef struct {
    lcd_config config;
    uint8_t   *buffer[2];
    uint32_t   frames;              /* shown */
    uint32_t   windows;             /* set, ever */
    uint64_t   sent;                /* bytes, ever, commands too */
    /* private */
    int32_t    x0, x1, next;        /* the open window: columns, next row or -1 */
    uint16_t   width, height;       /* of the glass as turned */
    uint16_t   dx, dy;              /* where it begins in the memory walked so */
    uint32_t   since;               /* the last whole update, and that */
    uint8_t    bits, turn;          /* of the walk; the buffer to pack into */
    bool       flying;              /* a data() that was not waited for */
    bool       whole, done;         /* this update is; the last one came to its end */
    uint8_t    arguments[8];
} lcd;

/* What the two buffers take; 0 and the reason: the config is refused. */
size_t lcd_bytes(const lcd_config *config, lcd_status *why);

/* `memory`: lcd_bytes(), aligned as the board's DMA wants it, which may also want it in a
 * certain RAM.  The board has pulled the reset line before, if it has one. */
lcd_status lcd_open(lcd *l, const lcd_config *config, void *memory);

/* The glass in pixels of one byte (e-paper: ffh is white), where the picture leaves some of
 * it free; clear.c.  E-paper shows it with the next frame, which then is whole. */
lcd_status lcd_clear(lcd *l, uint8_t byte);

/* Draws and sends a frame that has begun; `scratch` as for tp_frame_draw_tile().  Returns when
 * the last byte is sent, of e-paper when BUSY is free again. */
lcd_status lcd_show(lcd *l, const tp_frame *frame, void *scratch);

/* The parts of it, for programs with a loop of their own: lcd_begin, lcd_tile for each,
 * in any order, lcd_end.  lcd_tile returns while its bytes are on their way: the tile's
 * memory is free then, the panel's buffer is not. */
void       lcd_begin(lcd *l);
lcd_status lcd_tile(lcd *l, const tp_tile *tile);
lcd_status lcd_end(lcd *l);

/* For e-paper, which cannot be turned by lcd_config.turn: a tile of i1 as it lies in the
 * picture turned by quarters, clockwise, which is then what config.frame describes and
 * lcd_tile takes; turn.c.  `to`: a byte for each eight pixels of a turned row.  Rows of
 * tiles, and the side that becomes the width, are multiples of 8: of 122x250 glass a
 * picture of 250x128 has six rows beside it, the upper ones turned by 1, else the lower. */
tp_tile lcd_turned(const tp_tile *tile, const tp_config *picture, unsigned turn,
                   uint8_t *to);
#endif
