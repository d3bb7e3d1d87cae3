/* SPDX-License-Identifier: MIT */
/* Pixels as a screen's memory wants them: where each channel lies in a pixel of 8 to 32
 * bits.  Nothing here touches a device. */
#ifndef SCREEN_LAYOUT_H
#define SCREEN_LAYOUT_H
#include <stdbool.h>
#include "../host/picture.h"

typedef struct { uint8_t offset, length; } channel;     /* bits, from the lowest */

typedef struct {
    uint32_t bits;              /* a pixel: 8, 16, 24 or 32 */
    bool     indexed;           /* 8 bits that a table of colours turns into light */
    bool     grey;              /* 8 bits of brightness */
    bool     big;               /* high byte first; a machine's own order as a rule */
    channel  red, green, blue;  /* unless indexed or grey */
    channel  spare;             /* alpha or nothing: all ones */
} layout;

bool machine_is_big(void);      /* stores the high byte first */

/* Whether layout_row can write it: channels that lie inside the pixel, without overlap. */
bool layout_known(const layout *l);

/* The format whose pictures need no change of colours, or the least. */
tp_format layout_format(const layout *l);

/* Row y of a picture, as bits / 8 bytes a pixel.  Channels of less than 8 bits keep the
 * high ones, wider ones repeat them.  Indices and greys are copied: an indexed or grey
 * layout takes p8, l8 and i1 alone. */
bool layout_takes(const layout *l, tp_format format);
void layout_row(const layout *l, void *to, const picture *p, uint32_t y);

/* Entry `i` of the table of colours that such a picture is shown with, 0x00RRGGBB. */
uint32_t layout_colour(tp_format format, uint32_t i);

/* All 256 of them, 0..65535. */
void layout_table(tp_format format, uint16_t *red, uint16_t *green, uint16_t *blue);
#endif
