/* SPDX-License-Identifier: MIT */
/* The fast stage of stone, for the fast rung of solids.
 *
 * A surface within a block of 16 columns has one light and one level of the texture.  Its
 * points are computed at both ends; places on the texture are interpolated. */
#include "features/tank/tank.h"
#include "raster/raster.h"
#include "shade/material.h"
#include "shade/refracted_ray.h"

/* Returns the end of the samples of one surface: one normal, and depths without a jump by
 * more than a 64th. */
static int32_t surface_end(const tp_run *run, int32_t i, int32_t stop)
{
    const tp_packed_dir n = run->n[i];
    uint32_t here = TP_ZI(run->key[i]);

    while (++i < stop && run->n[i] == n) {
        const uint32_t next = TP_ZI(run->key[i]);
        if ((next > here ? next - here : here - next) > here >> 6)
            break;
        here = next;
    }
    return i;
}

/* A place on the texture, m: along the largest component of the normal, as tp_stage_wall
 * projects the texture. */
typedef struct {
    uint32_t s, t;
} stone_place;

static stone_place stone_place_make(tp_packed_dir n, tp_vec3 at)
{
    const int32_t x = tp_abs(tp_dir_x(n)), y = tp_abs(tp_dir_y(n)), z = tp_abs(tp_dir_z(n));

    return (stone_place){ (uint32_t)(x > y && x > z ? at.z : at.x),
                          y >= x && y >= z ? (uint32_t)at.z : 0u - (uint32_t)at.y };
}

/* Returns the step of a coordinate from column to column. */
static uint32_t step_per_column(uint32_t first, uint32_t last, int32_t columns)
{
    return columns > 0 ? (uint32_t)((int32_t)(last - first) / columns) : 0;
}

static void shade_surface(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop)
{
    const tp_wall_material *stone = &shade->underwater->wall;
    const tp_packed_dir n = run->n[i];
    const uint32_t colour = tp_light_matt_colour(shade, stone->colour, n);
    tp_refracted_ray first, last;

    if (!stone->texture) {
        for (; i < stop; i++)
            run->colour[i] = colour;
        return;
    }
    tp_underwater_set_start_points(shade, run, i, i + 1, &first);
    tp_underwater_set_start_points(shade, run, stop - 1, stop, &last);
    const stone_place a = stone_place_make(n, first.at), b = stone_place_make(n, last.at);
    const tp_mip_level level =
        tp_wall_material_level(stone, first.far / 2 + last.far / 2, false);
    const uint32_t step_s = step_per_column(a.s, b.s, stop - 1 - i) * stone->per_metre;
    const uint32_t step_t = step_per_column(a.t, b.t, stop - 1 - i) * stone->per_metre;
    uint32_t s = a.s * stone->per_metre, t = a.t * stone->per_metre;

    for (; i < stop; i++, s += step_s, t += step_t)
        run->colour[i] = tp_colour_times(tp_mip_level_sample_linear(&level, s, t), colour);
}

void tp_stage_quick_wall(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = surface_end(run, i, tp_block_end(run, i));
        shade_surface(shade, run, i, stop);
    }
}
