/* SPDX-License-Identifier: MIT */
/* Laying the ocean out in its block, and the order of its making. */
#include "wave/ocean.h"
#include "base/given.h"

#define NODES_LEAST 65          /* along the longer side of a map */
#define NODES_MOST  129
#define PIXELS_MOST 4096
#define SLOPE_LEAST 16          /* 2^-12: a floor that rises less is level */

/* -- the block --------------------------------------------------------------------- */

/* Where things lie in the block. */
typedef struct {
    size_t bytes, beds, rays, turns; /* rays: of the first wave; turns: for the making */
    uint32_t cols, rows;                /* of a map's nodes; 0: none */
} layout;

static size_t rounded(size_t bytes)
{
    return (bytes + 7) & ~(size_t)7;
}

static bool map_usable(const tp_grey *map)
{
    return map == NULL || (map->cols > 0 && map->cols <= PIXELS_MOST
                           && map->rows > 0 && map->rows <= PIXELS_MOST);
}

/* Nodes lie on the picture between the middles of its outermost pixels, from where on its
 * edge goes on level: `steps` of them along the longer side, as many as fit the other. */
static uint32_t nodes_along(uint32_t steps, uint32_t pixels, uint32_t most)
{
    const uint32_t nodes = most > 1 ? steps * (pixels - 1) / (most - 1) + 1 : 2;
    return nodes < 2 ? 2 : nodes;
}

static layout plan_of(const tp_grey *map, uint32_t count)
{
    const size_t tables = rounded(sizeof(tp_ocean) + count * sizeof(tp_ocean_table));
    if (map == NULL)
        return (layout){ .bytes = tables };

    const uint32_t most = map->cols >= map->rows ? map->cols : map->rows;
    const uint32_t nodes = (uint32_t)tp_clamp((int32_t)most, NODES_LEAST, NODES_MOST);
    layout plan = {
        .beds = tables, .cols = nodes_along(nodes - 1, map->cols, most),
        .rows = nodes_along(nodes - 1, map->rows, most),
    };
    const size_t all = (size_t)plan.cols * plan.rows;
    plan.rays = plan.beds + rounded(all * sizeof(tp_ocean_bed));
    plan.turns = plan.rays + count * rounded(all * sizeof(tp_ocean_ray));
    plan.bytes = plan.turns + all * sizeof(int64_t);
    return plan;
}

size_t tp_ocean_bytes(const tp_ocean_config *config, const tp_sea *sea)
{
    if (config == NULL || sea == NULL || !map_usable(config->floor.map))
        return 0;
    return plan_of(config->floor.map, sea->count).bytes;
}

static void *at_byte(const tp_ocean *ocean, size_t offset)
{
    return (char *)(uintptr_t)ocean + offset;
}

tp_ocean_bed *tp_ocean_beds(const tp_ocean *ocean)
{
    return at_byte(ocean, ocean->beds);
}

tp_ocean_ray *tp_ocean_rays(const tp_ocean *ocean, const tp_ocean_wave *wave)
{
    return at_byte(ocean, wave->rays);
}

/* -- the floor --------------------------------------------------------------------- */

static void make_straight(tp_ocean *ocean, const tp_floor *floor)
{
    const tp_way up = tp_way_of(floor->heading);

    ocean->depth = floor->depth == 0 ? TP_FX_MAX : floor->depth;
    ocean->slope = floor->depth == 0 ? 0 : tp_clamp(floor->slope, 0, TP_FX_ONE);
    if (ocean->slope < SLOPE_LEAST)
        ocean->slope = 0;
    ocean->up_x = up.x;
    ocean->up_z = up.z;
}

/* Metres between nodes, 16.16.  Where pixels are finer than nodes, depths are means of
 * what lies a quarter of a step around, so the outermost nodes stand back by that.  4096
 * times 8000 m has 41 bits. */
static uint32_t step_of(const tp_floor *floor, uint32_t nodes)
{
    const tp_grey *map = floor->map;
    const uint32_t most = map->cols >= map->rows ? map->cols : map->rows;
    const int64_t side = (int64_t)floor->map_size * (most > 1 ? most - 1 : 1) / map->cols;
    const int64_t step = most > nodes ? 2 * side / (2 * nodes - 1) : side / (nodes - 1);
    return (uint32_t)(step < TP_FX(125) ? step : TP_FX(125));
}

/* Pictures that are much taller than wide lose their ends to the longest step. */
static void make_map(tp_ocean *ocean, const tp_floor *floor, const layout *plan)
{
    const tp_fx far = TP_FX(16384);

    ocean->map_cols = plan->cols;
    ocean->map_rows = plan->rows;
    ocean->map_step = step_of(floor, plan->cols > plan->rows ? plan->cols : plan->rows);
    ocean->map_per_step = ((uint64_t)1 << 48) / ocean->map_step;
    ocean->map_x = tp_clamp(floor->map_x, -far, far)
                 - (int64_t)ocean->map_step * (plan->cols - 1) / 2;
    ocean->map_z = tp_clamp(floor->map_z, -far, far)
                 - (int64_t)ocean->map_step * (plan->rows - 1) / 2;
    ocean->beds = (uint32_t)plan->beds;
    tp_ocean_make_beds(ocean, floor);
}

