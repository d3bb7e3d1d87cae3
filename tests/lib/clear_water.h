/* SPDX-License-Identifier: MIT */
/* Scenes of clear water: tanks, and open water over floors of every kind. */
#ifndef TP_TESTS_LIB_CLEAR_WATER_H
#define TP_TESTS_LIB_CLEAR_WATER_H
#include <math.h>
#include "tests/lib/scenes.h"

enum { GLASS, STONE, BEACH, MAP, LEVEL, KINDS };

static uint16_t heights[16 * 16];
static const tp_grey hills = { .cols = 16, .rows = 16, .sample = heights };

static inline void make_hills(void)
{
    for (int i = 0; i < 16 * 16; i++)
        heights[i] = (uint16_t)(32768 + 25000 * sin(i / 40.0));
}

static inline void set_tank(tp_scene *s, int kind, uint64_t *chance)
{
    s->pool.cols = s->pool.rows = 32;
    s->pool.cell = TP_FX(0.1);
    s->grid.vertices = 1089;
    s->tank.sea = 0;
    s->tank.kind = kind == GLASS ? TP_TANK_GLASS : TP_TANK_STONE;
    s->camera.x = chance_fx(chance, 1.8, 3);
    s->camera.z = chance_fx(chance, 1.8, 3);
    s->camera.y = chance_fx(chance, 1.5, 3);
    s->camera.heading = -45 * TP_FX_ONE;
    s->camera.pitch = -35 * TP_FX_ONE;
}

static inline void set_open_water(tp_scene *s, int kind, uint64_t *chance)
{
    s->wave[0] = (tp_wave){ .amplitude = TP_FX(0.1), .length = 9 * TP_FX_ONE,
                            .steepness = TP_FX(0.05), .heading = 60 * TP_FX_ONE,
                            .speed = TP_FX_ONE, .exponent = 1 };
    s->floor.depth = 2 * TP_FX_ONE;
    s->floor.slope = kind == BEACH ? TP_FX(0.1) : 0;
    s->floor.map_size = 60 * TP_FX_ONE;
    s->floor.map_low = -3 * TP_FX_ONE;
    s->floor.map_high = TP_FX_ONE;
    s->camera.y = chance_fx(chance, 1, 4);
    s->camera.heading = chance_fx(chance, 0, 360);
    s->camera.pitch = chance_fx(chance, -40, -15);
}

/* A scene with fast shading and the fast view into the water. */
static inline tp_scene clear_scene(int kind, uint64_t *chance)
{
    tp_scene s;

    tp_scene_level(&s);
    s.water.clarity = 3 * TP_FX_ONE;
    s.water.caustics = kind == STONE || kind == BEACH ? 0 : TP_FX_ONE;
    s.water.caustic_cells = 32;
    s.camera.near = TP_FX(0.05);
    s.quality.shading = TP_SHADING_QUICK;
    s.quality.refraction = TP_RUNG_FAST;
    s.quality.rate = TP_RATE_FULL;
    s.quality.visibility = TP_VISIBILITY_TRIANGLES;
    if (kind == GLASS || kind == STONE)
        set_tank(&s, kind, chance);
    else
        set_open_water(&s, kind, chance);
    return s;
}

static inline tp_assets clear_assets(int kind, test_boat *boat)
{
    return (tp_assets){ .tank_wall = &boat->texture[0], .tank_floor = &boat->texture[1],
                        .floor_texture = &boat->texture[0],
                        .floor = kind == MAP ? &hills : NULL };
}

/* Returns the world after some steps with a splash. */
static inline tp_world *stirred_world(const tp_scene *s, const tp_assets *assets)
{
    tp_world *world = scene_world(s, assets);
    const tp_input poke = { .push[0].height = TP_FX(0.05) };

    assert_non_null(world);
    for (int i = 0; i < 20; i++)
        tp_world_step(&tp_program_all, world, s, i ? NULL : &poke);
    return world;
}

#endif
