/* SPDX-License-Identifier: MIT */
/* Declarations shared by the files of the benchmark.  A figure is the time of one renderer
 * for one case. */
#ifndef TP_TOOLS_BENCH_BENCH_H
#define TP_TOOLS_BENCH_BENCH_H
#include "app/files/picture.h"
#include "bench_scene.h"
#include "frame/tools.h"

enum { BENCH_ROUNDS = 3, BENCH_BY = 32 };

typedef struct bench_peer bench_peer;   /* another renderer */

typedef struct {
    uint32_t   width, height, points;
    bench_work work;
    tp_rungs   rungs;                   /* rungs; AUTO: the plan's */
    const bench_peer *peer;             /* other renderer; NULL: this engine */
    char       by[BENCH_BY];            /* "rows quick", "llvmpipe" */
    uint32_t   us[BENCH_ROUNDS];        /* median of each round, us; 0: failed */
    uint32_t   water;                   /* pixels of water; not counted for a peer, which
                                         * gets the count of the case's first figure */
    double     decibels;                /* PSNR against the case's first; < 0: none */
} bench_figure;

/* Figures of one case (size, points, work) are contiguous; the first is this engine's. */
typedef struct {
    bench_figure *of;
    size_t        count, room;
    uint32_t      frames;               /* frames per round */
    uint32_t     *kept;                 /* pixels 0x00RRGGBB of the case's first figure */
} bench_list;

bool bench_same_case(const bench_figure *a, const bench_figure *b);
bool bench_add(bench_list *list, const bench_figure *figure);   /* false: no memory */

/* -- bench_draw.c: frames of this engine --------------------------------------------- */

/* Measures the times of one round.  Round 0 also counts pixels of water and sets
 * `decibels`, or, if `first`, keeps the picture.  With a folder, round 0 writes the picture
 * there as a PNG.  Returns an exit code. */
int bench_draw(bench_list *list, bench_scene *s, bench_figure *f, int round, bool first,
               const char *folder);

/* Returns the PSNR, dB, of pixels of the figure's size against the kept pixels. */
double bench_decibels(const bench_list *list, const bench_figure *f,
                      const uint32_t *pixels);

/* -- bench_peers.c: other renderers, in the project's folder ------------------------- */

#define BENCH_FOLDER "build/bench"      /* folder of pictures */

int  bench_peers_build(void);
bool bench_peers_add(bench_list *list, bench_figure figure);    /* false: no memory */
void bench_peer_run(const bench_list *list, bench_figure *f, int round);

#endif
