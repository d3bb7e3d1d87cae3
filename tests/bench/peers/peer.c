/* SPDX-License-Identifier: MIT */
#include "peer.h"
#include "waves/deep_water.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/picture.h"
#include "app/files/timing.h"
#include "tidepool/tidepool.h"

float peer_metres(tp_fx x)
{
    return (float)x / 65536;
}

static void *claim(size_t bytes)
{
    void *memory = malloc(bytes);
    if (!memory) {
        fprintf(stderr, "no memory\n");
        exit(1);
    }
    return memory;
}

static void make_mesh(peer_job *job)
{
    const tp_scene *scene = &job->s.scene;
    const uint32_t n = job->points;
    const tp_fx cell = (tp_fx)(20 * TP_FX_ONE / (n - 1)), half = 10 * TP_FX_ONE;
    tp_turn phases[TP_WAVES];
    tp_deep_water deep;
    tp_deep_water_init(&deep, scene->wave, TP_WAVES, scene->water.gravity);
    tp_deep_water_phases(&deep, BENCH_TICK, 0, phases);
    job->mesh = claim((size_t)n * n * sizeof *job->mesh);
    for (uint32_t i = 0; i < n * n; i++) {
        const tp_fx x = -half + (tp_fx)(i % n) * cell;
        const tp_fx z = -half + (tp_fx)(i / n) * cell;
        const tp_surface_point p = tp_deep_water_displace_point(&deep, phases, x, z);
        job->mesh[i] = (peer_point){
            { peer_metres(p.position.x), peer_metres(p.position.y),
              peer_metres(p.position.z) },
            { peer_metres(x), peer_metres(z) },
            { peer_metres(p.slope_x), peer_metres(p.slope_z) },
        };
    }
}

/* Triangles from near to far, so that the depth test rejects most pixels. */
static void make_index(peer_job *job)
{
    const uint32_t n = job->points;
    job->indices = 6 * (n - 1) * (n - 1);
    job->index = claim(job->indices * sizeof *job->index);
    uint32_t *to = job->index;
    for (uint32_t row = n - 1; row-- > 0;)
        for (uint32_t col = 0; col + 1 < n; col++) {
            const uint32_t a = row * n + col, b = a + 1, c = a + n, d = c + 1;
            const uint32_t cell[6] = { a, c, b, b, c, d };
            memcpy(to, cell, sizeof cell);
            to += 6;
        }
}

void peer_begin(peer_job *job, int argc, char **argv)
{
    int work = 0;
    while (argc == 7 && work < BENCH_WORKS && strcmp(argv[1], bench_work_name[work]))
        work++;
    if (argc != 7 || work == BENCH_WORKS) {
        fprintf(stderr, "usage: PEER plain|full|smooth W H POINTS FRAMES FILE.png\n");
        exit(2);
    }
    *job = (peer_job){ .work = (bench_work)work, .width = (uint32_t)atoi(argv[2]),
                       .height = (uint32_t)atoi(argv[3]),
                       .points = (uint32_t)atoi(argv[4]),
                       .frames = (uint32_t)atoi(argv[5]), .file = argv[6] };
    if (bench_scene_open(&job->s))
        exit(1);
    bench_scene_set(&job->s, job->work, job->points);
    make_mesh(job);
    make_index(job);
}

static double radians(tp_fx degrees)
{
    return degrees / 65536.0 * (3.14159265358979 / 180);
}

void peer_camera(const peer_job *job, float turn[3][3], float *focal)
{
    const double pitch = radians(job->s.scene.camera.pitch);
    const float c = (float)cos(pitch), s = (float)sin(pitch);
    const float rows[3][3] = { { 1, 0, 0 }, { 0, c, s }, { 0, -s, c } };
    memcpy(turn, rows, sizeof rows);
    *focal = (float)(1 / tan(radians(job->s.scene.camera.fov) / 2));
}

void peer_light(const peer_job *job, float light[3])
{
    const double heading = radians(job->s.scene.light.heading);
    const double up = radians(job->s.scene.light.elevation);
    light[0] = (float)(cos(up) * sin(heading));
    light[1] = (float)sin(up);
    light[2] = (float)(-cos(up) * cos(heading));
}

int peer_run(peer_job *job, void (*draw)(void *user), void *user, const uint32_t *pixels)
{
    timings times = { 0 };
    draw(user);                         /* includes what drivers compile late */
    for (uint32_t i = 0; i < job->frames; i++) {
        const uint64_t begin = processor_us();
        draw(user);
        timings_add(&times, processor_us() - begin);
    }
    const size_t row_bytes = (size_t)job->width * 4;
    const picture p = { TP_FORMAT_XRGB8888, job->width, job->height, row_bytes,
                        (uint8_t *)(uintptr_t)pixels };
    printf("%" PRIu32 "\n", timings_median(&times));
    timings_free(&times);
    free(job->mesh);
    free(job->index);
    bench_scene_close(&job->s);
    return picture_write_png(&p, job->file);
}
