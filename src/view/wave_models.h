/* SPDX-License-Identifier: MIT */
/*
 * Level water in the picture, pixel by pixel, without a mesh; and the wave models of the
 * water surface, as structs that a program links.  A surface points to its program's
 * models and uses no others.
 */
#ifndef TP_VIEW_WAVE_MODELS_H
#define TP_VIEW_WAVE_MODELS_H
#include "view/grid.h"
#include "view/projection.h"
#include "view/surface.h"
#include "waves/deep_water.h"

/* -- level water --------------------------------------------------------------------- */

/* The ray of pixel (X, Y) is d = focal ahead + u right + v up, with u and v in px from
 * the picture's centre.  Along any world direction d is a sum that is linear in X and Y.
 * From an eye at height h the ray meets the water at eye + d h / -d.y, so
 *     near / depth is linear in X and Y, with its own sum;
 *     s and t need the reciprocal of -d.y, constant along a row without roll;
 *     each straight side of the water is a sign, e.g. h d.x <= (x1 - eye.x) (-d.y).
 * Values depend on absolute X and Y, so tile borders are not visible. */

/* A linear sum: at + x X + y Y at the centre of pixel (X, Y). */
typedef struct {
    int64_t at, x, y;
} tp_level_linear;

#define TP_LEVEL_SIDES 5        /* west, east, north, south, near plane */
#define TP_LEVEL_ZI    12       /* bits of zi beyond Q1.31 */

typedef struct {
    tp_level_linear down, east, south;     /* -d.y, d.x, d.z, px, Q.30 */
    tp_level_linear zi;                    /* near / depth, Q1.43 */
    tp_level_linear side[TP_LEVEL_SIDES];  /* water if no side is negative */
    tp_fx height, x, z;                    /* position of the eye, m */
    bool  rolled;
} tp_level;

#define TP_LEVEL_HEIGHT TP_FX(0.0625)   /* smallest height of the eye, m */

#define TP_LEVEL_FAR (16000 * TP_FX_ONE)    /* the water's sides around the eye, m */

/* Sets up the sums. The eye is at least TP_LEVEL_HEIGHT above the level. */
void tp_level_begin(tp_level *level, const tp_projection *projection);

TP_ALWAYS_INLINE int64_t tp_level_evaluate(const tp_level_linear *sum, int32_t x, int32_t y)
{
    return sum->at + sum->x * x + sum->y * y;
}

/* A straight line in the picture: the row at column X, px in Q.30, is at + x X. */
typedef struct {
    int64_t at, x;
} tp_level_line;

/* Returns the line where a sum is 0.  The sum must increase downwards, at least as fast
 * as sideways. */
tp_level_line tp_level_zero_line(const tp_level_linear *sum);

/* Evaluates a sum at column x and a row in Q.30; rows and sums are below 2^14. */
TP_ALWAYS_INLINE int64_t tp_level_evaluate_fractional_row(const tp_level_linear *sum,
                                                          int32_t x, int64_t row_q30)
{
    return sum->at + sum->x * x + (sum->y * (row_q30 >> 14) >> 16);
}

/* h / -d.y as factor / 2^shift: metres (16.16) per pixel (Q.16). */
typedef struct {
    int32_t factor;
    int     shift;
} tp_level_scale;

tp_level_scale tp_level_metres_per_pixel(const tp_level *level,
                                         int64_t ray_down); /* `down` > 0 */

/* Returns metres, 16.16: 31 bits times 30. Bits above 32 are cut off. */
TP_ALWAYS_INLINE int64_t tp_level_pixels_to_metres(tp_level_scale scale, int64_t pixels_q30)
{
    return (int64_t)scale.factor * (int32_t)(pixels_q30 >> 14) >> scale.shift;
}

/* Clips *x0..*x1 to the pixels of row y with water; tests only the sides in `mask`. */
void tp_level_clip_span(const tp_level *level, unsigned mask, int32_t y, int32_t *x0,
                        int32_t *x1);

/* Returns the sides that cut a tile, as bits: at least one pixel lies beyond the side. x1
 * and y1 are not included. */
unsigned tp_level_clip_mask(const tp_level *level, int32_t x0, int32_t y0, int32_t x1,
                            int32_t y1);

/* Returns the surface point of a rest position, for sample points `step` apart in two
 * directions.  Waves shorter than two steps are omitted, waves longer than four steps
 * have full height. */
tp_surface_point tp_level_sample_surface(const tp_surface *surface, const tp_fx place[2],
                                         tp_fx step[2][2]);

