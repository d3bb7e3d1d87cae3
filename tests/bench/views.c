/* SPDX-License-Identifier: MIT */
/* Draws a scene from random places. Every second place is within 40 m of the origin, where
 * boats are; 0.5 to 20 m above the water, any heading, 0 to 60 degrees down. Views with
 * less than a tenth of water are drawn but not reported.
 *
 *   views SCENE VIEWS SEED WIDTH HEIGHT [NAME=VALUE]...
 *
 * getppid() before and after each frame is the mark for tally.c; the line behind the marks
 * is
 *     view NUMBER x y z heading pitch water_pixels us
 * with the processor time of the frame, a substitute where tally.c is not used. */
#define _POSIX_C_SOURCE 200809L         /* getppid */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/scene/loaded_scene.h"
#include "app/files/timing.h"
#include "world/world.h"
#include "tests/lib/random.h"

static uint32_t seed;

/* Random number in 16.16, uniform from low to high. */
static tp_fx between(tp_fx low, tp_fx high)
{
    return low + (tp_fx)((uint64_t)random_xorshift(&seed) * (uint32_t)(high - low) >> 32);
}

typedef struct {
    tp_fx x, y, z, heading, pitch;      /* m, degrees */
} view_place;

static view_place random_place(const tp_world *world, tp_fx reach)
{
    view_place p = { .x = between(-reach, reach),
                     .z = between(-reach, reach),
                     .heading = between(0, TP_FX(360)),
                     .pitch = between(TP_FX(-60), 0) };
    const tp_surface_point under =
        tp_deep_water_sample(&world->deep, world->phases, p.x, p.z, NULL);
    p.y = under.position.y + between(TP_FX(0.5), TP_FX(20));
    return p;
}

static void stand(tp_world *world, const view_place *p)
{
    tp_world_set_camera(world, (tp_vec3){ p->x, p->y, p->z },
                        tp_turn_of_degrees(p->heading), tp_turn_of_degrees(p->pitch), 0);
}

/* Draws the view. A counted view is drawn once; a time is the least of three. */
static uint64_t draw(loaded_scene *s, bool timed)
{
    uint64_t least = 0;
    for (int i = 0; i < (timed ? 3 : 1); i++) {
        const uint64_t begin = processor_us();
        (void)getppid();
        frame_renderer_draw(&s->renderer, s->world);
        (void)getppid();
        const uint64_t us = processor_us() - begin;
        least = i == 0 || us < least ? us : least;
    }
    return least;
}

static int draw_views(loaded_scene *s, const options *o, uint32_t views)
{
    const bool timed = !getenv("TP_COUNTED");
    const uint32_t least = o->width * o->height / 10;
    for (uint32_t n = 0; n < views; n++) {
        const view_place p = random_place(s->world, n % 2 ? TP_FX(40) : TP_FX(2000));
        stand(s->world, &p);
        const uint64_t us = draw(s, timed);
        if (s->renderer.water_pixels < least)
            continue;
        printf("view %" PRIu32 " %.2f %.2f %.2f %.1f %.1f %" PRIu32 " %" PRIu64 "\n", n,
               p.x / 65536.0, p.y / 65536.0, p.z / 65536.0, p.heading / 65536.0,
               p.pitch / 65536.0, s->renderer.water_pixels, us);
    }
    return 0;
}

int main(int argc, char **argv)
{
    loaded_scene s;
    if (argc < 6) {
        fprintf(stderr, "usage: views SCENE VIEWS SEED WIDTH HEIGHT [NAME=VALUE]...\n");
        return 2;
    }
    seed = (uint32_t)strtoul(argv[3], NULL, 10) * 2654435761u | 1;
    const options o = { .command = "views", .scene = argv[1],
                        .width = (uint32_t)atoi(argv[4]),
                        .height = (uint32_t)atoi(argv[5]),
                        .settings = (const char **)argv + 6,
                        .n_settings = (uint32_t)argc - 6 };
    setvbuf(stdout, NULL, _IOLBF, 0);
    int code = loaded_scene_open(&s, &o);
    for (int i = 0; i < 60 && !code; i++)
        tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
    if (!code)
        code = draw_views(&s, &o, (uint32_t)strtoul(argv[2], NULL, 10));
    loaded_scene_close(&s);
    return code;
}
