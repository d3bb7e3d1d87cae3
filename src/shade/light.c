/* SPDX-License-Identifier: MIT */
/* Light on water: Phong's three terms [F5] and the mirrored sky by Fresnel's share [F1].
 *
 * The normal stays a pair of slopes, N = (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2).  With V to
 * the eye and L to the light, R = 2 (N.L) N - L gives R.V = 2 (N.L)(N.V) - L.V, and the
 * mirrored view's height is 2 (N.V) Ny - Vy: no vector is ever reflected. */
#include "shade/shade.h"

/* 1/sqrt(1 + q) in Q1.15; q in Q24, held below 4. */
static int32_t steep_of(const tp_shade *shade, uint32_t q)
{
    if (q > 0x3ffffff)
        q = 0x3ffffff;
    uint32_t i = q >> 18, f = q >> 10 & 0xff;
    int32_t  a = shade->steep[i], b = shade->steep[i + 1];
    return a + ((b - a) * (int32_t)f >> 8);
}

void tp_stage_light(const tp_shade *shade, tp_run *run)
{
    int32_t lx = shade->world.lx, ly = shade->world.ly, lz = shade->world.lz;
    int32_t ambient = shade->ambient, direct = 256 - ambient;

    for (int32_t i = 0; i < run->count; i++) {
        int32_t sx = run->sx[i], sz = run->sz[i];
        int32_t vx = run->vx[i], vy = run->vy[i], vz = run->vz[i];
        int32_t ny = steep_of(shade, (uint32_t)(sx * sx) + (uint32_t)(sz * sz));
        int32_t nv = vy - ((sx * vx + sz * vz) >> 12);      /* Q14, below 14 */
        int32_t nl = ly - ((sx * lx + sz * lz) >> 12);

        nv = tp_clamp(nv, 0, 4 * 16384) * (ny >> 1) >> 14;
        nl = tp_clamp(nl, 0, 4 * 16384) * (ny >> 1) >> 14;
        nv = nv > 16384 ? 16384 : nv;
        int32_t rv = tp_clamp((2 * nl * nv >> 14) - run->lv[i], 0, 16384);
        uint32_t bright = (uint32_t)(ambient + (direct * nl >> 14));
        run->nv[i] = (int16_t)nv;
        run->up[i] = (int16_t)tp_clamp((nv * ny >> 14) - vy, -16384, 16384);
        run->glint[i] = nl > 0 ? shade->shine[rv >> 4] : 0;
        run->colour[i] = tp_colour_scale(run->colour[i], bright > 256 ? 256 : bright);
    }
}

void tp_stage_mirror(const tp_shade *shade, tp_run *run)
{
    uint32_t mirror = (uint32_t)shade->mirror;

    for (int32_t i = 0; i < run->count; i++) {
        uint32_t share = shade->fresnel[run->nv[i] >> 6] * mirror >> 8;
        int32_t  sine = run->up[i] >> 6;
        uint32_t sky = shade->sky[sine < 0 ? -sine : sine];
        run->colour[i] = tp_colour_mix(run->colour[i], sky, share);
    }
}

void tp_stage_glint(const tp_shade *shade, tp_run *run)
{
    uint32_t light = shade->light_colour;

    for (int32_t i = 0; i < run->count; i++) {
        uint32_t share = run->glint[i] > 256 ? 256 : run->glint[i];
        run->colour[i] = tp_colour_add(run->colour[i], tp_colour_scale(light, share));
    }
}
