/* SPDX-License-Identifier: MIT */
/* Layout of coastal water in its block, and the order of its construction. */
#include "base/base.h"
#include "waves/coastal_tables.h"

#define NODES_LEAST 65          /* along the longer side of a map */
#define NODES_MOST  129
#define PIXELS_MOST 4096
#define SLOPE_LEAST 16          /* 2^-12: a smaller slope counts as level */

/* -- the block ----------------------------------------------------------------------- */

/* Byte offsets of the parts of the block. */
typedef struct {
    size_t bytes, floor_nodes, wave_nodes,
        turns; /* rays: of the first wave; turns: scratch memory */
    uint32_t cols, rows;                /* nodes of a map; 0: no map */
} block_layout;

static size_t round_up_to_8(size_t bytes)
{
    return (bytes + 7) & ~(size_t)7;
}

static bool is_map_usable(const tp_grey *map)
{
    return map == NULL || (map->cols > 0 && map->cols <= PIXELS_MOST
                           && map->rows > 0 && map->rows <= PIXELS_MOST);
}

/* Returns the number of nodes along a side.  Nodes cover the map between the centres
 * of its outermost pixels; outside the edge goes on level.  The longer side has
 * `longer_side_steps` steps, the other side as many as fit. */
static uint32_t count_side_nodes(uint32_t longer_side_steps, uint32_t side_pixels,
                                 uint32_t longer_side_pixels)
{
    const uint32_t nodes =
        longer_side_pixels > 1
            ? longer_side_steps * (side_pixels - 1) / (longer_side_pixels - 1) + 1
            : 2;
    return nodes < 2 ? 2 : nodes;
}

static block_layout make_layout(const tp_grey *map, uint32_t wave_count)
{
    const size_t tables = TP_COASTAL_STRAIGHT_BYTES(wave_count);
    if (map == NULL)
        return (block_layout){ .bytes = tables };

    const uint32_t most = map->cols >= map->rows ? map->cols : map->rows;
    const uint32_t nodes = (uint32_t)tp_clamp((int32_t)most, NODES_LEAST, NODES_MOST);
    block_layout plan = {
        .floor_nodes = tables, .cols = count_side_nodes(nodes - 1, map->cols, most),
        .rows = count_side_nodes(nodes - 1, map->rows, most),
    };
    const size_t all = (size_t)plan.cols * plan.rows;
    plan.wave_nodes =
        plan.floor_nodes + round_up_to_8(all * sizeof(tp_coastal_floor_node));
    plan.turns =
        plan.wave_nodes + wave_count * round_up_to_8(all * sizeof(tp_coastal_wave_node));
    plan.bytes = plan.turns + all * sizeof(int64_t);
    return plan;
}

size_t tp_coastal_bytes(const tp_coastal_config *config, const tp_deep_water *deep)
{
    if (config == NULL || deep == NULL || !is_map_usable(config->floor.map))
        return 0;
    return make_layout(config->floor.map, deep->count).bytes;
}

size_t tp_coastal_table_bytes(const tp_coastal_water *coastal)
{
    const size_t nodes = (size_t)coastal->map_cols * coastal->map_rows;

    return TP_COASTAL_STRAIGHT_BYTES(coastal->count)
           + round_up_to_8(nodes * sizeof(tp_coastal_floor_node))
           + coastal->count * round_up_to_8(nodes * sizeof(tp_coastal_wave_node));
}

/* -- inputs of the tables ------------------------------------------------------------ */

/* A map ignores the numbers of the straight floor, and a straight floor ignores the
 * numbers of a map. */
static tp_coastal_floor_inputs make_floor_key(const tp_coastal_config *config)
{
    const tp_floor *f = &config->floor;

    if (f->map)
        return (tp_coastal_floor_inputs){
            .map_x = f->map_x, .map_z = f->map_z, .map_size = f->map_size,
            .map_low = f->map_low, .map_high = f->map_high,
        };
    return (tp_coastal_floor_inputs){ .depth = f->depth, .slope = f->slope,
                                 .heading = f->heading };
}

static tp_coastal_model_inputs make_model_key(const tp_coastal_config *config)
{
    return (tp_coastal_model_inputs){ config->wind, config->wind_heading, config->k0,
                                 config->kx, config->ky, config->stretch,
                                 config->irregular };
}

/* The turns per metre of a swell follow from length and heading, and need no field. */
static tp_coastal_swell_inputs make_swell_key(const tp_wave *wave, const tp_swell *swell)
{
    return (tp_coastal_swell_inputs){ wave->length, wave->heading, swell->amplitude,
                                      swell->orbit_x, swell->orbit_z };
}

static bool has_same_node_counts(const tp_coastal_water *coastal, const tp_grey *map)
{
    const block_layout plan = make_layout(map, coastal->count);
    return plan.cols == coastal->map_cols && plan.rows == coastal->map_rows;
}