/* -- the waves --------------------------------------------------------------------- */

/* The root of a length in 16.16, to the nearest: 2^25 squared twice and 8 bits more. */
static tp_fx length_of(tp_fx x, tp_fx z)
{
    const uint64_t square = (uint64_t)((int64_t)x * x + (int64_t)z * z);
    return (tp_fx)((tp_isqrt64(square << 8) + 8) >> 4);
}

static tp_ocean_swell swell_of(const tp_ocean *ocean, const tp_wave *wave,
                               const tp_swell *swell)
{
    tp_ocean_swell w = {
        .way = tp_way_of(wave->heading), .amplitude = swell->amplitude,
        .reach = length_of(swell->reach_x, swell->reach_z),
        .length = tp_clamp(wave->length, TP_FX(0.25), TP_FX(2000)),
    };
    const tp_way along = { -ocean->up_z, ocean->up_x };

    w.k_inf_q32 = tp_depth_number_deep(w.length);
    w.kz_q32 =
        ocean->slope > 0 ? tp_ocean_part(w.k_inf_q32, tp_way_dot(w.way, along)) : 0;
    return w;
}

/* [B20] of the beach: stretch and plunge of r and 2 r. */
static void set_breaker(tp_ocean *ocean, tp_ocean_wave *wave, const tp_ocean_swell *w,
                        tp_fx stretch)
{
    const tp_q30 slope = ocean->map_cols ? tp_ocean_beach(ocean, w->amplitude)
                                         : ocean->slope * (1 << 14);
    const tp_fx height = 2 * w->amplitude;
    const tp_breaker_type type =
        tp_breaker_type_of(tp_iribarren(slope, height, w->length));

    stretch = tp_clamp(stretch, 0, 2 * TP_FX_ONE);
    if (type == TP_BREAKER_PLUNGING) {
        wave->stretch = stretch;
        wave->plunge = 2 * stretch;
    } else if (type == TP_BREAKER_SPILLING) {
        wave->stretch = tp_fx_mul(stretch, TP_FX(0.3));
    }
}

/* A level floor bends nothing, but waves are shorter over it. */
static void shorten(tp_ocean *ocean, tp_ocean_wave *wave, const tp_ocean_swell *w)
{
    if (ocean->slope > 0 || ocean->map_cols || ocean->depth >= 1 << TP_OCEAN_LAST)
        return;
    const int64_t k = tp_ocean_number_at(w->k_inf_q32, ocean->depth);
    const int64_t more = tp_ocean_turns(k - w->k_inf_q32);
    wave->turns_x += tp_ocean_part(more, w->way.x);
    wave->turns_z += tp_ocean_part(more, w->way.z);
}

static void make_wave(tp_ocean *ocean, uint32_t i, const tp_wave *given,
                      const tp_swell *swell, const tp_ocean_config *config)
{
    const tp_ocean_swell w = swell_of(ocean, given, swell);
    const tp_way wind = tp_way_of(config->wind_heading);
    tp_ocean_wave *wave = &ocean->wave[i];

    *wave = (tp_ocean_wave){
        .turns_x = swell->turns_x, .turns_z = swell->turns_z,
        .way_x = w.way.x, .way_z = w.way.z, .iterations = 1,
        .lambda = tp_wind_lambda(tp_clamp(config->wind, 0, TP_FX_ONE),
                                 tp_way_dot(w.way, wind)),
    };
    shorten(ocean, wave, &w);
    set_breaker(ocean, wave, &w, config->stretch);
    tp_ocean_make_table(ocean, i, &w, config);
}

static void make_far(tp_ocean *ocean, uint32_t i, const tp_wave *given,
                     const tp_swell *swell, const layout *plan)
{
    const tp_ocean_swell w = swell_of(ocean, given, swell);
    const size_t all = (size_t)plan->cols * plan->rows;

    tp_ocean_make_phases(ocean, i, &w);
    if (plan->cols == 0)
        return;
    ocean->wave[i].rays =
        (uint32_t)(plan->rays + i * rounded(all * sizeof(tp_ocean_ray)));
    tp_ocean_make_rays(ocean, i, &w, at_byte(ocean, plan->turns));
}

/* -- bounds ------------------------------------------------------------------------ */

