/* SPDX-License-Identifier: MIT */
/* Foam beyond the window over a map of the floor, and over a straight beach that is
 * far from the window's middle.
 *
 * The depth gives the mean of the cover: the mean of the gains by breaking and by the
 * shore, in balance with fading.  Waves that break pass every place once in a period: their
 * crests leave fresh foam behind, which has aged when the next crest comes.  The cover
 * falls along a period; the first term of its Fourier series goes with the slope along the
 * waves' way, so backs have more foam than fronts, and where the grid leaves the waves out
 * the mean is left.  Crests of open water foam as where there is no floor, by the mean of
 * the field in open water, in the share that the depth leaves them.
 *
 * Left out: foam that drifts away from where it is made, and the clumps of crests that
 * break by noise; the noise widens the zone of the mean.  Off a straight beach open water
 * has no foam beyond the window. */
#include "base/base.h"
#include "features/foam/foam_cover.h"
#include "waves/coastal_tables.h"

#define SLOPE_LEAST 16          /* Q12: smaller means of the slope count as this */

/* Returns the swing of the cover over a period T, of 256: T / 4 fade, from the loss in the
 * half of a period in which a crest makes no foam; 256 at the most. */
static int32_t period_swing(const tp_world *world, const tp_scene *scene)
{
    const tp_swell *high = &world->deep.swell[0];

    for (uint32_t i = 1; i < world->deep.count; i++)
        if (world->deep.swell[i].amplitude > high->amplitude)
            high = &world->deep.swell[i];
    const uint64_t fade = (uint64_t)(uint32_t)scene->foam.fade * TP_TICKS_PER_SECOND;
    const uint64_t turns = (high->turns_tick >> 32) * fade >> 16;       /* Q32 */
    const uint64_t swing = ((uint64_t)64 << 32) / (turns + 1);
    return swing < 256 ? (int32_t)swing : 256;
}

static void make_means(tp_foam_surf *surf, const tp_foam *field, const tp_wave_models *by,
                       const tp_world *world, const tp_scene *scene)
{
    tp_foam_maker make;
    const uint32_t visits = field->visits / TP_FOAM_TICKS;

    tp_foam_maker_begin(&make, (tp_foam *)(uintptr_t)field, by, world, scene);
    surf->deepest = 0;
    for (uint32_t n = 0; n < TP_COASTAL_DEPTHS; n++) {
        const tp_fx depth = tp_coastal_node_depth(n, 3);
        const uint32_t share = tp_foam_maker_open_share(&make, depth);
        surf->mean[n] =
            (uint8_t)tp_foam_maker_mean_cover(&make, depth > 0 ? depth : 1, visits);
        surf->open[n] = (uint8_t)(share < 255 ? share : 255);
        if (surf->mean[n] > 0 || (share > 0 && surf->open_fresh > 0))
            surf->deepest = n + 1 < TP_COASTAL_DEPTHS ? tp_coastal_node_depth(n + 1, 3)
                                                      : TP_FX_MAX;
    }
}

/* Sets the nodes' places.  A map's middle is within 16384 m and its sides below 16000 m, so
 * all fit; a step is at least 2^9. */
static void set_nodes(tp_foam_surf *surf, const tp_coastal_water *map)
{
    TP_ASSERT(map->map_cols >= 2 && map->map_rows >= 2 && map->map_step >= 512);
    surf->node = tp_coastal_floor_nodes(map);
    surf->cols = map->map_cols;
    surf->map_x = (tp_fx)map->map_x;
    surf->map_z = (tp_fx)map->map_z;
    surf->last_x = map->map_step * (map->map_cols - 1) - 1;
    surf->last_z = map->map_step * (map->map_rows - 1) - 1;
    surf->per_step = (uint32_t)(((uint64_t)1 << 40) / map->map_step);
}

/* Sets the plane of a straight beach: its direction is at right angles to the rise. */
static void set_plane(tp_foam_surf *surf, const tp_scene *scene)
{
    const tp_turn rise = tp_turn_of_degrees(scene->floor.heading);

    surf->node = NULL;
    surf->depth = scene->floor.depth;
    surf->rise_x = (int32_t)((int64_t)tp_sin(rise) * scene->floor.slope >> 16);
    surf->rise_z = -(int32_t)((int64_t)tp_cos(rise) * scene->floor.slope >> 16);
}

/* Returns the mean of the surf, more on the waves' backs and less on their fronts.  A slope
 * of twice the mean takes all of the swing. */