/* -- the floor ----------------------------------------------------------------------- */

static void set_straight_floor(tp_coastal_water *coastal, const tp_floor *floor)
{
    const tp_way up = tp_way_from_degrees(floor->heading);

    coastal->depth = floor->depth == 0 ? TP_FX_MAX : floor->depth;
    coastal->slope = floor->depth == 0 ? 0 : tp_clamp(floor->slope, 0, TP_FX_ONE);
    if (coastal->slope < SLOPE_LEAST)
        coastal->slope = 0;
    coastal->up_x = up.x;
    coastal->up_z = up.z;
}

/* Returns the distance of nodes, m, 16.16.  If pixels are finer than nodes, a node's depth
 * is the mean of four points a quarter of a step around the node: the outermost nodes keep
 * this distance from the edge.  4096 times 8000 m has 41 bits. */
static uint32_t node_spacing(const tp_floor *floor, uint32_t nodes)
{
    const tp_grey *map = floor->map;
    const uint32_t most = map->cols >= map->rows ? map->cols : map->rows;
    const int64_t side = (int64_t)floor->map_size * (most > 1 ? most - 1 : 1) / map->cols;
    const int64_t step = most > nodes ? 2 * side / (2 * nodes - 1) : side / (nodes - 1);
    return (uint32_t)(step < TP_FX(125) ? step : TP_FX(125));
}

/* Sets size, place and step of the floor map, and computes the floor nodes.
 * `keep_floor_nodes`: the block already holds the nodes of this floor.  The step is limited
 * to 125 m: a map much taller than wide loses its ends. */
static void set_floor_map(tp_coastal_water *coastal, const tp_floor *floor,
                          const block_layout *plan, bool keep_floor_nodes)
{
    const tp_fx far = TP_FX(16384);

    coastal->map_cols = plan->cols;
    coastal->map_rows = plan->rows;
    coastal->map_step =
        node_spacing(floor, plan->cols > plan->rows ? plan->cols : plan->rows);
    coastal->map_per_step = ((uint64_t)1 << 48) / coastal->map_step;
    coastal->map_x = tp_clamp(floor->map_x, -far, far)
                     - (int64_t)coastal->map_step * (plan->cols - 1) / 2;
    coastal->map_z = tp_clamp(floor->map_z, -far, far)
                     - (int64_t)coastal->map_step * (plan->rows - 1) / 2;
    coastal->floor_nodes = (uint32_t)plan->floor_nodes;
    if (!keep_floor_nodes)
        tp_coastal_make_floor_nodes(coastal, floor);
}

/* -- the waves ----------------------------------------------------------------------- */

/* Returns the length of (x, z) in 16.16, rounded to nearest: 2^25 squared, twice,
 * and 8 more bits. */
static tp_fx vector_length(tp_fx x, tp_fx z)
{
    const uint64_t square = (uint64_t)((int64_t)x * x + (int64_t)z * z);
    return (tp_fx)((tp_isqrt64(square << 8) + 8) >> 4);
}

static tp_coastal_swell make_swell(const tp_coastal_water *coastal, const tp_wave *wave,
                                   const tp_swell *swell)
{
    tp_coastal_swell w = {
        .way = tp_way_from_degrees(wave->heading), .amplitude = swell->amplitude,
        .reach = vector_length(swell->orbit_x, swell->orbit_z),
        .length = tp_clamp(wave->length, TP_FX(0.25), TP_FX(2000)),
    };
    const tp_way along = { -coastal->up_z, coastal->up_x };

    w.k_inf_q32 = tp_depth_wave_number_deep(w.length);
    w.kz_q32 = coastal->slope > 0
                   ? tp_coastal_scale_q30(w.k_inf_q32, tp_way_dot(w.way, along))
                   : 0;
    return w;
}

/* Sets the breaker factors of the beach [B20]: stretch is a factor of r, plunge is
 * the factor for 2 r.  A surging wave has no roller: a quarter of the foam,
 * and orbits that do not widen, so that its front never overhangs. */
static void set_breaker(tp_coastal_water *coastal, tp_coastal_wave *wave,
                        tp_coastal_swell *w, tp_fx stretch)
{
    const tp_q30 slope = coastal->map_cols ? tp_coastal_beach_slope(coastal, w->amplitude)
                                           : coastal->slope * (1 << 14);
    const tp_fx height = 2 * w->amplitude;
    const tp_breaker_type type =
        tp_breaker_classify(tp_iribarren(slope, height, w->length));

    stretch = tp_clamp(stretch, 0, 2 * TP_FX_ONE);
    w->surging = type == TP_BREAKER_SURGING;
    wave->foam = w->surging ? 64 : 256;
    if (type == TP_BREAKER_PLUNGING) {
        wave->stretch = stretch;
        wave->plunge = 2 * stretch;
    } else if (type == TP_BREAKER_SPILLING) {
        wave->stretch = tp_fx_mul(stretch, TP_FX(0.3));
    }
}

