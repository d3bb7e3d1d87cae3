/* SPDX-License-Identifier: MIT */
/* The span stages of spray: the colour of a speck, and the streaks over shaded samples. */
#include "features/spray/spray.h"
#include "shade/shade.h"
#include "tidepool/modules.h"

void tp_stage_spray(const tp_shade *shade, tp_run *run)
{
    const tp_streaks *d = run->mine;

    (void)shade;
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = d->colour;
}

/* The numbers of a streak in one row of pixels. */
typedef struct {
    int32_t hh, per_hh;         /* square of half the way, 1/256 px; 2^16 over it */
    int32_t rr, dy;
    uint32_t opacity, per_rr;   /* 0..255; 2^16 opacity over the square of the radius */
} streak_row;

static streak_row make_streak_row(const tp_streak *s, int32_t dy)
{
    streak_row r = {
        .hh = s->du * s->du + s->dv * s->dv, .rr = s->radius * s->radius, .dy = dy,
        .opacity = s->colour >> 24,
    };

    r.per_hh = r.hh ? 65536 / r.hh : 0;
    r.per_rr = (r.opacity << 16) / (uint32_t)r.rr;
    return r;
}

/* Returns the streak's opacity at a distance dx, 1/16 px, from its middle, 0..255: less by
 * the square of the distance from the nearest point of the way. */
static uint32_t opacity_in_row(const tp_streak *s, const streak_row *r, int32_t dx)
{
    const int32_t along = tp_clamp(dx * s->du + r->dy * s->dv, -r->hh, r->hh);
    const int32_t t = along * r->per_hh / 256;          /* -1..1, Q8 */
    const int32_t x = dx - t * s->du / 256, y = r->dy - t * s->dv / 256;
    const int32_t q = x * x + y * y;

    return q < r->rr ? r->opacity - ((uint32_t)q * r->per_rr >> 16) : 0;
}

static void blend_streak(const tp_streak *s, tp_run *run)
{
    const int32_t dy = 16 * run->y + 8 - s->v, high = s->high;
    if ((uint32_t)(dy + high) > 2 * (uint32_t)high)     /* most streaks of the bands */
        return;
    const int32_t wide = s->radius + tp_abs(s->du);
    const int32_t low = (s->u - wide + 7) >> 4, end = ((s->u + wide - 8) >> 4) + 1;
    const int32_t stop = end < run->x + run->count ? end : run->x + run->count;

    if (low >= stop || end <= run->x)
        return;
    const streak_row r = make_streak_row(s, dy);
    for (int32_t x = low > run->x ? low : run->x; x < stop; x++) {
        const int32_t  i = x - run->x;
        const uint32_t share = opacity_in_row(s, &r, 16 * x + 8 - s->u);
        if (share > 0 && !tp_speck_is_hidden(s->key, run->key[i]))
            run->colour[i] = tp_colour_mix(run->colour[i], s->colour & 0xffffff, share);
    }
}

/* Blends the streaks of the bands that reach this row.  The order of the streaks is the
 * same in every tile. */
void tp_stage_spray_blend(const tp_shade *shade, tp_run *run)
{
    const tp_streaks *d = run->mine;
    const uint32_t y = (uint32_t)run->y, reach = d->reach + 1;
    uint32_t band = (y > reach ? y - reach : 0) / TP_STREAK_BAND;
    uint32_t last = (y + reach) / TP_STREAK_BAND;

    (void)shade;
    last = last < d->bands ? last : d->bands - 1;
    for (; d->count > 0 && band <= last; band++)
        for (uint32_t i = d->first[band]; i > 0; i = d->streak[i - 1].next)
            blend_streak(&d->streak[i - 1], run);
}

const tp_stage tp_spray_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_spray(X)
#undef X
};
