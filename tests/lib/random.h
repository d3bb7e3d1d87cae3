/* SPDX-License-Identifier: MIT */
/* Random inputs of tests, and their seed: TP_SEED=n repeats the inputs of a run. */
#ifndef TP_TESTS_LIB_RANDOM_H
#define TP_TESTS_LIB_RANDOM_H
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tidepool/world.h"

static inline uint64_t random_seed(void)
{
    const char *const given = getenv("TP_SEED");
    const uint64_t seed = given != NULL ? strtoull(given, NULL, 0) : (uint64_t)time(NULL);
    printf("TP_SEED=%" PRIu64 "\n", seed);
    return seed;
}

/* Number of rounds: `all` without sanitizers and in the soak. Under the sanitizers, where a
 * round takes several times as long and faults are found rather than results, `some`. */
static inline int random_rounds(int all, int some)
{
#ifdef __SANITIZE_ADDRESS__
    return getenv("TP_SOAK") ? all : some;
#else
    (void)some;
    return all;
#endif
}

/* splitmix64 */
static inline uint64_t random_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* xorshift32, Marsaglia 2003; the state is not 0. */
static inline uint32_t random_xorshift(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

static inline uint32_t random_below(uint64_t *state, uint32_t end)
{
    return (uint32_t)((random_next(state) >> 32) * end >> 32);
}

/* A signed number of random bit length, 0 to 31, so that small numbers are frequent. */
static inline int32_t random_number(uint64_t *state)
{
    const uint64_t word = random_next(state);
    return (int32_t)(uint32_t)word >> (word >> 59);
}

static inline double chance_double(uint64_t *state, double low, double high)
{
    return low + (high - low) * (double)(random_next(state) >> 11) / 9007199254740992.0;
}

/* Returns an integer in [low, high], both ends included. */
static inline int32_t chance_int(uint64_t *state, int32_t low, int32_t high)
{
    const uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)((random_next(state) >> 32) * count >> 32));
}

static inline tp_fx chance_fx(uint64_t *state, double low, double high)
{
    return (tp_fx)lround(chance_double(state, low, high) * 65536);
}

/* Returns a number in [low, high], uniform in its logarithm. */
static inline tp_fx chance_scale(uint64_t *state, double low, double high)
{
    return (tp_fx)lround(low * pow(high / low, chance_double(state, 0, 1)) * 65536);
}

/* A random wave from the whole ranges of the parameter table. */
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

/* Returns a word: any bits, a number near 0, an end of the 32-bit range, or a number near
 * an end. */
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

/* Input with arbitrary bits in each field; a third of the fields are 0. */
static inline tp_input chance_input(uint64_t *state)
{
    tp_input in;
    int32_t *const word = (int32_t *)(void *)&in;

    for (size_t i = 0; i < sizeof in / sizeof *word; i++)
        word[i] = random_below(state, 3) ? chance_word(state) : 0;
    return in;
}
#endif
