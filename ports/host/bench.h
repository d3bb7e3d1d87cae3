/* SPDX-License-Identifier: MIT */
/* What the benchmark's files share: a figure is one renderer's time for one case. */
#ifndef HOST_BENCH_H
#define HOST_BENCH_H
#include "bench_scene.h"
#include "picture.h"
#include "scene/plan.h"

enum { BENCH_ROUNDS = 3, BENCH_BY = 32 };

typedef struct bench_peer bench_peer;   /* another renderer */

typedef struct {
    uint32_t   width, height, points;
    bench_work work;
    tp_rungs   rungs;                   /* AUTO: the plan's */
    const bench_peer *peer;             /* NULL: this engine */
    char       by[BENCH_BY];            /* "rows quick", "llvmpipe" */
    uint32_t   us[BENCH_ROUNDS];        /* median of each round; 0: it failed */
    uint32_t   water;                   /* pixels; of a peer those of the case's first */
    double     decibels;                /* PSNR against the case's first; < 0: none */
} bench_figure;

/* Figures of one case (size, points, work) stand together; the first is ours. */
typedef struct {
    bench_figure *of;
    size_t        count, room;
    uint32_t      frames;               /* of each round */
    uint32_t     *kept;                 /* 0x00RRGGBB of the case's first */
} bench_list;

bool bench_same_case(const bench_figure *a, const bench_figure *b);
bool bench_add(bench_list *list, const bench_figure *figure);   /* false: no memory */

/* -- bench_draw.c: frames of this engine ------------------------------------------- */

/* Times a round.  In round 0 it also counts water and sets `decibels`, or keeps the
 * picture if `first`; `folder`, if not NULL, gets it as a PNG.  An exit code. */
int bench_draw(bench_list *list, bench_scene *s, bench_figure *f, int round, bool first,
               const char *folder);

/* Pixels of the figure's size against the kept ones. */
double bench_decibels(const bench_list *list, const bench_figure *f,
                      const uint32_t *pixels);

/* -- bench_peers.c: other renderers, from the project's folder ---------------------- */

#define BENCH_FOLDER "build/bench"      /* of pictures */

int  bench_peers_build(void);
bool bench_peers_add(bench_list *list, bench_figure figure);    /* false: no memory */
void bench_peer_run(const bench_list *list, bench_figure *f, int round);

/* -- bench_print.c ------------------------------------------------------------------ */

void bench_print(const bench_list *list, bool csv);
#endif
