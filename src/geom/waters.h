/* SPDX-License-Identifier: MIT */
/* The models of the water's surface, as a program links them.  A surface points to its
 * program's models and consists of those alone. */
#ifndef TP_GEOM_WATERS_H
#define TP_GEOM_WATERS_H
#include "geom/level.h"
#include "geom/lod.h"
#include "geom/run.h"
#include "geom/sheet.h"

/* Adds what lies on the swells to a run of crossings. */
typedef void (*tp_run_relief_of)(const tp_vertex_place_of *place, tp_vertex_run *run,
                                 tp_grid_vertex *vertex);

struct tp_water_rings {
    tp_relief (*relief)(const tp_ring_now *rings, uint32_t count, tp_fx x, tp_fx z);
    bool (*at)(const tp_ring *ring, int64_t time, tp_ring_now *now);
    tp_run_relief_of run;
};

struct tp_water_pools {
    tp_relief (*relief)(const tp_pool *pool, tp_fx x, tp_fx z, tp_fx back);
    tp_fx (*highest)(const tp_pool *pool);
    tp_run_relief_of run;
};

struct tp_water_swells {
    void (*init)(tp_sea *sea, const tp_wave *waves, uint32_t count, tp_fx gravity);
    tp_sea_point (*above)(const tp_sea *sea, const tp_turn phases[TP_WAVES], tp_fx x,
                          tp_fx z, tp_fx rest[2]);
    void (*begin)(tp_vertex_frame *frame);
    void (*columns)(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                    uint32_t first, uint32_t end, tp_fx cell);
    void (*row)(const tp_vertex_frame *frame, tp_vertex_row *row, bool sloped);
    /* One axis of a run, from + rest; and a run's slopes. */
    void (*sway)(const tp_vertex_place_of *place, int axis, const int32_t *from,
                 int32_t rest, int32_t *to);
    void (*slope)(const tp_vertex_place_of *place, tp_grid_vertex *to);
    /* Of a lattice over the picture. */
    tp_sea_point (*point)(const tp_level *level, const tp_surface *surface,
                          const tp_fx place[2], tp_fx step[2][2]);
    bool few;                   /* a world has room for those of its scene alone */
};

struct tp_water_sharp {         /* swells with sharpened crests; needs swells */
    void (*run)(const tp_vertex_place_of *place, tp_vertex_run *run,
                tp_grid_vertex *vertex);
};

struct tp_water_ocean {
    tp_fx (*reach)(const tp_ocean *ocean);
    tp_fx (*height)(const tp_ocean *ocean);
    tp_sea_point (*above)(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx rest[2]);
    tp_ocean_point (*smooth)(const tp_ocean *ocean, const tp_turn phases[TP_WAVES],
                             tp_fx x0, tp_fx z0);
    tp_floor_at (*floor)(const tp_ocean *ocean, tp_fx x, tp_fx z);
    void (*carve)(tp_grid *grid, tp_arena *arena);
    void (*row)(tp_grid *grid, uint32_t j, tp_grid_span needed);
    tp_view_corner (*corner)(const tp_grid *grid, uint32_t i, uint32_t j);
};
#endif
