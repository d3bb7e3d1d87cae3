/* SPDX-License-Identifier: MIT */
/* What is seen through the water's surface from above: the floor, walls and things in the
 * water, refracted at the bumped normal [F4] and lessened on the way.
 *
 * What the water itself sends is three parts of the colour of its depth and one part of
 * the lit colour that the stages before have left: so layers and light still move over
 * deep water, while a shore's last inch shows the land alone.
 *
 * With dispersion each channel has an index of its own and goes its own way. */
#include "shade/beam.h"
#include "geom/geom.h"
#include "shade/half.h"
#include "shade/slope.h"

#define PIECE 16

/* Places and ways of samples [i, stop), bent for one channel. */
TP_ALWAYS_INLINE void bend(const tp_shade *shade, const tp_run *run, int32_t i,
                           int32_t stop, int rippled, int channel, tp_beam *beam)
{
    for (; i < stop; i++, beam++) {
        tp_ray in = { -run->vx[i], -run->vy[i], -run->vz[i], 0 };
        tp_ray n = tp_slope_normal_of(shade, run, i, rippled);
        beam->way = tp_inside_bent(&shade->inside, channel, in, n);
        if (beam->way.y > -1638)    /* a steep ripple would throw it out of the water */
            beam->way.y = -1638;
    }
}

/* What of shade.sunken lies there: bent as if half a metre under the surface, by a
 * quarter of the slope [F4]. */
static uint32_t with_sunken(const tp_shade *shade, const tp_run *run, int32_t i,
                            const tp_beam *beam, tp_ray n, uint32_t colour)
{
    const tp_half *half = &shade->sunken;
    const tp_view_axes *axes = &shade->world;
    int32_t across = (int32_t)(((int64_t)axes->right.x * n.x + (int64_t)axes->right.z * n.z)
                               >> 30);
    int32_t along = (int32_t)(((int64_t)axes->up.x * n.x + (int64_t)axes->up.z * n.z)
                              >> 30);
    uint32_t far = (uint32_t)beam->far | 1;
    int      shift = tp_clz(far);
    int64_t  each = tp_recip_rough(far << shift);       /* 2^46 / m / 2^shift */
    int64_t  focal = shade->focal;
    int32_t  u = (int32_t)tp_limit((across * focal >> 4) * each >> (64 - shift), 64);
    int32_t  v = (int32_t)tp_limit((along * focal >> 4) * each >> (64 - shift), 64);
    int32_t  x = (run->x + i) / 2 - u, y = run->y / 2 + v;

    uint32_t over = tp_half_pixel(half, x, y);
    uint32_t share = (over >> 24) + (over >> 31);
    return tp_colour_mix(colour, over, share);
}

/* 16 / n in Q8. */
static const uint16_t over[PIECE] = { 0, 4096, 2048, 1365, 1024, 819, 683, 585, 512, 455,
                                      410, 372, 341, 315, 293, 273 };

/* The floor is looked up under the piece's ends and joined between them. */
static void see(const tp_shade *shade, const tp_beam *beam, int32_t count,
                const uint32_t *body, uint32_t *seen)
{
    tp_bed a = tp_inside_bed(shade, &beam[0]), b = a;

    if (!shade->inside.ocean) {
        for (int32_t k = 0; k < count; k++)
            seen[k] = tp_inside_at(shade, &a, &beam[k], body[k]);
        return;
    }
    b = tp_inside_bed(shade, &beam[count - 1]);
    for (int32_t k = 0; k < count; k++) {
        tp_bed bed = tp_inside_bed_between(&a, &b, k * over[count - 1] >> 8, beam[k].at);
        seen[k] = tp_inside_at(shade, &bed, &beam[k], body[k]);
    }
}

TP_ALWAYS_INLINE void behind(const tp_shade *shade, tp_run *run, int rippled,
                             int dispersed)
{
    uint32_t body[PIECE], seen[3][PIECE];
    tp_beam  beam[PIECE];

    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = i + PIECE - ((run->x + i) & (PIECE - 1));
        stop = stop < run->count ? stop : run->count;
        for (int32_t k = 0; k < stop - i; k++)
            body[k] = tp_colour_mix(shade->inside.deep, run->colour[i + k], 64);
        tp_inside_places(shade, run, i, stop, beam);
        for (int channel = dispersed ? 0 : 1; channel < (dispersed ? 3 : 2); channel++) {
            bend(shade, run, i, stop, rippled, channel, beam);
            see(shade, beam, stop - i, body, seen[channel]);
        }
        for (int32_t k = 0; i < stop; i++, k++) {
            uint32_t c = seen[1][k];
            if (dispersed)
                c = (seen[0][k] & 0xff0000) | (c & 0xff00) | (seen[2][k] & 0xff);
            if (shade->sunken.colour)
                c = with_sunken(shade, run, i, &beam[k],
                                tp_slope_normal_of(shade, run, i, rippled), c);
            run->colour[i] = c;
        }
    }
}

#define BEHIND_STAGE(name, rippled, dispersed) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { behind(shade, run, rippled, dispersed); }
TP_BEHIND_STAGES(BEHIND_STAGE)
