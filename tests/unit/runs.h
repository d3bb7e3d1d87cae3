/* SPDX-License-Identifier: MIT */
/* Spans of random samples for the shading stages. */
#ifndef TP_TESTS_RUNS_H
#define TP_TESTS_RUNS_H
#include "chance.h"
#include "shade/depth.h"

typedef struct {
    tp_run   run;
    uint32_t key[TP_RUN], s[TP_RUN], t[TP_RUN], n[TP_RUN];
} test_run;

/* A full span of random colours and samples; slopes within +-`steep`, 4096 is 1. */
static inline void run_any(test_run *r, int32_t steep, uint64_t *state)
{
    memset(r, 0xa5, sizeof *r);
    r->run.x = TP_RUN * chance_int(state, 0, 9);
    r->run.y = chance_int(state, 0, 479);
    r->run.count = TP_RUN;
    r->run.material = 0;
    r->run.key = r->key;
    r->run.s = r->s;
    r->run.t = r->t;
    r->run.ls = r->s;
    r->run.lt = r->t;
    r->run.n = r->n;
    for (int i = 0; i < TP_RUN; i++) {
        const uint32_t sx = (uint32_t)chance_int(state, -steep, steep) & 0xffff;
        r->key[i] = (uint32_t)random_next(state) | 0x100;
        r->s[i] = (uint32_t)random_next(state);
        r->t[i] = (uint32_t)random_next(state);
        r->n[i] = sx << 16 | ((uint32_t)chance_int(state, -steep, steep) & 0xffff);
        r->run.colour[i] = (uint32_t)random_next(state) & 0xffffff;
    }
}

/* The part [from, end) of a span as a span of its own, with the data that stages hand
 * on. */
static inline tp_run run_part(const tp_run *r, int32_t from, int32_t end)
{
    tp_run part = *r;
    const size_t count = (size_t)(end - from);

    part.x = r->x + from;
    part.count = end - from;
    part.key = r->key + from;
    part.s = r->s + from;
    part.t = r->t + from;
    part.ls = part.s;
    part.lt = part.t;
    part.n = r->n + from;
    memmove(part.colour, r->colour + from, count * sizeof *part.colour);
    memmove(part.vx, r->vx + from, count * sizeof *part.vx);
    memmove(part.vy, r->vy + from, count * sizeof *part.vy);
    memmove(part.vz, r->vz + from, count * sizeof *part.vz);
    memmove(part.lv, r->lv + from, count * sizeof *part.lv);
    memmove(part.sx, r->sx + from, count * sizeof *part.sx);
    memmove(part.sz, r->sz + from, count * sizeof *part.sz);
    memmove(part.nv, r->nv + from, count * sizeof *part.nv);
    memmove(part.up, r->up + from, count * sizeof *part.up);
    memmove(part.glint, r->glint + from, count * sizeof *part.glint);
    memmove(part.rx, r->rx + from, count * sizeof *part.rx);
    memmove(part.rz, r->rz + from, count * sizeof *part.rz);
    memmove(part.mirror, r->mirror + from, count * sizeof *part.mirror);
    return part;
}
#endif
