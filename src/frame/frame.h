/* SPDX-License-Identifier: MIT */
/* The inside of a frame: everything that drawing a tile reads. */
#ifndef TP_FRAME_INSIDE_H
#define TP_FRAME_INSIDE_H
#include "geom/grid.h"
#include "raster/raster.h"
#include "scene/drawn.h"
#include "shade/shade.h"
#include "tidepool/frame.h"

#define TP_STAGES 20

/* What a kind of sample goes through, ended by NULL. */
typedef struct {
    tp_stage stage[TP_STAGES];
} tp_plan;

/* Tables of the sky and the camera that only some scenes have, or NULL. */
typedef struct {
    tp_dome  *dome;
    tp_cube  *cube;
    uint32_t *recip;            /* TP_RECIP + 2 */
    uint8_t  *tone;             /* 256 */
} tp_frame_sky;

/* A corner of the boat, projected; u = TP_GRID_CUT: must be clipped. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
} tp_boat_vertex;

/* A corner of the land, projected; u as of the water's. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
    int16_t  n[3];              /* normal, of any length */
    int16_t  deep;              /* no wave uncovers it */
} tp_land_vertex;

/* Rows of pixels, both included. */
typedef struct {
    int32_t y0, y1;
} tp_land_band;

#define TP_BALL_ROUND 10                        /* meridians */
#define TP_BALL_RINGS 5                         /* parallels */
#define TP_BALL (TP_BALL_ROUND * TP_BALL_RINGS + 2)

/* A point of the unit sphere, Q1.14. */
typedef struct {
    int16_t x, y, z;
} tp_ball_point;

#define TP_MATERIALS (TP_MARK_LAND - TP_MARK_SOLID)     /* more share the last mark */

struct tp_frame {
    const tp_scene  *scene;
    tp_assets        assets;
    tp_frame_config  config;    /* tile sizes filled in */
    uint32_t         across, down;      /* tiles */
    tp_frame_stats   stats;
    tp_frame_ram     ram;

    tp_lens          lens;
    const tp_world  *world;
    tp_drawn         drawn;
    tp_surface       surface;
    tp_grid          grid;
    tp_grid_view     grid_view;
    bool             cull_water;        /* the eye is above every crest */

    bool             boat_seen;
    tp_lens          boat_lens;         /* the same view in the mesh's frame */
    tp_boat_vertex  *boat_vertex;
    tp_grid_box      boat_box;          /* pixels */
    tp_solid        *solid;
    uint8_t         *gloss;

    tp_land_vertex  *land_vertex;       /* rows x cols of the grid */
    tp_land_band    *land_band;         /* of each row of cells */

    tp_ball_point    ball[TP_BALL];     /* of a sphere, once */
    tp_grid_box     *drop_box;          /* of each drop in the air, then the sphere */
    uint32_t         drop_capacity, drops_seen;
    tp_ring_now     *ring;              /* as they lie at the drawn moment */
    uint32_t         ring_capacity;
    uint8_t          drop_gloss[TP_GLOSS];

    tp_frame_sky     heaven;
    int32_t          fresnel, model;    /* that tables were made for */
    tp_shade         shade;
    tp_plan          sky, water, solids, land, drops;
};

/* water.c */
void tp_frame_place_water(tp_frame *frame);
void tp_frame_draw_water(const tp_frame *frame, tp_samples *tile);

/* boat.c */
void tp_frame_place_boat(tp_frame *frame);
void tp_frame_draw_boat(const tp_frame *frame, tp_samples *tile);

/* land.c: of scenes with a sea floor */
void tp_frame_place_land(tp_frame *frame);
void tp_frame_draw_land(const tp_frame *frame, tp_samples *tile);

/* drops.c */
void tp_frame_make_ball(tp_frame *frame);
void tp_frame_place_drops(tp_frame *frame);
void tp_frame_draw_drops(const tp_frame *frame, tp_samples *tile);

/* plan.c: the stages that the scene needs, and their numbers. */
void tp_frame_plan(tp_frame *frame);
void tp_frame_plan_materials(tp_frame *frame);
void tp_frame_make_gloss(tp_frame *frame);              /* frame.c */
void tp_plan_add(tp_plan *plan, tp_stage stage);

/* plan_sky.c: sky, what water mirrors of it, air, exposure. */
tp_frame_sky tp_frame_carve_sky(tp_arena *arena, const tp_scene *scene,
                                const tp_assets *assets);
void tp_frame_init_sky(tp_frame *frame);
void tp_frame_plan_sky(tp_frame *frame);
void tp_frame_add_sky(const tp_frame *frame, tp_plan *plan);
bool tp_frame_mirrors_apart(const tp_frame *frame);
void tp_frame_add_reflection(const tp_frame *frame, tp_plan *plan);
void tp_frame_add_fresnel(const tp_frame *frame, tp_plan *plan);
void tp_frame_add_air(const tp_frame *frame, tp_plan *plan);
void tp_frame_add_exposure(const tp_frame *frame, tp_plan *plan);
#endif
