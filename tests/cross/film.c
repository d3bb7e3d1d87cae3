/* SPDX-License-Identifier: MIT */
/* Writes the baked scene's frames as a film with the tools' own conversion, on machines
 * that the tools themselves are not built for:
 *
 *   film WxH FIRST:LAST FILE.y4m */
#include <inttypes.h>
#include <stdlib.h>
#include "cortex-m/baked.h"
#include "app/files/film.h"
#include "app/files/log.h"
#include "pixel/pixel.h"

static void *claim(size_t bytes)
{
    void *memory = bytes ? malloc(bytes) : NULL;
    if (!memory)
        exit(log_fail_memory(bytes));
    return memory;
}

static tp_world *world_begin(void)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, &baked_scene, &baked_assets);
    tp_world *world = claim(bytes);
    tp_error  err = { 0 };
    if (tp_world_init(&tp_program_all, world, bytes, &baked_scene, &baked_assets, &err))
        exit(log_fail_error("film", &err));
    return world;
}

/* One tile covers the whole picture. */
static int add_frame(film *to, const picture *p, tp_frame *frame, const tp_world *world,
                     void *scratch)
{
    tp_tile tile;
    tp_frame_begin(frame, world);
    tp_frame_draw_tile_direct(frame, 0, scratch, p->rows, p->row_bytes, &tile);
    return film_add(to, p);
}

static int draw(const char *name, tp_config config, uint32_t first, uint32_t last)
{
    const size_t row_bytes = tp_format_row_bytes(config.format, (int)config.width);
    const picture p = { config.format, config.width, config.height, row_bytes,
                        claim(row_bytes * config.height) };
    tp_world *world = world_begin();
    config.assets = &baked_assets;
    config.tile_height = config.height;
    const size_t bytes = tp_frame_bytes(&config, &baked_scene);
    void *block = claim(bytes);
    void *scratch = claim(tp_frame_direct_scratch_bytes(&config, &baked_scene));
    tp_frame *frame;
    tp_error  err = { 0 };
    film to;
    if (tp_frame_init(&frame, &config, &baked_scene, block, bytes, &err))
        return log_fail_error("film", &err);
    int code = film_open(&to, name, config.width, config.height, 1);
    for (uint32_t n = 0; n <= last && !code; n++) {
        for (uint32_t ticks = n ? tp_world_advance_clock(world) : 0; ticks > 0; ticks--)
            tp_world_step(&tp_program_all, world, &baked_scene, NULL);
        if (n >= first)
            code = add_frame(&to, &p, frame, world, scratch);
    }
    free(scratch);
    free(block);
    free(world);
    free(p.rows);
    return code ? code : film_close(&to);
}

int main(int argc, char **argv)
{
    tp_config config = { .format = TP_FORMAT_XRGB8888 };
    uint32_t first, last;
    if (argc == 4
        && sscanf(argv[1], "%" SCNu32 "x%" SCNu32, &config.width, &config.height) == 2
        && sscanf(argv[2], "%" SCNu32 ":%" SCNu32, &first, &last) == 2)
        return draw(argv[3], config, first, last);
    return log_fail(EXIT_USAGE, "usage: film WxH FIRST:LAST FILE.y4m");
}
