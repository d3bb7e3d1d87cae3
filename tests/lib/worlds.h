/* SPDX-License-Identifier: MIT */
/* Scenes with buffers behind the world's head, and their random inputs. */
#ifndef TP_TESTS_LIB_WORLDS_H
#define TP_TESTS_LIB_WORLDS_H
#include "world/module.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"

enum { SAMPLES = 24 };

static uint16_t sample[SAMPLES * SAMPLES];
static const tp_grey grey = { SAMPLES, SAMPLES, sample };

static inline tp_scene_pool some_pool(uint64_t *chance)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = chance_int(chance, 16, 40);
    s.pool.rows = chance_int(chance, 16, 40);
    s.pool.cell_bits = chance_int(chance, 0, 2);
    s.pool.boundary = chance_int(chance, 0, 2);
    s.pool.sponge = 4;
    s.pool.splash_interval = TP_FX(0.2);
    s.pool.paddle = TP_FX(0.1);
    return s.pool;
}

/* A scene with the parts selected by bits 0 to 4: floor, wind, pool, field, drops. */
static inline tp_scene scene_with(uint64_t *chance, uint32_t parts)
{
    tp_scene s = scene_plain();

    s.floor.depth = parts & 1 ? TP_FX(6) : 0;
    s.floor.slope = TP_FX(0.02);
    s.wind.strength = parts & 2 ? TP_FX(0.05) : 0;
    if (parts & 4)
        s.pool = some_pool(chance);
    if (parts & 8)
        s.field = some_pool(chance);
    s.drops.count = parts & 16 ? chance_int(chance, 1, 40) : 0;
    s.drops.rings = chance_int(chance, 0, 40);
    s.drops.target = chance_int(chance, 0, 1);
    s.drops.interval = TP_FX(0.1);
    s.boat.wake = TP_FX(0.5);
    return s;
}

static inline tp_assets assets_with(uint64_t *chance, tp_scene *s, bool map,
                                    bool masks)
{
    for (int i = 0; i < SAMPLES * SAMPLES; i++)
        sample[i] = (uint16_t)chance_int(chance, 20000, 65535);
    if (map)
        strcpy(s->floor.map, "floor.png");
    return (tp_assets){ .floor = map ? &grey : NULL, .pool_mask = masks ? &grey : NULL,
                        .field_mask = masks ? &grey : NULL };
}

static inline tp_input input_any(uint64_t *chance)
{
    return (tp_input){
        .forward = chance_fx(chance, -0.1, 0.1),
        .drops = chance_int(chance, 0, 3),
        .sphere_x = chance_fx(chance, -0.1, 0.1),
        .throttle = chance_fx(chance, 0, 5),
        .push[0].height = chance_int(chance, 0, 9) ? 0 : TP_FX(0.3),
        .slowdown = chance_int(chance, 0, 50) ? 0 : chance_int(chance, -1, 1),
    };
}

static inline void run(uint64_t *chance, tp_world *world, const tp_scene *scene,
                       int ticks)
{
    for (int i = 0; i < ticks; i++) {
        const tp_input in = input_any(chance);
        tp_world_advance_clock(world);
        tp_world_step(&tp_program_all, world, scene, &in);
    }
}
#endif
