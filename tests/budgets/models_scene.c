/* SPDX-License-Identifier: MIT */
/* Models of moving parts of a scene: drops, boats, the world's tick; and the water's mesh;
 * see models.c. */
#include "features/drops/drops.h"
#include "view/grid.h"
#include "features/boat/boat.h"
#include "tests/budgets/models.h"

/* -- drops --------------------------------------------------------------------------- */

enum { FALL, LIFE };

static const tp_scene_drops drops = {
    .count = 8,
    .rings = 8,
    .y = TP_FX(3),
    .radius = TP_FX(0.05),
    .density = 1000 * TP_FX_ONE,
    .drag = TP_FX(0.47),
    .bounce = TP_FX(0.7),
    .impacts = 6,
    .efficiency = TP_FX(0.2),
    .ring_speed = TP_FX(1.2),
    .ring_decay = TP_FX(2),
    .ring_spread = TP_FX(0.5),
    .ring_rise_time = TP_FX(0.1),
};
static tp_drop drop;

static void prepare_drop(int kind)
{
    const tp_fx high = kind == FALL ? TP_FX(300) : TP_FX(3);

    drop = (tp_drop){ .place = { 0, high, 0 }, .last = { 0, high, 0 },
                      .high_q32 = (int64_t)high * 65536, .radius = drops.radius,
                      .level = TP_DROP_NEW };
    model.bytes = sizeof drop;
}

COUNTED(fall)
{
    tp_impact impact;

    for (uint32_t i = 0; i < model.count; i++)
        model_expect(!tp_drop_step(&drop, &drops, TP_FX(9.81), 0, i + 1, &impact),
                     "an impact");
}

/* Life of a drop, from release to end. */
COUNTED(life)
{
    tp_impact impact;
    uint32_t  ticks = 0;

    while (drop.radius > 0 && ticks < 1000) {
        tp_drop_step(&drop, &drops, TP_FX(9.81), 0, ++ticks, &impact);
        KEEP(impact);
    }
    model_expect(drop.radius == 0, "a drop that stays");
    model.count = ticks;
}

/* -- a world ------------------------------------------------------------------------- */

enum { KINEMATIC, SMOOTH, DYNAMIC, WAKE, PLAIN };

static tp_scene scene;
static tp_world *const world = (tp_world *)(void *)&model.block;
static const tp_input no_input;

/* The boat's functions are called directly, so the scene needs no mesh name. */
static void prepare_world(int kind)
{
    tp_scene_level(&scene);
    for (int i = 0; i < 3; i++) {
        scene.wave[i] = model_waves[i];
        scene.wave[i].steepness = TP_FX(0.23);
    }
    scene.boat.length = TP_FX(15);
    scene.boat.beam = TP_FX(4);
    scene.boat.speed = TP_FX(2);
    scene.boat.mode = kind == DYNAMIC ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
    scene.boat.smooth = kind == SMOOTH ? TP_FX(0.5) : 0;
    scene.boat.draft = TP_FX(0.8);
    scene.boat.drag = TP_FX(0.5);
    scene.boat.wake = TP_FX_ONE;
    scene.pool.cols = kind == WAKE ? 64 : 0;
    scene.pool.rows = 64;
    scene.pool.cell = TP_FX(0.5);
    model_expect(tp_world_bytes(&tp_program_all, &scene, NULL) <= sizeof model.block,
                 "too large a world");
    model_expect(
        !tp_world_init(&tp_program_all, world, sizeof model.block, &scene, NULL, NULL),
        "no world");
    tp_boat_place_on_water(&tp_program_all, world, &scene);
    model.bytes = kind == PLAIN ? sizeof(tp_world)
                                : (uint32_t)(sizeof(tp_boat_state) + 2 * sizeof(tp_pose));
}