/* Returns the slopes in the format of the G-buffer: x:z, Q3.12 each. */
static inline uint32_t tp_level_pack_slopes(const tp_surface_point *at)
{
    int32_t x = tp_clamp((at->slope_x + 8) >> 4, INT16_MIN, INT16_MAX);
    int32_t z = tp_clamp((at->slope_z + 8) >> 4, INT16_MIN, INT16_MAX);
    return (uint32_t)x << 16 | ((uint32_t)z & 0xffff);
}

/* -- wave models --------------------------------------------------------------------- */

struct tp_fan;
struct tp_fan_row;

/* Rings and pools at the vertices of a row: their weight, and their sum. */
struct tp_fan_relief {
    tp_fx (*weight)(const struct tp_fan *fan, const struct tp_fan_row *row);
    tp_height_slope (*sample)(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx weight);
};

struct tp_water_rings {
    tp_height_slope (*height_slope)(const tp_ring_now *rings, uint32_t count, tp_fx x,
                                    tp_fx z);
    bool (*at)(const tp_ring *ring, int64_t time, tp_ring_now *now);
    const struct tp_fan_relief *relief;
};

struct tp_water_pools {
    tp_height_slope (*height_slope)(const tp_pool *pool, const tp_pool_kind *kind, tp_fx x,
                                    tp_fx z, tp_fx lag);
    tp_fx (*highest)(const tp_pool *pool);
    const struct tp_fan_relief *relief;
};

/* The kinds of pools. */
#define X(name) struct tp_water_pool_##name { const tp_pool_kind *kind; };
TP_POOL_KINDS(X)
#undef X

/* Returns a program's kind of this number, or of a pool; NULL: the program lacks it. */
const tp_pool_kind *tp_models_numbered_kind(const tp_wave_models *by, uint32_t number);

static inline const tp_pool_kind *tp_models_pool_kind(const tp_wave_models *by,
                                                  const tp_pool *pool)
{
    return tp_models_numbered_kind(
        by, tp_pool_kind_number((tp_cells)pool->cells, pool->walls != 0, pool->sponge != 0));
}

/* Splashes in pools: of drops, and of pools that drive their water [C16]. */
struct tp_water_pool_splashes {
    bool (*add)(tp_pool *pool, tp_fx x, tp_fx z, tp_fx sigma, tp_fx height);
    tp_pool_drive *drive;
};

struct tp_water_swells {
    void (*init)(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                 tp_fx gravity);    /* NULL: the world is baked */
    bool few;                   /* true: memory for the scene's own swells only */
};

/* The swells above a position, and their points of rest positions; without them water
 * samples are level. */
struct tp_water_samples {
    tp_surface_point (*above)(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                              tp_fx x, tp_fx z, tp_fx rest[2]);
    tp_surface_point (*displaced)(const tp_deep_water *deep,
                                  const tp_turn phases[TP_WAVES], tp_fx x, tp_fx z);
};

/* The points of a screen grid over level water. */
struct tp_water_points {
    tp_surface_point (*point)(const tp_surface *surface, const tp_fx place[2],
                              tp_fx step[2][2]);
};

struct tp_fan_wave;
struct tp_fan_waves;
struct tp_fan_view;

struct tp_water_coastal {
    tp_fx (*max_displacement)(const tp_coastal_water *coastal);
    tp_fx (*height)(const tp_coastal_water *coastal);
    tp_surface_point (*above)(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx rest[2]);
    tp_coastal_point (*breaking)(const tp_coastal_water *coastal,
                                 const tp_turn phases[TP_WAVES], tp_fx x0, tp_fx z0);
    tp_coastal_point (*smooth)(const tp_coastal_water *coastal,
                               const tp_turn phases[TP_WAVES], tp_fx x0, tp_fx z0);
    tp_surface_point (*near)(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx off[2]);
    tp_floor_at (*floor)(const tp_coastal_water *coastal, tp_fx x, tp_fx z);
    void (*layout)(tp_grid *grid, tp_arena *arena, uint32_t vertices);
    /* Evaluates vertices of row j into vertex[needed.first] and on. */
    void (*row)(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                tp_grid_span needed, tp_grid_vertex *vertex);
    tp_view_vertex (*corner)(const tp_grid *grid, uint32_t i, uint32_t j);
    /* Waves in a wind at the vertices of rows, fan_vertices.c. */
    void (*set_wind)(struct tp_fan_wave *wave, const tp_coastal_water *coastal, tp_fx share,
                     uint32_t i);
    tp_surface_point (*wind_point)(const struct tp_fan_waves *waves, uint32_t i, tp_fx x,
                                   tp_fx z);
    /* Raises the land of a view to the floor in sight, fan_view.c. */
    void (*widen_land)(struct tp_fan_view *view, const tp_surface *surface);
};

#endif
