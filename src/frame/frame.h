/* SPDX-License-Identifier: MIT */
/* The inside of a frame: everything that drawing a tile reads. */
#ifndef TP_FRAME_INSIDE_H
#define TP_FRAME_INSIDE_H
#include "geom/grid.h"
#include "raster/raster.h"
#include "shade/shade.h"
#include "tidepool/frame.h"

#define TP_STAGES 10

/* What a kind of sample goes through, ended by NULL. */
typedef struct {
    tp_stage stage[TP_STAGES];
} tp_plan;

/* A corner of the boat, projected; u = TP_GRID_CUT: must be clipped. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
} tp_boat_vertex;

#define TP_MATERIALS (256 - TP_MARK_SOLID)      /* more share the last mark */

struct tp_frame {
    const tp_scene  *scene;
    tp_assets        assets;
    tp_frame_config  config;    /* tile sizes filled in */
    uint32_t         across, down;      /* tiles */
    tp_frame_stats   stats;
    tp_frame_ram     ram;

    tp_lens          lens;
    tp_sea           sea;
    tp_turn          phases[TP_WAVES];
    tp_grid          grid;
    tp_grid_view     grid_view;
    bool             cull_water;        /* the eye is above every crest */

    bool             boat_seen;
    tp_lens          boat_lens;         /* the same view in the mesh's frame */
    tp_boat_vertex  *boat_vertex;
    tp_grid_box      boat_box;          /* pixels */
    tp_solid        *solid;
    uint8_t         *gloss;

    tp_shade         shade;
    tp_plan          sky, water, solids;
};

/* water.c */
void tp_frame_place_water(tp_frame *frame);
void tp_frame_draw_water(const tp_frame *frame, tp_samples *tile);

/* boat.c */
void tp_frame_place_boat(tp_frame *frame, const tp_world *world);
void tp_frame_draw_boat(const tp_frame *frame, tp_samples *tile);

/* plan.c: the stages that the scene needs, and their numbers. */
void tp_frame_plan(tp_frame *frame, const tp_world *world);
void tp_frame_plan_materials(tp_frame *frame);
#endif