static uint32_t swung_mean(const tp_shade_foam *f, const tp_foam_surf *surf, uint32_t mean,
                           const tp_run *run, int32_t i)
{
    const int32_t up = (tp_slope_x(run, i, 0) * f->way_x + tp_slope_z(run, i, 0) * f->way_z)
                     / 16384;
    const int32_t back = (int32_t)tp_clamp_abs((int64_t)up * surf->per_slope / 65536, 256);

    return mean + (uint32_t)((int32_t)mean * surf->swing * back / 65536);
}

/* Returns the way from the first node to a place in nodes, Q16, below the last node. */
TP_ALWAYS_INLINE uint32_t node_coordinate(const tp_foam_surf *surf, uint32_t place,
                                          tp_fx first, uint32_t last)
{
    const uint32_t way = (tp_fx)place > first ? place - (uint32_t)first : 0;
    return (uint32_t)((uint64_t)(way < last ? way : last) * surf->per_step >> 24);
}

/* Returns a plane's depth at a place, m. */
static tp_fx plane_depth(const tp_foam_surf *surf, uint32_t s, uint32_t t)
{
    const int64_t up = (int64_t)(tp_fx)s * surf->rise_x + (int64_t)(tp_fx)t * surf->rise_z;
    return tp_fx_saturate(surf->depth - (up >> 30));
}

/* Returns the depth at a place, m, or `deepest` if the four nodes around are all as deep,
 * the case of most water.  Outside of the map the depth of its edge goes on. */
TP_ALWAYS_INLINE tp_fx shallow_depth(const tp_foam_surf *surf, uint32_t s, uint32_t t)
{
    if (!surf->node)
        return plane_depth(surf, s, t);
    const uint32_t u = node_coordinate(surf, s, surf->map_x, surf->last_x);
    const uint32_t v = node_coordinate(surf, t, surf->map_z, surf->last_z);
    const tp_coastal_floor_node *n = surf->node + (v >> 16) * surf->cols + (u >> 16);
    const tp_coastal_floor_node *below = n + surf->cols;
    const tp_fx deepest = surf->deepest;

    if (n[0].depth >= deepest && n[1].depth >= deepest && below[0].depth >= deepest
        && below[1].depth >= deepest)
        return deepest;
    const int32_t part = (int32_t)(u & 0xffff);
    return tp_coastal_mix(tp_coastal_mix(n[0].depth, n[1].depth, part),
                          tp_coastal_mix(below[0].depth, below[1].depth, part),
                          (int32_t)(v & 0xffff));
}

static uint32_t surf_cover(const tp_shade_foam *f, const tp_run *run, int32_t i, uint32_t v)
{
    const tp_foam_surf *surf = &((const tp_shade_foam_surf *)(const void *)f)->surf;
    const tp_fx depth = shallow_depth(surf, run->s[i], run->t[i]);

    if (depth <= 0 || depth >= surf->deepest)
        return 0;
    const tp_coastal_table_place at = tp_coastal_table_find(depth);
    const uint8_t *mean = surf->mean + at.depth, *open = surf->open + at.depth;
    const uint32_t share = (uint32_t)tp_coastal_mix(open[0], open[1], at.depth_fraction);
    const uint32_t there = (uint32_t)tp_coastal_mix(mean[0], mean[1], at.depth_fraction);
    uint32_t cover = there ? swung_mean(f, surf, there, run, i) : 0;

    if (share && surf->open_fresh)
        cover += tp_foam_open_cover(f, surf->open_fresh, surf->open_old, run, i, v)
               * share / 255;
    return cover < 255 ? cover : 255;
}

void tp_foam_surf_begin(tp_shade_foam_surf *both, const tp_foam *field,
                        const tp_wave_models *by, const tp_world *world,
                        const tp_scene *scene)
{
    tp_shade_foam *f = &both->foam;
    tp_foam_surf *surf = &both->surf;
    const tp_coastal_water *map = tp_foam_map(world);
    const uint32_t root = tp_isqrt64(((uint64_t)1 << 32) / f->per_square);  /* Q12 */

    if (map)
        set_nodes(surf, map);
    else
        set_plane(surf, scene);
    surf->open_fresh = f->far_fresh;
    surf->open_old = f->far_old;
    f->far_fresh = 0;
    f->floor = TP_FOAM_DEPTH;
    f->floor_cover = surf_cover;
    surf->per_slope = (1u << 23) / (root > SLOPE_LEAST ? root : SLOPE_LEAST);
    surf->swing = world->deep.count ? period_swing(world, scene) : 0;
    make_means(surf, field, by, world, scene);
}
