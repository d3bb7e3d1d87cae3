/* SPDX-License-Identifier: MIT */
/* Panels that take commands and data over a few wires: SPI or 8080 displays with their own
 * memory, OLEDs and e-paper.
 *
 *     static uint64_t memory[N];                      N: lcd_bytes(&config) / 8
 *     if (lcd_open(&panel, &config, memory)) ...      reset, orientation
 *     tp_frame_begin(frame, &world);
 *     if (lcd_show(&panel, frame, scratch)) ...       every tile, then the update
 *
 * A panel is a table of constants (lcd_panel).  A board is four functions (lcd_wires), two
 * of them essential.  Two buffers of one tile each hold outgoing data: while one is on the
 * wires, the core draws the next tile into its scratch, and the tile is packed into the
 * other buffer.  The driver stores nothing of the world or the frame: after a failure the
 * next frame is complete again. */
#ifndef TP_LCD_LCD_H
#define TP_LCD_LCD_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/frame.h"

#define LCD_STATUS_LIST(X) \
    X(OK,        "ok") \
    X(E_TURN,    "the panel cannot be turned or mirrored this way") \
    X(E_FORMAT,  "the panel shows another pixel format") \
    X(E_SIZE,    "tile or picture is empty or outside the panel") \
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

/* -- the board's wires --------------------------------------------------------------- */

typedef enum {
    LCD_SENT,               /* the bytes of the last data() have left their buffer */
    LCD_IDLE                /* the panel's BUSY line is free; e-paper only */
} lcd_until;

typedef struct {
    void *user;
    void (*command)(void *user, uint8_t byte);      /* D/C low; returns after sending */
    /* D/C high.  May return at once and continue by DMA: the bytes stay valid until the
     * next wait for LCD_SENT, and no other function of the wires is called before that
     * wait. */
    void (*data)(void *user, const uint8_t *bytes, size_t count);
    /* Returns false after a timeout; the frame is then given up.  NULL: data() returns
     * when all bytes are sent; not for panels with a BUSY line. */
    bool (*wait)(void *user, lcd_until until);
    void (*pause)(void *user, uint32_t ms);
} lcd_wires;

/* -- panel descriptions -------------------------------------------------------------- */

/* A sequence of commands, each `command, count, argument ...`.  Flags in the count:
 * LCD_PAUSE: a byte of milliseconds follows the arguments; LCD_BUSY: wait for the BUSY
 * line. */
typedef struct {
    const uint8_t *bytes;
    size_t         count;
} lcd_script;
#define LCD_SCRIPT(array) { array, sizeof array }
enum { LCD_PAUSE = 0x80, LCD_BUSY = 0x40, LCD_COUNT = 0x3f };

/* Order of pixels in the memory, bits of MADCTL (36h) of MIPI DCS: rows from below,
 * columns from the right, rows and columns exchanged, blue first. */
enum { LCD_MY = 0x80, LCD_MX = 0x40, LCD_MV = 0x20, LCD_BGR = 0x08 };

enum { LCD_ALIGN = 32 };     /* size alignment of buffers: one cache line */

enum {
    LCD_LOW_FIRST = 1,      /* two-byte addresses: low byte first */
    LCD_ALL_COMMANDS = 2    /* arguments are sent like commands, D/C low */
};

typedef struct {
    uint16_t  cols, rows;           /* size of the controller's memory, px */
    uint16_t  x, y, width, height;  /* the glass in the memory, not turned, px */
    tp_format format;               /* pixel format of tiles */
    uint8_t   unit;                 /* pixels per column address: 1, 2, 8 */
    uint8_t   unit_bytes;           /* bytes per unit, as sent */
    uint8_t   set_x, set_y;         /* commands: first and last column or row address */
    uint8_t   at_x, at_y;           /* commands: start address; 0: none */
    uint8_t   write;                /* command before pixels; 0: none */
    uint8_t   write_old;            /* e-paper: writes the shown image's memory; or 0 */
    uint8_t   x_bytes, y_bytes;     /* bytes of an address: 1, 2 */
    uint8_t   flags;                /* LCD_LOW_FIRST, LCD_ALL_COMMANDS */
    uint8_t   upright;              /* MX MY BGR bits of an upright picture */
    uint8_t   able;                 /* changeable MX MY MV BGR bits */
    uint8_t   set_turn;             /* command to set the bits; 0: none */
    uint8_t (*turned)(uint8_t bits);        /* converts bits to its argument; NULL: as is */
    lcd_script start;               /* sent after the reset line */
    lcd_script on;                  /* sent after the first frame: light, if any */
    lcd_script update;              /* sent after a frame's last tile; empty: none */
    lcd_script partly;              /* the same for a partial update */
    /* Converts `pixels`, a multiple of `unit`, to the sent format; NULL: sent as drawn. */
    void (*pack)(uint8_t *to, const uint8_t *from, uint32_t pixels);
} lcd_panel;