/* A level floor does not turn waves, but shortens them. */
static void shorten_wave_on_level_floor(tp_coastal_water *coastal, tp_coastal_wave *wave,
                                        const tp_coastal_swell *w)
{
    if (coastal->slope > 0 || coastal->map_cols || coastal->depth >= 1 << TP_COASTAL_LAST)
        return;
    const int64_t k = tp_coastal_local_wave_number(w->k_inf_q32, coastal->depth);
    const int64_t more = tp_coastal_turns_per_metre(k - w->k_inf_q32);
    wave->turns_x += tp_coastal_scale_q30(more, w->way.x);
    wave->turns_z += tp_coastal_scale_q30(more, w->way.z);
}

static void make_wave(tp_coastal_water *coastal, uint32_t i, const tp_wave *given,
                      const tp_swell *swell, const tp_coastal_config *config)
{
    tp_coastal_swell w = make_swell(coastal, given, swell);
    const tp_way wind = tp_way_from_degrees(config->wind_heading);
    tp_coastal_wave *wave = &coastal->wave[i];

    *wave = (tp_coastal_wave){
        .turns_x = swell->turns_x, .turns_z = swell->turns_z,
        .way_x = w.way.x, .way_z = w.way.z, .iterations = 1,
        .lambda = tp_wind_lambda(tp_clamp(config->wind, 0, TP_FX_ONE),
                                 tp_way_dot(w.way, wind)),
    };
    shorten_wave_on_level_floor(coastal, wave, &w);
    set_breaker(coastal, wave, &w, config->stretch);
    tp_coastal_make_table(coastal, i, &w, config);
}

static void make_wave_phases(tp_coastal_water *coastal, uint32_t i, const tp_wave *given,
                             const tp_swell *swell, const block_layout *plan,
                             bool reuse_wave_nodes)
{
    tp_coastal_swell w = make_swell(coastal, given, swell);
    const size_t all = (size_t)plan->cols * plan->rows;

    tp_coastal_make_phases_by_depth(coastal, i, &w);
    if (plan->cols == 0)
        return;
    coastal->wave[i].wave_nodes =
        (uint32_t)(plan->wave_nodes
                   + i * round_up_to_8(all * sizeof(tp_coastal_wave_node)));
    if (!reuse_wave_nodes)
        tp_coastal_make_wave_nodes(coastal, i, &w,
                                   tp_coastal_at_byte(coastal, plan->turns));
}

/* -- the whole ----------------------------------------------------------------------- */

/* Parts of the block that are still valid and stay. */
typedef struct {
    bool     floor_nodes;
    uint32_t wave_nodes;              /* one bit per swell */
} parts_kept;

static void make_waves(tp_coastal_water *coastal, const tp_coastal_config *config,
                       const tp_deep_water *deep, const tp_wave *const wave[TP_WAVES],
                       const block_layout *plan, parts_kept kept)
{
    const int32_t tilt = plan->cols ? tp_coastal_floor_tilt_sine_bound(coastal) : 0;

    for (uint32_t i = 0; i < deep->count; i++)
        make_wave(coastal, i, wave[i], &deep->swell[i], config);
    tp_coastal_limit_steepness_sum(coastal);
    for (uint32_t i = 0; i < deep->count; i++) {
        make_wave_phases(coastal, i, wave[i], &deep->swell[i], plan,
                         kept.wave_nodes >> i & 1);
        tp_coastal_add_bounds(coastal, i, tilt);
    }
}

/* The scratch memory of the solver is left all 0, whichever swells used the memory. */
static void clear_scratch_turns(tp_coastal_water *coastal, const block_layout *plan)
{
    if (plan->cols)
        memset(tp_coastal_at_byte(coastal, plan->turns), 0, plan->bytes - plan->turns);
}

static void build_coastal(tp_coastal_water *coastal, const tp_coastal_config *config,
                          const tp_deep_water *deep, const tp_wave *const wave[TP_WAVES],
                          parts_kept kept)
{
    const tp_floor *floor = &config->floor;
    const block_layout plan = make_layout(floor->map, deep->count);

    memset(coastal, 0, sizeof *coastal);
    coastal->count = deep->count;
    coastal->irregular = tp_clamp(config->irregular, 0, TP_FX_ONE);
    coastal->depth = TP_FX_MAX;
    coastal->floor_key = make_floor_key(config);
    coastal->model_key = make_model_key(config);
    if (floor->map)
        set_floor_map(coastal, floor, &plan, kept.floor_nodes);
    else
        set_straight_floor(coastal, floor);
    for (uint32_t n = 0; n + 1 < TP_COASTAL_DEPTHS; n++)
        coastal->fall[n] = tp_orbit_depth_decay(config->k0, tp_coastal_node_depth(n, 3));
    make_waves(coastal, config, deep, wave, &plan, kept);
    for (uint32_t i = 0; i < deep->count; i++)
        tp_coastal_tables(coastal)[i].key = make_swell_key(wave[i], &deep->swell[i]);
    clear_scratch_turns(coastal, &plan);
}

