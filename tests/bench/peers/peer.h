/* SPDX-License-Identifier: MIT */
/* Shared by all peers of the benchmark: reads the job from the command line, builds the
 * mesh with the engine's own waves, times the frames, writes a picture and prints the
 * median.
 *
 *   PEER plain|full|smooth WIDTH HEIGHT POINTS FRAMES FILE.png */
#ifndef TP_TESTS_BENCH_PEERS_PEER_H
#define TP_TESTS_BENCH_PEERS_PEER_H
#include "tools/bench/bench_scene.h"

typedef struct {
    float place[3];             /* displaced place, m, y up */
    float rest[2];              /* rest point, m: texture coordinates */
    float slope[2];             /* dy/dx, dy/dz */
} peer_point;

typedef struct {
    bench_scene s;
    bench_work  work;
    uint32_t    width, height, points, frames;
    const char *file;
    peer_point *mesh;           /* points x points at BENCH_TICK, row 0 farthest */
    uint32_t   *index;          /* triangles, rows from near to far */
    uint32_t    indices;
} peer_job;

float peer_metres(tp_fx x);

/* Begins the job; ends the program with a message on failure. */
void peer_begin(peer_job *job, int argc, char **argv);

/* Right, up and back axes of the camera, and its focal length in half heights of the
 * picture. */
void peer_camera(const peer_job *job, float turn[3][3], float *focal);
void peer_light(const peer_job *job, float light[3]);

/* Draws `frames` times, prints the median in us and writes `pixels`, 0x00RRGGBB with the
 * top row first, after the last frame. Returns an exit code. */
int  peer_run(peer_job *job, void (*draw)(void *user), void *user,
              const uint32_t *pixels);
#endif
