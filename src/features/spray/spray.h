/* SPDX-License-Identifier: MIT */
/*
 * Spray and bubbles: specks flying over the water, and specks rising in the water.
 *
 *     spray_module.c    the module: crests, splashes, flight
 *     spray_drawing.c   specks as soft streaks over the picture
 *     spray_stage.c     their colour and blending
 *     fast_spray_stage.c  the same for quality.spray=fast
 */
#ifndef TP_FEATURES_SPRAY_SPRAY_H
#define TP_FEATURES_SPRAY_SPRAY_H
#include "frame/drawing.h"
#include "tidepool/modules.h"
#include "tidepool/world.h"
#include "world/module.h"

typedef enum { TP_SPECK_SPRAY, TP_SPECK_BUBBLE } tp_speck_kind;

typedef struct {
    tp_vec3  place, last;       /* m: now; a tick ago */
    tp_vec3  speed;             /* m/s */
    uint16_t age;               /* ticks */
    uint8_t  kind;              /* tp_speck_kind */
    uint8_t  chance;            /* random, 0..255: gives the size */
} tp_speck;

/* Head of the block; the specks follow the head. */
typedef struct {
    uint32_t capacity, count;
    uint32_t dropped;           /* specks beyond the capacity, so far */
    uint32_t random;
} tp_spray;

const tp_speck *tp_spray_list(const tp_spray *spray);

/* Returns the spray of a world, or NULL. */
const tp_spray *tp_world_spray(const tp_world *world);

#define TP_SPRAY_ID TP_MODULE_ID('s', 'p', 'r', 'y')

/* The module's state in a world, or NULL. */
static inline tp_spray *tp_spray_of_world(const tp_world *world)
{
    return tp_world_module_state(world, TP_SPRAY_ID);
}

/* -- streaks of a picture, in tp_run.mine -------------------------------------------- */

#define TP_STREAK_BAND  8       /* rows of a band */
#define TP_STREAK_MOST  96      /* length of the longest streak, 1/16 px */
#define TP_STREAK_BLUR  16      /* smallest radius, 1/16 px */
#define TP_STREAK_REACH 5       /* most rows from any streak's middle to its end */

/* A projected speck without its shape. */
typedef struct {
    int32_t  u, v;              /* middle, 28.4 px */
    int32_t  du, dv;            /* half of the way, 1/16 px, up to 2^24 */
    uint32_t key;               /* depth as in the G-buffer; 1: a bubble under water */
    int32_t  radius;            /* 1/256 px, up to 2^24 */
    uint32_t opacity;           /* by its depth, 0..255 */
} tp_speck_place;

/* A projected speck with the shape of its streak; members as above. */
typedef struct {
    int32_t  u, v;
    uint32_t key;
    uint32_t colour;            /* 0xAARRGGBB: opacity, and the colour in its haze */
    int8_t   du, dv;            /* half of the way, 1/16 px */
    uint8_t  radius;            /* half of the width, 1/16 px */
    uint8_t  high;              /* most height from the middle to an end, 1/16 px */
    uint16_t next;              /* number of the band's next streak from 1 on; 0: none */
} tp_streak;

typedef struct {
    uint32_t   count, room, bands;
    uint32_t   foam_colour;     /* of unlit specks */
    uint32_t   colour;          /* colour of the speck being shaded */
    uint32_t   reach;           /* most rows from a streak's middle to its end */
    tp_streak *streak;
    uint16_t  *first;           /* number of the first streak of each band, or of the
                                 * first dash of each row; 0: none */
    struct tp_dashes *dashes;   /* NULL: the exact rung; else streaks have no memory */
    const tp_shaders *list;             /* of the specks' colours; NULL: none */
} tp_streaks;

/* Returns the colour of a speck with the key and the pixel (x, y), behind the air or the
 * water before it.  Overwrites `run`, which takes much stack. */
uint32_t tp_spray_shade(const tp_shade *shade, tp_streaks *d, uint32_t key, int32_t x,
                        int32_t y, tp_run *run);

/* True if the sample lies before the speck.  Clear water does not hide a bubble. */
TP_ALWAYS_INLINE bool tp_speck_is_hidden(uint32_t key, uint32_t sample)
{
    const bool through = key & 1;

    return (key & ~(uint32_t)0xff) <= (sample | 0xff)
           && !(through && TP_MARK(sample) == TP_MARK_WATER);
}

/* -- streaks of quality.spray=fast --------------------------------------------------- */

/* The pixels of a streak in one row of the picture. */
typedef struct {
    uint32_t key;               /* as above; bits 1 to 7: number of the colour */
    int16_t  x;                 /* first pixel */
    uint16_t next;              /* number of the row's next dash from 1 on; 0: none */
    uint8_t  count;             /* pixels */
    uint8_t  left, middle, right;       /* opacities of the ends, and between them */
} tp_dash;

/* Colours: one for each quarter of the picture's width and each half octave of depth. */
#define TP_DASH_ZONES   4
#define TP_DASH_COLOURS 128

typedef struct tp_dashes {
    uint32_t  count, room;      /* dashes beyond the room are not drawn */
    int32_t   width, height;    /* of the picture, px */
    uint32_t  colour[TP_DASH_COLOURS];  /* 0xffRRGGBB; 0: not computed yet */
    tp_dash  *dash;
} tp_dashes;

/* Data of the stage spray_dashes, in tp_run.mine; the rest of that run is scratch. */
typedef struct {
    tp_streaks *streaks;
    const tp_speck_place *speck;
} tp_dash_task;

/* Throws a crown of specks, and bubbles under it, for a drop's impact on water at
 * `level`, m. */
void tp_spray_splash(tp_spray *spray, const tp_scene *scene, const tp_impact *impact,
                     tp_fx level);

struct tp_water_spray_splashes {
    void (*add)(tp_spray *spray, const tp_scene *scene, const tp_impact *impact,
                tp_fx level);
};

#define TP_SPRAY_ROWS \
    TP_ROW_COUNT("spray.count", spray.count, "", 0, 1024, 0, \
        "most specks of spray and bubbles at once; 0: none"), \
    TP_ROW_NUMBER("spray.crest", spray.crest, "", 0, 4, 1, \
        "amount of spray from breaking crests"), \
    TP_ROW_NUMBER("spray.impact", spray.impact, "", 0, 4, 1, \
        "amount of spray from drops"), \
    TP_ROW_NUMBER("spray.size", spray.size, "m", 0.001, 1, 0.03, "size of a speck")

#endif
