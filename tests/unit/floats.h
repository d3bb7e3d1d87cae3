/* SPDX-License-Identifier: MIT */
/* Floating boats, for tests. */
#ifndef TP_TESTS_FLOATS_H
#define TP_TESTS_FLOATS_H
#include "features/boat/boat.h"
#include "scenes.h"

#define Q40 1099511627776.0
#define LSB (1 / 65536.0)

/* A boat from the whole ranges of the parameter table. */
static inline tp_scene any_boat(uint64_t *chance, tp_boat_mode mode)
{
    tp_scene s;

    tp_scene_level(&s);
    s.boat.mode = (int32_t)mode;
    s.boat.draft = chance_scale(chance, 0.05, 20);
    s.boat.drag = chance_fx(chance, 0.05, 2);
    s.water.gravity = chance_scale(chance, 0.1, 100);
    return s;
}

/* omega dt of [E3] for one tick; omega_step() is omega dt of a substep, at most 1/8. */
static inline double omega_tick(const tp_scene *s)
{
    return sqrt((double)s->water.gravity / s->boat.draft) / TP_TICKS_PER_SECOND;
}

static inline int steps_of(const tp_scene *s)
{
    return (int)fmax(1, ceil(omega_tick(s) * 8));
}

static inline double omega_step(const tp_scene *s)
{
    return omega_tick(s) / steps_of(s);
}

static inline void flat(tp_fx water[4], tp_fx height)
{
    for (int i = 0; i < 4; i++)
        water[i] = height;
}
#endif
