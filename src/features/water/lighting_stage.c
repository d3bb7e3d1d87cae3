/* SPDX-License-Identifier: MIT */
/*
 * Span stages of light on water: Phong's three terms [F5], or Blinn's; the reflected sky,
 * weighted by Fresnel; and the glint, added to the water's colour.
 */
#include "shade/env.h"
#include "shade/material.h"
#include "shade/rough_lobe.h"
#include "shade/shade.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* -- light --------------------------------------------------------------------------- */

/* The normal stays a pair of slopes, N = (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2).  With V
 * to the eye and L to the light, R = 2 (N.L) N - L gives R.V = 2 (N.L)(N.V) - L.V, and
 * the reflected view's height is 2 (N.V) Ny - Vy.  The stages need neither a reflected
 * vector nor a half vector (see material.h). */

/* Shades the diffuse term alone, for water without glitter and reflection.  The nearest
 * entry of the table of roots is within 0.2 %, half a level of 255. */
TP_ALWAYS_INLINE void diffuse(const tp_shade *restrict shade, tp_run *restrict run,
                              int rippled)
{
    int32_t ambient = shade->ambient, direct = 256 - ambient, count = run->count;
    int32_t lx = shade->world.lx * direct >> 8, ly = shade->world.ly * direct >> 8;
    int32_t lz = shade->world.lz * direct >> 8;

    for (int32_t i = 0; i < count; i++) {
        int32_t sx = tp_slope_x(run, i, rippled), sz = tp_slope_z(run, i, rippled);
        int32_t ny = tp_rsqrt_one_plus_nearest(tp_slope_square(sx, sz));
        int32_t nl = ly - ((sx * lx + sz * lz) >> 12);
        int32_t lit = nl * ny >> 20;
        if ((uint32_t)lit > (uint32_t)direct)       /* facing away, or rounded up */
            lit = lit < 0 ? 0 : direct;
        run->colour[i] = tp_colour_scale(run->colour[i], (uint32_t)(ambient + lit));
    }
}

/* Returns the lobe at R.V, interpolated between table entries: on smooth water the
 * entries of a sharp lobe would show as rings.  Most samples lie outside of the lobe. */
TP_ALWAYS_INLINE int32_t sample_shine(const tp_shade *shade, int32_t rv)
{
    rv = tp_clamp(rv, 0, 16384);
    int32_t here = (int32_t)shade->shine[rv >> 4];
    if (!TP_WIDE && here == 0)
        return 0;
    int32_t next = (int32_t)shade->shine[(rv + 15) >> 4];
    int32_t between = here + ((next - here) * (rv & 15) >> 4);
    return here ? between : 0;
}

/* Lower bound of N.V on rippled water, 1/10.  Ripples below a pixel keep a part of the
 * water facing the eye at any grazing angle.  Without the bound crests would be outlined
 * by the horizon's full light. */
#define RIPPLED_VIEW 1638

/* Blinn's half vectors of a run, for loops over several samples at once: the reciprocal
 * calls a function and has a loop of its own. */
typedef struct {
    tp_blinn_half half[TP_WIDE ? TP_RUN : 1];
} blinn_halves;

TP_ALWAYS_INLINE void fill_blinn_halves(blinn_halves *to, const int16_t *lv, int32_t count,
                                        int blinn)
{
    for (int32_t i = 0; TP_WIDE && blinn && i < count; i++)
        to->half[i] = tp_blinn_half_make(lv[i]);
}

TP_ALWAYS_INLINE int32_t lobe_cosine(const blinn_halves *halves, int32_t i, int32_t nl,
                                     int32_t seen, int32_t lv, int blinn)
{
    if (TP_WIDE && blinn)
        return tp_blinn_half_cosine(&halves->half[i], nl, seen);
    return tp_lobe_table_cosine(nl, seen, lv, blinn);
}

/* Shades ambient and diffuse light, and leaves the glint.  The outputs are arrays of the
 * run, restrict so that the loop is vectorised.  The lobe uses N.V without the
 * lower bound, clamped at 0: a crest facing away shows no more light than a grazing
 * crest. */
