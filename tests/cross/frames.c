/* SPDX-License-Identifier: MIT */
/* Prints the CRCs of the baked scene's frames, with nothing but the core and printf. All
 * processors, compilers and optimisation levels must print the same CRCs.
 *
 *   frames                                     golden frames of each pixel format
 *   frames WxH FIRST:LAST FORMAT STRIPxBAND    other frames; sides of 0: all in one tile
 *
 * The second form adds a line with the contents of the frames, for counting. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/base.h"
#include "cortex-m/baked.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "world/world.h"
#include "tests/lib/golden_sizes.h"

typedef struct {
    tp_config config;
    tp_frame *frame;
    void     *block, *scratch;
    uint8_t  *rows;             /* the whole picture */
    size_t    row_bytes;
    uint32_t  water_pixels;
} cross_painter;

static void *claim(size_t bytes)
{
    void *memory = bytes ? malloc(bytes) : NULL;
    if (!memory) {
        printf("no memory, or a size that cannot be drawn: %zu bytes\n", bytes);
        exit(1);
    }
    return memory;
}

static cross_painter painter_of(tp_config config)
{
    config.assets = &baked_assets;
    cross_painter  p = { .config = config };
    tp_error err;
    const size_t bytes = tp_frame_bytes(&config, &baked_scene);
    p.block = claim(bytes);
    p.scratch = claim(tp_frame_scratch_bytes(&config, &baked_scene));
    p.row_bytes = tp_format_row_bytes(config.format, (int)config.width);
    p.rows = claim(p.row_bytes * config.height);
    if (tp_frame_init(&p.frame, &config, &baked_scene, p.block, bytes, &err)) {
        printf("%s\n", tp_status_text(err.code));
        exit(1);
    }
    return p;
}

/* Copies a tile. Tiles begin at whole bytes: their columns are multiples of 16. */
static void keep(cross_painter *p, const tp_tile *tile)
{
    const uint8_t *from = tile->pixels;
    size_t skip = tp_format_row_bytes(p->config.format, (int)tile->x0);
    size_t bytes = tp_format_row_bytes(p->config.format, (int)(tile->x1 - tile->x0));
    for (uint32_t y = tile->y0; y < tile->y1; y++, from += tile->stride)
        for (size_t i = 0; i < bytes; i++)
            p->rows[y * p->row_bytes + skip + i] = from[i];
}

static uint32_t paint(cross_painter *p, const tp_world *world)
{
    tp_tile  tile;
    uint32_t crc = 0;
    p->water_pixels = 0;
    tp_frame_begin(p->frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(p->frame, i, p->scratch, &tile); i++) {
        keep(p, &tile);
        p->water_pixels += tp_frame_water_pixels(p->frame, p->scratch, &tile);
    }
    for (uint32_t y = 0; y < p->config.height; y++)
        crc = tp_crc32_pixels(crc, p->config.format, p->rows + y * p->row_bytes,
                              (int)p->config.width);
    return crc;
}

static void painter_end(cross_painter *p)
{
    free(p->rows);
    free(p->scratch);
    free(p->block);
}

static tp_world *world_begin(void)
{
    size_t bytes = tp_world_bytes(&tp_program_all, &baked_scene, &baked_assets);
    tp_world *world = claim(bytes);
    tp_error  err;
    if (tp_world_init(&tp_program_all, world, bytes, &baked_scene, &baked_assets, &err)) {
        printf("%s\n", tp_status_text(err.code));
        exit(1);
    }
    return world;
}

static void golden_frames_of(tp_format format, uint32_t strip, uint32_t band)
{
    static const uint32_t ticks[] = GOLDEN_TICKS;
    tp_world *world = world_begin();
    cross_painter p = painter_of((tp_config){ .width = GOLDEN_WIDTH,
                                              .height = GOLDEN_HEIGHT,
                                              .tile_width = strip,
                                              .tile_height = band,
                                              .format = format });
    for (size_t i = 0; i < sizeof ticks / sizeof *ticks; i++) {
        while (world->tick < ticks[i])
            tp_world_step(&tp_program_all, world, &baked_scene, NULL);
        printf("%s frame %04" PRIu32 " crc32 %08" PRIx32 "\n", tp_format_name(format),
               ticks[i], paint(&p, world));
    }
    painter_end(&p);
    free(world);
}

static void frames_of(tp_config config, uint32_t first, uint32_t last)
{
    tp_world *world = world_begin();
    cross_painter p = painter_of(config);
    while (world->tick < first)
        tp_world_step(&tp_program_all, world, &baked_scene, NULL);
    for (uint32_t n = first; n <= last; n++) {
        uint32_t crc = paint(&p, world);
        tp_draw_stats stats = tp_frame_stats(p.frame);
        printf("frame %04" PRIu32 " crc32 %08" PRIx32 "\n", n, crc);
        fprintf(stderr, "held water_pixels %" PRIu32 " vertices %" PRIu32 " triangles %"
                PRIu32 " dropped %" PRIu32 "\n", p.water_pixels, stats.vertices,
                stats.triangles, stats.dropped);
        tp_world_step(&tp_program_all, world, &baked_scene, NULL);
    }
    painter_end(&p);
    free(world);
}

static int format_of(const char *name)
{
    uint32_t length = 0;
    while (name[length])
        length++;
    return tp_format_find(name, length);
}

int main(int argc, char **argv)
{
    tp_config c = { 0 };
    uint32_t first, last;
    char name[16];

    if (argc == 2 && format_of(argv[1]) >= 0) {
        golden_frames_of((tp_format)format_of(argv[1]), 96, 50);
        return 0;
    }
    if (argc == 5 && sscanf(argv[1], "%" SCNu32 "x%" SCNu32, &c.width, &c.height) == 2
        && sscanf(argv[2], "%" SCNu32 ":%" SCNu32, &first, &last) == 2
        && sscanf(argv[3], "%15s", name) == 1
        && sscanf(argv[4], "%" SCNu32 "x%" SCNu32, &c.tile_width, &c.tile_height) == 2) {
        int format = format_of(name);
        if (format >= 0) {
            c.format = (tp_format)format;
            frames_of(c, first, last);
            return 0;
        }
    }
    fprintf(stderr, "usage: frames FORMAT | WxH FIRST:LAST FORMAT STRIPxBAND\n");
    return 2;
}
