/* SPDX-License-Identifier: MIT */
/* A tank: the water behind its glass, the glass itself, its stone.
 *
 * The glass is thin: a ray is bent as if air met water there [F4]. */
#include "shade/beam.h"
#include "shade/coat.h"
#include "shade/env.h"

/* Out of wall `face`: +x, -x, +z, -z. */
static tp_ray normal_of(uint32_t face)
{
    int32_t one = face & 1 ? -16384 : 16384;
    return face & 2 ? (tp_ray){ 0, 0, one, 0 } : (tp_ray){ one, 0, 0, 0 };
}

void tp_stage_side(const tp_shade *shade, tp_run *run)
{
    tp_view_run(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++) {
        tp_ray  in = { -run->vx[i], -run->vy[i], -run->vz[i], 0 };
        tp_beam beam;
        tp_inside_places(shade, run, i, i + 1, &beam);
        beam.way = tp_inside_bent(shade->inside, 1, in, normal_of(run->t[i]));
        run->colour[i] = tp_inside_at(shade, &shade->inside->bed, &beam,
                                      shade->inside->deep);
    }
}

void tp_shade_glaze(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop,
                    uint32_t face)
{
    TP_ASSERT(i <= stop && stop <= run->count && face < 4);
    const tp_inside *inside = shade->inside;
    tp_ray n = normal_of(face);

    tp_view_run(shade, &shade->world, run);
    for (; i < stop; i++) {
        int32_t  vx = run->vx[i], vy = run->vy[i], vz = run->vz[i];
        int32_t  nv = (vx * n.x + vz * n.z) >> 14;
        uint32_t share = shade->fresnel[tp_clamp(nv, 0, 16384) >> 6];
        uint32_t sky = tp_env_at(shade, (2 * nv * n.x >> 14) - vx, -vy,
                                 (2 * nv * n.z >> 14) - vz);
        uint32_t c = tp_colour_mix(run->colour[i], inside->glass_colour, inside->glass);
        run->colour[i] = tp_colour_mix(c, sky, share);
    }
}

/* -- stone ---------------------------------------------------------------------------- */

/* The picture lies in the plane that the normal is nearest to: x y, z y or x z. */
void tp_stage_wall(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++) {
        tp_packed_dir n = run->n[i];
        int32_t x = tp_abs(tp_dir_x(n)), y = tp_abs(tp_dir_y(n)), z = tp_abs(tp_dir_z(n));
        tp_beam beam;
        tp_inside_places(shade, run, i, i + 1, &beam);
        tp_fx s = x > y && x > z ? beam.at.z : beam.at.x;
        tp_fx t = y >= x && y >= z ? beam.at.z : -beam.at.y;
        uint32_t colour = tp_coat_at(&shade->inside->wall, s, t, beam.far, false);
        run->colour[i] = tp_coat_lit(shade, colour, n);
    }
}
