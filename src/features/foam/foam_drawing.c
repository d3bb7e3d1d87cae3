/* SPDX-License-Identifier: MIT */
/* Prepares the drawing of foam: the field's position at the drawn moment, its texture and
 * colour. */
#include "features/foam/foam_cover.h"
#include "features/foam/foam_visit.h"
#include "features/foam/foam_window.h"
#include "frame/frame.h"
#include "world/pools.h"

/* Returns the drift in m at the drawn moment, `lag` of a tick before the world's current
 * tick. */
static tp_fx interpolate_drift(int64_t drift_q32, tp_fx speed, tp_fx lag)
{
    return (tp_fx)((drift_q32 - (int64_t)speed * lag / TP_TICKS_PER_SECOND) >> 16);
}

/* Sets the field: the cells of the last tick, at the lattice's drift of the drawn
 * moment. */
static void place_foam(tp_shade_foam *f, const tp_foam *foam, const tp_scene_map *map,
                       tp_fx lag)
{
    TP_ASSERT(foam->cells > 0 && foam->cell > 0);
    f->cover = (const uint8_t *)(foam + 1);
    f->cells = foam->cells;
    f->col = tp_foam_mod(foam->first_x - 1, foam->cells);
    f->row = tp_foam_mod(foam->first_z - 1, foam->cells);
    f->low_s = (tp_fx)((int64_t)foam->first_x * foam->cell
                       + interpolate_drift(foam->drift_x, map->drift_x, lag));
    f->low_t = (tp_fx)((int64_t)foam->first_z * foam->cell
                       + interpolate_drift(foam->drift_z, map->drift_z, lag));
    f->side = foam->cells * (uint32_t)foam->cell;
    f->per_metre = ((uint64_t)1 << 48) / (uint32_t)foam->cell;
}

/* Sets the texture's two scales. */
static void set_bubbles(const tp_frame *frame, tp_shade_foam *f, const tp_scene_map *map)
{
    tp_scene_map wide = *map;

    wide.size = tp_fx_saturate((int64_t)map->size * 4);
    const tp_layer layer = tp_frame_layer(frame, frame->assets.foam, map);
    const tp_layer patches = tp_frame_layer(frame, frame->assets.foam, &wide);
    f->texture = layer.texture;
    f->repeats = layer.per_metre;
    f->drift_s = layer.drift_s;
    f->drift_t = layer.drift_t;
    f->lod = layer.lod;
    f->wide_repeats = patches.per_metre;
    f->wide_drift_s = patches.drift_s;
    f->wide_drift_t = patches.drift_t;
}

/* Returns 1 over the mean square of the waves' slope, Q32 over Q24. */
static uint32_t per_mean_square(const tp_world *world)
{
    uint64_t square = 0;                    /* Q24 */

    for (uint32_t i = 0; i < world->deep.count; i++) {
        const int64_t x = world->deep.swell[i].slope_x / (1 << 18),
                      z = world->deep.swell[i].slope_z / (1 << 18);
        square += (uint64_t)(x * x + z * z) / 2;
    }
    return (uint32_t)(((uint64_t)1 << 32) / (square + 2));
}

/* Sets the mean way of the waves, each by its slope. */
static void set_mean_way(tp_shade_foam *f, const tp_world *world)
{
    int64_t x = 0, z = 0;                   /* Q20, below 2^26 */

    for (uint32_t i = 0; i < world->deep.count; i++) {
        x += world->deep.swell[i].slope_x / 1024;
        z += world->deep.swell[i].slope_z / 1024;
    }
    const int64_t length = (int64_t)tp_isqrt64((uint64_t)(x * x + z * z)) + 1;
    f->way_x = (int32_t)(x * 16384 / length);
    f->way_z = (int32_t)(z * 16384 / length);
}

/* Sets the direction of a straight beach, at right angles to the floor's rise, if its water
 * line passes the window's middle within half of the radius.  A stretch of 7/8 of the
 * window's radius repeats, so the stretch and its seam have their full weight. */
void tp_foam_set_shore(tp_shade_foam *f, const tp_scene *scene)
{
    const tp_turn rise = tp_turn_of_degrees(scene->floor.heading);
    const int64_t x = (int64_t)f->low_s + f->side / 2, z = (int64_t)f->low_t + f->side / 2;
    const int64_t up = (x * (tp_sin(rise) / 65536) - z * (tp_cos(rise) / 65536)) >> 14;
    const int64_t depth = scene->floor.depth - (up * scene->floor.slope >> 16);
    const int64_t most = (int64_t)(f->side / 4) * scene->floor.slope >> 16;

    if (depth >= most || -depth >= most)
        return;
    f->shore_x = tp_cos(rise) / 65536;
    f->shore_z = tp_sin(rise) / 65536;
    f->stretch = (int32_t)(f->side / 16 * 7);
    f->floor = TP_FOAM_BEACH;
    f->floor_cover = tp_foam_shore_cover;
}

#define OLD      128            /* of 256, over the field's mean: foam that crests left */
#define FRESH    352            /* of 256, over the field's mean: foam of crests, if none is
                                 * old.  The sum is above 1, since the cover is capped and the
                                 * lace shows less white than a small cover */
#define OLD_MEAN 4096           /* Q8: means below leave less old foam, as it shows no white */

