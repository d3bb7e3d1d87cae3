/* SPDX-License-Identifier: MIT */
/* Random numbers of the kinds that tests of the drawing need; measure.h has the seed. */
#ifndef TP_TESTS_CHANCE_H
#define TP_TESTS_CHANCE_H
#include "measure.h"
#include "tidepool/world.h"

static inline double chance_double(uint64_t *state, double low, double high)
{
    return low + (high - low) * (double)(random_next(state) >> 11) / 9007199254740992.0;
}

/* Both ends included. */
static inline int32_t chance_int(uint64_t *state, int32_t low, int32_t high)
{
    const uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)((random_next(state) >> 32) * count >> 32));
}

static inline tp_fx chance_fx(uint64_t *state, double low, double high)
{
    return (tp_fx)lround(chance_double(state, low, high) * 65536);
}

/* Evenly in the logarithm. */
static inline tp_fx chance_scale(uint64_t *state, double low, double high)
{
    return (tp_fx)lround(low * pow(high / low, chance_double(state, 0, 1)) * 65536);
}

/* A wave from anywhere in the table's ranges. */
static inline tp_wave chance_wave(uint64_t *state)
{
    return (tp_wave){
        .amplitude = chance_scale(state, 0.001, 16),
        .length = chance_scale(state, 0.25, 2000),
        .steepness = chance_fx(state, 0, 1),
        .heading = chance_fx(state, -32400, 32400),
        .phase = chance_fx(state, -32400, 32400),
        .speed = chance_fx(state, 0, 8),
    };
}

/* Any bits, near numbers, and what lies at the ends of 32 bits and near them. */
static inline int32_t chance_word(uint64_t *state)
{
    const int32_t near = (int32_t)(random_next(state) >> (33 + random_below(state, 31)));

    switch (random_below(state, 6)) {
    case 0:  return INT32_MAX - near;
    case 1:  return INT32_MIN + near;
    case 2:  return random_below(state, 2) ? INT32_MAX : INT32_MIN;
    case 3:  return (int32_t)(uint32_t)random_next(state);
    default: return random_number(state);
    }
}

/* Input of any bits, a third of it 0. */
static inline tp_input chance_input(uint64_t *state)
{
    tp_input in;
    int32_t *const word = (int32_t *)(void *)&in;

    for (size_t i = 0; i < sizeof in / sizeof *word; i++)
        word[i] = random_below(state, 3) ? chance_word(state) : 0;
    return in;
}
#endif