TP_ALWAYS_INLINE void light(const tp_shade *shade, const tp_run *run, int16_t *restrict nvs,
                            int16_t *restrict ups, uint16_t *restrict glints,
                            uint32_t *restrict colours, int rippled, int blinn)
{
    int32_t lx = shade->world.lx, ly = shade->world.ly, lz = shade->world.lz;
    int32_t ambient = shade->ambient, count = run->count;
    blinn_halves halves;

    fill_blinn_halves(&halves, run->lv, count, blinn);
    for (int32_t i = 0; i < count; i++) {
        int32_t sx = tp_slope_x(run, i, rippled), sz = tp_slope_z(run, i, rippled);
        int32_t vx = run->vx[i], vy = run->vy[i], vz = run->vz[i];
        int32_t ny = tp_rsqrt_one_plus(tp_slope_square(sx, sz));
        int32_t nv = vy - ((sx * vx + sz * vz) >> 12);      /* Q14, |nv| below 14 */
        int32_t nl = ly - ((sx * lx + sz * lz) >> 12);

        int32_t seen = tp_clamp(nv * ny >> 14, 0, 16384);
        nv = rippled && seen < RIPPLED_VIEW ? RIPPLED_VIEW : seen;
        nl = tp_clamp(nl * ny >> 14, 0, 16384);
        int32_t rv = lobe_cosine(&halves, i, nl, seen, run->lv[i], blinn);
        int32_t up = (2 * nv * ny >> 14) - vy;
        nvs[i] = (int16_t)nv;
        ups[i] = (int16_t)(up > 16384 ? 16384 : up);    /* vy is at most 1 */
        int32_t shine = TP_WIDE || nl > 0 ? sample_shine(shade, rv) : 0;
        glints[i] = (uint16_t)(nl > 0 ? shine : 0);
        colours[i] = tp_colour_scale(colours[i],
                                     (uint32_t)tp_lit_share(ambient, nl));
    }
}

/* -- light of rough water ------------------------------------------------------------- */

/* Shades `count` columns from column i on, at most 16, of one lobe: as light does, with N.V
 * bent and the lobe widened. */
TP_ALWAYS_INLINE void light_rough_columns(const tp_shade *shade, const tp_run *run,
                                          int16_t *restrict nvs, int16_t *restrict ups,
                                          uint16_t *restrict glints,
                                          uint32_t *restrict colours, tp_rough_lobe lobe,
                                          int32_t i, int32_t count, int rippled, int blinn)
{
    int32_t lx = shade->world.lx, ly = shade->world.ly, lz = shade->world.lz;
    int32_t ambient = shade->ambient;
    int32_t dark = tp_rough_lobe_dark_cosine(shade, &lobe);
    int32_t half = lobe.peak + 8191;    /* both roundings down of the table, nearest */
    blinn_halves halves;

    fill_blinn_halves(&halves, run->lv + i, count, blinn);
    for (int32_t k = 0; k < count; k++) {
        int32_t sx = tp_slope_x(run, i + k, rippled), sz = tp_slope_z(run, i + k, rippled);
        int32_t vx = run->vx[i + k], vy = run->vy[i + k], vz = run->vz[i + k];
        int32_t ny = tp_rsqrt_one_plus(tp_slope_square(sx, sz));
        int32_t nv = vy - ((sx * vx + sz * vz) >> 12);
        int32_t nl = ly - ((sx * lx + sz * lz) >> 12);

        nv = tp_clamp(nv * ny >> 14, -16384, 16384);
        int32_t seen = nv < 0 ? 0 : nv;
        nv = tp_rough_view_cosine(nv, &lobe.view);
        nv = rippled && nv < RIPPLED_VIEW ? RIPPLED_VIEW : nv;
        nl = tp_clamp(nl * ny >> 14, 0, 16384);
        int32_t rv = lobe_cosine(&halves, k, nl, seen, run->lv[i + k], blinn);
        int32_t rise = blinn ? 0 : (2 * seen * ny >> 14) - vy - ly;
        int32_t up = ((2 * nv * ny >> 14) - vy) * lobe.view.height >> 14;
        nvs[i + k] = (int16_t)nv;
        ups[i + k] = (int16_t)(up > 16384 ? 16384 : up);
        int32_t glint = 0;
        if (TP_WIDE || rv > dark) {             /* most samples lie outside of the lobe */
            int32_t shine = sample_shine(shade, tp_rough_lobe_cosine(&lobe, rv, rise));
            glint = shine ? (shine * lobe.peak + half) >> 14 : 0;
        }
        glints[i + k] = (uint16_t)(nl > 0 ? glint : 0);
        nl = tp_clamp(nl + lobe.seen, 0, 16384);
        colours[i + k] = tp_colour_scale(colours[i + k],
                                     (uint32_t)tp_lit_share(ambient, nl));
    }
}

TP_ALWAYS_INLINE void light_rough(const tp_shade *restrict shade, tp_run *restrict run,
                                  int rippled, int blinn)
{
    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = tp_block_end(run, i);
        const tp_rough_lobe lobe =
            tp_rough_lobe_make(shade, run->key[i], run->vy[i], run->lv[i], blinn);
        light_rough_columns(shade, run, run->nv, run->up, run->glint, run->colour, lobe, i,
                            stop - i, rippled, blinn);
        i = stop;
    }
}

#define DIFFUSE_STAGE(name, rippled) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { diffuse(shade, run, rippled); }
DIFFUSE_STAGE(diffuse, 0)
DIFFUSE_STAGE(diffuse_rippled, 1)

