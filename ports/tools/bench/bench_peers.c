/* SPDX-License-Identifier: MIT */
/* Other renderers.  Each is a separate program (tests/bench/peers), built and run from the
 * project's folder: the programs need packages that nothing else in the project needs. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "app/files/log.h"
#include "bench.h"

#define PROGRAMS "build/host/tests/bench/peers"

struct bench_peer {
    const char *name, *program, *setting;
    unsigned    works;              /* set of works, bits 1 << BENCH_... */
    uint32_t    frames;             /* frames per round, 0: as this engine */
};

/* With LP_NUM_THREADS=0 llvmpipe draws in the calling thread. */
static const bench_peer peers[] = {
    { "llvmpipe", "osmesa", "GALLIUM_DRIVER=llvmpipe LP_NUM_THREADS=0",
      1 << BENCH_PLAIN | 1 << BENCH_FULL | 1 << BENCH_SMOOTH, 0 },
    { "softpipe", "osmesa", "GALLIUM_DRIVER=softpipe",
      1 << BENCH_PLAIN | 1 << BENCH_FULL, 2 },
    { "SDL geometry, affine", "sdl", "SDL_VIDEODRIVER=dummy", 1 << BENCH_PLAIN, 0 },
};

#define PEERS (sizeof peers / sizeof *peers)

static bool is_built(const bench_peer *peer)
{
    char path[96];
    snprintf(path, sizeof path, PROGRAMS "/%s", peer->program);
    return access(path, X_OK) == 0;
}

/* Builds the other renderers.  If a package is missing, make prints a message, and the peer
 * is left out. */
int bench_peers_build(void)
{
    if (access("Makefile", R_OK) || access("tests/bench/peers", R_OK))
        return log_fail(EXIT_INPUT, "tidepool bench: --peers builds other renderers: run it"
                    " in the project's folder");
    if (system("mkdir -p " BENCH_FOLDER " && make -s --no-print-directory peers >&2"))
        return log_fail(EXIT_INPUT, "tidepool bench: the other renderers cannot be built");
    return EXIT_DONE;
}

bool bench_peers_add(bench_list *list, bench_figure figure)
{
    for (size_t i = 0; i < PEERS; i++) {
        if (!(peers[i].works >> figure.work & 1) || !is_built(&peers[i]))
            continue;
        figure.peer = &peers[i];
        snprintf(figure.by, sizeof figure.by, "%s", peers[i].name);
        if (!bench_add(list, &figure))
            return false;
    }
    return true;
}

static void compare(const bench_list *list, bench_figure *f, const char *name)
{
    uint32_t w, h;
    uint32_t *pixels = picture_read_png(name, "tidepool bench", &w, &h);
    if (pixels && w == f->width && h == f->height)
        f->decibels = bench_decibels(list, f, pixels);
    free(pixels);
}

/* Runs the program of a peer.  The program writes its picture and prints the median time of
 * its frames, us. */
void bench_peer_run(const bench_list *list, bench_figure *f, int round)
{
    const bench_peer *peer = f->peer;
    const uint32_t frames = peer->frames ? peer->frames : list->frames;
    char name[160], command[480];
    unsigned us = 0;
    snprintf(name, sizeof name, BENCH_FOLDER "/%s-%ux%u-%u-%.8s.png",
             bench_work_name[f->work], (unsigned)f->width, (unsigned)f->height,
             (unsigned)f->points, peer->name);
    for (char *c = name; *c; c++)
        *c = *c == ' ' ? '_' : *c;
    snprintf(command, sizeof command, "%s " PROGRAMS "/%s %s %u %u %u %u %s",
             peer->setting, peer->program, bench_work_name[f->work], (unsigned)f->width,
             (unsigned)f->height, (unsigned)f->points, (unsigned)frames, name);
    FILE *answer = popen(command, "r");
    if (answer && fscanf(answer, "%u", &us) != 1)
        us = 0;
    if (answer && pclose(answer))
        us = 0;
    f->us[round] = us;
    if (us && round == 0)
        compare(list, f, name);
}
