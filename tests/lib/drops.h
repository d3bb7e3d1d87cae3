/* SPDX-License-Identifier: MIT */
/* Drops for tests: a usual drop, a drop from the whole ranges of the parameter table, and a
 * drop released above a point. */
#ifndef TP_TESTS_LIB_DROPS_H
#define TP_TESTS_LIB_DROPS_H
#include "features/drops/drops.h"
#include "tests/lib/random.h"

static const tp_scene_drops usual = {
    .count = 64, .rings = 64, .y = TP_FX(3), .radius = TP_FX(0.06),
    .density = TP_FX(1000), .drag = TP_FX(0.47), .bounce = TP_FX(0.65), .impacts = 6,
    .interval = TP_FX_ONE, .efficiency = TP_FX(0.2),
    .ring_speed = TP_FX(1.2), .ring_decay = TP_FX(2),
    .ring_spread = TP_FX_ONE, .ring_rise_time = TP_FX(0.1),
};

static inline tp_scene_drops any_config(uint64_t *chance)
{
    tp_scene_drops c = usual;
    c.radius = chance_scale(chance, 0.002, 1);
    c.density = chance_scale(chance, 100, 10000);
    c.drag = chance_int(chance, 0, 3) ? chance_fx(chance, 0, 2) : 0;
    c.bounce = chance_fx(chance, 0.5, 0.8);
    c.impacts = chance_int(chance, 5, 7);
    c.efficiency = chance_fx(chance, 0, 1);
    c.y = chance_fx(chance, 0, 100);
    return c;
}

static inline tp_drop drop_at(const tp_scene_drops *c, double y)
{
    const tp_fx high = (tp_fx)lround(y * 65536);
    return (tp_drop){ .place.y = high, .last.y = high, .high_q32 = (int64_t)high * 65536,
                      .radius = c->radius, .level = TP_DROP_NEW };
}
#endif