#define LIGHT_STAGE(name, rippled, blinn) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { light(shade, run, run->nv, run->up, run->glint, run->colour, rippled, blinn); }
LIGHT_STAGE(light, 0, 0)
LIGHT_STAGE(light_rippled, 1, 0)
LIGHT_STAGE(light_blinn, 0, 1)
LIGHT_STAGE(light_blinn_rippled, 1, 1)

#define ROUGH_STAGE(name, rippled, blinn) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { light_rough(shade, run, rippled, blinn); }
ROUGH_STAGE(light_rough, 0, 0)
ROUGH_STAGE(light_rough_rippled, 1, 0)
ROUGH_STAGE(light_blinn_rough, 0, 1)
ROUGH_STAGE(light_blinn_rough_rippled, 1, 1)

const tp_stage tp_lighting_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_lighting(X)
#undef X
};

const tp_stage tp_diffuse_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_diffuse(X)
#undef X
};

/* -- the reflected sky --------------------------------------------------------------- */

/* The plain gradient needs only the height of the reflected view and takes one stage.
 * Other skies may give light above white [F8]. */

/* Returns the weight of a reflected ray by its height, Q14, 1/2..1.  A ray downwards meets
 * other water, half as bright as the horizon: the weight fades to a half within 7 degrees
 * below level. */
TP_ALWAYS_INLINE uint32_t horizon_fade(int32_t up)
{
    return (uint32_t)tp_clamp(16384 + 4 * up, 8192, 16384);
}

TP_ALWAYS_INLINE uint32_t reflected_share(const tp_shade *shade, int32_t nv, int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror >> 8;
    return share * horizon_fade(up) >> 14;
}

/* Returns reflected_share in 1/65536: light of many whites multiplies the rounding
 * error. */
TP_ALWAYS_INLINE uint32_t reflected_share_q16(const tp_shade *shade, int32_t nv,
                                              int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror;
    return share * horizon_fade(up) >> 14;
}

/* Mixes the reflected gradient sky into the colours, by Fresnel's share: the work of
 * tp_stage_reflect_gradient and tp_stage_fresnel in one stage. */
void tp_stage_mirror_gradient_sky(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t sky = tp_env_gradient(shade, run->up[i]);
        run->colour[i] = tp_colour_mix(run->colour[i], sky,
                                       reflected_share(shade, run->nv[i], run->up[i]));
    }
}

/* Unpacks the slopes as sampled, so later stages read the slopes of smooth and of rippled
 * water from the same arrays. */
void tp_stage_slopes(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    (void)shade;
    for (int32_t i = 0; i < count; i++) {
        run->sx[i] = (int16_t)tp_slope_x(run, i, 0);
        run->sz[i] = (int16_t)tp_slope_z(run, i, 0);
    }
}

void tp_stage_reflect_gradient(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = tp_reflected_compute(run, i);
        run->mirror[i] = tp_env_gradient(shade, to.y);
    }
}

/* Mixes light above white.  The share is multiplied first: light above white times a
 * small share may be below white. */
TP_ALWAYS_INLINE uint32_t bright_mix(uint32_t a, uint32_t light, uint32_t share,
                                     uint32_t gain)
{
    uint32_t part = share * gain >> 8, left = 65536 - share, sum = 0;

    for (int k = 0; k < 24; k += 8) {
        uint32_t c = ((a >> k & 0xff) * left + (light >> k & 0xff) * part) >> 16;
        sum |= (c < 255 ? c : 255) << k;
    }
    return sum;
}

TP_ALWAYS_INLINE void fresnel(const tp_shade *restrict shade, tp_run *restrict run,
                              int hdr)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t light = run->mirror[i], colour = run->colour[i], bright = 0;
        int32_t  nv = run->nv[i], up = run->up[i];
        if (hdr && (TP_WIDE || light >> 24))
            bright = bright_mix(colour, light, reflected_share_q16(shade, nv, up),
                                tp_hdr_gain(shade, light));
        uint32_t mixed = tp_colour_mix(colour, light, reflected_share(shade, nv, up));
        run->colour[i] = hdr && light >> 24 ? bright : mixed;
    }
}

#define FRESNEL_STAGE(name, hdr) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { fresnel(shade, run, hdr); }
FRESNEL_STAGE(fresnel, 0)
FRESNEL_STAGE(fresnel_hdr, 1)

const tp_stage tp_reflectance_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_reflectance(X)
#undef X
};

/* -- the glint ----------------------------------------------------------------------- */

void tp_stage_glint(const tp_shade *restrict shade, tp_run *restrict run)
{
    const uint32_t light = shade->light_colour;
    const int32_t  count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t share = run->glint[i];
        if (!TP_WIDE && share == 0)         /* the usual case of most water pixels */
            continue;
        share = share > 256 ? 256 : share;
        run->colour[i] = tp_colour_add(run->colour[i], tp_colour_scale(light, share));
    }
}

const tp_stage tp_glint_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_glint(X)
#undef X
};