/* Fills `wave` with the waves of amplitude > 0, in the order of the swells.  False if they
 * are not as many as the swells, or if the map is unusable. */
static bool collect_waves(const tp_coastal_config *config, const tp_deep_water *deep,
                          const tp_wave *waves, uint32_t count,
                          const tp_wave *wave[TP_WAVES])
{
    const tp_floor *floor = &config->floor;
    uint32_t n = 0;

    if (!is_map_usable(floor->map)
        || (floor->map && (floor->map_size < TP_FX_ONE || floor->map_size > TP_FX(8000))))
        return false;
    for (uint32_t i = 0; i < count && i < TP_WAVES; i++) {
        if (waves[i].amplitude > 0)
            wave[n++] = &waves[i];
    }
    return n == deep->count;
}

static tp_status check_given(const tp_coastal_water *coastal,
                             const tp_coastal_config *config, const tp_deep_water *deep,
                             const tp_wave *waves, uint32_t count,
                             const tp_wave *wave[TP_WAVES], tp_error *err)
{
    tp_status status = tp_pointer_check_aligned(coastal, 8, "coastal", err);

    if (status == TP_OK)
        status = tp_pointer_check(config, "config of the coast", err);
    if (status == TP_OK)
        status = tp_pointer_check(deep, "sea", err);
    if (status == TP_OK)
        status = tp_pointer_check(waves, "waves", err);
    if (status == TP_OK && !collect_waves(config, deep, waves, count, wave))
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);
    return status;
}

tp_status tp_coastal_init(tp_coastal_water *coastal, const tp_coastal_config *config,
                          const tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                          tp_error *err)
{
    const tp_wave *wave[TP_WAVES];
    const tp_status status = check_given(coastal, config, deep, waves, count, wave, err);

    if (status == TP_OK)
        build_coastal(coastal, config, deep, wave, (parts_kept){ .floor_nodes = false });
    return status;
}

/* Finds the parts of the block that are still valid; true if all are. */
static bool find_kept_parts(const tp_coastal_water *coastal, const tp_coastal_config *config,
                            const tp_deep_water *deep, const tp_wave *const wave[TP_WAVES],
                            parts_kept *kept)
{
    const tp_coastal_floor_inputs floor = make_floor_key(config);
    const tp_coastal_model_inputs model = make_model_key(config);

    *kept = (parts_kept){ .floor_nodes =
                              memcmp(&floor, &coastal->floor_key, sizeof floor) == 0 };
    bool same =
        kept->floor_nodes && memcmp(&model, &coastal->model_key, sizeof model) == 0;
    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_coastal_swell_inputs key = make_swell_key(wave[i], &deep->swell[i]);
        const tp_coastal_swell_inputs *was = &tp_coastal_tables(coastal)[i].key;
        if (kept->floor_nodes && key.length == was->length && key.heading == was->heading)
            kept->wave_nodes |= (uint32_t)1 << i;
        same = same && memcmp(&key, was, sizeof key) == 0;
    }
    return same;
}

tp_status tp_coastal_refresh(tp_coastal_water *coastal, const tp_coastal_config *config,
                             const tp_deep_water *deep, const tp_wave *waves,
                             uint32_t count, tp_error *err)
{
    const tp_wave *wave[TP_WAVES];
    const tp_status status = check_given(coastal, config, deep, waves, count, wave, err);

    if (status != TP_OK)
        return status;
    if (coastal->count != deep->count
        || !has_same_node_counts(coastal, config->floor.map))
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);

    parts_kept kept;
    if (!find_kept_parts(coastal, config, deep, wave, &kept))
        build_coastal(coastal, config, deep, wave, kept);
    return TP_OK;
}

bool tp_coastal_is_current(const tp_coastal_water *coastal, const tp_coastal_config *config,
                           const tp_deep_water *deep, const tp_wave *waves, uint32_t count)
{
    const tp_wave *wave[TP_WAVES];
    parts_kept kept;

    return check_given(coastal, config, deep, waves, count, wave, NULL) == TP_OK
           && coastal->count == deep->count
           && has_same_node_counts(coastal, config->floor.map)
           && find_kept_parts(coastal, config, deep, wave, &kept);
}
