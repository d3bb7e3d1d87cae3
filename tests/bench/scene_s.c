/* SPDX-License-Identifier: MIT */
/* Draws two frames of the benchmark's scene with the shader list for this processor. The
 * first frame fills caches; the second is counted: a begin and one tile.
 *
 *   scene_s WIDTH HEIGHT POINTS WORK [NAME=VALUE]...
 *
 * WORK is plain, full or smooth; NAME is a parameter (quality.visibility=rows). Prints the
 * number of water pixels and the frame's CRC. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "frame/tools.h"
#include "tools/bench/bench_scene.h"
#include "app/scene/machine.h"
#include "pixel/pixel.h"
#include "world/text.h"
#include "world/world.h"
#include "tidepool/tidepool.h"

static void *claim(size_t bytes)
{
    void *memory = bytes ? malloc(bytes) : NULL;
    if (!memory)
        exit(1);
    return memory;
}

static bench_work work_of(const char *name)
{
    int i = 0;
    while (i < BENCH_WORKS && strcmp(name, bench_work_name[i]))
        i++;
    if (i == BENCH_WORKS)
        exit(2);
    return (bench_work)i;
}

static void set(tp_scene *scene, const char *setting)
{
    const char *equals = strchr(setting, '=');
    const tp_param *row = equals ? tp_param_find(setting, (size_t)(equals - setting))
                                 : NULL;
    tp_error err;
    if (!row || tp_param_set(scene, row, equals + 1, strlen(equals + 1), &err))
        exit(2);
}

static void print_held(const tp_frame *frame, const void *scratch, const tp_tile *tile)
{
    uint32_t crc = 0;
    for (uint32_t y = 0; y < tile->y1; y++)
        crc = tp_crc32_pixels(crc, TP_FORMAT_XRGB8888, (const uint8_t *)tile->pixels
                              + y * tile->stride, (int)tile->x1);
    printf("water_pixels %" PRIu32 " crc32 %08" PRIx32 "\n",
           tp_frame_water_pixels(frame, scratch, tile), crc);
}

static void draw(tp_frame *frame, const tp_world *world, void *scratch, tp_tile *tile)
{
    tp_frame_begin(frame, world);
    if (!tp_frame_draw_tile(frame, 0, scratch, tile))
        exit(1);
}

/* Callgrind collects inside this function. */
void counted(tp_frame *frame, const tp_world *world, void *scratch, tp_tile *tile);
__attribute__((noinline)) void counted(tp_frame *frame, const tp_world *world,
                                       void *scratch, tp_tile *tile)
{
    draw(frame, world, scratch, tile);
}

int main(int argc, char **argv)
{
    static bench_scene s;
    static tp_world world;
    tp_error  err;
    tp_frame *frame;
    tp_tile   tile;
    size_t programs;
    const tp_program *program = machine_list(&programs)->program;

    if (argc < 5) {
        fprintf(stderr, "usage: scene_s WIDTH HEIGHT POINTS plain|full|smooth\n");
        return 2;
    }
    const tp_config config = { .width = (uint32_t)atoi(argv[1]),
                               .height = (uint32_t)atoi(argv[2]),
                               .tile_height = (uint32_t)atoi(argv[2]),
                               .format = TP_FORMAT_XRGB8888,
                               .program = program,
                               .assets = &s.assets };
    if (bench_scene_open(&s))
        return 1;
    bench_scene_set(&s, work_of(argv[4]), (uint32_t)atoi(argv[3]));
    for (int i = 5; i < argc; i++)
        set(&s.scene, argv[i]);
    void *block = claim(tp_frame_bytes(&config, &s.scene));
    void *scratch = claim(tp_frame_scratch_bytes(&config, &s.scene));
    if (tp_frame_init(&frame, &config, &s.scene, block, tp_frame_bytes(&config, &s.scene),
                      &err))
        return 1;
    tp_world_init(&tp_program_all, &world, sizeof world, &s.scene, NULL, NULL);
    for (int i = 0; i < BENCH_TICK; i++)
        tp_world_step(&tp_program_all, &world, &s.scene, NULL);
    draw(frame, &world, scratch, &tile);
    counted(frame, &world, scratch, &tile);
    print_held(frame, scratch, &tile);
    free(scratch);
    free(block);
    bench_scene_close(&s);
    return 0;
}