/* Of the sine of any tilt of a map, Q14: of the steepest rise, r / sqrt(1 + r^2). */
static int32_t tilt_most(const tp_ocean *ocean)
{
    const tp_ocean_bed *beds = tp_ocean_beds(ocean);
    int64_t most = 0;

    for (size_t i = 0; i < (size_t)ocean->map_cols * ocean->map_rows; i++) {
        const int64_t x = beds[i].rise_x, z = beds[i].rise_z, square = x * x + z * z;
        most = square > most ? square : most;
    }
    const int64_t length = tp_isqrt64((uint64_t)(most + (1 << 22)));    /* Q11 */
    return (int32_t)((tp_isqrt64((uint64_t)most) + 1) * 16384 / length);
}

/* The stretch and the lip are there only where the gate can open.  A little more than the
 * sum makes up for ways that are longer than one by their rounding. */
static void add_bounds(tp_ocean *ocean, uint32_t i, int32_t tilt)
{
    const tp_ocean_wave *wave = &ocean->wave[i];
    const tp_fx open = tp_fx_div(TP_FX(0.6), TP_FX_ONE + ocean->irregular / 2) - 1;
    tp_fx reach = 0, height = 0;

    for (uint32_t n = 1; n < TP_OCEAN_DEPTHS; n++) {
        const tp_ocean_depth *node = &tp_ocean_tables(ocean)[i].depth[n];
        const bool near = node->ratio > open || node[-1].ratio > open
                       || (n + 1 < TP_OCEAN_DEPTHS && node[1].ratio > open);
        const tp_fx lip = near ? tp_fx_mul(node->lip, wave->stretch + wave->plunge) : 0;
        const int32_t sin = ocean->map_cols ? tilt : node->tilt_sin;
        const tp_fx along = node->along + lip;
        const tp_fx up = node->up + (tp_fx)((int64_t)node->along * sin >> 14) + lip;
        reach = along > reach ? along : reach;
        height = up > height ? up : height;
    }
    ocean->reach += reach + reach / 1024 + 8;
    ocean->height += height + 8;
}

/* Below the deepest node where a wave may break, by its depth or its steepness. */
static void find_calm(tp_ocean *ocean, uint32_t i)
{
    const tp_ocean_depth *depth = tp_ocean_tables(ocean)[i].depth;
    uint32_t n = TP_OCEAN_DEPTHS;

    while (n > 0 && depth[n - 1].ratio < TP_OCEAN_RATIO_LEAST && depth[n - 1].steep == 0)
        n--;
    ocean->wave[i].calm = n;
}

static uint32_t moving(const tp_wave *waves, uint32_t count)
{
    uint32_t found = 0;

    for (uint32_t i = 0; i < count && i < TP_WAVES; i++)
        found += waves[i].amplitude > 0;
    return found;
}

static void make_waves(tp_ocean *ocean, const tp_ocean_config *config, const tp_sea *sea,
                       const tp_wave *waves, const layout *plan)
{
    const tp_wave *wave[TP_WAVES];
    const int32_t tilt = plan->cols ? tilt_most(ocean) : 0;
    uint32_t n = 0;

    for (const tp_wave *w = waves; n < sea->count; w++) {
        if (w->amplitude > 0)
            wave[n++] = w;
    }
    for (uint32_t i = 0; i < sea->count; i++)
        make_wave(ocean, i, wave[i], &sea->swell[i], config);
    tp_ocean_share(ocean);
    for (uint32_t i = 0; i < sea->count; i++) {
        make_far(ocean, i, wave[i], &sea->swell[i], plan);
        find_calm(ocean, i);
        add_bounds(ocean, i, tilt);
    }
}

tp_status tp_ocean_init(tp_ocean *ocean, const tp_ocean_config *config, const tp_sea *sea,
                        const tp_wave *waves, uint32_t count, tp_error *err)
{
    tp_status status = tp_given_block(ocean, 8, "ocean", err);

    if (status == TP_OK)
        status = tp_given_check(config, "config", err);
    if (status == TP_OK)
        status = tp_given_check(sea, "sea", err);
    if (status == TP_OK)
        status = tp_given_check(waves, "waves", err);
    if (status != TP_OK)
        return status;
    const tp_floor *floor = &config->floor;
    if (moving(waves, count) != sea->count || !map_usable(floor->map))
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);
    if (floor->map && (floor->map_size < TP_FX_ONE || floor->map_size > TP_FX(8000)))
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);

    const layout plan = plan_of(floor->map, sea->count);
    memset(ocean, 0, sizeof *ocean);
    ocean->count = sea->count;
    ocean->irregular = tp_clamp(config->irregular, 0, TP_FX_ONE);
    ocean->depth = TP_FX_MAX;
    if (floor->map)
        make_map(ocean, floor, &plan);
    else
        make_straight(ocean, floor);
    for (uint32_t n = 0; n + 1 < TP_OCEAN_DEPTHS; n++)
        ocean->fall[n] = tp_orbit_fall(config->k0, tp_ocean_node_depth(n, 3));
    make_waves(ocean, config, sea, waves, &plan);
    return TP_OK;
}
