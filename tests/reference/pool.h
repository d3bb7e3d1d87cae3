/* SPDX-License-Identifier: MIT */
/* The pool's automaton as the models print it, cell by cell in 64 bits, with a full copy of
 * the old heights: [C8]-[C11] and [C17]. Reads nothing but the walls from the pool. */
#ifndef TP_TESTS_REFERENCE_POOL_H
#define TP_TESTS_REFERENCE_POOL_H
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "pool/pool.h"

enum { REF_POOL = 64 * 64 };        /* most cells */

typedef struct {
    int32_t cols, rows, full, courant_sq_q10, m;
    bool    tiled, sponge;
    int32_t gear;
    bool    at_rest;
    bool    wall[REF_POOL];
    int32_t own[REF_POOL];          /* damping of each cell in a sponge layer */
    int64_t h[REF_POOL], v[REF_POOL];
    int64_t right[REF_POOL], down[REF_POOL];    /* fluxes [C17] */
} ref_pool;

/* Index of the neighbour at (x, y); -1: none. */
static inline int32_t ref_beside(const ref_pool *p, int32_t x, int32_t y)
{
    if (p->tiled) {
        x = (x + p->cols) % p->cols;
        y = (y + p->rows) % p->rows;
    }
    if (x < 0 || y < 0 || x >= p->cols || y >= p->rows || p->wall[y * p->cols + x])
        return -1;
    return y * p->cols + x;
}

static inline void ref_pool_read(ref_pool *p, const tp_pool *pool)
{
    p->cols = (int32_t)pool->cols;
    p->rows = (int32_t)pool->rows;
    p->full = pool->cells == TP_CELLS_8 ? 127 : pool->cells == TP_CELLS_16 ? 32767
                                                                          : (1 << 30) - 1;
    p->courant_sq_q10 = (int32_t)pool->courant_sq_q10;
    p->m = (int32_t)pool->damping;
    p->sponge = pool->edges == TP_EDGES_SPONGE;
    p->tiled = pool->edges == TP_EDGES_TILE;
    p->gear = (int32_t)pool->gear;
    p->at_rest = pool->at_rest;
    for (int32_t i = 0; i < p->cols * p->rows; i++) {
        const uint32_t x = (uint32_t)(i % p->cols), y = (uint32_t)(i / p->cols);
        p->wall[i] = tp_pool_is_wall_or_outside(pool, x, y);
        p->own[i] = p->m;
        p->h[i] = tp_pool_height_lsb(pool, x, y);
        p->v[i] = tp_pool_velocity(pool, x, y);
        p->right[i] = p->down[i] = 0;
    }
}

static inline int64_t ref_force(const ref_pool *p, const int64_t *h, int32_t i)
{
    static const int32_t way[4][2] = { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
    int64_t f = 0;

    for (int n = 0; n < 4; n++) {
        const int32_t j = ref_beside(p, i % p->cols + way[n][0], i / p->cols + way[n][1]);
        f += j >= 0 ? h[j] - h[i] : 0;
    }
    return f;
}

/* Quotient rounded to nearest, halves away from 0. */
static inline int64_t ref_nearest(int64_t n, int64_t d)
{
    return n < 0 ? -((-n + d / 2) / d) : (n + d / 2) / d;
}

static inline int64_t ref_clamp(int64_t x, int64_t low, int64_t high)
{
    return x < low ? low : x > high ? high : x;
}

static inline void ref_peel(ref_pool *p)
{
    p->at_rest = true;
    for (int32_t i = 0; i < p->cols * p->rows; i++) {
        p->h[i] -= (p->h[i] > 0) - (p->h[i] < 0);
        p->at_rest &= p->h[i] == 0;
    }
}

static inline void ref_gears(ref_pool *p)
{
    static int64_t old[REF_POOL];
    const int64_t whole = (int64_t)2048 << p->m;
    const bool a = p->gear > 0;
    int64_t carry = 0;
    bool moved = false;

    memcpy(old, p->h, sizeof old);
    for (int32_t i = 0; i < p->cols * p->rows; i++) {
        const int32_t m = a ? p->own[i] : p->m;
        const int64_t v = p->v[i], f = p->wall[i] ? 0 : ref_force(p, old, i);
        /* in a sponge layer a spring of (delta / 2)^2 beside r^2 F: 2048 (delta / 2)^2 /
         * 2 */
        const int64_t pull = a && p->sponge && m < p->m && m <= 4
                           ? old[i] * (256 >> 2 * m) : 0;
        const int64_t x = (((int64_t)2 << m) - 1)
                          * (2048 * v + p->courant_sq_q10 * f - pull)
                          * ((int64_t)1 << (p->m - m));
        int64_t s = x / whole;
        if (a && (v != 0 || f != 0 || pull != 0)) {
            s = ref_nearest(x + carry, whole);
            carry += x - s * whole;
        }
        int64_t speed = ref_clamp(s - v, -p->full - old[i], p->full - old[i]);
        speed = ref_clamp(speed, -p->full, p->full);
        p->v[i] = speed;
        p->h[i] += speed;
        moved |= speed != 0;
    }
    if (a)
        p->gear--;
    else if (!moved)
        ref_peel(p);
}

/* Flux tz(tz(q + tz(fall a)) d) with the bound of flux.c; C division truncates towards
 * 0. */
static inline int64_t ref_flux(const ref_pool *p, int64_t q, int32_t i, int32_t j)
{
    const int64_t one = (int64_t)1 << p->own[i], from = p->h[i], to = p->h[j];
    const int64_t most = ref_clamp(p->full + from, 0, p->full - to) / 4;
    const int64_t least = ref_clamp(p->full + to, 0, p->full - from) / 4;

    q += (from - to) * p->courant_sq_q10 / 1024;
    return ref_clamp(q * (one - 1) / one, -least, most);
}

static inline void ref_fluxes(ref_pool *p)
{
    const int32_t count = p->cols * p->rows;

    for (int32_t i = 0; i < count; i++) {
        const int32_t right = ref_beside(p, i % p->cols + 1, i / p->cols);
        const int32_t down = ref_beside(p, i % p->cols, i / p->cols + 1);
        p->right[i] = p->wall[i] || right < 0 ? 0 : ref_flux(p, p->right[i], i, right);
        p->down[i] = p->wall[i] || down < 0 ? 0 : ref_flux(p, p->down[i], i, down);
    }
    for (int32_t i = 0; i < count; i++) {
        const int32_t right = ref_beside(p, i % p->cols + 1, i / p->cols);
        const int32_t down = ref_beside(p, i % p->cols, i / p->cols + 1);
        p->h[i] -= p->right[i] + p->down[i];
        if (right >= 0)
            p->h[right] += p->right[i];
        if (down >= 0)
            p->h[down] += p->down[i];
    }
}
#endif
