/* SPDX-License-Identifier: MIT */
/*
 * The span stages of quality.spray=fast.
 *
 * spray_dashes, called once for each speck of a picture, cuts the speck's streak into
 * dashes, one a row, each in its row's list; spray_fast blends the dashes of a row.  A
 * dash has three opacities: of both end pixels, by the rule of the exact stage, and one of
 * all pixels between.  Dashes of less than FAINT are left out.
 *
 * A colour with its haze serves all specks of a quarter of the picture's width and of half
 * an octave of depth.  Colours and dashes depend on the specks and the view alone, so every
 * tiling has the same bits.
 */
#include "base/base.h"
#include "features/spray/spray.h"
#include "fixed/arithmetic.h"

#define FAINT 6u                /* of 255: smallest visible opacity */
#define SMOOTH 24               /* 1/16 px: wider streaks are fainter towards their edges */

/* -- the shape of a streak ----------------------------------------------------------- */

/* Members as of tp_streak; `flat`: the streak is so level that its whole way is in one
 * row. */
typedef struct {
    int32_t  u, v, du, dv, radius;
    uint32_t opacity, per_rr;   /* 0..255; 2^16 opacity over the square of the radius */
    bool     flat;
} shape;

/* Returns the length of (x, y) within 7 %: the octagon around the circle. */
static uint32_t rough_length(int32_t x, int32_t y)
{
    const uint32_t a = (uint32_t)tp_abs(x), b = (uint32_t)tp_abs(y);
    const uint32_t most = a > b ? a : b;

    return (15 * most + 15 * (a + b - most) / 2) / 16;
}

/* Returns the shape: the rules of the exact rung in 32 bits, for ways and radii of up to 64
 * pixels. */
static shape make_shape(const tp_speck_place *p)
{
    const int32_t du = tp_clamp(p->du, -1024, 1024);
    const int32_t dv = tp_clamp(p->dv, -1024, 1024);
    const uint32_t wide = (uint32_t)(p->radius < 1 << 14 ? p->radius : 1 << 14);
    const uint32_t half = rough_length(du, dv);
    const uint32_t whole = wide / 8 + 2 * half + 1;
    const uint32_t part = whole > TP_STREAK_MOST ? TP_STREAK_MOST * 256 / whole : 256;
    const uint32_t blur = TP_STREAK_BLUR;
    uint32_t radius = wide * part >> 12, opacity = p->opacity * wide / (8 * whole);
    shape s = { .u = p->u, .v = p->v, .du = du * (int32_t)part / 256,
                .dv = dv * (int32_t)part / 256 };

    if (radius < blur) {
        const uint32_t way = half * part >> 8;
        opacity = opacity * (wide * part >> 8) / (blur * 16) * (radius + way) / (blur + way);
        radius = blur;
    }
    s.radius = (int32_t)radius;
    s.opacity = opacity < 255 ? opacity : 255;
    s.per_rr = (s.opacity << 16) / (radius * radius);
    s.flat = tp_abs(s.dv) < 8;
    return s;
}

/* Returns the opacity at (x, y) 1/16 px from the nearest point of the way. */
static uint32_t opacity_beside(const shape *s, int32_t x, int32_t y)
{
    const int32_t square = x * x + y * y;

    return square < s->radius * s->radius
               ? s->opacity - ((uint32_t)square * s->per_rr >> 16) : 0;
}

/* -- dashes -------------------------------------------------------------------------- */

/* Returns the number of the colour for a key and a column. */
static uint32_t colour_number(const tp_dashes *to, uint32_t key, int32_t x)
{
    const uint32_t depth = key | 256, octave = (uint32_t)tp_clz(depth);
    const uint32_t halves = 2 * octave + (depth << octave >> 30 & 1 ? 0 : 1);
    const uint32_t most = TP_DASH_COLOURS / TP_DASH_ZONES - 1;
    const uint32_t zone =
        (uint32_t)(tp_clamp(x, 0, to->width - 1) * TP_DASH_ZONES / to->width);

    return (halves < most ? halves : most) * TP_DASH_ZONES + zone;
}

/* Computes a colour for the middle of its zone and of its half octave. */
static uint32_t make_colour(const tp_shade *shade, tp_streaks *d, uint32_t number,
                            tp_run *run)
{
    const tp_dashes *to = d->dashes;
    const uint32_t halves = number / TP_DASH_ZONES, zone = number % TP_DASH_ZONES;
    const uint32_t key = (halves & 1 ? 0xa0000000u : 0xe0000000u) >> halves / 2;
    const int32_t x = (int32_t)(2 * zone + 1) * to->width / (2 * TP_DASH_ZONES);

    return tp_spray_shade(shade, d, key, x, to->height / 2, run);
}