extern const lcd_panel lcd_ili9341, lcd_st7789, lcd_st7789_240x240, lcd_st7789_135x240;
extern const lcd_panel lcd_ssd1680;         /* e-paper, 122x250 */
extern const lcd_panel lcd_ssd0323;         /* greyscale OLED, 128x64 */

/* -- the driver ---------------------------------------------------------------------- */

typedef struct {
    const lcd_panel *panel;
    lcd_wires        wires;
    tp_config        frame;         /* config of the frame; in the panel's format */
    int16_t          x, y;          /* picture's corner on the turned glass; pixels outside
                                     * of the glass are drawn but not sent */
    uint8_t          turn;          /* quarter turns, clockwise: 0..3 */
    bool             mirror;        /* exchanges left and right */
    bool             bgr;           /* exchanges red and blue */
    uint16_t         whole_every;   /* e-paper: one of so many updates is whole, the others
                                     * are partial; 0, 1: all are whole */
} lcd_config;

typedef struct {
    lcd_config config;
    uint8_t   *buffer[2];
    uint32_t   frames;              /* frames shown */
    uint32_t   windows;             /* windows set since lcd_open */
    uint64_t   sent;                /* bytes sent since lcd_open, with commands */
    /* -- private part -- */
    int32_t    x0, x1, next;        /* the open window: columns, next row or -1 */
    uint16_t   width, height;       /* of the turned glass, px */
    uint16_t   dx, dy;              /* start of the glass in the walked memory */
    uint32_t   since;               /* frames since the last whole update, included */
    uint8_t    bits, turn;          /* bits of the walk; buffer to pack into */
    bool       flying;              /* a data() without a wait yet */
    bool       whole, done;         /* this update is whole; the last one ended well */
    uint8_t    arguments[8];
} lcd;

/* Returns the bytes of both buffers; 0: the config is refused, *why is the reason. */
size_t lcd_bytes(const lcd_config *config, lcd_status *why);

/* Resets and configures the panel.  `memory`: lcd_bytes(), aligned and located as the
 * board's DMA requires.  The board has pulsed the reset line before, if it has one. */
lcd_status lcd_open(lcd *l, const lcd_config *config, void *memory);

/* Fills the glass with pixels of one byte (e-paper: ffh is white), for pictures smaller
 * than the glass; clear.c.  E-paper shows the fill with the next frame, a whole update. */
lcd_status lcd_clear(lcd *l, uint8_t byte);

/* Draws and sends a frame that has begun; `scratch` as for tp_frame_draw_tile().  Returns
 * when the last byte is sent; on e-paper when BUSY is free again. */
lcd_status lcd_show(lcd *l, const tp_frame *frame, void *scratch);

/* The steps of lcd_show, for programs with their own loop: lcd_begin, lcd_tile for each
 * tile in any order, lcd_end.  lcd_tile returns while its bytes are in transfer: the
 * tile's memory is free then, the panel's buffer is not. */
void       lcd_begin(lcd *l);
lcd_status lcd_tile(lcd *l, const tp_tile *tile);
lcd_status lcd_end(lcd *l);

/* Turns a tile of i1 by quarters, clockwise, for e-paper, which lcd_config.turn cannot
 * turn.  The result is a tile of the turned picture; config.frame describes that picture,
 * and lcd_tile takes the result.  `to`: one byte for each eight pixels of a turned row.
 * Tile rows, and the side that becomes the width, are multiples of 8: on 122x250 glass a
 * picture of 250x128 has six rows outside of the glass, the upper rows if turned by 1,
 * else the lower. */
tp_tile lcd_turned(const tp_tile *tile, const tp_config *picture, unsigned turn,
                   uint8_t *to);
#endif