/* Sets the cover of open water by its mean.  Half of the water has old foam: its share is
 * taken from the crests. */
static void set_open_water(tp_shade_foam *f, uint32_t mean)
{
    const uint32_t old = mean < OLD_MEAN ? OLD * mean / OLD_MEAN : OLD;

    f->far_old = old * mean >> 16;
    f->far_fresh = (FRESH - old / 2) * mean >> 8;
}

/* Sets the foam beyond the window: none where walls bound the foam, the field along a
 * straight beach, the field's mean where there is no floor or a map.  Over a map, and over a
 * beach whose line is farther away, the depth then replaces it (foam_surf.c). */
static void set_far_foam(const tp_frame *frame, tp_shade_foam *f, const tp_foam *foam)
{
    const struct tp_water_foam_coast *coast = frame->program->water.foam_coast;
    const bool pool = tp_world_pool(frame->world) != NULL;
    const uint64_t square = (uint64_t)(foam->cells * 128) * (foam->cells * 128);

    f->edge = pool ? UINT32_MAX : (uint32_t)(((uint64_t)1 << 44) / (7 * square));
    const bool open = !pool && (frame->assets.floor || !tp_has_floor(frame->scene));
    set_open_water(f, open ? tp_foam_open_mean(foam, frame->world) : 0);
    f->per_square = per_mean_square(frame->world);
    set_mean_way(f, frame->world);
    f->floor = 0;
    if (!pool && coast && tp_has_floor(frame->scene) && !frame->assets.floor)
        coast->set_shore(f, frame->scene);
}

/* Fast stages draw no cover below this, beyond the window by its largest. */
#define FAST_LEAST 16

/* Leaves out foam of open water too thin for fast stages. */
static void leave_out_thin_foam(tp_shade_foam *f)
{
    const uint32_t most = ((TP_FOAM_STEEP * TP_FOAM_STEEP >> 8) * f->far_fresh >> 16)
                        + f->far_old;

    if (most < FAST_LEAST)
        f->far_fresh = 0;
}

/* True if there may be foam beyond an empty window. */
static bool has_far_foam(const tp_shade_foam *f)
{
    return f->far_fresh
        || (f->floor == TP_FOAM_DEPTH
            && ((const tp_shade_foam_surf *)(const void *)f)->surf.deepest > 0);
}

/* Sets the foam's colour and texture, and the place of its cover under the picture's
 * water. */
static void begin_foam(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const tp_foam  *foam = tp_foam_of_world(frame->world);
    tp_shade_foam  *f = mine;
    const struct tp_water_foam_coast *coast = frame->program->water.foam_coast;

    if (!foam)
        return;
    set_bubbles(frame, f, &scene->foam.map);
    f->colour = (uint32_t)scene->foam.colour;
    place_foam(f, foam, &scene->foam.map, frame->world->lag);
    set_far_foam(frame, f, foam);
    const bool fast = scene->quality.foam >= TP_FOAM_FAST;
    const bool covered = tp_foam_find_empty_squares(f, fast ? FAST_LEAST : 1);
    if (fast)
        leave_out_thin_foam(f);
    if (f->has_surf && f->floor != TP_FOAM_BEACH && f->edge != UINT32_MAX && coast
        && tp_world_coastal(frame->world))
        coast->begin_surf(mine, foam, &frame->program->water, frame->world, scene);
    f->none = !covered && !has_far_foam(mine);
}

/* Returns the index of the stage for a list of exact or fast water. */
static int select_stage(const tp_frame *frame, const tp_shaders *list)
{
    static const uint8_t exact[] = { TP_NTH_foam, TP_NTH_foam_rippled, TP_NTH_foam_shiny,
                                     TP_NTH_foam_shiny_rippled };
    const int32_t rung = frame->scene->quality.foam;

    if (rung >= TP_FOAM_PLAIN)
        return list->shines ? TP_NTH_foam_plain_shiny : TP_NTH_foam_plain;
    if (rung == TP_FOAM_FAST)
        return list->shines ? TP_NTH_foam_fast_shiny : TP_NTH_foam_fast;
    return list->kind == TP_LIST_FAST ? TP_NTH_foam_packed
                                      : exact[list->rippled + 2 * list->shines];
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    if ((list->kind == TP_LIST_WATER || list->kind == TP_LIST_FAST)
        && tp_foam_of_world(frame->world))
        tp_shaders_add(list, TP_AT_MATT, stage[select_stage(frame, list)], mine);
}

/* True for foam over a floor: a tp_foam_surf follows its data. */
static bool has_surf(const tp_scene *scene)
{
    return tp_has_floor(scene) && scene->pool.cols == 0;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    return tp_arena_alloc(arena, 1, has_surf(conditions->scene) ? sizeof(tp_shade_foam_surf)
                                                                : sizeof(tp_shade_foam));
}

static void init(tp_frame *frame, void *mine)
{
    tp_shade_foam *f = mine;

    memset(f, 0, sizeof *f);
    f->has_surf = has_surf(frame->scene);
    if (frame->assets.foam)
        tp_shade_foam_make_ranks(f, frame->assets.foam);
}

const tp_drawing tp_foam_drawing = {
    .layout = layout, .init = init, .begin = begin_foam, .stages = add_stage,
};
