/* SPDX-License-Identifier: MIT */
/* Shared by the counted models; see models.c. */
#ifndef TP_TESTS_BUDGETS_MODELS_H
#define TP_TESTS_BUDGETS_MODELS_H
#include "pool/pool.h"
#include "tidepool/tidepool.h"
#include "waves/deep_water.h"

/* A model: its preparation, its counted function, and its number of units. A row of zeros
 * ends a list. */
typedef struct {
    const char *name, *unit;        /* no blanks */
    const char *each;               /* owner of the bytes: "a wave" */
    void      (*prepare)(int kind);
    void      (*run)(void);
    int         kind;
    uint32_t    units;
} model_row;

extern const model_row model_seas[], model_oceans[], model_pools[], model_drops[],
                       model_grids[];

/* State of the row at work; `prepare` may change count, and sets bytes. */
typedef struct {
    uint32_t count, bytes;
    tp_deep_water   deep;
    tp_turn  phases[TP_WAVES];
    union { uint64_t aligned; uint8_t byte[1 << 20]; } block;
} model_place;
extern model_place model;

void model_expect(bool holds, const char *otherwise);

/* Sets three crossing waves with a sum of steepness in 16.16, at a tick. */
void model_sea(tp_fx steepness, int32_t power);
extern const tp_wave model_waves[3];

/* Makes a moving pool of this row's kind in the block. */
tp_pool *model_pool(int kind);
#define MODEL_POOL(cells, side, with) ((cells) + 4 * ((side) == 128) + 8 * (with))
enum { OPEN, MASK, SPONGE, TILED, SETTLE, FED };

/* Counted function; the compiler may not inline it. */
#define COUNTED(name) static __attribute__((noinline)) void counted_##name(void)

/* Makes the compiler treat the value as used. */
#define KEEP(value) __asm__ volatile("" :: "r"(&(value)) : "memory")

/* The i-th of places within +-`half` metres, spread evenly in no order. */
static inline tp_fx model_spread(uint32_t i, uint32_t step, tp_fx half)
{
    return (tp_fx)((int64_t)(int32_t)(i * step) * half >> 31);
}

#define PLACE_X(i, half) model_spread((i), 2654435769u, (half))
#define PLACE_Z(i, half) model_spread((i), 1640531527u, (half))
#endif