COUNTED(world)
{
    for (uint32_t i = 0; i < model.count; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
}

COUNTED(boat)
{
    for (uint32_t i = 0; i < model.count; i++)
        tp_boat_step(&tp_program_all, world, &scene, &no_input);
}

/* The boat has moved by a tick's distance before each call. */
COUNTED(wake)
{
    tp_boat_stir_pool(world, &scene);
}

static void prepare_wake(int kind)
{
    prepare_world(kind);
    for (int i = 0; i < 4; i++) {
        tp_boat_stir_pool(world, &scene);
        tp_world_step(&tp_program_all, world, &scene, NULL);
        tp_boat_step(&tp_program_all, world, &scene, &no_input);
    }
    model_expect(world->boat_state.wake_ticks > 0, "a boat that stirs nothing");
}

const model_row model_drops[] = {
    { "drop-falling", "tick", "a drop", prepare_drop, counted_fall, FALL, 128 },
    { "drop-life", "tick", "a drop", prepare_drop, counted_life, LIFE, 0 },
    { "boat-kinematic", "tick", "a boat", prepare_world, counted_boat, KINEMATIC, 64 },
    { "boat-smooth", "tick", "a boat", prepare_world, counted_boat, SMOOTH, 64 },
    { "boat-dynamic", "tick", "a boat", prepare_world, counted_boat, DYNAMIC, 64 },
    { "boat-wake", "tick", "a boat", prepare_wake, counted_wake, WAKE, 1 },
    { "world-tick", "tick", "the head", prepare_world, counted_world, PLAIN, 64 },
    { 0 },
};

/* -- the mesh ------------------------------------------------------------------------ */

enum { CHEAP, EXACT, SHARP, RINGS, POOL, SIDE = 100, WIDTH = 320, HEIGHT = 240 };

static tp_grid     grid;
static tp_projection     projection;
static tp_surface  surface;
static tp_ring_now ring[4];

static const tp_grid_view view = {
    .projection = &projection, .surface = &surface, .width = WIDTH, .height = HEIGHT,
    .vertices = SIDE * SIDE,
};

static void set_rings(void)
{
    for (int i = 0; i < 4; i++) {
        const tp_ring raised = {
            .x = (7 * i - 10) * TP_FX_ONE, .z = (9 - 5 * i) * TP_FX_ONE,
            .amplitude = TP_FX(0.1), .length = TP_FX(1), .speed = TP_FX(2),
            .decay = TP_FX(4), .spread = TP_FX(1),
        };
        model_expect(tp_ring_evaluate(&raised, 120 * TP_FX_ONE, &ring[i]), "no ring");
    }
    surface.ring = ring;
    surface.rings = 4;
}

/* The camera is 30 m up and looks down.  A pool lies in the block below the grid. */
static void prepare_grid(int kind)
{
    size_t below = 0;

    model_sea(kind == CHEAP ? TP_FX(0.05) : TP_FX(0.7), kind == SHARP ? 2 : 1);
    surface = (tp_surface){ .by = &tp_program_all.water,
                            .deep = &model.deep,
                            .phases = model.phases };
    if (kind == RINGS)
        set_rings();
    if (kind == POOL) {
        surface.pool = model_pool(MODEL_POOL(TP_CELLS_16, 128, OPEN));
        surface.pool_kind = tp_pool_find_kind(surface.pool);
        below = sizeof model.block / 2;
    }
    tp_arena arena = tp_arena_init(model.block.byte + below, sizeof model.block - below);
    tp_grid_layout(&grid, &arena, SIDE * SIDE, TP_WAVES, false);
    grid.exact_waves = &tp_draw_exact_waves;
    grid.exact_corners = &tp_draw_exact_corners;
    model_expect(!arena.failed, "no memory for the grid");
    tp_projection_init(&projection, (tp_vec3){ 0, TP_FX(30), TP_FX(40) }, 0,
                 tp_turn_of_degrees(TP_FX(-40)), TP_FX(90), TP_FX(0.5), WIDTH, HEIGHT);
    tp_grid_evaluate_vertices(&grid, &view);
    model.count = grid.vertices;
    model.bytes = (uint32_t)((arena.used + model.count / 2) / model.count);
}

COUNTED(grid)
{
    tp_grid_evaluate_vertices(&grid, &view);
    model_expect(grid.vertices == model.count, "another number of vertices");
}

const model_row model_grids[] = {
    { "vertex-cheap", "vertex", "a vertex", prepare_grid, counted_grid, CHEAP, 0 },
    { "vertex-exact", "vertex", "a vertex", prepare_grid, counted_grid, EXACT, 0 },
    { "vertex-sharp", "vertex", "a vertex", prepare_grid, counted_grid, SHARP, 0 },
    { "vertex-rings", "vertex", "a vertex", prepare_grid, counted_grid, RINGS, 0 },
    { "vertex-pool", "vertex", "a vertex", prepare_grid, counted_grid, POOL, 0 },
    { 0 },
};
