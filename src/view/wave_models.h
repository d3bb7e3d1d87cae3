/* SPDX-License-Identifier: MIT */
/* The wave models of the water surface, as structs that a program links.  A surface
 * points to its program's models and uses no others. */
#ifndef TP_VIEW_WAVE_MODELS_H
#define TP_VIEW_WAVE_MODELS_H
#include "view/grid.h"
#include "view/grid_vertex.h"
#include "view/level_plane.h"

/* Adds the heights and slopes of rings and pools to a run of vertices. */
typedef void (*tp_batch_add_model)(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                                 tp_grid_vertex *vertex);

struct tp_water_rings {
    tp_height_slope (*height_slope)(const tp_ring_now *rings, uint32_t count, tp_fx x,
                                    tp_fx z);
    bool (*at)(const tp_ring *ring, int64_t time, tp_ring_now *now);
    tp_batch_add_model run;
};

struct tp_water_pools {
    tp_height_slope (*height_slope)(const tp_pool *pool, tp_fx x, tp_fx z, tp_fx back);
    tp_fx (*highest)(const tp_pool *pool);
    tp_batch_add_model run;
};

struct tp_water_swells {
    void (*init)(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                 tp_fx gravity);
    tp_surface_point (*above)(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                              tp_fx x, tp_fx z, tp_fx rest[2]);
    void (*begin)(tp_vertex_frame *frame);
    void (*columns)(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                    uint32_t first, uint32_t end, tp_fx cell);
    void (*row)(const tp_vertex_frame *frame, tp_vertex_row *row, bool sloped);
    /* displace_axis: a view axis of a batch, from + rest; slope: the slopes of a batch. */
    void (*displace_axis)(const tp_vertex_batch_input *place, int axis, const int32_t *from,
                 int32_t rest, int32_t *to);
    void (*slope)(const tp_vertex_batch_input *place, tp_grid_vertex *to);
    /* Returns a point of a screen grid over level water. */
    tp_surface_point (*point)(const tp_level *level, const tp_surface *surface,
                              const tp_fx place[2], tp_fx step[2][2]);
    bool few;                   /* true: memory for the scene's own swells only */
};

struct tp_water_sharp {         /* swells with sharpened crests; needs swells */
    void (*run)(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                tp_grid_vertex *vertex);
};

struct tp_water_coastal {
    tp_fx (*max_displacement)(const tp_coastal_water *coastal);
    tp_fx (*height)(const tp_coastal_water *coastal);
    tp_surface_point (*above)(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx rest[2]);
    tp_coastal_point (*smooth)(const tp_coastal_water *coastal,
                               const tp_turn phases[TP_WAVES], tp_fx x0, tp_fx z0);
    tp_floor_at (*floor)(const tp_coastal_water *coastal, tp_fx x, tp_fx z);
    void (*layout)(tp_grid *grid, tp_arena *arena);
    void (*row)(tp_grid *grid, uint32_t j, tp_grid_span needed);
    tp_view_vertex (*corner)(const tp_grid *grid, uint32_t i, uint32_t j);
};
#endif
