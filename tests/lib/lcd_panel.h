/* SPDX-License-Identifier: MIT */
/* Models of panels driven by the bytes on the wires: ILI9341 and ST7789 (MIPI DCS, 16 bits
 * a pixel) and SSD1680 (e-paper). The models share no code with the driver and follow the
 * data sheets; each byte that a data sheet does not allow is a fault. */
#ifndef TP_TESTS_LIB_LCD_PANEL_H
#define TP_TESTS_LIB_LCD_PANEL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum { PANEL_ILI9341, PANEL_ST7789, PANEL_SSD1680 } panel_model_kind;

enum { PANEL_COLS = 240, PANEL_ROWS = 320, PANEL_PENDING = 4 };

/* Colours of the glass without a picture: off or asleep, and never written. */
#define PANEL_DARK   0xff000000u
#define PANEL_NOTHING 0xdead0000u

typedef struct {
    const uint8_t *bytes;
    size_t         count;
    uint32_t       crc;                 /* CRC at hand-over */
} panel_transfer;

typedef struct {
    panel_model_kind kind;
    uint32_t    ms, ready_ms, wake_ms;  /* now; earliest for commands; for SLPOUT */
    bool        reset, awake, lit, inverted, busy;
    int         command;                /* -1: none yet */
    uint8_t     argument[16];
    uint32_t    arguments;              /* received arguments of the command */
    uint8_t     walk, pixel_size;       /* MADCTL or data entry; COLMOD */
    uint32_t    x0, x1, y0, y1;         /* window set by commands */
    uint32_t    x, y;                   /* next pixel or byte in the window */
    bool        begun;                  /* write begun, and none refused since */
    uint8_t     option, sequence;       /* 37h, 22h of e-paper */
    uint32_t    memory[PANEL_ROWS * PANEL_COLS];    /* by raw row and column */
    uint8_t     plane[2][PANEL_ROWS * PANEL_COLS / 8];      /* 24h, 26h of e-paper */
    uint8_t     paper[PANEL_ROWS * PANEL_COLS / 8];         /* displayed picture */
    uint64_t    bytes, pixels, wraps;   /* received; written; window overflows */
    uint32_t    updates, partial;
    uint32_t    faults;
    const char *fault;                  /* first fault */
    /* the wires: transfers handed over and not yet sent */
    panel_transfer pending[PANEL_PENDING];
    uint32_t    waiting, late;          /* pending transfers; allowed number */
    uint32_t    overwritten;            /* transfers with bytes changed too early */
    uint32_t    overlapped;             /* pixels drawn during a transfer */
} panel_model;

void panel_power(panel_model *p, panel_model_kind kind);
void panel_byte(panel_model *p, bool data, uint8_t byte);
void panel_pause(panel_model *p, uint32_t ms);
void panel_idle(panel_model *p);              /* until BUSY is free */

/* The colour 0x00RRGGBB at a column and row of the memory as the glass stands upright. */
uint32_t panel_seen(const panel_model *p, uint32_t x, uint32_t y);

/* Wires by DMA: the bytes are taken when they are waited for, or when more than `late`
 * transfers are on their way. */
void panel_send(panel_model *p, const uint8_t *bytes, size_t count);
void panel_settle(panel_model *p);
#endif