/* Adds the dash of row y if it is visible and there is room.  The streak's part in the row
 * has its middle at x; `along` is half of its length. */
static void add_dash(tp_streaks *d, const shape *s, uint32_t key, int32_t y)
{
    tp_dashes *to = d->dashes;
    const int32_t dy = 16 * y + 8 - s->v, high = tp_abs(s->dv);
    const int32_t at = s->flat ? 0 : tp_clamp(dy, -high, high);
    const int32_t beside = tp_abs(dy) > high ? tp_abs(dy) - high : 0;
    const int32_t x = s->flat ? s->u : s->u + at * s->du / s->dv;
    const int32_t along = tp_abs(s->flat ? s->du : s->du * 8 / s->dv);
    const int32_t low = (x - along - s->radius + 7) >> 4;
    const int32_t last = (x + along + s->radius - 8) >> 4;
    const uint32_t middle = opacity_beside(s, s->radius > SMOOTH ? s->radius / 2 : 0, beside);
    const int32_t before = x - along - (16 * low + 8), after = 16 * last + 8 - x - along;

    if (middle < FAINT || last < 0 || low >= to->width || last < low
        || to->count >= to->room)
        return;
    to->dash[to->count] = (tp_dash){
        .key = key, .x = (int16_t)low, .next = d->first[y],
        .count = (uint8_t)(last - low + 1), .middle = (uint8_t)middle,
        .left = (uint8_t)opacity_beside(s, before > 0 ? before : 0, beside),
        .right = (uint8_t)opacity_beside(s, after > 0 ? after : 0, beside),
    };
    d->first[y] = (uint16_t)++to->count;
}

/* Adds the dashes of a speck, with the key and colour number of all of them. */
TP_NEVER_INLINE void add_dashes(tp_streaks *d, const tp_speck_place *speck, uint32_t key)
{
    const shape s = make_shape(speck);
    const int32_t high = s.radius + tp_abs(s.dv), height = d->dashes->height;
    const int32_t top = (s.v - high + 7) >> 4, end = ((s.v + high - 8) >> 4) + 1;
    const int32_t stop = end < height ? end : height;

    if (s.opacity < FAINT)
        return;
    for (int32_t y = top > 0 ? top : 0; y < stop; y++)
        add_dash(d, &s, key, y);
    d->count++;
}

void tp_stage_spray_dashes(const tp_shade *shade, tp_run *run)
{
    const tp_dash_task *task = run->mine;
    tp_streaks *d = task->streaks;
    const tp_speck_place *speck = task->speck;
    const uint32_t number = colour_number(d->dashes, speck->key, speck->u >> 4);
    uint32_t *colour = &d->dashes->colour[number];

    if (*colour == 0)
        *colour = make_colour(shade, d, number, run) | 0xff000000u;
    add_dashes(d, speck, (speck->key & ~(uint32_t)0xfe) | number << 1);
}

/* -- blending ------------------------------------------------------------------------ */

static void blend_dash(const tp_dash *dash, uint32_t colour, tp_run *run)
{
    const int32_t from = dash->x - run->x, last = from + dash->count - 1;
    const int32_t stop = last < run->count ? last + 1 : run->count;

    for (int32_t i = from > 0 ? from : 0; i < stop; i++) {
        const uint32_t share = i == from ? dash->left
                             : i == last ? dash->right : dash->middle;
        if (!tp_speck_is_hidden(dash->key, run->key[i]))
            run->colour[i] = tp_colour_mix(run->colour[i], colour, share);
    }
}

/* Blends the dashes of the run's row; their order is the same in every tile.  Lists are
 * empty until a picture has a dash. */
void tp_stage_spray_fast(const tp_shade *shade, tp_run *run)
{
    const tp_streaks *d = run->mine;
    const tp_dashes *from = d->dashes;
    uint32_t number = from->count > 0 ? d->first[run->y] : 0;

    (void)shade;
    while (number > 0) {
        const tp_dash *dash = &from->dash[number - 1];
        if (dash->x < run->x + run->count && dash->x + dash->count > run->x)
            blend_dash(dash, from->colour[dash->key >> 1 & (TP_DASH_COLOURS - 1)] & 0xffffff,
                       run);
        number = dash->next;
    }
}
